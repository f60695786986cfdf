use super::*;
use crate::brdf::params::lobe_values;
use crate::geom::{Cosines, direction};
use glam::DVec3;
use proptest::prelude::*;
use std::f64::consts::PI;

fn brdf(key: &str, fresnel: Fresnel, s: f64, alpha: f64) -> Brdf {
    Brdf {
        model: Model::by_key(key).expect("a model"),
        fresnel,
        params: Params {
            rho_d: [0.1, 0.2, 0.3],
            k_s: [1.0, 2.0, 0.5],
            lobe: lobe_values([s, alpha]),
            eta: 1.5,
        },
    }
}

/// Lobes of the models from their definitions, written out with vectors and without this crate. `p` are the parameters of
/// the lobe in their order.
fn closed_form(key: &str, wi: DVec3, wo: DVec3, p: [f64; 2]) -> f64 {
    let n = DVec3::Z;
    let wr = 2.0 * wi.dot(n) * n - wi;
    let wh = (wi + wo).normalize();
    let (r, h, d) = (wr.dot(wo).max(0.0), wh.dot(n).max(0.0), wi.dot(wh));
    let (i, o) = (wi.dot(n), wo.dot(n));
    let tan2_h = (1.0 - h * h) / (h * h);
    let (first, a2) = (p[0], p[0] * p[0]);
    let beckmann = (-tan2_h / a2).exp() / (PI * a2 * h.powi(4));
    let groove = 1.0_f64.min(2.0 * h * i / d).min(2.0 * h * o / d);
    match key {
        "phong" => r.powf(first),
        "blinn-phong" => h.powf(first),
        "combined" => ((1.0 - p[1]) * r + p[1] * h.powi(4)).powf(first),
        "lafortune" => {
            let dot = p[1] * i * o - wi.x * wo.x - wi.y * wo.y;
            (dot.max(0.0) / p[1].max(1.0)).powf(first)
        }
        "ashikhmin-shirley" => (first + 1.0) / (8.0 * PI) * h.powf(first) / (d * i.max(o)),
        "ggx" => {
            let density = a2 / (PI * (h * h * (a2 - 1.0) + 1.0).powi(2));
            let seen = |cos: f64| 2.0 / (1.0 + (1.0 + a2 * (1.0 / (cos * cos) - 1.0)).sqrt());
            density * seen(i) * seen(o) / (4.0 * i * o)
        }
        "beckmann" => {
            let seen = |cos: f64| {
                let b = cos / (first * (1.0 - cos * cos).sqrt());
                let rational = (3.535 * b + 2.181 * b * b) / (1.0 + 2.276 * b + 2.577 * b * b);
                if b < 1.6 { rational } else { 1.0 }
            };
            beckmann * seen(i) * seen(o) / (4.0 * i * o)
        }
        "cook-torrance" => beckmann * groove / (4.0 * i * o),
        "ward" => (-tan2_h / a2).exp() / (4.0 * PI * a2 * (i * o).sqrt()),
        "ward-duer" => (-tan2_h / a2).exp() / (4.0 * PI * a2 * i * o),
        "low-smooth" => {
            let sum = wi + wo;
            (1.0 + first * (sum.x * sum.x + sum.y * sum.y)).powf(-p[1])
        }
        "low-microfacet" => (1.0 + first * (1.0 - h)).powf(-p[1]) * groove / (i * o),
        key => panic!("{key} has no closed form here"),
    }
}

/// Largest relative distance between the models and the closed forms at 20 angles, with an error put in.
fn worst_distance_at_20_angles(planted: f64) -> Vec<f64> {
    let of = |model: &&'static Model| {
        let mut worst: f64 = 0.0;
        for k in 0..20 {
            let t = f64::from(k) / 20.0;
            let (wi, wo) = (
                direction(1.5 * t, 0.3),
                direction(1.5 * (1.0 - t), 0.3 + 6.0 * t),
            );
            let mut b = Brdf::new(model, Fresnel::None);
            // Broad enough that no angle is in the dark, and on either side of what the formulas tell apart.
            let first = if model.params[0].key() == "roughness" {
                0.45
            } else {
                7.0
            };
            let second = if k % 2 == 0 {
                0.3
            } else {
                1.0 + 0.3 * f64::from(model.params.len() as u32 / 2)
            };
            let second = if model.key == "combined" { 0.3 } else { second };
            b.params = Params {
                rho_d: [0.1, 0.2, 0.3],
                k_s: [1.0, 2.0, 0.5],
                lobe: lobe_values([first, second]),
                eta: 1.5,
            };
            let expected = closed_form(model.key, wi, wo, [first + planted, second]);
            let found = b.eval(&Cosines::from_directions(wi, wo));
            for (channel, value) in found.into_iter().enumerate() {
                let wanted = b.params.rho_d[channel] / PI + b.params.k_s[channel] * expected;
                worst = worst.max((value - wanted).abs() / wanted);
            }
        }
        worst
    };
    MODELS.iter().map(of).collect()
}

