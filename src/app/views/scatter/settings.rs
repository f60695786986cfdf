//! Settings of the materials: those of their figure.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::brdf::Model;
use crate::figure::faults::Faults;
use crate::figure::panel::PanelView as _;
use crate::figure::scatter::{Quantity, ScatterSpec};

/// Settings of the materials. E of the subjects is the fits' own, and not kept here.
pub type ScatterSettings = ScatterSpec;

/// Settings that show another model, by its first quantities.
pub fn with_model(settings: &ScatterSettings, model: &'static Model) -> ScatterSettings {
    if settings.model == model {
        return settings.clone();
    }
    ScatterSettings {
        model,
        ..ScatterSettings::default()
    }
}

/// Settings with these quantities along x and y. An axis that changes is around all values again.
pub fn with_quantities(settings: &ScatterSettings, [x, y]: [Quantity; 2]) -> ScatterSettings {
    let first = Quantity::first(settings.model);
    let mut changed = settings.clone();
    let [old_x, old_y] = settings.quantities();
    if x != old_x {
        // The first one is not named, as in the files from before there was a choice.
        (changed.x, changed.window) = ((x != first[0]).then_some(x), None);
    }
    if y != old_y {
        (changed.y, changed.y_window) = ((y != first[1]).then_some(y), None);
    }
    changed
}

/// Settings with these ends of the axes, as far as they can be shown.
pub fn with_ends(settings: &ScatterSettings, ends: [Option<[f64; 2]>; 2]) -> ScatterSettings {
    let mut changed = settings.clone();
    let windows = [&mut changed.window, &mut changed.y_window];
    for ((window, row), ends) in windows.into_iter().zip(settings.rows()).zip(ends) {
        if let Some(ends) = ends {
            *window = row.moved(*window, ends);
        }
    }
    changed
}

impl Settings for ScatterSettings {
    const VIEW: ViewId = ViewId::Scatter;

    fn sanitized(mut self) -> Self {
        self.sanitize(&mut Faults::default());
        self.errors.clear();
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::MODELS;

    #[test]
    fn ends_that_show_nothing_are_not_taken() {
        let with_x = |settings: &ScatterSettings, ends| with_ends(settings, [Some(ends), None]);
        let view = with_x(&ScatterSettings::default(), [1.0, 10.0]);
        assert_eq!(view.window, Some([1.0, 10.0]));
        for odd in [
            [10.0, 1.0],
            [1.0, 1.01],
            [0.0, 1.0],
            [1.0, 1e9],
            [f64::NAN, 1.0],
        ] {
            assert_eq!(with_x(&view, odd), view);
            let odd = ScatterSettings {
                window: Some(odd),
                ..ScatterSettings::default()
            };
            assert_eq!(odd.sanitized(), ScatterSettings::default());
        }
        // As far as old sessions have them.
        let far = with_x(&view, [1e-4, 1e8]);
        assert_eq!(far.window, Some([1e-4, 1e8]));
        assert_eq!(far.clone().sanitized(), far);
    }

    #[test]
    fn a_blend_stays_inside_its_interval() {
        let with_y = |settings: &ScatterSettings, ends| with_ends(settings, [None, Some(ends)]);
        let view = ScatterSettings::default();
        assert_eq!(with_y(&view, [-5.0, 5.0]), view);
        assert_eq!(with_y(&view, [-0.1, 1.1]), view);
        let [low, high] = with_y(&view, [0.9, 1.4]).y_window.expect("a part");
        assert!((low - 0.6).abs() < 1e-12 && (high - 1.1).abs() < 1e-12);
    }

    #[test]
    fn every_model_has_axes_and_forgets_those_of_another() {
        for model in MODELS {
            let view = with_model(&ScatterSettings::default(), model);
            let [x, y] = view.quantities();
            assert_ne!(x, y, "{}", model.key);
            assert_eq!(view.clone().sanitized(), view);
            for quantity in Quantity::all(model) {
                let turned = with_quantities(&view, [y, quantity]);
                assert_eq!(turned.quantities(), [y, quantity]);
                assert_eq!(turned.clone().sanitized(), turned);
                let back = with_quantities(&turned, [x, y]);
                assert_eq!(back, view);
            }
        }
        let mut foreign = with_model(&ScatterSettings::default(), MODELS[5]);
        foreign.x = Some(Quantity::Param(crate::brdf::ParamId("alpha")));
        let sanitized = foreign.clone().sanitized();
        assert_eq!(sanitized.x, None);
        assert_eq!(sanitized.model, MODELS[5]);
    }
}
