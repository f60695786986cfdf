//! The WGSL twins against the CPU, as numbers, on a real adapter. Both get the same f32 inputs.

use crate::common::gpu::{evaluate, gpu};
use crate::common::random::Random;
use glam::DVec3;
use grazing::brdf::fresnel::FRESNELS;
use grazing::brdf::params::Scale;
use grazing::brdf::wgsl::{UNIFORM_SLOTS, uniform};
use grazing::brdf::{Brdf, MODELS, Model, Param};
use grazing::geom::color::srgb_encode;
use grazing::geom::{Cosines, HalfDiff, direction, mirror};
use grazing::gpu::adapter::Gpu;
use grazing::gpu::shader;
use grazing::gpu::table_texture::TableTexture;
use grazing::measured::lookup::Lookup;
use grazing::measured::{Grid, Table};
use std::f64::consts::{FRAC_PI_2, TAU};

const PAIRS: usize = 20_000;

/// A pair above the horizon: anywhere, near the mirror direction, or both grazing, in turn.
fn pair(random: &mut Random, kind: usize) -> (DVec3, DVec3) {
    let theta = |random: &mut Random, low: f64| random.between(low, FRAC_PI_2 - 1e-3);
    let low = if kind % 3 == 2 { 1.2 } else { 0.0 };
    let wi = direction(theta(random, low), random.between(0.0, TAU));
    let wo = if kind % 3 == 1 {
        let spread = random.log_between(1e-4, 0.5);
        let aside = DVec3::new(
            random.between(-1.0, 1.0),
            random.between(-1.0, 1.0),
            random.between(-1.0, 1.0),
        );
        let near = (mirror(wi) + spread * aside).normalize();
        DVec3::new(near.x, near.y, near.z.abs())
    } else {
        direction(theta(random, low), random.between(0.0, TAU))
    };
    (rounded(wi), rounded(wo))
}

/// As the GPU gets it.
fn rounded(w: DVec3) -> DVec3 {
    w.as_vec3().as_dvec3()
}

fn slot(w: DVec3) -> [f32; 4] {
    let [x, y, z] = w.as_vec3().to_array();
    [x, y, z, 0.0]
}

fn random_brdf(random: &mut Random, k: usize) -> Brdf {
    let model = MODELS[k % MODELS.len()];
    let color =
        |random: &mut Random, low: f64, high: f64| [0; 3].map(|_| random.log_between(low, high));
    let mut brdf = Brdf::new(model, FRESNELS[(k / MODELS.len()) % FRESNELS.len()]);
    brdf.params.rho_d = color(random, 0.01, 1.0);
    brdf.params.k_s = color(random, 0.01, 1e3);
    brdf.params.eta = 1.0 + random.log_between(1e-3, 2.0);
    for (value, row) in brdf.params.lobe.iter_mut().zip(model.params) {
        *value = random_value(random, row);
    }
    for row in model.rows() {
        for value in brdf.get_mut(row.id) {
            *value = f64::from(*value as f32);
        }
    }
    brdf
}

/// A value in the range of a parameter's slider; now and then one of its ends, or beyond it what can be typed.
fn random_value(random: &mut Random, row: &Param) -> f64 {
    let ((low, high), (least, most)) = (row.range, row.domain);
    match (random.unit(), row.scale) {
        (at, _) if at < 0.05 => low,
        (at, _) if at < 0.1 => high,
        (at, Scale::Log { .. }) if at < 0.15 => random.log_between(least, low),
        (at, Scale::Log { .. }) if at < 0.2 => random.log_between(high, most),
        (at, Scale::Linear) if at < 0.2 => random.between(least, most),
        (_, Scale::Linear) => random.between(low, high),
        (_, Scale::Log { .. }) => random.log_between(low, high),
    }
}

/// Largest distance of the models, or of one, relative to the value itself.
fn worst_model_distance(gpu: &Gpu, library: &str, only: Option<&Model>) -> f64 {
    let mut random = Random(1);
    let cases: Vec<(DVec3, DVec3, Brdf)> = (0..PAIRS)
        .map(|k| {
            let (wi, wo) = pair(&mut random, k / 9);
            (wi, wo, random_brdf(&mut random, k))
        })
        .filter(|(_, _, brdf)| only.is_none_or(|model| brdf.model == model))
        .collect();
    let mut inputs = Vec::new();
    for (wi, wo, brdf) in &cases {
        inputs.extend([slot(*wi), slot(*wo)]);
        inputs.extend(uniform(brdf));
    }
    let stride = 2 + UNIFORM_SLOTS;
    let shader = format!(
        "{library}
fn item(index: u32) -> vec4f {{
    let at = index * {stride}u;
    var slots: array<vec4f, BRDF_SLOTS>;
    for (var k = 0u; k < BRDF_SLOTS; k++) {{
        slots[k] = inputs[at + 2u + k];
    }}
    let b = brdf_from_slots(slots);
    return vec4f(eval_brdf(b, cosines_from_directions(inputs[at].xyz, inputs[at + 1u].xyz)), 1.0);
}}"
    );
    let values = evaluate(gpu, &shader, &inputs, cases.len(), None);
    let mut worst: f64 = 0.0;
    for ((wi, wo, brdf), value) in cases.iter().zip(values) {
        let expected = brdf.eval(&Cosines::from_directions(*wi, *wo));
        for channel in 0..3 {
            assert!(value[channel].is_finite(), "{brdf:?} {wi} {wo}");
            worst = worst
                .max((f64::from(value[channel]) - expected[channel]).abs() / expected[channel]);
        }
    }
    worst
}

