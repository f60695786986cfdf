// Twin of low_microfacet.rs.

fn lobe_low_microfacet(b: f32, falloff: f32, c: Cosines) -> f32 {
    return abc_falloff(b, falloff, c.wh_n.versine) * vgroove_over_cosines(c);
}
