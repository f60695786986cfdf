// Twin of low_smooth.rs.

fn lobe_low_smooth(b: f32, falloff: f32, c: Cosines) -> f32 {
    let deviation: f32 = 4.0 * c.wi_wh.cos * c.wi_wh.cos * sin_squared(c.wh_n);
    return abc_falloff(b, falloff, deviation);
}
