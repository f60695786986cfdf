//! What holds from stage to stage and from variant to variant.

use super::making::{fit, numbers, problem, sample, thinned, variant, watched};
use grazing::brdf::PHONG_FAMILY;
use grazing::brdf::{Fresnel, MODELS, Model};
use grazing::fit::{
    EndReason, FitOptions, Outcome, Partial, Problem, STAGES, Stage, StageSet, Variant, fit_all,
};
use std::ops::ControlFlow;

/// What a number may differ by for rounding alone.
const ROUNDING: f64 = 1e-6;

/// Which laws an outcome of all four stages breaks.
fn broken(problem: &Problem, outcome: &Outcome) -> Vec<String> {
    let mut broken = Vec::new();
    let mut law = |holds: bool, says: String| {
        if !holds {
            broken.push(says);
        }
    };
    let stages: Vec<Stage> = outcome.stages.iter().map(|report| report.stage).collect();
    law(stages == STAGES, format!("stages {stages:?}"));
    for report in &outcome.stages {
        let n = report.stage.number();
        law(
            report.error <= report.start_error * (1.0 + ROUNDING),
            format!("E rises in stage {n}"),
        );
        for (brdf, said) in [
            (report.start, report.start_error),
            (report.end, report.error),
        ] {
            let found = problem.errors(&brdf).total;
            law(
                (found / said - 1.0).abs() < ROUNDING,
                format!("stage {n} says {said}, it is {found}"),
            );
            for row in brdf.used() {
                let (low, high) = row.bounds;
                let inside = |x: &f64| (low..=high).contains(x);
                law(
                    brdf.get(row.id).iter().all(inside),
                    format!("stage {n}: {} is out of bounds", row.key()),
                );
            }
        }
        for row in report.start.model.rows() {
            let same = report.start.get(row.id) == report.end.get(row.id);
            law(
                same || report.stage.moves(row.id),
                format!("stage {n} moves {}", row.key()),
            );
        }
        law(report.evaluations > 0, format!("stage {n} tries nothing"));
    }
    for pair in outcome.stages.windows(2) {
        law(
            pair[1].error <= pair[0].error * (1.0 + ROUNDING),
            format!("E rises after stage {}", pair[0].stage.number()),
        );
    }
    if let Some(last) = outcome.stages.last() {
        law(last.end == outcome.brdf, "not where it ended".into());
        law(
            (last.error / outcome.errors.total - 1.0).abs() < ROUNDING,
            "another E than where it ended".into(),
        );
    }
    law(
        problem.errors(&outcome.brdf) == outcome.errors,
        "errors of another model".into(),
    );
    law(
        outcome.ended == EndReason::Converged,
        format!("{:?}", outcome.ended),
    );
    law(
        outcome.errors.total <= 1.0 + ROUNDING,
        "black is better".into(),
    );
    broken
}

/// E(combined) over the smaller of the other two, for one kind of Fresnel factor.
fn combined_to_others(outcomes: &[Outcome], fresnel: Fresnel) -> f64 {
    let error = |key: &str| {
        let of =
            |outcome: &&Outcome| outcome.brdf.model.key == key && outcome.brdf.fresnel == fresnel;
        let outcome = outcomes.iter().find(of).expect("was fitted");
        outcome.errors.total
    };
    error("combined") / error("phong").min(error("blinn-phong"))
}

#[test]
fn all_six_keep_the_laws() {
    let problem = problem(sample("copper-glaze"));
    let variants = Variant::of(PHONG_FAMILY, Fresnel::Exact);
    let outcomes = fit_all(&problem, &variants, &FitOptions::default(), &mut |_, _| {
        ControlFlow::Continue(())
    });
    assert_eq!(outcomes.len(), variants.len());
    for (variant, outcome) in variants.iter().zip(&outcomes) {
        assert_eq!(Variant::from(&outcome.brdf), *variant);
        let broken = broken(&problem, outcome);
        assert!(broken.is_empty(), "{variant:?}: {broken:?} {outcome:?}");
    }
    for fresnel in [Fresnel::None, Fresnel::Exact] {
        let ratio = combined_to_others(&outcomes, fresnel);
        assert!(ratio <= 1.0 + ROUNDING, "{fresnel:?}: {ratio}");
    }
    // The laws are the same for every model, and Lafortune is never worse than the Phong that it contains.
    let thin = super::making::problem(&thinned(sample("copper-glaze"), 8));
    let exact = |models: &[&'static Model]| {
        let of = |model: &&'static Model| Variant {
            model,
            fresnel: Fresnel::Exact,
        };
        let variants: Vec<Variant> = models.iter().map(of).collect();
        fit_all(&thin, &variants, &FitOptions::default(), &mut |_, _| {
            ControlFlow::Continue(())
        })
    };
    let every = exact(MODELS);
    for outcome in &every {
        let broken = broken(&thin, outcome);
        let key = outcome.brdf.model.key;
        assert!(broken.is_empty(), "{key}: {broken:?} {outcome:?}");
        // Alone it comes to the same as beside the others.
        let alone = exact(&[outcome.brdf.model]);
        assert!(
            (alone[0].errors.total / outcome.errors.total - 1.0).abs() < 1e-3,
            "{key}: {} {}",
            alone[0].errors.total,
            outcome.errors.total
        );
        for inner in outcome.brdf.model.contains {
            let found = every.iter().find(|other| other.brdf.model == inner.model);
            let ratio = outcome.errors.total / found.expect("was fitted").errors.total;
            assert!(
                ratio <= 1.0 + ROUNDING,
                "{key} {}: {ratio}",
                inner.model.key
            );
        }
    }
    // This one is between the models: the containment is strict.
    assert!(combined_to_others(&outcomes, Fresnel::Exact) < 0.99);

    // Planted, one law at a time.
    let planted = |change: &dyn Fn(&mut Outcome), says: &str| {
        let mut outcome = outcomes[5].clone();
        change(&mut outcome);
        let broken = broken(&problem, &outcome);
        assert!(
            broken.iter().any(|law| law.contains(says)),
            "{says}: {broken:?}"
        );
    };
    planted(&|o| o.stages[1].error *= 1.1, "stage 2 says");
    planted(&|o| o.stages[1].end = o.stages[3].end, "stage 2 moves");
    planted(&|o| o.stages.swap(0, 3), "E rises after stage");
    planted(
        &|o| o.stages.swap(1, 2),
        "stages [Amplitudes, ShapeAndSpecular",
    );
    planted(&|o| o.stages[2].start_error *= 0.1, "E rises in stage 3");
    planted(&|o| o.brdf.params.lobe[0] *= 1.01, "not where it ended");
    planted(&|o| o.errors.total *= 1.01, "errors of another model");
    planted(
        &|o| o.stages[0].start.params.lobe[0] = 2e5,
        "s is out of bounds",
    );
    let mut worse = outcomes.clone();
    worse[5].errors.total = worse[3].errors.total.min(worse[4].errors.total) * 1.00001;
    assert!(combined_to_others(&worse, Fresnel::Exact) > 1.0 + ROUNDING);
}

