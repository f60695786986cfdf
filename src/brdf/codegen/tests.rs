use super::*;
use crate::brdf::fresnel::FRESNELS;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, MODELS, Params};

fn brdf(model: usize, fresnel: Fresnel) -> Brdf {
    Brdf {
        model: MODELS[model],
        fresnel,
        params: Params {
            rho_d: [0.25, 0.125, 0.0],
            k_s: [9.0, 8.5, 1e-7],
            lobe: lobe_values([120.0, 0.4]),
            eta: 1.5,
        },
    }
}

type Export = fn(&Brdf, Option<&str>) -> String;

const EXPORTS: [Export; 3] = [wgsl, glsl, disney];

#[test]
fn the_head_says_what_it_is_and_all_is_ascii() {
    for export in EXPORTS {
        let text = export(&brdf(2, Fresnel::Exact), Some("teflon"));
        for said in [
            " Combined BRDF of teflon, by Grazing ",
            env!("CARGO_PKG_VERSION"),
            " f_r = rho_d/pi + k_s R_F(wi.wh, eta) ((1 - alpha)(wr.wo) + alpha(wh.n)^4)^s\n",
            "[Nielsen14], the poster's new model; R_F is the Fresnel equations",
            "[CookTorrance82]",
            "rho_d = (0.25, 0.125, 0.0), k_s = (9.0, 8.5, 1e-7) 1/sr, s = 120.0, alpha = 0.4, eta = 1.5",
        ] {
            assert!(text.contains(said), "{said:?} is not in\n{text}");
        }
        for model in 0..MODELS.len() {
            for fresnel in FRESNELS {
                let text = export(&brdf(model, fresnel), Some("größe 7"));
                assert!(text.is_ascii(), "{text}");
            }
        }
    }
    let plain = wgsl(&brdf(0, Fresnel::None), None);
    assert!(plain.starts_with("// Phong BRDF, by Grazing "), "{plain}");
    assert!(
        plain.contains("// f_r = rho_d/pi + k_s (wr.wo)^s\n"),
        "{plain}"
    );
}

#[test]
fn only_what_the_model_needs_is_there() {
    let text = wgsl(&brdf(0, Fresnel::Schlick), None);
    let names: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("fn ").or(line.strip_prefix("struct ")))
        .filter_map(|rest| rest.split(['(', ' ']).next())
        .collect();
    let mut sorted = names.clone();
    sorted.sort_unstable();
    assert_eq!(
        sorted,
        [
            "BrdfCosine",
            "BrdfCosines",
            "BrdfParams",
            "brdf",
            "brdf_cosine_between",
            "brdf_cosines_from_directions",
            "brdf_fresnel_schlick",
            "brdf_half_vector",
            "brdf_ln_one_minus",
            "brdf_lobe_phong",
            "brdf_pow_cosine",
            "brdf_with_params",
        ]
    );
    assert_eq!(names.last(), Some(&"brdf"));
    assert!(!text.contains("alpha") && !text.contains("Twin"), "{text}");
    let without = wgsl(&brdf(0, Fresnel::None), None);
    assert!(
        !without.contains(" eta") && !without.contains("fresnel_"),
        "{without}"
    );
}

#[test]
fn a_strange_name_stays_in_its_comment() {
    for export in EXPORTS {
        let text = export(&brdf(1, Fresnel::None), Some("a\nfn b() {} \\"));
        let line = text.lines().find(|line| line.contains("BRDF of a"));
        let line = line.expect("the head");
        assert!(line.contains("a?fn b() {} /, by Grazing"), "{line}");
    }
}

#[test]
fn numbers_outside_of_the_domain_are_brought_into_it() {
    let mut wild = brdf(2, Fresnel::Exact);
    wild.params.lobe[0] = f64::NAN;
    wild.params.eta = 0.0;
    wild.params.rho_d = [-1.0, f64::INFINITY, 0.5];
    let text = wgsl(&wild, None);
    assert!(text.contains("s = 50.0, alpha = 0.4, eta = 1.0"), "{text}");
    assert!(text.contains("vec3f(0.0, 1000000.0, 0.5)"), "{text}");
}

#[test]
fn wgsl_becomes_glsl_word_by_word() {
    let wgsl = "\
// Kept: fn let if.
struct A {
    x: f32,
    v: vec3f,
}

fn f(a: A, n: u32) -> f32 {
    var y: f32 = inverseSqrt(a.x);
    if a.x < 1e-3 {
        y = 2.0;
    } else if a.v.z > y {
        return max(
            y,
            a.x,
        );
    }
    let b: A = A(y, vec3f(1.0, 2.0, 3.0));
    return b.x;
}
";
    let wanted = "\
// Kept: fn let if.
struct A {
    float x;
    vec3 v;
};

float f(A a, uint n) {
    float y = inversesqrt(a.x);
    if (a.x < 1e-3) {
        y = 2.0;
    } else if (a.v.z > y) {
        return max(
            y,
            a.x
        );
    }
    A b = A(y, vec3(1.0, 2.0, 3.0));
    return b.x;
}
";
    assert_eq!(glsl::from_wgsl(wgsl), wanted);
}