#[test]
fn models_have_their_closed_form_values_at_20_angles() {
    for (model, worst) in MODELS.iter().zip(worst_distance_at_20_angles(0.0)) {
        assert!(worst < 2e-13, "{}: {worst:e}", model.key);
    }
}

#[test]
fn a_wrong_parameter_is_caught() {
    for (model, worst) in MODELS.iter().zip(worst_distance_at_20_angles(1e-9)) {
        assert!(worst > 1e-12, "{}: {worst:e}", model.key);
    }
}

#[test]
fn fresnel_has_its_textbook_values() {
    // η = 1.5 at normal incidence reflects 4 %; everything is reflected at the horizon.
    for fresnel in [Fresnel::Exact, Fresnel::Schlick] {
        assert!((fresnel.reflectance(1.0, 1.5) - 0.04).abs() < 1e-15);
        assert!((fresnel.reflectance(0.0, 1.5) - 1.0).abs() < 1e-15);
        assert!(fresnel.reflectance(1.0, 1.0).abs() < 1e-15);
        assert_eq!(fresnel.reflectance(0.0, 1.0), 1.0);
    }
    // Brewster's angle: p-polarised light vanishes, and half of the s-polarised share ((η²−1)/(η²+1))² is left.
    let eta: f64 = 1.5;
    let brewster = Fresnel::Exact.reflectance(eta.atan().cos(), eta);
    let expected = 0.5 * ((eta * eta - 1.0) / (eta * eta + 1.0)).powi(2);
    assert!((brewster - expected).abs() < 1e-15);
    // Snell and the two polarisations, the long way.
    for deg in [10.0, 45.0, 60.0, 75.0, 85.0, 89.9_f64] {
        let (theta_i, c) = (deg.to_radians(), deg.to_radians().cos());
        let ct = (theta_i.sin() / eta).asin().cos();
        let s = ((c - eta * ct) / (c + eta * ct)).powi(2);
        let p = ((eta * c - ct) / (eta * c + ct)).powi(2);
        assert!((Fresnel::Exact.reflectance(c, eta) - 0.5 * (s + p)).abs() < 1e-14);
    }
    assert_eq!(Fresnel::None.reflectance(0.3, 1.5), 1.0);
}

#[test]
fn schlick_is_the_polynomial() {
    let r = Fresnel::Schlick.reflectance(0.5, 2.0);
    let r0 = 1.0 / 9.0;
    assert!((r - (r0 + (1.0 - r0) / 32.0)).abs() < 1e-15);
}

proptest! {
    #[test]
    fn combined_contains_both_others(
        theta_i in 0.0..1.57, theta_o in 0.0..1.57, phi in 0.0..6.3, log_s in -1.0..4.0,
        fresnel in prop::sample::select(fresnel::FRESNELS.to_vec()),
    ) {
        let c = Cosines::from_directions(direction(theta_i, 0.0), direction(theta_o, phi));
        let s = 10f64.powf(log_s);
        for (key, ratio, alpha) in [("phong", 1.0, 0.0), ("blinn-phong", 4.0, 1.0)] {
            let one = brdf(key, fresnel, s * ratio, 0.7).eval(&c);
            let combined = brdf("combined", fresnel, s, alpha).eval(&c);
            for k in 0..3 {
                // The logarithms of both differ by rounding, which the exponent multiplies.
                let tolerance = 1e-14 * (100.0 + s);
                prop_assert!((one[k] - combined[k]).abs() <= tolerance, "{key} {:?} {:?}", one, combined);
            }
        }
    }

    #[test]
    fn models_are_reciprocal(
        theta_i in 0.0..1.57, theta_o in 0.0..1.57, phi in 0.0..6.3, alpha in 0.0..1.0,
    ) {
        let (wi, wo) = (direction(theta_i, 0.0), direction(theta_o, phi));
        for model in MODELS {
            let b = brdf(model.key, Fresnel::Exact, 20.0, alpha);
            let (there, back) = (
                b.eval(&Cosines::from_directions(wi, wo)),
                b.eval(&Cosines::from_directions(wo, wi)),
            );
            prop_assert!((there[0] - back[0]).abs() <= 1e-12 * there[0]);
        }
    }
}

