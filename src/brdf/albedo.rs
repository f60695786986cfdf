//! Directional albedo of a model: the share of the light from one direction that it reflects.
//!
//! Glossy lobes are needles, and at grazing angles slivers: the quadrature is laid out around the mirror direction.

use super::along_phi_d::{AlongPhiD, Azimuth};
use super::model::Brdf;
use crate::geom::{Cosines, Rgb, direction, mirror};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// Directional-hemispherical reflectance ∫ f_r cos θo dωo of light from `theta_i` in [0, π/2) radians.
///
/// Right to 1e-4 of the specular part for needles as for broad lobes, and for angles up to 89°.
pub fn albedo(brdf: &Brdf, theta_i: f64) -> Rgb {
    let specular = specular_integral(brdf, theta_i);
    std::array::from_fn(|k| brdf.params.rho_d[k] + brdf.params.k_s[k] * specular)
}

/// Specular part for k_s = 1: ∫ R_F · lobe · cos θo dωo.
///
/// In polar coordinates (ψ, β) around the mirror direction: ψ is the angle between wo and wr, where a Phong lobe is
/// round, or twice θh, where a Blinn-Phong lobe is round. β = 0 points down to the horizon. In both
/// `cos θo = cos θi cos ψ − sin θi sin ψ cos β`, so the horizon is the same curve.
fn specular_integral(brdf: &Brdf, theta_i: f64) -> f64 {
    let peak = Peak::new(brdf, theta_i);
    // Along β = 90° the lobe and the horizon change within this angle, along 0° and 180° the lobe does.
    let fine = (0.5 * peak.cos_theta_i).min(0.5 / peak.stretch());
    let mut sum = 0.0;
    for quarter in [0.0, FRAC_PI_2] {
        let mut breaks = vec![0.0];
        breaks_upwards(&mut breaks, 0.5 * FRAC_PI_2, fine, 3.0);
        breaks_mirrored(&mut breaks, FRAC_PI_2);
        sum += panels(&breaks, |beta| peak.along_ray(quarter + beta));
    }
    // The other half by symmetry.
    2.0 * sum
}

/// Integrand for one direction of incidence, in polar coordinates around the mirror direction in which the lobe is as
/// round as can be.
struct Peak<'a> {
    brdf: &'a Brdf,
    wi: DVec3,
    cos_theta_i: f64,
    sin_theta_i: f64,
    /// Whether ψ is 2 θh instead of the angle to wr.
    by_half_vector: bool,
}

impl<'a> Peak<'a> {
    fn new(brdf: &'a Brdf, theta_i: f64) -> Self {
        // Below this the layout would go on for ever; what is left out is as small.
        let cos_theta_i = theta_i.cos().max(1e-5);
        let mut peak = Self {
            brdf,
            wi: direction(cos_theta_i.acos(), 0.0),
            cos_theta_i,
            sin_theta_i: (1.0 - cos_theta_i * cos_theta_i).sqrt(),
            by_half_vector: false,
        };
        let round_the_mirror = peak.stretch();
        peak.by_half_vector = true;
        peak.by_half_vector = peak.stretch() < round_the_mirror;
        peak
    }

    /// Ratio, ≥ 1, of the widths of the lobe's peak along the two axes of these coordinates.
    fn stretch(&self) -> f64 {
        // Away from the horizon, where it goes on as long.
        let along = self.width(-1.0, 0.0);
        let across = self.width(0.0, 1.0);
        (along / across).max(across / along)
    }

    /// ψ within which the lobe changes by a tenth along a ray, at most 1 rad.
    fn width(&self, cos_beta: f64, sin_beta: f64) -> f64 {
        let height = self.lobe(0.0, sin_beta, cos_beta);
        let changed = |psi: f64| {
            let lobe = self.lobe(psi, sin_beta, cos_beta);
            !((0.9 * height..=height / 0.9).contains(&lobe))
        };
        // The first change, as a peak beside the mirror direction makes it rise and fall again.
        let mut high = NARROWEST;
        while high < 1.0 && !changed(high) {
            high *= 4.0;
        }
        let mut low = 0.25 * high;
        for _ in 0..4 {
            let middle = (low * high).sqrt();
            *(if changed(middle) { &mut high } else { &mut low }) = middle;
        }
        high.min(1.0)
    }

    /// ∫ of the integrand over ψ at one β.
    fn along_ray(&self, beta: f64) -> f64 {
        let (sin_beta, cos_beta) = beta.sin_cos();
        let horizon = self.cos_theta_i.atan2(self.sin_theta_i * cos_beta);
        let fine = (1.1 * self.width(cos_beta, sin_beta)).min(0.5 * self.cos_theta_i);
        let mut ends = [
            self.end_of_mirror(sin_beta, cos_beta, horizon),
            self.end_of_open_grooves(sin_beta, cos_beta, horizon),
            horizon,
        ];
        ends.sort_by(f64::total_cmp);
        let mut sum = 0.0;
        let mut from = 0.0;
        for to in ends {
            if to <= from {
                continue;
            }
            // Fine at the peak, and fine again where a small power ends with a vertical tangent.
            let mut breaks = vec![from];
            breaks_upwards(&mut breaks, 0.5 * (from + to), fine, 2.0);
            for k in 1..=4 {
                breaks.push(to - (to - from) * 0.5 * 0.25_f64.powi(k));
            }
            breaks.push(to);
            let dim = |psi: &f64| self.lobe(*psi, sin_beta, cos_beta) < NEGLIGIBLE * self.height();
            if let Some(first) = breaks.iter().position(dim) {
                breaks.truncate(first + 1);
            }
            sum += panels(&breaks, |psi| self.integrand(psi, sin_beta, cos_beta));
            from = to;
        }
        sum
    }

