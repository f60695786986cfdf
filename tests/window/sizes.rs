//! The window at every size: what has to be in sight, and what folds away.

use crate::common::window::{Window, click, press, run, send, settings, settle, window};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::{NodeT, Queryable};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::state::layout::Tiles;
use grazing::app::state::prefs::Theme;
use grazing::app::state::side_panels::Side;
use grazing::app::views::lobes::settings::LobeSettings;
use grazing::app::views::sphere::settings::{Show, SphereSettings};
use grazing::figure::lobes::LobeScale;

fn resized(size: [f32; 2]) -> Window {
    let mut window = window(vec![], vec![]);
    resize(&mut window, size);
    window
}

fn resize(window: &mut Window, size: [f32; 2]) {
    window.set_size(size.into());
    window.run_steps(4);
}

/// The place of a control on screen.
#[track_caller]
fn place(window: &Window, role: Role, label: &str) -> Rect {
    window.get_by_role_and_label(role, label).rect()
}

/// Checks that controls stand one below the other, all of them between these heights.
#[track_caller]
fn stand_below_each_other(places: &[(&str, Rect)], from: f32, to: f32) {
    let mut bottom = from;
    for (name, place) in places {
        assert!(
            place.top() >= bottom - 0.5 && place.bottom() <= to,
            "{name} at {place} in {bottom}..{to}"
        );
        bottom = place.top();
    }
}

