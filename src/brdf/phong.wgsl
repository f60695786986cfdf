// Twin of phong.rs.

fn lobe_phong(p: Params, c: Cosines) -> f32 {
    return pow_versine(c.versine_r, p.s);
}
