//! Lines of equal value over a grid, by marching squares: straight within a cell, joined from cell to cell.

use std::collections::BTreeMap;

/// An edge of the grid between neighbouring nodes: column, row, and whether it goes up instead of to the right.
type Edge = (usize, usize, bool);

/// The lines at a level. `values` are those of the nodes, row by row; closed lines end where they begin.
///
/// Empty for a grid of less than two by two nodes, or with other than one value per node.
pub fn contours(x: &[f64], y: &[f64], values: &[f64], level: f64) -> Vec<Vec<[f64; 2]>> {
    let (columns, rows) = (x.len(), y.len());
    if columns < 2 || rows < 2 || values.len() != columns * rows {
        return Vec::new();
    }
    let value = |i: usize, j: usize| values[i + columns * j];
    let mut links: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for j in 0..rows - 1 {
        for i in 0..columns - 1 {
            let corners = [
                value(i, j),
                value(i + 1, j),
                value(i + 1, j + 1),
                value(i, j + 1),
            ];
            if corners.iter().any(|value| !value.is_finite()) {
                continue;
            }
            for (a, b) in pieces(corners, level, (i, j)) {
                links.entry(a).or_default().push(b);
                links.entry(b).or_default().push(a);
            }
        }
    }
    let at = |edge: &Edge| {
        let (i, j, up) = *edge;
        let (next_i, next_j) = if up { (i, j + 1) } else { (i + 1, j) };
        let (from, to) = (value(i, j), value(next_i, next_j));
        let t = ((level - from) / (to - from)).clamp(0.0, 1.0);
        [x[i] + t * (x[next_i] - x[i]), y[j] + t * (y[next_j] - y[j])]
    };
    let mut lines = Vec::new();
    // Open lines first, from an end; what is left are loops.
    let ends: Vec<Edge> = links
        .iter()
        .filter(|(_, next)| next.len() == 1)
        .map(|(edge, _)| *edge)
        .collect();
    let all: Vec<Edge> = links.keys().copied().collect();
    for start in ends.into_iter().chain(all) {
        let line = walk(&mut links, start);
        if line.len() > 1 {
            lines.push(line.iter().map(at).collect());
        }
    }
    lines
}

/// The pieces of a line within a cell whose corners go around it from the lower left: pairs of its edges.
fn pieces(corners: [f64; 4], level: f64, (i, j): (usize, usize)) -> Vec<(Edge, Edge)> {
    let (below, right, above, left) = (
        (i, j, false),
        (i + 1, j, true),
        (i, j + 1, false),
        (i, j, true),
    );
    let high = corners.map(|value| value > level);
    let edges = [below, right, above, left];
    // An edge is crossed where its two corners differ.
    let crossed: Vec<Edge> = (0..4)
        .filter(|k| high[*k] != high[(k + 1) % 4])
        .map(|k| edges[k])
        .collect();
    match crossed[..] {
        [a, b] => vec![(a, b)],
        [_, _, _, _] => {
            // A saddle: the middle says which corners hang together.
            let middle = corners.iter().sum::<f64>() / 4.0 > level;
            if middle == high[0] {
                vec![(below, right), (above, left)]
            } else {
                vec![(left, below), (right, above)]
            }
        }
        _ => Vec::new(),
    }
}

/// Follows the links from an edge and takes them away.
fn walk(links: &mut BTreeMap<Edge, Vec<Edge>>, start: Edge) -> Vec<Edge> {
    let mut line = vec![start];
    let mut here = start;
    while let Some(next) = links.get_mut(&here).and_then(Vec::pop) {
        if let Some(back) = links.get_mut(&next)
            && let Some(at) = back.iter().position(|edge| *edge == here)
        {
            back.swap_remove(at);
        }
        line.push(next);
        here = next;
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(f: impl Fn(f64, f64) -> f64) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let x: Vec<f64> = (0..=40).map(|k| f64::from(k) / 20.0 - 1.0).collect();
        let y = x.clone();
        let values = y.iter().flat_map(|y| x.iter().map(|x| f(*x, *y))).collect();
        (x, y, values)
    }

    /// The largest distance from the wanted value along the lines.
    fn off(lines: &[Vec<[f64; 2]>], f: impl Fn([f64; 2]) -> f64, wanted: f64) -> f64 {
        let points = lines.iter().flatten();
        points.map(|p| (f(*p) - wanted).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn a_circle_is_one_closed_line() {
        let (x, y, values) = grid(|x, y| x.hypot(y));
        let lines = contours(&x, &y, &values, 0.6);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        assert!(off(&lines, |[x, y]| x.hypot(y), 0.6) < 2e-3);
        let length: f64 = lines[0]
            .windows(2)
            .map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]))
            .sum();
        assert!((length / (2.0 * std::f64::consts::PI * 0.6) - 1.0).abs() < 2e-3);
        // Planted: the axes swapped of something that is not round.
        let (x, y, values) = grid(|x, y| x.hypot(2.0 * y));
        let lines = contours(&x, &y, &values, 0.6);
        assert!(off(&lines, |[x, y]| x.hypot(2.0 * y), 0.6) < 4e-3);
        assert!(off(&lines, |[x, y]| y.hypot(2.0 * x), 0.6) > 0.1);
    }

    #[test]
    fn lines_end_at_the_border_and_saddles_part() {
        let (x, y, values) = grid(|x, y| x + 0.3 * y);
        let lines = contours(&x, &y, &values, 0.11);
        assert_eq!(lines.len(), 1);
        assert_ne!(lines[0].first(), lines[0].last());
        assert!(off(&lines, |[x, y]| x + 0.3 * y, 0.11) < 1e-12);
        let (x, y, values) = grid(|x, y| x * y);
        for level in [-0.05, 0.05] {
            assert_eq!(contours(&x, &y, &values, level).len(), 2);
        }
        assert_eq!(contours(&x, &y, &values, 3.0).len(), 0);
        assert_eq!(contours(&x[..1], &y, &values, 0.0).len(), 0);
    }
}
