//! WGSL source of all models, put together from their rows, and the uniform that holds a BRDF.

use super::model::Brdf;
use super::models::MODELS;
use super::params::{self, ParamId};
use std::fmt::Write as _;

/// Number of 16-byte slots of a BRDF in a uniform: one per parameter, and one for model and Fresnel factor.
pub const UNIFORM_SLOTS: usize = params::ALL.len() + 1;

/// Uniform `array<vec4f, BRDF_SLOTS>` of a BRDF, which `brdf_from_slots` of [`source`] reads: one slot per parameter,
/// in the order of [`params::ALL`]. Values are clamped to the parameter's domain, on which the shader makes no inf or
/// NaN.
///
/// An array of vectors, since it lies in memory the same way everywhere: on GL, members of a struct are packed without
/// regard to `@align`.
pub fn uniform(brdf: &Brdf) -> [[f32; 4]; UNIFORM_SLOTS] {
    let mut slots = [[0.0; 4]; UNIFORM_SLOTS];
    for (slot, row) in slots.iter_mut().zip(&params::ALL) {
        let row = brdf.model.param(row.id).unwrap_or(row);
        for (to, from) in slot.iter_mut().zip(brdf.params.get(row.id)) {
            *to = row.clamp(*from) as f32;
        }
    }
    slots[UNIFORM_SLOTS - 1] = [
        brdf.model.index() as f32,
        brdf.fresnel.index() as f32,
        0.0,
        0.0,
    ];
    slots
}

/// WGSL source that defines `struct Params`, `struct Brdf`, every lobe, `fn eval_brdf(b: Brdf, c: Cosines) -> vec3f`,
/// the twin of [`Brdf::eval`], and `fn brdf_from_slots(slots: array<vec4f, BRDF_SLOTS>) -> Brdf`.
pub fn source() -> String {
    let mut text = String::from("struct Params {\n");
    for row in &params::ALL {
        let ty = if row.id.is_color() { "vec3f" } else { "f32" };
        let _ = writeln!(text, "    {}: {ty},", row.key);
    }
    text.push_str(
        "}\n\nstruct Brdf {\n    params: Params,\n    model: u32,\n    fresnel: u32,\n}\n\n",
    );
    text.push_str(&from_slots());
    text.push_str(include_str!("../geom/cosines.wgsl"));
    text.push_str(include_str!("fresnel.wgsl"));
    for model in MODELS {
        text.push_str(model.wgsl);
    }
    text.push_str("\nfn lobe(b: Brdf, c: Cosines) -> f32 {\n    switch b.model {\n");
    for (index, model) in MODELS.iter().enumerate() {
        let name = model.key.replace('-', "_");
        let _ = writeln!(
            text,
            "        case {index}u: {{ return lobe_{name}(b.params, c); }}"
        );
    }
    text.push_str("        default: { return 0.0; }\n    }\n}\n");
    let _ = write!(
        text,
        "
fn eval_brdf(b: Brdf, c: Cosines) -> vec3f {{
    let shape = reflectance(b.fresnel, c.wi_dot_wh, b.params.{eta}) * lobe(b, c);
    return b.params.{rho_d} * 0.3183098861837907 + b.params.{k_s} * shape;
}}
",
        eta = ParamId::Eta.key(),
        rho_d = ParamId::RhoD.key(),
        k_s = ParamId::KS.key(),
    );
    text
}

fn from_slots() -> String {
    let last = UNIFORM_SLOTS - 1;
    let mut text = format!(
        "const BRDF_SLOTS: u32 = {UNIFORM_SLOTS}u;\n\n\
         fn brdf_from_slots(slots: array<vec4f, BRDF_SLOTS>) -> Brdf {{\n    let params = Params(\n"
    );
    for (slot, row) in params::ALL.iter().enumerate() {
        let part = if row.id.is_color() { "xyz" } else { "x" };
        let _ = writeln!(text, "        slots[{slot}].{part},");
    }
    let _ = writeln!(
        text,
        "    );\n    return Brdf(params, u32(slots[{last}].x), u32(slots[{last}].y));\n}}\n"
    );
    text
}
