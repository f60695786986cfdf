//! Contents of a fit file as data.

use crate::brdf::{Brdf, Params};
use crate::files::path_text;
use crate::files::paths::last_name;
use crate::fit::{EndReason, Errors, FitOptions, Outcome, Stage, Weight};
use crate::geom::Rgb;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Identity of a measured file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceFile {
    /// Path of the file, absolute where this program wrote it.
    #[serde(with = "path_text")]
    pub path: PathBuf,
    /// Length of the file in bytes; `None` where not known.
    pub bytes: Option<u64>,
    /// SHA-256 of the file's bytes in hexadecimal; `None` where not known.
    pub sha256: Option<String>,
}

impl SourceFile {
    /// Whether both files have the same bytes; `None` where a hash is not known.
    pub fn same_data(&self, other: &Self) -> Option<bool> {
        let (a, b) = (self.sha256.as_ref()?, other.sha256.as_ref()?);
        Some(a.eq_ignore_ascii_case(b))
    }

    /// Paths at which the file may be, in the order in which to look: its path, relative to `folder` if it is not
    /// absolute; its name in `folder`, as happens when both were moved.
    pub fn places(&self, folder: &Path) -> [PathBuf; 2] {
        [folder.join(&self.path), folder.join(last_name(&self.path))]
    }
}

/// Stage of a fit as recorded in a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageRecord {
    /// Stage that was run.
    pub stage: Stage,
    /// E at the start of the stage.
    pub start_error: f64,
    /// E at the end of the stage.
    pub error: f64,
    /// Number of shapes (lobe and η) that the stage has tried.
    pub evaluations: usize,
    /// Parameters at the end of the stage.
    pub params: Params,
}

/// Record of a fit with all that is needed to repeat it.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRecord {
    /// Name of the material.
    pub material: String,
    /// Measured file; `None` for data without one.
    pub source: Option<SourceFile>,
    /// Version of the program that fitted.
    pub version: String,
    /// Weight of the cells.
    pub weight: Weight,
    /// Grazing limit in degrees.
    pub limit_deg: f64,
    /// Options of the fit: stages, held values, start, bounds.
    pub options: FitOptions,
    /// Fitted model.
    pub brdf: Brdf,
    /// E of the fitted model.
    pub errors: Errors,
    /// Records of the stages that were run, in order.
    pub stages: Vec<StageRecord>,
    /// Directional albedo of the model at [`crate::fit::outcome::ALBEDO_ANGLES`], linear RGB.
    pub albedo: [Rgb; 3],
    /// Number of shapes (lobe and η) that were tried in all.
    pub evaluations: usize,
    /// Reason why the fit ended.
    pub ended: EndReason,
    /// Concerns about the parameters, a sentence each.
    pub concerns: Vec<String>,
}

impl FitRecord {
    /// Record of a fit made by this version of the program.
    pub fn new(
        material: String,
        source: Option<SourceFile>,
        (weight, limit_deg): (Weight, f64),
        options: &FitOptions,
        outcome: &Outcome,
    ) -> Self {
        let stages = outcome.stages.iter().map(|report| StageRecord {
            stage: report.stage,
            start_error: report.start_error,
            error: report.error,
            evaluations: report.evaluations,
            params: report.end.params,
        });
        Self {
            material,
            source,
            version: env!("CARGO_PKG_VERSION").into(),
            weight,
            limit_deg,
            options: options.clone(),
            brdf: outcome.brdf,
            errors: outcome.errors,
            stages: stages.collect(),
            albedo: outcome.albedo,
            evaluations: outcome.evaluations,
            ended: outcome.ended,
            concerns: outcome.concerns.iter().map(|c| c.text()).collect(),
        }
    }

    /// Whether the directional albedo is above 1 at one of the angles.
    pub fn exceeds_one(&self) -> bool {
        self.albedo.iter().flatten().any(|albedo| *albedo > 1.0)
    }
}

/// Entry of a JSON file: a model with the other keys of its object.
#[derive(Clone, Debug, PartialEq)]
pub struct FitEntry {
    /// Model of the entry.
    pub brdf: Brdf,
    /// Name of the material, in one line; `None` where it is missing or blank.
    pub material: Option<String>,
    /// Measured file that the model was fitted to; `None` where none is named.
    pub source: Option<SourceFile>,
    /// E of the model; `None` where none is given.
    pub error: Option<f64>,
    /// Record of the whole fit; `None` for a plain model.
    pub fit: Option<Box<FitRecord>>,
}
