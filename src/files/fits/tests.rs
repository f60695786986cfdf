use super::*;
use crate::brdf::COMBINED;
use crate::brdf::ParamId;
use crate::brdf::params::lobe_values;
use crate::brdf::{Brdf, Fresnel, MODELS, Params};
use crate::fit::{EndReason, Errors, FitOptions, Partial, STAGES, Weight};

fn record(model: usize, fresnel: Fresnel) -> FitRecord {
    let brdf = Brdf {
        model: MODELS[model],
        fresnel,
        params: Params {
            rho_d: [0.1 + 0.2, 1.0 / 3.0, 0.0],
            k_s: [1e-7, 12.5, 1e9 / 7.0],
            lobe: if MODELS[model].params[0].key() == "roughness" {
                lobe_values([1.0 / 3.0, 0.7])
            } else {
                lobe_values([100.0 / 3.0, 0.7])
            },
            eta: 1.1,
        },
    };
    let mut options = FitOptions {
        start: Partial {
            shared: [("s", 30.0), ("alpha", 0.25)]
                .map(|(key, value)| (ParamId(key), value))
                .into(),
            ..Partial::default()
        },
        held: Partial {
            rho_d: Some([0.1, 0.2, 0.3]),
            ..Partial::default()
        },
        ..FitOptions::default()
    };
    options.stages.shape = false;
    options.bounds.insert(ParamId("s"), (1.0, 500.0));
    FitRecord {
        material: "half \"brass\", β".into(),
        source: Some(SourceFile {
            path: "/data/half brass.binary".into(),
            bytes: Some(34_992_012),
            sha256: Some("ab".repeat(32)),
        }),
        version: "0.0.9".into(),
        weight: Weight::SolidAngle,
        limit_deg: 80.1,
        options,
        brdf,
        errors: Errors {
            total: 0.1234567890123456,
            grazing: None,
            channels: [0.1, f64::NAN, 0.3],
        },
        stages: STAGES
            .into_iter()
            .map(|stage| StageRecord {
                stage,
                start_error: 0.5,
                error: 0.5 / stage.number() as f64,
                evaluations: 7,
                params: brdf.params,
            })
            .collect(),
        albedo: [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 1.1, 0.9]],
        evaluations: 28,
        ended: EndReason::Limit,
        concerns: vec!["s ended at its bound 500; the best may lie beyond.".into()],
    }
}

fn json_of(fits: &[FitRecord]) -> String {
    let mut bytes = Vec::new();
    write_json(fits, &mut bytes).expect("memory takes it");
    String::from_utf8(bytes).expect("UTF-8")
}

#[test]
fn what_is_written_is_read_back_bit_by_bit() {
    for fresnel in crate::brdf::fresnel::FRESNELS {
        for (model, row) in MODELS.iter().enumerate() {
            let written = record(model, fresnel);
            let text = json_of(std::slice::from_ref(&written));
            let mut read = entries(&text).expect("is read");
            assert_eq!(read.len(), 1);
            let entry = read.remove(0);
            assert_eq!(entry.material.as_ref(), Some(&written.material));
            assert_eq!(entry.source, written.source);
            assert_eq!(entry.error, Some(written.errors.total));
            let mut fit = entry.fit.expect("is a fit");
            assert_eq!(json_of(&[(*fit).clone()]), text);
            assert!(fit.errors.channels[1].is_nan());
            fit.errors.channels[1] = 0.0;
            let mut expected = written.clone();
            expected.errors.channels[1] = 0.0;
            // What the model lacks is not kept.
            let lobe = row.params;
            expected.brdf.params.lobe[lobe.len()..].fill(0.0);
            let has = |id: &ParamId| *id == ParamId::ETA || lobe.iter().any(|row| row.id == *id);
            expected.options.bounds.retain(|id, _| has(id));
            let start = &mut expected.options.start.shared;
            start.retain(|id, _| has(id));
            if fresnel == Fresnel::None {
                expected.brdf.params.eta = COMBINED.default_params().eta;
            }
            for stage in &mut expected.stages {
                stage.params = expected.brdf.params;
            }
            assert_eq!(*fit, expected);
            // A planted change is seen.
            expected.limit_deg = 80.10000000000001;
            assert_ne!(*fit, expected);
        }
    }
}

