//! Quasi-Newton descent within bounds.
//!
//! BFGS with a line search for the weak Wolfe conditions, which also copes with the kinks of L1 [Lewis13].

use super::linear::{Matrix, Vector, add_outer, diagonal, dot, length, product, solve};
use super::variables::VARIABLES;
use std::array::from_fn;

/// Value and gradient of the objective at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Error to be minimised.
    pub error: f64,
    /// Gradient of the error.
    pub gradient: Vector,
}

/// Bounds and stopping rules of a descent.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// Bounds of each variable, (smallest, largest); both alike where it is held.
    pub bounds: [(f64, f64); VARIABLES],
    /// Relative decrease of the error that a step must promise for the descent to go on.
    pub tolerance: f64,
    /// Largest number of evaluations.
    pub evaluations: usize,
    /// Length of the first step, in units of the variables.
    pub first_step: f64,
}

impl Rules {
    fn clamp(&self, point: Vector) -> Vector {
        from_fn(|k| point[k].clamp(self.bounds[k].0, self.bounds[k].1))
    }

    /// The point a step away, within the bounds.
    fn moved(&self, at: Vector, t: f64, step: Vector) -> Vector {
        self.clamp(from_fn(|k| at[k] + t * step[k]))
    }
}

/// Result of a descent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Point with the smallest error.
    pub at: Vector,
    /// Error and gradient at that point.
    pub value: Value,
    /// Approximate Hessian at the end, a start for a descent on more data; `None` where none was built up.
    pub curvature: Option<Matrix>,
    /// Whether the descent ended because no step promised a further decrease.
    pub converged: bool,
}

const ARMIJO: f64 = 1e-4;
const WOLFE: f64 = 0.7;
const LINE_SEARCH: usize = 10;
/// Second derivative of the error in a variable of the search, relative to the error.
const COMMON_CURVATURE: f64 = 0.5;
/// Promised relative decrease below which a failed step is not tried again without the Hessian.
const RETRY: f64 = 1e-3;

/// Minimises from `start`. `evaluate` returns `None` to stop: then the best point so far is returned; `None` where the
/// first evaluation stops.
pub fn descend(
    start: Vector,
    curvature: Option<Matrix>,
    rules: &Rules,
    evaluate: &mut dyn FnMut(Vector) -> Option<Value>,
) -> Option<End> {
    let mut at = rules.clamp(start);
    let mut value = evaluate(at)?;
    let mut left = rules.evaluations.saturating_sub(1);
    let mut b = curvature;
    let mut converged = false;
    let mut idle = 0;
    loop {
        let free = free_variables(at, value.gradient, rules);
        let g = from_fn(|k| if free[k] { value.gradient[k] } else { 0.0 });
        // Without a curvature yet: steepest descent, not longer than the first step, and not past a minimum that is
        // as sharp as errors commonly have it.
        let scaled = || diagonal(length(g) / rules.first_step + COMMON_CURVATURE * value.error);
        let step = newton_step(b.unwrap_or_else(scaled), g, free);
        let promise = -0.5 * dot(g, step);
        if promise.is_nan() || promise <= rules.tolerance * value.error {
            converged = true;
            break;
        }
        let least = rules.tolerance * value.error;
        let Some((t, next)) = line_search(at, value, step, least, rules, &mut left, evaluate)
        else {
            // No step is better: the promise came from a curvature that is wrong, or a kink ends here.
            if b.take().is_none() || promise <= RETRY * value.error || left == 0 {
                converged = left > 0;
                break;
            }
            continue;
        };
        let to = rules.moved(at, t, step);
        let difference = |a: Vector, b: Vector| from_fn(|k| a[k] - b[k]);
        let turned = difference(next.gradient, value.gradient);
        b = Some(updated(b, difference(to, at), turned));
        let gain = value.error - next.error;
        at = to;
        value = next;
        idle = if gain <= rules.tolerance * value.error {
            idle + 1
        } else {
            0
        };
        if idle == 2 {
            converged = true;
            break;
        }
        if left == 0 {
            break;
        }
    }
    Some(End {
        at,
        value,
        curvature: b,
        converged,
    })
}

/// Whether each variable is free: it is not where a bound holds it against the slope.
fn free_variables(at: Vector, gradient: Vector, rules: &Rules) -> [bool; VARIABLES] {
    from_fn(|k| {
        let (low, high) = rules.bounds[k];
        !((at[k] <= low && gradient[k] >= 0.0) || (at[k] >= high && gradient[k] <= 0.0))
    })
}

/// Step −B⁻¹ g in the free variables; −g where that is not finite or not a descent. `g` is 0 in the others.
fn newton_step(mut b: Matrix, g: Vector, free: [bool; VARIABLES]) -> Vector {
    // What is not free stands alone.
    for (row, entries) in b.iter_mut().enumerate() {
        for (column, entry) in entries.iter_mut().enumerate() {
            if !(free[row] && free[column]) {
                *entry = f64::from(row == column);
            }
        }
    }
    let step = solve(b, g).map(|x| -x);
    if step.iter().all(|x| x.is_finite()) && dot(step, g) < 0.0 {
        step
    } else {
        g.map(|x| -x)
    }
}

