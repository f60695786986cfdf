use super::draw::grazing_regions;
use super::*;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, Model, Params};
use crate::figure::cosine::CosineFactor;
use crate::figure::drawing::Item;
use crate::figure::palette::Role;
use crate::figure::plot::tests::subject;
use crate::figure::samples;
use crate::figure::subject::{Channel, Look, Source};
use crate::geom::HalfDiff;
use std::sync::Arc;

mod looks;

const SIZE: [f32; 2] = [700.0, 400.0];

fn brdf(key: &str, s: f64) -> Brdf {
    Brdf {
        model: Model::by_key(key).expect("a model"),
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.3, 0.2, 0.1],
            k_s: [2.0, 1.0, 0.5],
            lobe: lobe_values([s, 0.4]),
            eta: 1.5,
        },
    }
}

fn model(brdf: Brdf) -> Subject {
    Subject {
        source: Source::Model(brdf),
        ..subject("model", Look::Model, 0)
    }
}

fn constant(look: Look, series: usize, value: f64) -> Subject {
    Subject {
        source: Source::Function(Arc::new(move |_, _| Some([value; 3]))),
        ..subject("constant", look, series)
    }
}

fn spec(over: Over) -> SliceSpec {
    SliceSpec {
        over,
        theta_h: 0.2,
        theta_d: 0.9,
        phi_d: 1.2,
        ..SliceSpec::default()
    }
}

/// Largest relative distance of the plotted numbers from the formula in half and difference angles, with a turn put in.
fn worst(over: Over, cosine: CosineFactor, planted: f64) -> f64 {
    let brdf = brdf("combined", 30.0);
    let spec = SliceSpec {
        cosine,
        channel: Channel::G,
        ..spec(over)
    };
    let plot = SlicePlot::new(&spec, &[model(brdf)], SIZE);
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for sample in &plot.traces[0].samples {
        let x = sample.x + planted;
        let angles = match over {
            Over::ThetaO => {
                // In the plane of incidence: θh and θd are half the sum and half the difference of the signed angles.
                let theta_i = spec.theta_i[0];
                HalfDiff {
                    theta_h: 0.5 * (x - theta_i).abs(),
                    theta_d: 0.5 * (x + theta_i).abs(),
                    phi_d: if (x > theta_i) == (x + theta_i > 0.0) {
                        std::f64::consts::PI
                    } else {
                        0.0
                    },
                }
            }
            Over::ThetaH => HalfDiff {
                theta_h: x,
                theta_d: 0.9,
                phi_d: 1.2,
            },
            Over::ThetaD => HalfDiff {
                theta_h: 0.2,
                theta_d: x,
                phi_d: 1.2,
            },
            Over::PhiD => HalfDiff {
                theta_h: 0.2,
                theta_d: 0.9,
                phi_d: x,
            },
        };
        let cosines = angles.cosines();
        let Some(value) = sample.value else {
            assert!(cosines.cos_theta_i.min(cosines.cos_theta_o) < 1e-9, "{x}");
            continue;
        };
        let mut factor = 1.0;
        if cosine.theta_i {
            factor *= cosines.cos_theta_i;
        }
        if cosine.theta_o {
            factor *= cosines.cos_theta_o;
        }
        let wanted = factor * brdf.eval(&cosines)[1];
        count += 1;
        worst = worst.max((value - wanted).abs() / (wanted.abs() + 1e-6));
    }
    assert!(count > 300, "{count}");
    worst
}

#[test]
fn slices_are_the_formula_over_every_angle() {
    for over in OVERS {
        for cosine in [
            CosineFactor::NONE,
            CosineFactor::THETA_I,
            CosineFactor::BOTH,
        ] {
            let worst = worst(over, cosine, 0.0);
            assert!(worst < 1e-6, "{over:?}: {worst}");
        }
    }
}

#[test]
fn a_slice_at_another_angle_is_caught() {
    for over in OVERS {
        assert!(worst(over, CosineFactor::NONE, 1e-3) > 1e-4, "{over:?}");
    }
}

#[test]
fn values_are_those_of_the_source() {
    for over in OVERS {
        let (spec, subject) = (spec(over), model(brdf("phong", 40.0)));
        let plot = SlicePlot::new(&spec, std::slice::from_ref(&subject), SIZE);
        for sample in &plot.traces[0].samples {
            let (wi, wo) = spec.pair(0, sample.x);
            let f_r = subject.source.f_r(wi, wo);
            assert_eq!(sample.value, f_r.map(|rgb| Channel::Luminance.of(rgb)));
        }
    }
}

#[test]
fn the_sharpest_peak_is_not_missed_at_any_zoom() {
    for key in ["phong", "blinn-phong", "combined"] {
        for over in [Over::ThetaO, Over::ThetaH] {
            for (width, window) in [
                (300.0, None),
                (900.0, Some([-0.2, 1.3])),
                (300.0, Some([0.0, 1.1])),
            ] {
                let spec = SliceSpec {
                    window,
                    theta_d: 60f64.to_radians(),
                    ..SliceSpec {
                        over,
                        ..SliceSpec::default()
                    }
                };
                let subject = model(brdf(key, 1e5));
                let highest = if over == Over::ThetaO {
                    spec.theta_i[0]
                } else {
                    0.0
                };
                let wanted = spec.value(&subject, 0, highest).expect("above the horizon");
                let plot = SlicePlot::new(&spec, &[subject], [width, 300.0]);
                let (_, peak) = samples::peak(&plot.traces[0].samples).expect("has values");
                assert!(
                    (peak / wanted - 1.0).abs() < 1e-3,
                    "{key} {over:?} {peak} {wanted}"
                );
                // Half of it is met too, not only the top.
                let upper = samples::values(&plot.traces[0].samples).filter(|x| *x > 0.5 * wanted);
                assert!(upper.count() > 20);
            }
        }
    }
}

