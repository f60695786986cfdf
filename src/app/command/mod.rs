//! The commands: one list behind menus, shortcuts, tooltips and the palette.

pub mod search;
pub mod table;

pub use crate::app::msg::command::Command;

use crate::app::command::table::{Item, MENUS, Row};
use crate::app::state::{State, folder_fit};
use crate::app::views::lobes::settings::LobeSettings;
use crate::app::views::sphere::settings::SphereSettings;
use crate::brdf::{MODELS, PHONG_FAMILY};
use crate::geom::sphere::LIGHT_PRESETS;
use crate::measured::lookup::Lookup;
use egui::KeyboardShortcut;
use std::borrow::Cow;
use std::sync::LazyLock;

/// A command with its place in the menus.
#[derive(Debug)]
pub struct Entry {
    /// The command.
    pub command: Command,
    /// Menu of the bar.
    pub menu: &'static str,
    /// Submenu, empty for none.
    pub submenu: &'static str,
    /// Name in the menu.
    pub name: Cow<'static, str>,
    /// Keys that run it.
    pub keys: Option<KeyboardShortcut>,
    /// One sentence.
    pub help: Cow<'static, str>,
}

/// All commands in menu order.
pub static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let rows = MENUS
        .iter()
        .flat_map(|menu| menu.rows.iter().map(|row| (menu.name, row)));
    rows.flat_map(|(menu, row)| match row {
        Row::One(Item {
            command,
            name,
            keys,
            help,
        }) => vec![Entry {
            command: *command,
            menu,
            submenu: "",
            name: name.clone(),
            keys: *keys,
            help: help.clone(),
        }],
        Row::Each(submenu, items) => items()
            .into_iter()
            .map(|item| Entry {
                command: item.command,
                menu,
                submenu,
                name: item.name,
                keys: item.keys,
                help: item.help,
            })
            .collect(),
    })
    .collect()
});

impl Entry {
    /// Name with its submenu, such as "Theme: Light".
    pub fn title(&self) -> String {
        match self.submenu {
            "" => self.name.to_string(),
            submenu => format!("{submenu}: {}", self.name),
        }
    }
}

impl Command {
    /// The row of this command; `None` for those that depend on the state (recent files).
    pub fn entry(self) -> Option<&'static Entry> {
        ENTRIES.iter().find(|entry| entry.command == self)
    }

    /// The name with the keys, for tooltips.
    pub fn hint(self, ctx: &egui::Context) -> String {
        let Some(entry) = self.entry() else {
            return String::new();
        };
        match &entry.keys {
            Some(keys) => format!("{} ({})", entry.help, ctx.format_shortcut(keys)),
            None => entry.help.to_string(),
        }
    }

    /// Whether it can be done now.
    pub fn is_enabled(self, state: &State) -> bool {
        match self {
            Self::Undo => state.history.can_undo(),
            Self::Redo => state.history.can_redo(),
            Self::Close
            | Self::CopyParams
            | Self::ExportModel(_)
            | Self::ExportFigure
            | Self::GuessParams
            | Self::ResetParams
            | Self::UseModel(_)
            | Self::UseFresnel(_) => state.current().is_some(),
            Self::Copy => Self::CopyProbe.is_enabled(state) || Self::CopyPicture.is_enabled(state),
            Self::CopyPicture | Self::CopyNumbers => state.meant_view().is_some(),
            Self::CopyProbe => state.probe().is_some() && state.current().is_some(),
            Self::Unpin => state.pinned.is_some() && state.dialog.is_none(),
            Self::Fit => state.fit_blocked().is_none(),
            Self::Compare => state.comparison_blocked().is_none(),
            Self::CancelFit => {
                state.dialog.is_none() && state.fit.run.as_ref().is_some_and(|run| !run.stopping)
            }
            Self::ZoomIn => state.prefs.zoom.larger() != state.prefs.zoom,
            Self::ZoomOut => state.prefs.zoom.smaller() != state.prefs.zoom,
            Self::NextMaterial | Self::PreviousMaterial => {
                state.scene.opened.len() > 1 || state.library.folder.is_some()
            }
            Self::CloseFolder => state.library.folder.is_some(),
            Self::FitFolder => folder_fit::blocked(state).is_none(),
            Self::CompareFolder => {
                let blocked = folder_fit::blocked(state);
                blocked.or(state.prefs.comparison.blocked()).is_none()
            }
            Self::CancelFitFolder => state.library.run.is_some(),
            Self::SaveFits => state.library.folder_fits().next().is_some(),
            _ => true,
        }
    }

    /// Whether it is what is shown now, for commands that choose.
    pub fn is_checked(self, state: &State) -> Option<bool> {
        let scene = &state.scene;
        let brdf = state.current().map(|(_, opened)| opened.brdf);
        Some(match self {
            Self::UseModel(index) => brdf.is_some_and(|brdf| brdf.model.index() == index),
            Self::UseFresnel(fresnel) => brdf.is_some_and(|brdf| brdf.fresnel == fresnel),
            Self::CompareFamily => state.prefs.comparison.is_of(PHONG_FAMILY),
            Self::CompareEvery => state.prefs.comparison.is_of(MODELS),
            Self::ToggleCompared(index) => MODELS
                .get(index)
                .is_some_and(|model| state.prefs.comparison.has_model(model)),
            Self::ToggleComparedFresnel(fresnel) => state.prefs.comparison.has_fresnel(fresnel),
            Self::ToggleKeepOptimal => state.fit.keep_optimal,
            Self::ToggleFitOnOpening => state.prefs.fit_on_opening.0,
            Self::ToggleFromSliders => state.fit.settings.from_sliders,
            Self::UseWeight(weight) => state.fit.settings.weight == weight,
            Self::UseShow(show) => scene.views.get::<SphereSettings>().show == show,
            Self::UseLights(index) => LIGHT_PRESETS.get(index).is_some_and(|preset| {
                (preset.lights)() == scene.views.get::<SphereSettings>().view.lights
            }),
            Self::UseScale(scale) => scene.views.get::<LobeSettings>().scale == scale,
            Self::ToggleShapeOnly => scene.views.get::<LobeSettings>().shape_only,
            Self::ToggleCosine => scene.views.get::<LobeSettings>().cosine.theta_i,
            Self::ToggleCosineO => scene.views.get::<LobeSettings>().cosine.theta_o,
            Self::ToggleRaw => scene.lookup == Lookup::Nearest,
            Self::ToggleTile(pane) => state.tiles.is_open(pane),
            Self::UseTheme(theme) => state.prefs.theme == theme,
            Self::TogglePanel(side) => state.prefs.panels.is_open(side),
            _ => return None,
        })
    }
}
