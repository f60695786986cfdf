//! The papers hold what they promise: pictures are there, those of the gallery have their commands, sources and keys are
//! named.

use grazing::export::preset::PRESETS;
use grazing::figure::ViewSpec;
use grazing::figure::page::Style;
use grazing::geom::limits::{GRAZING_THETA_DEG, UNRELIABLE_THETA_DEG};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The paths of the pictures in a text.
fn pictures(text: &str) -> Vec<&str> {
    let marks = text.split("](").skip(1);
    marks
        .filter_map(|rest| rest.split(')').next())
        .filter(|path| path.ends_with(".png"))
        .collect()
}

/// Pictures of the gallery without a command right below that writes them.
fn without_command(gallery: &str) -> Vec<&str> {
    let parts: Vec<&str> = gallery.split("![").skip(1).collect();
    let names = parts.iter().map(|part| pictures(part)[0]);
    names
        .zip(&parts)
        .filter(|(path, part)| {
            let name = path.rsplit('/').next().unwrap_or_default();
            let mut commands = part.lines().filter(|line| line.starts_with("grazing "));
            !commands.any(|line| line.contains(&format!("-o {name}")))
        })
        .map(|(path, _)| path)
        .collect()
}

fn gallery(figures: &str) -> &str {
    let (_, rest) = figures.split_once("## Gallery").expect("a gallery");
    rest.split_once("\n## ")
        .map_or(rest, |(gallery, _)| gallery)
}

#[test]
fn every_picture_is_there() {
    let mut count = 0;
    for (paper, folder) in [("README.md", ""), ("docs/figures.md", "docs")] {
        for path in pictures(&read(paper)) {
            let file = root().join(folder).join(path);
            let picture = image::open(&file).unwrap_or_else(|error| panic!("{path}: {error}"));
            assert!(picture.width() >= 300, "{path}");
            count += 1;
        }
    }
    assert!(count > 8, "{count}");
}

#[test]
fn every_picture_of_the_gallery_has_its_command() {
    let figures = read("docs/figures.md");
    assert_eq!(without_command(gallery(&figures)), Vec::<&str>::new());
    // Planted: a command that writes something else.
    let planted = figures.replace("-o lobes.png", "-o lobe.png");
    assert_eq!(
        without_command(gallery(&planted)),
        ["../assets/gallery/lobes.png"]
    );
    // The script reads the commands from there.
    let make = read("assets/gallery/make");
    assert!(make.contains("/^## Gallery/") && make.contains("docs/figures.md"));
}

#[test]
fn every_preset_is_in_the_table() {
    let missing = |figures: &str| {
        let rows = PRESETS.iter().map(|preset| preset.key);
        rows.filter(|key| !figures.contains(&format!("\n| `{key}` |")))
            .collect::<Vec<_>>()
    };
    let figures = read("docs/figures.md");
    assert_eq!(missing(&figures), Vec::<&str>::new());
    let planted = figures.replace("| `albedo` |", "| `albedos` |");
    assert_eq!(missing(&planted), ["albedo"]);
}

/// All keys of an object and of what is in it.
fn keys(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                found.insert(key.clone());
                keys(value, found);
            }
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
        _ => {}
    }
}

#[test]
fn every_key_of_a_figure_spec_is_documented() {
    let mut all = BTreeSet::new();
    for view in ViewSpec::defaults() {
        keys(&serde_json::to_value(view).expect("data"), &mut all);
    }
    keys(
        &serde_json::to_value(Style::default()).expect("data"),
        &mut all,
    );
    let missing = |formats: &str| {
        let mut missing = all.clone();
        missing.retain(|key| !formats.contains(&format!("`{key}`")));
        missing.into_iter().collect::<Vec<String>>()
    };
    let formats = read("docs/formats.md");
    assert_eq!(missing(&formats), Vec::<String>::new());
    let planted = formats.replace("`exposure_stops`", "`exposure`");
    assert_eq!(missing(&planted), ["exposure_stops"]);
}

/// The sources that a text names: `[Name12]`, or several of them with commas between.
fn cited(text: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for part in text.split('[').skip(1) {
        let Some((inside, _)) = part.split_once(']') else {
            continue;
        };
        let keys: Vec<&str> = inside.split(", ").collect();
        if keys.iter().all(|key| is_source(key)) {
            found.extend(keys.into_iter().map(str::to_owned));
        }
    }
    found
}

