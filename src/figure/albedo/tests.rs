use super::*;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, Model, Params};
use crate::figure::drawing::Item;
use crate::figure::plot::tests::{SIZES, clashes, strays, subject};
use std::f64::consts::PI;
use std::sync::Arc;

fn function(value: f64) -> Source {
    Source::Function(Arc::new(move |_, _| Some([value / PI; 3])))
}

fn points(albedo: impl Fn(f64) -> f64) -> Vec<AlbedoPoint> {
    let angles = angles().into_iter();
    angles
        .map(|theta_i| AlbedoPoint {
            theta_i,
            rgb: [albedo(theta_i); 3],
            measured: 0.9,
        })
        .collect()
}

#[test]
fn angles_reach_from_normal_to_grazing() {
    let angles = angles();
    assert!(angles.is_sorted() && angles[0] == 0.0);
    assert!((angles[angles.len() - 1].to_degrees() - 89.0).abs() < 1e-9);
}

#[test]
fn lambert_is_flat_whatever_it_is_made_of() {
    let lambert = Brdf {
        model: Model::by_key("phong").expect("a model"),
        fresnel: Fresnel::None,
        params: Params {
            rho_d: [0.4; 3],
            k_s: [0.0; 3],
            lobe: lobe_values([10.0, 0.0]),
            eta: 1.5,
        },
    };
    for source in [Source::Model(lambert), function(0.4)] {
        let curve = curve(&source, || ControlFlow::Continue(())).expect("not stopped");
        let off = |wanted: f64| {
            let distances = curve.iter().map(|p| (p.rgb[1] / wanted - 1.0).abs());
            distances.fold(0.0, f64::max)
        };
        assert!(off(0.4) < 1e-3, "{}", off(0.4));
        assert!(off(0.401) > 1e-3);
    }
    let mut count = 0;
    let stopped = curve(&function(0.4), || {
        count += 1;
        ControlFlow::Break(())
    });
    assert_eq!((stopped, count), (None, 1));
}

fn texts(plot: &AlbedoPlot) -> Vec<String> {
    plot.drawing.labels().map(|l| l.text.plain()).collect()
}

/// A plot of albedos that rise to `end` at 90°.
fn rising(end: f64, size: [f32; 2]) -> AlbedoPlot {
    let subjects = [
        subject("chrome", Look::Measured, 0),
        subject("Combined", Look::Model, 0),
    ];
    let (measured, model) = (points(|_| 0.5), points(|x| end * x / FRAC_PI_2));
    let curve = |points| AlbedoCurve { points, old: false };
    let spec = AlbedoSpec {
        probe: Some(ProbeMark {
            at: 0.3,
            exact: false,
        }),
        ..AlbedoSpec::default()
    };
    AlbedoPlot::new(&spec, &subjects, &[curve(&measured), curve(&model)], size)
}

#[test]
fn more_than_all_the_light_is_flagged() {
    let size = [700.0, 400.0];
    let flagged = |plot: &AlbedoPlot| {
        let accent =
            |item: &&Item| matches!(item, Item::Line { ink, .. } if ink.role == Role::Accent);
        plot.drawing.items.iter().filter(accent).count()
    };
    let over = rising(2.0, size);
    assert_eq!(flagged(&over), 1);
    let said = texts(&over);
    // 2 x / 90° is 1 at 45°.
    let wanted = "Combined exceeds 1 at θi = 45°…89°";
    assert!(said.contains(&wanted.to_owned()), "{said:?}");
    assert!(said.contains(&"measured share".to_owned()));
    assert_eq!(over.frame.y.limit, 2.0);
    let under = rising(0.99, size);
    assert_eq!(flagged(&under), 0);
    assert!(!texts(&under).iter().any(|text| text.contains("exceeds")));
    assert_eq!(under.frame.y.limit, 1.1);
}

#[test]
fn hidden_and_unknown_curves_are_not_drawn() {
    let mut hidden = subject("chrome", Look::Measured, 0);
    hidden.hidden = true;
    let high = points(|_| 7.0);
    let curve = AlbedoCurve {
        points: &high,
        old: true,
    };
    let plot = AlbedoPlot::new(&AlbedoSpec::default(), &[hidden], &[curve], [700.0, 400.0]);
    assert_eq!(plot.frame.y.limit, 1.1);
    let waiting = AlbedoPlot::new(
        &AlbedoSpec::default(),
        &[subject("chrome", Look::Measured, 0)],
        &[AlbedoCurve::default()],
        [700.0, 400.0],
    );
    assert!(texts(&waiting).contains(&"Computing the albedo…".to_owned()));
}

#[test]
fn no_text_covers_another_in_any_size() {
    for size in SIZES {
        for end in [0.5, 1.02, 3.0] {
            let plot = rising(end, size);
            let clashes = clashes(&plot.drawing);
            assert!(clashes.is_empty(), "{size:?} {end}: {clashes:?}");
            assert!(!strays(&plot.drawing));
            let point = plot.frame.point(30.0, 0.4);
            let theta_i = plot.theta_i_at(point).expect("inside");
            assert!((theta_i.to_degrees() - 30.0).abs() < 0.05);
        }
    }
}