    /// The lobe in the mirror direction.
    fn height(&self) -> f64 {
        self.lobe(0.0, 0.0, 1.0)
    }

    /// ψ along a ray at which the lobe becomes 0 or wr·wo does, where the clamp makes a kink; `horizon` where neither.
    fn end_of_mirror(&self, sin_beta: f64, cos_beta: f64, horizon: f64) -> f64 {
        let wr = mirror(self.wi);
        let is_dark = |psi: f64| self.lobe(psi, sin_beta, cos_beta) == 0.0;
        let goes_dark = is_dark(horizon);
        let ends = |psi: f64| match goes_dark {
            true => is_dark(psi),
            false => wr.dot(self.at(psi, sin_beta, cos_beta).0) <= 0.0,
        };
        first_true(ends, horizon)
    }

    /// ψ along a ray at which V-grooves begin to hide their walls, where the minimum makes a kink; `horizon` where the
    /// lobe has none.
    fn end_of_open_grooves(&self, sin_beta: f64, cos_beta: f64, horizon: f64) -> f64 {
        if !matches!(
            self.brdf.model.along_phi_d,
            AlongPhiD::Factor(Azimuth::VGroove)
        ) {
            return horizon;
        }
        let hidden = |psi: f64| {
            let c = Cosines::from_directions(self.wi, self.at(psi, sin_beta, cos_beta).0);
            2.0 * c.wh_n.cos * c.cos_theta_i.min(c.cos_theta_o) < c.wi_wh.cos
        };
        first_true(hidden, horizon)
    }

    /// View direction wo at (ψ, β), and the Jacobian dωo / (dψ dβ).
    fn at(&self, psi: f64, sin_beta: f64, cos_beta: f64) -> (DVec3, f64) {
        let (c, s) = (self.cos_theta_i, self.sin_theta_i);
        if self.by_half_vector {
            let (sin_h, cos_h) = (0.5 * psi).sin_cos();
            let wh = DVec3::new(-sin_h * cos_beta, sin_h * sin_beta, cos_h);
            let cos_d = self.wi.dot(wh);
            // dωo = 4 cos θd dωh
            (2.0 * cos_d * wh - self.wi, 2.0 * cos_d * sin_h)
        } else {
            let (sin_psi, cos_psi) = psi.sin_cos();
            let down = DVec3::new(-c, 0.0, -s);
            let wo = cos_psi * mirror(self.wi) + sin_psi * (cos_beta * down + sin_beta * DVec3::Y);
            (wo, sin_psi)
        }
    }

    fn lobe(&self, psi: f64, sin_beta: f64, cos_beta: f64) -> f64 {
        let wo = self.at(psi, sin_beta, cos_beta).0;
        self.brdf.lobe(&Cosines::from_directions(self.wi, wo))
    }

    fn integrand(&self, psi: f64, sin_beta: f64, cos_beta: f64) -> f64 {
        let (wo, jacobian) = self.at(psi, sin_beta, cos_beta);
        let cosines = Cosines::from_directions(self.wi, wo);
        self.brdf.specular_shape(&cosines) * cosines.cos_theta_o.max(0.0) * jacobian.max(0.0)
    }
}

/// Smallest argument in [0, `end`] at which a condition that then stays is met; `end` where it is not.
fn first_true(is_met: impl Fn(f64) -> bool, end: f64) -> f64 {
    if !is_met(end) {
        return end;
    }
    let (mut low, mut high) = (0.0, end);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        *(if is_met(middle) { &mut high } else { &mut low }) = middle;
    }
    low
}

/// Appends breaks from the last of `breaks` to `to` in growing steps, the first of length `fine`.
fn breaks_upwards(breaks: &mut Vec<f64>, to: f64, fine: f64, growth: f64) {
    let start = breaks.last().copied().unwrap_or(0.0);
    let mut step = fine;
    while start + step * 1.3 < to {
        breaks.push(start + step);
        step *= growth;
    }
    breaks.push(to);
}

/// Appends the breaks mirrored: `end` − b for each b but the last, in descending order of b.
fn breaks_mirrored(breaks: &mut Vec<f64>, end: f64) {
    for k in (0..breaks.len() - 1).rev() {
        breaks.push(end - breaks[k]);
    }
}

/// Share of the lobe's height below which its tail is not integrated. The Fresnel factor may be 1e9 times larger there.
const NEGLIGIBLE: f64 = 1e-20;

/// Narrowest width that is looked for, in rad.
const NARROWEST: f64 = 1e-9;

/// Nodes and weights of Gauss-Legendre with six points on [−1, 1]; the other half is mirrored.
const GAUSS: [(f64, f64); 3] = [
    (0.238_619_186_083_196_9, 0.467_913_934_572_691),
    (0.661_209_386_466_264_5, 0.360_761_573_048_138_6),
    (0.932_469_514_203_152, 0.171_324_492_379_170_4),
];

/// ∫ f over the panels between the breaks, by six-point Gauss-Legendre on each.
fn panels(breaks: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for pair in breaks.windows(2) {
        let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
        for (node, weight) in GAUSS {
            sum += weight * half * (f(middle - half * node) + f(middle + half * node));
        }
    }
    sum
}

#[cfg(test)]
mod tests;
