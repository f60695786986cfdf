// Twin of ggx.rs.

fn ggx_masking_over_two_cosines(roughness: f32, cos_theta: f32) -> f32 {
    let cosine: f32 = max(cos_theta, 0.0);
    let sin2: f32 = (1.0 - cosine) * (1.0 + cosine);
    return 1.0 / (cosine + sqrt(cosine * cosine + roughness * roughness * sin2));
}

fn lobe_ggx(roughness: f32, c: Cosines) -> f32 {
    let cos_h: f32 = c.wh_n.cos;
    let width: f32 = roughness * roughness * cos_h * cos_h + sin_squared(c.wh_n);
    let root_d: f32 = roughness / width;
    return root_d * root_d * 0.3183098861837907
        * ggx_masking_over_two_cosines(roughness, c.cos_theta_i)
        * ggx_masking_over_two_cosines(roughness, c.cos_theta_o);
}