#[test]
fn zoomed_in_there_is_a_sample_per_point() {
    let spec = SliceSpec {
        window: Some([-0.5, -0.49]),
        ..SliceSpec::default()
    };
    let plot = SlicePlot::new(&spec, &[model(brdf("phong", 10.0))], SIZE);
    let samples = &plot.traces[0].samples;
    assert!(samples.len() >= 700);
    assert!(
        samples
            .iter()
            .all(|s| (-0.5 - 1e-12..=-0.49 + 1e-12).contains(&s.x))
    );
    let [low, high] = [plot.frame.x.floor, plot.frame.x.limit].map(f64::to_radians);
    assert!((low + 0.5).abs() < 1e-12 && (high + 0.49).abs() < 1e-12);
}

/// Differences and ratios of 1.5 against 2 and 3 against 6, and of fits of 2.5 and 4 beside.
fn residual_values(residual: Residual) -> Vec<(usize, usize, f64)> {
    let spec = SliceSpec {
        residual,
        cosine: CosineFactor::THETA_I,
        theta_i: vec![0.0],
        ..SliceSpec::default()
    };
    let subjects = [
        constant(Look::Measured, 0, 2.0),
        constant(Look::Model, 0, 1.5),
        constant(Look::Beside { long: false }, 1, 2.5),
        constant(Look::Measured, 3, 6.0),
        constant(Look::Model, 3, 3.0),
        constant(Look::Model, 4, 9.0),
        constant(Look::Dashed, 4, 4.0),
    ];
    let plot = SlicePlot::new(&spec, &subjects, SIZE);
    let residuals = plot.residuals.iter();
    residuals
        .map(|r| {
            let value = r.samples[100].value.expect("a value");
            (r.measured, r.model, (1e9 * value).round() / 1e9)
        })
        .collect()
}

#[test]
fn residuals_compare_a_model_with_its_own_material() {
    assert_eq!(
        residual_values(Residual::Difference),
        [(0, 1, -0.5), (0, 2, 0.5), (3, 4, -3.0), (0, 6, 2.0)]
    );
    assert_eq!(
        residual_values(Residual::Ratio),
        [(0, 1, 0.75), (0, 2, 1.25), (3, 4, 0.5), (0, 6, 2.0)]
    );
    assert_eq!(residual_values(Residual::None), []);
}

#[test]
fn residuals_need_both_and_their_axis_is_symmetric() {
    let hidden = |hide: usize| {
        let mut subjects = [
            constant(Look::Measured, 0, 2.0),
            constant(Look::Model, 0, 0.5),
        ];
        if let Some(subject) = subjects.get_mut(hide) {
            subject.hidden = true;
        }
        let spec = SliceSpec {
            residual: Residual::Ratio,
            ..SliceSpec::default()
        };
        SlicePlot::new(&spec, &subjects, SIZE)
    };
    assert!(hidden(0).residuals.is_empty() && hidden(1).residuals.is_empty());
    let strip = hidden(9).strip.expect("a strip");
    assert_eq!(strip.y.limit, 5.0);
    assert!((strip.y.share(1.0) - 0.5).abs() < 1e-9);
    assert!(strip.min[1] > hidden(9).frame.max[1]);
    assert_eq!(strip.min[0], hidden(9).frame.min[0]);
}

#[test]
fn where_nothing_was_measured_there_is_a_gap_and_no_line_to_zero() {
    let gap = Subject {
        source: Source::Function(Arc::new(|_, wo| (wo.x.abs() > 0.2).then_some([3.0; 3]))),
        ..subject("f", Look::Measured, 0)
    };
    let plot = SlicePlot::new(&SliceSpec::default(), &[gap], SIZE);
    let curves = plot.drawing.items.iter().filter_map(|item| match item {
        Item::Line { points, ink, .. } if ink.role == Role::Series(0) => Some(points),
        _ => None,
    });
    // The first is in the legend.
    let curves: Vec<_> = curves.skip(1).collect();
    assert_eq!(curves.len(), 2);
    for point in curves.into_iter().flatten() {
        let [x, y] = plot.frame.shares(*point);
        let (x, y) = (plot.frame.x.value(x), plot.frame.y.value(y));
        assert!(x.to_radians().sin().abs() > 0.199 && (y / 3.0 - 1.0).abs() < 1e-3);
    }
}

#[test]
fn grazing_begins_at_80_degrees_of_view_or_light() {
    let degrees = |spec: &SliceSpec| -> Vec<[f64; 2]> {
        let regions = grazing_regions(spec);
        regions
            .iter()
            .map(|r| r.map(|x| (1e4 * x.to_degrees()).round() / 1e4))
            .collect()
    };
    assert_eq!(degrees(&spec(Over::ThetaO)), [[-90.0, -80.0], [80.0, 90.0]]);
    let at_normal = SliceSpec {
        theta_d: 0.0,
        theta_h: 0.0,
        ..SliceSpec::default()
    };
    for over in [Over::ThetaH, Over::ThetaD] {
        let spec = SliceSpec {
            over,
            ..at_normal.clone()
        };
        assert_eq!(degrees(&spec), [[80.0, 90.0]], "{over:?}");
    }
    // φd = 0: θi and θo are θd ∓ θh.
    let along = SliceSpec {
        over: Over::ThetaD,
        theta_h: 30f64.to_radians(),
        phi_d: 0.0,
        ..SliceSpec::default()
    };
    assert_eq!(degrees(&along), [[50.0, 60.0]]);
    let grazing = SliceSpec {
        theta_i: vec![1.5],
        ..SliceSpec::default()
    };
    assert_eq!(degrees(&grazing), [[-90.0, 90.0]]);
}
