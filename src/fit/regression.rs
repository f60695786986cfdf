//! L1 regression of stage 1: for a fixed shape x = R_F · lobe the best a = ρ_d/π and b = k_s per channel.
//!
//! Σ w |a + b x − f| is convex in (a, b). Newton steps on the sum with its kinks rounded off within a band come near in
//! a few passes [Madsen93]; steps on a quadratic majorant are the fallback where one goes too far.
//! [`super::vertex_walk`] then goes to the exact minimum.

use super::amplitudes::{AmplitudeBounds, Amplitudes};
use super::kernels::{self, ChannelSums};
use super::symmetric_cells::SymmetricCells;
use super::threads::Threads;

/// Stopping rules and bands of the regression.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Promised relative decrease of the error below which a step is the last.
    pub tolerance: f64,
    /// Largest number of passes.
    pub passes: usize,
    /// Initial half width of the band, relative to the model.
    pub band: f64,
    /// Final half width of the band, as a share of the relative error: well within the residuals.
    pub narrow: f64,
}

impl Effort {
    /// Effort from a start without information.
    pub const COLD: Self = Self {
        tolerance: 1e-3,
        passes: 12,
        band: 2.0,
        narrow: 0.2,
    };
    /// Effort from the solution of a similar shape.
    pub const WARM: Self = Self {
        tolerance: 3e-4,
        passes: 6,
        band: 0.02,
        narrow: 0.05,
    };
    /// Effort after which [`super::exact_l1`] has little left to do.
    pub const CLOSE: Self = Self {
        tolerance: 1e-7,
        passes: 16,
        band: 0.1,
        narrow: 0.03,
    };

    /// Effort near a solution with this error: no wider a band, from the first pass on, than that needs.
    pub fn near_error(self, error: f64) -> Self {
        let band = (self.narrow * error).max(0.1 * self.band).min(self.band);
        Self { band, ..self }
    }
}

/// Narrowest final band, for data that a model meets exactly.
const NARROWEST: f64 = 1e-6;
const WIDEST: f64 = 0.03;
/// Factor on the final band that is narrow enough, as the final band changes a little with the error.
const NARROW_ENOUGH: f64 = 1.5;
/// Share of the majorant that is added to the curvature, which few residuals within the band may leave too small.
const SAFEGUARD: f64 = 0.02;

/// Start without information: the mean as diffuse, hardly any highlight of a shape of this height.
pub fn cold(cells: &SymmetricCells, limits: &AmplitudeBounds, height: f64) -> Amplitudes {
    limits.clamp(Amplitudes {
        diffuse: cells.energy.map(|share| 2.0 * share),
        specular: cells.energy.map(|share| 1e-3 * share / height),
    })
}

/// State of one channel's regression.
struct Descent {
    at: [f64; 2],
    best: [f64; 2],
    sums: ChannelSums,
    band: f64,
    use_majorant: bool,
    done: bool,
}

/// Amplitudes that minimise the error, near enough for [`Effort::tolerance`], and the error per channel.
pub fn solve(
    cells: &SymmetricCells,
    shapes: &[f32],
    start: &Amplitudes,
    limits: &AmplitudeBounds,
    effort: Effort,
    threads: Threads,
) -> (Amplitudes, [f64; 3]) {
    let start = limits.clamp(*start);
    let mut channels: [Descent; 3] = std::array::from_fn(|k| Descent {
        at: [start.diffuse[k], start.specular[k]],
        best: [start.diffuse[k], start.specular[k]],
        sums: ChannelSums {
            error: f64::INFINITY,
            ..ChannelSums::default()
        },
        band: effort.band,
        use_majorant: false,
        // A black channel has nothing to say.
        done: cells.energy[k] <= 0.0,
    });
    for _ in 0..effort.passes {
        let at = amplitudes(|k| channels[k].at);
        let bands = std::array::from_fn(|k| channels[k].band);
        let floor = std::array::from_fn(|k| (3e-3 * cells.energy[k] * bands[k]).max(1e-25));
        let wanted = std::array::from_fn(|k| !channels[k].done);
        let sums = kernels::regression(cells, shapes, &at, bands, floor, wanted, threads);
        for (k, channel) in channels.iter_mut().enumerate() {
            if !channel.done {
                channel.update(&sums[k], &limits.of(k), effort, cells.energy[k]);
            }
        }
        if channels.iter().all(|channel| channel.done) {
            break;
        }
    }
    let errors = std::array::from_fn(|k| match channels[k].sums.error {
        error if error.is_finite() => error,
        _ => 0.0,
    });
    (amplitudes(|k| channels[k].best), errors)
}

