use super::*;
use crate::figure::drawing::{Item, Point};
use crate::figure::palette::Role;
use crate::figure::scale::{Axis, RadialScale};

fn spec() -> HeatSpec {
    HeatSpec {
        title: vec!["A long title that needs room".into(), "Short".into()],
        x: Side::angle("θ_{h}", Law::SquareRoot),
        y: Side::angle("θ_{d}", Law::Linear),
        view: HeatView::default(),
        colors: ColorScale::Amount(Axis::new(RadialScale::Linear, 1.0, None)),
        bar_title: "f_{r}".into(),
        missing: "not measured",
        smooth: false,
        square: false,
        curves: Vec::new(),
        spots: Vec::new(),
        nothing: "Nothing to show.",
    }
}

/// 90 × 90 cells: values on the left, missing in the middle, nothing on the right.
fn field() -> HeatField {
    let x = (0..=90).map(|k| f64::from(k * k) / 90.0).collect();
    let y = (0..=90).map(f64::from).collect();
    HeatField::new(x, y, |column, _| match column {
        0..30 => Cell::Value(1.0),
        30..60 => Cell::Missing,
        _ => Cell::Outside,
    })
}

const SIZES: [[f32; 2]; 5] = [
    [300.0, 200.0],
    [700.0, 420.0],
    [1900.0, 1000.0],
    [120.0, 90.0],
    [20.0, 10.0],
];

fn corners(item: &Item) -> Vec<Point> {
    match item {
        Item::Line { points, .. } | Item::Fill { points, .. } => points.clone(),
        Item::Dot { center, .. } => vec![*center],
        Item::Text(label) => vec![label.pos],
        Item::Image(picture) => vec![picture.min, picture.max],
    }
}

#[test]
fn points_and_values_are_each_others_inverse_in_any_view() {
    let views = [
        HeatView::default(),
        HeatView::default().zoomed([0.3, 0.8], 0.25),
        HeatView::default()
            .zoomed([0.9, 0.1], 0.1)
            .moved([-0.5, 0.4]),
    ];
    let mut spec = spec();
    for (view, law) in views
        .into_iter()
        .zip([Law::Linear, Law::SquareRoot, Law::Log])
    {
        spec.view = view;
        spec.x.law = law;
        spec.x.range = (0.1, 90.0);
        let frame = HeatMap::new(&spec, &field(), [700.0, 420.0]).frame;
        for share in [[0.1, 0.2], [0.5, 0.5], [0.93, 0.71]] {
            let point = [0, 1].map(|k| frame.min[k] + share[k] * frame.size()[k]);
            let values = frame.locate(point).expect("inside");
            let back = frame.point(values);
            assert!((0..2).all(|k| (point[k] - back[k]).abs() < 0.01), "{law:?}");
            // Planted: the other axis' view.
            let swapped = HeatFrame {
                view: HeatView {
                    x: view.y,
                    y: view.x,
                },
                ..frame.clone()
            };
            let moved = swapped.point(values);
            let off = (0..2).any(|k| (point[k] - moved[k]).abs() > 0.01);
            assert_eq!(off, view.x != view.y);
        }
        assert_eq!(frame.locate([frame.min[0] - 1.0, frame.max[1] - 5.0]), None);
    }
}

#[test]
fn zooming_keeps_what_is_under_the_pointer_and_stays_inside() {
    let near = HeatView::default().zoomed([0.25, 0.5], 0.5);
    assert_eq!(near.x, (0.125, 0.625));
    assert_eq!(near.y, (0.25, 0.75));
    assert_eq!(near.moved([10.0, -10.0]).x, (0.5, 1.0));
    assert_eq!(near.moved([10.0, -10.0]).y, (0.0, 0.5));
    assert_eq!(near.zoomed([0.5, 0.5], 100.0), HeatView::default());
    let closest = (0..200).fold(HeatView::default(), |view, _| view.zoomed([0.5, 0.5], 0.8));
    assert!(closest.x.1 - closest.x.0 >= 0.0199);
}

#[test]
fn a_cell_is_found_by_its_values() {
    let field = field();
    for (column, row) in [(0, 0), (29, 45), (89, 89)] {
        let middle = [
            0.5 * (field.x[column] + field.x[column + 1]),
            0.5 * (field.y[row] + field.y[row + 1]),
        ];
        assert_eq!(field.find(middle), Some((column, row)));
    }
    assert_eq!(field.find([90.0, 90.0]), Some((89, 89)));
    assert_eq!(field.find([-0.1, 5.0]), None);
}