/// Measured on software Vulkan: 5.8e-6 at worst, from the rounding of the exponent in tails of narrow lobes.
const MODEL_TOLERANCE: f64 = 2e-5;

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn models_agree() {
    let gpu = gpu();
    for model in MODELS {
        let worst = worst_model_distance(&gpu, &shader::library(), Some(model));
        println!("{}: worst relative distance {worst:.2e}", model.key);
        assert!(worst < MODEL_TOLERANCE, "{}: {worst:e}", model.key);
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn planted_errors_in_the_models_are_caught() {
    let gpu = gpu();
    let library = shader::library();
    for (right, wrong) in [
        ("0.3183098861837907", "0.3185"),
        ("x * (4.0 - x * (6.0", "x * (4.0 - x * (6.01"),
        ("-wi.x, -wi.y, wi.z", "-wi.y, -wi.x, wi.z"),
        ("return 0.5 * a * a", "return 0.501 * a * a"),
        ("(x2 * x2 * x)", "(x2 * x2)"),
        ("pow_cosine(c.wh_n, s)", "pow_cosine(c.wh_n, s + 0.01)"),
        (
            "0.5 * wr_wo.versine + sin2_d",
            "0.501 * wr_wo.versine + sin2_d",
        ),
        ("0.039788735772973836", "0.0398"),
        (
            "cos_h * cos_h + sin_squared",
            "cos_h * cos_h + 1.001 * sin_squared",
        ),
        ("2.577 * b", "2.58 * b"),
        ("min(open, blocked)", "min(open, 1.001 * blocked)"),
        ("sqrt(cosines)", "cosines"),
        ("4.0 * c.wi_wh.cos * c.wi_wh.cos", "4.0 * c.wi_wh.cos"),
        ("return log(1.0 + x)", "return log(1.001 + x)"),
    ] {
        assert!(
            library.contains(right),
            "{right} is not in the shader any more"
        );
        let worst = worst_model_distance(&gpu, &library.replace(right, wrong), None);
        assert!(
            worst > 2.0 * MODEL_TOLERANCE,
            "{right} → {wrong} went unnoticed: {worst:e}"
        );
    }
}

/// The library with the twin of a model in which the parameter at a position is a thousandth less than given.
fn with_parameter_off(library: &str, model: &Model, position: usize) -> String {
    let head = format!("fn {}(", model.wgsl_name());
    let (before, twin) = library.split_once(&head).expect("the twin");
    let (signature, body) = twin.split_once('{').expect("a body");
    let declared = signature.split(", ").nth(position).expect("a parameter");
    let name = declared.strip_suffix(": f32").expect("a number");
    let signature = signature.replacen(declared, "given: f32", 1);
    format!("{before}{head}{signature}{{\n    let {name}: f32 = 0.999 * given;{body}")
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_parameter_that_is_a_little_off_is_caught_in_every_model() {
    let gpu = gpu();
    let library = shader::library();
    for model in MODELS {
        for (position, row) in model.params.iter().enumerate() {
            let planted = with_parameter_off(&library, model, position);
            let worst = worst_model_distance(&gpu, &planted, Some(model));
            assert!(
                worst > 2.0 * MODEL_TOLERANCE,
                "{} of {} went unnoticed: {worst:e}",
                row.key(),
                model.key
            );
        }
    }
}

/// Largest distance of the half/difference angles in radians; azimuths weighted by the circle they are on.
fn worst_angle_distance(gpu: &Gpu, library: &str) -> f64 {
    let mut random = Random(2);
    let pairs: Vec<_> = (0..PAIRS).map(|k| pair(&mut random, k)).collect();
    let inputs: Vec<_> = pairs
        .iter()
        .flat_map(|(wi, wo)| [slot(*wi), slot(*wo)])
        .collect();
    let shader = format!(
        "{library}
fn item(index: u32) -> vec4f {{
    let a = half_diff_from_directions(inputs[2u * index].xyz, inputs[2u * index + 1u].xyz);
    return vec4f(a.theta_h, a.theta_d, a.phi_d, 0.0);
}}"
    );
    let mut worst: f64 = 0.0;
    for ((wi, wo), value) in pairs
        .iter()
        .zip(evaluate(gpu, &shader, &inputs, PAIRS, None))
    {
        let expected = HalfDiff::from_directions(*wi, *wo).expect("has a half vector");
        let turn = (f64::from(value[2]) - expected.phi_d).rem_euclid(TAU);
        let around = turn.min(TAU - turn) * expected.theta_h.sin() * expected.theta_d.sin();
        worst = worst
            .max((f64::from(value[0]) - expected.theta_h).abs())
            .max((f64::from(value[1]) - expected.theta_d).abs())
            .max(around);
    }
    worst
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn half_and_difference_angles_agree() {
    let gpu = gpu();
    let library = shader::library();
    let worst = worst_angle_distance(&gpu, &library);
    println!("angles: worst distance {worst:.2e} rad");
    // Measured: 3.3e-6 at worst. A bin of θ_h is 2e-4 rad at its narrowest.
    assert!(worst < 1e-5, "{worst:e}");
    let swapped = library.replace("let across = wi - wo;", "let across = wo - wi;");
    assert!(
        worst_angle_distance(&gpu, &swapped) > 1e-2,
        "a swapped axis went unnoticed"
    );
}

/// A table of smooth but uneven values with invalid cells strewn in.
fn strewn_table(grid: Grid) -> Table {
    let mut random = Random(3);
    let cells = (0..grid.len())
        .map(|_| {
            if random.unit() < 0.1 {
                [-1.0; 3]
            } else {
                [0; 3].map(|_| random.between(0.5, 1.5) as f32)
            }
        })
        .collect();
    Table::new(grid, cells)
}

/// Largest distance of looked-up values away from the edges of cells, and whether validity agrees everywhere.
fn worst_lookup_distance(gpu: &Gpu, library: &str, grid: Grid, lookup: Lookup) -> (f64, bool) {
    let table = strewn_table(grid);
    let texture = TableTexture::upload(&gpu.device, &gpu.queue, &table);
    let mut random = Random(4);
    let pairs: Vec<(DVec3, DVec3)> = std::iter::repeat_with(|| pair(&mut random, 0))
        .filter(|(wi, wo)| {
            let angles = HalfDiff::from_directions(*wi, *wo).expect("has a half vector");
            grid.bin_coordinates(angles)
                .iter()
                .all(|u| (0.02..0.98).contains(&u.fract()))
        })
        .take(PAIRS)
        .collect();
    let inputs: Vec<_> = pairs
        .iter()
        .flat_map(|(wi, wo)| [slot(*wi), slot(*wo)])
        .collect();
    let smoothly = lookup == Lookup::Smooth;
    let shader = format!(
        "{library}
fn item(index: u32) -> vec4f {{
    return lookup_table(table, {smoothly}, inputs[2u * index].xyz, inputs[2u * index + 1u].xyz);
}}"
    );
    let (mut worst, mut same_validity): (f64, bool) = (0.0, true);
    for ((wi, wo), value) in
        pairs
            .iter()
            .zip(evaluate(gpu, &shader, &inputs, PAIRS, Some(&texture)))
    {
        let expected = table.lookup(*wi, *wo, lookup);
        same_validity &= expected.is_some() == (value[3] == 1.0);
        for (channel, expected) in expected.into_iter().flatten().enumerate() {
            worst = worst.max((f64::from(value[channel]) - expected).abs());
        }
    }
    (worst, same_validity)
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn lookups_agree_away_from_the_edges() {
    let gpu = gpu();
    let library = shader::library();
    for grid in [Grid::FOLDED, Grid::FULL] {
        for (lookup, tolerance) in [(Lookup::Nearest, 1e-7), (Lookup::Smooth, 1e-3)] {
            let (worst, same_validity) = worst_lookup_distance(&gpu, &library, grid, lookup);
            println!(
                "lookup {lookup:?} {}: worst distance {worst:.2e}",
                grid.phi_d_bins()
            );
            assert!(
                worst < tolerance && same_validity,
                "{grid:?} {lookup:?}: {worst:e} {same_validity}"
            );
        }
    }
    for (right, wrong) in [
        (
            "vec2i(bins.z, bins.y), bins.x",
            "vec2i(bins.z, bins.x), bins.y",
        ),
        ("u.z - 0.5", "u.z - 0.48"),
    ] {
        assert!(library.contains(right));
        let (worst, _) = worst_lookup_distance(
            &gpu,
            &library.replace(right, wrong),
            Grid::FOLDED,
            Lookup::Smooth,
        );
        assert!(worst > 5e-3, "{right} → {wrong} went unnoticed: {worst:e}");
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_srgb_curve_agrees() {
    let gpu = gpu();
    let inputs: Vec<[f32; 4]> = (0..2000).map(|k| [k as f32 / 1500.0 - 0.1; 4]).collect();
    let distance = |library: &str| {
        let shader = format!(
            "{library}\nfn item(index: u32) -> vec4f {{ return vec4f(srgb_encode(inputs[index].xyz), 0.0); }}"
        );
        let values = evaluate(&gpu, &shader, &inputs, inputs.len(), None);
        let distances = inputs
            .iter()
            .zip(values)
            .map(|(x, y)| (srgb_encode(f64::from(x[0])) - f64::from(y[0])).abs());
        distances.fold(0.0, f64::max)
    };
    let library = shader::library();
    assert!(distance(&library) < 1e-5);
    assert!(distance(&library.replace("1.0 / 2.4", "1.0 / 2.2")) > 1e-3);
}
