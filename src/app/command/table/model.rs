//! The rows of the Model menu.

use crate::app::command::table::{Item, Row, ctrl, item};
use crate::app::msg::command::Command;
use crate::brdf::fresnel::{FRESNELS, Fresnel};
use crate::brdf::{MODELS, Model};
use egui::Key;

/// Keys of the models, with Ctrl.
const DIGITS: [Key; 9] = [
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::Num5,
    Key::Num6,
    Key::Num7,
    Key::Num8,
    Key::Num9,
];

/// Rows from above to below.
pub(super) const ROWS: &[Row] = &[
    Row::Each("", || {
        let models = MODELS.iter().enumerate();
        let row = |(index, model): (usize, &&Model)| Item {
            command: Command::UseModel(index),
            name: model.name.into(),
            keys: DIGITS.get(index).and_then(|key| ctrl(*key)),
            help: format!("Use the {} model", model.name).into(),
        };
        models.map(row).collect()
    }),
    Row::Each("Fresnel", || {
        let row = |fresnel: Fresnel| {
            item(
                Command::UseFresnel(fresnel),
                fresnel.name(),
                fresnel_help(fresnel),
            )
        };
        FRESNELS.map(row).into()
    }),
];

fn fresnel_help(fresnel: Fresnel) -> &'static str {
    match fresnel {
        Fresnel::None => "No Fresnel factor on the specular term",
        Fresnel::Exact => "The Fresnel equations for unpolarised light on a dielectric",
        Fresnel::Schlick => "Schlick's approximation",
    }
}
