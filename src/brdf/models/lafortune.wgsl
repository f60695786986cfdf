// Twin of lafortune.rs.

fn lobe_lafortune(s: f32, c_z: f32, c: Cosines) -> f32 {
    let product: f32 = max(c.cos_theta_i, 0.0) * max(c.cos_theta_o, 0.0);
    let excess: f32 = c_z - 1.0;
    var cosine: f32 = c.wr_wo.cos + excess * product;
    var versine: f32 = c.wr_wo.versine - excess * product;
    if excess > 0.0 {
        let sin2_d: f32 = sin_squared(c.wi_wh);
        var wr_wo: Cosine = c.wr_wo;
        // wr·wo below 0 is clamped in its Cosine, but counts here.
        if wr_wo.cos <= 0.0 {
            wr_wo.cos = 2.0 * product - 1.0 + 2.0 * sin2_d;
            wr_wo.versine = 1.0 - wr_wo.cos;
        }
        let rest: f32 = 0.5 * wr_wo.versine + sin2_d;
        cosine = (wr_wo.cos + excess * product) / c_z;
        versine = (wr_wo.versine + excess * rest) / c_z;
    }
    return pow_cosine(Cosine(max(cosine, 0.0), clamp(versine, 0.0, 1.0)), s);
}
