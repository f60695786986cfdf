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
