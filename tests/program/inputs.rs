//! Inputs survive their command: no output replaces one, whatever `--force` says and by whatever name, and a changed one is
//! named wherever it stands.
#![cfg(unix)]

use crate::common::folder::Folder;
use crate::common::program::{failed, grazing, stderr, succeeded};
use std::ffi::OsStr;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

const MODEL: &str = r#"{"model": "combined", "fresnel": "exact", "rho_d": [0.2, 0.2, 0.2], "k_s": [1, 1, 1],
                        "s": 9, "alpha": 0.5, "eta": 1.5}"#;

/// A link, a second name and a detour for a file, each with the end of a name that a command writes.
fn names(folder: &Folder, file: &Path, end: &str) -> Vec<PathBuf> {
    let [link, second] = ["link", "second"].map(|name| folder.path(format!("{name}.{end}")));
    for path in [&link, &second] {
        let _ = fs::remove_file(path);
    }
    symlink(file, &link).expect("a link");
    fs::hard_link(file, &second).expect("a second name");
    let name = link.file_name().expect("a name");
    fs::create_dir_all(folder.path("in")).expect("a folder");
    let detour = folder.path("in").join("..").join(name);
    vec![link, second, detour]
}

#[test]
fn no_command_replaces_its_input() {
    let folder = Folder::new();
    let model = folder.file("m.json", MODEL);
    let data = folder.path("d.binary");
    succeeded(&grazing(&[&"sample", &"violet-felt", &"-o", &data]));
    let directions = folder.file("d.csv", "theta_i,phi_i,theta_o,phi_o\n40,180,40,0\n");
    let spec = folder.file(
        "lobes.figure.json",
        r#"{"subjects": [{"label": "d", "source": {"measured": {"file": {"path": "d.binary", "bytes": null,
                "sha256": null}, "lookup": "smooth"}}}], "rows": [{"panels": [{"subjects": [0], "view": "lobes"}]}]}"#,
    );
    let cases: [(&Path, &str, Vec<&dyn AsRef<OsStr>>); 9] = [
        (
            &model,
            "json",
            vec![&"export", &model, &"--format", &"wgsl"],
        ),
        (
            &model,
            "json",
            vec![&"eval", &model, &"--directions", &directions],
        ),
        (
            &directions,
            "csv",
            vec![&"eval", &model, &"--directions", &directions],
        ),
        (&data, "png", vec![&"render", &data, &"--size", &"4"]),
        (
            &model,
            "png",
            vec![&"render", &data, &"--split", &model, &"--size", &"4"],
        ),
        (&data, "json", vec![&"fit", &data, &"--stages", &"1"]),
        (&data, "svg", vec![&"figure", &data, &"--preset", &"lobes"]),
        (&spec, "svg", vec![&"figure", &spec]),
        // The data that a spec names.
        (&data, "svg", vec![&"figure", &spec]),
    ];
    for (input, end, args) in cases {
        let before = fs::read(input).expect("is there");
        for output in names(&folder, input, end) {
            let mut args = args.clone();
            args.extend([&"-o" as &dyn AsRef<OsStr>, &output, &"--force"]);
            let result = grazing(&args);
            let said = stderr(&result);
            let name = output.display();
            assert_eq!(result.status.code(), Some(2), "{name}: {said}");
            assert!(said.contains("would replace an input"), "{name}: {said}");
            assert!(fs::read(input).expect("is there") == before, "{name}");
        }
    }
    // A spec that would be written over a file of fits.
    let fits = folder.file("other.figure.json", format!("[{MODEL}]"));
    let figure = folder.path("other.svg");
    let args: [&dyn AsRef<OsStr>; 7] = [
        &"figure",
        &fits,
        &"--preset",
        &"scatter",
        &"-o",
        &figure,
        &"--force",
    ];
    let result = grazing(&args);
    assert_eq!(result.status.code(), Some(2), "{}", stderr(&result));
    assert!(!figure.exists());
    // Planted: another name is another file.
    let output = folder.path("else.wgsl");
    succeeded(&grazing(&[&"export", &model, &"-o", &output, &"--force"]));
}