#[test]
fn a_plain_model_is_no_fit_and_a_bad_entry_is_named() {
    let plain =
        r#"{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": 3, "source": "a paper"}"#;
    let read = entries(plain).expect("is read");
    let [entry] = &read[..] else {
        panic!("{read:?}")
    };
    assert_eq!(
        (&entry.fit, &entry.source, entry.error),
        (&None, &None, None)
    );
    let said = |text: &str| entries(text).expect_err("is bad");
    assert!(said(&format!("[{plain}, {{}}]")).starts_with("entry 1: \"model\" is missing"));
    assert!(said("[]").contains("empty"));
    assert!(said("[{\"model\"").starts_with("not valid JSON"));
    assert!(said("[3]").starts_with("entry 0: expected a JSON object"));
    // A fit that lacks a key is a model all the same.
    let text = json_of(&[record(2, Fresnel::Exact)]).replace("\"evaluations\":28,", "");
    let read = entries(&text).expect("is read");
    assert!(read[0].fit.is_none() && read[0].source.is_some());
}

#[test]
fn two_files_of_the_same_bytes_are_two_materials_and_a_moved_one_stays_one() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["a", "b"] {
        std::fs::create_dir(folder.path().join(name)).expect("a folder");
    }
    let there = [
        "red.binary",
        "blue.binary",
        "a/steel.binary",
        "b/steel.binary",
    ];
    for name in there {
        std::fs::write(folder.path().join(name), "x").expect("is written");
    }
    let fit = |path: &str, error: f64| {
        let mut fit = record(0, Fresnel::None);
        fit.material = crate::files::material_name(path.as_ref());
        fit.source = Some(SourceFile {
            path: path.into(),
            bytes: None,
            sha256: Some("a".into()),
        });
        fit.errors.total = error;
        fit
    };
    let mut fits: Vec<_> = there.iter().map(|path| fit(path, 0.1)).collect();
    // Where they were before, of the same name and the same bytes.
    fits.extend([fit("/gone/red.binary", 0.2), fit("/gone/blue.binary", 0.3)]);
    let path = folder.path().join("fits.json");
    let all = by_material(&path, entries(&json_of(&fits)).expect("is read"));
    let found: Vec<_> = all.iter().filter_map(|fits| fits.found.clone()).collect();
    assert_eq!(found, there.map(|name| folder.path().join(name)));
    let counts: Vec<usize> = all.iter().map(|fits| fits.entries.len()).collect();
    assert_eq!(counts, [2, 2, 1, 1]);
}

#[test]
fn fits_of_one_material_are_together_the_best_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path().join("gold.binary");
    std::fs::write(&here, "x").expect("is written");
    let fit = |path: &str, sha256: &str, error: f64| {
        let mut fit = record(0, Fresnel::None);
        fit.source = Some(SourceFile {
            path: path.into(),
            bytes: None,
            sha256: Some(sha256.into()),
        });
        fit.errors.total = error;
        fit
    };
    let text = json_of(&[
        fit("/gone/gold.binary", "a", 0.3),
        fit("C:\\far\\silver.binary", "b", 0.2),
        fit("/gone/gold.binary", "a", 0.1),
        fit("/copied/gold2.binary", "A", 0.2),
        fit("gold.binary", "c", 0.2),
    ]);
    let plain = r#"{"model": "phong", "rho_d": [1, 0, 0], "k_s": [1, 2, 4], "s": 3}"#;
    let text = text.replace("\n]", &format!(",{plain},{plain}]"));
    let all = by_material(
        &folder.path().join("fits.json"),
        entries(&text).expect("is read"),
    );
    let errors: Vec<Vec<Option<f64>>> = all
        .iter()
        .map(|fits| fits.entries.iter().map(|entry| entry.error).collect())
        .collect();
    assert_eq!(
        errors,
        [
            vec![Some(0.1), Some(0.2), Some(0.3)],
            vec![Some(0.2)],
            vec![Some(0.2)],
            vec![None],
            vec![None]
        ]
    );
    // Moved: it is found beside the file. A relative path counts from the file too.
    assert_eq!(all[0].found.as_ref(), Some(&here));
    assert_eq!(all[2].found.as_ref(), Some(&here));
    assert!(all[1].found.is_none());
    assert!(all[1].places[1].ends_with("silver.binary"));
    assert_eq!(
        (all[3].name.as_str(), all[4].name.as_str()),
        ("fits 5", "fits 6")
    );
}

