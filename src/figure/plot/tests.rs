use super::*;
use crate::figure::drawing::Item;
use crate::figure::scale::{Axis, RADIAL_SCALES, RadialScale, Steps};
use crate::figure::subject::{Look, Source, Subject};
use std::sync::Arc;

/// Sizes from the smallest tile to a whole screen.
pub(in crate::figure) const SIZES: [[f32; 2]; 5] = [
    [300.0, 200.0],
    [300.0, 600.0],
    [700.0, 400.0],
    [1200.0, 240.0],
    [1900.0, 1000.0],
];

pub(in crate::figure) fn subject(label: &str, look: Look, series: usize) -> Subject {
    Subject {
        label: label.into(),
        look,
        series,
        hidden: false,
        source: Source::Function(Arc::new(|_, _| Some([0.5; 3]))),
    }
}

/// Pairs of texts that overlap, and texts that stick out.
pub(in crate::figure) fn clashes(drawing: &Drawing) -> Vec<String> {
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

/// Whether a number of the drawing is not finite, or a line leaves it.
pub(in crate::figure) fn strays(drawing: &Drawing) -> bool {
    drawing.items.iter().any(|item| {
        let points = match item {
            Item::Line { points, .. } | Item::Fill { points, .. } => points.clone(),
            Item::Dot { center, .. } => vec![*center],
            Item::Image(picture) => vec![picture.min, picture.max],
            Item::Text(label) => vec![label.pos],
        };
        points.iter().any(|point| {
            (0..2).any(|k| !(-1.0..=drawing.size[k].max(80.0) + 1.0).contains(&point[k]))
        })
    })
}

fn outline(subjects: &[Subject], scale: RadialScale, ends: [f64; 2]) -> Outline<'_> {
    Outline {
        title: vec![
            "f_{r} [sr^{−1}], all of it, at length".into(),
            "f_{r}".into(),
        ],
        subjects,
        x: Axis::between(RadialScale::Linear, -90.0, 90.0),
        x_steps: Steps::Degrees,
        x_names: Vec::new(),
        x_name: "θ_{o} [°]".into(),
        panels: vec![
            Panel {
                axis: Axis::between(scale, ends[0], ends[1]),
                height: 3.0,
                title: vec![],
            },
            Panel {
                axis: Axis::between(RadialScale::CubeRoot, -2.0, 2.0),
                height: 1.0,
                title: vec!["difference".into()],
            },
        ],
    }
}

#[test]
fn values_and_points_lead_back_to_each_other() {
    for scale in RADIAL_SCALES {
        let plot = Plot::new(&outline(&[], scale, [1e-2, 300.0]), [700.0, 400.0]);
        let frame = plot.frames[0];
        for x in [-90.0, -12.5, 0.0, 77.0] {
            for y in [0.011, 1.0, 250.0] {
                let [back_x, back_y] = frame.locate(frame.point(x, y)).expect("inside");
                assert!((back_x - x).abs() < 0.01, "{back_x} {x}");
                let (a, b) = (frame.y.share(y), frame.y.share(back_y));
                assert!((a - b).abs() < 1e-5 && frame.shows(x, y));
            }
        }
        // A planted shift by a point is seen.
        let [x, y] = frame.point(0.0, 1.0);
        let shifted = frame.locate([x + 1.0, y]).expect("inside");
        assert!((shifted[0] - 0.0).abs() > 0.01);
        assert_eq!(frame.locate([frame.max[0] + 1.0, y]), None);
        assert!(!frame.shows(91.0, 1.0) && !frame.shows(0.0, 301.0));
    }
}

#[test]
fn no_text_covers_another_in_any_size() {
    let few = [
        subject("chrome", Look::Measured, 0),
        subject("Phong", Look::Model, 0),
    ];
    let long = "a rather long name of a material (synthetic)";
    let many: Vec<Subject> = (0..9).map(|k| subject(long, Look::Model, k)).collect();
    for size in SIZES {
        for subjects in [&[][..], &few, &many] {
            for scale in RADIAL_SCALES {
                for ends in [[1e-3, 2e4], [0.3, 0.4], [5.0, 50.0]] {
                    let mut plot = Plot::new(&outline(subjects, scale, ends), size);
                    plot.axes();
                    let [_, height] = plot.frames[0].size();
                    let least = if subjects.len() > 2 { 0.15 } else { 0.25 };
                    assert!(height > least * size[1], "{height} of {size:?}");
                    let (drawing, legend) = plot.finish();
                    assert_eq!(legend.len(), subjects.len());
                    let clashes = clashes(&drawing);
                    assert!(
                        clashes.is_empty(),
                        "{size:?} {scale:?} {ends:?}: {clashes:?}"
                    );
                    assert!(!strays(&drawing));
                }
            }
        }
    }
}

