use super::*;

fn labels(axis: Axis, count: usize) -> Vec<String> {
    let ticks = axis.ticks(count);
    ticks.iter().map(|tick| tick.label.plain()).collect()
}

#[test]
fn positions_have_closed_values() {
    let position = |scale, limit, value| Axis::new(scale, limit, Some(2e-4)).position(value);
    assert_eq!(position(RadialScale::Linear, 4.0, 1.0), 0.25);
    assert!((position(RadialScale::CubeRoot, 8.0, 1.0) - 0.5).abs() < 1e-15);
    // Five decades from 1e-4 to 10: 1 is the fourth of five.
    assert!((position(RadialScale::Log, 10.0, 1.0) - 0.8).abs() < 1e-12);
    assert!((position(RadialScale::Log, 10.0, 1.001) - 0.8).abs() > 1e-5);
    for scale in RADIAL_SCALES {
        assert_eq!(position(scale, 10.0, 0.0), 0.0);
        assert!((position(scale, 10.0, 10.0) - 1.0).abs() < 1e-15);
        let axis = Axis::new(scale, 10.0, Some(2e-4));
        for k in 1..=12 {
            let p = f64::from(k) / 10.0;
            assert!((axis.position(axis.value(p)) - p).abs() < 1e-12);
        }
    }
    assert_eq!(position(RadialScale::Log, 10.0, 1e-4), 0.0);
    assert_eq!(position(RadialScale::Log, 10.0, 1e-9), 0.0);
}

#[test]
fn floors_are_three_to_six_decades_down() {
    let floor = |limit, smallest| Axis::new(RadialScale::Log, limit, smallest).floor;
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    assert!(close(floor(10.0, Some(0.5)), 1e-2));
    assert!(close(floor(10.0, Some(2e-4)), 1e-4));
    assert!(close(floor(10.0, Some(1e-12)), 1e-5));
    assert!(close(floor(2.5, None), 1e-2));
    for limit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Axis::new(RadialScale::Linear, limit, None).limit, 1.0);
    }
}

#[test]
fn rings_are_round_values() {
    let axis = |scale, limit| Axis::new(scale, limit, Some(3e-3));
    let linear = |limit, count| labels(axis(RadialScale::Linear, limit), count);
    assert_eq!(linear(1.0, 5), ["0.2", "0.4", "0.6", "0.8", "1"]);
    assert_eq!(linear(2.5, 5), ["0.5", "1", "1.5", "2", "2.5"]);
    assert_eq!(linear(0.06, 4), ["0.02", "0.04", "0.06"]);
    assert_eq!(linear(8000.0, 3), ["5000"]);
    assert_eq!(linear(3e6, 3), ["1·106", "2·106", "3·106"]);
    let cube = labels(axis(RadialScale::CubeRoot, 10.0), 5);
    assert_eq!(cube, ["0.05", "0.5", "2", "5", "10"]);
    assert_eq!(
        labels(axis(RadialScale::Log, 20.0), 6),
        ["10−2", "10−1", "1", "10"]
    );
    assert_eq!(labels(axis(RadialScale::Log, 20.0), 2), ["10−1", "10"]);
}

#[test]
fn limits_are_round_and_not_below() {
    for (max, limit) in [
        (0.0, 1.0),
        (1.0, 1.0),
        (1.01, 1.5),
        (0.00021, 0.00025),
        (8.5, 10.0),
        (99.0, 100.0),
        (f64::NAN, 1.0),
    ] {
        assert_eq!(nice_limit(max), limit);
    }
}

#[test]
fn numbers_are_short() {
    for (value, text) in [
        (0.25, "0.25"),
        (0.30000000000000004, "0.3"),
        (1234.5, "1234"),
        (-0.5, "−0.5"),
        (3e6, "3·10^{6}"),
        (2.5e-7, "2.5·10^{−7}"),
    ] {
        assert_eq!(number(value), text);
    }
}

#[test]
fn scales_are_found_by_key() {
    for scale in RADIAL_SCALES {
        assert_eq!(RadialScale::by_key(scale.key()), Some(scale));
    }
    assert_eq!(RadialScale::by_key("sqrt"), None);
}

fn marks(scale: RadialScale, low: f64, high: f64, length: f32) -> (Vec<String>, usize) {
    let steps = if high == 90.0 {
        Steps::Degrees
    } else {
        Steps::Decimal
    };
    let marks = Axis::between(scale, low, high).marks(length, 40.0, steps);
    let labels = marks.major.iter().map(|tick| tick.label.plain());
    (labels.collect(), marks.minor.len())
}

