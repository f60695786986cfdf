use super::frame::distance;
use super::*;
use crate::figure::cosine::CosineFactor;
use crate::figure::drawing::{Item, Point};
use crate::figure::mark::ProbeMark;
use crate::figure::palette::Role;
use crate::figure::polyline::off_segment;
use crate::figure::scale::{Axis, RADIAL_SCALES, RadialScale};
use crate::figure::subject::{CHANNELS, Channel, Look, Source};
use crate::geom::Cosines;
use crate::geom::Rgb;
use crate::geom::limits::MAX_THETA_I;
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

mod filling;

const SIZE: [f32; 2] = [640.0, 400.0];

/// 0.1 + (wr·wo)^20.
fn closed_form(wi: DVec3, wo: DVec3) -> Option<Rgb> {
    let c = Cosines::from_directions(wi, wo);
    Some([0.1 + c.wr_wo.cos.max(0.0).powi(20); 3])
}

fn curve(f_r: impl Fn(DVec3, DVec3) -> Option<Rgb> + Send + Sync + 'static) -> Subject {
    Subject {
        label: "f".into(),
        look: Look::Measured,
        series: 0,
        hidden: false,
        source: Source::Function(Arc::new(f_r)),
    }
}

/// The polylines of curves; the legend's has two points.
fn drawn(plot: &LobePlot) -> Vec<&Vec<Point>> {
    let lines = plot.drawing.items.iter().filter_map(|item| match item {
        Item::Line { points, ink, .. } if matches!(ink.role, Role::Series(_)) => Some(points),
        _ => None,
    });
    lines.filter(|points| points.len() > 2).collect()
}

/// Farthest distance of a drawn polyline from 0.1 + cos^20 of the angle to the mirror direction, in shares of the
/// axis, at angles all over it; with a turn put in.
fn worst_distance(scale: RadialScale, cosine: CosineFactor, planted_deg: f64) -> f64 {
    let theta_i = 50f64.to_radians();
    let spec = LobeSpec {
        theta_i: vec![theta_i],
        active: 0,
        scale: scale.into(),
        cosine,
        ..LobeSpec::default()
    };
    let plot = LobePlot::new(&spec, &[curve(closed_form)], SIZE);
    let (frame, lines) = (&plot.frame, drawn(&plot));
    assert_eq!(lines.len(), 1);
    let mut worst: f64 = 0.0;
    for deg in -89..=89 {
        let theta_o = f64::from(deg).to_radians();
        let base = (theta_o - theta_i - planted_deg.to_radians())
            .cos()
            .max(0.0);
        let mut factor = 1.0;
        if cosine.theta_i {
            factor *= theta_i.cos();
        }
        if cosine.theta_o {
            factor *= theta_o.cos();
        }
        let wanted = frame.point(theta_o, factor * (0.1 + base.powi(20)));
        let nearest = lines[0]
            .windows(2)
            .map(|pair| off_segment(wanted, pair[0], pair[1]))
            .fold(f32::MAX, f32::min);
        worst = worst.max(f64::from(nearest / frame.radius));
    }
    worst
}

#[test]
fn curves_are_the_function_on_every_scale() {
    for scale in RADIAL_SCALES {
        for cosine in [
            CosineFactor::NONE,
            CosineFactor::THETA_I,
            CosineFactor::BOTH,
        ] {
            let worst = worst_distance(scale, cosine, 0.0);
            assert!(worst < 1e-4, "{scale:?}: {worst}");
        }
    }
}

#[test]
fn a_lobe_turned_by_a_tenth_of_a_degree_is_caught() {
    for scale in RADIAL_SCALES {
        assert!(worst_distance(scale, CosineFactor::NONE, 0.1) > 5e-4);
    }
}

#[test]
fn where_nothing_was_measured_there_is_a_gap() {
    let gap = |wi: DVec3, wo: DVec3| closed_form(wi, wo).filter(|_| wo.x.abs() >= 0.2);
    let spec = LobeSpec {
        theta_i: vec![0.7],
        active: 0,
        ..LobeSpec::default()
    };
    let plot = LobePlot::new(&spec, &[curve(gap)], SIZE);
    let lines = drawn(&plot);
    assert_eq!(lines.len(), 2);
    for point in lines.into_iter().flatten() {
        let (theta_o, value) = plot.frame.locate(*point).expect("in the disc");
        assert!(theta_o.sin().abs() >= 0.2 - 1e-4 && value > 0.09);
    }
    let whole = LobePlot::new(&spec, &[curve(closed_form)], SIZE);
    assert_eq!(drawn(&whole).len(), 1);
    let nan = |_: DVec3, _: DVec3| Some([f64::NAN; 3]);
    let none = LobePlot::new(&spec, &[curve(nan)], SIZE);
    assert!(drawn(&none).is_empty());
    let said: Vec<String> = none.drawing.labels().map(|l| l.text.plain()).collect();
    assert!(said.contains(&"No value at these angles.".to_owned()));
}

