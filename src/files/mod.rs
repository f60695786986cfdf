//! The file system, for the window and the command line alike: opening materials and models, writing whole files.
//!
//! May know [`crate::geom`], [`crate::brdf`], [`crate::measured`] and [`crate::fit`]; knows no egui, wgpu or threads.

mod bytes;
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
mod temporary;
mod write;

pub use bytes::{read_bytes, read_head};
pub use error::FileError;
pub use fits::SourceFile;
pub use model_export::{MODEL_FORMATS, ModelFormat};
pub use open::{
    Json, OnProgress, OpenedSource, identify, open_json, open_measured, open_model, open_models,
    open_source, open_table, read_text,
};
pub use paths::{absolute, is_same_file, last_name, material_name, named_place, place};
pub use temporary::{PREFIX as TEMPORARY_PREFIX, remove_unfinished};
pub use write::{Whole, WriteSeek, check_writable, prepare_and_fill, write_atomically};
