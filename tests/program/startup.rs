//! The program without a display: plain words, exit code 1.
#![cfg(target_os = "linux")]

use std::process::Command;

#[test]
fn without_a_display_it_says_what_to_do() {
    let output = Command::new(env!("CARGO_BIN_EXE_grazing"))
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.starts_with("grazing: there is no display"), "{said}");
    assert!(
        said.contains("apt-get install") && said.contains("grazing info FILE"),
        "{said}"
    );
    assert!(
        !said.contains("panicked") && !said.contains(".rs:"),
        "{said}"
    );
}
