// Twin of fresnel.rs. Types are written out: brdf/codegen makes GLSL of this.

fn fresnel_exact(cos_theta: f32, eta: f32) -> f32 {
    let c: f32 = clamp(cos_theta, 0.0, 1.0);
    // (η − 1)(η + 1) keeps what η² − 1 would round away as η → 1.
    let n: f32 = (eta - 1.0) * (eta + 1.0);
    let g: f32 = sqrt(n + c * c);
    if g + c == 0.0 {
        return 1.0;
    }
    // g − c = n/(g + c), without the cancellation.
    let difference: f32 = n / (g + c);
    let a: f32 = difference / (g + c);
    let b: f32 = (c * (g + c) - 1.0) / (c * difference + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

fn fresnel_schlick(cos_theta: f32, eta: f32) -> f32 {
    let root: f32 = (eta - 1.0) / (eta + 1.0);
    let r0: f32 = root * root;
    let x: f32 = 1.0 - clamp(cos_theta, 0.0, 1.0);
    let x2: f32 = x * x;
    return r0 + (1.0 - r0) * (x2 * x2 * x);
}

// `kind` is the position in FRESNELS.
fn reflectance(kind: u32, cos_theta: f32, eta: f32) -> f32 {
    switch kind {
        case 1u: { return fresnel_exact(cos_theta, eta); }
        case 2u: { return fresnel_schlick(cos_theta, eta); }
        default: { return 1.0; }
    }
}
