//! The real window, driven by accessible names.

use crate::common::folder::Folder;
use crate::common::records::write_merl;
use crate::common::window::{
    Window, click, drag, press, s, set_slider, settings, settle, value, window,
};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use grazing::app::state::notice::{Dialog, Severity};
use grazing::app::state::prefs::Theme;
use grazing::app::views::lobes::settings::LobeSettings;
use grazing::app::views::sphere::settings::{Show, SphereSettings};
use grazing::brdf::{Fresnel, ParamId};
use grazing::geom::sphere::LIGHT_PRESETS;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn it_starts_with_a_synthetic_sample_and_a_model_over_it() {
    let window = window(vec![], vec![]);
    let state = window.state().state();
    let (material, opened) = state.current().expect("a material");
    assert!(material.name.contains("synthetic"), "{}", material.name);
    assert!(opened.brdf.params.k_s[0] > 0.0);
    assert!(!state.history.can_undo(), "the start is no step");
    assert_eq!(state.notices, []);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_slider_moves_the_model_and_undo_takes_it_back() {
    let mut window = window(vec![], vec![]);
    let before = s(&window);
    set_slider(&mut window, "s", 123.0);
    assert!((s(&window) - 123.0).abs() < 1.0, "{}", s(&window));
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(s(&window), before);
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
    assert!((s(&window) - 123.0).abs() < 1.0);
    assert!(!window.state().state().history.can_redo());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_drag_with_the_pointer_is_one_step() {
    let mut window = window(vec![], vec![]);
    let before = value(&window, ParamId("alpha"));
    let rect = window.get_by_role_and_label(Role::Slider, "alpha").rect();
    let at = |share: f32| egui::pos2(rect.left() + share * rect.width(), rect.center().y);
    drag(&mut window, &[0.5, 0.3, 0.4, 0.2, 0.1].map(at));
    assert!(
        value(&window, ParamId("alpha")) < 0.2,
        "{}",
        value(&window, ParamId("alpha"))
    );
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(value(&window, ParamId("alpha")), before);
    assert!(!window.state().state().history.can_undo());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn switching_the_model_keeps_the_look_and_shows_its_own_parameters() {
    let mut window = window(vec![], vec![]);
    set_slider(&mut window, "alpha", 1.0);
    set_slider(&mut window, "s", 50.0);
    let exponent = s(&window);
    click(&mut window, "Blinn-Phong");
    assert!((s(&window) / (4.0 * exponent) - 1.0).abs() < 1e-9);
    let alpha = window.query_by_role_and_label(Role::Slider, "alpha");
    assert!(alpha.is_none(), "it has no such parameter");
    press(&mut window, Modifiers::COMMAND, Key::Num3);
    assert!((s(&window) / exponent - 1.0).abs() < 1e-9);
    assert_eq!(value(&window, ParamId("alpha")), 1.0);
    click(&mut window, "None");
    assert_eq!(
        window
            .state()
            .state()
            .current()
            .expect("one")
            .1
            .brdf
            .fresnel,
        Fresnel::None
    );
    assert!(
        window
            .get_by_role_and_label(Role::Slider, "eta")
            .accesskit_node()
            .is_disabled()
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_double_click_on_a_name_resets_that_parameter() {
    let mut window = window(vec![], vec![]);
    set_slider(&mut window, "s", 1234.0);
    let alpha = value(&window, ParamId("alpha"));
    for _ in 0..2 {
        window.get_by_label_contains("specular exponent").click();
    }
    window.run_steps(3);
    let default = grazing::brdf::COMBINED.params[0].default;
    assert_eq!(
        (s(&window), value(&window, ParamId("alpha"))),
        (default, alpha)
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_colour_is_brighter_at_its_hue_and_opens_into_its_channels() {
    let mut window = window(vec![], vec![]);
    let rho_d = |window: &Window| {
        let state = window.state().state();
        state.current().expect("one").1.brdf.params.rho_d
    };
    let before = rho_d(&window);
    let largest = |rgb: [f64; 3]| rgb[0].max(rgb[1]).max(rgb[2]);
    assert!(before[0] != before[1], "{before:?}");
    set_slider(&mut window, "rho_d", 0.5);
    let hue = before.map(|value| value / largest(before));
    let near = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(near(rho_d(&window), hue.map(|share| 0.5 * share)));
    // Black has no hue; what it was darkened from comes back.
    set_slider(&mut window, "rho_d", 0.0);
    assert_eq!(rho_d(&window), [0.0; 3]);
    set_slider(&mut window, "rho_d", 0.25);
    assert!(near(rho_d(&window), hue.map(|share| 0.25 * share)));

    assert!(
        window
            .query_by_role_and_label(Role::Slider, "rho_d R")
            .is_none()
    );
    click(&mut window, "rho_d channels");
    set_slider(&mut window, "rho_d R", 0.7);
    let [r, g, b] = rho_d(&window);
    assert!((r - 0.7).abs() < 0.01 && near([r, g, b], [r, 0.25 * hue[1], 0.25 * hue[2]]));
    let luminance = grazing::geom::color::luminance([r, g, b]);
    click(&mut window, "rho_d grey");
    assert!(near(rho_d(&window), [luminance; 3]));
    set_slider(&mut window, "rho_d", 0.25);
    assert_eq!(rho_d(&window), [rho_d(&window)[0]; 3]);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn files_open_through_the_dialog_and_bad_ones_leave_the_rest() {
    let folder = Folder::new();
    let good = folder.path("made-up metal.binary");
    write_merl(&good);
    let bad = folder.path("cut off.binary");
    std::fs::write(&bad, &std::fs::read(&good).expect("bytes")[..1000]).expect("written");
    let mut window = window(vec![], vec![good.clone(), bad.clone()]);
    press(&mut window, Modifiers::COMMAND, Key::O);
    settle(&mut window, |state| {
        !state.notices.is_empty() && state.jobs.is_empty()
    });
    let state = window.state().state();
    assert_eq!(state.scene.opened.len(), 2);
    assert_eq!(state.current().expect("one").0.name, "made-up metal");
    assert_eq!(state.prefs.recent, [good]);
    let [notice] = &state.notices[..] else {
        panic!("{:?}", state.notices)
    };
    assert!(
        notice.level == Severity::Error && notice.text.contains("cut off.binary"),
        "{}",
        notice.text
    );
    assert_eq!(notice.text.lines().count(), 1);
    window.get_by_label("Close notice").click();
    window.run_steps(3);
    assert!(window.state().state().notices.is_empty());
    // Closing is a step as any other.
    click(&mut window, "Close made-up metal");
    assert_eq!(window.state().state().scene.opened.len(), 1);
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(
        window.state().state().current().expect("one").0.name,
        "made-up metal"
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_palette_finds_and_runs_commands() {
    let mut window = window(vec![], vec![]);
    press(&mut window, Modifiers::COMMAND, Key::P);
    assert_eq!(window.state().state().dialog, Some(Dialog::Palette));
    window.event(egui::Event::Text("side by".into()));
    window.run_steps(3);
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(window.state().state().dialog, None);
    assert_eq!(settings::<SphereSettings>(&window).show, Show::SideBySide);
    // A name goes before the sentences of samples; arrows move the choice.
    let choose = |window: &mut Window, downs: usize| {
        press(window, Modifiers::COMMAND, Key::P);
        window.event(egui::Event::Text("light".into()));
        window.run_steps(3);
        for _ in 0..downs {
            press(window, Modifiers::NONE, Key::ArrowDown);
        }
        press(window, Modifiers::NONE, Key::Enter);
    };
    choose(&mut window, 0);
    assert_eq!(window.state().state().prefs.theme, Theme::Light);
    choose(&mut window, 2);
    let lights = &settings::<SphereSettings>(&window).view.lights;
    assert_eq!(*lights, (LIGHT_PRESETS[1].lights)());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn dragging_on_the_sphere_moves_its_light_and_hovering_reads_it() {
    let mut window = window(vec![], vec![]);
    let rect = window.get_by_role_and_label(Role::Image, "Sphere").rect();
    let lights = |window: &Window| settings::<SphereSettings>(window).view.lights.clone();
    let before = lights(&window);
    let at = |dx: f32, dy: f32| rect.center() + egui::vec2(dx, dy);
    window.hover_at(at(60.0, -50.0));
    window.run_steps(2);
    assert!(window.state().state().probe().is_some());
    drag(&mut window, &[at(60.0, -50.0), at(-80.0, 20.0)]);
    let after = lights(&window);
    assert!(
        after[0].direction.x < 0.0 && after[1] == before[1],
        "{after:?}"
    );
    press(&mut window, Modifiers::COMMAND, Key::Z);
    assert_eq!(lights(&window), before);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn dragging_in_the_lobes_turns_the_light() {
    let mut window = window(vec![], vec![]);
    let before = settings::<LobeSettings>(&window).theta_i.clone();
    window.get_by_label("theta_i 1");
    let rect = window
        .get_by_role_and_label(Role::Image, "Polar lobes")
        .rect();
    // The plot says itself where the handle of the active light is.
    let spec = grazing::figure::lobes::LobeSpec {
        theta_i: before.clone(),
        ..Default::default()
    };
    let frame =
        grazing::figure::lobes::LobePlot::new(&spec, &[], [rect.width(), rect.height()]).frame;
    let point = |theta: f64| rect.min + egui::Vec2::from(frame.at(theta, 1.0));
    drag(&mut window, &[point(-before[1]), point(-0.5)]);
    let after = &settings::<LobeSettings>(&window).theta_i;
    assert!(
        (after[1] - 0.5).abs() < 0.01 && after[0] == before[0],
        "{after:?}"
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn an_idle_window_repaints_nothing() {
    let mut window = window(vec![], vec![]);
    window.run_steps(10);
    let delay = window
        .output()
        .viewport_output
        .values()
        .map(|output| output.repaint_delay)
        .min();
    assert!(
        delay.is_some_and(|delay| delay > Duration::from_secs(3600)),
        "{delay:?}"
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_typed_path_opens() {
    let folder = Folder::new();
    let file = folder.path("typed.binary");
    write_merl(&file);
    let mut window = window(vec![], vec![]);
    press(&mut window, Modifiers::COMMAND | Modifiers::SHIFT, Key::O);
    assert_eq!(window.state().state().dialog, Some(Dialog::OpenPath));
    window.event(egui::Event::Text(file.display().to_string()));
    window.run_steps(3);
    press(&mut window, Modifiers::NONE, Key::Enter);
    settle(&mut window, |state| state.jobs.is_empty());
    assert_eq!(
        window.state().state().current().expect("one").0.name,
        "typed"
    );
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_dialog_that_never_was_is_named() {
    let mut window = window(vec![], vec![]);
    press(&mut window, Modifiers::COMMAND, Key::O);
    settle(&mut window, |state| !state.notices.is_empty());
    assert!(window.state().state().notices[0].text.contains("zenity"));
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &std::path::Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("nobody asks for the bytes".into())
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn several_dropped_files_open() {
    let folder = Folder::new();
    let paths = ["first.binary", "second.binary"].map(|name| folder.path(name));
    let mut window = window(vec![], vec![]);
    for path in paths {
        write_merl(&path);
        window
            .input_mut()
            .dropped_files
            .push(Arc::new(Dropped(path)));
    }
    window.step();
    window.input_mut().dropped_files.clear();
    assert_eq!(window.state().state().jobs.len(), 2);
    settle(&mut window, |state| state.jobs.is_empty());
    let state = window.state().state();
    let names: Vec<&str> = state
        .materials
        .values()
        .map(|material| material.name.as_str())
        .collect();
    assert!(names.ends_with(&["first", "second"]), "{names:?}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_palette_opens_with_its_first_command_chosen() {
    let mut window = window(vec![], vec![]);
    let before = window.state().state().scene.opened.len();
    press(&mut window, Modifiers::COMMAND, Key::P);
    for _ in 0..3 {
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
    }
    press(&mut window, Modifiers::NONE, Key::Escape);
    press(&mut window, Modifiers::COMMAND, Key::P);
    assert_eq!(window.state().state().dialog, Some(Dialog::Palette));
    press(&mut window, Modifiers::NONE, Key::Enter);
    settle(&mut window, |state| state.jobs.is_empty());
    // The first is "Open…", which finds no file here; the fourth would open a sample.
    assert_eq!(window.state().state().scene.opened.len(), before);
}
