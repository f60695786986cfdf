use super::*;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, MODELS, Params};
use crate::figure::cosine::CosineFactor;
use crate::figure::drawing::Item;
use crate::figure::heatmap::Cell;
use crate::figure::palette::Palette;
use crate::figure::panel::{PanelInput, PanelView};
use crate::figure::plot::tests::{SIZES, clashes, strays};
use crate::figure::shown::{SHOWN, Shown};
use crate::figure::subject::{Channel, Look, Source, Subject};
use crate::geom::{direction, mirror};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

fn model() -> Source {
    Source::Model(Brdf {
        model: MODELS[2],
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.3, 0.2, 0.1],
            k_s: [2.0, 3.0, 4.0],
            lobe: lobe_values([40.0, 0.3]),
            eta: 1.6,
        },
    })
}

/// 1 + θo towards the light's side, nothing on the other.
fn half_measured() -> Source {
    Source::Function(Arc::new(|wi, wo| {
        let towards = wi.x * wo.x + wi.y * wo.y > 0.0;
        towards.then(|| [1.0 + crate::geom::directions::theta(wo); 3])
    }))
}

fn spec(shown: Shown) -> DiscSpec {
    DiscSpec {
        shown,
        theta_i: 0.9,
        phi_i: 2.0,
        ..DiscSpec::default()
    }
}

#[test]
fn places_and_directions_are_each_others_inverse() {
    for projection in PROJECTIONS {
        for (theta, phi) in [(0.2, 0.3), (1.0, 4.0), (1.5, 6.2), (FRAC_PI_2, 1.0)] {
            let w = direction(theta, phi);
            let place = projection.place(w);
            let back = projection.direction(place.map(|x| x * (1.0 - 1e-15)));
            assert!((back.expect("inside") - w).length() < 1e-9, "{theta} {phi}");
        }
        assert_eq!(projection.direction([0.8, -0.8]), None);
        assert!((projection.radius(FRAC_PI_2) - 1.0).abs() < 1e-15);
    }
}

/// Share of the disc inside θ.
fn area(projection: DiscProjection, theta: f64) -> f64 {
    projection.radius(theta).powi(2)
}

#[test]
fn equal_solid_angles_have_equal_areas_in_one_projection_and_equal_angles_equal_lengths_in_the_other()
 {
    for theta in [0.5, 0.7, 1.3_f64] {
        // The solid angle inside θ is 2π (1 − cos θ), of all 2π.
        let share = 1.0 - theta.cos();
        assert!((area(DiscProjection::EqualArea, theta) - share).abs() < 1e-12);
        assert!((area(DiscProjection::Linear, theta) - share).abs() > 1e-3);
        assert!((DiscProjection::Linear.radius(theta) - theta / FRAC_PI_2).abs() < 1e-12);
    }
}

#[test]
fn every_cell_is_the_formula_towards_its_direction() {
    const SIDE: usize = 64;
    let data = Source::Function(Arc::new(|wi, wo| {
        Some([1.0 + wi.z * wo.z, 0.0, 1.0 + wo.x])
    }));
    let Source::Model(brdf) = model() else {
        panic!("a model")
    };
    let worst = |turn: f64, shown: Shown| {
        let spec = DiscSpec {
            channel: Channel::B,
            cosine: CosineFactor::BOTH,
            ..spec(shown)
        };
        let field = spec.field(Some(&data), Some(&model()), SIDE);
        let mut worst: f64 = 0.0;
        let mut count = 0;
        for (k, cell) in field.cells.cells.iter().enumerate() {
            let [x, y] = [k % SIDE, k / SIDE].map(|k| (k as f64 + 0.5) * 2.0 / SIDE as f64 - 1.0);
            let radius = x.hypot(y);
            if radius > 1.0 {
                assert_eq!(*cell, Cell::Outside);
                continue;
            }
            // Written out: θ in proportion to the radius, seen from above.
            let theta = FRAC_PI_2 * radius;
            let (wi, wo) = (direction(0.9, 2.0), direction(theta, y.atan2(x) + turn));
            let factor = wi.z * wo.z;
            let [g, f] = [1.0 + wo.x, brdf.f_r(wi, wo).expect("above")[2]].map(|v| factor * v);
            let wanted = match shown {
                Shown::Measured => g,
                Shown::Model => f,
                Shown::Residual => f - g,
                Shown::Ratio => f / g,
            };
            let Cell::Value(value) = cell else {
                panic!("{cell:?} at {x} {y}")
            };
            count += 1;
            worst = worst.max((value - wanted).abs() / (wanted.abs() + 1e-3));
        }
        assert!(count > 3000);
        worst
    };
    for shown in SHOWN {
        assert!(worst(0.0, shown) < 1e-9, "{shown:?}");
        // Planted: turned by a tenth of a degree.
        assert!(worst(0.1f64.to_radians(), shown) > 1e-5, "{shown:?}");
    }
}

