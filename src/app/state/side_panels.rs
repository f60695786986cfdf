//! The panels beside the tiles: which are open in a wide window and in a narrow one, and the tab of a low one.

use serde::{Deserialize, Serialize};

/// A panel beside the tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Materials and the folder, left.
    Library,
    /// Model and fit, right.
    Model,
}

/// The panels in the order of the menu.
pub const SIDES: [Side; 2] = [Side::Library, Side::Model];

impl Side {
    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Library => "Materials",
            Self::Model => "Model and fit",
        }
    }
}

/// Which panels are open; a closed one is a strip that opens it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct OpenSides {
    /// Whether that of the materials is.
    pub library: bool,
    /// Whether that of model and fit is.
    pub model: bool,
}

impl OpenSides {
    fn get_mut(&mut self, side: Side) -> &mut bool {
        match side {
            Side::Library => &mut self.library,
            Side::Model => &mut self.model,
        }
    }
}

impl Default for OpenSides {
    fn default() -> Self {
        Self {
            library: true,
            model: true,
        }
    }
}

/// The panels as a person has left them, in a wide window and in a narrow one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SidePanels {
    /// Open panels of a wide window.
    pub wide: OpenSides,
    /// Open panels of a narrow window: at first the model, which is what is worked on.
    pub narrow: OpenSides,
    /// Whether the window is narrow now.
    #[serde(skip)]
    pub is_narrow: bool,
    /// Half of the model's panel that is shown where there is no room for both.
    #[serde(skip)]
    pub tab: SideTab,
}

impl Default for SidePanels {
    fn default() -> Self {
        Self {
            wide: OpenSides::default(),
            narrow: OpenSides {
                library: false,
                model: true,
            },
            is_narrow: false,
            tab: SideTab::default(),
        }
    }
}

impl SidePanels {
    /// The panels that are open now.
    pub fn open(&self) -> OpenSides {
        if self.is_narrow {
            self.narrow
        } else {
            self.wide
        }
    }

    /// Whether a panel is open now.
    pub fn is_open(&self, side: Side) -> bool {
        *self.open().get_mut(side)
    }

    /// Opens a closed panel, closes an open one.
    pub fn toggle(&mut self, side: Side) {
        let now = if self.is_narrow {
            &mut self.narrow
        } else {
            &mut self.wide
        };
        let open = now.get_mut(side);
        *open = !*open;
    }
}

/// Half of the model's panel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SideTab {
    /// The model with its sliders.
    #[default]
    Model,
    /// The fit with its settings and stages.
    Fit,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wide_window_and_a_narrow_one_are_left_as_they_are() {
        let mut panels = SidePanels::default();
        panels.toggle(Side::Model);
        assert!(panels.is_open(Side::Library) && !panels.is_open(Side::Model));
        panels.is_narrow = true;
        assert!(!panels.is_open(Side::Library) && panels.is_open(Side::Model));
        panels.toggle(Side::Library);
        assert!(panels.is_open(Side::Library));
        panels.is_narrow = false;
        assert!(!panels.is_open(Side::Model));
    }
}
