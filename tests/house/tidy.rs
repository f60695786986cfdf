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
    assert!(caught("measured", "fn f() { grazing::app::run(); }"));
    assert!(caught("figure", "use egui::Color32;"));
    assert!(caught("fit", "let now = std::time::Instant::now();"));
    assert!(caught("gpu", "use eframe::egui_wgpu;"));
    assert!(!caught("app", "use crate::gpu::sphere;"));
    assert!(!caught("geom", "// crate::brdf uses this"));
    assert!(!caught("brdf", "use crate::geom::Cosines;"));
}

/// The rooms of `app` in the order of their arrows: each may use those before it, and those beside it in its row only
/// where it is the same room.
const ROOMS: [&[&str]; 10] = [
    &["guide"],
    &["state"],
    &["session"],
    &["msg"],
    &["lessons"],
    &["command"],
    &["reduce", "jobs", "widgets"],
    &["views"],
    &["paper"],
    &["panels"],
];

/// The rank of a room; what is not in a room is the window itself, which may use all.
fn rank_of(room: &str) -> usize {
    let rank = ROOMS.iter().position(|rooms| rooms.contains(&room));
    rank.unwrap_or(ROOMS.len())
}

/// The room of a path inside `app`, such as `views/lobes/mod.rs` or `views::lobes::settings`. The row of a view and its
/// settings are part of the state.
fn room_of<'a>(path: &'a str, separator: &str) -> &'a str {
    let mut parts = path.split(separator);
    let room = parts.next().unwrap_or_default().trim_end_matches(".rs");
    let inside = parts.nth(1).unwrap_or_default().trim_end_matches(".rs");
    if room == "views" && ["about", "settings"].contains(&inside) {
        "state"
    } else {
        room
    }
}

/// The arrows of a file of `app` that point to a room above it, one line each. `path` is inside `app`.
fn upward_arrows(path: &str, text: &str) -> Vec<String> {
    let room = room_of(path, "/");
    // Tests may use the whole window.
    let text = text
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let code = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    let mut found = Vec::new();
    for (number, line) in code.enumerate() {
        for (at, _) in line.match_indices("crate::app::") {
            let rest = &line[at + "crate::app::".len()..];
            let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
            let used = room_of(&rest[..end.unwrap_or(rest.len())], "::");
            if used != room && rank_of(used) >= rank_of(room) && rank_of(room) < ROOMS.len() {
                found.push(format!(
                    "app/{path}:{}: {room} must not use {used}",
                    number + 1
                ));
            }
        }
    }
    found
}

