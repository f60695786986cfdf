//! The nearest values that can be shown, for what a session says.

use glam::DVec3;

/// Angles of incidence that a tile offers at most.
const MOST_ANGLES: usize = 5;
/// Values in 1/sr on an axis are below this.
const HIGHEST: f64 = 1e12;

/// Brings `angles` to at least one in [0, `last`] radians, at most as many as a tile offers; 60° where there is none.
pub fn angles(angles: &mut Vec<f64>, last: f64) {
    angles.truncate(MOST_ANGLES);
    if angles.is_empty() {
        angles.push(60f64.to_radians());
    }
    for angle in angles {
        *angle = angle.clamp(0.0, last);
    }
}

/// A part of a range of angles; `None` is all of it.
pub fn window(window: Option<[f64; 2]>, [first, last]: [f64; 2]) -> Option<[f64; 2]> {
    let [low, high] = window?;
    // As narrow as the wheel makes it.
    let least = 1e-3 * (last - first) / 90.0;
    let inside = low >= first - 1e-9 && high <= last + 1e-9;
    (inside && high - low >= 0.99 * least).then_some([low, high])
}

/// The ends of an axis of values; `None` where they are none.
pub fn limits(limits: Option<[f64; 2]>) -> Option<[f64; 2]> {
    let [low, high] = limits?;
    let possible = low >= 0.0 && (1e-12..HIGHEST).contains(&high) && high - low > 1e-6 * high;
    possible.then_some([low, high])
}

/// The direction of a vector; `None` where it has none.
pub fn unit(v: DVec3) -> Option<DVec3> {
    match v.length() {
        length if (length - 1.0).abs() < 1e-12 => Some(v),
        length if (1e-6..1e6).contains(&length) => Some(v / length),
        _ => None,
    }
}
