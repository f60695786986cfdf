// Twin of ward.rs.

fn lobe_ward(roughness: f32, c: Cosines) -> f32 {
    let cosines: f32 = divisor(c.cos_theta_i) * divisor(c.cos_theta_o);
    return gaussian_of_tan(roughness, c.wh_n)
        / (12.566370614359172 * roughness * roughness * sqrt(cosines));
}
