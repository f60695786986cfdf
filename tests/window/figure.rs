//! Figures out of the window: the dialog, the file it writes, and what is put on the clipboard.

use crate::common::folder::Folder;
use crate::common::window::{
    Window, nothing_picked, run, send, settings, settle, settle_on, window, window_with,
};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use grazing::app::Picker;
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::figure::FigureMsg;
use grazing::app::paper::figure::figure_of;
use grazing::app::paper::work::PreviewQuery;
use grazing::app::state::State;
use grazing::app::state::notice::Dialog;
use grazing::app::state::views::{VIEWS, ViewId};
use grazing::app::views::lobes::settings::LobeSettings;
use grazing::app::views::scatter::settings::ScatterSettings;
use grazing::app::views::sphere::settings::SphereSettings;
use grazing::export::{FigureFormat, FigureSpec};
use grazing::figure::ViewSpec;
use grazing::geom::sight::Sight;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::{fs, process};

/// A window whose dialog for saving answers with this path.
fn saving_to(path: PathBuf) -> Window {
    let picker = Picker {
        save: Arc::new(move |_| Some(path.clone())),
        ..nothing_picked()
    };
    window_with(vec![], picker)
}

fn said(state: &State, text: &str) -> bool {
    state
        .notices
        .iter()
        .any(|notice| notice.text.contains(text))
}

