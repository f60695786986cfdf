//! Opening the window, and plain words where it cannot be opened.

#[cfg(target_os = "linux")]
mod display;
mod words;

use crate::app::jobs::dialogs::Picker;
use crate::app::state::prefs::Prefs;
use crate::app::{App, WindowOptions};
use crate::gpu::adapter;
use eframe::egui_wgpu;
use std::path::PathBuf;
use std::sync::Arc;
use words::{Failure, explain};

pub use words::APT_LINE;

/// Opens the window with these files and returns when it is closed.
///
/// # Errors
/// A message for the terminal: why there is no window, what to install, and what works without one.
pub fn run(files: Vec<PathBuf>) -> Result<(), String> {
    catch_missing_libraries();
    adapter::check_environment()?;
    let options = eframe::NativeOptions {
        event_loop_builder: event_loop_hook()?,
        ..native_options()
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
    .map_err(|error| explain(Failure::of(&error), &error.to_string()))
}

/// Size, icon and graphics adapter of the window.
pub fn native_options() -> eframe::NativeOptions {
    eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Grazing")
            .with_app_id("grazing")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([640.0, 360.0])
            .with_icon(icon())
            .with_drag_and_drop(true),
        wgpu_options: wgpu_options(),
        ..Default::default()
    }
}

/// Way to X11 where the environment names a Wayland display that does not answer.
#[cfg(target_os = "linux")]
fn event_loop_hook() -> Result<Option<eframe::EventLoopBuilderHook>, String> {
    use winit::platform::x11::EventLoopBuilderExtX11 as _;
    let choice = display::choose().map_err(|tried| explain(Failure::Display, &tried))?;
    Ok(choice.map(|tried| -> eframe::EventLoopBuilderHook {
        words::say(&tried);
        Box::new(|builder| {
            builder.with_x11();
        })
    }))
}

#[cfg(not(target_os = "linux"))]
fn event_loop_hook() -> Result<Option<eframe::EventLoopBuilderHook>, String> {
    Ok(None)
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
            words::say(&explain(Failure::Library, text));
            std::process::exit(1);
        }
        default_hook(info);
    }));
}
