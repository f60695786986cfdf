//! Made-up records of fits, for tests.

use crate::brdf::COMBINED;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, MODELS, Params};
use crate::files::fits::FitRecord;
use crate::fit::{EndReason, Errors, FitOptions, Weight};

/// A fit of the combined model with this s and this E.
pub(crate) fn record(s: f64, error: f64) -> FitRecord {
    FitRecord {
        material: "made up".into(),
        source: None,
        version: "0".into(),
        weight: Weight::Cosine,
        limit_deg: 90.0,
        options: FitOptions::default(),
        brdf: Brdf {
            model: MODELS[2],
            fresnel: Fresnel::Exact,
            params: Params {
                lobe: lobe_values([s, 0.5]),
                ..COMBINED.default_params()
            },
        },
        errors: Errors {
            total: error,
            grazing: None,
            channels: [error; 3],
        },
        stages: Vec::new(),
        albedo: [[0.5; 3]; 3],
        evaluations: 1,
        ended: EndReason::Converged,
        concerns: Vec::new(),
    }
}
