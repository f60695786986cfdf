use super::*;
use crate::figure::drawing::Item;
use crate::figure::scale::RADIAL_SCALES;
use crate::geom::Cosines;

const SIZE: [f32; 2] = [640.0, 400.0];

/// A closed form: f = 0.1 + (wr·wo)^20.
fn closed_form(wi: DVec3, wo: DVec3) -> Option<Rgb> {
    let c = Cosines::from_directions(wi, wo);
    Some([0.1 + c.wr_wo.cos.powi(20); 3])
}

fn lines_of_series(plot: &LobePlot) -> Vec<&Vec<Point>> {
    let is_curve = |item: &&Item| matches!(item, Item::Line { ink, points, .. } if matches!(ink.role, Role::Series(_)) && points.len() > 2);
    plot.drawing
        .items
        .iter()
        .filter(is_curve)
        .filter_map(|item| match item {
            Item::Line { points, .. } => Some(points),
            _ => None,
        })
        .collect()
}

/// Largest distance between drawn values and the closed form, per axis length, with a shift of the angle put in.
fn worst_distance(scale: RadialScale, planted_deg: f64) -> f64 {
    let theta_i = 50f64.to_radians();
    let spec = LobeSpec {
        theta_i: vec![theta_i],
        scale,
        ..LobeSpec::default()
    };
    let curve = Curve {
        label: "f".into(),
        dashed: false,
        series: 0,
        f_r: &closed_form,
    };
    let plot = LobePlot::new(&spec, &[curve], SIZE);
    let frame = &plot.frame;
    let points = lines_of_series(&plot)[0];
    assert!(points.len() > 700);
    points
        .iter()
        .map(|point| {
            let (theta_o, value) = frame.theta_o_and_value(*point);
            // wr·wo is the cosine of the angle from the mirror direction, which is at +θi.
            let base = (theta_o - theta_i - planted_deg.to_radians())
                .cos()
                .max(0.0);
            let expected = 0.1 + base.powi(20);
            (scale.length(value, frame.limit) - scale.length(expected, frame.limit)).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn curves_are_the_function_on_every_scale() {
    for scale in RADIAL_SCALES {
        assert!(
            worst_distance(scale, 0.0) < 1e-4,
            "{scale:?}: {}",
            worst_distance(scale, 0.0)
        );
    }
}

#[test]
fn a_lobe_turned_by_a_tenth_of_a_degree_is_caught() {
    for scale in RADIAL_SCALES {
        assert!(worst_distance(scale, 0.1) > 1e-3);
    }
}

#[test]
fn where_nothing_was_measured_there_is_a_gap() {
    let gap = |wi: DVec3, wo: DVec3| {
        if wo.x.abs() < 0.2 {
            None
        } else {
            closed_form(wi, wo)
        }
    };
    let curve = Curve {
        label: "f".into(),
        dashed: false,
        series: 0,
        f_r: &gap,
    };
    let spec = LobeSpec::default();
    let plot = LobePlot::new(&spec, &[curve], SIZE);
    let lines = lines_of_series(&plot);
    assert_eq!(lines.len(), 2);
    for point in lines.into_iter().flatten() {
        let (theta_o, _) = plot.frame.theta_o_and_value(*point);
        assert!(
            theta_o.sin().abs() >= 0.2 - 1e-6,
            "a line runs through the gap"
        );
    }
}

#[test]
fn narrow_lobes_keep_their_peak() {
    let narrow = |wi: DVec3, wo: DVec3| {
        let c = Cosines::from_directions(wi, wo);
        Some([c.wr_wo.pow(1e5); 3])
    };
    let curve = Curve {
        label: "f".into(),
        dashed: false,
        series: 0,
        f_r: &narrow,
    };
    let spec = LobeSpec {
        theta_i: vec![0.7123],
        ..LobeSpec::default()
    };
    let plot = LobePlot::new(&spec, &[curve], SIZE);
    assert!((plot.frame.limit / spec.scale.limit(1.0) - 1.0).abs() < 1e-6);
}

#[test]
fn the_light_can_be_taken_where_it_is_drawn() {
    let spec = LobeSpec {
        theta_i: vec![0.3, 1.2],
        ..LobeSpec::default()
    };
    let frame = LobePlot::new(&spec, &[], SIZE).frame;
    for (index, theta_i) in spec.theta_i.iter().enumerate() {
        let point = frame.at(-theta_i, frame::HANDLE);
        assert_eq!(frame.nearest_light(point, 10.0), Some(index));
        assert!((frame.theta_i_at(point) - theta_i).abs() < 1e-6);
    }
    assert_eq!(frame.nearest_light(frame.at(0.3, 1.0), 10.0), None);
    assert_eq!(frame.theta_o_at([SIZE[0] / 2.0, SIZE[1] - 1.0]), None);
}

#[test]
fn every_size_stays_inside_and_finite() {
    let curve = || Curve {
        label: "a rather long name of a material".into(),
        dashed: true,
        series: 3,
        f_r: &closed_form,
    };
    for size in [
        [60.0, 60.0],
        [250.0, 200.0],
        [1200.0, 900.0],
        [900.0, 150.0],
    ] {
        let spec = LobeSpec {
            probe_theta_o: Some(0.4),
            ..LobeSpec::default()
        };
        let plot = LobePlot::new(&spec, &[curve()], size);
        for item in &plot.drawing.items {
            let points: Vec<Point> = match item {
                Item::Line { points, .. } | Item::Fill { points, .. } => points.clone(),
                Item::Dot { center, .. } => vec![*center],
                Item::Text { position, .. } => vec![*position],
            };
            assert!(points.iter().flatten().all(|x| x.is_finite()));
        }
    }
}
