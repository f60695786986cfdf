//! Opening the window, and plain words where it cannot be opened.

use crate::app::jobs::dialogs::Picker;
use crate::app::state::prefs::Prefs;
use crate::app::{App, WindowOptions};
use crate::gpu::adapter;
use eframe::egui_wgpu;
use std::path::PathBuf;
use std::sync::Arc;

/// The packages a window needs on Debian and Ubuntu beyond a bare system.
const APT_LINE: &str = "sudo apt-get install -y libxkbcommon-x11-0 libxcursor1 libxi6 libx11-xcb1 mesa-vulkan-drivers libegl1 libgl1-mesa-dri";
/// Hint at the subcommands, which work without a window.
const WITHOUT_WINDOW: &str = "Without a window these work: grazing info FILE, grazing sample NAME -o FILE, grazing eval SOURCE --directions FILE.csv, grazing fit FILE, grazing figure --preset lobes FILE -o lobes.pdf, grazing render SOURCE -o sphere.png";

/// Opens the window with these files and returns when it is closed.
///
/// # Errors
/// A message for the terminal: why there is no window, what to install, and what works without one.
pub fn run(files: Vec<PathBuf>) -> Result<(), String> {
    catch_missing_libraries();
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Grazing")
            .with_app_id("grazing")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([640.0, 360.0])
            .with_icon(icon())
            .with_drag_and_drop(true),
        wgpu_options: wgpu_options(),
        ..Default::default()
    };
    let start = WindowOptions {
        files,
        picker: Picker::system(),
        autosave: eframe::storage_dir("grazing").map(|folder| folder.join("autosave")),
        prefs: Prefs::default(),
    };
    eframe::run_native(
        "grazing",
        options,
        Box::new(|cc| Ok(Box::new(App::new(cc, start)?))),
    )
    .map_err(|error| explain(&error.to_string()))
}

fn icon() -> egui::IconData {
    eframe::icon_data::from_png_bytes(include_bytes!("../../assets/icon.png")).unwrap_or_default()
}

/// The adapters are tried in the order of [`adapter::select`]; the first that really works is taken.
fn wgpu_options() -> egui_wgpu::WgpuConfiguration {
    let mut options = egui_wgpu::WgpuConfiguration::default();
    if let egui_wgpu::WgpuSetup::CreateNew(setup) = &mut options.wgpu_setup {
        setup.native_adapter_selector = Some(Arc::new(|adapters, surface| {
            adapter::select(adapters, surface)
        }));
        setup.device_descriptor = Arc::new(adapter::device_descriptor);
    }
    options
}

/// winit panics where libxkbcommon is missing. That is no bug of ours to report with a backtrace.
fn catch_missing_libraries() {
    let default_hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        let text = info.payload_as_str().unwrap_or_default();
        if text.contains("xkbcommon") || text.contains("could not be loaded") {
            eprintln!("grazing: {}", explain(text));
            std::process::exit(1);
        }
        default_hook(info);
    }));
}

/// Why there is no window, in words and with what to do.
fn explain(error: &str) -> String {
    // winit puts the place in its source before the reason.
    let error = match error.split_once(".rs:") {
        Some((_, rest)) => rest.split_once(": ").map_or(rest, |(_, reason)| reason),
        None => error,
    };
    let lower = error.to_lowercase();
    let (what, todo) = if lower.contains("xkbcommon") || lower.contains("librar") {
        (
            "a library that the window needs is missing",
            format!("Install it: {APT_LINE}"),
        )
    } else if lower.contains("display") && !lower.contains("surface") || lower.contains("x server")
    {
        (
            "there is no display to open a window on",
            format!(
                "Start it from a desktop, or on a virtual display: {APT_LINE} xvfb xauth && xvfb-run grazing"
            ),
        )
    } else {
        (
            "no graphics driver works for a window",
            format!("Install one: {APT_LINE}"),
        )
    };
    format!("{what} ({error})\n{todo}\n{WITHOUT_WINDOW}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_failure_says_what_to_do() {
        for (error, what) in [
            (
                "winit EventLoopError: os error at /home/a/winit/linux/mod.rs:765: neither WAYLAND_DISPLAY nor DISPLAY is set.",
                "no display to open a window on (neither",
            ),
            (
                "os error at /a/mod.rs:788: Failed to open connection to X server",
                "no display",
            ),
            (
                "os error at /a/mod.rs:788: Failed to load one of xlib's shared libraries",
                "library",
            ),
            (
                "WGPU error: Failed to create surface for any enabled backend",
                "no graphics driver",
            ),
            (
                "Library libxkbcommon-x11.so could not be loaded.",
                "library",
            ),
        ] {
            let text = explain(error);
            assert!(
                text.lines().next().is_some_and(|line| line.contains(what)),
                "{text}"
            );
            assert!(text.contains("grazing info FILE"));
        }
        assert!(explain("Library libxkbcommon-x11.so").contains("libxkbcommon-x11-0"));
    }
}
