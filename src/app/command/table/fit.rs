//! The rows of the Fit menu.

use crate::app::command::table::{Row, bare, ctrl, ctrl_shift, item, one};
use crate::app::msg::command::Command;
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
        Command::FitAll,
        "Fit all six",
        ctrl_shift(Key::F),
        "Fit every model without and with the Fresnel factor, and compare them in a table",
    ),
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
        Command::FitFolderAll,
        "Fit all six to the folder",
        None,
        "Fit every model to every file of the folder that has no such fits, in the background",
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
        "Begin the fit at the present s, α and η instead of at what the data say",
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
        "Find the best ρd and ks again whenever s, α, η or the model change",
    ),
];
