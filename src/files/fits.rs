//! Fit files: material, options and result of fits, for the window and the command line alike.
//!
//! A fit file is a JSON array with an object per fit; `docs/formats.md` documents its keys. Each object is also a model that
//! [`crate::brdf::json`] reads. A CSV of the same fits is written for spreadsheets and not read.

mod csv;
mod json;
mod materials;
mod record;

pub use csv::write_csv;
pub use json::{entries, from_value, to_value, write_json};
pub use materials::{MaterialFits, best_of, by_material};
pub use record::{FitEntry, FitRecord, SourceFile, StageRecord};

#[cfg(test)]
mod tests;
