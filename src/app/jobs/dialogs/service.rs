//! The desktop's service for file dialogs, the portal, asked whether it is there before a dialog is wanted of it.
//!
//! The library for dialogs asks the portal too, but waits as long as D-Bus does, 25 s, then tries zenity, and tells no
//! dialog from one that was cancelled.

use super::NoDialog;
use crate::app::jobs::within;
use std::env;
use std::time::Duration;
use zbus::connection::Builder;

/// Longest time that the portal may take to answer. One that sleeps is woken by the question.
const PATIENCE: Duration = Duration::from_secs(2);

const NAME: &str = "org.freedesktop.portal.Desktop";
const OBJECT: &str = "/org/freedesktop/portal/desktop";
const PROPERTIES: &str = "org.freedesktop.DBus.Properties";
const FILE_CHOOSER: &str = "org.freedesktop.portal.FileChooser";

/// Waits until the portal answers; without one there must be zenity.
pub(super) fn ready() -> Result<(), NoDialog> {
    let path = env::var_os("PATH").unwrap_or_default();
    let zenity = env::split_paths(&path).any(|folder| folder.join("zenity").is_file());
    ready_at(None, zenity)
}

/// `bus` is the address of the session bus where it is not that of the environment.
fn ready_at(bus: Option<String>, zenity: bool) -> Result<(), NoDialog> {
    match within(PATIENCE, || pollster::block_on(ask_portal(bus))) {
        Some(Ok(())) => Ok(()),
        // No bus, or nobody on it with dialogs.
        Some(Err(_)) if zenity => Ok(()),
        Some(Err(_)) => Err(NoDialog::Missing),
        None => Err(NoDialog::Silent),
    }
}

/// Asks for the version of the portal's file dialogs.
async fn ask_portal(bus: Option<String>) -> zbus::Result<()> {
    let builder = match &bus {
        Some(address) => Builder::address(address.as_str())?,
        None => Builder::session()?,
    };
    let connection = builder.build().await?;
    let what = (FILE_CHOOSER, "version");
    let (name, interface) = (Some(NAME), Some(PROPERTIES));
    let reply = connection.call_method(name, OBJECT, interface, "Get", &what);
    reply.await.map(|_| ())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::net::UnixListener;

    #[test]
    fn a_bus_that_is_silent_is_told_from_one_that_is_not_there() {
        let folder = tempfile::tempdir().expect("a folder");
        let address =
            |name: &str| Some(format!("unix:path={}", folder.path().join(name).display()));
        let _silent = UnixListener::bind(folder.path().join("silent")).expect("a socket");
        assert_eq!(ready_at(address("silent"), false), Err(NoDialog::Silent));
        // The library would wait for the portal before it ran zenity.
        assert_eq!(ready_at(address("silent"), true), Err(NoDialog::Silent));
        assert_eq!(ready_at(address("gone"), false), Err(NoDialog::Missing));
        assert_eq!(ready_at(address("gone"), true), Ok(()));
    }
}
