//! Fits as a file holds them, and measured files to go with them.

use super::merl::merl_file;
use grazing::brdf::COMBINED;
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, Fresnel, MODELS, Params};
use grazing::files::fits::{FitRecord, SourceFile, write_json};
use grazing::fit::{EndReason, Errors, FitOptions, Weight};
use std::path::Path;
use std::sync::LazyLock;

/// The combined model with these s and α, the rest as always.
pub fn combined(s: f64, alpha: f64) -> Brdf {
    Brdf {
        model: MODELS[2],
        fresnel: Fresnel::Exact,
        params: Params {
            lobe: lobe_values([s, alpha]),
            ..COMBINED.default_params()
        },
    }
}

/// A fit of a material that ended with this model and this E: a real one takes longer than a test.
pub fn record(material: &str, source: Option<SourceFile>, brdf: Brdf, error: f64) -> FitRecord {
    FitRecord {
        material: material.into(),
        source,
        version: "0".into(),
        weight: Weight::Cosine,
        limit_deg: 90.0,
        options: FitOptions::default(),
        brdf,
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

/// A measured file of which a fit knows the path alone.
pub fn only_named(path: impl AsRef<Path>) -> SourceFile {
    SourceFile {
        path: path.as_ref().to_owned(),
        bytes: None,
        sha256: None,
    }
}

/// Writes a fit file.
pub fn write_fits(path: &Path, fits: &[FitRecord]) {
    let mut bytes = Vec::new();
    write_json(fits, &mut bytes).expect("memory takes it");
    std::fs::write(path, bytes).expect("is written");
}

/// Writes a small made-up material: a grey diffuse one, unmeasured below the horizon.
pub fn write_merl(path: &Path) {
    static GREY: LazyLock<Vec<u8>> = LazyLock::new(|| merl_file(|_| Some([0.1; 3])));
    std::fs::write(path, &*GREY).expect("written");
}
