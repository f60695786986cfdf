//! Which variants a variant contains.

use super::options::{Options, Variant};
use crate::brdf::{MODELS, ParamId, params};

/// The variants that equal this one at some α, with the options that mean the same for them.
pub fn variants(variant: Variant, options: &Options) -> Vec<(Variant, Options)> {
    let Some(alpha) = variant.model.param(ParamId::Alpha) else {
        return Vec::new();
    };
    if options.held.alpha.is_some() {
        return Vec::new();
    }
    let (low, high) = options.bounds_of(alpha);
    let within = |alpha: f64| (low..=high).contains(&alpha);
    MODELS
        .into_iter()
        .filter(|model| model.alpha.is_some_and(within))
        .map(|model| {
            let ratio = model.exponent_ratio / variant.model.exponent_ratio;
            let mut inner = *options;
            inner.held.s = inner.held.s.map(|s| s * ratio);
            inner.start.s = inner.start.s.map(|s| s * ratio);
            for (bounds, row) in inner.bounds.iter_mut().zip(params::ALL) {
                if row.id == ParamId::S {
                    *bounds = bounds.map(|(low, high)| (low * ratio, high * ratio));
                }
            }
            let fresnel = variant.fresnel;
            (Variant { model, fresnel }, inner)
        })
        .collect()
}
