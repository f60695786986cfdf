//! What a frame costs, as ratios taken in one run, in real windows on a virtual display with software Vulkan. While a
//! slider is dragged:
//!
//! - with every tile in sight, against a bare window with the same panels and one empty plot; goal ≤ 2
//! - each tile alone, against the same panels with an empty middle
//!
//! And from the start of the process to the first frame, as the program starts, against a bare egui window; goal ≤ 1.3.
//!
//! `cargo bench --bench frame`. Needs Xvfb. Each window is a process of its own: winit opens one event loop only.

#[path = "../tests/common"]
mod common {
    pub mod display;
}

use common::display::{Display, Running};
use eframe::egui;
use grazing::app::msg::Msg;
use grazing::app::state::layout::Tiles;
use grazing::app::state::prefs::{FitOnOpening, Prefs};
use grazing::app::state::views::VIEWS;
use grazing::app::views::albedo::work::MeasuredAlbedo;
use grazing::app::views::landscape::work::LandscapeQuery;
use grazing::app::{App, Picker, WindowOptions};
use grazing::brdf::ParamId;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::time::{Duration, Instant};

const KIND: &str = "GRAZING_BENCH_WINDOW";
const SIZE: [f32; 2] = [1280.0, 800.0];
/// Frames that do not count at least: the sample is loading and pipelines are compiled.
const WARM_UP: Duration = Duration::from_secs(3);
const MEASURED: Duration = Duration::from_secs(3);
const ROUNDS: usize = 3;
/// Starts of each window, which take a fraction of a second.
const STARTS: usize = 15;
/// Where the button is held: on the bar of the menu, where nothing else answers.
const HAND: [f32; 2] = [800.0, 8.0];

/// The window as it opens by default, the one with every tile side by side, the panels around nothing, a bare egui
/// window, and a bare one with panels of the same sizes around an empty plot. Every other kind is the key of a tile.
const WINDOWS: [&str; 5] = ["whole", "all", "panels", "bare", "bare-plot"];

fn main() {
    if let Ok(kind) = std::env::var(KIND) {
        return window(&kind);
    }
    let display = Display::of_size(SIZE.map(|n| n as u32));
    let kinds: Vec<&str> = WINDOWS
        .into_iter()
        .chain(VIEWS.iter().map(|row| row.key))
        .collect();
    let mut times: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for _ in 0..ROUNDS {
        // In turn, so that what else the machine does falls on all of them.
        for kind in &kinds {
            times.entry(kind).or_default().push(measure(kind, &display));
        }
    }
    let mut starts: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for _ in 0..STARTS {
        for kind in ["whole", "bare"] {
            starts.entry(kind).or_default().push(start(kind, &display));
        }
    }
    let frame_ms = |kind: &str| 1e3 * median(times[kind].iter().copied());
    let start_ms = |kind: &str| 1e3 * median(starts[kind].iter().copied());
    println!("frame while a slider is dragged, {}×{}:", SIZE[0], SIZE[1]);
    for (kind, name) in [
        ("bare-plot", "bare panels, empty plot"),
        ("panels", "panels"),
    ] {
        println!("  {name:<24} {:6.1} ms", frame_ms(kind));
    }
    for row in VIEWS {
        let ratio = frame_ms(row.key) / frame_ms("panels");
        println!(
            "  {:<24} {:6.1} ms, {ratio:.2} × panels",
            row.name,
            frame_ms(row.key)
        );
    }
    for (kind, name) in [("whole", "as it opens"), ("all", "every tile")] {
        let ratio = frame_ms(kind) / frame_ms("bare-plot");
        let goal = if kind == "all" { " (goal ≤ 2)" } else { "" };
        println!(
            "  {name:<24} {:6.1} ms, {ratio:.2} × bare panels with an empty plot{goal}",
            frame_ms(kind)
        );
    }
    println!(
        "start to first frame: {:.0} ms, {:.0} ms a bare window, ratio {:.2} (goal ≤ 1.3)",
        start_ms("whole"),
        start_ms("bare"),
        start_ms("whole") / start_ms("bare")
    );
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Seconds a frame.
fn measure(kind: &str, display: &Display) -> f64 {
    let (mut child, mut lines, _) = open(kind, display);
    let frame = lines
        .next()
        .and_then(|line| line.parse().ok())
        .unwrap_or_else(|| panic!("the {kind} window ended before its time"));
    let _ = child.0.wait();
    frame
}

/// Seconds from start to the first frame.
fn start(kind: &str, display: &Display) -> f64 {
    let (_child, _, seconds) = open(kind, display);
    seconds
}

/// A window, what it says from its first frame on, and the seconds until then.
fn open(kind: &str, display: &Display) -> (Running, impl Iterator<Item = String>, f64) {
    let started = Instant::now();
    let mut command = display.command(std::env::current_exe().expect("a path"));
    // What a window says on standard error is for whoever runs this.
    command.env(KIND, kind).stdout(Stdio::piped());
    let mut child = Running(command.spawn().expect("a window"));
    let mut lines = BufReader::new(child.0.stdout.take().expect("piped"))
        .lines()
        .map_while(Result::ok);
    assert_eq!(
        lines.next().as_deref(),
        Some("first frame"),
        "the {kind} window did not open"
    );
    (child, lines, started.elapsed().as_secs_f64())
}

fn window(kind: &str) {
    let options = eframe::NativeOptions {
        persist_window: false,
        ..match kind {
            "bare" | "bare-plot" => eframe::NativeOptions {
                viewport: egui::ViewportBuilder::default().with_inner_size(SIZE),
                ..Default::default()
            },
            _ => grazing::app::startup::native_options(),
        }
    };
    let kind = kind.to_string();
    let make = Box::new(move |cc: &eframe::CreationContext<'_>| {
        let content = match kind.as_str() {
            "bare" => Content::Bare,
            "bare-plot" => Content::BarePlot,
            kind => Content::App(Box::new(app(cc, kind)?)),
        };
        Ok(Box::new(Driver {
            content,
            frames: 0,
            started: Instant::now(),
            first: None,
            held: false,
            s: 1.0,
        }) as Box<dyn eframe::App>)
    });
    eframe::run_native("bench", options, make).expect("a window");
}

