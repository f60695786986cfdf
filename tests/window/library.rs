//! The library in the real window: a folder with good and bad files, memory, fits of the whole folder.

use crate::common::folder::Folder;
use crate::common::records::{combined, only_named, record, write_fits, write_merl};
use crate::common::window::{Window, click, drag, press, run, set_slider, settings, settle, wheel};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use grazing::app::command::Command;
use grazing::app::msg::Msg;
use grazing::app::msg::fit::FitMsg;
use grazing::app::msg::library::{FolderMsg, LibraryMsg};
use grazing::app::paper::figure::figure_of;
use grazing::app::state::fitting::settings::FitSettings;
use grazing::app::state::library::listing::{FileSort, SortKey};
use grazing::app::state::library::{FileKind, Scan};
use grazing::app::state::material::Presence;
use grazing::app::state::prefs::MIB;
use grazing::app::state::views::ViewId;
use grazing::app::state::{State, memory};
use grazing::app::views::ranking::settings::RankingSettings;
use grazing::app::views::scatter::settings::ScatterSettings;
use grazing::brdf::{Brdf, Fresnel, MODELS, Model};
use grazing::figure::ViewSpec;
use grazing::figure::faults::Faults;
use grazing::figure::palette::Role as ColorRole;
use grazing::figure::ranking::{RankedFit, RankedMaterial, RankingPlot, RankingSpec};
use grazing::figure::scatter::{Quantity, ScatterDot, ScatterPlot};
use grazing::files::fits::FitRecord;
use grazing::fit::{Stage, StageSet};
use std::fs;
use std::path::PathBuf;

/// A folder with these measured files, which differ in their first values.
fn folder(names: &[&str]) -> Folder {
    let folder = Folder::new();
    let Some((first, others)) = names.split_first() else {
        return folder;
    };
    let first = folder.path(first);
    write_merl(&first);
    let mut bytes = fs::read(&first).expect("bytes");
    for (k, name) in others.iter().enumerate() {
        bytes[12..20].copy_from_slice(&(100.0 + k as f64).to_le_bytes());
        folder.file(name, &bytes);
    }
    folder
}

/// A window that shows the folder, all of which has been looked at.
fn window(folder: &Folder) -> Window {
    let mut window = crate::common::window::window(vec![folder.root().to_path_buf()], vec![]);
    settle(&mut window, is_scanned);
    window
}

fn is_scanned(state: &State) -> bool {
    let folder = state.library.folder.as_ref();
    folder.is_some_and(|folder| folder.scan == Scan::Done) && is_quiet(state)
}

fn is_quiet(state: &State) -> bool {
    state.jobs.is_empty() && state.library.pending.is_none() && state.fit.run.is_none()
}

fn send(window: &mut Window, msg: LibraryMsg) {
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::Library(msg));
}

fn name(window: &Window) -> String {
    let current = window.state().state().current();
    current.map_or(String::new(), |(material, _)| material.name.clone())
}