#[test]
fn the_data_of_every_subject_are_checked() {
    let folder = Folder::new();
    let data = folder.path("d.binary");
    succeeded(&grazing(&[&"sample", &"violet-felt", &"-o", &data]));
    let of = |sha256: &str| {
        format!(
            r#"{{"label": "d", "source": {{"measured": {{"file": {{"path": "d.binary", "bytes": 34992012,
                "sha256": "{sha256}"}}, "lookup": "smooth"}}}}}}"#
        )
    };
    let found = grazing::files::identify(&data).expect("is read");
    let (right, wrong) = (found.sha256.expect("a hash"), "0".repeat(64));
    let out = folder.path("o.svg");
    for hashes in [[&wrong, &right], [&right, &wrong]] {
        let subjects = hashes.map(|hash| of(hash)).join(", ");
        let text = format!(
            r#"{{"subjects": [{subjects}], "rows": [{{"panels": [{{"subjects": [0, 1], "view": "lobes"}}]}}]}}"#
        );
        let spec = folder.file("two.figure.json", text);
        let result = grazing(&[&"figure", &spec, &"-o", &out]);
        failed(&result, &data, "its SHA-256 differs");
        assert!(!out.exists());
        succeeded(&grazing(&[&"figure", &spec, &"-o", &out, &"--changed"]));
        fs::remove_file(&out).expect("is removed");
        fs::remove_file(folder.path("o.figure.json")).expect("is removed");
    }
}

#[test]
fn where_a_figure_cannot_be_written_is_found_before_the_work() {
    let folder = Folder::new();
    // A measured file that is not there: whoever names it has begun the work.
    let unread = folder.path("none.binary");
    let long = folder.path(format!("{}.svg", "n".repeat(246)));
    let lost = folder.path("lost.svg");
    symlink("nowhere/lost.svg", &lost).expect("a link");
    for (out, said) in [
        (&long, "the name of the file is too long"),
        (&lost, "there is no directory for the file"),
    ] {
        let args: [&dyn AsRef<OsStr>; 6] = [&"figure", &unread, &"--preset", &"lobes", &"-o", &out];
        let result = grazing(&args);
        assert_eq!(result.status.code(), Some(1));
        assert!(stderr(&result).contains(said), "{}", stderr(&result));
        assert!(!out.exists());
    }
    // Planted: without these faults it is the measured file.
    let out = folder.path("o.svg");
    let args: [&dyn AsRef<OsStr>; 6] = [&"figure", &unread, &"--preset", &"lobes", &"-o", &out];
    failed(&grazing(&args), &unread, "no such file");
    // A link to nothing is written through.
    let link = folder.path("link.svg");
    symlink("target.svg", &link).expect("a link");
    succeeded(&grazing(&[
        &"figure",
        &"--preset",
        &"scatter",
        &"-o",
        &link,
        &"--dpi",
        &"40",
    ]));
    assert!(link.is_symlink() && folder.path("target.svg").is_file());
}

#[test]
fn the_true_reason_is_named_where_a_path_lost_its_bytes() {
    use std::os::unix::ffi::OsStrExt as _;
    let folder = Folder::new();
    let name = OsStr::from_bytes(b"gr\xfcn.binary");
    let data = folder.path(name);
    succeeded(&grazing(&[&"sample", &"violet-felt", &"-o", &data]));
    let with_path = |path: &str| {
        let text = format!(
            r#"{{"subjects": [{{"label": "d", "source": {{"measured": {{"file": {{"path": {path}, "bytes": null, "sha256": null}},
                "lookup": "smooth"}}}}}}], "rows": [{{"panels": [{{"subjects": [0], "view": "lobes"}}]}}]}}"#
        );
        folder.file("n.figure.json", text)
    };
    let out = folder.path("o.svg");
    let lossy = folder.path("gr\u{fffd}n.binary");
    let spec = with_path("\"gr\u{fffd}n.binary\"");
    let said = "its path has U+FFFD where a name was no UTF-8";
    failed(&grazing(&[&"figure", &spec, &"-o", &out]), &lossy, said);
    let spec = with_path(r#"{"bytes": "gr%FCn.binary"}"#);
    succeeded(&grazing(&[&"figure", &spec, &"-o", &out]));
}
