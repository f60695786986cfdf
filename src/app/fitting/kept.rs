//! What a fit is asked, and what is kept of it.

use crate::brdf::params::ALL;
use crate::brdf::{Brdf, Fresnel, ParamId};
use crate::files::SourceFile;
use crate::files::fits::FitRecord;
use crate::fit::options::NO_LIMIT;
use crate::fit::{
    Ended, Options, Outcome, Partial, Progress, STAGES, StageReport, Variant, Weight, diagnostics,
};
use crate::geom::degrees;
use serde::{Deserialize, Serialize};

/// What the panel says of the next fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// How much a cell counts.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// Which stages are run; by position in [`STAGES`].
    pub stages: [bool; 4],
    /// Which parameters keep the value of their slider; by position in [`ALL`].
    pub held: [bool; 5],
    /// Bounds that are not the default; by position in [`ALL`].
    pub bounds: [Option<(f64, f64)>; 5],
    /// Whether the fit begins at the sliders instead of at what the data say.
    pub from_sliders: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            weight: Weight::default(),
            limit: NO_LIMIT,
            stages: [true; 4],
            held: [false; 5],
            bounds: [None; 5],
            from_sliders: false,
        }
    }
}

impl Settings {
    /// What a fit is asked while the sliders stand at `brdf`.
    pub fn setup(&self, brdf: &Brdf) -> Setup {
        let mut options = Options {
            stages: self.stages,
            bounds: self.bounds,
            ..Options::default()
        };
        for (row, held) in ALL.iter().zip(self.held) {
            if held {
                options.held.set(row.id, &brdf.params);
            } else if self.from_sliders && !row.id.is_color() {
                options.start.set(row.id, &brdf.params);
            }
        }
        Setup {
            weight: self.weight,
            limit: self.limit,
            options,
        }
    }

    /// Why there is nothing to fit, in words.
    pub fn blocked(&self, brdf: &Brdf) -> Option<&'static str> {
        let runs = |k: usize| self.stages[k];
        if !(0..STAGES.len()).any(runs) {
            return Some("Tick at least one stage.");
        }
        let free = |id: ParamId| {
            let index = ALL.iter().position(|row| row.id == id);
            brdf.uses(id) && index.is_some_and(|index| !self.held[index])
        };
        let moved = STAGES
            .iter()
            .enumerate()
            .any(|(k, stage)| runs(k) && ALL.iter().any(|row| stage.moves(row.id) && free(row.id)));
        (!moved).then_some("Every parameter that these stages move is held.")
    }
}

/// What a fit was asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    /// How much a cell counted.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// Stages, what was held and where, start and bounds.
    pub options: Options,
}

impl Setup {
    /// Whether another setup asks for the same. Where the sliders stood when a fit began does not count, for the fit
    /// itself moves them; that it began there does.
    pub fn asks_the_same(&self, other: &Self) -> bool {
        let began_at_data = |setup: &Self| setup.options.start == Partial::default();
        let with_start_of = |setup: &Self| Self {
            options: Options {
                start: setup.options.start,
                ..self.options
            },
            ..*self
        };
        began_at_data(self) == began_at_data(other) && with_start_of(other) == *other
    }

    /// In words, for hovering.
    pub fn text(&self) -> String {
        let mut text = format!(
            "Weight {}, grazing limit {:.0}°",
            self.weight.name().to_lowercase(),
            self.limit.to_degrees()
        );
        let stages: Vec<String> = STAGES
            .iter()
            .filter(|stage| self.options.runs(**stage))
            .map(|stage| stage.number().to_string())
            .collect();
        text += &format!(", stages {}", stages.join(" "));
        let held: Vec<&str> = ALL
            .iter()
            .filter(|row| self.options.held.has(row.id))
            .map(|row| row.key)
            .collect();
        if !held.is_empty() {
            text += &format!(", held {}", held.join(" "));
        }
        if self.options.start != Partial::default() {
            text += ", from the sliders";
        }
        if self.options.bounds.iter().any(Option::is_some) {
            text += ", own bounds";
        }
        text
    }
}

/// A fit that is kept with its material.
#[derive(Clone, Debug)]
pub struct KeptFit {
    /// What it brought.
    pub outcome: Outcome,
    /// What it was asked.
    pub setup: Setup,
    /// How long it took; `None` where nobody knows.
    pub seconds: Option<f64>,
    /// All that it said while it ran; may be empty.
    pub trace: Vec<Progress>,
    /// Whether its lobes are drawn beside the model's.
    pub overlaid: bool,
}

impl KeptFit {
    /// What was fitted.
    pub fn variant(&self) -> Variant {
        Variant::from(&self.outcome.brdf)
    }

