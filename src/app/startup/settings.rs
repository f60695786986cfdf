//! The settings file of earlier runs, looked at before the window opens: what cannot be goes, and is said once.

use crate::app::state::layout::Tiles;
use crate::app::state::prefs::{Prefs, Zoom};
use crate::app::{LAYOUT_KEY, PREFS_KEY};
use crate::files;
use ron::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// Size in bytes above which a file holds no settings. Real ones have some kilobytes.
const LARGEST: u64 = 4 << 20;

/// Key under which eframe keeps the place and the size of the window.
const WINDOW_KEY: &str = "window";

/// Key under which eframe keeps what egui remembers: widths of panels, places of scroll bars.
const EGUI_KEY: &str = "egui";

/// Screens are smaller than this, in points or pixels.
const FAR: f64 = 1e5;

/// Kept settings by their keys.
type Kept = BTreeMap<String, String>;

/// Removes what cannot be from a settings file; the old file is kept beside it. Returns a sentence about it, `None` where
/// nothing is wrong or there is no file.
pub(super) fn mend(path: &Path) -> Option<String> {
    let mut bytes = Vec::new();
    let file = fs::File::open(path).ok()?;
    file.take(LARGEST + 1).read_to_end(&mut bytes).ok()?;
    if bytes.is_empty() {
        return None;
    }
    let (mended, what) = match read(&bytes) {
        Some(mut kept) => {
            let before = kept.len();
            kept.retain(|key, text| is_possible(key, text));
            if kept.len() == before {
                return None;
            }
            (kept, "Some settings were damaged")
        }
        None => (Kept::new(), "The settings were damaged"),
    };
    let beside = beside(path);
    let kept_beside = fs::rename(path, &beside);
    let text = ron::to_string(&mended).unwrap_or_default();
    let written = kept_beside.and_then(|()| {
        files::write_atomically(path, true, |file| file.write_all(text.as_bytes()))
            .map_err(std::io::Error::other)
    });
    Some(match written {
        Ok(()) => format!(
            "{what} and are at their defaults; the old file is {}.",
            beside.display()
        ),
        Err(error) => format!("{what}, and the file cannot be mended: {error}"),
    })
}

/// The path under which a damaged file is kept.
fn beside(path: &Path) -> PathBuf {
    path.with_extension("ron.damaged")
}

fn read(bytes: &[u8]) -> Option<Kept> {
    if bytes.len() as u64 > LARGEST {
        return None;
    }
    ron::de::from_bytes(bytes).ok()
}

/// Whether a window can be opened with what is kept under a key.
fn is_possible(key: &str, text: &str) -> bool {
    match key {
        WINDOW_KEY => ron::from_str::<Value>(text).is_ok_and(|window| is_on_a_screen(&window)),
        EGUI_KEY => {
            let zoom = |memory: egui::Memory| memory.options.zoom_factor;
            let words = text.split(|c: char| !c.is_ascii_alphanumeric());
            ron::from_str(text).map(zoom).is_ok_and(Zoom::offers)
                && !words.into_iter().any(|word| matches!(word, "NaN" | "inf"))
        }
        PREFS_KEY => ron::from_str::<Prefs>(text).is_ok_and(|prefs| prefs.is_possible()),
        LAYOUT_KEY => ron::from_str::<Tiles>(text).is_ok(),
        // Of a newer version, say.
        _ => true,
    }
}

/// Whether every number can be a place or a size; sizes and scales, which have no sign, are none of 0.
fn is_on_a_screen(value: &Value) -> bool {
    match value {
        Value::Number(number) => {
            let number = number.into_f64();
            number.is_finite() && number.abs() < FAR
        }
        Value::Map(map) => map.iter().all(|(key, value)| {
            let size = matches!(key, Value::String(name) if SIZES.contains(&name.as_str()));
            is_on_a_screen(value) && (!size || is_positive(value))
        }),
        Value::Seq(values) => values.iter().all(is_on_a_screen),
        Value::Option(Some(value)) => is_on_a_screen(value),
        _ => true,
    }
}

/// Names of sizes in the settings of the window.
const SIZES: [&str; 2] = ["scale_factor", "inner_size_points"];

