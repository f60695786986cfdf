//! The `.brdf` files of Disney's BRDF Explorer: parameters with sliders, and a GLSL shader that reads them as uniforms.

use super::glsl::from_wgsl;
use super::items::WgslItems;
use super::parts::{ascii, head, library, literal, values};
use crate::brdf::Brdf;
use crate::brdf::params::{Param, Scale};
use std::fmt::Write as _;

/// Text of a `.brdf` file of the model, whose sliders begin at its parameters.
///
/// The program's sliders are linear, so a parameter whose row has a logarithmic scale is written as its logarithm,
/// under `log10_` and its key. The program's colours are in [0, 1], so a colour is written as its largest channel under
/// its key, and its shade under the key with `_color`. Ranges are those of the rows.
pub fn disney(brdf: &Brdf, material: Option<&str>) -> String {
    let mut text = String::from("analytic\n\n");
    text.push_str(&head(brdf, material, "#"));
    text.push_str("\n::begin parameters\n");
    let mut arguments = String::new();
    for row in brdf.used() {
        let values = values(brdf, row);
        let largest = values.iter().copied().fold(0.0, f64::max);
        let (name, [low, high], default, value) = slider(row, largest);
        let numbers = [low, high, default].map(literal).join(" ");
        let _ = writeln!(text, "float {name} {numbers}");
        if row.id.is_color() {
            let key = row.key();
            let shade = |value: &f64| literal(if largest > 0.0 { value / largest } else { 0.0 });
            let shades: Vec<String> = values.iter().map(shade).collect();
            let _ = writeln!(text, "color {key}_color {}", shades.join(" "));
            let _ = writeln!(arguments, "        {value} * {key}_color,");
        } else {
            let _ = writeln!(arguments, "        {value},");
        }
    }
    let function = format!(
        "fn BRDF(L: vec3f, V: vec3f, N: vec3f, X: vec3f, Y: vec3f) -> vec3f {{
    // The local frame has z = N.
    let wi: vec3f = vec3f(dot(L, X), dot(L, Y), dot(L, N));
    let wo: vec3f = vec3f(dot(V, X), dot(V, Y), dot(V, N));
    let p: Params = Params(
{arguments}    );
    return with_params(p, wi, wo);
}}
"
    );
    let items = WgslItems::new(&[&library(brdf), &function]);
    let functions = from_wgsl(&items.needed_by("BRDF"));
    let _ = write!(
        text,
        "::end parameters\n\n::begin shader\n\n{functions}\n::end shader\n"
    );
    ascii(&text)
}

/// Name, range and default of a parameter's slider, and the GLSL expression of the parameter in terms of it.
fn slider(row: &Param, value: f64) -> (String, [f64; 2], f64, String) {
    let key = row.key();
    let (low, high) = row.range;
    match row.scale {
        Scale::Linear => {
            let ends = [low.min(value), high.max(value)];
            (key.to_string(), ends, value, key.to_string())
        }
        Scale::Log { smallest_exponent } => {
            // 0 has no logarithm; its shade is black.
            let smallest = if low > 0.0 {
                low.log10()
            } else {
                f64::from(smallest_exponent)
            };
            let default = if value > 0.0 { value.log10() } else { smallest };
            let ends = [smallest.min(default), high.log10().max(default)];
            let name = format!("log10_{key}");
            let back = format!("pow(10.0, {name})");
            (name, ends, default, back)
        }
    }
}
