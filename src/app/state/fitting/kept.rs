//! Fits that are kept with their material.

use crate::app::state::fitting::settings::Setup;
use crate::brdf::Fresnel;
use crate::files::SourceFile;
use crate::files::fits::FitRecord;
use crate::fit::{EndReason, FitProgress, Outcome, StageReport, Variant, diagnostics};
use crate::geom::degrees;

/// A fit that is kept with its material.
#[derive(Clone, Debug)]
pub struct KeptFit {
    /// Result of the fit.
    pub outcome: Outcome,
    /// Settings it was made with.
    pub setup: Setup,
    /// Duration in seconds; `None` where nobody knows.
    pub seconds: Option<f64>,
    /// All that it said while it ran; may be empty.
    pub trace: Vec<FitProgress>,
    /// Whether it was made when its material was opened.
    pub on_opening: bool,
    /// Whether its lobes are drawn beside the model's.
    pub overlaid: bool,
}

impl KeptFit {
    /// Model and Fresnel factor that were fitted.
    pub fn variant(&self) -> Variant {
        Variant::from(&self.outcome.brdf)
    }

    /// Record of the fit, as fit files keep it.
    pub fn record(&self, material: String, source: Option<SourceFile>) -> FitRecord {
        let Setup {
            weight,
            limit,
            options,
        } = &self.setup;
        let asked = (*weight, degrees::rounded(*limit));
        FitRecord::new(material, source, asked, options, &self.outcome)
    }

    /// Whether it was stopped before its end.
    pub fn is_cancelled(&self) -> bool {
        self.outcome.ended == EndReason::Cancelled
    }
}

impl From<&FitRecord> for KeptFit {
    /// A fit from a file; where its first stage began is not in there, nor what it said.
    fn from(record: &FitRecord) -> Self {
        let variant = Variant::from(&record.brdf);
        let end = |k: usize| variant.with(record.stages[k].params);
        let stages = record
            .stages
            .iter()
            .enumerate()
            .map(|(k, stage)| StageReport {
                stage: stage.stage,
                start: end(k.saturating_sub(1)),
                start_error: stage.start_error,
                end: end(k),
                error: stage.error,
                evaluations: stage.evaluations,
            });
        Self {
            outcome: Outcome {
                brdf: record.brdf,
                errors: record.errors,
                stages: stages.collect(),
                evaluations: record.evaluations,
                ended: record.ended,
                albedo: record.albedo,
                concerns: diagnostics::diagnose(&record.brdf, &record.options, &record.albedo),
            },
            setup: Setup {
                weight: record.weight,
                limit: record.limit_deg.to_radians(),
                options: record.options.clone(),
            },
            seconds: None,
            trace: Vec::new(),
            on_opening: false,
            overlaid: false,
        }
    }
}

/// A variant in few words, where room is short.
pub fn short_variant_name(variant: Variant) -> String {
    let model = variant.model.name;
    match variant.fresnel {
        Fresnel::None => model.to_string(),
        fresnel => format!("{model}, {}", fresnel.key()),
    }
}

/// A variant in words.
pub fn variant_name(variant: Variant) -> String {
    let model = variant.model.name;
    match variant.fresnel {
        Fresnel::None => format!("{model}, no Fresnel"),
        Fresnel::Exact => format!("{model}, exact Fresnel"),
        Fresnel::Schlick => format!("{model}, Schlick Fresnel"),
    }
}
