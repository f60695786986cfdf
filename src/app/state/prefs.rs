//! Preferences, kept between runs.

use crate::app::state::figure::FigurePrefs;
use crate::app::state::fitting::comparison::Comparison;
use crate::app::state::side_panels::SidePanels;
use crate::figure::faults::Faults;
use crate::files::path_text;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::path::PathBuf;

/// Preferences, kept between runs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Prefs {
    /// Files opened lately, the last first.
    #[serde(with = "path_text")]
    pub recent: VecDeque<PathBuf>,
    /// Light, dark, or as the system.
    pub theme: Theme,
    /// The folder that was open last.
    #[serde(with = "path_text")]
    pub folder: Option<PathBuf>,
    /// Looks and format of figures.
    pub figure: FigurePrefs,
    /// Limit of the memory for tables.
    pub memory: MemoryLimit,
    /// Open panels beside the tiles.
    pub panels: SidePanels,
    /// Size of everything in the window.
    pub zoom: Zoom,
    /// Whether a material is fitted when it is opened.
    pub fit_on_opening: FitOnOpening,
    /// Models that are fitted beside each other.
    pub comparison: Comparison,
}

/// Whether a material is fitted when it is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FitOnOpening(pub bool);

impl Default for FitOnOpening {
    fn default() -> Self {
        Self(true)
    }
}

/// Size of everything in the window, in percent of what the system asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "u32", into = "u32")]
pub struct Zoom(u32);

impl Zoom {
    const STEP: u32 = 10;
    const RANGE: std::ops::RangeInclusive<u32> = 50..=300;

    /// Size as a factor.
    pub fn factor(self) -> f32 {
        self.0 as f32 / 100.0
    }

    /// Whether a window can be as large as this factor makes it.
    pub fn offers(factor: f32) -> bool {
        let percent = f64::from(factor) * 100.0;
        (f64::from(*Self::RANGE.start())..=f64::from(*Self::RANGE.end())).contains(&percent.round())
    }

    /// One step larger.
    pub fn larger(self) -> Self {
        Self::from(self.0 + Self::STEP)
    }

    /// One step smaller.
    pub fn smaller(self) -> Self {
        Self::from(self.0.saturating_sub(Self::STEP))
    }
}

impl Default for Zoom {
    fn default() -> Self {
        Self(100)
    }
}

impl From<u32> for Zoom {
    /// The nearest size at which the window can be read.
    fn from(percent: u32) -> Self {
        Self(percent.clamp(*Self::RANGE.start(), *Self::RANGE.end()))
    }
}

impl From<Zoom> for u32 {
    fn from(zoom: Zoom) -> Self {
        zoom.0
    }
}

/// Bytes of a MiB.
pub const MIB: u64 = 1 << 20;

/// Limit of the memory for tables, in MiB.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MemoryLimit(pub u32);

impl Default for MemoryLimit {
    fn default() -> Self {
        Self(512)
    }
}

impl MemoryLimit {
    /// Limit in bytes.
    pub fn bytes(self) -> u64 {
        u64::from(self.0) * MIB
    }

    /// Limits that can be set.
    pub const RANGE: std::ops::RangeInclusive<u32> = 0..=65_536;
}

/// Number of recent files that are kept.
const RECENT: usize = 10;

impl Prefs {
    /// Whether every value is one that could have been set.
    pub fn is_possible(&self) -> bool {
        let mut faults = Faults::default();
        self.figure.style.clone().sanitize(&mut faults);
        faults.result().is_ok()
            && FigurePrefs::COLUMNS.contains(&self.figure.columns)
            && MemoryLimit::RANGE.contains(&self.memory.0)
    }

    /// Puts a file at the front of the recent ones.
    pub fn remember(&mut self, path: PathBuf) {
        self.recent.retain(|other| *other != path);
        self.recent.push_front(path);
        self.recent.truncate(RECENT);
    }
}

/// The look of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Theme {
    /// Look that the system asks for.
    #[default]
    System,
    /// Light.
    Light,
    /// Dark.
    Dark,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::side_panels::Side;
    use crate::brdf::MODELS;

    #[test]
    fn preferences_outlive_the_window_and_those_of_an_older_one_are_read() {
        let mut prefs = Prefs {
            zoom: Zoom::default().larger(),
            fit_on_opening: FitOnOpening(false),
            theme: Theme::Dark,
            ..Prefs::default()
        };
        prefs.panels.toggle(Side::Library);
        prefs.comparison.set_models(MODELS);
        let text = serde_json::to_string(&prefs).expect("JSON");
        assert_eq!(serde_json::from_str::<Prefs>(&text).expect("read"), prefs);
        // One from before there were panels that fold, sizes and fits on opening.
        let mut old: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        for key in ["panels", "zoom", "fit_on_opening", "comparison"] {
            assert!(
                old.as_object_mut()
                    .expect("an object")
                    .remove(key)
                    .is_some()
            );
        }
        let read: Prefs = serde_json::from_value(old).expect("read");
        let usual = Prefs::default();
        assert_eq!(read.theme, Theme::Dark);
        assert_eq!((read.panels, read.zoom), (usual.panels, usual.zoom));
        assert!(read.fit_on_opening.0);
        assert_eq!(read.comparison, usual.comparison);
        // A size at which nothing can be read is brought to one at which it can.
        assert_eq!(Zoom::from(3), Zoom::from(50));
        assert_eq!(Zoom::from(u32::MAX), Zoom::from(300));
    }
}
