// Twin of ward_duer.rs.

fn lobe_ward_duer(roughness: f32, c: Cosines) -> f32 {
    let cosines: f32 = divisor(c.cos_theta_i) * divisor(c.cos_theta_o);
    return gaussian_of_tan(roughness, c.wh_n)
        / (12.566370614359172 * roughness * roughness * cosines);
}
