//! Places in the picture, texts, odd specs.

use super::*;
use crate::figure::cosine::CosineFactor;
use crate::figure::mark::ProbeMark;
use crate::figure::plot::tests::{SIZES, clashes, strays};
use crate::figure::scale::RADIAL_SCALES;

#[test]
fn points_and_angles_lead_back_to_each_other() {
    for over in OVERS {
        let spec = SliceSpec {
            residual: Residual::Difference,
            ..spec(over)
        };
        let plot = SlicePlot::new(&spec, &[], SIZE);
        let [low, high] = over.range();
        let x = low + 0.3 * (high - low);
        for frame in [plot.frame, plot.strip.expect("a strip")] {
            let point = frame.at(x.to_degrees(), 0.5);
            assert!((plot.x_at(point).expect("inside") - x).abs() < 1e-3);
        }
        assert_eq!(plot.x_at([1.0, 1.0]), None);
    }
}

#[test]
fn no_text_covers_another_in_any_size() {
    for size in SIZES {
        for over in OVERS {
            for scale in RADIAL_SCALES {
                for (residual, cosine) in [
                    (Residual::None, CosineFactor::NONE),
                    (Residual::Ratio, CosineFactor::BOTH),
                    (Residual::Difference, CosineFactor::THETA_I),
                ] {
                    let spec = SliceSpec {
                        theta_i: [10.0, 45.0, 80.0].map(f64::to_radians).to_vec(),
                        active: 1,
                        scale,
                        residual,
                        cosine,
                        probe: Some(ProbeMark {
                            at: 0.4,
                            exact: true,
                        }),
                        ..spec(over)
                    };
                    let measured = Subject {
                        label: "a rather long name of a material (synthetic)".into(),
                        look: Look::Measured,
                        ..model(brdf("phong", 100.0))
                    };
                    let plot =
                        SlicePlot::new(&spec, &[measured, model(brdf("combined", 90.0))], size);
                    let clashes = clashes(&plot.drawing);
                    assert!(clashes.is_empty(), "{size:?} {spec:?}: {clashes:?}");
                    assert!(!strays(&plot.drawing));
                    assert!(plot.frame.size()[1] > 0.2 * size[1]);
                }
            }
        }
    }
}

#[test]
fn odd_specs_are_drawn() {
    for spec in [
        SliceSpec {
            theta_i: vec![],
            active: 4,
            ..SliceSpec::default()
        },
        SliceSpec {
            window: Some([f64::NAN, 1.0]),
            ..SliceSpec::default()
        },
        SliceSpec {
            window: Some([3.0, -3.0]),
            limits: Some([5.0, -2.0]),
            ..SliceSpec::default()
        },
        SliceSpec {
            limits: Some([f64::NAN, f64::INFINITY]),
            ..spec(Over::PhiD)
        },
    ] {
        let plot = SlicePlot::new(&spec, &[model(brdf("phong", 9.0))], SIZE);
        assert!(!strays(&plot.drawing), "{spec:?}");
    }
}

#[test]
fn keys_are_read_back() {
    for over in OVERS {
        assert_eq!(Over::by_key(over.key()), Some(over));
    }
    for residual in RESIDUALS {
        assert_eq!(Residual::by_key(residual.key()), Some(residual));
    }
}