/// The colours of the picture at shares of the frame from its upper left corner.
fn color_at(map: &HeatMap, [x, y]: [f32; 2]) -> [u8; 4] {
    let image = map.drawing.items.iter().find_map(|item| match item {
        Item::Image(picture) if picture.min == map.frame.min => Some(picture),
        _ => None,
    });
    let image = image.expect("a picture");
    let [column, row] = [x * image.width as f32, y * image.height as f32].map(|at| at as usize);
    let at = column + row * image.width;
    std::array::from_fn(|k| image.rgba[4 * at + k])
}

#[test]
fn the_picture_has_the_cells_where_the_axes_say() {
    let field = field();
    let mut spec = spec();
    // In bins θh ends at 30/90 of the root axis and at 10° of the linear one.
    for (law, edge) in [(Law::SquareRoot, 1.0 / 3.0), (Law::Linear, 1.0 / 9.0)] {
        spec.x.law = law;
        let map = HeatMap::new(&spec, &field, [700.0, 420.0]);
        assert_eq!(color_at(&map, [edge - 0.01, 0.5])[3], 255);
        assert_eq!(color_at(&map, [edge + 0.01, 0.5])[3], 0);
    }
    spec.x.law = Law::SquareRoot;
    spec.view = HeatView::default().zoomed([0.0, 0.0], 0.5);
    let map = HeatMap::new(&spec, &field, [700.0, 420.0]);
    assert_eq!(color_at(&map, [0.65, 0.5])[3], 255);
    assert_eq!(color_at(&map, [0.68, 0.5])[3], 0);
}

/// Lengths of hatching over missing cells and elsewhere, within the frame.
fn hatching(map: &HeatMap, field: &HeatField) -> (f32, f32) {
    let (mut on, mut off) = (0.0, 0.0);
    for item in &map.drawing.items {
        let Item::Line { points, ink, .. } = item else {
            continue;
        };
        let &[a, b] = &points[..] else { continue };
        let is_diagonal = ((a[0] - b[0]).abs() - (a[1] - b[1]).abs()).abs() < 1e-2;
        if ink.role != Role::Muted || !is_diagonal {
            continue;
        }
        for k in 0..100 {
            let t = (k as f32 + 0.5) / 100.0;
            let at = [0, 1].map(|k| a[k] + t * (b[k] - a[k]));
            let Some((column, row)) = map.frame.locate(at).and_then(|at| field.find(at)) else {
                continue;
            };
            let piece = 0.01 * (a[0] - b[0]).hypot(a[1] - b[1]);
            if field.cell(column, row) == Cell::Missing {
                on += piece;
            } else {
                off += piece;
            }
        }
    }
    (on, off)
}

#[test]
fn missing_cells_are_hatched_up_to_their_outlines() {
    let speckled = |column: usize, row: usize| match (column * 7 + row * 13) % 5 {
        0 => Cell::Missing,
        _ => Cell::Value(0.5),
    };
    let even: Vec<f64> = (0..=90).map(f64::from).collect();
    let speckled = HeatField::new(even.clone(), even, speckled);
    for (field, share) in [(field(), 1.0 / 3.0), (speckled, 0.2)] {
        let mut spec = spec();
        if share == 0.2 {
            spec.x.law = Law::Linear;
        }
        let map = HeatMap::new(&spec, &field, [700.0, 420.0]);
        let (on, off) = hatching(&map, &field);
        let [width, height] = map.frame.size();
        // Lines 5 points apart, on the missing share of the area.
        let wanted = share * width * height / 5.0;
        assert!((on / wanted - 1.0).abs() < 0.1, "{on} of {wanted}");
        assert!(off < 0.02 * on, "{off}");
        // Planted: a neighbour's cells.
        let shifted = HeatField::new(field.x.clone(), field.y.clone(), |column, row| {
            field.cell((column + 1) % field.columns(), row)
        });
        let (_, off) = hatching(&map, &shifted);
        assert!(off > 0.02 * on, "{off}");
    }
}

