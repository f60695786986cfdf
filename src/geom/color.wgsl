// Twin of color.rs.

fn srgb_encode(linear: vec3f) -> vec3f {
    let x = clamp(linear, vec3f(0.0), vec3f(1.0));
    let low = 12.92 * x;
    let high = 1.055 * pow(max(x, vec3f(1e-8)), vec3f(1.0 / 2.4)) - 0.055;
    return select(high, low, x <= vec3f(0.0031308));
}

fn luminance(rgb: vec3f) -> f32 {
    return dot(rgb, vec3f(0.2126, 0.7152, 0.0722));
}
