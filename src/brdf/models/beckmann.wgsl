// Twin of beckmann.rs.

fn beckmann_masking_over_cosine(roughness: f32, cos_theta: f32) -> f32 {
    let cosine: f32 = max(cos_theta, 0.0);
    let scale: f32 = roughness * sqrt((1.0 - cosine) * (1.0 + cosine));
    if cosine >= 1.6 * scale {
        return 1.0 / cosine;
    }
    let b: f32 = cosine / scale;
    return (3.535 + 2.181 * b) / (scale * (1.0 + b * (2.276 + 2.577 * b)));
}

fn lobe_beckmann(roughness: f32, c: Cosines) -> f32 {
    return 0.25 * beckmann_d(roughness, c.wh_n)
        * beckmann_masking_over_cosine(roughness, c.cos_theta_i)
        * beckmann_masking_over_cosine(roughness, c.cos_theta_o);
}
