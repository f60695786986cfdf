//! Exported models read back: as shaders by naga, and as numbers on the adapter against the CPU.

use crate::common::gpu::{evaluate, gpu};
use crate::common::random::Random;
use glam::DVec3;
use grazing::brdf::fresnel::FRESNELS;
use grazing::brdf::params::Scale;
use grazing::brdf::{Brdf, MODELS, codegen};
use grazing::geom::{direction, mirror};
use grazing::gpu::adapter::Gpu;
use naga::ShaderStage;
use naga::back::wgsl::WriterFlags;
use naga::front::{glsl, wgsl};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Every model with every Fresnel factor, twice, with numbers from all over their ranges.
fn brdfs() -> Vec<Brdf> {
    let mut random = Random(11);
    let all = || MODELS.iter().flat_map(|m| FRESNELS.map(|f| (*m, f)));
    let cases = all().chain(all());
    cases
        .map(|(model, fresnel)| {
            let color = |random: &mut Random, low: f64, high: f64| {
                [0; 3].map(|_| random.log_between(low, high))
            };
            let mut brdf = Brdf::new(model, fresnel);
            brdf.params.rho_d = color(&mut random, 0.01, 1.0);
            brdf.params.k_s = color(&mut random, 0.01, 1e3);
            brdf.params.eta = 1.0 + random.log_between(1e-3, 2.0);
            for (value, row) in brdf.params.lobe.iter_mut().zip(model.params) {
                let (low, high) = row.range;
                *value = match row.scale {
                    Scale::Linear => random.between(low, high),
                    Scale::Log { .. } => random.log_between(10.0 * low, 0.1 * high),
                };
            }
            // The shaders have f32: with an exponent of 40,000 that alone is 5e-5 of the value.
            for row in model.rows() {
                for value in brdf.get_mut(row.id) {
                    *value = f64::from(*value as f32);
                }
            }
            brdf
        })
        .collect()
}

/// Pairs above the horizon, anywhere, near the mirror direction, or both grazing; every tenth below it.
fn pairs() -> Vec<(DVec3, DVec3)> {
    let mut random = Random(12);
    let pairs = (0..4000).map(|k| {
        let low = if k % 3 == 2 { 1.2 } else { 0.0 };
        let high = if k % 10 == 9 { 2.0 } else { FRAC_PI_2 - 1e-3 };
        let mut any = || direction(random.between(low, high), random.between(0.0, TAU));
        let (wi, wo) = (any(), any());
        let wo = if k % 3 == 1 {
            (mirror(wi) + random.log_between(1e-4, 0.5) * wo).normalize()
        } else {
            wo
        };
        let rounded = |w: DVec3| w.as_vec3().as_dvec3();
        (rounded(wi), rounded(wo))
    });
    pairs.collect()
}

fn validated(module: &naga::Module) -> ModuleInfo {
    Validator::new(ValidationFlags::all(), Capabilities::default())
        .validate(module)
        .expect("a valid module")
}

/// GLSL with its functions as WGSL, by way of naga; `uses` names what has to be there.
fn glsl_as_wgsl(text: &str) -> String {
    let source = format!("#version 450\n{text}\nvoid main() {{}}\n");
    let options = glsl::Options::from(ShaderStage::Compute);
    let module = glsl::Frontend::default().parse(&options, &source);
    let module = module.unwrap_or_else(|errors| panic!("{}", errors.emit_to_string(&source)));
    let info = validated(&module);
    let wgsl = naga::back::wgsl::write_string(&module, &info, WriterFlags::empty());
    // The entry point that GLSL must have.
    let wgsl = wgsl.expect("WGSL");
    let entry = wgsl.find("@compute").expect("an entry point");
    wgsl[..entry].to_string()
}

/// Largest distance of `brdf(wi, wo)` of a WGSL text from the CPU, relative to the value; 0 is wanted below the horizon.
fn worst_distance(gpu: &Gpu, text: &str, brdf: &Brdf) -> f64 {
    let pairs = pairs();
    let slot = |w: DVec3| {
        let [x, y, z] = w.as_vec3().to_array();
        [x, y, z, 0.0]
    };
    let inputs: Vec<[f32; 4]> = pairs
        .iter()
        .flat_map(|(wi, wo)| [slot(*wi), slot(*wo)])
        .collect();
    let shader = format!(
        "{text}
fn item(index: u32) -> vec4f {{
    return vec4f(brdf(inputs[2u * index].xyz, inputs[2u * index + 1u].xyz), 1.0);
}}"
    );
    let values = evaluate(gpu, &shader, &inputs, pairs.len(), None);
    let mut worst: f64 = 0.0;
    for ((wi, wo), value) in pairs.iter().zip(values) {
        let expected = brdf.f_r(*wi, *wo);
        for channel in 0..3 {
            let value = f64::from(value[channel]);
            worst = worst.max(match expected {
                Some(expected) => (value - expected[channel]).abs() / expected[channel],
                None if value == 0.0 => 0.0,
                None => f64::INFINITY,
            });
        }
    }
    worst
}

