//! Curves as polylines: broken in gaps, cut at the ends of an axis, without points that change nothing.

use super::drawing::Point;

/// Lengths are held to this many lengths of the axis: what has none lies so far off that its lines are upright.
const FAR: f64 = 1e3;

/// The pieces of a curve between gaps and inside [0, 1] of its axis. `samples` are (x, length), ascending in x;
/// `at` says where they are.
pub(super) fn runs(
    samples: impl Iterator<Item = (f64, Option<f64>)>,
    at: impl Fn(f64, f64) -> Point,
) -> Vec<Vec<Point>> {
    let (mut runs, mut run) = (Vec::new(), Vec::new());
    let mut last: Option<(f64, f64)> = None;
    for (x, length) in samples {
        let next = length.map(|length| (x, length.clamp(-FAR, FAR)));
        match (last, next) {
            (_, None) => runs.push(std::mem::take(&mut run)),
            (None, Some(b)) => {
                if inside(b.1) {
                    run.push(at(b.0, b.1));
                }
            }
            (Some(a), Some(b)) => {
                // Where the curve crosses an end of the axis, on it.
                let between = |t: f64| (a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1));
                if let Some([from, to]) = part_inside(a.1, b.1) {
                    if from > 0.0 {
                        runs.push(std::mem::take(&mut run));
                        let (x, length) = between(from);
                        run.push(at(x, length));
                    }
                    let (x, length) = if to < 1.0 { between(to) } else { b };
                    run.push(at(x, length));
                    if to < 1.0 {
                        runs.push(std::mem::take(&mut run));
                    }
                }
            }
        }
        last = next;
    }
    runs.push(run);
    runs.retain(|run| !run.is_empty());
    runs
}

fn inside(length: f64) -> bool {
    (0.0..=1.0).contains(&length)
}

/// The part of the way from `a` to `b` that is inside [0, 1].
fn part_inside(a: f64, b: f64) -> Option<[f64; 2]> {
    if a == b {
        return inside(a).then_some([0.0, 1.0]);
    }
    let (zero, one) = (-a / (b - a), (1.0 - a) / (b - a));
    let from = zero.min(one).max(0.0);
    let to = zero.max(one).min(1.0);
    (from <= to).then_some([from, to])
}

/// Farthest that a thinned curve may be from the samples it leaves out, in points.
const THINNING: f32 = 0.02;

/// Without the points that lie on the line between their neighbours [Douglas and Peucker].
pub(super) fn thinned(points: Vec<Point>) -> Vec<Point> {
    if points.len() < 3 {
        return points;
    }
    let mut kept = vec![false; points.len()];
    let mut spans = vec![(0, points.len() - 1)];
    while let Some((first, last)) = spans.pop() {
        (kept[first], kept[last]) = (true, true);
        let farthest = (first + 1..last)
            .map(|k| (k, off_segment(points[k], points[first], points[last])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((k, off)) = farthest
            && off > THINNING
        {
            spans.extend([(first, k), (k, last)]);
        }
    }
    let mut kept = kept.into_iter();
    let mut points = points;
    points.retain(|_| kept.next().unwrap_or(true));
    points
}

/// Distance of a point from a segment.
pub(super) fn off_segment(p: Point, a: Point, b: Point) -> f32 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let (px, py) = (p[0] - a[0], p[1] - a[1]);
    let length_squared = dx * dx + dy * dy;
    let t = if length_squared > 0.0 {
        ((px * dx + py * dy) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (px - t * dx).hypot(py - t * dy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(lengths: &[Option<f64>]) -> Vec<Vec<Point>> {
        let samples = lengths.iter().enumerate().map(|(k, y)| (k as f64, *y));
        runs(samples, |x, y| [x as f32, y as f32])
    }

    #[test]
    fn curves_break_in_gaps_and_end_on_both_ends_of_the_axis() {
        let gap = pieces(&[Some(0.2), Some(0.4), None, Some(0.6)]);
        assert_eq!(gap, [vec![[0.0, 0.2], [1.0, 0.4]], vec![[3.0, 0.6]]]);
        let over = pieces(&[Some(0.5), Some(1.5), Some(0.5)]);
        assert_eq!(
            over,
            [vec![[0.0, 0.5], [0.5, 1.0]], vec![[1.5, 1.0], [2.0, 0.5]]]
        );
        let through = pieces(&[Some(-1.0), Some(3.0)]);
        assert_eq!(through, [vec![[0.25, 0.0], [0.5, 1.0]]]);
        assert!(pieces(&[Some(-1.0), Some(-2.0), None, Some(2.0)]).is_empty());
        // A zero on a logarithmic axis: straight down next to it.
        let zero = pieces(&[Some(0.5), Some(f64::NEG_INFINITY)]);
        assert!((zero[0][1][0] - 0.0).abs() < 1e-3 && zero[0][1][1].abs() < 1e-6);
    }

    #[test]
    fn what_is_thinned_out_was_on_the_line() {
        let wave: Vec<Point> = (0..=1000)
            .map(|k| k as f32 * 0.3)
            .map(|x| [x, 40.0 * (0.05 * x).sin()])
            .collect();
        let few = thinned(wave.clone());
        assert!(few.len() < 500, "{}", few.len());
        let off = |few: &[Point]| -> f32 {
            let nearest = |p: &Point| {
                let pairs = few.windows(2);
                pairs
                    .map(|pair| off_segment(*p, pair[0], pair[1]))
                    .fold(f32::MAX, f32::min)
            };
            wave.iter().map(nearest).fold(0.0, f32::max)
        };
        assert!(off(&few) <= THINNING);
        let mut wrong = few;
        wrong.remove(5);
        assert!(off(&wrong) > THINNING);
    }
}
