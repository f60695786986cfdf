// Twin of ashikhmin_shirley.rs.

fn lobe_ashikhmin_shirley(s: f32, c: Cosines) -> f32 {
    let larger: f32 = divisor(max(c.cos_theta_i, c.cos_theta_o));
    return (s + 1.0) * 0.039788735772973836 * pow_cosine(c.wh_n, s)
        / (divisor(c.wi_wh.cos) * larger);
}
