//! WGSL sources of the passes, put together from the twins.

/// Library of angles, models and tables: `eval_brdf`, `half_diff_from_directions`, `lookup_table`.
pub fn library() -> String {
    [
        crate::brdf::wgsl::source().as_str(),
        include_str!("../geom/half_diff.wgsl"),
        include_str!("../geom/color.wgsl"),
        include_str!("../measured/lookup.wgsl"),
    ]
    .join("\n")
}

/// WGSL source of the sphere pass.
pub fn sphere() -> String {
    library() + include_str!("sphere.wgsl")
}

/// WGSL source of lobes in 3D.
pub fn lobe3d() -> String {
    include_str!("lobe3d.wgsl").to_string()
}

/// WGSL source of the copy of a texture over a viewport.
pub fn blit() -> String {
    include_str!("blit.wgsl").to_string()
}
