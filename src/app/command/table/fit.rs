//! The rows of the Fit menu.

use crate::app::command::table::{Item, Row, bare, ctrl, ctrl_shift, item, one};
use crate::app::msg::command::Command;
use crate::brdf::fresnel::{FRESNELS, Fresnel};
use crate::brdf::{MODELS, Model};
use crate::fit::{WEIGHTS, Weight};
use egui::Key;

/// Rows from above to below.
pub(super) const ROWS: &[Row] = &[
    one(
        Command::Fit,
        "Fit",
        ctrl(Key::F),
        "Fit the shown model to the shown material",
    ),
    one(
        Command::Compare,
        "Compare",
        ctrl_shift(Key::F),
        "Fit the models to compare, with each Fresnel factor that is ticked, and show them in a table",
    ),
    Row::Each("Models to compare", || {
        let sets = [
            item(
                Command::CompareFamily,
                "Phong family",
                "Compare Phong, Blinn-Phong and the model between them",
            ),
            item(Command::CompareEvery, "All", "Compare every model"),
        ];
        let model = |(index, model): (usize, &&Model)| Item {
            command: Command::ToggleCompared(index),
            name: model.name.into(),
            keys: None,
            help: format!("Compare the {} model, or leave it out", model.name).into(),
        };
        sets.into_iter()
            .chain(MODELS.iter().enumerate().map(model))
            .collect()
    }),
    Row::Each("Fresnel to compare", || {
        let row = |fresnel: Fresnel| {
            let command = Command::ToggleComparedFresnel(fresnel);
            let help = "Compare the models with this Fresnel factor, or leave it out";
            item(command, fresnel.name(), help)
        };
        FRESNELS.map(row).into()
    }),
    one(
        Command::CancelFit,
        "Cancel fit",
        bare(Key::Escape),
        "Stop the fit and keep the best so far",
    ),
    one(
        Command::FitFolder,
        "Fit the folder",
        None,
        "Fit the shown model to every file of the folder that has no such fit, in the background",
    ),
    one(
        Command::CompareFolder,
        "Compare on the folder",
        None,
        "Fit the models to compare to every file of the folder that has no such fits, in the background",
    ),
    one(
        Command::CancelFitFolder,
        "Cancel fit of the folder",
        None,
        "Stop fitting the folder and keep the files that are done",
    ),
    Row::Each("Weight", || {
        let row = |weight: Weight| item(Command::UseWeight(weight), weight.name(), weight.help());
        WEIGHTS.map(row).into()
    }),
    one(
        Command::ToggleFromSliders,
        "Start from sliders",
        None,
        "Begin the fit at the present values instead of at what the data say",
    ),
    one(
        Command::ToggleFitOnOpening,
        "Fit on opening",
        None,
        "Fit a material when it is opened, unless its models come from a file",
    ),
    one(
        Command::ToggleKeepOptimal,
        "Keep ρd, ks optimal",
        ctrl(Key::K),
        "Find the best ρd and ks again whenever the lobe, η or the model change",
    ),
];
