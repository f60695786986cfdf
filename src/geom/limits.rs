//! Limits of angles and exposure that several modules share.

/// Largest exposure in stops, of either sign: on the command line, in the window and in sessions.
///
/// The factor 2³⁰ leaves f32 room for f_r and the strength of lights. Sessions kept 10 before and keep these still; figure
/// files are not held to it and are read as ever, up to where 2 to this power is no number.
pub const MAX_EXPOSURE_STOPS: f64 = 30.0;

/// Largest θi that can be set in the window and is kept in a session, in degrees: half a degree above the horizon.
pub const MAX_THETA_I_DEG: f64 = 89.5;
/// Largest θi that can be set, in radians.
pub const MAX_THETA_I: f64 = MAX_THETA_I_DEG * std::f64::consts::PI / 180.0;

/// Smallest θi or θo of the grazing part, in degrees: E is reported for this part alone as well.
pub const GRAZING_THETA_DEG: f64 = 70.0;
/// Smallest θi or θo of the grazing part, in radians.
pub const GRAZING_THETA: f64 = GRAZING_THETA_DEG * std::f64::consts::PI / 180.0;

/// θi or θo in degrees beyond which plots are shaded: measurements are not to be relied on there [Ngan05].
pub const UNRELIABLE_THETA_DEG: f64 = 80.0;
/// θi or θo in radians beyond which plots are shaded.
pub const UNRELIABLE_THETA: f64 = UNRELIABLE_THETA_DEG * std::f64::consts::PI / 180.0;
