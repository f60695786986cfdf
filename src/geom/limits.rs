//! Bounds that several parts of the program keep, each once.

/// Exposure in stops, either way from 0: on the command line, in the window and in sessions.
///
/// The factor 2³⁰ leaves f32 room for f_r and the strength of lights. Sessions kept 10 before and keep these still; figure
/// files are not held to it and are read as ever.
pub const MAX_EXPOSURE_STOPS: f64 = 30.0;

/// Largest θi that can be set in the window and that a session keeps, in degrees: half a degree above the horizon.
pub const MAX_THETA_I_DEG: f64 = 89.5;
/// Largest θi that can be set, in radians.
pub const MAX_THETA_I: f64 = MAX_THETA_I_DEG * std::f64::consts::PI / 180.0;

/// θi or θo from here on is grazing, in degrees: E is reported for this part alone as well.
pub const GRAZING_THETA_DEG: f64 = 70.0;
/// θi or θo from here on is grazing, in radians.
pub const GRAZING_THETA: f64 = GRAZING_THETA_DEG * std::f64::consts::PI / 180.0;

/// θi or θo beyond this is shaded in plots, in degrees: measurements are not to be relied on [Ngan05].
pub const UNRELIABLE_THETA_DEG: f64 = 80.0;
/// θi or θo beyond this is shaded in plots, in radians.
pub const UNRELIABLE_THETA: f64 = UNRELIABLE_THETA_DEG * std::f64::consts::PI / 180.0;