/// Step length and value, by parabola and bisection; `None` where no length lowers the error.
fn line_search(
    at: Vector,
    value: Value,
    step: Vector,
    least: f64,
    rules: &Rules,
    left: &mut usize,
    evaluate: &mut dyn FnMut(Vector) -> Option<Value>,
) -> Option<(f64, Value)> {
    let slope = dot(value.gradient, step);
    let (mut near, mut far) = (0.0, f64::INFINITY);
    let mut t = 1.0;
    let mut best: Option<(f64, Value)> = None;
    for _ in 0..LINE_SEARCH.min(*left) {
        if -t * slope < least {
            // So short a step cannot gain what counts.
            break;
        }
        let to = rules.moved(at, t, step);
        *left -= 1;
        let Some(found) = evaluate(to) else {
            *left = 0;
            break;
        };
        if found.error < value.error && best.is_none_or(|(_, best)| found.error < best.error) {
            best = Some((t, found));
        }
        if found.error > value.error + ARMIJO * t * slope || found.error.is_nan() {
            far = t;
            // The minimum of the parabola through what is known, at most half way.
            let bent = found.error - value.error - t * slope;
            let lowest = -0.5 * slope * t * t / bent;
            if near == 0.0 && lowest.is_finite() {
                t = lowest.clamp(0.05 * t, 0.5 * t);
                continue;
            }
        } else if dot(found.gradient, step) < WOLFE * slope && to != rules.moved(at, 2.0 * t, step)
        {
            near = t;
        } else {
            break;
        }
        t = if far.is_finite() {
            0.5 * (near + far)
        } else {
            2.0 * t
        };
    }
    best
}

/// BFGS update of the approximate Hessian; unchanged where it would not stay positive definite.
fn updated(b: Option<Matrix>, moved: Vector, turned: Vector) -> Matrix {
    let sy = dot(moved, turned);
    let mut b = b.unwrap_or_else(|| {
        let scale = if sy > 0.0 {
            dot(turned, turned) / sy
        } else {
            length(turned) / length(moved).max(1e-12)
        };
        diagonal(scale.max(1e-12))
    });
    let bs = product(&b, moved);
    let sbs = dot(moved, bs);
    if sy <= 1e-10 * length(moved) * length(turned) || sbs <= 0.0 {
        return b;
    }
    add_outer(&mut b, turned, 1.0 / sy);
    add_outer(&mut b, bs, -1.0 / sbs);
    b
}

#[cfg(test)]
mod tests {
    use super::*;

    use glam::DVec3;

    /// The first three variables; the others are held at 0.
    fn three(p: Vector) -> DVec3 {
        DVec3::new(p[0], p[1], p[2])
    }

    fn five<T: Copy>([a, b, c]: [T; 3], rest: T) -> [T; VARIABLES] {
        [a, b, c, rest, rest]
    }

    fn run(start: [f64; 3], bounds: [(f64, f64); 3], f: impl Fn(DVec3) -> f64) -> (DVec3, usize) {
        let bounds = five(bounds, (0.0, 0.0));
        let mut count = 0;
        let rules = Rules {
            bounds,
            tolerance: 1e-12,
            evaluations: 400,
            first_step: 0.1,
        };
        let end = descend(five(start, 0.0), None, &rules, &mut |p| {
            let p = three(p);
            count += 1;
            let slope = |k: usize| {
                let mut step = DVec3::ZERO;
                step[k] = 1e-6;
                (f(p + step) - f(p - step)) / 2e-6
            };
            Some(Value {
                error: f(p),
                gradient: five([slope(0), slope(1), slope(2)], 0.0),
            })
        });
        (three(end.expect("is not stopped").at), count)
    }

    const WIDE: [(f64, f64); 3] = [(-10.0, 10.0); 3];

    #[test]
    fn a_curved_valley_is_followed_to_its_end() {
        let f = |p: DVec3| {
            1.0 + 100.0 * (p.y - p.x * p.x).powi(2) + (1.0 - p.x).powi(2) + (p.z - 2.0).powi(2)
        };
        let (end, count) = run([-1.2, 1.0, 0.0], WIDE, f);
        assert!(
            (end - DVec3::new(1.0, 1.0, 2.0)).length() < 1e-4,
            "{end} after {count}"
        );
    }

    #[test]
    fn kinks_do_not_stop_it() {
        let f = |p: DVec3| {
            1e-9 + (p.x - 1.0).abs() + 3.0 * (p.y + p.x - 2.0).abs() + (p.z - p.x).powi(2)
        };
        let (end, count) = run([4.0, -3.0, 7.0], WIDE, f);
        assert!(f(end) < 1e-3, "{end} after {count}");
    }

    #[test]
    fn bounds_and_held_variables_are_kept() {
        let f = |p: DVec3| 1.0 + (p.x - 3.0).powi(2) + (p.y + p.x).powi(2) + p.z * p.z;
        let (end, _) = run([0.5, 0.0, 0.7], [(0.0, 1.0), (-10.0, 10.0), (0.7, 0.7)], f);
        assert!((end - DVec3::new(1.0, -1.0, 0.7)).length() < 1e-5, "{end}");
    }

    #[test]
    fn stopped_it_returns_the_best_so_far() {
        let rules = Rules {
            bounds: five(WIDE, (0.0, 0.0)),
            tolerance: 1e-12,
            evaluations: 100,
            first_step: 0.1,
        };
        let mut count = 0;
        let end = descend([0.0; VARIABLES], None, &rules, &mut |p| {
            count += 1;
            (count < 4).then(|| Value {
                error: 1.0 + (p[0] - 3.0).powi(2),
                gradient: five([2.0 * (p[0] - 3.0), 0.0, 0.0], 0.0),
            })
        })
        .expect("there is a first value");
        assert!(end.value.error < 10.0 && !end.converged);
    }
}