#[test]
fn the_colours_of_a_model_are_those_of_the_data() {
    let data = half_measured();
    let of = |shown| spec(shown).field(Some(&data), Some(&model()), 64).reference;
    assert_eq!(of(Shown::Model), of(Shown::Measured));
    let alone = spec(Shown::Model).field(None, Some(&model()), 64);
    assert_eq!(alone.reference, alone.values);
}

#[test]
fn no_text_covers_another_in_any_size_and_directions_are_found_again() {
    let data = half_measured();
    for size in SIZES {
        for projection in PROJECTIONS {
            for theta_i in [0.0, 0.8, 1.5] {
                let spec = DiscSpec {
                    projection,
                    theta_i,
                    ..spec(Shown::Measured)
                };
                let field = spec.field(Some(&data), None, 64);
                let name = "a rather long name of a material (synthetic)";
                let mut plot = DiscPlot::new(&spec, name, &field, size);
                // The title of the bar is turned: its bounds are not where it is.
                plot.drawing
                    .items
                    .retain(|item| !matches!(item, Item::Text(label) if label.angle != 0.0));
                assert_eq!(clashes(&plot.drawing), Vec::<String>::new(), "{size:?}");
                assert!(!strays(&plot.drawing), "{size:?}");
                if plot.frame.radius < 20.0 {
                    continue;
                }
                let wo = direction(0.6, 1.0);
                let found = plot.frame.direction(plot.frame.point(wo)).expect("inside");
                assert!((found - wo).length() < 1e-3);
                assert_eq!(plot.frame.direction([1.0, 1.0]), None);
            }
        }
    }
}

#[test]
fn what_was_not_measured_is_hatched_and_named() {
    let words = |source: Source| {
        let spec = spec(Shown::Measured);
        let field = spec.field(Some(&source), None, 128);
        let plot = DiscPlot::new(&spec, "half", &field, [500.0, 420.0]);
        let lines = plot.drawing.items.iter();
        let lines = lines
            .filter(|item| matches!(item, Item::Line { .. }))
            .count();
        let named = plot
            .drawing
            .labels()
            .any(|l| l.text.plain() == "not measured");
        (named, lines)
    };
    let (half, all) = (words(half_measured()), words(model_as_data()));
    assert!(half.0 && !all.0);
    assert!(half.1 > all.1 + 20, "{half:?} {all:?}");
}

fn model_as_data() -> Source {
    Source::Function(Arc::new(|_, _| Some([1.0; 3])))
}

#[test]
fn the_marks_are_at_the_light_and_opposite_to_it() {
    let spec = spec(Shown::Model);
    let field = spec.field(None, Some(&model()), 64);
    let plot = DiscPlot::new(&spec, "model", &field, [500.0, 420.0]);
    let marks = plot.marks(&spec);
    let centers: Vec<_> = marks
        .items
        .iter()
        .filter_map(|item| match item {
            Item::Dot { center, .. } => Some(*center),
            _ => None,
        })
        .collect();
    let wi = direction(0.9, 2.0);
    for w in [wi, mirror(wi)] {
        assert!(centers.contains(&plot.frame.point(w)));
    }
    assert!(!centers.contains(&plot.frame.point(direction(0.9, 2.01))));
}

#[test]
fn the_table_has_every_degree_and_says_where_there_is_no_value() {
    let spec = DiscSpec {
        phi_i: PI,
        ..spec(Shown::Measured)
    };
    let subjects = [Subject {
        label: "half".into(),
        look: Look::Measured,
        series: 0,
        hidden: false,
        source: half_measured(),
    }];
    let drawn = spec.draw(&PanelInput {
        subjects: &subjects,
        named: &subjects,
        made: None,
        name: "half",
        size: [300.0, 260.0],
        density: 1.0,
        palette: &Palette::LIGHT,
        numbers: true,
        albedos: &Default::default(),
    });
    let text = drawn.table.text(',');
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(
        rows[0],
        "quantity,channel,theta_i,phi_i,theta_o,phi_o,value"
    );
    assert_eq!(rows.len(), 1 + 1 + 90 * 120);
    // Light at φ = 180°: to the left there are values, to the right none.
    let right = rows.iter().find(|row| row.contains(",180,30,0,"));
    assert!(
        right.is_some_and(|row| row.starts_with("f_r,luminance,51.566") && row.ends_with(",0,"))
    );
    let left = rows.iter().find(|row| row.contains(",180,30,180,"));
    let value: f64 = left
        .and_then(|row| row.rsplit(',').next())
        .and_then(|x| x.parse().ok())
        .expect("a value");
    assert!((value - (1.0 + PI / 6.0)).abs() < 1e-12);
}