    /// The same as fit files keep it.
    pub fn record(&self, material: String, source: Option<SourceFile>) -> FitRecord {
        let Setup {
            weight,
            limit,
            options,
        } = &self.setup;
        let asked = (*weight, degrees::rounded(*limit));
        FitRecord::new(material, source, asked, options, &self.outcome)
    }

    /// Whether it was stopped before its end.
    pub fn is_cancelled(&self) -> bool {
        self.outcome.ended == Ended::Cancelled
    }
}

impl From<&FitRecord> for KeptFit {
    /// A fit from a file; where its first stage began is not in there, nor what it said.
    fn from(record: &FitRecord) -> Self {
        let variant = Variant::from(&record.brdf);
        let end = |k: usize| variant.with(record.stages[k].params);
        let stages = record
            .stages
            .iter()
            .enumerate()
            .map(|(k, stage)| StageReport {
                stage: stage.stage,
                start: end(k.saturating_sub(1)),
                start_error: stage.start_error,
                end: end(k),
                error: stage.error,
                evaluations: stage.evaluations,
            });
        Self {
            outcome: Outcome {
                brdf: record.brdf,
                errors: record.errors,
                stages: stages.collect(),
                evaluations: record.evaluations,
                ended: record.ended,
                albedo: record.albedo,
                concerns: diagnostics::diagnose(&record.brdf, &record.options, &record.albedo),
            },
            setup: Setup {
                weight: record.weight,
                limit: record.limit_deg.to_radians(),
                options: record.options,
            },
            seconds: None,
            trace: Vec::new(),
            overlaid: false,
        }
    }
}

/// What the table of fits is ordered by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SortBy {
    /// Model, then Fresnel factor.
    Name,
    /// E over all cells, the smallest first.
    #[default]
    Error,
    /// E over the grazing cells, the smallest first.
    Grazing,
}

/// A variant in few words, where room is short.
pub fn short_variant_name(variant: Variant) -> String {
    let model = variant.model.name;
    match variant.fresnel {
        Fresnel::None => model.to_string(),
        fresnel => format!("{model}, {}", fresnel.key()),
    }
}

/// A variant in words.
pub fn variant_name(variant: Variant) -> String {
    let model = variant.model.name;
    match variant.fresnel {
        Fresnel::None => format!("{model}, no Fresnel"),
        Fresnel::Exact => format!("{model}, exact Fresnel"),
        Fresnel::Schlick => format!("{model}, Schlick Fresnel"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::{MODELS, Params};

    fn brdf() -> Brdf {
        Brdf {
            model: MODELS[2],
            fresnel: Fresnel::Exact,
            params: Params::default(),
        }
    }

    #[test]
    fn held_parameters_keep_their_sliders_values() {
        let mut settings = Settings::default();
        settings.held[2] = true;
        settings.from_sliders = true;
        let options = settings.setup(&brdf()).options;
        assert_eq!(options.held.s, Some(brdf().params.s));
        assert_eq!(options.held.alpha, None);
        assert_eq!(options.start.s, None);
        assert_eq!(options.start.eta, Some(brdf().params.eta));
        assert_eq!(options.start.k_s, None);
    }

    #[test]
    fn only_what_a_fit_is_asked_makes_it_stale() {
        let settings = Settings::default();
        let made = settings.setup(&brdf());
        let mut moved = brdf();
        moved.params.s *= 2.0;
        assert!(made.asks_the_same(&settings.setup(&moved)));
        let changes: [fn(&mut Settings); 6] = [
            |s| s.weight = Weight::Cells,
            |s| s.limit = 1.0,
            |s| s.stages[3] = false,
            |s| s.held[3] = true,
            |s| s.bounds[2] = Some((1.0, 2.0)),
            |s| s.from_sliders = true,
        ];
        for (k, change) in changes.into_iter().enumerate() {
            let mut other = settings.clone();
            change(&mut other);
            assert!(!made.asks_the_same(&other.setup(&brdf())), "change {k}");
        }
        // A fit from the sliders moves them, and is still what was asked.
        let from_sliders = Settings {
            from_sliders: true,
            ..settings
        };
        let made = from_sliders.setup(&brdf());
        assert!(made.asks_the_same(&from_sliders.setup(&moved)));
    }

    #[test]
    fn a_fit_of_nothing_is_blocked() {
        let mut settings = Settings::default();
        assert_eq!(settings.blocked(&brdf()), None);
        settings.stages = [false, true, false, false];
        settings.held = [false, false, true, true, true];
        assert!(settings.blocked(&brdf()).is_some());
        settings.stages[0] = true;
        assert_eq!(settings.blocked(&brdf()), None);
        settings.stages = [false; 4];
        assert!(settings.blocked(&brdf()).is_some());
    }
}
