//! Files that the program writes, as a beginning for each target: where SEEDS names a folder, they are written there.

use grazing::app::msg::{Loaded, Msg};
use grazing::app::reduce;
use grazing::app::session::file::SessionFile;
use grazing::app::state::State;
use grazing::app::state::fitting::kept::KeptFit;
use grazing::app::state::material::Origin;
use grazing::brdf::fresnel::FRESNELS;
use grazing::brdf::{self, Brdf, Fresnel, MODELS};
use grazing::export::SubjectSource;
use grazing::export::preset::{PRESETS, PresetMaterial, PresetOptions};
use grazing::figure::page::Style;
use grazing::files::fits::{self, FitRecord, SourceFile};
use grazing::fit::options::NO_LIMIT;
use grazing::fit::{Errors, FitOptions, Problem, Stage, StageSet, Variant, Weight, fit_all};
use grazing::geom::sphere::SphereView;
use grazing::measured::{SAMPLES, merl};
use std::ops::ControlFlow;
use std::path::Path;
use std::{env, fs};

/// Writes the files of a target into the folder that SEEDS names, if it does.
pub fn write(target: &str) {
    let Some(folder) = env::var_os("SEEDS") else {
        return;
    };
    let seeds = match target {
        "merl" => measured().map(|bytes| [&[0], &*bytes].concat()).into(),
        "models" => texts(models())
            .map(|text| [b"\0", &*text].concat())
            .collect(),
        "fits" => texts(vec![fit_file(), one_entry()]).collect(),
        "session" => texts(vec![session()]).collect(),
        "figure" => texts(figures()).collect(),
        "directions" => texts(directions()).collect(),
        _ => every_kind(),
    };
    for (index, seed) in seeds.iter().enumerate() {
        let path = Path::new(&folder).join(format!("{target}-{index}"));
        fs::write(&path, seed).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
}

/// One file of each kind, under the name of that kind.
fn every_kind() -> Vec<Vec<u8>> {
    let named = |name: u8, bytes: Vec<u8>| [&[name], &*bytes].concat();
    let json = [
        models(),
        vec![fit_file(), session()],
        figures(),
        directions(),
    ];
    let json = texts(json.concat()).map(|bytes| named(0, bytes));
    json.chain(measured().map(|bytes| named(1, bytes)))
        .collect()
}

fn texts(texts: Vec<String>) -> impl Iterator<Item = Vec<u8>> {
    texts.into_iter().map(String::into_bytes)
}

/// The beginning of a measured file, and a whole header alone.
fn measured() -> [Vec<u8>; 2] {
    let mut bytes = Vec::new();
    merl::write(&SAMPLES[0].synthesize(), &mut bytes).expect("memory takes it");
    [bytes[..1024].to_vec(), bytes[..12].to_vec()]
}

fn models() -> Vec<String> {
    let all = MODELS
        .iter()
        .flat_map(|model| FRESNELS.map(|fresnel| Brdf::new(model, fresnel)));
    let all: Vec<_> = all.map(|brdf| brdf::json::to_value(&brdf)).collect();
    vec![all[8].to_string(), serde_json::Value::from(all).to_string()]
}

/// Quick fits of a sample.
fn records() -> Vec<FitRecord> {
    let table = SAMPLES[0].synthesize();
    let problem = Problem::new(&table, Weight::default(), NO_LIMIT).expect("there are data");
    let mut stages = StageSet::NONE;
    stages[Stage::by_number(1).expect("a stage")] = true;
    let options = FitOptions {
        stages,
        ..FitOptions::default()
    };
    let variants = [0, 2].map(|k| Variant {
        model: MODELS[k],
        fresnel: FRESNELS[k / 2],
    });
    let source = SourceFile {
        path: "/data/sample.binary".into(),
        bytes: Some(34_992_012),
        sha256: Some("ab".repeat(32)),
    };
    let go_on = &mut |_: usize, _: &grazing::fit::FitProgress| ControlFlow::Continue(());
    fit_all(&problem, &variants, &options, go_on)
        .iter()
        .map(|outcome| {
            let how = (Weight::default(), 90.0);
            FitRecord::new(
                "sample".into(),
                Some(source.clone()),
                how,
                &options,
                outcome,
            )
        })
        .collect()
}

fn fit_file() -> String {
    let mut bytes = Vec::new();
    fits::write_json(&records(), &mut bytes).expect("memory takes it");
    String::from_utf8(bytes).expect("text")
}

fn one_entry() -> String {
    fits::to_value(&records()[0]).to_string()
}

/// What is open after a start with a sample that was fitted.
fn session() -> String {
    let mut state = State::default();
    let sample = &SAMPLES[0];
    let loaded = Loaded::new(sample.name.into(), None, sample.synthesize());
    reduce::apply(
        &mut state,
        Msg::Loaded {
            job: 0,
            origin: Origin::Sample(0),
            result: Ok(loaded),
        },
    );
    for material in state.materials.values_mut() {
        material.fits = records().iter().map(KeptFit::from).collect();
    }
    SessionFile::of(&state).text().expect("data")
}

fn figures() -> Vec<String> {
    let options = PresetOptions {
        models: Vec::new(),
        fresnel: Fresnel::Exact,
        theta_i: vec![0.5, 1.0],
        scale: None,
        view: SphereView::default(),
        style: Style::default(),
    };
    let errors = Errors {
        total: 0.25,
        grazing: Some(0.5),
        channels: [0.25; 3],
    };
    let figure = |preset: &grazing::export::preset::Preset| {
        let models = preset.variants(&options);
        let material = PresetMaterial {
            name: "sample".into(),
            source: Some(SubjectSource::sample(SAMPLES[0].key)),
            models: models.iter().map(|variant| variant.defaults()).collect(),
            errors: models.iter().map(|_| errors).collect(),
        };
        preset.figure(&[material], &options).to_json()
    };
    PRESETS.iter().map(figure).collect()
}

fn directions() -> Vec<String> {
    let head = "theta_i,phi_i,theta_o,phi_o";
    vec![
        format!("{head}\n30,0,30,180\n89.5,-12,1e1,0\n"),
        format!("name, {head},more\r\n\"a, \"\"b\"\"\",1,2,3,4,\r\n\r\n\"\n\",0,360,0,-360,x\r\n"),
        format!("\u{feff}{head}\n0,0,0,0"),
    ]
}
