//! Queries about the fits of the shown material.

use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::run::Run;
use crate::app::state::material::MaterialId;
use crate::fit::Variant;

impl State {
    /// Keeps a fit of a material in place of the one of the same variant.
    ///
    /// One that was cancelled does not replace one that was made with the same setup and ran to its end.
    /// Of a file, it is kept with the path too: the file may be opened again.
    pub fn keep_fit(&mut self, material: MaterialId, mut fit: KeptFit) {
        let Some(material) = self.materials.get_mut(&material) else {
            return;
        };
        let variant = fit.variant();
        match material
            .fits
            .iter_mut()
            .find(|kept| kept.variant() == fit.variant())
        {
            Some(kept)
                if fit.is_cancelled()
                    && !kept.is_cancelled()
                    && kept.setup.asks_the_same(&fit.setup) => {}
            Some(kept) => {
                fit.overlaid = kept.overlaid;
                *kept = fit;
            }
            None => material.fits.push(fit),
        }
        if let (Some(path), Some(kept)) = (material.file(), material.fit(variant)) {
            let record = kept.record(material.name.clone(), material.source.clone());
            self.library.keep_fit(&path, record);
        }
    }

    /// The kept fit of the shown material for the shown model and Fresnel factor.
    pub fn current_fit(&self) -> Option<&KeptFit> {
        let (material, opened) = self.current()?;
        material.fit(Variant::from(&opened.brdf))
    }

    /// The run under way, if it is of the shown material.
    pub fn current_run(&self) -> Option<&Run> {
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
}