/// Everything that the model and its fit have, from above to below, at 1280 × 800.
fn in_sight(window: &Window) {
    let slider = |key| (key, place(window, Role::Slider, key));
    let tick = |name| (name, place(window, Role::CheckBox, name));
    let error = window.get_by_label_contains("at grazing angles").rect();
    let fit = place(window, Role::Button, "Start the fit");
    let rows = [
        slider("s"),
        slider("alpha"),
        slider("eta"),
        tick("keep rho_d, k_s optimal"),
        slider("rho_d"),
        slider("k_s"),
        ("the fit's button", fit),
        tick("stage 1"),
        tick("stage 2"),
        tick("stage 3"),
        tick("stage 4"),
        ("E", error),
    ];
    let model = place(window, Role::Button, "Combined");
    stand_below_each_other(&rows, model.bottom(), 800.0 - 24.0);
    for pair in rows.windows(2) {
        let [(above, a), (below, b)] = pair else {
            unreachable!()
        };
        assert!(a.bottom() <= b.top() + 0.5, "{above} {a} over {below} {b}");
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn at_1280_by_800_every_parameter_and_the_fit_are_in_sight() {
    for theme in [Theme::Dark, Theme::Light] {
        let mut window = window(vec![], vec![]);
        run(&mut window, Command::UseTheme(theme));
        click(&mut window, "Start the fit");
        settle(&mut window, |state| state.fit.run.is_none());
        in_sight(&window);
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn at_960_by_540_the_main_job_is_in_sight() {
    let mut window = resized([960.0, 540.0]);
    let rows = ["s", "alpha", "eta", "rho_d", "k_s"];
    let rows = rows.map(|key| (key, place(&window, Role::Slider, key)));
    stand_below_each_other(&rows, 24.0, 540.0 - 24.0);
    // The fit is started from here, and its error read.
    click(&mut window, "Start the fit");
    settle(&mut window, |state| state.fit.run.is_none());
    let error = window.get_by_label_contains("at grazing angles").rect();
    assert!(error.bottom() < rows[0].1.top());
    assert!(
        window
            .query_by_role_and_label(Role::CheckBox, "stage 1")
            .is_none()
    );
    window.get_by_role_and_label(Role::Tab, "Fit").click();
    window.run_steps(3);
    assert!(place(&window, Role::CheckBox, "stage 4").bottom() < 516.0);
    assert!(window.query_by_role_and_label(Role::Slider, "s").is_none());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_smallest_window_keeps_a_sphere_a_lobe_plot_and_a_slider() {
    let window = resized([640.0, 360.0]);
    for name in ["Sphere", "Polar lobes"] {
        let picture = place(&window, Role::Image, name);
        assert!(
            picture.width() > 200.0 && picture.height() > 60.0,
            "{name} {picture}"
        );
        assert!(picture.bottom() <= 360.0 - 20.0, "{name} {picture}");
    }
    let slider = place(&window, Role::Slider, "s");
    assert!(
        slider.bottom() < 340.0 && slider.right() <= 640.0,
        "{slider}"
    );
    // Nothing of the panel is cut off.
    let (lobes, tab) = (
        place(&window, Role::Image, "Polar lobes"),
        place(&window, Role::Tab, "Model"),
    );
    assert!(tab.left() > lobes.right() + 8.0, "{tab} {lobes}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_narrow_window_folds_the_materials_and_a_strip_opens_them() {
    let mut window = resized([1280.0, 800.0]);
    let open = |window: &Window| window.query_by_label("Open Materials").is_none();
    assert!(open(&window));
    resize(&mut window, [1000.0, 700.0]);
    assert!(!open(&window));
    click(&mut window, "Open Materials");
    assert!(open(&window));
    click(&mut window, "Fold Materials");
    assert!(!open(&window));
    // Each width keeps what was chosen at it.
    run(&mut window, Command::TogglePanel(Side::Model));
    assert!(window.query_by_role_and_label(Role::Slider, "s").is_none());
    resize(&mut window, [1280.0, 800.0]);
    assert!(open(&window));
    assert!(window.query_by_role_and_label(Role::Slider, "s").is_some());
    run(&mut window, Command::TogglePanel(Side::Model));
    click(&mut window, "Open Model and fit");
    assert!(window.query_by_role_and_label(Role::Slider, "s").is_some());
}

/// Every control of a tile is in its row or in its menu, whatever the width, and works in both.
#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_toolbar_is_one_row_and_the_rest_is_in_its_menu() {
    let mut window = resized([640.0, 360.0]);
    let row = place(&window, Role::Button, "Linear");
    let lobes = place(&window, Role::Image, "Polar lobes");
    assert!(lobes.top() - row.bottom() < 14.0, "{row} {lobes}");
    let channel = |window: &Window| window.query_by_label("Channel").is_some();
    assert!(!channel(&window));
    more(&mut window, lobes);
    assert!(channel(&window));
    // The menu stays while it is used, and while a list in it is open.
    window.get_by_label("× cos θi").click();
    window.run_steps(3);
    assert!(settings::<LobeSettings>(&window).cosine.theta_i && channel(&window));
    window.get_by_label("Channel").click();
    window.run_steps(3);
    window.get_by_label("green").click();
    window.run_steps(3);
    let green = grazing::figure::Channel::G;
    assert_eq!(settings::<LobeSettings>(&window).channel, green);
    assert!(channel(&window));
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(!channel(&window));
    // What is in the row of a wide window is no longer in a menu.
    resize(&mut window, [1700.0, 800.0]);
    assert!(channel(&window));
    assert!(window.query_by_label("More controls").is_none());
}

/// Opens the menu of the toolbar that is over a picture.
fn more(window: &mut Window, under: Rect) {
    let nearest = window
        .query_all_by_label("More controls")
        .min_by(|a, b| {
            let far = |rect: Rect| (under.top() - rect.bottom()).abs();
            far(a.rect()).total_cmp(&far(b.rect()))
        })
        .expect("a menu");
    nearest.click();
    window.run_steps(3);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn no_toolbar_is_wider_than_its_tile() {
    let mut window = resized([1500.0, 900.0]);
    send(&mut window, Msg::SetLayout(Tiles::side_by_side()));
    run(&mut window, Command::UseScale(LobeScale::Log));
    run(&mut window, Command::UseShow(Show::Split));
    assert_eq!(settings::<SphereSettings>(&window).show, Show::Split);
    window.run_steps(4);
    let right = place(&window, Role::Button, "Phong").left();
    for role in [Role::Button, Role::CheckBox, Role::ComboBox] {
        for node in window.query_all_by_role(role) {
            let rect = node.rect();
            let crossing = rect.left() < right - 30.0 && rect.right() > right - 8.0;
            assert!(!crossing, "{:?} at {rect}", node.accesskit_node().label());
        }
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn keys_make_everything_larger_and_the_menu_says_so() {
    let mut window = resized([1280.0, 800.0]);
    let factor = |window: &Window| window.ctx.zoom_factor();
    assert_eq!(factor(&window), 1.0);
    press(&mut window, Modifiers::COMMAND, Key::Plus);
    press(&mut window, Modifiers::COMMAND, Key::Equals);
    assert_eq!(factor(&window), 1.2);
    press(&mut window, Modifiers::COMMAND, Key::Minus);
    assert_eq!(factor(&window), 1.1);
    press(&mut window, Modifiers::COMMAND, Key::Num0);
    assert_eq!(factor(&window), 1.0);
    for _ in 0..40 {
        run(&mut window, Command::ZoomOut);
    }
    assert_eq!(factor(&window), 0.5);
    assert!(!Command::ZoomOut.is_enabled(window.state().state()));
}
