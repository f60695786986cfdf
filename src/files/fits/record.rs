//! What a fit file holds of a fit.

use crate::brdf::{Brdf, Params};
use crate::fit::{Ended, Errors, Options, Outcome, Stage, Weight};
use crate::geom::Rgb;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Which measured file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SourceFile {
    /// Its path, from the root on where this program wrote it.
    pub path: String,
    /// Its length.
    pub bytes: Option<u64>,
    /// SHA-256 of its bytes in hexadecimal.
    pub sha256: Option<String>,
}

impl SourceFile {
    /// Whether both are the same bytes; `None` where one of them is not known.
    pub fn same_data(&self, other: &Self) -> Option<bool> {
        let (a, b) = (self.sha256.as_ref()?, other.sha256.as_ref()?);
        Some(a.eq_ignore_ascii_case(b))
    }

    /// The places where it may be, in the order in which to look: its path, seen from `folder` if it is relative;
    /// in `folder` under the same name, as happens when both were moved.
    pub fn places(&self, folder: &Path) -> [PathBuf; 2] {
        // The path may come from another system.
        let name = self.path.rsplit(['/', '\\']).next().unwrap_or(&self.path);
        [folder.join(&self.path), folder.join(name)]
    }
}

/// A stage of a fit as the file keeps it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageRecord {
    /// Which one.
    pub stage: Stage,
    /// E where it began.
    pub start_error: f64,
    /// E where it ended.
    pub error: f64,
    /// How many shapes (s, α, η) it has tried.
    pub evaluations: usize,
    /// Where it ended.
    pub params: Params,
}

/// A fit with all that one must know to repeat it.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRecord {
    /// Name of the material.
    pub material: String,
    /// The measured file; `None` for data without one.
    pub source: Option<SourceFile>,
    /// Version of the program that fitted.
    pub version: String,
    /// How much a cell counted.
    pub weight: Weight,
    /// The grazing limit in degrees.
    pub limit_deg: f64,
    /// Stages, what was held, where it began, bounds.
    pub options: Options,
    /// The fitted model.
    pub brdf: Brdf,
    /// Its E.
    pub errors: Errors,
    /// The stages that were run, in order.
    pub stages: Vec<StageRecord>,
    /// Directional albedo at [`crate::fit::outcome::ALBEDO_ANGLES`].
    pub albedo: [Rgb; 3],
    /// How many shapes (s, α, η) were tried in all.
    pub evaluations: usize,
    /// Why it ended.
    pub ended: Ended,
    /// What to know before trusting it, as sentences.
    pub concerns: Vec<String>,
}

impl FitRecord {
    /// The record of a fit made by this program.
    pub fn new(
        material: String,
        source: Option<SourceFile>,
        (weight, limit_deg): (Weight, f64),
        options: &Options,
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
            options: *options,
            brdf: outcome.brdf,
            errors: outcome.errors,
            stages: stages.collect(),
            albedo: outcome.albedo,
            evaluations: outcome.evaluations,
            ended: outcome.ended,
            concerns: outcome.concerns.iter().map(|c| c.text()).collect(),
        }
    }

    /// Whether the model reflects more than it receives at one of the angles.
    pub fn exceeds_one(&self) -> bool {
        self.albedo.iter().flatten().any(|albedo| *albedo > 1.0)
    }
}

/// A model of a JSON file with what the file says around it.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The model.
    pub brdf: Brdf,
    /// Name of the material, in one line.
    pub material: Option<String>,
    /// The measured file that it was fitted to.
    pub source: Option<SourceFile>,
    /// Its E.
    pub error: Option<f64>,
    /// All the rest, where the entry is a whole fit and no plain model.
    pub fit: Option<FitRecord>,
}
