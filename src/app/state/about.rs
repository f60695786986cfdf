//! Row of a view: what there is to know of it without drawing it.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::SettingsKind;

/// The half of the default layout in which a view is at first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// Upper half, with the sphere.
    Upper,
    /// Lower half, with the lobes.
    Lower,
}

/// Condition under which a figure can show a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnPaper {
    /// Never.
    Never,
    /// Some material is open.
    Always,
    /// The shown material has data.
    WithData,
    /// Some material has a fit of the model whose materials are shown.
    WithMaterials,
    /// Some material has a fit.
    WithFits,
}

/// Row of a view: what there is to know about it without drawing it.
#[derive(Debug)]
pub struct About {
    /// Identity of the view.
    pub id: ViewId,
    /// Name in ids and file names.
    pub key: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Three lines behind its "?".
    pub help: [&'static str; 3],
    /// Half of the default layout in which it is at first.
    pub home: Home,
    /// Condition under which a figure can show it.
    pub on_paper: OnPaper,
    /// Kind of its settings; `None` where it has none.
    pub settings: Option<SettingsKind>,
}

impl About {
    /// Name of the view in the settings of a session.
    pub fn session_key(&self) -> String {
        self.key.replace('-', "_")
    }
}
