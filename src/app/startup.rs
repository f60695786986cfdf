//! Opening the window, and plain words where it cannot be opened.

mod device;
#[cfg(target_os = "linux")]
mod display;
mod settings;
mod words;

use crate::app::jobs::dialogs::Picker;
use crate::app::state::prefs::Prefs;
use crate::app::{App, WindowOptions};
use crate::gpu::adapter;
use crate::signals;
use eframe::egui_wgpu;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;
use words::{Failure, explain};

pub use words::APT_LINE;

/// Name of the program for the desktop, and of its own folder.
const NAME: &str = "grazing";

/// Longest time that the window has to close where the system ends the program.
const TIME_TO_CLOSE: Duration = Duration::from_secs(4);

/// Devices lost in one run after which the driver is given up.
const MOST_LOST: usize = 3;

/// Opens the window with these files and returns when it is closed.
///
/// # Errors
/// A message for the terminal: why there is no window, what to install, and what works without one.
pub fn run(files: Vec<PathBuf>) -> Result<(), String> {
    run_watched(files, |_| {})
}

/// Opens the window as [`run`] does, with a look at each one that is opened: for tests. Where the graphics device is lost,
/// the window closes and another one takes its place, with what was open.
///
/// # Errors
/// Errors of [`run`].
pub fn run_watched(
    files: Vec<PathBuf>,
    opened: impl Fn(&eframe::CreationContext<'_>),
) -> Result<(), String> {
    catch_missing_libraries();
    adapter::check_environment()?;
    let own_folder = eframe::storage_dir(NAME);
    let mut start = Start {
        files,
        notice: own_folder
            .as_ref()
            .and_then(|folder| settings::mend(&folder.join("app.ron"))),
    };
    let end = End::default();
    signals::watch({
        let end = Arc::clone(&end);
        move || tell(&end)
    });
    let mut event_loop = event_loop_hook()?;
    let autosave = own_folder.map(|folder| folder.join("autosave"));
    for _ in 0..MOST_LOST {
        let lost = Arc::default();
        window(
            event_loop.take(),
            start,
            autosave.clone(),
            &end,
            &lost,
            &opened,
        )?;
        if !lost.load(Ordering::Acquire) {
            return Ok(());
        }
        start = Start {
            files: Vec::new(),
            notice: Some("The graphics device was lost and has been opened again.".into()),
        };
    }
    Err(
        "the graphics device was lost again and again; what was open is kept for the next start"
            .into(),
    )
}

/// Beginning of a window.
struct Start {
    files: Vec<PathBuf>,
    notice: Option<String>,
}

/// Answer of the window that is open to a signal that ends the program.
type End = Arc<Mutex<Option<Box<dyn Fn() + Send>>>>;

/// Tells the window that is open that the system ends the program, and gives it time.
fn tell(end: &End) {
    if let Some(end) = &*end.lock().unwrap_or_else(PoisonError::into_inner) {
        end();
        thread::sleep(TIME_TO_CLOSE);
    }
}

fn window(
    event_loop: Option<eframe::EventLoopBuilderHook>,
    start: Start,
    autosave: Option<PathBuf>,
    end: &End,
    lost: &Arc<AtomicBool>,
    opened: &impl Fn(&eframe::CreationContext<'_>),
) -> Result<(), String> {
    let native = eframe::NativeOptions {
        event_loop_builder: event_loop,
        ..native_options()
    };
    let options = WindowOptions {
        files: start.files,
        picker: Picker::system(),
        autosave,
        prefs: Prefs::default(),
        notice: start.notice,
    };
    let make = |cc: &eframe::CreationContext<'_>| {
        let app = App::new(cc, options)?;
        *end.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(app.on_end()));
        if let Some(state) = &cc.wgpu_render_state {
            device::watch(&state.device, app.sender(), lost);
        }
        opened(cc);
        let lost = Arc::clone(lost);
        Ok(Box::new(device::Guarded { app, lost }) as Box<dyn eframe::App>)
    };
    let closed = eframe::run_native(NAME, native, Box::new(make));
    *end.lock().unwrap_or_else(PoisonError::into_inner) = None;
    closed.map_err(|error| explain(Failure::of(&error), &error.to_string()))
}

/// Size, icon and graphics adapter of the window.
pub fn native_options() -> eframe::NativeOptions {
    eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Grazing")
            .with_app_id(NAME)
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