fn app(
    cc: &eframe::CreationContext<'_>,
    kind: &str,
) -> Result<App, Box<dyn std::error::Error + Send + Sync>> {
    let options = WindowOptions {
        files: vec![],
        picker: Picker::system(),
        autosave: None,
        // A fit in the background would be measured with the frames.
        prefs: Prefs {
            fit_on_opening: FitOnOpening(false),
            ..Prefs::default()
        },
        notice: None,
    };
    let mut app = App::new(cc, options)?;
    match kind {
        "whole" => {}
        "all" => app.handle(&cc.egui_ctx, Msg::SetLayout(Tiles::side_by_side())),
        "panels" => app.handle(&cc.egui_ctx, Msg::SetLayout(Tiles::none())),
        key => {
            app.handle(&cc.egui_ctx, Msg::SetLayout(Tiles::none()));
            let row = VIEWS.iter().find(|row| row.key == key);
            let pane = row.ok_or("no tile has this key")?.id;
            let toggle = grazing::app::command::Command::ToggleTile(pane);
            app.handle(&cc.egui_ctx, Msg::Run(toggle));
        }
    }
    Ok(app)
}

enum Content {
    Bare,
    BarePlot,
    App(Box<App>),
}

/// Repaints without end and moves a slider in every frame.
struct Driver {
    content: Content,
    frames: usize,
    started: Instant,
    first: Option<Instant>,
    held: bool,
    s: f64,
}

impl Driver {
    /// Whether all that does not follow the slider has been made: a person who drags has waited for it.
    fn is_ready(&self) -> bool {
        let Content::App(app) = &self.content else {
            return true;
        };
        let state = app.state();
        let caches = &state.caches;
        let jobs = [
            caches.progress::<LandscapeQuery>(),
            caches.progress::<MeasuredAlbedo>(),
        ];
        state.jobs.is_empty() && jobs.iter().all(Option::is_none)
    }
}

impl eframe::App for Driver {
    /// The button that holds the slider: what views leave for the end of a drag, they leave here too.
    fn raw_input_hook(&mut self, ctx: &egui::Context, input: &mut egui::RawInput) {
        if let Content::App(app) = &mut self.content {
            app.raw_input_hook(ctx, input);
        }
        if self.first.is_none() {
            return;
        }
        let place = |step: usize| egui::pos2(HAND[0] + (step % 2) as f32, HAND[1]);
        input
            .events
            .push(egui::Event::PointerMoved(place(self.frames)));
        if !std::mem::replace(&mut self.held, true) {
            input.events.push(egui::Event::PointerButton {
                pos: place(self.frames),
                button: egui::PointerButton::Primary,
                pressed: true,
                modifiers: egui::Modifiers::NONE,
            });
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        ctx.request_repaint();
        match self.frames {
            // The second call comes when the first frame is on screen.
            1 => println!("first frame"),
            _ if self.first.is_none() && self.started.elapsed() > WARM_UP && self.is_ready() => {
                self.first = Some(Instant::now());
                self.frames = 2;
            }
            _ => {}
        }
        if let Some(first) = self.first.filter(|first| first.elapsed() > MEASURED) {
            println!(
                "{}",
                first.elapsed().as_secs_f64() / (self.frames - 2) as f64
            );
            std::process::exit(0);
        }
        self.frames += 1;
        self.s = if self.s > 1000.0 { 1.0 } else { self.s * 1.02 };
        match &mut self.content {
            Content::App(app) => {
                app.handle(
                    &ctx,
                    Msg::SetParam {
                        id: ParamId("s"),
                        channel: None,
                        value: self.s,
                    },
                );
                app.ui(ui, frame);
            }
            Content::Bare => {
                egui::CentralPanel::default().show(ui, |ui| ui.label("bare"));
            }
            Content::BarePlot => bare_plot_ui(ui, &mut self.s),
        }
    }
}

/// Panels of the sizes of the real ones with a slider, around the frame of a plot without curves.
fn bare_plot_ui(ui: &mut egui::Ui, s: &mut f64) {
    egui::Panel::top("menu").show(ui, |ui| ui.label("File"));
    egui::Panel::bottom("status").show(ui, |ui| ui.label("status"));
    egui::Panel::left("library")
        .default_size(210.0)
        .show(ui, |ui| ui.label("material"));
    egui::Panel::right("model")
        .default_size(316.0)
        .show(ui, |ui| {
            ui.add(egui::Slider::new(s, 1.0..=1000.0).text("s"));
        });
    egui::CentralPanel::default().show(ui, |ui| {
        let rect = ui.available_rect_before_wrap();
        let stroke = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter()
            .rect_stroke(rect.shrink(20.0), 0.0, stroke, egui::StrokeKind::Middle);
        for k in 1..10 {
            let x = egui::lerp(rect.x_range(), k as f32 / 10.0);
            ui.painter().vline(x, rect.y_range().shrink(20.0), stroke);
        }
    });
}
