//! The models as shader text, put together from the rows, and the uniform that carries their numbers.

use super::{Brdf, MODELS, ParamId, params};
use std::fmt::Write as _;

/// The number of 16-byte slots of the uniform struct `Brdf`: one per parameter and one for what is chosen.
pub const UNIFORM_SLOTS: usize = params::ALL.len() + 1;

/// The uniform struct `Brdf` of [`source`] as bytes to upload: every parameter starts a slot of its own.
pub fn uniform(brdf: &Brdf) -> [[f32; 4]; UNIFORM_SLOTS] {
    let mut slots = [[0.0; 4]; UNIFORM_SLOTS];
    for (slot, row) in slots.iter_mut().zip(&params::ALL) {
        for (to, from) in slot.iter_mut().zip(brdf.params.get(row.id)) {
            *to = *from as f32;
        }
    }
    slots[UNIFORM_SLOTS - 1] = [
        f32::from_bits(brdf.model.index() as u32),
        f32::from_bits(brdf.fresnel.index() as u32),
        0.0,
        0.0,
    ];
    slots
}

/// WGSL that defines `struct Params`, `struct Brdf`, every lobe, and
/// `fn eval_brdf(b: Brdf, c: Cosines) -> vec3f`, the twin of [`Brdf::eval`].
pub fn source() -> String {
    let mut text = String::from("struct Params {\n");
    for row in &params::ALL {
        let ty = if row.id.is_color() { "vec3f" } else { "f32" };
        let _ = writeln!(text, "    @align(16) {}: {ty},", row.key);
    }
    text.push_str(
        "}\n\nstruct Brdf {\n    params: Params,\n    @align(16) model: u32,\n    fresnel: u32,\n}\n\n",
    );
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
