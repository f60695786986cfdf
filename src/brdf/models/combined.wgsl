// Twin of combined.rs.

fn versine_pow4(x: f32) -> f32 {
    return x * (4.0 - x * (6.0 - x * (4.0 - x)));
}

fn lobe_combined(s: f32, alpha: f32, c: Cosines) -> f32 {
    let h2: f32 = c.wh_n.cos * c.wh_n.cos;
    let blend: Cosine = Cosine(
        (1.0 - alpha) * c.wr_wo.cos + alpha * h2 * h2,
        (1.0 - alpha) * c.wr_wo.versine + alpha * versine_pow4(c.wh_n.versine),
    );
    return pow_cosine(blend, s);
}
