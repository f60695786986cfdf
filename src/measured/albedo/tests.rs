use super::*;
use crate::brdf::params::lobe_values;
use crate::brdf::{self, Brdf, Fresnel, Model, Params};
use crate::measured::{Grid, lookup::LOOKUPS};

/// Table of f_r at the centres of all cells; invalid where f_r has no value.
fn table(f_r: impl Fn(&crate::geom::HalfDiff) -> Option<Rgb>) -> Table {
    let grid = Grid::FOLDED;
    let cells = (0..grid.len()).map(|index| {
        let (h, d, phi) = grid.bins(index);
        let value = f_r(&grid.center(h, d, phi)).unwrap_or([f64::NAN; 3]);
        value.map(|x| x as f32)
    });
    Table::new(grid, cells.collect())
}

fn model(key: &str, fresnel: Fresnel, s: f64) -> Brdf {
    Brdf {
        model: Model::by_key(key).expect("a model"),
        fresnel,
        params: Params {
            rho_d: [0.0, 0.3, 0.1],
            k_s: [(s + 2.0) / (2.0 * PI), 0.0, 0.5],
            lobe: lobe_values([s, 0.5]),
            eta: 1.5,
        },
    }
}

fn of_model(brdf: &Brdf) -> Table {
    table(|angles| Some(brdf.eval(&angles.cosines())))
}

fn off(found: f64, wanted: f64) -> f64 {
    (found / wanted - 1.0).abs()
}

#[test]
fn lambert_reflects_rho_d_at_every_angle() {
    let rho_d = [0.2, 0.5, 0.9];
    let lambert = table(|_| Some(rho_d.map(|x| x / PI)));
    for lookup in LOOKUPS {
        for deg in [0.0, 20.0, 45.0, 70.0, 85.0, 89.0_f64] {
            let found = albedo(&lambert, lookup, deg.to_radians());
            for (found, wanted) in found.rgb.into_iter().zip(rho_d) {
                assert!(off(found, wanted) < 1e-3, "{deg}°: {found} {wanted}");
            }
            assert!(off(found.measured, 1.0) < 1e-3, "{deg}° {}", found.measured);
        }
    }
}

/// Largest distance of Phong at normal incidence to k_s 2π/(s + 2), for exponents with an error put in.
fn worst_phong(lookup: Lookup, planted: f64) -> f64 {
    let mut worst: f64 = 0.0;
    for s in [3.0, 30.0, 300.0, 1000.0] {
        let mut phong = model("phong", Fresnel::None, s);
        phong.params.lobe[0] *= 1.0 + planted;
        let found = albedo(&of_model(&phong), lookup, 0.0).rgb[0];
        // k_s is (s + 2)/2π.
        worst = worst.max(off(found, 1.0));
    }
    worst
}

#[test]
fn phong_at_normal_incidence_has_its_closed_form() {
    for lookup in LOOKUPS {
        let worst = worst_phong(lookup, 0.0);
        assert!(worst < 8e-3, "{lookup:?} {worst}");
        assert!(worst_phong(lookup, 0.02) > 8e-3);
    }
}

#[test]
fn a_table_of_a_model_reflects_as_the_model_does() {
    for (key, s) in [("phong", 40.0), ("blinn-phong", 400.0), ("combined", 60.0)] {
        let brdf = model(key, Fresnel::Exact, s);
        let table = of_model(&brdf);
        for deg in [0.0, 30.0, 60.0, 75.0, 85.0_f64] {
            let found = albedo(&table, Lookup::Smooth, deg.to_radians()).rgb;
            let wanted = brdf::albedo(&brdf, deg.to_radians());
            for (found, wanted) in found.into_iter().zip(wanted) {
                assert!(off(found, wanted) < 8e-3, "{key} {deg}°: {found} {wanted}");
            }
        }
        // Planted: another angle.
        let elsewhere = albedo(&table, Lookup::Smooth, 80f64.to_radians()).rgb[0];
        assert!(off(elsewhere, brdf::albedo(&brdf, 75f64.to_radians())[0]) > 8e-3);
    }
}

#[test]
fn the_measured_share_is_what_holes_leave() {
    // θh = 22.5° is an edge of the bins; at normal incidence it is θo = 45°.
    let hole = table(|angles| (angles.theta_h > 22.5_f64.to_radians()).then_some([1.0 / PI; 3]));
    let other = table(|angles| (angles.theta_h > 23.1_f64.to_radians()).then_some([1.0 / PI; 3]));
    for lookup in LOOKUPS {
        let found = albedo(&hole, lookup, 0.0);
        assert!(off(found.measured, 0.5) < 1e-3, "{}", found.measured);
        assert!(off(found.rgb[0], 0.5) < 1e-3);
        assert!(off(albedo(&other, lookup, 0.0).measured, 0.5) > 1e-3);
    }
    let nothing = albedo(&Table::unmeasured(), Lookup::Smooth, 0.7);
    assert_eq!((nothing.rgb, nothing.measured), ([0.0; 3], 0.0));
}

#[test]
fn directions_past_the_horizon_are_left_out() {
    for theta_i in [0.0, 0.3, 1.0, 1.5, FRAC_PI_2] {
        let found = reflectance(theta_i, |_, wo| {
            assert!(wo.z > 0.0);
            Some([1.0; 3])
        });
        assert!(off(found.rgb[0], PI) < 2e-3, "{theta_i}: {:?}", found.rgb);
    }
}