#[test]
fn scales_place_their_ticks() {
    let axis = |scale| Axis::new(scale, 10.0, Some(0.02));
    let scales = [
        ColorScale::Amount(axis(RadialScale::Linear)),
        ColorScale::Amount(axis(RadialScale::Log)),
        ColorScale::Signed(axis(RadialScale::CubeRoot)),
        ColorScale::Signed(axis(RadialScale::Log)),
        ColorScale::Ratio(8.0),
        ColorScale::Ratio(1000.0),
        ColorScale::Between(5.3, 98.0),
    ];
    for scale in scales {
        for count in [2, 5, 9] {
            let ticks = scale.ticks(count);
            assert!(
                ticks.len() >= 2 && ticks.len() <= 2 * count + 1,
                "{scale:?}"
            );
            for pair in ticks.windows(2) {
                assert!(pair[0].value < pair[1].value && pair[0].position < pair[1].position);
            }
            for tick in &ticks {
                assert!((scale.position(tick.value) - tick.position).abs() < 1e-9);
            }
        }
    }
    let signed = ColorScale::Signed(axis(RadialScale::CubeRoot));
    let position = signed.position(3.0) + signed.position(-3.0);
    assert!((position - 1.0).abs() < 1e-12);
    assert_eq!(ColorScale::Ratio(8.0).position(1.0), 0.5);
    assert!((ColorScale::Ratio(8.0).position(0.125)).abs() < 1e-12);
    // Decades.
    let values: Vec<f64> = scales[1].ticks(9).iter().map(|tick| tick.value).collect();
    assert!(
        values
            .iter()
            .all(|v| (v.log10() - v.log10().round()).abs() < 1e-9)
    );
}

#[test]
fn axes_have_ticks_that_do_not_crowd() {
    for law in [Law::Linear, Law::SquareRoot] {
        let side = Side::angle("θ", law);
        for view in [(0.0, 1.0), (0.4, 0.6), (0.0, 0.05)] {
            for gap in [0.02, 0.06, 0.2] {
                let ticks = side.ticks(view, gap);
                assert!(ticks.len() >= 2, "{law:?} {view:?} {gap}");
                assert!(
                    ticks
                        .windows(2)
                        .all(|p| p[1].position - p[0].position >= gap)
                );
            }
        }
    }
    let s = Side {
        title: "s".into(),
        law: Law::Log,
        range: (0.1, 1e5),
        degrees: false,
    };
    let values: Vec<f64> = s.ticks((0.0, 1.0), 0.05).iter().map(|t| t.value).collect();
    assert_eq!(values.len(), 7);
}

#[test]
fn everything_stays_inside_and_finite_at_any_size() {
    let mark = ProbeMark {
        at: [45.0, 45.0],
        exact: true,
    };
    for size in SIZES {
        for square in [false, true] {
            let spec = HeatSpec {
                square,
                curves: vec![Curve {
                    points: vec![[-10.0, 5.0], [50.0, 50.0], [200.0, 300.0]],
                    kind: CurveKind::Limit,
                    label: Some("80°".into()),
                }],
                spots: vec![HeatSpot::Probe(mark), HeatSpot::Best([400.0, 3.0])],
                ..spec()
            };
            let map = HeatMap::new(&spec, &field(), size);
            for point in map.drawing.items.iter().flat_map(corners) {
                assert!(point.iter().all(|x| x.is_finite()), "{size:?}");
                let inside = (0..2).all(|k| (-1.0..=size[k] + 1.0).contains(&point[k]));
                // The smallest have no room for anything.
                assert!(inside || size[0] < 200.0, "{size:?} {point:?}");
            }
        }
    }
}

#[test]
fn ticks_end_whatever_part_of_an_axis_is_in_sight() {
    for law in [Law::Linear, Law::SquareRoot, Law::Log] {
        for range in [(0.1, 1e5), (0.0, 90.0), (0.0, 0.0), (1e-300, f64::INFINITY)] {
            let side = Side {
                title: String::new(),
                law,
                range,
                degrees: false,
            };
            for sight in [
                (0.0, 1.0),
                (0.0, 45.0),
                (-1e9, 1e9),
                (1.0, 0.0),
                (0.0, f64::NAN),
            ] {
                let count = side.ticks(sight, 0.1).len();
                assert!(count < 1000, "{law:?} {range:?} {sight:?}: {count}");
            }
        }
    }
    for colors in [
        ColorScale::Between(0.0, f64::INFINITY),
        ColorScale::Ratio(f64::INFINITY),
    ] {
        assert!(colors.ticks(6).len() < 10_000, "{colors:?}");
    }
}