/// A name that begins with a capital, and a year of two digits.
fn is_source(key: &str) -> bool {
    let name = key.trim_end_matches(|c: char| c.is_ascii_digit());
    let letters = name.chars().count();
    key.len() == name.len() + 2
        && letters > 2
        && name.starts_with(char::is_uppercase)
        && name.chars().all(char::is_alphabetic)
}

fn bibliography(theory: &str) -> BTreeSet<String> {
    let (_, sources) = theory.split_once("\n## Sources\n").expect("the sources");
    let entries = sources.lines().filter(|line| line.starts_with("- **["));
    entries.flat_map(cited).collect()
}

/// Sources that are named in the texts and are not in the bibliography, and those that nothing names.
fn amiss(texts: &[String], theory: &str) -> (Vec<String>, Vec<String>) {
    let bibliography = bibliography(theory);
    let cited: BTreeSet<String> = texts.iter().flat_map(|text| cited(text)).collect();
    (
        cited.difference(&bibliography).cloned().collect(),
        bibliography.difference(&cited).cloned().collect(),
    )
}

/// The texts that may name sources: all but the bibliography itself, and this file, which makes some up.
fn texts() -> Vec<String> {
    let mut folders: Vec<PathBuf> = ["src", "tests", "benches", "docs"]
        .map(PathBuf::from)
        .to_vec();
    let mut texts: Vec<String> = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
    ]
    .map(read)
    .to_vec();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root().join(&folder)).expect("a folder") {
            let path = folder.join(entry.expect("an entry").file_name());
            let extension = path.extension().unwrap_or_default();
            if root().join(&path).is_dir() {
                folders.push(path);
            } else if !path.ends_with("readme.rs")
                && ["rs", "wgsl", "md"].iter().any(|known| extension == *known)
            {
                let text = read(&path.display().to_string());
                let body = text.split("\n## Sources\n").next().unwrap_or_default();
                texts.push(body.to_owned());
            }
        }
    }
    texts
}

#[test]
fn every_source_is_in_the_bibliography_and_named_somewhere() {
    let (theory, mut texts) = (read("docs/theory.md"), texts());
    assert_eq!(amiss(&texts, &theory), (vec![], vec![]));
    assert!(bibliography(&theory).len() > 15);
    // Planted: a source that is named alone and one that is named beside another, and an entry that is gone.
    let [alone, beside] = ["Nobody98", "Nobody99"];
    texts.push(format!(
        "//! As [{alone}] has it, and [Walter07, {beside}]."
    ));
    let (missing, _) = amiss(&texts, &theory);
    assert_eq!(missing, [alone, beside]);
    let gone = theory.replace("- **[Burley12]**", "- **Burley**");
    assert!(amiss(&texts, &gone).0.contains(&"Burley12".to_string()));
    // Planted: an entry that nothing names.
    let dead = format!("{theory}- **[{alone}{}]** Nobody.\n", "").replace(alone, "Unread77");
    assert_eq!(amiss(&texts[..texts.len() - 1], &dead).1, ["Unread77"]);
    // Indices and units are no sources.
    assert!(cited("a[10] [i12] [Ab12] [A, B] [x](y) [1/sr] [Name123]").is_empty());
}

/// Texts that name a limit in degrees, by file: each has to follow its constant.
fn limits_in_words(grazing: f64, unreliable: f64) -> [(&'static str, String); 5] {
    [
        ("src/app/views/fits/columns.rs", format!("E ≥ {grazing}°")),
        (
            "src/app/views/fits/columns.rs",
            format!("from {grazing}° on"),
        ),
        (
            "src/app/views/disc/about.rs",
            format!("beyond {unreliable}°"),
        ),
        (
            "src/app/views/image/about.rs",
            format!("beyond {unreliable}°"),
        ),
        ("src/cli/fit.rs", format!("beyond {unreliable}°")),
    ]
}

#[test]
fn words_about_grazing_angles_follow_their_constants() {
    let wrong = |grazing: f64, unreliable: f64| {
        let all = limits_in_words(grazing, unreliable).into_iter();
        all.filter(|(path, words)| !read(path).contains(words.as_str()))
            .count()
    };
    assert_eq!(wrong(GRAZING_THETA_DEG, UNRELIABLE_THETA_DEG), 0);
    assert_eq!(
        wrong(GRAZING_THETA_DEG + 1.0, UNRELIABLE_THETA_DEG + 1.0),
        5
    );
}
