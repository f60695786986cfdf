//! The rows of the View menu.

use crate::app::command::table::{Row, ctrl, item, one};
use crate::app::msg::command::Command;
use crate::app::state::about::About;
use crate::app::state::prefs::Theme;
use crate::app::state::side_panels::{SIDES, Side};
use crate::app::state::views::VIEWS;
use crate::app::views::sphere::settings::{SHOWS, Show};
use crate::figure::lobes::LOBE_SCALES;
use crate::geom::sphere::{LIGHT_PRESETS, LightPreset};
use crate::geom::sphere_error::SphereError;
use egui::Key;

/// Rows from above to below.
pub(super) const ROWS: &[Row] = &[
    Row::Each("Sphere", || {
        let row = |show: Show| item(Command::UseShow(show), show.name(), show_help(show));
        SHOWS.map(row).into()
    }),
    Row::Each("Lights", || {
        let presets = LIGHT_PRESETS.iter().enumerate();
        let row = |(index, preset): (usize, &LightPreset)| {
            item(Command::UseLights(index), preset.name, preset.help)
        };
        presets.map(row).collect()
    }),
    Row::Each("Lobe scale", || {
        let help = "Radius of the polar lobes per f_r";
        LOBE_SCALES
            .map(|scale| item(Command::UseScale(scale), scale.name(), help))
            .into()
    }),
    one(
        Command::ToggleShapeOnly,
        "Lobes: shape only",
        None,
        "Draw each lobe by its own maximum, to compare shapes",
    ),
    one(
        Command::ToggleCosine,
        "Lobes × cos θi",
        None,
        "Multiply the lobes by the cosine of the angle of incidence",
    ),
    one(
        Command::ToggleCosineO,
        "Lobes × cos θo",
        None,
        "Multiply the lobes by the cosine of the view angle",
    ),
    one(
        Command::ToggleRaw,
        "Raw cells",
        None,
        "Show the cells as stored, without interpolation",
    ),
    one(
        Command::NextMaterial,
        "Next material",
        ctrl(Key::PageDown),
        "Show the next open material",
    ),
    one(
        Command::PreviousMaterial,
        "Previous material",
        ctrl(Key::PageUp),
        "Show the previous open material",
    ),
    Row::Each("Theme", || {
        let themes = [
            (Theme::System, "As the system"),
            (Theme::Light, "Light"),
            (Theme::Dark, "Dark"),
        ];
        themes
            .map(|(theme, name)| item(Command::UseTheme(theme), name, "Colours of the window"))
            .into()
    }),
    one(
        Command::ZoomIn,
        "Zoom in",
        ctrl(Key::Plus),
        "Make everything in the window larger",
    ),
    one(
        Command::ZoomOut,
        "Zoom out",
        ctrl(Key::Minus),
        "Make everything in the window smaller",
    ),
    one(
        Command::ZoomReset,
        "Actual size",
        ctrl(Key::Num0),
        "Everything in the window at the size that the system asks for",
    ),
    Row::Each("Panels", || {
        let help = "Open this panel, or fold it to a strip";
        let row = |side: Side| item(Command::TogglePanel(side), side.name(), help);
        SIDES.map(row).into()
    }),
    Row::Each("Tiles", || {
        let row = |about: &About| item(Command::ToggleTile(about.id), about.name, about.help[0]);
        VIEWS.iter().map(row).collect()
    }),
    one(
        Command::ResetLayout,
        "Reset layout",
        None,
        "Put the tiles back to where they were",
    ),
];

fn show_help(show: Show) -> &'static str {
    match show {
        Show::Measured => "Show the data on the sphere",
        Show::Model => "Show the model on the sphere",
        Show::Split => "Show the data left of a line and the model right of it",
        Show::SideBySide => "Show two spheres",
        Show::Error(SphereError::Difference) => {
            "Show |model − measured| in colours beside the split sphere"
        }
        Show::Error(SphereError::Ratio) => {
            "Show model / measured in colours beside the split sphere"
        }
    }
}
