//! The file system, for the window and the command line alike: opening materials and models, writing whole files.
//!
//! May know [`crate::geom`], [`crate::brdf`], [`crate::measured`] and [`crate::fit`]; knows no egui, wgpu or threads.

pub mod directions;
mod error;
pub mod fits;
pub mod folder;
mod json_file;
mod model_export;
pub mod names;
mod open;
pub mod path_text;
mod paths;
pub mod session;
mod write;

pub use error::FileError;
pub use fits::SourceFile;
pub use model_export::{MODEL_FORMATS, ModelFormat};
pub use open::{
    Json, OnProgress, OpenedSource, identify, open_json, open_measured, open_model, open_models,
    open_source, open_table, read_text,
};
pub use paths::{absolute, last_name, material_name, named_place, place};
pub use write::{check_writable, write_atomically};
