//! Shader text, put together from the twins.

/// Everything that knows angles, models and tables: `eval_brdf`, `half_diff_from_directions`, `lookup_table`.
pub fn library() -> String {
    [
        crate::brdf::wgsl::source().as_str(),
        include_str!("../geom/half_diff.wgsl"),
        include_str!("../geom/color.wgsl"),
        include_str!("../measured/lookup.wgsl"),
    ]
    .join("\n")
}

/// The sphere pass.
pub fn sphere() -> String {
    library() + include_str!("sphere.wgsl")
}

/// Lobes in space.
pub fn lobe3d() -> String {
    include_str!("lobe3d.wgsl").to_string()
}

/// A picture put into another one.
pub fn blit() -> String {
    include_str!("blit.wgsl").to_string()
}
