//! Models exported from the real window.

use crate::common::folder::Folder;
use crate::common::window::{Window, click, nothing_picked, run, set_slider, settle, window_with};
use grazing::app::Picker;
use grazing::app::command::Command;
use grazing::app::state::notice::Severity;
use grazing::brdf::{Brdf, codegen};
use grazing::files::{MODEL_FORMATS, ModelFormat};
use grazing::measured::merl;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// A window that saves in a folder under the names it proposes, and the names.
fn saving_in(folder: &Path, files: Vec<PathBuf>) -> (Window, Arc<Mutex<Vec<String>>>) {
    let proposed = Arc::new(Mutex::new(Vec::new()));
    let (folder, names) = (folder.to_owned(), Arc::clone(&proposed));
    let save = move |name: &str| {
        names.lock().expect("no panic").push(name.to_string());
        Some(folder.join(name))
    };
    let picker = Picker {
        save: Arc::new(save),
        ..nothing_picked()
    };
    (window_with(files, picker), proposed)
}

fn shown(window: &Window) -> Brdf {
    let state = window.state().state();
    state.current().expect("a material").1.brdf
}

const MODEL: &str = r#"{"material": "teflon", "model": "combined", "fresnel": "exact",
    "rho_d": [0.2, 0.1, 0.05], "k_s": [9, 8, 7], "s": 120, "alpha": 0.4, "eta": 1.5}"#;

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_model_is_saved_as_every_kind_of_file() {
    let folder = Folder::new();
    let model = folder.file("model.json", MODEL);
    let (mut window, proposed) = saving_in(folder.root(), vec![model]);
    set_slider(&mut window, "s", 123.0);
    let brdf = shown(&window);
    for format in MODEL_FORMATS {
        let saved = folder.path(format.file_name(&brdf, "teflon"));
        let saved = format!("Saved {}", saved.display());
        if format == ModelFormat::Wgsl {
            click(&mut window, "File");
            click(&mut window, "Export model");
            click(&mut window, "WGSL function…");
        } else {
            run(&mut window, Command::ExportModel(format));
        }
        settle(&mut window, |state| {
            let mut notices = state.notices.iter();
            notices.any(|notice| notice.level == Severity::Info && notice.text == saved)
        });
    }
    let names = proposed.lock().expect("no panic").clone();
    assert_eq!(
        names,
        ["binary", "brdf", "wgsl", "glsl"].map(|e| format!("teflon_combined-exact.{e}"))
    );
    let paths = names.iter().map(|name| folder.path(name));
    let files: Vec<Vec<u8>> = paths
        .clone()
        .map(|path| fs::read(path).expect("is there"))
        .collect();
    let [binary, texts @ ..] = &files[..] else {
        panic!("four files")
    };
    let read = merl::read(&binary[..], binary.len() as u64, &mut |_| {
        ControlFlow::Continue(())
    });
    let grid = read.as_ref().expect("a MERL file").grid();
    let cell = grid.index(10, 20, 30);
    let found = read
        .expect("a MERL file")
        .cell(cell)
        .expect("above the horizon");
    let wanted = brdf.eval(&grid.center(10, 20, 30).cosines());
    assert!(
        (found[1] / wanted[1] - 1.0).abs() < 1e-6,
        "{found:?} {wanted:?}"
    );
    let exports = [codegen::disney, codegen::wgsl, codegen::glsl];
    for (text, export) in texts.iter().zip(exports) {
        assert_eq!(String::from_utf8_lossy(text), export(&brdf, Some("teflon")));
        let mut planted = brdf;
        planted.params.lobe[0] = 120.0;
        assert_ne!(
            String::from_utf8_lossy(text),
            export(&planted, Some("teflon"))
        );
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn what_cannot_be_saved_is_said() {
    let folder = Folder::new();
    let gone = folder.path("gone");
    let (mut window, _) = saving_in(&gone, vec![]);
    run(&mut window, Command::ExportModel(ModelFormat::Glsl));
    settle(&mut window, |state| !state.notices.is_empty());
    let notice = &window.state().state().notices[0];
    assert_eq!(notice.level, Severity::Error);
    assert!(notice.text.contains("no directory") && notice.text.ends_with(".glsl"));
    // A dialog that never was.
    let mut window = crate::common::window::window(vec![], vec![]);
    run(&mut window, Command::ExportModel(ModelFormat::Glsl));
    settle(&mut window, |state| !state.notices.is_empty());
    assert!(window.state().state().notices[0].text.contains("zenity"));
    // Without a material there is no model.
    run(&mut window, Command::Close);
    assert!(!Command::ExportModel(ModelFormat::Glsl).is_enabled(window.state().state()));
}
