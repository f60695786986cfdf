//! The settings of the views: one map from a view to what it is set to show. The session saves it, figures and tiles
//! read it, and one message changes it.

use crate::app::state::view_settings::{AnySettings, Settings};
use crate::app::state::views::{VIEWS, ViewId};
use serde::ser::{Error as _, SerializeMap};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// The settings of all views that have some.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingsMap(BTreeMap<ViewId, AnySettings>);

impl Default for SettingsMap {
    fn default() -> Self {
        let kinds = VIEWS.iter().filter_map(|about| about.settings);
        let all = kinds.map(|kind| kind.initial());
        Self(all.map(|settings| (settings.view(), settings)).collect())
    }
}

/// Error of a view without settings; a test below looks at all rows.
const NO_SETTINGS: &str = "every view with settings has a row that makes them";

impl SettingsMap {
    /// The settings of a view.
    pub fn get<T: Settings>(&self) -> &T {
        let settings = self.0.get(&T::VIEW);
        let settings = settings.and_then(|settings| settings.downcast());
        settings.expect(NO_SETTINGS)
    }

    /// The settings of a view, to be changed.
    pub fn get_mut<T: Settings>(&mut self) -> &mut T {
        let settings = self.0.get_mut(&T::VIEW);
        let settings = settings.and_then(|settings| settings.downcast_mut());
        settings.expect(NO_SETTINGS)
    }

    /// Takes the place of the settings of the same view.
    pub fn set(&mut self, settings: AnySettings) {
        self.0.insert(settings.view(), settings);
    }

    /// See [`Settings::sanitized`].
    pub fn sanitized(&self) -> Self {
        let all = self.0.iter();
        Self(
            all.map(|(view, settings)| (*view, settings.sanitized()))
                .collect(),
        )
    }
}

impl Serialize for SettingsMap {
    /// An object with a key per view, in the order of the table.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for about in VIEWS {
            if let Some(settings) = self.0.get(&about.id) {
                let value = settings.to_json().map_err(S::Error::custom)?;
                map.serialize_entry(&about.session_key(), &value)?;
            }
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_makes_the_settings_of_its_view_and_reads_them_back() {
        for about in VIEWS {
            let Some(kind) = about.settings else { continue };
            let settings = kind.initial();
            assert_eq!(settings.view(), about.id, "{}", about.key);
            assert_eq!(settings.sanitized(), settings, "{}", about.key);
            let value = settings.to_json().expect("data");
            assert_eq!(
                kind.read(&value).expect("understood"),
                settings,
                "{}",
                about.key
            );
            let empty = kind
                .read(&serde_json::json!({}))
                .expect("all keys may be left out");
            assert_eq!(empty, settings, "{}", about.key);
        }
    }
}