fn row<'a>(window: &'a Window, name: &'a str) -> egui_kittest::Node<'a> {
    window.get_by_role_and_label(Role::Button, name)
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn every_file_is_listed_and_what_is_no_brdf_says_why() {
    let folder = folder(&["a10.binary", "a2.binary"]);
    let at = |name: &str| folder.path(name);
    let good = fs::read(at("a2.binary")).expect("bytes");
    fs::write(at("cut.binary"), &good[..5000]).expect("written");
    let mut wrong = good[..12].to_vec();
    wrong[0] = 89;
    fs::write(at("wrong.binary"), wrong).expect("written");
    let mut holes = good;
    for value in holes[12..].chunks_exact_mut(8) {
        value.copy_from_slice(&(-1.0_f64).to_le_bytes());
    }
    fs::write(at("holes.binary"), holes).expect("written");
    fs::write(at("notes.txt"), "some words").expect("written");
    fs::write(at("empty.binary"), "").expect("written");
    fs::create_dir(at("folder.binary")).expect("made");
    fs::write(at(".hidden"), "").expect("written");
    #[cfg(unix)]
    std::os::unix::fs::symlink("nowhere", at("lost.binary")).expect("linked");

    let window = window(&folder);
    let state = window.state().state();
    let files = &state.library.folder.as_ref().expect("a folder").files;
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    let mut expected = vec![
        "a2.binary",
        "a10.binary",
        "cut.binary",
        "empty.binary",
        "folder.binary",
        "holes.binary",
        "lost.binary",
        "notes.txt",
        "wrong.binary",
    ];
    if cfg!(not(unix)) {
        expected.retain(|name| *name != "lost.binary");
    }
    assert_eq!(names, expected);
    let reason = |name: &str| match &files.iter().find(|file| file.name == name) {
        Some(file) => match &file.kind {
            FileKind::Other(reason) => reason.clone(),
            other => format!("{other:?}"),
        },
        None => String::new(),
    };
    for (name, words) in [
        ("cut.binary", "truncated"),
        ("empty.binary", "empty"),
        ("folder.binary", "directory"),
        ("holes.binary", "nothing was measured"),
        ("notes.txt", "it is a text"),
        ("wrong.binary", "89 × 90 × 180"),
    ] {
        assert!(reason(name).contains(words), "{name}: {}", reason(name));
        assert!(row(&window, name).accesskit_node().is_disabled());
    }
    let examined = files[0].examined().expect("it was read");
    assert!((examined.valid_share - 0.75).abs() < 0.01, "{examined:?}");
    assert_eq!(examined.half_width, None, "a diffuse material");
    // An empty window shows the first one; bad files of a folder are no news.
    assert_eq!((name(&window).as_str(), state.notices.len()), ("a2", 0));
    assert_eq!(state.prefs.recent, [folder.root()]);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn arrows_step_through_previews_and_what_was_touched_stays() {
    let folder = folder(&["a.binary", "b.binary", "c.binary", "d.binary"]);
    fs::write(folder.path("bad.binary"), "words").expect("written");
    let mut window = window(&folder);
    let open = |window: &Window| window.state().state().scene.opened.len();
    row(&window, "b.binary").click();
    window.run_steps(2);
    assert_eq!(name(&window), "a", "the last picture stays");
    assert!(
        window
            .state()
            .state()
            .loading()
            .is_some_and(|text| text.contains("b.binary"))
    );
    settle(&mut window, is_quiet);
    assert_eq!((name(&window).as_str(), open(&window)), ("b", 1));
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    settle(&mut window, is_quiet);
    assert_eq!((name(&window).as_str(), open(&window)), ("d", 1));
    // The end of the list is the end.
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    assert!(is_quiet(window.state().state()));
    set_slider(&mut window, "s", 77.0);
    press(&mut window, Modifiers::COMMAND, Key::PageUp);
    settle(&mut window, is_quiet);
    assert_eq!((name(&window).as_str(), open(&window)), ("c", 2));
    row(&window, "c.binary").click();
    window.run_steps(2);
    press(&mut window, Modifiers::NONE, Key::Enter);
    press(&mut window, Modifiers::NONE, Key::ArrowUp);
    settle(&mut window, is_quiet);
    assert_eq!((name(&window).as_str(), open(&window)), ("b", 3));
    // What is open is not opened again.
    press(&mut window, Modifiers::NONE, Key::End);
    settle(&mut window, is_quiet);
    assert_eq!((name(&window).as_str(), open(&window)), ("d", 3));
    assert!((crate::common::window::s(&window) - 77.0).abs() < 1.0);

    // While somebody types, the arrows are the field's.
    window
        .get_by_role_and_label(Role::TextInput, "Search the folder")
        .click();
    window.run_steps(2);
    window.event(egui::Event::Text("B".into()));
    window.run_steps(2);
    press(&mut window, Modifiers::NONE, Key::ArrowUp);
    assert_eq!(name(&window), "d");
    let listed = |window: &Window| window.state().state().library.visible().len();
    assert_eq!(listed(&window), 5, "all names have a b");
    press(&mut window, Modifiers::NONE, Key::End);
    window.event(egui::Event::Text("ad".into()));
    window.run_steps(2);
    assert_eq!(listed(&window), 1);
    let row = |name| window.query_by_role_and_label(Role::Button, name);
    assert!(row("bad.binary").is_some() && row("a.binary").is_none());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn tables_stay_within_the_limit_and_come_back_when_they_are_shown() {
    let names = ["a", "b", "c", "d"];
    let folder = folder(
        &names
            .map(|name| format!("{name}.binary"))
            .each_ref()
            .map(String::as_str),
    );
    let path = |name: &str| folder.path(format!("{name}.binary"));
    let mut window = window(&folder);
    let one = memory::total(window.state().state());
    assert_eq!(one, (12 + 16) * 1_458_000, "in memory and on the GPU");
    let limit = 60;
    send(&mut window, LibraryMsg::SetLimit(limit));
    for name in names {
        send(
            &mut window,
            LibraryMsg::Show {
                path: path(name),
                keep: true,
            },
        );
        settle(&mut window, |state| {
            let total = memory::total(state);
            assert!(total <= u64::from(limit) * MIB, "{total} bytes");
            is_quiet(state)
        });
        assert_eq!(self::name(&window), name);
    }
    let here = |state: &State| -> Vec<bool> {
        let opened = state.scene.opened.iter();
        let presence = opened.map(|opened| state.materials[&opened.id].presence);
        presence
            .map(|presence| presence == Presence::Loaded)
            .collect()
    };
    assert_eq!(here(window.state().state()), [false, false, true, true]);

    // The last picture stays until the data are there again.
    click(&mut window, "a");
    assert_eq!(name(&window), "d");
    settle(&mut window, is_quiet);
    assert_eq!(name(&window), "a");
    let state = window.state().state();
    assert!(state.current().expect("one").0.table.valid_count() > 0);
    assert_eq!(here(state), [true, false, false, true]);

    // What is beside is shown too, whatever the limit says.
    send(&mut window, LibraryMsg::SetLimit(0));
    window
        .get_by_role_and_label(Role::CheckBox, "Show b beside")
        .click();
    window.run_steps(2);
    settle(&mut window, is_quiet);
    assert_eq!(here(window.state().state()), [true, true, false, false]);
    // Undo shows it no longer, redo does.
    run(&mut window, Command::Undo);
    assert_eq!(here(window.state().state()), [true, false, false, false]);
    run(&mut window, Command::Redo);
    settle(&mut window, is_quiet);
    assert_eq!(here(window.state().state()), [true, true, false, false]);
    run(&mut window, Command::Undo);

    // A file that is gone is named once, and its model is still there.
    fs::remove_file(path("d")).expect("removed");
    click(&mut window, "d");
    settle(&mut window, is_quiet);
    assert_eq!(name(&window), "d");
    let state = window.state().state();
    let [notice] = &state.notices[..] else {
        panic!("{:?}", state.notices)
    };
    assert!(
        notice.text.starts_with("d is shown without its data"),
        "{}",
        notice.text
    );
    assert!(notice.text.ends_with("d.binary"), "{}", notice.text);
    let id = notice.id;
    let ctx = window.ctx.clone();
    window.state_mut().handle(&ctx, Msg::Dismiss(id));

    // One that has other data by now says so.
    let mut bytes = fs::read(path("c")).expect("bytes");
    bytes[12..20].copy_from_slice(&7.0_f64.to_le_bytes());
    fs::remove_file(path("c")).expect("removed");
    fs::write(path("c"), bytes).expect("written");
    click(&mut window, "c");
    settle(&mut window, is_quiet);
    let state = window.state().state();
    assert_eq!(name(&window), "c");
    let [notice] = &state.notices[..] else {
        panic!("{:?}", state.notices)
    };
    assert!(
        notice.text.contains("data of c have changed"),
        "{}",
        notice.text
    );
    assert_eq!(memory::total(state), one, "the shown one alone");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_sample_that_was_let_go_is_made_again() {
    let mut window = crate::common::window::window(vec![], vec![]);
    let valid = |window: &Window| {
        let state = window.state().state();
        state.current().expect("one").0.table.valid_count()
    };
    let before = (name(&window), valid(&window));
    send(&mut window, LibraryMsg::SetLimit(0));
    run(&mut window, Command::OpenSample(1));
    settle(&mut window, is_quiet);
    assert_ne!(name(&window), before.0);
    run(&mut window, Command::NextMaterial);
    settle(&mut window, is_quiet);
    assert_eq!((name(&window), valid(&window)), before);
}

/// What is quick to fit.
fn diffuse_only(window: &mut Window) {
    run(window, Command::UseModel(0));
    run(window, Command::UseFresnel(Fresnel::None));
    let settings = FitSettings {
        stages: StageSet::from_iter([Stage::Amplitudes]),
        ..FitSettings::default()
    };
    let ctx = window.ctx.clone();
    let msg = Msg::Fit(FitMsg::Settings(settings));
    window.state_mut().handle(&ctx, msg);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_folder_is_fitted_in_the_background() {
    let folder = folder(&["a.binary", "b.binary", "c.binary"]);
    let path = |name: &str| folder.path(name);
    fs::write(path("bad.binary"), "words").expect("written");
    let mut window = window(&folder);
    diffuse_only(&mut window);
    run(&mut window, Command::FitFolder);
    click(&mut window, "Stop fitting the folder");
    assert!(window.state().state().library.run.is_none());
    let fitted = |window: &Window| window.state().state().library.fits.len();
    let done = fitted(&window);
    assert!(done < 3, "{done}");
    // Alive: it can be started again, and goes on with what is lacking.
    run(&mut window, Command::FitFolder);
    let total = |window: &Window| {
        window
            .state()
            .state()
            .library
            .run
            .as_ref()
            .map(|run| run.total)
    };
    assert_eq!(total(&window), Some(3 - done));
    assert!(!Command::FitFolder.is_enabled(window.state().state()));
    settle(&mut window, |state| state.library.run.is_none());
    let state = window.state().state();
    assert_eq!(fitted(&window), 3);
    assert_eq!(state.notices.len(), 1, "{:?}", state.notices);
    for name in ["a.binary", "b.binary", "c.binary"] {
        let fit = state.library.best_fit(&path(name)).expect("a fit");
        assert!(fit.errors.total < 1e-3, "{fit:?}");
        assert!(
            fit.source
                .as_ref()
                .is_some_and(|source| source.sha256.is_some())
        );
    }
    // The open material has it, and the others have it when they are opened.
    let kept = |window: &Window| window.state().state().current().expect("one").0.fits.len();
    assert_eq!(kept(&window), 1);
    row(&window, "c.binary").click();
    window.run_steps(2);
    settle(&mut window, is_quiet);
    assert_eq!((name(&window).as_str(), kept(&window)), ("c", 1));
    let state = window.state().state();
    let (material, opened) = state.current().expect("one");
    assert_eq!(opened.brdf, material.fits[0].outcome.brdf);

    // A fit file in the folder brings the same back.
    let fits: Vec<_> = state.library.folder_fits().cloned().collect();
    write_fits(&path("fits.json"), &fits);
    let again = self::window(&folder);
    let state = again.state().state();
    assert_eq!(state.library.folder_fits().count(), 3);
    let file = |name: &str| state.library.kind_of(&path(name)).cloned();
    assert!(matches!(file("fits.json"), Some(FileKind::Models(Some(3)))));
    assert_eq!(kept(&again), 1, "{:?}", state.notices);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn of_a_hundred_files_only_those_in_sight_are_drawn() {
    let folder = Folder::new();
    let names: Vec<String> = (0..100).map(|k| format!("file {k}.binary")).collect();
    for name in &names {
        fs::write(folder.path(name), "words").expect("written");
    }
    let mut window = window(&folder);
    let drawn = |window: &Window| -> Vec<usize> {
        let rows = names.iter().enumerate();
        rows.filter(|(_, name)| window.query_by_role_and_label(Role::Button, name).is_some())
            .map(|(k, _)| k)
            .collect()
    };
    let before = drawn(&window);
    assert_eq!(before[0], 0);
    assert!(before.len() < 25, "{before:?}");
    let at = row(&window, "file 3.binary").rect().center();
    window.hover_at(at);
    for _ in 0..30 {
        window.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: egui::vec2(0.0, -100.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Unknown,
            modifiers: Modifiers::NONE,
        });
        window.run_steps(2);
    }
    window.run_steps(20);
    let after = drawn(&window);
    assert!(after.len() < 25 && after[0] > 40, "{after:?}");
    // The other way round, and a folder that is closed.
    send(
        &mut window,
        FolderMsg::Sort(FileSort {
            key: SortKey::Name,
            descending: true,
        })
        .into(),
    );
    window.run_steps(3);
    let first = window.state().state().library.visible().first().copied();
    assert_eq!(first, Some(99));
    run(&mut window, Command::CloseFolder);
    assert!(drawn(&window).is_empty());
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_folder_that_is_not_there_is_one_line() {
    let mut window = crate::common::window::window(vec![PathBuf::from("/no/such folder")], vec![]);
    send(&mut window, LibraryMsg::Open("/no/such folder".into()));
    settle(&mut window, |state| state.library.folder.is_none());
    // Asked for twice, it is said once.
    let notices = &window.state().state().notices;
    let [notice] = notices.as_slice() else {
        panic!("{notices:?}")
    };
    assert!(notice.text.contains("no such file"), "{}", notice.text);
    assert_eq!(notice.text.lines().count(), 1);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn fitted_materials_are_dots_that_show_them() {
    let folder = folder(&["a.binary", "b.binary"]);
    let path = |name: &str| folder.path(name);
    let fit = |name: &str, s: f64, alpha: f64| {
        record(name, Some(only_named(path(name))), combined(s, alpha), 0.1)
    };
    let fits = [fit("a.binary", 20.0, 0.1), fit("b.binary", 700.0, 0.9)];
    write_fits(&path("fits.json"), &fits);
    let mut window = window(&folder);
    assert_eq!(name(&window), "a");
    // It is open behind the sphere: closed and opened again, it is in front.
    run(&mut window, Command::ToggleTile(ViewId::Scatter));
    run(&mut window, Command::ToggleTile(ViewId::Scatter));
    let rect = window.get_by_role_and_label(Role::Image, "Scatter").rect();
    let dot = |fit: &FitRecord| ScatterDot {
        name: fit.material.clone(),
        x: fit.brdf.params.lobe[0],
        y: fit.brdf.params.lobe[1],
        fill: ColorRole::Muted,
        ring: None,
        shown: false,
    };
    let dots = fits.each_ref().map(dot);
    let place = |window: &Window| {
        let view = settings::<ScatterSettings>(window);
        let plot = ScatterPlot::new(&dots, view, [rect.width(), rect.height()]);
        rect.min + egui::Vec2::from(plot.places[1].expect("a place"))
    };
    let at = place(&window);
    // The wheel makes room around the pointer, and what is under it stays.
    window.hover_at(at);
    window.run_steps(2);
    wheel(&mut window, 120.0);
    let view = settings::<ScatterSettings>(&window);
    let [low, high] = view.window.expect("a part");
    assert!(low > 10.0 && high < 1e4, "{low} {high}");
    assert!((place(&window) - at).length() < 0.5);
    drag(&mut window, &[at, at]);
    settle(&mut window, is_quiet);
    assert_eq!(name(&window), "b");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn materials_are_shown_by_the_model_and_the_axes_that_are_chosen() {
    let folder = folder(&["a.binary", "b.binary"]);
    let path = |name: &str| folder.path(name);
    let fit = |name: &str, roughness: f64, error: f64| {
        let mut brdf = Brdf::new(Model::by_key("ggx").expect("a model"), Fresnel::Exact);
        brdf.params.lobe[0] = roughness;
        record(name, Some(only_named(path(name))), brdf, error)
    };
    let fits = [fit("a.binary", 0.02, 0.3), fit("b.binary", 0.4, 0.05)];
    write_fits(&path("fits.json"), &fits);
    let mut window = window(&folder);
    run(&mut window, Command::ToggleTile(ViewId::Scatter));
    run(&mut window, Command::ToggleTile(ViewId::Scatter));
    let can_draw = |window: &Window| window.state().state().can_draw(ViewId::Scatter);
    assert!(
        !can_draw(&window),
        "nothing has a fit of the combined model"
    );
    let choose = |window: &mut Window, list: &str, choice: &str| {
        window.get_by_role_and_label(Role::ComboBox, list).click();
        window.run_steps(3);
        // The list lies over everything: its choice is the last of this name.
        let choices: Vec<_> = window.get_all_by_label(choice).collect();
        choices.last().expect("a choice").click();
        window.run_steps(3);
    };
    choose(&mut window, "Model of the fits", "GGX");
    assert_eq!(settings::<ScatterSettings>(&window).model.key, "ggx");
    assert!(can_draw(&window));
    choose(&mut window, "Vertical axis", "E, error of the fit");
    let view = settings::<ScatterSettings>(&window);
    assert_eq!(view.y, Some(Quantity::Error));
    assert_eq!(view.x, None);
    // A dot is where its roughness and its E are: a click shows its material.
    let rect = window.get_by_role_and_label(Role::Image, "Scatter").rect();
    let dots = fits.each_ref().map(|fit| {
        let [x, y] = view
            .values(&fit.brdf, Some(fit.errors.total))
            .expect("its model");
        ScatterDot {
            name: fit.material.clone(),
            x,
            y,
            fill: ColorRole::Muted,
            ring: None,
            shown: false,
        }
    });
    assert_eq!((dots[1].x, dots[1].y), (0.4, 5.0));
    let plot = ScatterPlot::new(&dots, view, [rect.width(), rect.height()]);
    let at = rect.min + egui::Vec2::from(plot.places[1].expect("a place"));
    // The wheel enlarges both axes about the pointer.
    window.hover_at(at);
    window.run_steps(2);
    wheel(&mut window, 120.0);
    let zoomed = settings::<ScatterSettings>(&window);
    assert!(zoomed.window.is_some() && zoomed.y_window.is_some());
    let plot = ScatterPlot::new(&dots, zoomed, [rect.width(), rect.height()]);
    let again = rect.min + egui::Vec2::from(plot.places[1].expect("a place"));
    // The numbers beside the axis have another width now.
    let [across, up] = [(again.x - at.x).abs(), (again.y - at.y).abs()];
    assert!(across < 12.0 && up < 0.5, "{across} {up}");
    drag(&mut window, &[again, again]);
    settle(&mut window, is_quiet);
    assert_eq!(name(&window), "b");
    // On paper E goes with the subjects.
    let state = window.state().state();
    let figure = figure_of(state, &[ViewId::Scatter], 1, &state.prefs.figure.style);
    let spec = figure.expect("can be drawn").spec;
    let mut faults = Faults::default();
    spec.clone().sanitize(&mut faults);
    assert_eq!(faults.result(), Ok(()));
    let ViewSpec::Scatter(on_paper) = &spec.rows[0].panels[0].view else {
        panic!("{spec:?}")
    };
    let mut errors = on_paper.errors.clone();
    errors.sort_by(f64::total_cmp);
    assert_eq!(errors, [0.05, 0.3]);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn models_are_ranked_over_the_folder_and_a_dot_shows_its_material() {
    let folder = folder(&["a.binary", "b.binary"]);
    let path = |name: &str| folder.path(name);
    let fit = |name: &str, model: usize, error: f64| {
        let brdf = Brdf::new(MODELS[model], Fresnel::Exact);
        record(name, Some(only_named(path(name))), brdf, error)
    };
    let fits = [
        fit("a.binary", 0, 0.4),
        fit("a.binary", 1, 0.2),
        fit("b.binary", 0, 0.05),
        fit("b.binary", 1, 0.1),
    ];
    write_fits(&path("fits.json"), &fits);
    let mut window = window(&folder);
    assert_eq!(name(&window), "a");
    run(&mut window, Command::ToggleTile(ViewId::Ranking));
    run(&mut window, Command::ToggleTile(ViewId::Ranking));
    let rect = window.get_by_role_and_label(Role::Image, "Ranking").rect();
    let ranked = |name: &str, errors: [f64; 2]| RankedMaterial {
        name: name.into(),
        fits: errors
            .iter()
            .zip(MODELS)
            .map(|(error, model)| RankedFit::new(&Brdf::new(model, Fresnel::Exact), *error, None))
            .collect(),
    };
    let plot = |window: &Window| {
        let spec = RankingSpec {
            materials: vec![ranked("a", [0.4, 0.2]), ranked("b", [0.05, 0.1])],
            ..settings::<RankingSettings>(window).clone()
        };
        RankingPlot::new(&spec, [rect.width(), rect.height()])
    };
    let ranking = plot(&window).ranking;
    assert_eq!(
        (ranking.wins(0), ranking.wins(1), ranking.compared()),
        (1, 1, 2)
    );
    // By their least E b comes first; by the second model's as well, and with it hidden there is one curve.
    assert_eq!(ranking.rows[0].material, 1);
    click(&mut window, "Models");
    window
        .get_by_role_and_label(Role::CheckBox, MODELS[1].name)
        .click();
    window.run_steps(2);
    press(&mut window, Modifiers::NONE, Key::Escape);
    let shown = plot(&window);
    assert_eq!(shown.ranking.models.len(), 1);
    let (at, row, _) = shown.dots[0];
    assert_eq!(shown.ranking.rows[row].material, 1);
    let at = rect.min + egui::Vec2::from(at);
    drag(&mut window, &[at, at]);
    settle(&mut window, is_quiet);
    assert_eq!(name(&window), "b");
}
