//! Vectors and matrices of the search's few variables.

use super::variables::VARIABLES;
use std::array::from_fn;

/// A number per variable.
pub type Vector = [f64; VARIABLES];

/// A symmetric matrix over the variables.
pub type Matrix = [Vector; VARIABLES];

/// a · b
pub fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// |a|
pub fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The identity times a number.
pub fn diagonal(value: f64) -> Matrix {
    from_fn(|row| from_fn(|column| if row == column { value } else { 0.0 }))
}

/// M a
pub fn product(m: &Matrix, a: Vector) -> Vector {
    m.map(|row| dot(row, a))
}

/// Adds factor · a aᵀ.
pub fn add_outer(m: &mut Matrix, a: Vector, factor: f64) {
    for (row, x) in m.iter_mut().zip(a) {
        for (entry, y) in row.iter_mut().zip(a) {
            *entry += factor * x * y;
        }
    }
}

/// Solution of M x = b by elimination with pivots; not finite where M is singular.
pub fn solve(mut m: Matrix, mut b: Vector) -> Vector {
    for k in 0..VARIABLES {
        let size = |row: usize| m[row][k].abs();
        let pivot = (k..VARIABLES).fold(
            k,
            |best, row| if size(row) > size(best) { row } else { best },
        );
        m.swap(k, pivot);
        b.swap(k, pivot);
        let (upper, of_pivot) = (m[k], b[k]);
        for (row, of_row) in m.iter_mut().zip(&mut b).skip(k + 1) {
            let factor = row[k] / upper[k];
            row.iter_mut()
                .zip(upper)
                .for_each(|(to, from)| *to -= factor * from);
            *of_row -= factor * of_pivot;
        }
    }
    let mut x = [0.0; VARIABLES];
    for k in (0..VARIABLES).rev() {
        let known: f64 = (k + 1..VARIABLES)
            .map(|column| m[k][column] * x[column])
            .sum();
        x[k] = (b[k] - known) / m[k][k];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_solved_gives_the_right_side_back() {
        let mut m = diagonal(1.0);
        add_outer(&mut m, [1.0, -2.0, 0.5, 3.0, 0.1], 2.0);
        add_outer(&mut m, [0.0, 1.0, 4.0, -1.0, 2.0], 0.3);
        // A pivot that is 0 is not divided by.
        m[0][0] = 0.0;
        let b = [1.0, 2.0, -3.0, 0.5, 4.0];
        let back = product(&m, solve(m, b));
        assert!(
            (0..VARIABLES).all(|k| (back[k] - b[k]).abs() < 1e-12),
            "{back:?}"
        );
        m[1][2] += 1e-6;
        let other = product(&m, solve(m, b.map(|x| x + 1e-9)));
        assert!(
            (0..VARIABLES).any(|k| (other[k] - b[k]).abs() > 1e-12),
            "a planted error passes"
        );
        assert!(!solve(diagonal(0.0), b)[0].is_finite());
    }
}
