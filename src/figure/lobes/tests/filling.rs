//! Lobes that fill their plot: scale and rim from the data, clipped peaks, shapes.

use super::*;

/// A grey lobe around the mirror direction over a base, as measured.
fn lobe_over(base: f64, height: impl Fn(f64) -> f64 + Send + Sync + 'static, s: i32) -> Subject {
    curve(move |wi: DVec3, wo: DVec3| {
        let theta_i = wi.z.clamp(-1.0, 1.0).acos();
        let c = Cosines::from_directions(wi, wo).wr_wo.cos.max(0.0);
        Some([base + height(theta_i) * c.powi(s); 3])
    })
}

/// Length of each lobe's highest point up to 80°, as a share of the radius; ascending by θi.
fn reaches(plot: &LobePlot) -> Vec<f64> {
    let reach = |trace: &Trace| {
        let near = trace
            .samples
            .iter()
            .filter(|s| s.x.abs() <= 80f64.to_radians());
        let values = near.filter_map(|sample| sample.value);
        plot.frame
            .axis
            .position(values.fold(0.0, f64::max))
            .min(1.0)
    };
    plot.traces.iter().map(reach).collect()
}

#[test]
fn the_scale_and_the_rim_are_chosen_such_that_lobes_fill_their_plot() {
    // A needle, a glossy one, a matte one, each rising towards grazing as measured ones do.
    let rising = |least: f64| move |theta_i: f64| least / theta_i.cos().powi(3);
    for (subject, scale, clipped) in [
        (lobe_over(1e-3, rising(500.0), 20_000), RadialScale::Log, 0),
        (lobe_over(0.05, rising(0.25), 12), RadialScale::CubeRoot, 1),
        (lobe_over(0.025, rising(0.01), 4), RadialScale::Linear, 1),
    ] {
        let plot = LobePlot::new(&LobeSpec::default(), std::slice::from_ref(&subject), SIZE);
        assert_eq!(plot.frame.axis.scale, scale);
        let reaches = reaches(&plot);
        assert!(
            reaches.iter().all(|reach| *reach > 0.3),
            "{scale:?} {reaches:?}"
        );
        assert!(
            reaches.iter().any(|reach| *reach > 0.85),
            "{scale:?} {reaches:?}"
        );
        // The base is in sight: neither in the middle nor at the rim.
        let base = plot
            .frame
            .axis
            .position(plot.traces[0].value_at(-1.3).expect("a value"));
        assert!((0.08..0.6).contains(&base), "{scale:?} {base}");
        let names: Vec<String> = plot
            .drawing
            .labels()
            .map(|label| label.text.plain())
            .collect();
        let marked = names.iter().filter(|name| name.contains("peak")).count();
        assert_eq!(marked, clipped, "{scale:?} {names:?}");
        for theta_i in ["30°", "60°", "80°"] {
            let named = |name: &&String| name.starts_with(theta_i);
            assert!(names.iter().any(|name| named(&name)), "{theta_i} {names:?}");
        }
    }
}

#[test]
fn a_clipped_peak_has_its_value_and_an_arrow_on_the_rim() {
    let subject = lobe_over(0.025, |theta_i| 0.01 / theta_i.cos().powi(3), 4);
    let plot = LobePlot::new(&LobeSpec::default(), &[subject], SIZE);
    let (_, peak) = plot.traces[2].peak().expect("a peak");
    assert!(peak > plot.frame.axis.limit);
    let label = plot
        .drawing
        .labels()
        .find(|label| label.text.plain().starts_with("80°, peak "))
        .expect("its name");
    let text = label.text.plain();
    let written: f64 = text["80°, peak ".len()..].parse().expect("a number");
    assert!((written / peak - 1.0).abs() < 0.05, "{written} {peak}");
    let arrows = plot.drawing.items.iter().filter(|item| match item {
        Item::Fill { points, ink } if matches!(ink.role, Role::Series(_)) => {
            let tip = points[1];
            let away = distance(tip, plot.frame.origin) / plot.frame.radius;
            (away - 1.0).abs() < 1e-3
        }
        _ => false,
    });
    assert_eq!(arrows.count(), 1);
}

#[test]
fn the_axis_is_that_of_the_data_whatever_the_model() {
    let data = || lobe_over(0.05, |_| 0.4, 12);
    let model = |height: f64| Subject {
        look: Look::Model,
        ..lobe_over(0.02, move |_| height, 40)
    };
    let axis = |model: Subject| {
        LobePlot::new(&LobeSpec::default(), &[data(), model], SIZE)
            .frame
            .axis
    };
    assert_eq!(axis(model(0.1)), axis(model(900.0)));
    // A model alone has an axis of its own.
    let alone = LobePlot::new(&LobeSpec::default(), &[model(900.0)], SIZE);
    assert_ne!(alone.frame.axis, axis(model(900.0)));
}

#[test]
fn shapes_are_compared_by_their_own_maxima() {
    let spec = LobeSpec {
        shape_only: true,
        scale: LobeScale::Linear,
        ..LobeSpec::default()
    };
    let (low, high) = (lobe_over(0.1, |_| 0.3, 8), lobe_over(10.0, |_| 30.0, 8));
    let plot = LobePlot::new(&spec, &[low, high], SIZE);
    for pair in plot.traces.chunks(2) {
        let near: Vec<(f64, f64)> = pair[0]
            .values()
            .zip(pair[1].values())
            .filter(|(a, b)| (a - b).abs() > 1e-9)
            .collect();
        assert_eq!(near, []);
        let (_, peak) = pair[0].peak().expect("a peak");
        assert!((peak - 1.0).abs() < 1e-9, "{peak}");
    }
    let titled = |plot: &LobePlot| {
        plot.drawing
            .labels()
            .any(|label| label.text.plain().contains("its maximum"))
    };
    assert!(titled(&plot));
    // Planted: in values they are 100 times apart.
    let spec = LobeSpec {
        shape_only: false,
        ..spec
    };
    let (low, high) = (lobe_over(0.1, |_| 0.3, 8), lobe_over(10.0, |_| 30.0, 8));
    let plot = LobePlot::new(&spec, &[low, high], SIZE);
    let peaks: Vec<f64> = plot
        .traces
        .iter()
        .filter_map(|trace| Some(trace.peak()?.1))
        .collect();
    assert!(peaks[1] / peaks[0] > 99.0 && !titled(&plot));
}
