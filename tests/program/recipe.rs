//! Pictures that carry the recipe of their figure: they are drawn again from themselves, here and moved, and none is half done.
#![cfg(target_os = "linux")]

use crate::common::folder::Folder;
use crate::common::program::{failed, failed_with, grazing, stderr, succeeded};
use std::fs;
use std::os::unix::process::ExitStatusExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A figure of a measured file that is named with letters of every kind.
fn spec(folder: &Folder) -> PathBuf {
    let data = folder.path("d.binary");
    succeeded(&grazing(&[&"sample", &"violet-felt", &"-o", &data]));
    let found = grazing::files::identify(&data).expect("is read");
    let data = data.display();
    let sha256 = found.sha256.expect("a hash");
    folder.file(
        "first.figure.json",
        format!(
            r#"{{"program": "grazing", "version": "0.1.0", "subjects": [{{"label": "Filz <ü> & \"]]>\" \u0085\ufffe 漢", "source": {{"measured":
                {{"file": {{"path": "{data}", "bytes": 34992012, "sha256": "{sha256}"}}, "lookup": "smooth"}}}}}}],
                "rows": [{{"panels": [{{"subjects": [0], "view": {{"lobes": {{"theta_i": [20, 55.5]}}}}}}]}}],
                "style": {{"dpi": 60, "width_mm": 60}}}}"#
        ),
    )
}

fn figure(input: &Path, output: &Path) -> Output {
    grazing(&[&"figure", &input, &"-o", &output])
}

/// A figure, whose letters may be without a font where the tests run.
fn drawn(input: &Path, output: &Path) -> Vec<u8> {
    let result = figure(input, output);
    assert_eq!(result.status.code(), Some(0), "{}", stderr(&result));
    fs::read(output).expect("a figure")
}

#[test]
fn a_picture_is_drawn_again_from_itself() {
    let folder = Folder::new();
    let spec = spec(&folder);
    let ends = ["svg", "pdf", "png"];
    let firsts = ends.map(|end| drawn(&spec, &folder.path(format!("first.{end}"))));
    // Nobody who reads the picture learns where it was made.
    let text = String::from_utf8_lossy(&firsts[0]);
    assert!(text.contains("d.binary") && !text.contains(&folder.root().display().to_string()));
    fs::remove_file(&spec).expect("is removed");
    for end in ends {
        let picture = folder.path(format!("first.{end}"));
        for (other, first) in ends.iter().zip(&firsts) {
            let again = folder.path(format!("{end}.{other}"));
            assert!(&drawn(&picture, &again) == first, "{other} from {end}");
        }
    }
    // Elsewhere it has the way to its data all the same.
    let elsewhere = Folder::new();
    drawn(&folder.path("first.pdf"), &elsewhere.path("far.svg"));
    assert!(
        drawn(&elsewhere.path("far.svg"), &elsewhere.path("again.pdf"))
            == drawn(&elsewhere.path("far.svg"), &elsewhere.path("twice.pdf"))
    );
    // Moved along with its data, as a spec is.
    let moved = Folder::new();
    for name in ["first.pdf", "d.binary"] {
        fs::rename(folder.path(name), moved.path(name)).expect("is moved");
    }
    assert!(drawn(&moved.path("first.pdf"), &moved.path("again.svg")) == firsts[0]);
    fs::remove_file(moved.path("d.binary")).expect("is removed");
    let lost = figure(&moved.path("first.pdf"), &moved.path("lost.svg"));
    failed(&lost, &moved.path("d.binary"), "is missing");
}

#[test]
fn a_picture_of_changed_data_has_the_recipe_of_these() {
    let folder = Folder::new();
    let spec = spec(&folder);
    let data = folder.path("d.binary");
    let sample = |name: &str| {
        succeeded(&grazing(&[&"sample", &name, &"-o", &data, &"--force"]));
    };
    sample("hammered-gold");
    let [changed, again] = ["changed.svg", "again.svg"].map(|name| folder.path(name));
    let result = grazing(&[&"figure", &spec, &"--changed", &"-o", &changed]);
    assert_eq!(result.status.code(), Some(0), "{}", stderr(&result));
    assert!(drawn(&changed, &again) == fs::read(&changed).expect("a figure"));
    // Planted: with the data of the first figure it is another one.
    sample("violet-felt");
    let refused = figure(&changed, &folder.path("third.svg"));
    failed(
        &refused,
        &data,
        "is not the one that the figure was drawn from",
    );
}

