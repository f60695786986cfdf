use super::*;
use crate::brdf::{Brdf, COMBINED, Fresnel};
use crate::figure::cosine::CosineFactor;
use crate::figure::shown::SHOWN;
use crate::measured::Table;
use crate::measured::lookup::Lookup;
use std::sync::Arc;

fn brdf() -> Brdf {
    Brdf {
        model: &COMBINED,
        fresnel: Fresnel::Exact,
        params: COMBINED.default_params(),
    }
}

/// Table in which every cell has a value of its own and some have none.
fn table() -> Arc<Table> {
    let grid = Grid::FOLDED;
    let cells = (0..grid.len())
        .map(|index| match index % 23 {
            5 => [-1.0; 3],
            _ => [0.001, 0.002, 0.003].map(|x: f32| x * (1.0 + index as f32)),
        })
        .collect();
    Arc::new(Table::new(grid, cells))
}

/// The largest relative distance of the picture's values from the cells of the table at a bin of φd.
fn off_cells(field: &HeatField, table: &Table, phi_bin: usize, channel: Channel) -> f64 {
    let grid = table.grid();
    let mut off = 0.0f64;
    for h in 0..THETA_H_BINS {
        for d in 0..THETA_D_BINS {
            let wanted = table.cell(grid.index(h, d, phi_bin));
            let above = grid.center(h, d, phi_bin).cosines().above_horizon();
            let difference = match (field.cell(h, d), wanted) {
                (Cell::Outside, _) if !above => 0.0,
                (Cell::Missing, None) if above => 0.0,
                (Cell::Value(value), Some(rgb)) if above => (value / channel.of(rgb) - 1.0).abs(),
                _ => f64::INFINITY,
            };
            off = off.max(difference);
        }
    }
    off
}

#[test]
fn measured_cells_are_the_tables_with_either_lookup() {
    let table = table();
    for lookup in [Lookup::Nearest, Lookup::Smooth] {
        let source = Source::Measured(table.clone(), lookup);
        for channel in [Channel::Luminance, Channel::B] {
            let spec = ImageSpec {
                phi_d: 90.5f64.to_radians(),
                channel,
                ..ImageSpec::default()
            };
            let field = spec.field(Some(&source), None);
            assert!(off_cells(&field, &table, 90, channel) < 1e-9, "{lookup:?}");
            // Planted: another φd, another channel.
            assert!(off_cells(&field, &table, 91, channel) > 1e-7);
            assert!(off_cells(&field, &table, 90, Channel::R) > 1e-7);
        }
    }
}

#[test]
fn below_the_horizon_is_not_what_was_not_measured() {
    let source = Source::Measured(table(), Lookup::Nearest);
    let spec = ImageSpec {
        phi_d: 0.5f64.to_radians(),
        ..ImageSpec::default()
    };
    let field = spec.field(Some(&source), None);
    let count = |wanted: Cell| field.cells.iter().filter(|cell| **cell == wanted).count();
    // In the plane half of the angles are below: θh + θd > 90°.
    assert!(count(Cell::Outside) > 2000 && count(Cell::Missing) > 100);
    assert_eq!(field.cell(89, 89), Cell::Outside);
    let model = Source::Model(brdf());
    let model = ImageSpec {
        shown: Shown::Model,
        ..spec
    }
    .field(Some(&source), Some(&model));
    assert!(!model.cells.contains(&Cell::Missing));
    let outside = |field: &HeatField| -> Vec<bool> {
        field
            .cells
            .iter()
            .map(|cell| *cell == Cell::Outside)
            .collect()
    };
    assert_eq!(outside(&model), outside(&field));
}

#[test]
fn model_residual_and_ratio_are_those_of_eval() {
    let (table, brdf) = (table(), brdf());
    let data = Source::Measured(table.clone(), Lookup::Nearest);
    let model = Source::Model(brdf);
    for cosine in [
        CosineFactor::NONE,
        CosineFactor::THETA_I,
        CosineFactor::BOTH,
    ] {
        let spec = |shown| ImageSpec {
            shown,
            phi_d: 40.5f64.to_radians(),
            cosine,
            ..ImageSpec::default()
        };
        let field = |shown| spec(shown).field(Some(&data), Some(&model));
        let fields = SHOWN.map(field);
        for (h, d) in [(10, 40), (50, 20), (0, 0), (30, 77)] {
            let angles = Grid::FOLDED.center(h, d, 40);
            let (wi, wo) = angles.to_directions();
            let factor = match cosine {
                CosineFactor::NONE => 1.0,
                CosineFactor::THETA_I => wi.z,
                _ => wi.z * wo.z,
            };
            let f = factor * Channel::Luminance.of(brdf.f_r(wi, wo).expect("above"));
            let Some(g) = table.cell(table.grid().index(h, d, 40)) else {
                panic!("the test wants a measured cell")
            };
            let g = factor * Channel::Luminance.of(g);
            let wanted = [g, f, f - g, f / g];
            for (field, wanted) in fields.iter().zip(wanted) {
                let value = field.cell(h, d).value().expect("a value");
                assert!((value / wanted - 1.0).abs() < 1e-9);
                // Planted: the light and the view swapped.
                let swapped = wanted * wo.z / wi.z;
                assert!(
                    cosine != CosineFactor::THETA_I
                        || (value / swapped - 1.0).abs() > 1e-6
                        || h == 0
                );
            }
        }
    }
}

#[test]
fn the_grazing_line_is_where_one_of_the_directions_is_grazing() {
    for phi_d in [0.0, 40.0, 90.0, 150.0_f64] {
        let spec = ImageSpec {
            phi_d: phi_d.to_radians(),
            ..ImageSpec::default()
        };
        let line = spec.grazing(80f64.to_radians());
        assert!(line.len() > 100);
        for [theta_h, theta_d] in line {
            let cosines = HalfDiff {
                theta_h: theta_h.to_radians(),
                theta_d: theta_d.to_radians(),
                phi_d: spec.phi_d,
            }
            .cosines();
            let smaller = cosines.cos_theta_i.min(cosines.cos_theta_o);
            assert!((smaller.acos().to_degrees() - 80.0).abs() < 1e-6);
        }
    }
}

#[test]
fn data_and_model_have_the_same_colours() {
    let data = Source::Measured(table(), Lookup::Nearest);
    let model = Source::Model(brdf());
    let spec = |shown| ImageSpec {
        shown,
        ..ImageSpec::default()
    };
    let reference = spec(Shown::Measured).field(Some(&data), Some(&model));
    let colors = |shown| {
        let field = spec(shown).field(Some(&data), Some(&model));
        spec(shown).heat_spec("x", &field, &reference).colors
    };
    assert_eq!(colors(Shown::Measured), colors(Shown::Model));
    let unit = |shown| {
        let field = spec(shown).field(Some(&data), Some(&model));
        spec(shown).heat_spec("x", &field, &reference).title[0].contains("sr^")
    };
    assert_eq!(SHOWN.map(unit), [true, true, true, false]);
    assert!(matches!(colors(Shown::Residual), ColorScale::Signed(_)));
    assert!(matches!(colors(Shown::Ratio), ColorScale::Ratio(_)));
}
