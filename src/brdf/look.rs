//! From one model to another with the look kept.

use super::model::{Brdf, Model};
use super::models::MODELS;
use super::params::LobeValues;
use crate::geom::{Cosines, direction};
use std::f64::consts::FRAC_PI_2;

impl Brdf {
    /// BRDF of another model that looks alike: equal to this one where one of the two contains the other (or a third
    /// both), else with the same width and height of the highlight at normal incidence, and the defaults of the other
    /// parameters.
    pub fn with_model(&self, model: &'static Model) -> Self {
        let with = |lobe: LobeValues| {
            let mut other = Brdf { model, ..*self };
            other.params.lobe = lobe;
            for (value, row) in other.params.lobe.iter_mut().zip(model.params) {
                *value = row.clamp(*value);
            }
            other
        };
        if self.model == model {
            return *self;
        }
        if let Some(inner) = model.containing(self.model) {
            return with(inner.outer(&self.params.lobe));
        }
        if let Some(inner) = self.model.containing(model) {
            return with(inner.inner(&self.params.lobe));
        }
        let mut thirds = MODELS.iter();
        let third = thirds
            .find_map(|third| Some((third.containing(self.model)?, third.containing(model)?)));
        if let Some((from, to)) = third {
            return with(to.inner(&from.outer(&self.params.lobe)));
        }
        let mut other = with(model.default_lobe());
        other.params.lobe[0] = of_width(&other, half_width(self));
        let (height, now) = (normal_height(self), normal_height(&other));
        if height > 0.0 && now > 0.0 {
            other.params.k_s = other.params.k_s.map(|k_s| k_s * (height / now));
        }
        other
    }
}

/// The lobe at normal incidence, seen from the normal.
fn normal_height(brdf: &Brdf) -> f64 {
    brdf.lobe(&seen_from_above(0.0))
}

/// Cosines for light along the normal and a viewer at `theta_o` radians.
fn seen_from_above(theta_o: f64) -> Cosines {
    Cosines::from_directions(direction(0.0, 0.0), direction(theta_o, 0.0))
}

/// θo in radians at which the lobe has half its height, for light along the normal; 90° where it never has.
pub fn half_width(brdf: &Brdf) -> f64 {
    let half = 0.5 * normal_height(brdf);
    let above = |theta_o: f64| brdf.lobe(&seen_from_above(theta_o)) > half;
    // In the logarithm, for needles are as wide as 1e-4 rad.
    let (mut low, mut high) = (1e-8_f64.ln(), FRAC_PI_2.ln());
    if above(FRAC_PI_2) {
        return FRAC_PI_2;
    }
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        *(if above(middle.exp()) {
            &mut low
        } else {
            &mut high
        }) = middle;
    }
    (0.5 * (low + high)).exp()
}

/// Number of bisections: ln(1e8) halved until 1e-14 is left.
const STEPS: usize = 52;

/// Value of the first parameter with which the highlight has a width: the nearest within its slider's range.
fn of_width(brdf: &Brdf, width: f64) -> f64 {
    let Some(row) = brdf.model.params.first() else {
        return 0.0;
    };
    let width_of = |value: f64| {
        let mut other = *brdf;
        other.params.lobe[0] = value;
        half_width(&other)
    };
    let (mut low, mut high) = row.range;
    // Exponents make a highlight narrower, roughness makes it wider.
    let narrows = width_of(high) < width_of(low);
    for _ in 0..STEPS {
        let middle = (low * high).sqrt();
        let wider = width_of(middle) > width;
        *(if wider == narrows {
            &mut low
        } else {
            &mut high
        }) = middle;
    }
    (low * high).sqrt()
}
