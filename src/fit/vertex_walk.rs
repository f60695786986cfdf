//! Exact minimum of an L1 regression with two amplitudes.
//!
//! Σ w |a + b x − f| + la·a + lb·b is linear between the lines a + b x = f, so that a minimum is where two of them, or
//! one and a bound, cross. From a point nearby the walk goes along such lines, each time to the lowest point of the
//! line: a weighted median. Where no line through the point leads down, by convexity it is the minimum.

/// Observation of the regression: a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observation {
    /// Specular shape R_F · lobe, the factor of b.
    pub x: f64,
    /// Measured f_r, in the unit of the cells.
    pub f: f64,
    /// Weight w, > 0.
    pub w: f64,
}

/// Sum to be minimised, over (a, b) within bounds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct L1Sum {
    /// Cells whose residual may change its sign.
    pub cells: Vec<Observation>,
    /// Slopes in a and b of all other cells.
    pub linear: [f64; 2],
    /// Bounds of a and b, (smallest, largest).
    pub bounds: [(f64, f64); 2],
}

/// Largest number of steps; a walk from a point nearby takes about ten.
const STEPS: usize = 500;
/// Largest number of lines through a point that are followed.
const MOST_LINES: usize = 64;

impl L1Sum {
    /// Value at (a, b), up to a constant of the cells that are not listed.
    pub fn value(&self, [a, b]: [f64; 2]) -> f64 {
        let cells = self
            .cells
            .iter()
            .map(|cell| cell.w * (a + b * cell.x - cell.f).abs());
        cells.sum::<f64>() + self.linear[0] * a + self.linear[1] * b
    }

    /// The (a, b) within the bounds that minimises the sum, walking from `start`.
    pub fn minimise(&self, start: [f64; 2]) -> [f64; 2] {
        let mut at = std::array::from_fn(|k| start[k].clamp(self.bounds[k].0, self.bounds[k].1));
        let mut value = self.value(at);
        // On to a line first, by moving a alone, then b alone.
        for direction in [[1.0, 0.0], [0.0, 1.0]] {
            (at, value) = self.best_along(at, value, direction);
        }
        for _ in 0..STEPS {
            let before = value;
            for direction in self.directions(at) {
                (at, value) = self.best_along(at, value, direction);
                if value < before {
                    break;
                }
            }
            if value >= before {
                break;
            }
        }
        at
    }

    /// Directions of the lines through a point, and of both axes.
    fn directions(&self, [a, b]: [f64; 2]) -> Vec<[f64; 2]> {
        let mut found: Vec<[f64; 2]> = self
            .cells
            .iter()
            .filter(|cell| {
                let size = a.abs() + (b * cell.x).abs() + cell.f.abs();
                (a + b * cell.x - cell.f).abs() <= 1e-11 * size
            })
            .map(|cell| [-cell.x, 1.0])
            .collect();
        found.push([1.0, 0.0]);
        found.push([0.0, 1.0]);
        // Cells with the same x share a line.
        found.sort_by(|p, q| p[0].total_cmp(&q[0]));
        found.dedup();
        // More than a few lines through one point mean that the model meets the data, and nothing is left to gain.
        found.truncate(MOST_LINES);
        found
    }

    /// Lowest point of the line through `at` with its value, if it is lower; else `at` and `value`.
    fn best_along(&self, at: [f64; 2], value: f64, direction: [f64; 2]) -> ([f64; 2], f64) {
        let Some(t) = self.lowest_along(at, direction) else {
            return (at, value);
        };
        let to = std::array::from_fn(|k| {
            (at[k] + t * direction[k]).clamp(self.bounds[k].0, self.bounds[k].1)
        });
        let there = self.value(to);
        if there < value {
            (to, there)
        } else {
            (at, value)
        }
    }

