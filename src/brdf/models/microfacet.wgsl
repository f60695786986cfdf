// Twin of microfacet.rs.

// A cosine that a formula may divide by.
fn divisor(cosine: f32) -> f32 {
    return max(cosine, 1e-6);
}

fn sin_squared(x: Cosine) -> f32 {
    return x.versine * (2.0 - x.versine);
}

// exp underflows to 0 below −87; the clamp keeps drivers from making an inf on the way.
fn gaussian_of_tan(roughness: f32, x: Cosine) -> f32 {
    let scale: f32 = divisor(x.cos) * roughness;
    return exp(max(-sin_squared(x) / (scale * scale), -100.0));
}

fn beckmann_d(roughness: f32, wh_n: Cosine) -> f32 {
    let cosine: f32 = divisor(wh_n.cos);
    let scale: f32 = roughness * cosine * cosine;
    return gaussian_of_tan(roughness, wh_n) * 0.3183098861837907 / (scale * scale);
}

fn vgroove_over_cosines(c: Cosines) -> f32 {
    let cos_i: f32 = divisor(c.cos_theta_i);
    let cos_o: f32 = divisor(c.cos_theta_o);
    let open: f32 = 1.0 / (cos_i * cos_o);
    let blocked: f32 = 2.0 * c.wh_n.cos / (divisor(c.wi_wh.cos) * max(cos_i, cos_o));
    return min(open, blocked);
}

// ln(1 + x) for x ≥ 0. Shaders have no log1p; the series takes over where 1 + x would round.
fn ln_one_plus(x: f32) -> f32 {
    if x < 0.06 {
        return x * (1.0 - x * (0.5 - x * (1.0 / 3.0 - x * (0.25 - x * 0.2))));
    }
    return log(1.0 + x);
}

fn abc_falloff(b: f32, c: f32, x: f32) -> f32 {
    return exp(max(-c * ln_one_plus(b * x), -100.0));
}
