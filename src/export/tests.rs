use super::preset::{PRESETS, Preset, PresetMaterial, PresetModels, PresetOptions};
use super::{
    FigureFormat, FigureSpec, OpenedTables, Prepared, SubjectSource, SubjectSpec, open_from_files,
    prepare, spec_beside,
};
use crate::brdf::{COMBINED, Fresnel, MODELS, Model, PHONG_FAMILY};
use crate::figure::ViewSpec;
use crate::figure::faults::Faults;
use crate::figure::lobes::LobeScale;
use crate::figure::page::{RowSpec, Style};
use crate::figure::scale::RadialScale;
use crate::figure::sphere_image::SphereShow;
use crate::geom::sphere::SphereView;
use crate::measured::Lookup;
use std::ops::ControlFlow;
use std::path::Path;

fn options() -> PresetOptions {
    PresetOptions {
        models: Vec::new(),
        fresnel: Fresnel::Exact,
        theta_i: vec![0.5, 1.0],
        scale: None,
        view: SphereView::default(),
        style: Style {
            dpi: 40.0,
            width_mm: 40.0,
            ..Style::default()
        },
    }
}

fn materials(preset: &Preset, names: &[&str]) -> Vec<PresetMaterial> {
    materials_as(preset, names, &options())
}

fn materials_as(preset: &Preset, names: &[&str], options: &PresetOptions) -> Vec<PresetMaterial> {
    let model = |variant: crate::fit::Variant| variant.defaults();
    let material = |name: &&str| PresetMaterial {
        name: (*name).into(),
        source: Some(SubjectSource::Sample {
            key: "violet-felt".into(),
            lookup: Lookup::Nearest,
        }),
        models: preset.variants(options).into_iter().map(model).collect(),
        errors: Vec::new(),
    };
    names.iter().map(material).collect()
}

fn prepared(spec: &FigureSpec) -> Prepared {
    let mut opened = OpenedTables::new();
    let mut table = |source: &_| open_from_files(source, Path::new(""), false, &mut opened);
    prepare(spec, &mut table, &mut || ControlFlow::Continue(())).expect("is prepared")
}

#[test]
fn every_preset_is_read_back_and_names_subjects_that_are_there() {
    for preset in &PRESETS {
        let spec = preset.figure(&materials(preset, &["a", "b"]), &options());
        let again = FigureSpec::from_json(&spec.to_json()).expect("is read");
        assert_eq!(again.settled(), again, "{}", preset.key);
        let panels: Vec<_> = spec.rows.iter().flat_map(|row| &row.panels).collect();
        assert!(!panels.is_empty());
        for panel in panels {
            assert!(panel.subjects.iter().all(|at| *at < spec.subjects.len()));
            // Each panel has subjects of one material, but the scatter.
            let one = panel.subjects.iter().all(|at| {
                let per = spec.subjects.len() / 2;
                at / per == panel.subjects[0] / per
            });
            assert!(one || preset.key == "scatter", "{}", preset.key);
        }
        assert!(Preset::by_key(preset.key).is_some_and(|found| found.key == preset.key));
    }
    assert!(Preset::by_key("picture").is_none());
}

#[test]
fn the_poster_has_a_sphere_and_lobes_of_everything() {
    let preset = Preset::by_key("poster").expect("a preset");
    let spec = preset.figure(&materials(preset, &["a", "b"]), &options());
    assert_eq!(spec.rows.len(), 4);
    assert_eq!(spec.subjects.len(), 8);
    for (spheres, lobes) in [(0, 1), (2, 3)] {
        let shows: Vec<SphereShow> = spec.rows[spheres]
            .panels
            .iter()
            .filter_map(|panel| match &panel.view {
                ViewSpec::Sphere(spec) => Some(spec.show),
                _ => None,
            })
            .collect();
        let model = SphereShow::Model;
        assert_eq!(shows, [SphereShow::Measured, model, model, model]);
        // What was measured is under every model too.
        let data = spec.rows[spheres].panels[0].subjects[0];
        assert!(
            spec.rows[lobes]
                .panels
                .iter()
                .all(|panel| panel.subjects[0] == data)
        );
    }
}

#[test]
fn spheres_of_many_models_wrap_in_even_rows_of_one_size() {
    let preset = Preset::by_key("poster").expect("a preset");
    for (models, rows) in [
        (1, vec![2]),
        (2, vec![3]),
        (5, vec![6]),
        (6, vec![4, 3]),
        (12, vec![5, 5, 3]),
    ] {
        let options = PresetOptions {
            models: MODELS.iter().copied().cycle().take(models).collect(),
            ..options()
        };
        let spec = preset.figure(&materials_as(preset, &["a", "b"], &options), &options);
        let (spheres, lobes): (Vec<_>, Vec<_>) = spec
            .rows
            .iter()
            .partition(|row| matches!(row.panels[0].view, ViewSpec::Sphere(_)));
        let counts: Vec<usize> = spheres.iter().map(|row| row.panels.len()).collect();
        assert_eq!(counts, [&rows[..], &rows[..]].concat());
        assert_eq!(lobes.len(), 2);
        assert_eq!(lobes[1].panels[0].subjects.len(), 1 + models);
        let high = spheres[0].height_mm;
        assert!(spheres.iter().all(|row| row.height_mm == high));
        assert_eq!(high.is_some(), rows.len() > 1);
        // Each has its name where it is not under another row of the same.
        let named = |row: &&&RowSpec| row.panels.iter().all(|panel| panel.heading.is_some());
        let named = spheres.iter().filter(named).count();
        assert_eq!(named, if rows.len() > 1 { spheres.len() } else { 1 });
        let mut faults = Faults::default();
        spec.clone().sanitize(&mut faults);
        assert_eq!(faults.result(), Ok(()));
    }
}

