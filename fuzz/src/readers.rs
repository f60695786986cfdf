//! The readers, each called with bytes that may be anything. None panics, and what each says is short and in one line.

use grazing::app::session;
use grazing::brdf;
use grazing::export::FigureSpec;
use grazing::figure::faults::Faults;
use grazing::files::{self, FileError, directions, fits, folder};
use grazing::measured::merl::{self, MerlError};
use grazing::measured::{Grid, Lookup};
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::LazyLock;

/// Characters that a message has at most: four values of 120 with their keys and what is expected, and the path.
const LONGEST: usize = 1200;

fn said(text: &str) {
    assert!(text.chars().count() <= LONGEST, "long: {text}");
    assert!(!text.contains(char::is_control), "no line: {text:?}");
}

/// A MERL file. The first byte says how long the file claims to be.
pub fn merl(data: &[u8]) {
    let Some((claim, bytes)) = data.split_first() else {
        return;
    };
    let len = match claim % 4 {
        0 => merl::byte_count(Grid::FOLDED),
        1 => merl::byte_count(Grid::FULL),
        2 => bytes.len() as u64,
        _ => u64::MAX,
    };
    match merl::read(bytes, len, &mut |_| ControlFlow::Continue(())) {
        Ok(table) => assert!(table.valid_count() > 0),
        Err(MerlError::Io(error)) => panic!("{error}"),
        Err(error) => said(&error.to_string()),
    }
}

/// A model, at a position that the first byte says.
pub fn models(data: &[u8]) {
    let Some((index, text)) = data.split_first() else {
        return;
    };
    let Ok(text) = str::from_utf8(text) else {
        return;
    };
    match brdf::json::from_text(text, usize::from(index % 4)) {
        Ok(brdf) => {
            let written = brdf::json::to_value(&brdf);
            let again = brdf::json::from_value(&written).expect("what is written is read");
            assert_eq!(brdf::json::to_value(&again), written);
        }
        Err(error) => said(&error.to_string()),
    }
}

/// A fit file.
pub fn fits(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else {
        return;
    };
    match fits::entries(text) {
        Ok(entries) => {
            let count = entries.len();
            let records: Vec<_> = entries
                .iter()
                .filter_map(|e| e.fit.as_deref().cloned())
                .collect();
            let mut written = Vec::new();
            fits::write_json(&records, &mut written).expect("memory takes it");
            fits::write_csv(&records, &mut Vec::new()).expect("memory takes it");
            let all = fits::by_material(Path::new("/fuzz/fits.json"), entries);
            assert_eq!(
                all.iter().map(|fits| fits.entries.len()).sum::<usize>(),
                count
            );
        }
        Err(what) => said(&what),
    }
}

/// A session.
pub fn session(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else {
        return;
    };
    match session::read::read(text) {
        Ok((session, remarks)) => {
            remarks.iter().for_each(|remark| said(remark));
            // What was brought to what can be is left as it is the next time.
            let written = session.text().expect("data");
            let (again, _) = session::read::read(&written).expect("what is written is read");
            assert_eq!(again.text().expect("data"), written);
        }
        Err(what) => said(&what),
    }
}

/// A figure's spec.
pub fn figure(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else {
        return;
    };
    match FigureSpec::from_json(text) {
        Ok(mut spec) => {
            let settled = spec.settled();
            assert_eq!(settled.to_json(), settled.settled().to_json());
            let mut faults = Faults::default();
            spec.sanitize(&mut faults);
            if let Err(what) = faults.result() {
                said(&what);
            }
        }
        Err(what) => said(&what),
    }
}

/// A CSV of directions.
pub fn directions(data: &[u8]) {
    let Ok(text) = str::from_utf8(data) else {
        return;
    };
    match directions::parse(text.to_owned(), &["r", "g", "b"]) {
        Ok(directions) => {
            let each = directions.for_each(|row, wi, wo| {
                assert_eq!(row.len(), directions.header.len());
                assert!((wi.length() - 1.0).abs() < 1e-9 && (wo.length() - 1.0).abs() < 1e-9);
                Ok::<(), ()>(())
            });
            assert_eq!(each, Ok(()));
        }
        Err(what) => said(&what),
    }
}

/// A file of any kind, opened by every way in. The first byte says what it is called.
pub fn open(data: &[u8]) {
    static FOLDER: LazyLock<tempfile::TempDir> =
        LazyLock::new(|| tempfile::tempdir().expect("a folder"));
    let Some((name, bytes)) = data.split_first() else {
        return;
    };
    let name = ["a.json", "a.binary", "a.grazing.json", "a"][usize::from(name % 4)];
    let path = FOLDER.path().join(name);
    fs::write(&path, bytes).expect("is written");
    let failed = |error: &FileError| said(&error.to_string());
    let go_on = &mut |_| ControlFlow::Continue(());
    if let Err(error) = files::open_json(&path) {
        failed(&error);
    }
    if let Err(error) = folder::inspect(&path) {
        failed(&error);
    }
    match files::open_source(&path, 0, go_on) {
        Ok(source) => {
            let up = glam::DVec3::Z;
            source.eval(up, up, Lookup::Smooth);
        }
        Err(error) => failed(&error),
    }
    if let Err(error) = files::open_table(&path, go_on) {
        failed(&error);
    }
    if let Err(error) = directions::read(&path, &[]) {
        failed(&error);
    }
    if let Err(error) = FigureSpec::open(&path) {
        said(&error.to_string());
    }
}