fn is_positive(value: &Value) -> bool {
    match value {
        Value::Number(number) => number.into_f64() > 1e-2,
        Value::Map(map) => map.values().all(is_positive),
        Value::Seq(values) => values.iter().all(is_positive),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    const WINDOW: &str = "(normal_geometry:(outer_position_pixels:Some((x:10.0,y:-20.0)),scale_factor:1.0,\
        inner_size_points:(x:1280.0,y:800.0)),fullscreen:false,maximized:false)";

    fn egui_memory(zoom: &str) -> String {
        let memory = ron::to_string(&egui::Memory::default()).expect("RON");
        let changed = memory.replace("zoom_factor:1.0", &format!("zoom_factor:{zoom}"));
        assert!(zoom == "1.0" || changed != memory, "{memory}");
        changed
    }

    fn whole() -> Kept {
        let prefs = ron::to_string(&Prefs::default()).expect("RON");
        let tiles = ron::to_string(&Tiles::default()).expect("RON");
        let of_a_newer_version = "(anything)".to_string();
        let texts = [
            WINDOW.into(),
            egui_memory("1.0"),
            prefs,
            tiles,
            of_a_newer_version,
        ];
        let keys = [WINDOW_KEY, EGUI_KEY, PREFS_KEY, LAYOUT_KEY, "grazing.new"];
        keys.map(String::from).into_iter().zip(texts).collect()
    }

    /// Writes settings and mends them: the sentence, the keys that are left, and what was kept beside.
    fn mended(bytes: &[u8]) -> (Option<String>, BTreeSet<String>, Option<Vec<u8>>) {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("app.ron");
        fs::write(&path, bytes).expect("is written");
        let said = mend(&path);
        assert_eq!(mend(&path), None, "it is said once");
        let left = read(&fs::read(&path).expect("is there")).unwrap_or_default();
        (
            said,
            left.into_keys().collect(),
            fs::read(beside(&path)).ok(),
        )
    }

    #[test]
    fn settings_that_can_be_are_left_as_they_are() {
        let text = ron::to_string(&whole()).expect("RON");
        let (said, left, beside) = mended(text.as_bytes());
        assert_eq!((said, beside), (None, None));
        assert_eq!(left.len(), whole().len());
        assert_eq!(mend(Path::new("no such file")), None);
    }

    #[test]
    fn what_cannot_be_goes_alone_and_the_old_file_stays() {
        let window = |from: &str, to: &str| {
            assert!(WINDOW.contains(from));
            WINDOW.replace(from, to)
        };
        let mut damages = vec![
            (WINDOW_KEY, window("scale_factor:1.0", "scale_factor:0.0")),
            (WINDOW_KEY, window("x:1280.0", "x:NaN")),
            (WINDOW_KEY, window("x:1280.0", "x:inf")),
            (WINDOW_KEY, window("y:800.0", "y:-800.0")),
            (WINDOW_KEY, window("x:10.0", "x:1e30")),
            (WINDOW_KEY, "(".into()),
            (
                EGUI_KEY,
                egui_memory("1.0").replace("max_passes:2", "max_passes:0"),
            ),
            (PREFS_KEY, "(zoom:-1)".into()),
            (PREFS_KEY, "(memory:(4000000000))".into()),
            (PREFS_KEY, "(figure:(style:(dpi:NaN)))".into()),
            (LAYOUT_KEY, "7".into()),
        ];
        for zoom in ["0.0", "NaN", "inf", "-1.0", "100.0", "1e-9"] {
            damages.push((EGUI_KEY, egui_memory(zoom)));
        }
        for (key, damage) in damages {
            let mut kept = whole();
            kept.insert(key.into(), damage.clone());
            let text = ron::to_string(&kept).expect("RON");
            let (said, left, beside) = mended(text.as_bytes());
            let said = said.unwrap_or_else(|| panic!("{damage} passes"));
            assert!(said.contains("Some settings were damaged"), "{said}");
            assert!(said.ends_with("app.ron.damaged."), "{said}");
            let mut expected: BTreeSet<String> = whole().into_keys().collect();
            expected.remove(key);
            assert_eq!(left, expected, "{damage}");
            assert_eq!(beside.as_deref(), Some(text.as_bytes()));
        }
    }

    #[test]
    fn a_file_that_is_no_settings_is_put_aside_whole() {
        let long = vec![b' '; LARGEST as usize + 1];
        for bytes in [&b"{\"window\": "[..], b"\xff\xfe", b"[1, 2]", &long] {
            let (said, left, beside) = mended(bytes);
            let said = said.expect("said");
            assert!(said.starts_with("The settings were damaged"), "{said}");
            assert!(left.is_empty());
            assert_eq!(beside.as_deref(), Some(bytes));
        }
    }
}
