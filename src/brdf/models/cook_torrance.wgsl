// Twin of cook_torrance.rs.

fn lobe_cook_torrance(roughness: f32, c: Cosines) -> f32 {
    return 0.25 * beckmann_d(roughness, c.wh_n) * vgroove_over_cosines(c);
}