/// The definition of [`by_material`], one pair at a time: positions of entries by material.
fn plain_groups(folder: &std::path::Path, entries: &[FitEntry]) -> Vec<Vec<usize>> {
    struct Group {
        source: Option<SourceFile>,
        found: Option<std::path::PathBuf>,
        name: String,
        members: Vec<usize>,
    }
    let mut all: Vec<Group> = Vec::new();
    for (index, entry) in entries.iter().enumerate() {
        let places = entry.source.iter().flat_map(|source| source.places(folder));
        let found = places.into_iter().find(|place| place.is_file());
        let belongs = |group: &Group| match (&entry.source, &group.source) {
            (Some(a), Some(b)) if a.path == b.path => true,
            (Some(a), Some(b)) if a.same_data(b) == Some(true) => {
                let both = found.as_ref().zip(group.found.as_ref());
                let mut members = group.members.iter();
                members.all(|other| entries[*other].material == entry.material)
                    && both.is_none_or(|(found, other)| found == other)
            }
            (None, None) => entry.material.as_ref() == Some(&group.name),
            _ => false,
        };
        match all.iter_mut().find(|group| belongs(group)) {
            Some(group) => {
                group.members.push(index);
                group.found = group.found.take().or(found);
            }
            None => all.push(Group {
                source: entry.source.clone(),
                found,
                name: entry.material.clone().unwrap_or(format!("fits {index}")),
                members: vec![index],
            }),
        }
    }
    all.into_iter().map(|group| group.members).collect()
}

#[test]
fn entries_are_grouped_as_the_definition_has_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["here.binary", "there.binary"] {
        std::fs::write(folder.path().join(name), "x").expect("is written");
    }
    let mut seed = 7u64;
    let mut draw = |below: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        ((seed >> 33) % below) as usize
    };
    let mut together = 0;
    for _ in 0..2000 {
        let count = 2 + draw(8);
        let entries: Vec<FitEntry> = (0..count)
            .map(|index| FitEntry {
                brdf: record(0, Fresnel::None).brdf,
                material: [None, Some("a"), Some("b"), Some("fits 0")][draw(4)].map(String::from),
                source: (draw(4) > 0).then(|| SourceFile {
                    path: ["here.binary", "there.binary", "/gone/1", "/gone/2"][draw(4)].into(),
                    bytes: None,
                    sha256: [None, Some("ab"), Some("AB"), Some("cd")][draw(4)].map(String::from),
                }),
                // The order of the entries is that of E.
                error: Some(index as f64),
                fit: None,
            })
            .collect();
        let expected = plain_groups(folder.path(), &entries);
        let found: Vec<Vec<usize>> = by_material(&folder.path().join("fits.json"), entries)
            .iter()
            .map(|fits| {
                fits.entries
                    .iter()
                    .map(|entry| entry.error.expect("E") as usize)
                    .collect()
            })
            .collect();
        assert_eq!(found, expected);
        together += usize::from(found.iter().any(|group| group.len() > 1));
    }
    assert!(together > 1000, "{together}");
}
