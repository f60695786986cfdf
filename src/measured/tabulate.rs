//! Tabulation of a model on the grid: a noiseless measurement.

use super::grid::Grid;
use super::table::Table;
use crate::brdf::Brdf;
use rayon::prelude::*;

/// Table of a model's f_r at the centre of every cell; cells whose centre is below the horizon are invalid.
pub fn tabulate(brdf: &Brdf, grid: Grid) -> Table {
    let cells = (0..grid.len()).into_par_iter().map(|index| {
        let (theta_h, theta_d, phi_d) = grid.bins(index);
        let c = grid.center(theta_h, theta_d, phi_d).cosines();
        if c.above_horizon() {
            brdf.eval(&c).map(|value| value as f32)
        } else {
            [f32::NAN; 3]
        }
    });
    Table::new(grid, cells.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::fresnel::FRESNELS;
    use crate::brdf::params::lobe_values;
    use crate::brdf::{Fresnel, MODELS, Params};
    use crate::measured::merl;
    use std::ops::ControlFlow;

    fn brdf(model: usize, fresnel: usize) -> Brdf {
        Brdf {
            model: MODELS[model],
            fresnel: FRESNELS[fresnel],
            params: Params {
                rho_d: [0.3, 0.2, 1e-3],
                k_s: [30.0, 20.0, 1e4],
                lobe: lobe_values([80.0, 0.3]),
                eta: 1.6,
            },
        }
    }

    /// Bytes of the table as a MERL file, and the table read back from them.
    fn written_and_read(table: &Table) -> (Vec<u8>, Table) {
        let mut bytes = Vec::new();
        merl::write(table, &mut bytes).expect("memory takes it");
        let read = merl::read(&bytes[..], bytes.len() as u64, &mut |_| {
            ControlFlow::Continue(())
        });
        (bytes, read.expect("a MERL file"))
    }

    /// Largest relative distance from f_r at the centres in units of the f32 step; `None` where validity differs.
    fn worst_distance(table: &Table, brdf: &Brdf) -> Option<f64> {
        let grid = table.grid();
        let mut worst: f64 = 0.0;
        for index in 0..grid.len() {
            let (theta_h, theta_d, phi_d) = grid.bins(index);
            let (wi, wo) = grid.center(theta_h, theta_d, phi_d).to_directions();
            // Away from the horizon, where rounding decides.
            if wi.z.min(wo.z).abs() < 1e-12 {
                continue;
            }
            match (table.cell(index), brdf.f_r(wi, wo)) {
                (None, None) => {}
                (Some(found), Some(wanted)) => {
                    for (found, wanted) in found.into_iter().zip(wanted) {
                        worst = worst.max((found / wanted - 1.0).abs() / f64::from(f32::EPSILON));
                    }
                }
                _ => return None,
            }
        }
        Some(worst)
    }

    #[test]
    fn a_merl_file_of_a_model_is_read_back_as_the_model_at_every_centre() {
        for (model, fresnel) in [(0, 0), (1, 2), (2, 1)] {
            let brdf = brdf(model, fresnel);
            let table = tabulate(&brdf, Grid::FOLDED);
            let (bytes, read) = written_and_read(&table);
            assert_eq!(bytes.len(), 34_992_012);
            let worst = worst_distance(&read, &brdf).expect("the same cells are valid");
            assert!(worst <= 1.0, "{worst} steps of f32");
            // The share of centres below the horizon, counted with NumPy.
            let below = 1.0 - read.valid_count() as f64 / Grid::FOLDED.len() as f64;
            assert!((below - 0.248).abs() < 1e-3, "{below}");
        }
    }

    #[test]
    fn a_merl_file_of_every_model_is_read_back_and_tells_it_from_its_like() {
        for model in MODELS {
            let brdf = Brdf::new(model, Fresnel::Exact);
            let (_, read) = written_and_read(&tabulate(&brdf, Grid::FOLDED));
            let worst = worst_distance(&read, &brdf).expect("the same cells are valid");
            assert!(worst <= 1.0, "{}: {worst} steps of f32", model.key);
            let mut planted = brdf;
            planted.params.lobe[0] *= 1.0 + 1e-4;
            let worst = worst_distance(&read, &planted).expect("the same cells are valid");
            assert!(worst > 10.0, "{}: {worst} steps of f32", model.key);
        }
    }

    #[test]
    fn the_bytes_are_those_of_the_format() {
        let brdf = brdf(2, 1);
        let (bytes, _) = written_and_read(&tabulate(&brdf, Grid::FOLDED));
        let stored = |cell: usize| {
            let at = 12 + 8 * cell;
            f64::from_le_bytes(std::array::from_fn(|k| bytes[at + k]))
        };
        // By hand: θh bin 20, θd bin 30, φd bin 40 has its centre at ((20.5/90)² · 90°, 30.5°, 40.5°).
        let theta_h = (20.5_f64 / 90.0).powi(2) * 90.0_f64.to_radians();
        let angles = crate::geom::HalfDiff {
            theta_h,
            theta_d: 30.5_f64.to_radians(),
            phi_d: 40.5_f64.to_radians(),
        };
        let (wi, wo) = angles.to_directions();
        let wanted = brdf.f_r(wi, wo).expect("above the horizon");
        let cell = 40 + 180 * (30 + 90 * 20);
        for (channel, scale) in [1.0, 1.15, 1.66].into_iter().enumerate() {
            let found = stored(channel * 1_458_000 + cell) * scale / 1500.0;
            assert!((found / wanted[channel] - 1.0).abs() < 1e-6);
        }
        // θh and θd near 90° with φd = 0 are below it.
        assert_eq!(stored(180 * (89 + 90 * 89)), -1.0);
        let full = tabulate(&brdf, Grid::FULL);
        assert_eq!(written_and_read(&full).0.len(), 69_984_012);
    }
}