#[test]
fn past_a_fixed_limit_curves_end_on_the_rim() {
    let spec = LobeSpec {
        theta_i: vec![0.7],
        active: 0,
        limits: Some([0.0, 0.5]),
        scale: LobeScale::Linear,
        ..LobeSpec::default()
    };
    let plot = LobePlot::new(&spec, &[curve(closed_form)], SIZE);
    let (frame, lines) = (&plot.frame, drawn(&plot));
    assert_eq!((frame.axis.limit, lines.len()), (0.5, 2));
    let radius = |p: Point| distance(p, frame.origin) / frame.radius;
    assert!((radius(lines[0][lines[0].len() - 1]) - 1.0).abs() < 1e-4);
    assert!((radius(lines[1][0]) - 1.0).abs() < 1e-4);
    assert!(lines.into_iter().flatten().all(|p| radius(*p) < 1.0 + 1e-4));
}

#[test]
fn narrow_lobes_keep_their_peak() {
    let narrow = |wi: DVec3, wo: DVec3| {
        let mirrored = DVec3::new(-wi.x, -wi.y, wi.z);
        Some([(-1e5 * 0.5 * (mirrored - wo).length_squared()).exp(); 3])
    };
    let spec = LobeSpec {
        theta_i: vec![0.7123],
        active: 0,
        scale: LobeScale::CubeRoot,
        ..LobeSpec::default()
    };
    let plot = LobePlot::new(&spec, &[curve(narrow)], SIZE);
    let (theta_o, value) = plot.traces[0].peak().expect("has values");
    assert!((theta_o - 0.7123).abs() < 1e-12 && (value - 1.0).abs() < 1e-9);
    assert_eq!(plot.frame.axis.limit, 1.0);
}

#[test]
fn points_and_angles_lead_back_to_each_other() {
    for scale in RADIAL_SCALES {
        let frame = LobeFrame {
            origin: [320.0, 350.0],
            radius: 300.0,
            axis: Axis::new(scale, 8.0, Some(1e-2)),
            theta_i: vec![],
        };
        for deg in [-89.0, -30.0, 0.0, 45.0, 89.0_f64] {
            for value in [0.1, 1.0, 7.9] {
                let there = frame.point(deg.to_radians(), value);
                let (theta_o, back) = frame.locate(there).expect("in the disc");
                assert!((theta_o.to_degrees() - deg).abs() < 0.01);
                assert!(
                    (back / value - 1.0).abs() < 1e-3,
                    "{scale:?} {value} {back}"
                );
            }
        }
        // To the right is positive, up is the normal.
        assert!(frame.point(1.0, 8.0)[0] > 320.0 && frame.point(0.0, 8.0)[1] < 60.0);
        assert_eq!(frame.locate([320.0, 351.0]), None);
        assert_eq!(frame.locate([20.0, 100.0]), None);
    }
}

#[test]
fn the_light_can_be_taken_where_it_is_drawn() {
    let spec = LobeSpec {
        theta_i: vec![0.3, 1.2],
        ..LobeSpec::default()
    };
    let frame = LobePlot::new(&spec, &[], SIZE).frame;
    for (index, theta_i) in spec.theta_i.iter().enumerate() {
        let point = frame.handle(*theta_i);
        assert!(point[0] < frame.origin[0]);
        assert_eq!(frame.nearest_light(point, 10.0), Some(index));
        assert!((frame.theta_i_at(point) - theta_i).abs() < 1e-6);
    }
    assert_eq!(frame.nearest_light(frame.at(0.3, 1.0), 10.0), None);
    assert_eq!(frame.theta_o_at([SIZE[0] / 2.0, SIZE[1] - 1.0]), None);
    assert_eq!(frame.theta_i_at([SIZE[0], 10.0]), 0.0);
    assert_eq!(frame.theta_i_at([0.0, SIZE[1]]), MAX_THETA_I);
}

#[test]
fn hidden_subjects_count_for_nothing_and_keep_their_name() {
    let plot = |hidden| {
        let model = Subject {
            label: "high".into(),
            look: Look::Model,
            hidden,
            ..curve(|_: DVec3, _: DVec3| Some([50.0; 3]))
        };
        let spec = LobeSpec {
            scale: LobeScale::CubeRoot,
            ..LobeSpec::default()
        };
        LobePlot::new(&spec, &[curve(closed_form), model], SIZE)
    };
    assert_eq!(plot(false).frame.axis.limit, 50.0);
    let hidden = plot(true);
    assert_eq!(hidden.frame.axis.limit, 1.5);
    let name = hidden.drawing.labels().find(|l| l.text.plain() == "high");
    assert!(name.is_some_and(|label| label.ink.opacity < 0.5));
    let [min, max] = hidden.legend[1].bounds;
    let middle = [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])];
    assert_eq!(
        crate::figure::legend::subject_at(&hidden.legend, middle),
        Some(1)
    );
}

