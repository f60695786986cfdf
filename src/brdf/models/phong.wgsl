// Twin of phong.rs.

fn lobe_phong(p: Params, c: Cosines) -> f32 {
    return pow_cosine(c.wr_wo, p.s);
}