#[test]
fn a_text_drawn_twice_is_caught() {
    let plot = Plot::new(&outline(&[], RadialScale::Log, [0.1, 1.0]), SIZES[2]);
    let (mut drawing, _) = plot.finish();
    let title = drawing.items.first().cloned().expect("a title");
    drawing.items.push(title);
    assert_eq!(clashes(&drawing).len(), 1);
}

#[test]
fn names_stand_behind_the_title_where_they_fit() {
    let few = [
        subject("Copper glaze (synthetic)", Look::Measured, 0),
        subject("Phong", Look::Model, 0),
    ];
    let rows = |size| {
        let plot = Plot::new(&outline(&few, RadialScale::Log, [0.1, 1.0]), size);
        let (drawing, legend) = plot.finish();
        let title = drawing.labels().next().expect("a title").bounds();
        legend
            .iter()
            .filter(|entry| entry.bounds[0][1] > title[1][1] - 1.0)
            .count()
    };
    assert_eq!(rows([700.0, 400.0]), 0);
    assert_eq!(rows([300.0, 200.0]), 2);
}

#[test]
fn a_curve_is_broken_in_gaps_and_cut_at_the_frame() {
    let mut plot = Plot::new(&outline(&[], RadialScale::Linear, [0.0, 1.0]), SIZES[2]);
    let before = plot.canvas.drawing.items.len();
    let y = |x: f64| match x.abs() {
        x if x < 10.0 => None,
        x if x < 30.0 => Some(2.0),
        _ => Some(0.5),
    };
    let samples = (-90..=90).map(|x| (f64::from(x), y(f64::from(x))));
    let frame = plot.frames[0];
    plot.curve(0, samples, Pen::thin(Role::Series(0).into()));
    let lines: Vec<_> = plot.canvas.drawing.items[before..].iter().collect();
    assert_eq!(lines.len(), 2, "{lines:?}");
    for item in lines {
        let Item::Line { points, .. } = item else {
            panic!("{item:?}")
        };
        assert!(points.iter().all(|p| p[1] >= frame.min[1] - 1e-3));
        let tops = points.iter().filter(|p| (p[1] - frame.min[1]).abs() < 1e-3);
        assert_eq!(tops.count(), 1);
    }
}

#[test]
fn dots_are_named_and_left_out_where_they_are_not_shown() {
    let mut plot = Plot::new(&outline(&[], RadialScale::Linear, [0.0, 1.0]), SIZES[2]);
    let spot = |x, y, name| PlotDot {
        x,
        y,
        radius: 4.0,
        ink: Role::Series(1).into(),
        name: RichText::literal(name),
    };
    let spots = [
        spot(0.0, 0.5, "nickel"),
        spot(0.4, 0.5, "chrome"),
        spot(0.0, 3.0, "gold"),
    ];
    let places = plot.dots(0, &spots);
    assert_eq!(places[0], Some(plot.frames[0].point(0.0, 0.5)));
    assert_eq!(places[2], None);
    let (drawing, _) = plot.finish();
    let names: Vec<String> = drawing.labels().map(|label| label.text.plain()).collect();
    assert!(names.contains(&"nickel".into()) && names.contains(&"chrome".into()));
    assert!(!names.contains(&"gold".into()) && clashes(&drawing).is_empty());
}

#[test]
fn sizes_without_room_are_drawn_with_finite_numbers() {
    let subjects = [subject("chrome", Look::Measured, 0)];
    for size in [[0.0, 0.0], [60.0, 60.0], [30.0, 900.0]] {
        let mut plot = Plot::new(&outline(&subjects, RadialScale::Log, [1.0, 1.0]), size);
        plot.shade(-90.0, -80.0, Role::Faint.into());
        plot.axes();
        plot.level(0, 1.0, Pen::thin(Role::Muted.into()));
        plot.upright(0.0, Pen::thin(Role::Muted.into()));
        let (drawing, _) = plot.finish();
        let finite = |item: &Item| match item {
            Item::Line { points, .. } | Item::Fill { points, .. } => {
                points.iter().flatten().all(|x| x.is_finite())
            }
            _ => true,
        };
        assert!(drawing.items.iter().all(finite));
    }
}