#[test]
fn straight_axes_have_round_marks_and_smaller_ones_between() {
    let linear = |low, high, length| marks(RadialScale::Linear, low, high, length).0;
    assert_eq!(
        marks(RadialScale::Linear, -90.0, 90.0, 300.0),
        (
            vec!["−90", "−60", "−30", "0", "30", "60", "90"]
                .into_iter()
                .map(String::from)
                .collect(),
            12
        )
    );
    assert_eq!(
        linear(0.0, 1.0, 200.0),
        ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]
    );
    assert_eq!(
        linear(45.001, 45.0032, 160.0),
        ["45.001", "45.002", "45.003"]
    );
    assert_eq!(linear(-0.3, 0.3, 120.0), ["−0.2", "0", "0.2"]);
    let (log, minor) = marks(RadialScale::Log, 1e-2, 1e3, 400.0);
    assert_eq!(log, ["10−2", "10−1", "1", "10", "100", "103"]);
    assert_eq!(minor, 40, "2 to 9 in five decades");
    assert_eq!(
        marks(RadialScale::Log, 1e-6, 1e6, 200.0).0,
        ["10−6", "10−3", "1", "103", "106"]
    );
    assert_eq!(
        marks(RadialScale::Log, 0.5, 60.0, 300.0).0,
        ["0.5", "1", "2", "5", "10", "20", "50"]
    );
    // Too little of a decade for its digits.
    assert_eq!(
        marks(RadialScale::Log, 2.2, 2.8, 160.0).0,
        ["2.2", "2.4", "2.6", "2.8"]
    );
    let cubic = marks(RadialScale::CubeRoot, -8.0, 8.0, 200.0).0;
    assert_eq!(cubic, ["−5", "0", "5"]);
}

#[test]
fn marks_stand_where_their_values_are() {
    let worst = |planted: f64| -> f64 {
        let mut worst: f64 = 0.0;
        for scale in RADIAL_SCALES {
            for (low, high) in [(0.013, 4.0), (2.0, 2.5), (0.5, 7e5)] {
                let axis = Axis::between(scale, low, high);
                let marks = axis.marks(500.0, 30.0, Steps::Decimal);
                assert!(marks.major.len() >= 2, "{scale:?} {low} {high}");
                for tick in marks.major {
                    let back = axis.value(tick.position + planted);
                    worst = worst.max((back / tick.value - 1.0).abs());
                }
                assert!(marks.minor.iter().all(|p| (0.0..=1.0).contains(p)));
            }
        }
        worst
    };
    assert!(worst(0.0) < 1e-9, "{}", worst(0.0));
    assert!(worst(1e-3) > 1e-9);
}

#[test]
fn axes_between_any_ends_are_sound() {
    for scale in RADIAL_SCALES {
        for (low, high) in [
            (1.0, 1.0),
            (5.0, 2.0),
            (f64::NAN, f64::INFINITY),
            (-3.0, -2.0),
            (0.0, 0.0),
            (1e300, 1e-300),
        ] {
            let axis = Axis::between(scale, low, high);
            assert!(axis.floor < axis.limit, "{axis:?}");
            for length in [0.0, 1.0, 500.0] {
                let marks = axis.marks(length, 20.0, Steps::Decimal);
                assert!(marks.major.len() < 400);
                assert!(marks.major.iter().all(|tick| tick.position.is_finite()));
            }
        }
    }
}

#[test]
fn zooming_keeps_what_is_under_the_pointer() {
    for scale in RADIAL_SCALES {
        let axis = Axis::between(scale, 0.5, 80.0);
        let value = axis.value(0.3);
        for factor in [0.5, 1.0, 3.0] {
            let [low, high] = axis.zoomed(0.3, factor);
            let part = Axis::between(scale, low.max(1e-3), high);
            if low > 1e-3 {
                assert!((part.share(value) - 0.3).abs() < 1e-9, "{scale:?} {factor}");
            }
        }
        let [low, high] = axis.moved(0.1);
        let part = Axis::between(scale, low, high);
        assert!((part.share(value) - 0.2).abs() < 1e-9);
    }
}

#[test]
fn marks_end_whatever_the_ends_of_an_axis_are() {
    let odd = [
        0.0,
        -1.0,
        5e-324,
        1e-300,
        1.0,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    for scale in RADIAL_SCALES {
        for (floor, limit) in odd.iter().flat_map(|low| odd.map(|high| (*low, high))) {
            let axis = Axis {
                scale,
                limit,
                floor,
            };
            let marks = axis.marks(300.0, 20.0, Steps::Decimal);
            let count = marks.major.len() + marks.minor.len() + axis.ticks(6).len();
            assert!(count < 10_000, "{axis:?}: {count}");
        }
    }
}
