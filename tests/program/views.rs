//! What views show against what the command line says.

use crate::common::folder::Folder;
use crate::common::program::{grazing, succeeded};
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, Fresnel, MODELS, Params};
use grazing::figure::Channel;
use grazing::figure::heatmap::{Cell, HeatField};
use grazing::figure::image_slice::ImageSpec;
use grazing::figure::shown::SHOWN;
use grazing::figure::subject::Source;
use grazing::files::open_table;
use grazing::geom::directions::{phi, theta};
use grazing::measured::lookup::Lookup;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;

/// Cells of the image slice, as bins of θh and θd.
const CELLS: [(usize, usize); 8] = [
    (0, 0),
    (3, 60),
    (10, 40),
    (20, 77),
    (44, 44),
    (60, 5),
    (80, 30),
    (89, 89),
];

/// R, G, B of `grazing eval` for the cells of a picture, empty where it prints none.
fn eval(folder: &Folder, source: &Path, spec: &ImageSpec) -> Vec<Option<[f64; 3]>> {
    let mut rows = "theta_i,phi_i,theta_o,phi_o\n".to_string();
    for (h, d) in CELLS {
        let (wi, wo) = spec.angles(h, d).to_directions();
        let angles = [theta(wi), phi(wi), theta(wo), phi(wo)].map(f64::to_degrees);
        let _ = writeln!(
            rows,
            "{},{},{},{}",
            angles[0], angles[1], angles[2], angles[3]
        );
    }
    let rows = folder.file("rows.csv", rows);
    let text = succeeded(&grazing(&[
        &"eval",
        &source,
        &"--directions",
        &rows,
        &"--lookup",
        &"nearest",
    ]));
    let rgb = |line: &str| {
        let values: Option<Vec<f64>> = line.split(',').skip(4).map(|x| x.parse().ok()).collect();
        values.map(|x| [x[0], x[1], x[2]])
    };
    text.lines().skip(1).map(rgb).collect()
}

/// The largest relative distance of the picture's cells from the wanted values.
fn off(field: &HeatField, wanted: &[Option<f64>]) -> f64 {
    let distances =
        CELLS
            .iter()
            .zip(wanted)
            .map(|(&(h, d), wanted)| match (field.cell(h, d), wanted) {
                (Cell::Value(found), Some(wanted)) => (found / wanted - 1.0).abs(),
                (Cell::Missing | Cell::Outside, None) => 0.0,
                _ => f64::INFINITY,
            });
    distances.fold(0.0, f64::max)
}

#[test]
fn the_image_slice_has_the_values_of_eval() {
    let folder = Folder::new();
    let file = folder.path("sample.binary");
    succeeded(&grazing(&[&"sample", &"copper-glaze", &"-o", &file]));
    let table = open_table(&file, &mut |_| std::ops::ControlFlow::Continue(())).expect("a table");
    let data = Source::Measured(Arc::new(table), Lookup::Nearest);
    let params = Params {
        rho_d: [0.3, 0.2, 0.1],
        k_s: [2.0, 3.0, 4.0],
        lobe: lobe_values([40.0, 0.3]),
        eta: 1.6,
    };
    let model = Source::Model(Brdf {
        model: MODELS[2],
        fresnel: Fresnel::Exact,
        params,
    });
    let json = r#"{"model": "combined", "fresnel": "exact", "rho_d": [0.3, 0.2, 0.1], "k_s": [2, 3, 4],
        "s": 40, "alpha": 0.3, "eta": 1.6}"#;
    let model_file = folder.file("model.json", json);
    let luminance = |weights: [f64; 3], rgb: &[Option<[f64; 3]>]| -> Vec<Option<f64>> {
        let of = |rgb: [f64; 3]| rgb.iter().zip(weights).map(|(x, w)| w * x).sum();
        rgb.iter().map(|rgb| rgb.map(of)).collect()
    };
    // Rec. 709, and planted: Rec. 601.
    let [rec_709, rec_601] = [[0.2126, 0.7152, 0.0722], [0.299, 0.587, 0.114]];
    for phi_d in [90.5_f64, 20.5] {
        let spec = ImageSpec {
            phi_d: phi_d.to_radians(),
            ..ImageSpec::default()
        };
        let elsewhere = ImageSpec {
            phi_d: (phi_d + 2.0).to_radians(),
            ..spec.clone()
        };
        let [measured, modelled, planted] =
            [(&file, &spec), (&model_file, &spec), (&file, &elsewhere)]
                .map(|(source, spec)| eval(&folder, source, spec));
        assert!(measured.iter().flatten().count() >= 4, "{measured:?}");
        assert!(measured.iter().any(Option::is_none), "{measured:?}");
        let [f, g] = [&measured, &modelled].map(|rgb| luminance(rec_709, rgb));
        let pair = |of: fn(f64, f64) -> f64| -> Vec<Option<f64>> {
            f.iter()
                .zip(&g)
                .map(|(f, g)| Some(of((*f)?, (*g)?)))
                .collect()
        };
        let wanted = [f.clone(), g.clone(), pair(|f, g| g - f), pair(|f, g| g / f)];
        for (shown, wanted) in SHOWN.into_iter().zip(&wanted) {
            let spec = ImageSpec {
                shown,
                ..spec.clone()
            };
            let field = spec.field(Some(&data), Some(&model));
            // The table is in f32, and a difference of near values loses digits.
            let distance = off(&field, wanted);
            assert!(distance < 1e-5, "{shown:?} at {phi_d}°: {distance}");
        }
        let field = spec.field(Some(&data), Some(&model));
        assert!(off(&field, &luminance(rec_601, &measured)) > 1e-3);
        assert!(off(&field, &luminance(rec_709, &planted)) > 1e-3);
        let blue = ImageSpec {
            channel: Channel::B,
            ..spec
        };
        let blue = blue.field(Some(&data), Some(&model));
        assert!(off(&blue, &luminance([0.0, 0.0, 1.0], &measured)) < 1e-5);
    }
}
