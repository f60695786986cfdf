// Twin of half_diff.rs.

struct HalfDiff {
    theta_h: f32,
    theta_d: f32,
    phi_d: f32,
}

const TAU: f32 = 6.283185307179586;
const PI: f32 = 3.141592653589793;

fn wrap(angle: f32, period: f32) -> f32 {
    let wrapped = angle - period * floor(angle / period);
    return select(0.0, wrapped, wrapped < period);
}

// The caller makes sure that wi is not −wo.
fn half_diff_from_directions(wi: vec3f, wo: vec3f) -> HalfDiff {
    let wh = half_vector(wi, wo);
    let horizontal = length(wh.xy);
    let theta_h = atan2(horizontal, wh.z);
    let across = wi - wo;
    let theta_d = atan2(length(across), length(wi + wo));
    var azimuth_h = vec2f(1.0, 0.0);
    if horizontal > 0.0 {
        azimuth_h = wh.xy / horizontal;
    }
    let tangent = vec3f(wh.z * azimuth_h, -horizontal);
    let bitangent = vec3f(-azimuth_h.y, azimuth_h.x, 0.0);
    let x = dot(across, tangent);
    let y = dot(across, bitangent);
    var phi_d = 0.0;
    // Mirror directions have no azimuth, and atan2(0, 0) is undefined in WGSL.
    if horizontal > 1e-7 && (x != 0.0 || y != 0.0) {
        phi_d = wrap(atan2(y, x), TAU);
    }
    return HalfDiff(theta_h, theta_d, phi_d);
}
