//! The models that are fitted beside each other.

use crate::brdf::fresnel::FRESNELS;
use crate::brdf::{Fresnel, MODELS, Model, PHONG_FAMILY};
use crate::fit::Variant;
use serde::{Deserialize, Serialize};

/// Models and Fresnel factors that are fitted beside each other: every model with every factor.
///
/// JSON: `{"models": ["phong", …], "fresnel": ["none", …]}`; keys that nobody knows are left out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "Keys", into = "Keys")]
pub struct Comparison {
    /// Models in the order of [`MODELS`].
    models: Vec<&'static Model>,
    /// Fresnel factors in the order of [`FRESNELS`].
    fresnels: Vec<Fresnel>,
}

/// A comparison as keys.
#[derive(Serialize, Deserialize)]
struct Keys {
    models: Vec<String>,
    fresnel: Vec<String>,
}

impl Default for Comparison {
    /// The Phong family without and with the exact Fresnel factor.
    fn default() -> Self {
        Self {
            models: PHONG_FAMILY.to_vec(),
            fresnels: vec![Fresnel::None, Fresnel::Exact],
        }
    }
}

impl From<Keys> for Comparison {
    fn from(keys: Keys) -> Self {
        let models = MODELS.iter().copied();
        Self {
            models: models
                .filter(|model| keys.models.iter().any(|key| key == model.key))
                .collect(),
            fresnels: FRESNELS
                .into_iter()
                .filter(|fresnel| keys.fresnel.iter().any(|key| key == fresnel.key()))
                .collect(),
        }
    }
}

impl From<Comparison> for Keys {
    fn from(comparison: Comparison) -> Self {
        let models = comparison.models.iter();
        let fresnels = comparison.fresnels.iter();
        Self {
            models: models.map(|model| model.key.into()).collect(),
            fresnel: fresnels.map(|fresnel| fresnel.key().into()).collect(),
        }
    }
}

impl Comparison {
    /// Models with these keys and a Fresnel factor.
    pub fn of(models: &[&str], fresnel: Fresnel) -> Self {
        Self::from(Keys {
            models: models.iter().map(|key| (*key).into()).collect(),
            fresnel: vec![fresnel.key().into()],
        })
    }

    /// Variants in the order in which they are fitted: all models for one Fresnel factor after the other.
    pub fn variants(&self) -> Vec<Variant> {
        let of = |fresnel| {
            let models = self.models.iter();
            models.map(move |model| Variant { model, fresnel })
        };
        self.fresnels.iter().copied().flat_map(of).collect()
    }

    /// Whether a model is in it.
    pub fn has_model(&self, model: &Model) -> bool {
        self.models.contains(&model)
    }

    /// Whether a Fresnel factor is in it.
    pub fn has_fresnel(&self, fresnel: Fresnel) -> bool {
        self.fresnels.contains(&fresnel)
    }

    /// Whether its models are exactly these.
    pub fn is_of(&self, models: &[&'static Model]) -> bool {
        self.models == models
    }

    /// Replaces the models by these, which are in the order of [`MODELS`].
    pub fn set_models(&mut self, models: &[&'static Model]) {
        self.models = models.to_vec();
    }

    /// Takes a model in, or out.
    pub fn toggle_model(&mut self, model: &'static Model) {
        toggle(&mut self.models, model, |model| model.index());
    }

    /// Takes a Fresnel factor in, or out.
    pub fn toggle_fresnel(&mut self, fresnel: Fresnel) {
        toggle(&mut self.fresnels, fresnel, |fresnel| fresnel.index());
    }

    /// Why there is nothing to fit, in words.
    pub fn blocked(&self) -> Option<&'static str> {
        if self.models.is_empty() {
            return Some("Tick at least one model to compare.");
        }
        (self.fresnels.is_empty()).then_some("Tick at least one Fresnel factor to compare.")
    }

    /// Number of fits in words, such as "6 fits".
    pub fn count(&self) -> String {
        match self.models.len() * self.fresnels.len() {
            1 => "1 fit".into(),
            count => format!("{count} fits"),
        }
    }
}

fn toggle<T: Copy + PartialEq>(all: &mut Vec<T>, one: T, place: impl Fn(&T) -> usize) {
    let before = all.len();
    all.retain(|other| *other != one);
    if all.len() == before {
        all.push(one);
        all.sort_by_key(place);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::COMBINED;

    #[test]
    fn models_and_factors_are_taken_in_and_out_in_one_order() {
        let mut comparison = Comparison::default();
        assert_eq!(
            comparison.variants(),
            Variant::of(PHONG_FAMILY, Fresnel::Exact)
        );
        assert_eq!(comparison.count(), "6 fits");
        let (first, last) = (MODELS[0], MODELS[MODELS.len() - 1]);
        for model in [last, first, COMBINED_ROW, first] {
            comparison.toggle_model(model);
        }
        comparison.toggle_fresnel(Fresnel::None);
        comparison.toggle_fresnel(Fresnel::Schlick);
        let keys: Vec<_> = comparison
            .variants()
            .iter()
            .map(|variant| (variant.model.key, variant.fresnel))
            .collect();
        let models = [first.key, MODELS[1].key, last.key];
        let wanted: Vec<_> = [Fresnel::Exact, Fresnel::Schlick]
            .into_iter()
            .flat_map(|fresnel| models.map(|key| (key, fresnel)))
            .collect();
        assert_eq!(keys, wanted);
    }

    const COMBINED_ROW: &Model = &COMBINED;

    #[test]
    fn nothing_to_compare_is_said() {
        let mut comparison = Comparison::default();
        assert_eq!(comparison.blocked(), None);
        comparison.toggle_fresnel(Fresnel::None);
        comparison.toggle_fresnel(Fresnel::Exact);
        assert!(
            comparison
                .blocked()
                .is_some_and(|text| text.contains("Fresnel"))
        );
        comparison.set_models(&[]);
        assert!(
            comparison
                .blocked()
                .is_some_and(|text| text.contains("model"))
        );
    }

    #[test]
    fn what_is_kept_is_read_back_and_unknown_keys_are_left_out() {
        let mut comparison = Comparison::default();
        comparison.set_models(MODELS);
        let text = serde_json::to_string(&comparison).expect("JSON");
        assert_eq!(
            serde_json::from_str::<Comparison>(&text).expect("read"),
            comparison
        );
        let odd =
            r#"{"models": ["ggx", "oren-nayar", "phong", "ggx"], "fresnel": ["exact", "best"]}"#;
        let read: Comparison = serde_json::from_str(odd).expect("read");
        let keys: Vec<_> = read.variants().iter().map(|v| v.model.key).collect();
        assert_eq!(keys, ["phong", "ggx"]);
    }
}