fn amplitudes(of: impl Fn(usize) -> [f64; 2]) -> Amplitudes {
    Amplitudes {
        diffuse: std::array::from_fn(|k| of(k)[0]),
        specular: std::array::from_fn(|k| of(k)[1]),
    }
}

impl Descent {
    /// Takes the sums at `at` and sets the next point, or `done`.
    fn update(&mut self, sums: &ChannelSums, bounds: &[(f64, f64); 2], effort: Effort, share: f64) {
        let tolerance = effort.tolerance;
        let narrow =
            (effort.narrow * self.sums.error.min(sums.error) / share).clamp(NARROWEST, WIDEST);
        if sums.error <= self.sums.error {
            self.best = self.at;
            self.sums = *sums;
            self.use_majorant = false;
        } else if !self.use_majorant {
            self.use_majorant = true;
        } else if self.band > narrow {
            // The rounded sum has its minimum here, the true one not yet: look again with less rounding.
            self.band = (0.2 * self.band).max(narrow);
            self.at = self.best;
            self.use_majorant = false;
            return;
        } else {
            // Even the parabola finds nothing better: what is left is rounding.
            self.done = true;
        }
        let ChannelSums {
            slope,
            curvature,
            majorant,
            error,
        } = self.sums;
        let matrix = match self.use_majorant {
            true => majorant,
            false => std::array::from_fn(|k| curvature[k] + SAFEGUARD * majorant[k]),
        };
        let step = step_within(slope, matrix, self.best, bounds);
        let gain = -value(slope, matrix, step);
        let fits_exactly = error <= 1e-8 * share || !gain.is_finite();
        self.at = [self.best[0] + step[0], self.best[1] + step[1]];
        for (x, (low, high)) in self.at.iter_mut().zip(bounds) {
            *x = x.clamp(*low, *high);
        }
        if fits_exactly {
            self.done = true;
        } else if !self.done && gain <= tolerance * error && self.band <= NARROW_ENOUGH * narrow {
            // So short a step needs no look at where it leads.
            self.best = self.at;
            self.done = true;
        }
        if gain <= 0.1 * error {
            self.band = (0.2 * self.band).max(narrow);
        }
    }
}

/// Value of the quadratic form g·p + ½ p·M p; M is (aa, ab, bb).
fn value(g: [f64; 2], m: [f64; 3], p: [f64; 2]) -> f64 {
    g[0] * p[0] + g[1] * p[1] + 0.5 * (m[0] * p[0] * p[0] + m[2] * p[1] * p[1]) + m[1] * p[0] * p[1]
}

/// Step p that minimises g·p + ½ p·M p with `at` + p within the bounds. M is positive semidefinite.
fn step_within(g: [f64; 2], m: [f64; 3], at: [f64; 2], bounds: &[(f64, f64); 2]) -> [f64; 2] {
    let room = |k: usize| (bounds[k].0 - at[k], bounds[k].1 - at[k]);
    let inside = |p: [f64; 2]| (0..2).all(|k| p[k] >= room(k).0 && p[k] <= room(k).1);
    let determinant = m[0] * m[2] - m[1] * m[1];
    if determinant > 1e-12 * m[0] * m[2] {
        let p = [
            (m[1] * g[1] - m[2] * g[0]) / determinant,
            (m[1] * g[0] - m[0] * g[1]) / determinant,
        ];
        if inside(p) {
            return p;
        }
    }
    // The minimum is on an edge: one of the two at a bound or, where M tells them not apart, where it is.
    let mut best = [0.0; 2];
    for fixed in 0..2 {
        let other = 1 - fixed;
        let (low, high) = room(fixed);
        for shift in [low, 0.0, high] {
            let mut p = [0.0; 2];
            p[fixed] = shift;
            let slope = g[other] + m[1] * shift;
            let curvature = m[2 * other];
            if curvature > 0.0 {
                p[other] = (-slope / curvature).clamp(room(other).0, room(other).1);
            }
            if p[0].is_finite() && p[1].is_finite() && value(g, m, p) < value(g, m, best) {
                best = p;
            }
        }
    }
    best
}
