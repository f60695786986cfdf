//! WGSL source of all models, put together from their rows, and the uniform that holds a BRDF.

use super::model::{Brdf, Model};
use super::models::MODELS;
use super::params::{ETA, K_S, RHO_D};
use std::fmt::Write as _;

/// Number of 16-byte slots of a BRDF in a uniform: ρ_d, k_s, the lobe's parameters, and η with model and Fresnel factor.
pub const UNIFORM_SLOTS: usize = 4;

/// Uniform `array<vec4f, BRDF_SLOTS>` of a BRDF, which `brdf_from_slots` of [`source`] reads. Values are clamped to the
/// parameter's domain, on which the shader makes no inf or NaN.
///
/// An array of vectors, since it lies in memory the same way everywhere: on GL, members of a struct are packed without
/// regard to `@align`.
pub fn uniform(brdf: &Brdf) -> [[f32; 4]; UNIFORM_SLOTS] {
    let params = &brdf.params;
    let color = |row: &super::Param, rgb: [f64; 3]| {
        let [r, g, b] = rgb.map(|value| row.clamp(value) as f32);
        [r, g, b, 0.0]
    };
    let mut lobe = [0.0; 4];
    for ((to, from), row) in lobe.iter_mut().zip(params.lobe).zip(brdf.model.params) {
        *to = row.clamp(from) as f32;
    }
    [
        color(&RHO_D, params.rho_d),
        color(&K_S, params.k_s),
        lobe,
        [
            ETA.clamp(params.eta) as f32,
            brdf.model.index() as f32,
            brdf.fresnel.index() as f32,
            0.0,
        ],
    ]
}

/// WGSL source that defines `struct Brdf`, every lobe, `fn eval_brdf(b: Brdf, c: Cosines) -> vec3f`, the twin of
/// [`Brdf::eval`], and `fn brdf_from_slots(slots: array<vec4f, BRDF_SLOTS>) -> Brdf`.
pub fn source() -> String {
    let mut text = format!(
        "\
const BRDF_SLOTS: u32 = {UNIFORM_SLOTS}u;

struct Brdf {{
    rho_d: vec3f,
    k_s: vec3f,
    lobe: vec4f,
    eta: f32,
    model: u32,
    fresnel: u32,
}}

fn brdf_from_slots(slots: array<vec4f, BRDF_SLOTS>) -> Brdf {{
    let last = slots[3];
    return Brdf(slots[0].xyz, slots[1].xyz, slots[2], last.x, u32(last.y), u32(last.z));
}}

"
    );
    text.push_str(include_str!("../geom/cosines.wgsl"));
    text.push_str(include_str!("fresnel.wgsl"));
    text.push_str(SHARED);
    for model in MODELS {
        text.push_str(model.wgsl);
    }
    text.push_str("\nfn lobe(b: Brdf, c: Cosines) -> f32 {\n    switch b.model {\n");
    for (index, model) in MODELS.iter().enumerate() {
        let call = call(model, |k| format!("b.lobe[{k}]"));
        let _ = writeln!(text, "        case {index}u: {{ return {call}; }}");
    }
    text.push_str(
        "        default: { return 0.0; }
    }
}

fn eval_brdf(b: Brdf, c: Cosines) -> vec3f {
    let shape = reflectance(b.fresnel, c.wi_wh.cos, b.eta) * lobe(b, c);
    return b.rho_d * 0.3183098861837907 + b.k_s * shape;
}
",
    );
    text
}

/// WGSL text of what the twins of several models use.
pub(super) const SHARED: &str = include_str!("models/microfacet.wgsl");

/// Call of a lobe at the cosines `c`; `argument` is the text of its k-th parameter.
pub(super) fn call(model: &Model, argument: impl Fn(usize) -> String) -> String {
    let arguments: String = (0..model.params.len())
        .map(|k| argument(k) + ", ")
        .collect();
    format!("{}({arguments}c)", model.wgsl_name())
}