/// That of the twins.
const TOLERANCE: f64 = 2e-5;

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_wgsl_function_is_the_model() {
    for brdf in brdfs() {
        let text = codegen::wgsl(&brdf, Some("teflon"));
        let module = wgsl::parse_str(&text);
        validated(&module.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text))));
    }
    let gpu = gpu();
    let mut worst: f64 = 0.0;
    for brdf in brdfs() {
        worst = worst.max(worst_distance(&gpu, &codegen::wgsl(&brdf, None), &brdf));
    }
    println!("WGSL: worst relative distance {worst:.2e}");
    assert!(worst < TOLERANCE, "{worst:e}");
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_glsl_function_is_the_model() {
    let texts: Vec<(Brdf, String)> = brdfs()
        .into_iter()
        .map(|brdf| (brdf, glsl_as_wgsl(&codegen::glsl(&brdf, Some("teflon")))))
        .collect();
    let gpu = gpu();
    let mut worst: f64 = 0.0;
    for (brdf, text) in &texts {
        worst = worst.max(worst_distance(&gpu, text, brdf));
    }
    println!("GLSL: worst relative distance {worst:.2e}");
    assert!(worst < TOLERANCE, "{worst:e}");
}

/// A `.brdf` file as its program reads it: blank lines and `#` lines are skipped, sections begin and end.
struct Disney {
    floats: BTreeMap<String, [f64; 3]>,
    colors: BTreeMap<String, [f64; 3]>,
    shader: String,
}

impl Disney {
    fn read(text: &str) -> Self {
        let mut lines = text.lines();
        assert_eq!(lines.next(), Some("analytic"));
        let mut section = String::new();
        let mut file = Self {
            floats: BTreeMap::new(),
            colors: BTreeMap::new(),
            shader: String::new(),
        };
        for line in lines {
            let trimmed = line.trim();
            let words: Vec<&str> = trimmed.split_whitespace().collect();
            match (&words[..], section.as_str()) {
                ([], _) => {}
                _ if trimmed.starts_with('#') => {}
                (["::begin", name], "") => section = name.to_string(),
                (["::end", name], inside) => {
                    assert_eq!(*name, inside);
                    section.clear();
                }
                ([kind, name, numbers @ ..], "parameters") => {
                    let numbers: Vec<f64> = numbers
                        .iter()
                        .map(|number| number.parse().expect("a number"))
                        .collect();
                    let numbers: [f64; 3] = numbers.try_into().expect("three numbers");
                    let into = match *kind {
                        "float" => &mut file.floats,
                        "color" => &mut file.colors,
                        other => panic!("{other}"),
                    };
                    assert_eq!(into.insert(name.to_string(), numbers), None);
                }
                (_, "shader") => file.shader += &format!("{line}\n"),
                other => panic!("{other:?}"),
            }
        }
        assert_eq!(section, "");
        file
    }

