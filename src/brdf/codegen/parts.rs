//! The parts of the exported texts: head, parameter values, functions.

use crate::brdf::wgsl::{self, SHARED};
use crate::brdf::{Brdf, Fresnel, Param};
use crate::quote::shown;
use std::fmt::Write as _;

/// Comment that says how the function is called.
pub(super) const USE: &str = "//
// brdf(wi, wo) is f_r in 1/sr for linear R, G, B: without the cosine, and 0 below the horizon. wi to the light and wo to
// the viewer are unit vectors in the local frame, z = n. Dot products are clamped at 0.

";

/// Head of the text, as comments: model, formula, sources, parameter values, version.
pub(super) fn head(brdf: &Brdf, material: Option<&str>, comment: &str) -> String {
    let of = material.map_or(String::new(), |name| format!(" of {}", one_line(name)));
    let name = brdf.model.name;
    let version = env!("CARGO_PKG_VERSION");
    let formula = brdf
        .model
        .formula
        .replace("_{", "")
        .replace("^{", "^")
        .replace('}', "");
    let (factor, reflectance) = match brdf.fresnel {
        Fresnel::None => ("", String::new()),
        fresnel => (" R_F(ωi·ωh, eta)", format!("; R_F is {}", fresnel.source())),
    };
    let source = brdf.model.source;
    let mut numbers = Vec::new();
    for row in brdf.used() {
        let unit = if row.unit.is_empty() { "" } else { " " };
        let value = literal_list(brdf, row);
        numbers.push(format!("{} = {value}{unit}{}", row.key(), row.unit));
    }
    let numbers = numbers.join(", ");
    format!(
        "{comment} {name} BRDF{of}, by Grazing {version}
{comment}
{comment} f_r = rho_d/π + k_s{factor} {formula}
{comment} Source: {source}{reflectance}
{comment} {numbers}
"
    )
}

/// Values of a parameter, clamped to its domain, on which the functions make no inf or NaN.
pub(super) fn values(brdf: &Brdf, row: &Param) -> Vec<f64> {
    let values = brdf.get(row.id).iter();
    values.map(|value| row.clamp(*value)).collect()
}

fn literal_list(brdf: &Brdf, row: &Param) -> String {
    let list: Vec<String> = values(brdf, row).into_iter().map(literal).collect();
    match &list[..] {
        [one] => one.clone(),
        many => format!("({})", many.join(", ")),
    }
}

/// Literal of a number in WGSL and GLSL: the shortest text that reads back as the same f64.
pub(super) fn literal(value: f64) -> String {
    format!("{value:?}")
}

/// WGSL text of the twins that the model may need, and of `with_params`, the BRDF for any parameters.
pub(super) fn library(brdf: &Brdf) -> String {
    let mut text = String::from("struct Params {\n");
    for row in brdf.used() {
        let ty = if row.id.is_color() { "vec3f" } else { "f32" };
        let _ = writeln!(text, "    {}: {ty},", row.key());
    }
    text.push_str("}\n\n");
    text.push_str(include_str!("../../geom/cosines.wgsl"));
    text.push_str(include_str!("../fresnel.wgsl"));
    text.push_str(SHARED);
    text.push_str(brdf.model.wgsl);
    let factor = match brdf.fresnel {
        Fresnel::None => String::new(),
        fresnel => format!("fresnel_{}(c.wi_wh.cos, p.eta) * ", fresnel.key()),
    };
    let lobe = wgsl::call(brdf.model, |k| format!("p.{}", brdf.model.params[k].key()));
    let _ = write!(
        text,
        "
fn with_params(p: Params, wi: vec3f, wo: vec3f) -> vec3f {{
    if min(wi.z, wo.z) < 0.0 {{
        return vec3f(0.0);
    }}
    let c: Cosines = cosines_from_directions(wi, wo);
    let shape: f32 = {factor}{lobe};
    return p.rho_d * 0.3183098861837907 + p.k_s * shape;
}}
"
    );
    text
}

/// WGSL text of `fn brdf(wi, wo)` with the parameter values of the model.
pub(super) fn entry(brdf: &Brdf) -> String {
    let mut text =
        String::from("fn brdf(wi: vec3f, wo: vec3f) -> vec3f {\n    let p: Params = Params(\n");
    for row in brdf.used() {
        let list = literal_list(brdf, row);
        let ty = if row.id.is_color() { "vec3f" } else { "" };
        let _ = writeln!(text, "        {ty}{list},");
    }
    text.push_str("    );\n    return with_params(p, wi, wo);\n}\n");
    text
}

/// Name as ASCII text in a comment of one line of bounded length: a backslash at its end would continue the comment.
fn one_line(name: &str) -> String {
    let plain = |c: char| match c {
        '\\' => '/',
        c if c.is_ascii() && !c.is_ascii_control() => c,
        _ => '?',
    };
    let plain: String = name.chars().map(plain).collect();
    shown(&plain).replace('…', "...")
}

/// Text with characters outside of ASCII written out: shader compilers need not accept them, not even in comments.
pub(super) fn ascii(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            'α' => out.push_str("alpha"),
            'η' => out.push_str("eta"),
            'π' => out.push_str("pi"),
            'ω' => out.push('w'),
            '≥' => out.push_str(">="),
            'θ' => out.push_str("theta_"),
            '√' => out.push_str("sqrt"),
            'ö' | 'ü' => out.push_str(if c == 'ö' { "oe" } else { "ue" }),
            '²' => out.push_str("^2"),
            '−' => out.push('-'),
            '·' => out.push('.'),
            '→' => out.push_str("->"),
            c => out.push(c),
        }
    }
    out
}