#[test]
fn several_models_are_shown_where_it_makes_sense_and_refused_where_not() {
    for preset in &PRESETS {
        let asked = |models: &[&'static Model]| PresetOptions {
            models: models.to_vec(),
            ..options()
        };
        let (none, one, two) = (asked(&[]), asked(&MODELS[..1]), asked(&MODELS[..2]));
        assert_eq!(preset.check(&none), Ok(()));
        let shown = preset.models(&none);
        let several = match preset.models {
            PresetModels::Family => {
                assert_eq!(shown, PHONG_FAMILY);
                true
            }
            PresetModels::Several => true,
            PresetModels::One | PresetModels::Combined => false,
        };
        assert!(several == (shown.len() > 1) || shown == [&COMBINED]);
        assert_eq!(preset.check(&two).is_ok(), several, "{}", preset.key);
        let combined = preset.models == PresetModels::Combined;
        assert_eq!(preset.check(&one).is_err(), combined, "{}", preset.key);
        assert_eq!(preset.check(&asked(&[&COMBINED])), Ok(()));
        if several {
            assert_eq!(preset.models(&two), &MODELS[..2]);
        }
    }
    // Over one material each model has a line of its own; the data are the first colour.
    let lobes = Preset::by_key("lobes").expect("a preset");
    let options = PresetOptions {
        models: MODELS.to_vec(),
        ..options()
    };
    let spec = lobes.figure(&materials_as(lobes, &["a", "b"], &options), &options);
    let of_first = &spec.subjects[..=MODELS.len()];
    assert_eq!((of_first[0].series, &*of_first[0].label), (0, "measured"));
    for (k, subject) in of_first.iter().enumerate() {
        let same =
            |other: &&SubjectSpec| (other.series, other.look) == (subject.series, subject.look);
        assert_eq!(of_first.iter().position(|other| same(&other)), Some(k));
    }
}

#[test]
fn a_sphere_alone_is_an_exr_and_other_figures_are_not() {
    let preset = Preset::by_key("sphere").expect("a preset");
    let spec = preset.figure(&materials(preset, &["a"]), &options());
    let prepared_sphere = prepared(&spec);
    let page = spec.draw(&prepared_sphere, true).expect("a page");
    let bytes = FigureFormat::Exr
        .bytes(&spec, &prepared_sphere, &page)
        .expect("an EXR");
    let picture = image::load_from_memory(&bytes)
        .expect("an EXR")
        .to_rgba32f();
    assert_eq!(picture.dimensions(), (63, 63));
    assert!(picture.pixels().any(|pixel| pixel[0] > 0.01));
    assert!(
        FigureFormat::Csv
            .bytes(&spec, &prepared_sphere, &page)
            .is_err()
    );
    let two = preset.figure(&materials(preset, &["a", "b"]), &options());
    let prepared_two = prepared(&two);
    let page = two.draw(&prepared_two, true).expect("a page");
    let said = FigureFormat::Exr.bytes(&two, &prepared_two, &page);
    assert!(said.expect_err("two").to_string().contains("one sphere"));
}

#[test]
fn a_scale_that_is_asked_for_is_that_of_all_lobes() {
    let preset = Preset::by_key("lobes").expect("a preset");
    let asked = PresetOptions {
        scale: Some(RadialScale::Log),
        ..options()
    };
    let spec = preset.figure(&materials(preset, &["a", "b"]), &asked);
    for panel in spec.rows.iter().flat_map(|row| &row.panels) {
        let ViewSpec::Lobes(lobes) = &panel.view else {
            panic!("{panel:?}");
        };
        assert_eq!(lobes.scale, LobeScale::Log);
        assert_eq!(lobes.theta_i, [0.5, 1.0]);
    }
}

#[test]
fn a_format_is_that_of_the_name_and_the_spec_is_beside() {
    let of = |name: &str| FigureFormat::of_path(Path::new(name));
    assert_eq!(of("a/b.SVG"), Some(FigureFormat::Svg));
    assert_eq!(of("b.exr"), Some(FigureFormat::Exr));
    assert_eq!(of("b.gif"), None);
    assert_eq!(of("svg"), None);
    assert_eq!(
        spec_beside(Path::new("a/b.pdf")),
        Path::new("a/b.figure.json")
    );
}

#[test]
fn a_landscape_is_computed_once_for_all_panels_that_show_it() {
    let preset = Preset::by_key("landscape").expect("a preset");
    let mut spec = preset.figure(&materials(preset, &["a"]), &options());
    let landscapes = |spec: &FigureSpec| {
        let mut opened = OpenedTables::new();
        let mut table = |source: &_| open_from_files(source, Path::new(""), false, &mut opened);
        let mut steps = 0;
        let follow = &mut || {
            steps += 1;
            ControlFlow::Continue(())
        };
        let made = prepare(spec, &mut table, follow).expect("is prepared").made;
        (steps, made)
    };
    let (once, alone) = landscapes(&spec);
    let panel = spec.rows[0].panels[0].clone();
    spec.rows[0].panels.push(panel);
    // What is in sight is no matter.
    if let ViewSpec::Landscape(seen) = &mut spec.rows[0].panels[1].view {
        seen.view.x = (0.0, 0.5);
    }
    let (twice, both) = landscapes(&spec);
    assert_eq!(twice, once);
    assert_eq!(both, [alone.clone(), alone].concat());
    // Planted: with another limit it is another one.
    if let ViewSpec::Landscape(seen) = &mut spec.rows[0].panels[1].view {
        seen.limit = 1.2;
    }
    assert!(landscapes(&spec).0 > once);
}
