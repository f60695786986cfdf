//! What there is to know of a view without drawing it.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;

/// The half of the default layout in which a view is at first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// With the sphere.
    Upper,
    /// With the lobes.
    Lower,
}

/// When a figure can show a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnPaper {
    /// It cannot.
    Never,
    /// Where a material is open.
    Always,
    /// Where the shown material has data.
    WithData,
    /// Where some material has a fit of the combined model.
    WithCombinedFits,
}

/// What there is to know about a view without drawing it.
#[derive(Debug)]
pub struct About {
    /// Which one.
    pub id: ViewId,
    /// Name in ids and file names.
    pub key: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Three lines behind its "?".
    pub help: [&'static str; 3],
    /// Where it is at first.
    pub home: Home,
    /// When a figure can show it.
    pub on_paper: OnPaper,
    /// How its settings are made and read; `None` where it has none.
    pub settings: Option<SettingsKind>,
}

impl About {
    /// Name of the view in the settings of a session.
    pub fn session_key(&self) -> String {
        self.key.replace('-', "_")
    }
}
