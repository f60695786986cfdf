//! What a frame costs, as ratios taken in one run, in real windows on a virtual display with software Vulkan:
//!
//! - a slider is dragged with sphere and lobes open, against the same panels with an empty middle; goal ≤ 1.5
//! - from the start of the process to the first frame, against a bare egui window; goal ≤ 1.5
//!
//! `cargo bench --bench frame`. Needs Xvfb. Each window is a process of its own: winit opens one event loop only.

use eframe::egui;
use grazing::app::update::Msg;
use grazing::app::{App, Options, Picker};
use grazing::brdf::ParamId;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const KIND: &str = "GRAZING_BENCH_WINDOW";
const SIZE: [f32; 2] = [1280.0, 800.0];
/// Frames that do not count: the sample is loading and pipelines are compiled.
const WARM_UP: Duration = Duration::from_secs(3);
const MEASURED: Duration = Duration::from_secs(4);
const ROUNDS: usize = 3;

fn main() {
    if let Ok(kind) = std::env::var(KIND) {
        return window(&kind);
    }
    let display = ":97";
    let mut server = Command::new("Xvfb")
        .args([display, "-screen", "0", "1280x800x24", "-nolisten", "tcp"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("Xvfb starts; install the package xvfb");
    std::thread::sleep(Duration::from_secs(1));
    let mut times: [Vec<Numbers>; 3] = Default::default();
    for _ in 0..ROUNDS {
        for (kind, times) in ["panels", "whole", "bare"].into_iter().zip(&mut times) {
            times.push(measure(kind, display));
        }
    }
    let [panels, whole, bare] = times;
    let frame = |runs: &[Numbers]| median(runs.iter().map(|run| run.frame));
    let start = |runs: &[Numbers]| median(runs.iter().map(|run| run.start));
    println!(
        "frame while a slider is dragged: {:.1} ms with tiles, {:.1} ms panels alone, ratio {:.2} (goal ≤ 1.5)",
        1e3 * frame(&whole),
        1e3 * frame(&panels),
        frame(&whole) / frame(&panels)
    );
    println!(
        "start to first frame: {:.0} ms, {:.0} ms a bare window, ratio {:.2} (goal ≤ 1.5)",
        1e3 * start(&whole),
        1e3 * start(&bare),
        start(&whole) / start(&bare)
    );
    let _ = server.kill();
    let _ = server.wait();
}

/// Seconds from start to the first frame, and seconds a frame.
struct Numbers {
    start: f64,
    frame: f64,
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn measure(kind: &str, display: &str) -> Numbers {
    let started = Instant::now();
    let mut child: Child = Command::new(std::env::current_exe().expect("a path"))
        .env(KIND, kind)
        .env("DISPLAY", display)
        .env("NODEVICE_SELECT", "1")
        .env_remove("WAYLAND_DISPLAY")
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("a window");
    let mut lines = BufReader::new(child.stdout.take().expect("piped"))
        .lines()
        .map_while(Result::ok);
    assert_eq!(
        lines.next().as_deref(),
        Some("first frame"),
        "the {kind} window did not open"
    );
    let start = started.elapsed().as_secs_f64();
    let frame = lines
        .next()
        .and_then(|line| line.parse().ok())
        .expect("a time");
    let _ = child.wait();
    Numbers { start, frame }
}

fn window(kind: &str) {
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default().with_inner_size(SIZE),
        persist_window: false,
        ..Default::default()
    };
    let kind = kind.to_string();
    let make = Box::new(move |cc: &eframe::CreationContext<'_>| {
        let app = match kind.as_str() {
            "bare" => None,
            kind => {
                let mut app = App::new(
                    cc,
                    Options {
                        files: vec![],
                        picker: Picker::system(),
                    },
                )?;
                if kind == "panels" {
                    app.close_tiles();
                }
                Some(app)
            }
        };
        Ok(Box::new(Driver {
            app,
            frames: 0,
            started: Instant::now(),
            first: None,
            s: 1.0,
        }) as Box<dyn eframe::App>)
    });
    eframe::run_native("bench", options, make).expect("a window");
}

/// Repaints without end and moves a slider in every frame.
struct Driver {
    app: Option<App>,
    frames: usize,
    started: Instant,
    first: Option<Instant>,
    s: f64,
}

impl eframe::App for Driver {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        ctx.request_repaint();
        match self.frames {
            // The second call comes when the first frame is on screen.
            1 => println!("first frame"),
            _ if self.first.is_none() && self.started.elapsed() > WARM_UP => {
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
        match &mut self.app {
            Some(app) => {
                self.s = if self.s > 1000.0 { 1.0 } else { self.s * 1.02 };
                app.handle(
                    &ctx,
                    Msg::SetParam {
                        id: ParamId::S,
                        channel: None,
                        value: self.s,
                    },
                );
                app.ui(ui, frame);
            }
            None => {
                egui::CentralPanel::default().show(ui, |ui| ui.label("bare"));
            }
        }
    }
}
