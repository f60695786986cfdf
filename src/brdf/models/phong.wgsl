// Twin of phong.rs.

fn lobe_phong(s: f32, c: Cosines) -> f32 {
    return pow_cosine(c.wr_wo, s);
}