#[test]
fn switching_models_keeps_the_look_where_one_contains_the_other() {
    let c = Cosines::from_directions(direction(1.2, 0.0), direction(1.0, 2.8));
    let combined = Model::by_key("combined").expect("a model");
    for key in ["phong", "blinn-phong"] {
        let before = brdf(key, Fresnel::Exact, 40.0, 0.3);
        let after = before.with_model(combined);
        assert!((before.eval(&c)[1] / after.eval(&c)[1] - 1.0).abs() < 1e-12);
        assert_eq!(
            after.with_model(before.model).params.lobe[0],
            before.params.lobe[0]
        );
    }
    // Phong against Blinn-Phong: the same highlight seen from above, up to the next order of the angle.
    let phong = brdf("phong", Fresnel::None, 2000.0, 0.0);
    let blinn = phong.with_model(Model::by_key("blinn-phong").expect("a model"));
    let near = Cosines::from_directions(DVec3::Z, direction(0.03, 0.0));
    assert!((phong.eval(&near)[0] / blinn.eval(&near)[0] - 1.0).abs() < 1e-3);
}

#[test]
fn amplitude_and_normalised_reflectance_agree() {
    let phong = brdf("phong", Fresnel::None, 10.0, 0.0);
    let rho_s = phong.rho_s().expect("normalised");
    assert!((rho_s[0] * 12.0 / (2.0 * PI) - 1.0).abs() < 1e-15);
    let blinn = brdf("blinn-phong", Fresnel::None, 10.0, 0.0);
    assert!((blinn.rho_s().expect("normalised")[1] * 18.0 / (8.0 * PI) - 2.0).abs() < 1e-15);
    assert_eq!(brdf("combined", Fresnel::None, 10.0, 0.5).rho_s(), None);
    assert!((brdf("phong", Fresnel::Exact, 1.0, 0.0).specular_at_normal()[0] - 0.04).abs() < 1e-15);
}

#[test]
fn json_round_trips_and_says_what_is_wrong() {
    for model in MODELS {
        for fresnel in fresnel::FRESNELS {
            let b = brdf(model.key, fresnel, 8.5, 0.25);
            let back = json::from_text(&json::to_value(&b).to_string(), 0).expect("reads back");
            for row in b.used() {
                assert_eq!(back.get(row.id), b.get(row.id));
            }
            assert_eq!((back.model, back.fresnel), (b.model, b.fresnel));
        }
    }
    let said = |text: &str, index| {
        json::from_text(text, index)
            .expect_err("is wrong")
            .to_string()
    };
    assert!(said("{", 0).starts_with("not valid JSON"));
    assert!(said("[]", 0).contains("empty"));
    assert!(said("[{},{}]", 2).contains("there is no entry 2; the array has 2"));
    assert!(said("3", 0).contains("found a number"));
    assert!(said("{}", 0).contains("phong, blinn-phong, combined"));
    assert!(said(r#"{"model":"wart"}"#, 0).contains("unknown model \"wart\""));
    let phong = |rest: &str| said(&format!(r#"{{"model":"phong",{rest}}}"#), 0);
    assert!(
        phong(r#""Fresnel":"exact""#).contains("unknown key \"Fresnel\"; expected \"fresnel\"")
    );
    assert!(phong(r#""fresnl":"exact""#).contains("expected \"fresnel\""));
    assert!(phong(r#""fresnel":"exakt""#).ends_with("did you mean `exact`?"));
    assert!(said(r#"{"model":"blin-phong"}"#, 0).ends_with("did you mean `blinn-phong`?"));
    let alpha = r#"{"model":"combined","rho_d":[0,0,0],"k_s":[0,0,1],"s":9,"alhpa":1}"#;
    assert!(said(alpha, 0).ends_with("there is \"alhpa\": did you mean `alpha`?"));
    assert!(
        phong(r#""roughness":0.1"#)
            .ends_with("phong has no \"roughness\"; it has rho_d, k_s, s, eta")
    );
    assert!(
        !phong(r#""alpha":0.1,"roughness":null"#).contains("has no"),
        "old files have them"
    );
    assert!(phong(r#""fresnel":"cook""#).contains("none, exact, schlick"));
    assert!(phong(r#""rho_d":[0.1,0.2]"#).contains("three numbers"));
    assert!(phong(r#""rho_d":[0,0,0],"k_s":[0,0,-1],"s":1"#).contains("out of range"));
    assert!(phong(r#""rho_d":[0,0,0],"k_s":[0,0,1],"s":0"#).contains("\"s\" = 0"));
    assert!(
        phong(r#""rho_d":[0,0,0],"k_s":[0,0,1]"#).contains("\"s\" (specular exponent) is missing")
    );
}
