//! `grazing export` as a person meets it: what is written, and one clear line for everything that is wrong.

use crate::common::folder::Folder;
use crate::common::program::{failed, grazing, stderr, stdout, succeeded};
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, COMBINED, Fresnel, Params, codegen};
use grazing::geom::direction;
use grazing::measured::{Lookup, merl};
use std::ffi::OsStr;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::Output;

const MODELS_JSON: &str = r#"[
  {"model": "phong", "rho_d": [0.5, 0.4, 0.3], "k_s": [1, 1, 1], "s": 7},
  {"material": "teflon", "model": "combined", "fresnel": "exact",
   "rho_d": [0.2, 0.1, 0.05], "k_s": [9, 8, 7], "s": 120, "alpha": 0.4, "eta": 1.5}
]"#;

fn second() -> Brdf {
    Brdf {
        model: &COMBINED,
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.2, 0.1, 0.05],
            k_s: [9.0, 8.0, 7.0],
            lobe: lobe_values([120.0, 0.4]),
            eta: 1.5,
        },
    }
}

fn export(source: &Path, options: &[&dyn AsRef<OsStr>]) -> Output {
    let mut args: Vec<&dyn AsRef<OsStr>> = vec![&"export", &source];
    args.extend(options);
    grazing(&args)
}

#[test]
fn the_extension_or_the_format_says_what_is_written() {
    let folder = Folder::new();
    let models = folder.file("models.json", MODELS_JSON);
    type Export = fn(&Brdf, Option<&str>) -> String;
    let kinds: [(&str, &str, Export); 3] = [
        ("a.brdf", "disney", codegen::disney),
        ("a.wgsl", "wgsl", codegen::wgsl),
        ("a.glsl", "glsl", codegen::glsl),
    ];
    for (name, format, text) in kinds {
        let wanted = text(&second(), Some("teflon"));
        let path = folder.path(name);
        let silent = succeeded(&export(&models, &[&"--index", &"1", &"-o", &path]));
        assert_eq!(silent, "");
        assert_eq!(fs::read_to_string(&path).expect("is there"), wanted);
        let printed = succeeded(&export(&models, &[&"--index", &"1", &"--format", &format]));
        assert_eq!(printed, wanted);
        let other = folder.path(format!("{format}.txt"));
        succeeded(&export(&models, &[&"--format", &format, &"-o", &other]));
        let first = fs::read_to_string(&other).expect("is there");
        assert!(
            first.contains("s = 7.0") && !first.contains("teflon"),
            "{first}"
        );
    }
}

#[test]
fn a_merl_file_of_a_model_opens_as_measured_data() {
    let folder = Folder::new();
    let models = folder.file("models.json", MODELS_JSON);
    let path = folder.path("teflon.binary");
    succeeded(&export(&models, &[&"--index", &"1", &"-o", &path]));
    let bytes = fs::read(&path).expect("is there");
    assert_eq!(bytes.len(), 34_992_012);
    let table = merl::read(&bytes[..], bytes.len() as u64, &mut |_| {
        ControlFlow::Continue(())
    });
    let table = table.expect("a MERL file");
    let (wi, wo) = (direction(0.7, 0.0), direction(0.5, 2.9));
    let found = table.lookup(wi, wo, Lookup::Smooth).expect("measured");
    let wanted = second().f_r(wi, wo).expect("above the horizon");
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found / wanted - 1.0).abs() < 0.02, "{found} {wanted}");
    }
    assert!(
        (found[0] / wanted[1] - 1.0).abs() > 0.05,
        "swapped channels went unnoticed"
    );
    let info = succeeded(&grazing(&[&"info", &path]));
    assert!(info.contains("teflon"), "{info}");
}

#[test]
fn whatever_cannot_be_done_has_its_line() {
    let folder = Folder::new();
    let models = folder.file("models.json", MODELS_JSON);
    let bad = folder.file("bad.json", r#"{"model": "wart"}"#);
    let there = folder.file("there.wgsl", "precious");
    let data = folder.path("data.binary");
    succeeded(&export(&models, &[&"-o", &data]));
    let fresh = folder.path("new.wgsl");
    let missing = folder.path("missing.json");
    let odd = folder.path("new.txt");
    let nowhere = folder.path("no/new.wgsl");
    for (source, output, path, said) in [
        (&missing, &fresh, &missing, "there is no such file"),
        (
            &data,
            &fresh,
            &data,
            "which `grazing fit` makes of measured files",
        ),
        (&bad, &fresh, &bad, "unknown model \"wart\""),
        (&models, &there, &there, "the file exists already; --force"),
        (&models, &odd, &odd, "expected .binary, .brdf, .wgsl, .glsl"),
        (&models, &nowhere, &nowhere, "no directory"),
    ] {
        failed(&export(source, &[&"-o", output]), path, said);
    }
    failed(
        &export(&models, &[&"-o", &fresh, &"--index", &"2"]),
        &models,
        "there is no entry 2; the file has 2, counted from 0",
    );
    let written: Vec<PathBuf> = vec![fresh.clone(), odd];
    assert!(written.iter().all(|path| !path.exists()));
    assert_eq!(fs::read(&there).expect("is there"), b"precious");
    succeeded(&export(&models, &[&"-o", &there, &"--force"]));
    assert_ne!(fs::read(&there).expect("is there"), b"precious");
    for (options, said) in [
        (&[][..], "give --format, or --output with an extension"),
        (
            &["--format", "merl"],
            "a MERL file is no text; give --output",
        ),
        (
            &["--format", "hlsl"],
            "possible values: merl, disney, wgsl, glsl",
        ),
        (&["--format", "wgsl", "--force"], "--output"),
    ] {
        let options: Vec<&dyn AsRef<OsStr>> = options
            .iter()
            .map(|option| option as &dyn AsRef<OsStr>)
            .collect();
        let output = export(&models, &options);
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        assert!(stderr(&output).contains(said), "{}", stderr(&output));
        assert_eq!(stdout(&output), "");
    }
}
