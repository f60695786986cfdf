// Twin of cosines.rs. Directions are unit vectors in the local frame, z = n. Types are written out: brdf/codegen makes
// GLSL of this.

struct Cosine {
    cos: f32,
    versine: f32,
}

struct Cosines {
    cos_theta_i: f32,
    cos_theta_o: f32,
    wr_wo: Cosine,
    wh_n: Cosine,
    wi_wh: Cosine,
}

fn half_vector(wi: vec3f, wo: vec3f) -> vec3f {
    let sum: vec3f = wi + wo;
    let squared: f32 = dot(sum, sum);
    if squared < 1e-30 {
        return vec3f(0.0, 0.0, 1.0);
    }
    return sum * inverseSqrt(squared);
}

fn cosine_between(a: vec3f, b: vec3f) -> Cosine {
    let chord: vec3f = a - b;
    return Cosine(max(dot(a, b), 0.0), min(0.5 * dot(chord, chord), 1.0));
}

fn cosines_from_directions(wi: vec3f, wo: vec3f) -> Cosines {
    let wh: vec3f = half_vector(wi, wo);
    let wr: vec3f = vec3f(-wi.x, -wi.y, wi.z);
    return Cosines(
        wi.z,
        wo.z,
        cosine_between(wr, wo),
        cosine_between(wh, vec3f(0.0, 0.0, 1.0)),
        cosine_between(wi, wh),
    );
}

// ln(1 − x) for x in [0, 0.5]. Shaders have no log1p; the series takes over where 1 − x would round.
fn ln_one_minus(x: f32) -> f32 {
    if x < 0.06 {
        return -x * (1.0 + x * (0.5 + x * (1.0 / 3.0 + x * (0.25 + x * 0.2))));
    }
    return log(1.0 - x);
}

fn pow_cosine(c: Cosine, exponent: f32) -> f32 {
    var ln: f32 = 0.0;
    if c.versine < 0.5 {
        ln = ln_one_minus(c.versine);
    } else if c.cos > 0.0 {
        ln = log(c.cos);
    } else {
        return 0.0;
    }
    // exp underflows to 0 below −87; the clamp keeps drivers from making an inf on the way.
    return exp(max(exponent * ln, -100.0));
}
