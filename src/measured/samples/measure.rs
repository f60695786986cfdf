//! Synthetic measurement of a sample material on the MERL grid, with noise and with gaps at the horizon.

use super::SyntheticMaterial;
use super::surface::diffuse_ground;
use crate::geom::Rgb;
use crate::measured::{Grid, Table};

/// Relative standard deviation of the noise that the channels share, well above the horizon.
const NOISE: f64 = 0.025;
/// Relative standard deviation of each channel's own noise, well above the horizon.
const CHANNEL_NOISE: f64 = 0.008;
/// Factor on the noise at the horizon.
const NOISE_AT_HORIZON: f64 = 4.0;
/// Smallest cosine at which f_r is evaluated: cells that the horizon cuts through have finite values.
const SMALLEST_COSINE: f64 = 0.02;
/// Smaller cosine below which cells are gaps, give or take [`RAGGED`]. The validity of the MERL files begins 3.5° below
/// the horizon; 21 % of their cells are invalid.
const GAP: f64 = -0.061;
/// Largest deviation of the gap's edge, as a cosine, by row and again by cell: some cells above the horizon are lost.
const RAGGED: f64 = 0.045;

pub fn measure(sample: &SyntheticMaterial) -> Table {
    let grid = Grid::FOLDED;
    let mut cells = vec![[-1.0_f32; 3]; grid.len()];
    let bins = grid.phi_d_bins();
    for (row, cells) in cells.chunks_exact_mut(bins).enumerate() {
        let (h, d, _) = grid.bins(row * bins);
        let center = grid.center(h, d, 0);
        let lobes: Vec<Rgb> = sample
            .lobes
            .iter()
            .map(|(share, lobe)| {
                let f_r = lobe.of_angles(center.theta_h, center.theta_d);
                f_r.map(|f_r| share * f_r)
            })
            .collect();
        let (sin_h, cos_h) = center.theta_h.sin_cos();
        let (sin_d, cos_d) = center.theta_d.sin_cos();
        let row_edge = GAP + RAGGED * signed(hash(sample.seed ^ 0xed9e, row as u64));
        // Isotropic materials are even in φ_d about 90°: one half serves for both.
        for phi in 0..bins / 2 {
            let across = sin_h * sin_d * grid.center(h, d, phi).phi_d.cos();
            let (cos_theta_i, cos_theta_o) = (cos_h * cos_d - across, cos_h * cos_d + across);
            let mut f_r = None;
            for phi in [phi, bins - 1 - phi] {
                let noise = Noise::new(sample.seed, (row * bins + phi) as u64);
                let lower = cos_theta_i.min(cos_theta_o);
                if lower < row_edge + RAGGED * noise.edge {
                    continue;
                }
                let f_r = *f_r.get_or_insert_with(|| {
                    exact(
                        sample,
                        &lobes,
                        cos_theta_i.max(SMALLEST_COSINE),
                        cos_theta_o.max(SMALLEST_COSINE),
                    )
                });
                cells[phi] = noise.apply(f_r, lower.max(0.0));
            }
        }
    }
    Table::new(grid, cells)
}

/// f_r in 1/sr before noise, linear RGB.
fn exact(sample: &SyntheticMaterial, lobes: &[Rgb], cos_theta_i: f64, cos_theta_o: f64) -> Rgb {
    let diffuse_ground = diffuse_ground(sample.coat, cos_theta_i, cos_theta_o);
    let mut f_r = sample.albedo.map(|albedo| albedo * diffuse_ground);
    for ((_, lobe), of_angles) in sample.lobes.iter().zip(lobes) {
        let of_cosines = lobe.of_cosines(cos_theta_i, cos_theta_o);
        for (f_r, of_angles) in f_r.iter_mut().zip(of_angles) {
            *f_r += of_angles * of_cosines;
        }
    }
    f_r
}

/// Random numbers of one cell.
struct Noise {
    shared: f64,
    own: Rgb,
    /// Deviation of the gap's edge in units of [`RAGGED`], in [−1, 1].
    edge: f64,
}

impl Noise {
    fn new(seed: u64, cell: u64) -> Self {
        let first = hash(seed, 2 * cell);
        let second = hash(seed, 2 * cell + 1);
        Self {
            shared: bell(first),
            own: std::array::from_fn(|k| 1.7 * signed(second << (16 * k))),
            edge: signed(second << 48),
        }
    }

    /// f_r with noise. The noise multiplies and is bounded, so that nothing becomes negative.
    fn apply(&self, f_r: Rgb, lower_cosine: f64) -> [f32; 3] {
        let grazing = (1.0 - lower_cosine).powi(8);
        let amount = 1.0 + (NOISE_AT_HORIZON - 1.0) * grazing;
        std::array::from_fn(|k| {
            let noise = NOISE * self.shared + CHANNEL_NOISE * self.own[k];
            (f_r[k] * (1.0 + amount * noise)) as f32
        })
    }
}

/// Pseudo-random bits: SplitMix64 [Steele14] at a position of its sequence.
fn hash(seed: u64, place: u64) -> u64 {
    const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut x = seed
        .wrapping_mul(0xd134_2543_de82_ef95)
        .wrapping_add(place.wrapping_add(1).wrapping_mul(STEP));
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

/// Upper 16 bits as a number in [−1, 1].
fn signed(bits: u64) -> f64 {
    (bits >> 48) as f64 / 32_767.5 - 1.0
}

/// Approximately standard normal number, within ±3.5: the sum of four uniform ones.
fn bell(bits: u64) -> f64 {
    let sum: f64 = (0..4).map(|k| signed(bits << (16 * k))).sum();
    sum * 0.75_f64.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_noise_is_centred_and_as_large_as_it_says() {
        let count = 100_000;
        let moments = |f: &dyn Fn(&Noise) -> f64| {
            let values: Vec<f64> = (0..count).map(|cell| f(&Noise::new(7, cell))).collect();
            let mean = values.iter().sum::<f64>() / count as f64;
            let square = values.iter().map(|x| x * x).sum::<f64>() / count as f64;
            (mean, square.sqrt())
        };
        for of in [
            &(|n: &Noise| n.shared) as &dyn Fn(&Noise) -> f64,
            &|n: &Noise| n.own[0],
            &|n: &Noise| n.own[2],
        ] {
            let (mean, deviation) = moments(of);
            assert!(mean.abs() < 0.02, "{mean}");
            assert!((deviation - 1.0).abs() < 0.03, "{deviation}");
        }
    }
}
