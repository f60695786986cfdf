// Twin of cosines.rs. Directions are unit vectors in the local frame, z = n.

struct Cosines {
    cos_theta_i: f32,
    cos_theta_o: f32,
    versine_r: f32,
    versine_h: f32,
    wi_dot_wh: f32,
}

fn half_vector(wi: vec3f, wo: vec3f) -> vec3f {
    let sum = wi + wo;
    let squared = dot(sum, sum);
    if squared < 1e-30 {
        return vec3f(0.0, 0.0, 1.0);
    }
    return sum * inverseSqrt(squared);
}

fn versine(a: vec3f, b: vec3f) -> f32 {
    let chord = a - b;
    return min(0.5 * dot(chord, chord), 1.0);
}

fn cosines_from_directions(wi: vec3f, wo: vec3f) -> Cosines {
    let wh = half_vector(wi, wo);
    let wr = vec3f(-wi.x, -wi.y, wi.z);
    return Cosines(
        wi.z,
        wo.z,
        versine(wr, wo),
        versine(wh, vec3f(0.0, 0.0, 1.0)),
        max(dot(wi, wh), 0.0),
    );
}

// ln(1 − x) for x in [0, 1). WGSL has no log1p; the series takes over where 1 − x would round.
fn ln_one_minus(x: f32) -> f32 {
    if x < 0.06 {
        return -x * (1.0 + x * (0.5 + x * (1.0 / 3.0 + x * (0.25 + x * 0.2))));
    }
    return log(1.0 - x);
}

fn pow_versine(versine: f32, exponent: f32) -> f32 {
    if versine >= 1.0 {
        return 0.0;
    }
    // exp underflows to 0 below −87; the clamp keeps drivers from making an inf on the way.
    return exp(max(exponent * ln_one_minus(versine), -100.0));
}
