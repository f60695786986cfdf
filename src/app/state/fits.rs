//! Queries about the fits of the shown material.

use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::run::FitRun;
use crate::fit::Variant;

impl State {
    /// The kept fit of the shown material for the shown model and Fresnel factor.
    pub fn current_fit(&self) -> Option<&KeptFit> {
        let (material, opened) = self.current()?;
        material.fit(Variant::from(&opened.brdf))
    }

    /// The run under way, if it is of the shown material.
    pub fn current_run(&self) -> Option<&FitRun> {
        let opened = self.scene.opened.get(self.scene.selected)?;
        self.fit
            .run
            .as_ref()
            .filter(|run| run.material == opened.id)
    }

    /// Whether the settings would ask something else now than what the fit was asked.
    pub fn is_stale(&self, fit: &KeptFit) -> bool {
        self.current().is_some_and(|(_, opened)| {
            !fit.setup
                .asks_the_same(&self.fit.settings.setup(&opened.brdf))
        })
    }

    /// Why no fit can be started now, in words.
    pub fn fit_blocked(&self) -> Option<&'static str> {
        let Some((material, opened)) = self.current() else {
            return Some("Open a material first.");
        };
        if material.is_loading() {
            return Some("The data of this material are being loaded.");
        }
        self.fit.settings.blocked(&opened.brdf)
    }

    /// Why no models can be compared now, in words.
    pub fn comparison_blocked(&self) -> Option<&'static str> {
        self.fit_blocked().or(self.prefs.comparison.blocked())
    }
}