#[test]
fn a_picture_without_a_recipe_or_damaged_has_one_line() {
    let folder = Folder::new();
    let spec = spec(&folder);
    let out = folder.path("out.svg");
    let bare = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1\" height=\"1\"/>";
    let bare = folder.file("bare.svg", bare);
    failed(&figure(&bare, &out), &bare, "carries no recipe of a figure");
    let plain = folder.path("plain.png");
    let model = r#"{"model": "phong", "rho_d": [0.5, 0.4, 0.3], "k_s": [1, 2, 3], "s": 20}"#;
    let model = folder.file("m.json", model);
    succeeded(&grazing(&[
        &"render", &model, &"--size", &"8", &"-o", &plain,
    ]));
    failed(
        &figure(&plain, &out),
        &plain,
        "carries no recipe of a figure",
    );
    for end in ["svg", "pdf", "png"] {
        let picture = folder.path(format!("p.{end}"));
        let whole = drawn(&spec, &picture);
        // Cut at its first half line, the recipe is lost; cut later, it may be there all the same.
        for (eighth, lost) in [(0, true), (1, false), (4, false), (7, false)] {
            let end = 20 + whole.len() / 8 * eighth;
            fs::write(&picture, &whole[..end]).expect("is written");
            let result = grazing(&[&"figure", &picture, &"-o", &out, &"--force"]);
            assert!(!lost || result.status.code() == Some(1), "{end} bytes");
            if result.status.code() == Some(1) {
                assert_eq!(stderr(&result).lines().count(), 1, "{}", stderr(&result));
                assert!(!out.exists(), "{}", stderr(&result));
            } else {
                assert!(
                    drawn(&spec, &folder.path("direct.svg")) == fs::read(&out).expect("a figure")
                );
                for name in [
                    "out.svg",
                    "out.figure.json",
                    "direct.svg",
                    "direct.figure.json",
                ] {
                    fs::remove_file(folder.path(name)).expect("is removed");
                }
            }
        }
        fs::remove_file(folder.path("p.figure.json")).expect("is removed");
    }
    // A recipe that cannot be drawn is named as a spec is.
    let picture = folder.path("wrong.svg");
    let text = String::from_utf8(drawn(&spec, &picture)).expect("text");
    assert!(text.contains("[20.0,55.5]"));
    fs::write(&picture, text.replace("[20.0,55.5]", "[20.0,155.5]")).expect("is written");
    let result = figure(&picture, &out);
    failed_with(
        &result,
        2,
        &picture,
        "lobes.theta_i.1 is 155.5; expected 0 to 90",
    );
    assert!(!out.exists());
}

#[test]
fn whoever_is_stopped_has_a_new_spec_beside_an_old_picture_at_worst() {
    let folder = Folder::new();
    let spec = spec(&folder);
    let out = folder.file("second.svg", "the old one");
    // No file may be longer than 8 KiB: the spec is shorter, the picture is not, and ends the program.
    let stopped = Command::new("bash")
        .arg("-c")
        .arg("ulimit -f 8; exec \"$0\" figure --force \"$1\" -o \"$2\"")
        .arg(env!("CARGO_BIN_EXE_grazing"))
        .args([&spec, &out])
        .output()
        .expect("bash");
    assert!(stopped.status.signal().is_some(), "{}", stderr(&stopped));
    assert_eq!(fs::read(&out).expect("is there"), b"the old one");
    let beside = folder.path("second.figure.json");
    let read = grazing::export::FigureSpec::open(&beside).expect("a whole spec");
    assert_eq!(
        read,
        grazing::export::FigureSpec::open(&spec).expect("a spec")
    );
}