    /// The shader with its uniforms at their defaults, and `brdf` in the local frame turned by a planted frame.
    fn glsl(&self) -> String {
        let floats = self.floats.iter();
        let floats =
            floats.map(|(name, [_, _, value])| format!("const float {name} = {value:?};\n"));
        let colors = self.colors.iter();
        let colors = colors.map(|(name, rgb)| {
            let [r, g, b] = rgb.map(|x| format!("{x:?}"));
            format!("const vec3 {name} = vec3({r}, {g}, {b});\n")
        });
        let uniforms: String = floats.chain(colors).collect();
        // Another frame than the coordinate axes: X = y, Y = z, N = x.
        format!(
            "{uniforms}{}
vec3 brdf(vec3 wi, vec3 wo) {{
    return BRDF(wi.zxy, wo.zxy, vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
}}",
            self.shader
        )
    }
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_disney_file_has_the_ranges_and_the_numbers_and_its_shader_is_the_model() {
    let files: Vec<(Brdf, Disney)> = brdfs()
        .into_iter()
        .map(|brdf| (brdf, Disney::read(&codegen::disney(&brdf, Some("teflon")))))
        .collect();
    for (brdf, file) in &files {
        for row in brdf.used() {
            let log = format!("log10_{}", row.key());
            let ([low, high, value], back): (_, fn(f64) -> f64) = match file.floats.get(&log) {
                Some(slider) => (*slider, |x| 10_f64.powf(x)),
                None => (file.floats[row.key()], |x| x),
            };
            assert!((low..=high).contains(&value), "{}", row.key());
            assert!(
                (back(high) / row.range.1 - 1.0).abs() < 1e-9,
                "{}",
                row.key()
            );
            assert!(back(low) >= row.range.0 * (1.0 - 1e-9) && back(low) <= row.range.0 + 1.1e-4);
            let shade = file.colors.get(&format!("{}_color", row.key()));
            for (k, wanted) in brdf.get(row.id).iter().enumerate() {
                let found = back(value) * shade.map_or(1.0, |shade| shade[k]);
                assert!(
                    (found / wanted - 1.0).abs() < 1e-12,
                    "{}: {found} {wanted}",
                    row.key()
                );
            }
            assert!(shade.is_none_or(|shade| shade.iter().all(|x| (0.0..=1.0).contains(x))));
        }
        assert_eq!(file.floats.len(), brdf.used().count(), "and no others");
    }
    let texts: Vec<(&Brdf, String)> = files
        .iter()
        .map(|(brdf, file)| (brdf, glsl_as_wgsl(&file.glsl())))
        .collect();
    let gpu = gpu();
    let mut worst: f64 = 0.0;
    for (brdf, text) in &texts {
        worst = worst.max(worst_distance(&gpu, text, brdf));
    }
    println!(".brdf: worst relative distance {worst:.2e}");
    assert!(worst < 3.0 * TOLERANCE, "{worst:e}");
}

#[test]
fn a_black_model_has_a_disney_file_too() {
    let mut brdf = brdfs()[6];
    brdf.params.k_s = [0.0; 3];
    let file = Disney::read(&codegen::disney(&brdf, None));
    assert_eq!(file.colors["k_s_color"], [0.0; 3]);
    assert!(file.floats["log10_k_s"].iter().all(|x| x.is_finite()));
    // Values beyond the sliders widen them.
    brdf.params.rho_d = [3.0, 1.0, 0.0];
    brdf.params.k_s = [1e9; 3];
    let file = Disney::read(&codegen::disney(&brdf, None));
    assert_eq!(file.floats["rho_d"], [0.0, 3.0, 3.0]);
    assert_eq!(file.floats["log10_k_s"], [-4.0, 9.0, 9.0]);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn planted_errors_are_caught() {
    let gpu = gpu();
    let brdf = brdfs()[7];
    assert_eq!((brdf.model.key, brdf.fresnel.key()), ("combined", "exact"));
    let (wgsl, glsl) = (codegen::wgsl(&brdf, None), codegen::glsl(&brdf, None));
    for (right, wrong) in [
        ("0.3183098861837907", "0.3185"),
        ("return 0.5 * a * a", "return 0.501 * a * a"),
        ("-wi.x, -wi.y, wi.z", "-wi.y, -wi.x, wi.z"),
        ("wo.z) < 0.0", "wo.z) < -1.0"),
        (
            "+ alpha * brdf_versine_pow4",
            "+ 1.01 * alpha * brdf_versine_pow4",
        ),
    ] {
        let planted = |text: &str| {
            assert!(text.contains(right), "{right} is not in the text any more");
            text.replace(right, wrong)
        };
        let first = worst_distance(&gpu, &planted(&wgsl), &brdf);
        let second = worst_distance(&gpu, &glsl_as_wgsl(&planted(&glsl)), &brdf);
        assert!(first.min(second) > 2.0 * TOLERANCE, "{right} → {wrong}");
    }
    // Of every model, in every language.
    for model in MODELS {
        let mut brdfs = brdfs().into_iter();
        let brdf = brdfs.find(|brdf| brdf.model == *model).expect("a case");
        let texts = [
            codegen::wgsl(&brdf, None),
            glsl_as_wgsl(&codegen::glsl(&brdf, None)),
            glsl_as_wgsl(&Disney::read(&codegen::disney(&brdf, None)).glsl()),
        ];
        let mut other = brdf;
        other.params.lobe[0] *= 1.001;
        for text in texts {
            let worst = worst_distance(&gpu, &text, &other);
            assert!(worst > 3.0 * TOLERANCE, "{}: {worst:e}", model.key);
        }
    }
}