    /// Parameter t of the lowest point along the direction, where the slope changes its sign.
    fn lowest_along(&self, [a, b]: [f64; 2], direction: [f64; 2]) -> Option<f64> {
        let mut slope = self.linear[0] * direction[0] + self.linear[1] * direction[1];
        let mut kinks = Vec::with_capacity(self.cells.len());
        for cell in &self.cells {
            let rate = direction[0] + direction[1] * cell.x;
            let weight = cell.w * rate.abs();
            if weight > 0.0 {
                kinks.push(((cell.f - a - b * cell.x) / rate, weight));
                slope -= weight;
            }
        }
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for k in 0..2 {
            if direction[k] != 0.0 {
                let ends = [self.bounds[k].0, self.bounds[k].1]
                    .map(|end| (end - [a, b][k]) / direction[k]);
                low = low.max(ends[0].min(ends[1]));
                high = high.min(ends[0].max(ends[1]));
            }
        }
        let lowest = if slope >= 0.0 {
            low
        } else {
            first_upward_kink(&mut kinks, slope).unwrap_or(high)
        };
        (low <= high)
            .then(|| lowest.clamp(low, high))
            .filter(|t| t.is_finite())
    }
}

/// Position of the first kink at which a slope below 0 reaches 0: it grows by twice the weight of each.
fn first_upward_kink(mut kinks: &mut [(f64, f64)], mut slope: f64) -> Option<f64> {
    // Halves rather than all in order: one of them is done with each time.
    while kinks.len() > 1 {
        let middle = (kinks.len() - 1) / 2;
        kinks.select_nth_unstable_by(middle, |p, q| p.0.total_cmp(&q.0));
        let (first, rest) = kinks.split_at_mut(middle + 1);
        let after = slope + 2.0 * first.iter().map(|kink| kink.1).sum::<f64>();
        if after >= 0.0 {
            kinks = first;
        } else {
            slope = after;
            kinks = rest;
        }
    }
    let (place, weight) = *kinks.first()?;
    (slope + 2.0 * weight >= 0.0).then_some(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Generator of numbers in [0, 1) from a counter [Steele14].
    fn random(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    /// Smallest value over every crossing of two lines, of a line and a bound, and of two bounds.
    fn brute_force(sum: &L1Sum) -> f64 {
        let within =
            |k: usize, v: f64| v >= sum.bounds[k].0 - 1e-12 && v <= sum.bounds[k].1 + 1e-12;
        let mut points = Vec::new();
        for (i, p) in sum.cells.iter().enumerate() {
            for q in &sum.cells[..i] {
                if p.x != q.x {
                    let b = (p.f - q.f) / (p.x - q.x);
                    points.push([p.f - b * p.x, b]);
                }
            }
            for b in [sum.bounds[1].0, sum.bounds[1].1] {
                points.push([p.f - b * p.x, b]);
            }
            for a in [sum.bounds[0].0, sum.bounds[0].1] {
                if p.x != 0.0 {
                    points.push([a, (p.f - a) / p.x]);
                }
            }
        }
        for a in [sum.bounds[0].0, sum.bounds[0].1] {
            points.extend([sum.bounds[1].0, sum.bounds[1].1].map(|b| [a, b]));
        }
        points
            .into_iter()
            .filter(|p| within(0, p[0]) && within(1, p[1]))
            .map(|p| sum.value(p))
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn the_walk_ends_where_brute_force_does() {
        for seed in 0..400 {
            let mut unit = random(seed);
            let count = 1 + (40.0 * unit()) as usize;
            // Coarse numbers in half of the cases, so that many lines meet in a point.
            let steps = if seed % 2 == 0 { 4.0 } else { 1e9 };
            let mut coarse = |scale: f64| (unit() * steps).floor() / steps * scale;
            let cells = (0..count)
                .map(|_| Observation {
                    x: coarse(1.0).powi(2),
                    f: coarse(2.0),
                    w: 0.1 + coarse(1.0),
                })
                .collect();
            let sum = L1Sum {
                cells,
                linear: [0.2 * coarse(1.0), 0.1 - 0.2 * coarse(1.0)],
                bounds: [(0.0, 10.0), (0.25 * coarse(1.0), 50.0)],
            };
            let found = sum.minimise([3.0 * coarse(1.0), coarse(1.0)]);
            let (value, best) = (sum.value(found), brute_force(&sum));
            assert!(
                value <= best + 1e-12 * (1.0 + best.abs()),
                "seed {seed}: {value} {best}"
            );
            // A planted error: a little off it is worse, or as good where the minimum is flat.
            let off = [found[0] + 1e-3, found[1] + 1e-3];
            assert!(sum.value(off) >= best - 1e-12);
        }
    }
}