/// Dash and colour of the lines of each curve of a plot with a measurement, a model and four fits beside it.
fn looks() -> Vec<(Option<[f32; 2]>, Role)> {
    let beside = [(1, false), (1, true), (2, false), (2, true)].map(|(series, long)| Subject {
        look: Look::Beside { long },
        series,
        ..curve(closed_form)
    });
    let model = Subject {
        look: Look::Model,
        ..curve(closed_form)
    };
    let mut curves = vec![curve(closed_form), model];
    curves.extend(beside);
    let plot = LobePlot::new(&LobeSpec::default(), &curves, SIZE);
    let mut looks = Vec::new();
    for item in &plot.drawing.items {
        if let Item::Line { dash, ink, .. } = item
            && matches!(ink.role, Role::Series(_))
            && !looks.contains(&(*dash, ink.role))
        {
            looks.push((*dash, ink.role));
        }
    }
    looks
}

#[test]
fn fits_beside_the_model_all_look_different() {
    let looks = looks();
    assert_eq!(looks.len(), 6, "{looks:?}");
    assert_eq!(looks.iter().filter(|(dash, _)| dash.is_none()).count(), 1);
}

/// Pairs of texts that overlap, and texts that stick out.
fn clashes(drawing: &Drawing) -> Vec<String> {
    let labels: Vec<_> = drawing.labels().collect();
    let mut clashes = Vec::new();
    for (k, a) in labels.iter().enumerate() {
        let [min, max] = a.bounds();
        if min[0] < 0.0 || min[1] < 0.0 || max[0] > drawing.size[0] || max[1] > drawing.size[1] {
            clashes.push(format!("{} outside", a.text.plain()));
        }
        for b in &labels[..k] {
            let [bmin, bmax] = b.bounds();
            if (0..2).all(|axis| min[axis] < bmax[axis] && bmin[axis] < max[axis]) {
                clashes.push(format!("{} on {}", a.text.plain(), b.text.plain()));
            }
        }
    }
    clashes
}

#[test]
fn no_text_covers_another_in_any_size() {
    for size in [
        [250.0, 200.0],
        [300.0, 600.0],
        [900.0, 250.0],
        [640.0, 400.0],
        [1200.0, 900.0],
    ] {
        for scale in RADIAL_SCALES {
            for theta_i_deg in [[0.0, 45.0, 80.0], [30.0, 60.0, 85.0], [1.0, 2.0, 89.5]] {
                for probe in [None, Some(0.4), Some(-1.56)] {
                    let spec = LobeSpec {
                        theta_i: theta_i_deg.map(f64::to_radians).to_vec(),
                        scale: scale.into(),
                        probe: probe.map(|at| ProbeMark { at, exact: true }),
                        ..LobeSpec::default()
                    };
                    let long = Subject {
                        label: "a rather long name of a material (synthetic)".into(),
                        ..curve(closed_form)
                    };
                    let plot = LobePlot::new(&spec, &[long, curve(closed_form)], size);
                    let clashes = clashes(&plot.drawing);
                    assert!(clashes.is_empty(), "{size:?} {spec:?}: {clashes:?}");
                    assert!(plot.frame.radius > 0.3 * size[0].min(1.2 * size[1]));
                }
            }
        }
    }
}

#[test]
fn a_text_drawn_twice_is_caught() {
    let mut drawing = LobePlot::new(&LobeSpec::default(), &[], SIZE).drawing;
    assert_eq!(clashes(&drawing), Vec::<String>::new());
    let mut texts = drawing
        .items
        .iter()
        .filter(|item| matches!(item, Item::Text(_)));
    let first = texts.next().cloned().expect("has a title");
    drawing.items.push(first);
    assert_eq!(clashes(&drawing).len(), 1);
}

#[test]
fn every_size_is_drawn_with_finite_numbers() {
    for size in [[0.0, 0.0], [60.0, 60.0], [900.0, 150.0], [1e4, 1e4]] {
        for theta_i in [vec![], vec![0.0], vec![FRAC_PI_2]] {
            let spec = LobeSpec {
                theta_i,
                active: 7,
                probe: Some(ProbeMark {
                    at: 0.4,
                    exact: true,
                }),
                ..LobeSpec::default()
            };
            let drawing = LobePlot::new(&spec, &[curve(closed_form)], size).drawing;
            for item in &drawing.items {
                let points = match item {
                    Item::Line { points, .. } | Item::Fill { points, .. } => points.clone(),
                    Item::Dot { center, .. } => vec![*center],
                    Item::Text(label) => vec![label.pos],
                    Item::Image(picture) => vec![picture.min, picture.max],
                };
                assert!(points.iter().flatten().all(|x| x.is_finite()));
            }
        }
    }
}

#[test]
fn channels_are_found_by_key() {
    for channel in CHANNELS {
        assert_eq!(Channel::by_key(channel.key()), Some(channel));
    }
    assert_eq!(
        [Channel::R, Channel::G, Channel::B].map(|c| c.of([1.0, 2.0, 3.0])),
        [1.0, 2.0, 3.0]
    );
}