#[test]
fn fitted_alone_the_combined_model_is_no_worse_than_those_it_contains() {
    for (key, fresnel) in [
        ("violet-felt", Fresnel::Exact),
        ("hammered-gold", Fresnel::None),
        ("green-lacquer", Fresnel::Schlick),
        ("blue-porcelain", Fresnel::Exact),
    ] {
        let problem = problem(&thinned(sample(key), 4));
        let alone = |model| fit(&problem, variant(model, fresnel), &FitOptions::default());
        let outcomes = ["phong", "blinn-phong", "combined"].map(alone);
        for outcome in &outcomes {
            let broken = broken(&problem, outcome);
            assert!(broken.is_empty(), "{key}: {broken:?} {outcome:?}");
        }
        let ratio = combined_to_others(&outcomes, fresnel);
        assert!(ratio <= 1.0 + ROUNDING, "{key} {fresnel:?}: {ratio}");
    }
}

#[test]
fn only_the_stages_asked_for_are_run() {
    let problem = problem(&thinned(sample("hammered-gold"), 10));
    let combined = variant("combined", Fresnel::Exact);
    for stages in [
        StageSet::from_iter([Stage::Amplitudes]),
        StageSet::from_iter([Stage::Shape]),
        StageSet::POSTER,
        StageSet::from_iter([Stage::Joint]),
    ] {
        let options = FitOptions {
            stages,
            start: Partial {
                shared: numbers(&[("s", 300.0), ("alpha", 0.2), ("eta", 2.0)]),
                ..Partial::default()
            },
            ..FitOptions::default()
        };
        let (outcome, said) = watched(&problem, combined, &options);
        let asked: Vec<Stage> = STAGES.into_iter().filter(|s| options.runs(*s)).collect();
        let run: Vec<Stage> = outcome.stages.iter().map(|report| report.stage).collect();
        assert_eq!(run, asked);
        // Each is heard of, in order, with sound numbers.
        let mut heard: Vec<Stage> = said.iter().map(|progress| progress.stage).collect();
        heard.dedup();
        assert_eq!(heard, asked);
        for progress in &said {
            assert!((0.0..=1.0).contains(&progress.share), "{progress:?}");
            assert!(progress.error.is_finite(), "{progress:?}");
        }
        let first = &outcome.stages[0];
        if first.stage != Stage::Joint {
            let p = first.start.params;
            assert_eq!((p.lobe[0], p.lobe[1], p.eta), (300.0, 0.2, 2.0));
        }
        if first.stage == Stage::Amplitudes {
            let best = problem.with_best_amplitudes(&first.start);
            let ratio = first.error / problem.errors(&best).total;
            assert!((ratio - 1.0).abs() < ROUNDING, "{ratio}");
        }
    }
}

#[test]
fn the_start_does_not_decide_the_result() {
    let problem = problem(&thinned(sample("blue-porcelain"), 4));
    let combined = variant("combined", Fresnel::Exact);
    let from = |s, alpha, eta| {
        let start = Partial {
            shared: numbers(&[("s", s), ("alpha", alpha), ("eta", eta)]),
            ..Partial::default()
        };
        let options = FitOptions {
            start,
            ..FitOptions::default()
        };
        fit(&problem, combined, &options)
    };
    let outcomes = [from(0.1, 1.0, 1.01), from(9e4, 0.0, 900.0)];
    let free = fit(&problem, combined, &FitOptions::default());
    for outcome in &outcomes {
        let ratio = outcome.errors.total / free.errors.total;
        assert!((ratio - 1.0).abs() < 2e-4, "{ratio}: {outcome:?} {free:?}");
        // Planted: what the stages of the poster make of such a start.
        assert!(outcome.stages[2].error / free.errors.total > 1.0002);
    }
}
