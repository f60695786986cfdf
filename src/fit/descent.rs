//! Quasi-Newton descent in up to three variables within bounds.
//!
//! BFGS with a line search for the weak Wolfe conditions, which also copes with the kinks of L1 [Lewis13].

use glam::{DMat3, DVec3};

/// Value and gradient of the objective at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// Error to be minimised.
    pub error: f64,
    /// Gradient of the error.
    pub gradient: DVec3,
}

/// Bounds and stopping rules of a descent.
#[derive(Clone, Copy, Debug)]
pub struct Rules {
    /// Bounds of each variable, (smallest, largest); both alike where it is held.
    pub bounds: [(f64, f64); 3],
    /// Relative decrease of the error that a step must promise for the descent to go on.
    pub tolerance: f64,
    /// Largest number of evaluations.
    pub evaluations: usize,
    /// Length of the first step, in units of the variables.
    pub first_step: f64,
}

/// Result of a descent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Point with the smallest error.
    pub at: DVec3,
    /// Error and gradient at that point.
    pub value: Value,
    /// Approximate Hessian at the end, a start for a descent on more data; `None` where none was built up.
    pub curvature: Option<DMat3>,
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
    start: DVec3,
    curvature: Option<DMat3>,
    rules: &Rules,
    evaluate: &mut dyn FnMut(DVec3) -> Option<Value>,
) -> Option<End> {
    let low = DVec3::from_array(rules.bounds.map(|b| b.0));
    let high = DVec3::from_array(rules.bounds.map(|b| b.1));
    let mut at = start.clamp(low, high);
    let mut value = evaluate(at)?;
    let mut left = rules.evaluations.saturating_sub(1);
    let mut b = curvature;
    let mut converged = false;
    let mut idle = 0;
    loop {
        let free = free_variables(at, value.gradient, low, high);
        let g = value.gradient * free;
        // Without a curvature yet: steepest descent, not longer than the first step, and not past a minimum that is
        // as sharp as errors commonly have it.
        let scaled = || {
            DMat3::from_diagonal(DVec3::splat(
                g.length() / rules.first_step + COMMON_CURVATURE * value.error,
            ))
        };
        let step = newton_step(b.unwrap_or_else(scaled), g, free);
        let promise = -0.5 * g.dot(step);
        if promise.is_nan() || promise <= rules.tolerance * value.error {
            converged = true;
            break;
        }
        let least = rules.tolerance * value.error;
        let Some((t, next)) = line_search(at, value, step, least, (low, high), &mut left, evaluate)
        else {
            // No step is better: the promise came from a curvature that is wrong, or a kink ends here.
            if b.take().is_none() || promise <= RETRY * value.error || left == 0 {
                converged = left > 0;
                break;
            }
            continue;
        };
        let moved = (at + t * step).clamp(low, high) - at;
        b = Some(updated(b, moved, next.gradient - value.gradient));
        let gain = value.error - next.error;
        at += moved;
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

/// Mask of the variables: 1 where free, 0 where a bound holds the variable against the slope.
fn free_variables(at: DVec3, gradient: DVec3, low: DVec3, high: DVec3) -> DVec3 {
    let free = |k: usize| {
        let held =
            (at[k] <= low[k] && gradient[k] >= 0.0) || (at[k] >= high[k] && gradient[k] <= 0.0);
        f64::from(!held)
    };
    DVec3::new(free(0), free(1), free(2))
}

/// Step −B⁻¹ g in the free variables; −g where that is not finite or not a descent.
fn newton_step(mut b: DMat3, g: DVec3, free: DVec3) -> DVec3 {
    for k in 0..3 {
        if free[k] == 0.0 {
            for other in 0..3 {
                b.col_mut(k)[other] = 0.0;
                b.col_mut(other)[k] = 0.0;
            }
            b.col_mut(k)[k] = 1.0;
        }
    }
    let step = -(b.inverse() * g) * free;
    if step.is_finite() && step.dot(g) < 0.0 {
        step
    } else {
        -g
    }
}

/// Step length and value, by parabola and bisection; `None` where no length lowers the error.
fn line_search(
    at: DVec3,
    value: Value,
    step: DVec3,
    least: f64,
    (low, high): (DVec3, DVec3),
    left: &mut usize,
    evaluate: &mut dyn FnMut(DVec3) -> Option<Value>,
) -> Option<(f64, Value)> {
    let slope = value.gradient.dot(step);
    let (mut near, mut far) = (0.0, f64::INFINITY);
    let mut t = 1.0;
    let mut best: Option<(f64, Value)> = None;
    for _ in 0..LINE_SEARCH.min(*left) {
        if -t * slope < least {
            // So short a step cannot gain what counts.
            break;
        }
        let to = (at + t * step).clamp(low, high);
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
        } else if found.gradient.dot(step) < WOLFE * slope
            && to != (at + 2.0 * t * step).clamp(low, high)
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
fn updated(b: Option<DMat3>, moved: DVec3, turned: DVec3) -> DMat3 {
    let sy = moved.dot(turned);
    let b = b.unwrap_or_else(|| {
        let scale = if sy > 0.0 {
            turned.length_squared() / sy
        } else {
            turned.length() / moved.length().max(1e-12)
        };
        DMat3::from_diagonal(DVec3::splat(scale.max(1e-12)))
    });
    let bs = b * moved;
    let sbs = moved.dot(bs);
    if sy <= 1e-10 * moved.length() * turned.length() || sbs <= 0.0 {
        return b;
    }
    let outer = |v: DVec3| DMat3::from_cols(v * v.x, v * v.y, v * v.z);
    b + outer(turned) * (1.0 / sy) - outer(bs) * (1.0 / sbs)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(start: [f64; 3], bounds: [(f64, f64); 3], f: impl Fn(DVec3) -> f64) -> (DVec3, usize) {
        let mut count = 0;
        let rules = Rules {
            bounds,
            tolerance: 1e-12,
            evaluations: 400,
            first_step: 0.1,
        };
        let end = descend(DVec3::from_array(start), None, &rules, &mut |p| {
            count += 1;
            let slope = |k: usize| {
                let mut step = DVec3::ZERO;
                step[k] = 1e-6;
                (f(p + step) - f(p - step)) / 2e-6
            };
            Some(Value {
                error: f(p),
                gradient: DVec3::new(slope(0), slope(1), slope(2)),
            })
        });
        (end.expect("is not stopped").at, count)
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
            bounds: WIDE,
            tolerance: 1e-12,
            evaluations: 100,
            first_step: 0.1,
        };
        let mut count = 0;
        let end = descend(DVec3::ZERO, None, &rules, &mut |p| {
            count += 1;
            (count < 4).then(|| Value {
                error: 1.0 + (p.x - 3.0).powi(2),
                gradient: DVec3::new(2.0 * (p.x - 3.0), 0.0, 0.0),
            })
        })
        .expect("there is a first value");
        assert!(end.value.error < 10.0 && !end.converged);
    }
}
