//! Keeps the arrows between modules one-way and the pure modules pure, by reading the source.

use std::fs;
use std::path::{Path, PathBuf};

/// A module, what it may use of this crate, and whether it is pure.
struct Rule {
    module: &'static str,
    may_use: &'static [&'static str],
    pure: bool,
}

const RULES: [Rule; 10] = [
    Rule {
        module: "geom",
        may_use: &[],
        pure: true,
    },
    Rule {
        module: "brdf",
        may_use: &["geom"],
        pure: true,
    },
    Rule {
        module: "measured",
        may_use: &["geom", "brdf"],
        pure: true,
    },
    Rule {
        module: "fit",
        may_use: &["geom", "brdf", "measured"],
        pure: true,
    },
    Rule {
        module: "figure",
        may_use: &["geom", "brdf", "measured"],
        pure: true,
    },
    Rule {
        module: "files",
        may_use: &["geom", "brdf", "measured", "fit"],
        pure: false,
    },
    Rule {
        module: "export",
        may_use: &["geom", "brdf", "measured", "fit", "figure", "files"],
        pure: false,
    },
    Rule {
        module: "gpu",
        may_use: &["geom", "brdf", "measured"],
        pure: false,
    },
    Rule {
        module: "app",
        may_use: &[
            "geom", "brdf", "measured", "fit", "figure", "files", "export", "gpu",
        ],
        pure: false,
    },
    Rule {
        module: "cli",
        may_use: &[
            "geom", "brdf", "measured", "fit", "figure", "files", "export", "gpu", "app",
        ],
        pure: false,
    },
];

/// What a pure module must not know.
const IMPURE: [&str; 8] = [
    "egui",
    "eframe",
    "wgpu",
    "winit",
    "std::fs",
    "std::thread",
    "std::time",
    "std::env",
];

/// What is wrong with a file of a module, one line each.
fn complaints(rule: &Rule, path: &str, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap_or_default();
        let at = format!("{path}:{}", number + 1);
        for other in RULES.iter().filter(|other| other.module != rule.module) {
            let named = names(code, &format!("crate::{}", other.module))
                || names(code, &format!("grazing::{}", other.module));
            if named && !rule.may_use.contains(&other.module) {
                found.push(format!(
                    "{at}: {} must not use {}",
                    rule.module, other.module
                ));
            }
        }
        for impure in IMPURE {
            if rule.pure && names(code, impure) {
                found.push(format!(
                    "{at}: {} is pure and must not use {impure}",
                    rule.module
                ));
            }
        }
        if rule.module == "gpu" && (names(code, "egui") || names(code, "eframe")) {
            found.push(format!("{at}: gpu must not use egui"));
        }
        if rule.module != "app" && code.contains("use crate::{") && !code.contains("};") {
            found.push(format!(
                "{at}: name each module in a `use crate::…` line of its own"
            ));
        }
    }
    found
}

/// Whether `path` occurs as a whole path: not within a longer word.
fn names(code: &str, path: &str) -> bool {
    code.match_indices(path).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let after = code[at + path.len()..].chars().next();
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        !before.is_some_and(is_word) && !after.is_some_and(is_word)
    })
}

fn rust_files(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a source folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            rust_files(&path, out);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            out.push(path);
        }
    }
}

#[test]
fn arrows_between_modules_point_one_way() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    for rule in &RULES {
        let mut files = Vec::new();
        rust_files(&src.join(rule.module), &mut files);
        assert!(!files.is_empty(), "{} has no files", rule.module);
        for path in files {
            let text = fs::read_to_string(&path).expect("a source file");
            all.extend(complaints(rule, &path.display().to_string(), &text));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}

#[test]
fn every_module_has_a_rule() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for entry in fs::read_dir(src).expect("src").filter_map(Result::ok) {
        let name = entry.file_name().display().to_string();
        if entry.path().is_dir() {
            assert!(
                RULES.iter().any(|rule| rule.module == name),
                "{name} has no rule in this test"
            );
        }
    }
}

#[test]
fn files_stay_short_enough_to_read() {
    let mut files = Vec::new();
    rust_files(
        &Path::new(env!("CARGO_MANIFEST_DIR")).join("src"),
        &mut files,
    );
    for path in files {
        let lines = fs::read_to_string(&path)
            .expect("a source file")
            .lines()
            .count();
        assert!(
            lines <= 400,
            "{} has {lines} lines: look for the seam",
            path.display()
        );
    }
}

#[test]
fn a_planted_arrow_backwards_is_caught() {
    let rule = |module: &str| {
        RULES
            .iter()
            .find(|rule| rule.module == module)
            .expect("a rule")
    };
    let caught =
        |module: &str, text: &str| !complaints(rule(module), "planted.rs", text).is_empty();
    assert!(caught("geom", "use crate::brdf::Model;"));
    assert!(caught("measured", "fn f() { crate::app::run(); }"));
    assert!(caught("figure", "use egui::Color32;"));
    assert!(caught("fit", "let now = std::time::Instant::now();"));
    assert!(caught("gpu", "use eframe::egui_wgpu;"));
    assert!(!caught("app", "use crate::gpu::sphere;"));
    assert!(!caught("geom", "// crate::brdf uses this"));
    assert!(!caught("brdf", "use crate::geom::Cosines;"));
}
