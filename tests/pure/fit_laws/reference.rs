//! E by the book: a loop over the table in f64, and nothing of the fit's code.

use grazing::brdf::Brdf;
use grazing::fit::{Errors, Weight};
use grazing::measured::Table;
use std::f64::consts::FRAC_PI_2;

/// A cell that counts.
pub struct Counted {
    pub weight: f64,
    /// R_F · lobe.
    pub shape: f64,
    pub f_r: [f64; 3],
    grazing: bool,
}

/// The cells that count for a weight and a grazing limit in radians.
pub fn counted(table: &Table, brdf: &Brdf, weight: Weight, limit: f64) -> Vec<Counted> {
    let grid = table.grid();
    let edge = |bin: usize| (bin as f64 / 90.0).powi(2) * FRAC_PI_2;
    let mut found = Vec::new();
    for index in 0..grid.len() {
        let Some(f_r) = table.cell(index) else {
            continue;
        };
        let (h, d, phi) = grid.bins(index);
        let center = grid.center(h, d, phi);
        let c = center.cosines();
        let lower = c.cos_theta_i.min(c.cos_theta_o);
        if lower <= 0.0 || lower < limit.cos() {
            continue;
        }
        // dωh of the bin is exact: its centre would halve the first one. Bins of θd and φd are all as wide.
        let bin = edge(h).cos() - edge(h + 1).cos();
        let solid_angle = bin * center.theta_d.cos() * center.theta_d.sin();
        let weight = match weight {
            Weight::Cells => 1.0,
            Weight::SolidAngle => solid_angle,
            Weight::Cosine => solid_angle * c.cos_theta_i * c.cos_theta_o,
        };
        found.push(Counted {
            weight,
            shape: brdf.specular_shape(&c),
            f_r,
            grazing: lower <= 70_f64.to_radians().cos(),
        });
    }
    found
}

/// E over cells from [`counted`] with the same (s, α, η).
pub fn errors(cells: &[Counted], brdf: &Brdf) -> Errors {
    let channel = |k: usize, grazing_only: bool| {
        let mut sums = (0.0, 0.0);
        for cell in cells.iter().filter(|cell| cell.grazing || !grazing_only) {
            let model =
                brdf.params.rho_d[k] / std::f64::consts::PI + brdf.params.k_s[k] * cell.shape;
            sums.0 += cell.weight * (model - cell.f_r[k]).abs();
            sums.1 += cell.weight * cell.f_r[k];
        }
        sums
    };
    let over = |grazing_only: bool| {
        let sums: Vec<(f64, f64)> = (0..3).map(|k| channel(k, grazing_only)).collect();
        sums.iter().map(|sum| sum.0).sum::<f64>() / sums.iter().map(|sum| sum.1).sum::<f64>()
    };
    Errors {
        total: over(false),
        grazing: cells.iter().any(|cell| cell.grazing).then(|| over(true)),
        channels: std::array::from_fn(|k| {
            let (missed, sum) = channel(k, false);
            missed / sum
        }),
    }
}