/// Draws a figure from its spec without the window.
fn draw_again(spec: &Path, to: &Path) {
    let output = process::Command::new(env!("CARGO_BIN_EXE_grazing"))
        .args(["figure", "--force", "-o"])
        .args([to, spec])
        .output()
        .expect("the program");
    assert!(output.status.success(), "{output:?}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_window_and_the_command_write_the_same_bytes() {
    let folder = Folder::new();
    for format in [FigureFormat::Svg, FigureFormat::Pdf, FigureFormat::Csv] {
        let path = folder.path(format!("lobes.{}", format.extension()));
        let mut window = saving_to(path.clone());
        run(&mut window, Command::ExportFigure);
        assert_eq!(window.state().state().dialog, Some(Dialog::Figure));
        let mut prefs = window.state().state().prefs.figure.clone();
        prefs.format = format;
        prefs.style.font_pt = 7.5;
        send(&mut window, Msg::Figure(FigureMsg::Set(prefs)));
        send(
            &mut window,
            Msg::Figure(FigureMsg::Choose(vec![ViewId::Lobes, ViewId::Slices])),
        );
        settle(&mut window, |state| {
            state.caches.last::<PreviewQuery>().is_some()
        });
        window
            .get_by_role_and_label(Role::Button, "Export…")
            .click();
        settle(&mut window, |state| said(state, "Saved"));
        let first = fs::read(&path).expect("a figure");
        let spec = folder.path("lobes.figure.json");
        let again = folder.path(format!("again.{}", format.extension()));
        draw_again(&spec, &again);
        assert!(fs::read(&again).expect("a figure") == first, "{format:?}");
        // Planted: one angle off is other bytes.
        let text = fs::read_to_string(&spec).expect("a spec");
        let mut value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(value["style"]["font_pt"], 7.5);
        let theta_i = &mut value["rows"][0]["panels"][0]["view"]["lobes"]["theta_i"][0];
        assert_eq!(*theta_i, 30.0);
        *theta_i = 31.0.into();
        let planted = folder.file("planted.figure.json", value.to_string());
        draw_again(&planted, &again);
        assert!(fs::read(&again).expect("a figure") != first, "{format:?}");
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_zoomed_sphere_and_zoomed_lobes_stay_zoomed_on_paper() {
    let mut window = window(vec![], vec![]);
    let sphere = SphereSettings {
        sight: Sight::default().zoomed(3.0, [0.4, 0.2]),
        ..settings::<SphereSettings>(&window).clone()
    };
    let lobes = LobeSettings {
        limits: Some([0.0, 0.25]),
        ..settings::<LobeSettings>(&window).clone()
    };
    send(&mut window, Msg::set_view(sphere.clone()));
    send(&mut window, Msg::set_view(lobes.clone()));
    let state = window.state().state();
    let views = [ViewId::Sphere, ViewId::Lobes];
    let figure = figure_of(state, &views, 2, &state.prefs.figure.style).expect("a figure");
    // As its file has it.
    let figure = FigureSpec::from_json(&figure.spec.to_json()).expect("is read");
    let views: Vec<&ViewSpec> = figure.rows[0]
        .panels
        .iter()
        .map(|panel| &panel.view)
        .collect();
    let [ViewSpec::Sphere(on_paper), ViewSpec::Lobes(lobes_on_paper)] = views[..] else {
        panic!("{views:?}")
    };
    assert_eq!(on_paper.sight, sphere.sight);
    assert_eq!(lobes_on_paper.limits, lobes.limits);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn every_view_can_be_put_on_paper() {
    let mut window = window(vec![], vec![]);
    run(&mut window, Command::Fit);
    settle(&mut window, |state| {
        state.fit.run.is_none() && state.current().is_some_and(|(m, _)| !m.fits.is_empty())
    });
    // Zoomed, it is zoomed on paper too.
    let zoomed = ScatterSettings {
        window: Some([5.0, 500.0]),
        ..ScatterSettings::default()
    };
    send(&mut window, Msg::set_view(zoomed.clone()));
    let state = window.state().state();
    let panes: Vec<ViewId> = VIEWS
        .iter()
        .map(|row| row.id)
        .filter(|pane| *pane != ViewId::Fits)
        .collect();
    for pane in &panes {
        let figure = figure_of(state, &[*pane], 1, &state.prefs.figure.style);
        let figure = figure.unwrap_or_else(|| panic!("{pane:?}"));
        let again = FigureSpec::from_json(&figure.spec.to_json()).expect("is read");
        assert_eq!(again, figure.spec, "{pane:?}");
        if let ViewSpec::Scatter(on_paper) = &again.rows[0].panels[0].view {
            assert_eq!(*on_paper, zoomed);
        }
    }
    assert_eq!(
        figure_of(state, &[ViewId::Fits], 1, &state.prefs.figure.style),
        None
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_place_that_cannot_be_written_to_is_named_and_a_foreign_file_is_kept() {
    let folder = Folder::new();
    let export = |path: PathBuf, wanted: &str| {
        let mut window = saving_to(path);
        run(&mut window, Command::ExportFigure);
        send(&mut window, Msg::Figure(FigureMsg::Export));
        settle(&mut window, |state| said(state, wanted));
    };
    export(folder.path("no/lobes.svg"), "there is no directory");
    let mine = folder.path("lobes.figure.json");
    fs::write(&mine, "my own notes").expect("is written");
    export(folder.path("lobes.svg"), "is no figure");
    assert_eq!(fs::read(&mine).expect("is there"), b"my own notes");
    assert!(!folder.path("lobes.svg").exists());
    // The spec of another figure is kept too, but where that figure is replaced.
    let mut text = String::new();
    for (name, wanted) in [
        ("disc.svg", "Saved"),
        ("disc.pdf", "Saved"),
        ("disc.png", "the spec of another figure is there"),
        ("disc.svg", "Saved"),
    ] {
        export(folder.path(name), wanted);
        let spec = folder.path("disc.figure.json");
        let now = fs::read_to_string(&spec).expect("a spec");
        if name == "disc.pdf" {
            assert_eq!(now, text);
            // Another figure of the same name from now on.
            fs::write(&spec, now.replace("\"font_pt\": 8.0", "\"font_pt\": 9.0"))
                .expect("is written");
        } else if name == "disc.png" {
            assert!(now != text && !folder.path(name).exists());
        } else if !text.is_empty() {
            assert_eq!(now, text);
        }
        text = if text.is_empty() { now } else { text };
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_png_of_a_tile_says_how_large_it_is_on_paper() {
    let folder = Folder::new();
    for dpi in [96.0, 250.0] {
        let path = folder.path(format!("lobes-{dpi}.png"));
        let mut window = saving_to(path.clone());
        let mut prefs = window.state().state().prefs.figure.clone();
        prefs.format = FigureFormat::Png;
        (prefs.style.dpi, prefs.style.width_mm) = (dpi, 100.0);
        send(&mut window, Msg::Figure(FigureMsg::Set(prefs)));
        run(&mut window, Command::ExportFigure);
        send(
            &mut window,
            Msg::Figure(FigureMsg::Choose(vec![ViewId::Lobes])),
        );
        send(&mut window, Msg::Figure(FigureMsg::Export));
        settle(&mut window, |state| said(state, "Saved"));
        let file = std::io::BufReader::new(fs::File::open(&path).expect("a PNG"));
        let reader = png::Decoder::new(file).read_info().expect("a header");
        let density = reader.info().pixel_dims.expect("a resolution");
        assert_eq!(density.unit, png::Unit::Meter);
        assert_eq!(density.xppu, (dpi / 0.0254).round() as u32);
        // Together with its pixels: 100 mm, to a pixel.
        let metres = f64::from(reader.info().width) / f64::from(density.xppu);
        assert!((metres - 0.1).abs() < 0.0254 / dpi, "{metres}");
    }
}

/// Moves the pointer onto a view and copies; what was copied, once it is there.
fn copied(window: &mut Window, command: Command, view: &str) -> egui::OutputCommand {
    hover(window, view);
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::Run(command));
    // What one frame puts out is gone with the next.
    settle_on(window, |window| {
        let commands = &window.output().platform_output.commands;
        commands.first().cloned()
    })
}

fn hover(window: &mut Window, view: &str) {
    let image = window.get_by_role_and_label(Role::Image, view);
    let at = image.rect().center();
    window.hover_at(at);
    window.run_steps(3);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_view_under_the_pointer_is_copied_as_a_picture_and_as_numbers() {
    let mut window = window(vec![], vec![]);
    match copied(&mut window, Command::Copy, "Polar lobes") {
        egui::OutputCommand::CopyImage(image) => {
            // 85 mm at 300 dpi on white.
            assert_eq!(image.size[0], 1004);
            assert_eq!(image.pixels[0], egui::Color32::WHITE);
            assert!(image.pixels.iter().any(|pixel| pixel.r() < 60));
        }
        other => panic!("{other:?}"),
    }
    match copied(&mut window, Command::CopyNumbers, "Polar lobes") {
        egui::OutputCommand::CopyText(text) => {
            let mut lines = text.lines();
            let head = lines.next().expect("names");
            assert!(
                head.starts_with("panel\tquantity\tchannel\tcurve"),
                "{head}"
            );
            assert!(lines.count() > 1000);
        }
        other => panic!("{other:?}"),
    }
    hover(&mut window, "Sphere");
    run(&mut window, Command::CopyNumbers);
    settle(&mut window, |state| {
        said(state, "Sphere: this view has no numbers")
    });
}
