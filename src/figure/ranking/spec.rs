//! The spec of the ranking: which part of E, in which order, and the errors themselves.

use crate::brdf::json::model_key;
use crate::brdf::{Brdf, Fresnel, Model};
use crate::keys;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Models by their E over materials, on paper. It holds the errors, so that it is drawn from itself alone.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RankingSpec {
    /// Part of E that is shown.
    pub part: RankingPart,
    /// Model by whose E the materials are in order; by the least E of all shown models without.
    #[serde(with = "maybe_model")]
    pub sort: Option<&'static Model>,
    /// Fresnel factor of the fits; of each model the best one without.
    pub fresnel: Option<Fresnel>,
    /// Models that are not shown.
    pub hidden: Vec<ModelKey>,
    /// Materials with the errors of their fits.
    pub materials: Vec<RankedMaterial>,
}

/// Part of E.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RankingPart {
    /// E over all cells.
    #[default]
    Total,
    /// E over the cells towards grazing.
    Grazing,
}

/// Both parts in the order offered.
pub const RANKING_PARTS: [RankingPart; 2] = [RankingPart::Total, RankingPart::Grazing];

impl RankingPart {
    /// Name in files and on the command line.
    pub fn key(self) -> &'static str {
        keys::key_at::<Self>(self as usize)
    }
}

/// A model as its key.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct ModelKey(#[serde(with = "model_key")] pub &'static Model);

/// A material and what is left of it by its fits.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RankedMaterial {
    /// Display name.
    pub name: String,
    /// Errors of its fits, one of each model and Fresnel factor at most.
    pub fits: Vec<RankedFit>,
}

/// The errors of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RankedFit {
    /// Model that was fitted.
    #[serde(with = "model_key")]
    pub model: &'static Model,
    /// Fresnel factor that was fitted.
    pub fresnel: Fresnel,
    /// E over all cells, as a share.
    pub error: f64,
    /// E over the cells towards grazing, as a share; none where the fit left them out.
    pub grazing: Option<f64>,
}

impl RankedFit {
    /// E of a fitted model over all cells, and over those towards grazing.
    pub fn new(brdf: &Brdf, error: f64, grazing: Option<f64>) -> Self {
        Self {
            model: brdf.model,
            fresnel: brdf.fresnel,
            error,
            grazing,
        }
    }

    /// A part of E, as a share; none where it is not above 0, for a logarithmic axis has no place for it.
    pub fn part(&self, part: RankingPart) -> Option<f64> {
        let error = match part {
            RankingPart::Total => Some(self.error),
            RankingPart::Grazing => self.grazing,
        };
        error.filter(|error| *error > 0.0 && error.is_finite())
    }
}

/// A model as its key, or none.
mod maybe_model {
    use super::{Deserialize, Deserializer, Model, ModelKey, Serialize, Serializer};

    pub fn serialize<S: Serializer>(
        model: &Option<&'static Model>,
        to: S,
    ) -> Result<S::Ok, S::Error> {
        model.map(ModelKey).serialize(to)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(
        from: D,
    ) -> Result<Option<&'static Model>, D::Error> {
        Ok(Option::<ModelKey>::deserialize(from)?.map(|key| key.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::ViewSpec;

    #[test]
    fn a_spec_is_read_back_and_what_is_wrong_is_named() {
        let text = r#"{"ranking": {"part": "grazing", "sort": "ggx", "fresnel": "exact", "hidden": ["ward"],
            "materials": [{"name": "a", "fits": [
                {"model": "ggx", "fresnel": "exact", "error": 0.1, "grazing": null},
                {"model": "phong", "fresnel": "exact", "error": 0.25, "grazing": 0.5}]}]}}"#;
        let spec: ViewSpec = serde_json::from_str(text).expect("a spec");
        let ViewSpec::Ranking(ranking) = &spec else {
            panic!("{spec:?}")
        };
        assert_eq!(ranking.sort, Model::by_key("ggx"));
        assert_eq!(ranking.materials[0].fits[1].part(ranking.part), Some(0.5));
        assert_eq!(ranking.materials[0].fits[0].part(ranking.part), None);
        let written = serde_json::to_string(&spec).expect("JSON");
        assert_eq!(
            serde_json::from_str::<ViewSpec>(&written).expect("read"),
            spec
        );
        for (from, to, said) in [
            (r#""ggx""#, r#""gxx""#, "gxx"),
            (r#""grazing", "sort""#, r#""nearly", "sort""#, "nearly"),
            (r#""hidden""#, r#""hiden""#, "hiden"),
        ] {
            let wrong = serde_json::from_str::<ViewSpec>(&text.replacen(from, to, 1));
            assert!(wrong.expect_err(to).to_string().contains(said));
        }
    }
}
