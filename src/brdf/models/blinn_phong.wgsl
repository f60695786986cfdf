// Twin of blinn_phong.rs.

fn lobe_blinn_phong(p: Params, c: Cosines) -> f32 {
    return pow_cosine(c.wh_n, p.s);
}
