// Twin of combined.rs.

fn versine_pow4(x: f32) -> f32 {
    return x * (4.0 - x * (6.0 - x * (4.0 - x)));
}

fn lobe_combined(p: Params, c: Cosines) -> f32 {
    let blend = (1.0 - p.alpha) * c.versine_r + p.alpha * versine_pow4(c.versine_h);
    return pow_versine(min(blend, 1.0), p.s);
}
