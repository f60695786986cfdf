//! Angles that a tile offers, for what a session says.

/// Angles of incidence that a tile offers at most.
const MOST_ANGLES: usize = 5;

/// Keeps as many angles as a tile offers, each at most `last`, in radians.
pub fn offered(angles: &mut Vec<f64>, last: f64) {
    angles.truncate(MOST_ANGLES);
    for angle in angles {
        *angle = angle.min(last);
    }
}
