//! Letters that the font of figures lacks: a font that has them is taken, and where there is none it is said.
#![cfg(target_os = "linux")]

use crate::common::folder::Folder;
use crate::common::font::{FAMILY, font};
use crate::common::program::{grazing, stderr, succeeded};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A fit file of a material with a Chinese name.
fn fits(folder: &Folder) -> PathBuf {
    let data = folder.path("木林 wood.binary");
    succeeded(&grazing(&[&"sample", &"green-lacquer", &"-o", &data]));
    let fits = folder.path("fits.json");
    succeeded(&grazing(&[&"fit", &data, &"--stages", &"1", &"-o", &fits]));
    fits
}

/// Draws with the fonts of a folder alone.
fn drawn(fits: &Path, fonts: &Path, outputs: &[&Path]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_grazing"));
    command.env("GRAZING_FONTS", fonts);
    command.args(["figure", "--preset", "lobes"]).arg(fits);
    for output in outputs {
        command.arg("-o").arg(output);
    }
    command.output().expect("the program starts")
}

fn run(program: &str, args: &[&Path]) -> String {
    let output = Command::new(program).args(args).output();
    let output = output.expect("poppler-utils");
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn a_name_in_another_script_is_drawn_with_a_font_that_has_it() {
    let folder = Folder::new();
    let fits = fits(&folder);
    let (with, without) = (folder.path("with"), folder.path("without"));
    for fonts in [&with, &without] {
        fs::create_dir(fonts).expect("a folder");
    }
    fs::write(with.join("wood.ttf"), font()).expect("is written");
    let [svg, pdf, png] = ["svg", "pdf", "png"].map(|end| folder.path(format!("a.{end}")));
    succeeded(&drawn(&fits, &with, &[&svg, &pdf, &png]));
    let text = fs::read_to_string(&svg).expect("an SVG");
    assert!(
        text.contains(&format!("'Liberation Sans', '{FAMILY}', ")),
        "{text}"
    );
    assert!(text.contains(">木林 wood<"));
    assert!(run("pdftotext", &[&pdf, Path::new("-")]).contains("木林 wood"));
    // Embedded, and its letters alone: the whole font has 400 kB.
    let embedded = run("pdffonts", &[&pdf]);
    let line = embedded
        .lines()
        .find(|line| line.contains("PlantationSans"));
    let line = line.unwrap_or_else(|| panic!("{embedded}"));
    let words: Vec<&str> = line.split_whitespace().collect();
    assert!(
        words[0].contains('+') && words.windows(3).any(|w| w == ["yes", "yes", "yes"]),
        "{line}"
    );
    assert!(fs::metadata(&pdf).expect("a PDF").len() < 100_000);

    // Planted: no font has them. Boxes are drawn, which are other pixels, and one line says so.
    let [boxes, csv] = ["boxes.png", "numbers.csv"].map(|name| folder.path(name));
    let output = drawn(&fits, &without, &[&boxes]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    for word in ["no font", "木 (U+6728)", "林 (U+6797)", "boxes.png"] {
        assert!(said.contains(word), "{said}");
    }
    assert!(fs::read(&boxes).expect("a PNG") != fs::read(&png).expect("a PNG"));
    // Numbers have no letters that are drawn.
    succeeded(&drawn(&fits, &without, &[&csv]));
}
