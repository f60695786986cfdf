//! The rows of the File menu.

use crate::app::command::table::{Row, ctrl, ctrl_shift, item, one};
use crate::app::msg::command::Command;
use crate::files::{MODEL_FORMATS, ModelFormat};
use crate::measured::samples::{SAMPLES, SyntheticMaterial};
use egui::Key;

/// Rows from above to below.
pub(super) const ROWS: &[Row] = &[
    one(
        Command::Open,
        "Open…",
        ctrl(Key::O),
        "Open MERL files, fit files, models or a session",
    ),
    one(
        Command::OpenPath,
        "Open path…",
        ctrl_shift(Key::O),
        "Type the path of a file to open",
    ),
    one(
        Command::OpenFolder,
        "Open folder…",
        ctrl(Key::L),
        "List the files of a folder in the library",
    ),
    Row::Each("Samples", || {
        let samples = SAMPLES.iter().enumerate();
        let row = |(index, sample): (usize, &SyntheticMaterial)| {
            item(Command::OpenSample(index), sample.name, sample.about)
        };
        samples.map(row).collect()
    }),
    one(
        Command::Close,
        "Close material",
        ctrl(Key::W),
        "Close the shown material",
    ),
    one(
        Command::CloseFolder,
        "Close folder",
        None,
        "Take the folder out of the library; open materials stay",
    ),
    one(
        Command::SaveFits,
        "Save fits of the folder…",
        None,
        "Write the fits of all files of the folder to a fit file",
    ),
    one(
        Command::SaveSession,
        "Save session…",
        ctrl(Key::S),
        "Save what is open with models, fits, views and layout; asks where the first time",
    ),
    one(
        Command::SaveSessionAs,
        "Save session as…",
        None,
        "Save what is open to another session file",
    ),
    Row::Each("Export model", || {
        let row = |format: ModelFormat| {
            let name = format!("{}…", format.name());
            item(Command::ExportModel(format), name, format.help())
        };
        MODEL_FORMATS.map(row).into()
    }),
    one(
        Command::ExportFigure,
        "Export figure…",
        ctrl(Key::E),
        "Make a figure for a paper: SVG, PDF, PNG or CSV",
    ),
    one(
        Command::SavePicture,
        "Save picture…",
        ctrl_shift(Key::S),
        "Save the window as a PNG picture",
    ),
    one(Command::Quit, "Quit", ctrl(Key::Q), "Close the program"),
];
