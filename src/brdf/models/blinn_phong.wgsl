// Twin of blinn_phong.rs.

fn lobe_blinn_phong(s: f32, c: Cosines) -> f32 {
    return pow_cosine(c.wh_n, s);
}
