//! Settings of the ranking: those of its figure, without the materials.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::brdf::Model;
use crate::figure::ranking::{ModelKey, RankingSpec};

/// Settings of the ranking. The materials are the window's own, and not kept here.
pub type RankingSettings = RankingSpec;

/// Settings in which a model is shown, or not.
pub fn with_model(
    settings: &RankingSettings,
    model: &'static Model,
    shown: bool,
) -> RankingSettings {
    let mut changed = settings.clone();
    changed.hidden.retain(|hidden| hidden.0 != model);
    if !shown {
        changed.hidden.push(ModelKey(model));
    }
    changed
}

impl Settings for RankingSettings {
    const VIEW: ViewId = ViewId::Ranking;

    fn sanitized(mut self) -> Self {
        self.materials.clear();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::MODELS;

    #[test]
    fn a_model_is_hidden_once_and_shown_again() {
        let settings = RankingSettings::default();
        let hidden = with_model(&with_model(&settings, MODELS[1], false), MODELS[1], false);
        assert_eq!(hidden.hidden, [ModelKey(MODELS[1])]);
        assert_eq!(with_model(&hidden, MODELS[1], true), settings);
    }
}