#[test]
fn arrows_between_the_rooms_of_app_point_one_way() {
    let app = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/app");
    let mut files = Vec::new();
    rust_files(&app, &mut files);
    let mut all = Vec::new();
    for path in files {
        let inside = path
            .strip_prefix(&app)
            .expect("inside")
            .display()
            .to_string();
        if inside.contains("tests") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a source file");
        all.extend(upward_arrows(&inside, &text));
        let relative = text.contains("use super::") && !text.contains("use super::*");
        if relative {
            all.push(format!("app/{inside}: name modules from the crate on"));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}

/// Whether a reducer starts the whole reducer again instead of calling the function that it means.
fn reduces_again(text: &str) -> bool {
    let text = text
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let mut imports = text.split("use crate::app::reduce::").skip(1);
    imports.any(|rest| names(rest.split(';').next().unwrap_or_default(), "apply"))
        || names(text, "crate::app::reduce::apply")
}

#[test]
fn no_reducer_calls_the_whole_reducer_again() {
    let mut files = Vec::new();
    let reduce = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/app/reduce");
    rust_files(&reduce, &mut files);
    for path in files {
        let text = fs::read_to_string(&path).expect("a source file");
        assert!(!reduces_again(&text), "{}", path.display());
    }
    assert!(reduces_again("use crate::app::reduce::{apply, edit};"));
    assert!(reduces_again(
        "fn f() { crate::app::reduce::apply(state, msg); }"
    ));
    assert!(!reduces_again(
        "use crate::app::reduce::{edit, fit};\nfn f() { fit::apply(); }"
    ));
}

/// Lines outside `reduce` that could change the state. `path` is inside `app`.
fn changes_outside_reducers(path: &str, text: &str) -> Vec<String> {
    let room = room_of(path, "/");
    if room == "reduce" || path.contains("tests") {
        return Vec::new();
    }
    let text = text
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let lines = text.lines().enumerate();
    let changes = lines.filter(|(_, line)| {
        let code = line.split("//").next().unwrap_or_default();
        let lent = code.contains("&mut State") || code.contains("&mut self.state");
        let target = code.split_once(" = ").map_or("", |(target, _)| target);
        let assigned = target.contains(".state.") && !target.contains("let ");
        // The one call of the reducer.
        (lent || assigned) && !code.contains("in apply(&mut self.state, msg)")
    });
    changes
        .map(|(number, line)| format!("app/{path}:{}: {}", number + 1, line.trim()))
        .collect()
}

#[test]
fn the_state_changes_in_reducers_only() {
    let app = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/app");
    let mut files = Vec::new();
    rust_files(&app, &mut files);
    let mut all = Vec::new();
    for path in files {
        let inside = path.strip_prefix(&app).expect("inside");
        let text = fs::read_to_string(&path).expect("a source file");
        all.extend(changes_outside_reducers(
            &inside.display().to_string(),
            &text,
        ));
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
    let caught = |path: &str, text: &str| !changes_outside_reducers(path, text).is_empty();
    assert!(caught("mod.rs", "app.state.prefs = prefs;"));
    assert!(caught("panels/fit.rs", "fn f(state: &mut State) {}"));
    assert!(!caught("reduce/fit.rs", "fn f(state: &mut State) {}"));
    assert!(!caught(
        "mod.rs",
        "for task in apply(&mut self.state, msg) {"
    ));
    assert!(!caught("mod.rs", "let files = app.state.library.files;"));
}

#[test]
fn the_state_knows_no_egui() {
    let state = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/app/state");
    let mut files = Vec::new();
    rust_files(&state, &mut files);
    for path in files {
        // The tree of tiles is egui_tiles' own data; a thumbnail is a texture on the GPU.
        let allowed = ["layout.rs", "layout_check.rs", "library/mod.rs"];
        if allowed.iter().any(|name| path.ends_with(name)) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a source file");
        let mut lines = text
            .lines()
            .map(|line| line.split("//").next().unwrap_or_default());
        let found = lines.find(|line| names(line, "egui") || names(line, "wgpu"));
        assert_eq!(found, None, "{}", path.display());
    }
}

#[test]
fn a_planted_arrow_between_rooms_is_caught() {
    let caught = |path: &str, text: &str| !upward_arrows(path, text).is_empty();
    assert!(caught(
        "state/mod.rs",
        "use crate::app::views::lobes::lobes_ui;"
    ));
    assert!(caught(
        "views/lobes/settings.rs",
        "use crate::app::msg::Msg;"
    ));
    assert!(caught(
        "reduce/fit.rs",
        "fn f() { crate::app::jobs::start(); }"
    ));
    assert!(caught("msg/mod.rs", "use crate::app::command::ENTRIES;"));
    assert!(!caught(
        "state/views.rs",
        "use crate::app::views::lobes::settings::LobeSettings;"
    ));
    assert!(!caught("panels/fit.rs", "use crate::app::views::fits;"));
    assert!(!caught("mod.rs", "use crate::app::panels::menu;"));
    assert!(!caught(
        "reduce/fit.rs",
        "#[cfg(test)]\nmod tests {\nuse crate::app::panels::x;"
    ));
}

/// Folders of `src` in which a doc comment begins with what the thing is.
const DOCUMENTED: [&str; 10] = [
    "geom", "brdf", "measured", "fit", "figure", "files", "export", "gpu", "app", "cli",
];

/// First words of a doc comment that say what a thing is only to one who knows it already.
const VAGUE: [&str; 4] = ["What", "Its", "The same", "All of them"];

/// The doc comments of a file that begin with a word of [`VAGUE`], one line each.
fn vague_comments(path: &str, text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut begins = true;
    for (number, line) in text.lines().enumerate() {
        let line = line.trim_start();
        let comment = line.strip_prefix("///").or(line.strip_prefix("//!"));
        // A paragraph of its own begins anew.
        let Some(comment) = comment.map(str::trim).filter(|comment| !comment.is_empty()) else {
            begins = true;
            continue;
        };
        let vague = VAGUE.into_iter().find(|words| {
            let rest = comment.strip_prefix(words);
            rest.is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
        });
        if let Some(words) = vague.filter(|_| begins) {
            found.push(format!(
                "{path}:{}: \"{words}\": begin with what it is",
                number + 1
            ));
        }
        begins = false;
    }
    found
}

#[test]
fn doc_comments_begin_with_what_a_thing_is() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    for module in DOCUMENTED {
        let mut files = Vec::new();
        rust_files(&src.join(module), &mut files);
        assert!(!files.is_empty(), "{module} has no files");
        for path in files {
            let text = fs::read_to_string(&path).expect("a source file");
            all.extend(vague_comments(&path.display().to_string(), &text));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}

#[test]
fn a_planted_vague_comment_is_caught() {
    let caught = |text: &str| !vague_comments("planted.rs", text).is_empty();
    assert!(caught("    /// What was measured.\n    pub table: Table,"));
    assert!(caught("/// Its name on screen.\nfn name() {}"));
    assert!(caught("/// The same, to be written.\nfn get_mut() {}"));
    assert!(caught(
        "/// A model.\n///\n/// All of them have a row.\nstruct Model;"
    ));
    assert!(caught("//! What a fit is asked."));
    assert!(!caught(
        "    /// Measured f_r, 1/sr.\n    pub table: Table,"
    ));
    assert!(!caught(
        "/// Lobe that is 1 at the peak.\n/// What is left is 0.\nfn lobe() {}"
    ));
    assert!(!caught("// What follows is rounding.\nlet x = 1;"));
    assert!(!caught(
        "/// Whatever the angle, a value in [0, 1].\nfn value() {}"
    ));
}
