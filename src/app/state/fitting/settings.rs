//! Settings of the next fit, and the setup that is kept with a fit.

use crate::brdf::{Brdf, Param, ParamId, all_params};
use crate::fit::options::{Bounds, NO_LIMIT};
use crate::fit::{FitOptions, StageSet, Weight};
use std::collections::{BTreeMap, BTreeSet};

/// Settings of the next fit, as the panel says them.
#[derive(Clone, Debug, PartialEq)]
pub struct FitSettings {
    /// Weight of the cells in E.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// Stages that are run.
    pub stages: StageSet,
    /// Parameters that keep the value of their sliders.
    pub held: BTreeSet<ParamId>,
    /// Bounds that are not the default ones.
    pub bounds: BTreeMap<ParamId, Bounds>,
    /// Whether the fit begins at the sliders instead of at what the data say.
    pub from_sliders: bool,
}

impl Default for FitSettings {
    fn default() -> Self {
        Self {
            weight: Weight::default(),
            limit: NO_LIMIT,
            stages: StageSet::ALL,
            held: BTreeSet::new(),
            bounds: BTreeMap::new(),
            from_sliders: false,
        }
    }
}

impl FitSettings {
    /// Setup of a fit that starts while the sliders stand at `brdf`.
    pub fn setup(&self, brdf: &Brdf) -> Setup {
        let mut options = FitOptions {
            stages: self.stages,
            bounds: self.bounds.clone(),
            ..FitOptions::default()
        };
        for row in brdf.model.rows() {
            if self.held.contains(&row.id) {
                options.held.set(row.id, brdf);
            } else if self.from_sliders && !row.id.is_color() {
                options.start.set(row.id, brdf);
            }
        }
        Setup {
            weight: self.weight,
            limit: self.limit,
            options,
        }
    }

    /// Holds a parameter at its slider, or frees it.
    pub fn hold(&mut self, id: ParamId, held: bool) {
        if held {
            self.held.insert(id);
        } else {
            self.held.remove(&id);
        }
    }

    /// Why there is nothing to fit, in words.
    pub fn blocked(&self, brdf: &Brdf) -> Option<&'static str> {
        if self.stages == StageSet::NONE {
            return Some("Tick at least one stage.");
        }
        let mut free = brdf.used().filter(|row| !self.held.contains(&row.id));
        let moved = free.any(|row| self.stages.iter().any(|stage| stage.moves(row.id)));
        (!moved).then_some("Every parameter that these stages move is held.")
    }
}

/// Bounds that can be chosen for a parameter at most, (smallest, largest).
pub fn widest_bounds(row: &Param) -> Bounds {
    let least = row.bounds.0.min(row.range.0).max(row.domain.0);
    (least, row.domain.1)
}

/// Settings that a fit was made with.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Weight of the cells in E.
    pub weight: Weight,
    /// Grazing limit in radians.
    pub limit: f64,
    /// Stages, what was held and where, start and bounds.
    pub options: FitOptions,
}

impl Setup {
    /// Whether another setup asks for the same. Where the sliders stood when a fit began does not count, for the fit
    /// itself moves them; that it began there does.
    pub fn asks_the_same(&self, other: &Self) -> bool {
        let began_at_data = |setup: &Self| setup.options.start.is_empty();
        let mut with_start_of_other = self.clone();
        with_start_of_other.options.start = other.options.start.clone();
        began_at_data(self) == began_at_data(other) && with_start_of_other == *other
    }

    /// Settings in words, for hovering.
    pub fn text(&self) -> String {
        let mut text = format!(
            "Weight {}, grazing limit {:.0}°",
            self.weight.name().to_lowercase(),
            self.limit.to_degrees()
        );
        let stages = self.options.stages.iter();
        let stages: Vec<String> = stages.map(|stage| stage.number().to_string()).collect();
        text += &format!(", stages {}", stages.join(" "));
        let held: Vec<&str> = all_params()
            .filter(|row| self.options.held.has(row.id))
            .map(Param::key)
            .collect();
        if !held.is_empty() {
            text += &format!(", held {}", held.join(" "));
        }
        if !self.options.start.is_empty() {
            text += ", from the sliders";
        }
        if !self.options.bounds.is_empty() {
            text += ", own bounds";
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::COMBINED;
    use crate::brdf::Fresnel;
    use crate::fit::Stage;

    fn brdf() -> Brdf {
        Brdf::new(&COMBINED, Fresnel::Exact)
    }

    #[test]
    fn held_parameters_keep_their_sliders_values() {
        let mut settings = FitSettings::default();
        settings.held.insert(ParamId("s"));
        settings.from_sliders = true;
        let options = settings.setup(&brdf()).options;
        assert_eq!(
            options.held.number(ParamId("s")),
            Some(brdf().params.lobe[0])
        );
        assert_eq!(options.held.number(ParamId("alpha")), None);
        assert_eq!(options.start.number(ParamId("s")), None);
        assert_eq!(options.start.number(ParamId::ETA), Some(brdf().params.eta));
        assert_eq!(options.start.k_s, None);
    }

    #[test]
    fn only_what_a_fit_is_asked_makes_it_stale() {
        let settings = FitSettings::default();
        let made = settings.setup(&brdf());
        let mut moved = brdf();
        moved.params.lobe[0] *= 2.0;
        assert!(made.asks_the_same(&settings.setup(&moved)));
        let changes: [fn(&mut FitSettings); 6] = [
            |s| s.weight = Weight::Cells,
            |s| s.limit = 1.0,
            |s| s.stages.joint = false,
            |s| s.hold(ParamId("alpha"), true),
            |s| _ = s.bounds.insert(ParamId("s"), (1.0, 2.0)),
            |s| s.from_sliders = true,
        ];
        for (k, change) in changes.into_iter().enumerate() {
            let mut other = settings.clone();
            change(&mut other);
            assert!(!made.asks_the_same(&other.setup(&brdf())), "change {k}");
        }
        // A fit from the sliders moves them, and is still what was asked.
        let from_sliders = FitSettings {
            from_sliders: true,
            ..settings
        };
        let made = from_sliders.setup(&brdf());
        assert!(made.asks_the_same(&from_sliders.setup(&moved)));
    }

    #[test]
    fn a_fit_of_nothing_is_blocked() {
        let mut settings = FitSettings::default();
        assert_eq!(settings.blocked(&brdf()), None);
        settings.stages = StageSet::from_iter([Stage::Shape]);
        let rows = brdf().model.rows().filter(|row| !row.id.is_color());
        settings.held = rows.map(|row| row.id).collect();
        assert!(settings.blocked(&brdf()).is_some());
        settings.stages.amplitudes = true;
        assert_eq!(settings.blocked(&brdf()), None);
        settings.stages = StageSet::NONE;
        assert!(settings.blocked(&brdf()).is_some());
    }
}
