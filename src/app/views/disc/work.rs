//! Computation of the view in the background.

use crate::app::state::cache::{Query, Update, WhenNewer};
use crate::app::state::sources::Sources;
use crate::app::views::disc::settings::DiscSettings;
use crate::figure::disc::{DiscField, DiscSpec};
use crate::figure::shown::Shown;
use std::ops::ControlFlow;

/// The values of a disc.
#[derive(Clone, Debug, PartialEq)]
pub struct DiscQuery {
    /// Spec of the disc; colours and marks are left at their defaults, as they change no value.
    pub spec: DiscSpec,
    /// Data and model.
    pub sources: Sources,
    /// Cells on a side.
    pub side: usize,
}

impl DiscQuery {
    /// The values for these settings.
    pub fn new(settings: &DiscSettings, mut sources: Sources, side: usize) -> Self {
        let DiscSpec { scale, limits, .. } = DiscSpec::default();
        if settings.shown == Shown::Measured {
            // The sliders move nothing then.
            sources.model = None;
        }
        Self {
            spec: DiscSpec {
                scale,
                limits,
                probe: None,
                ..settings.clone()
            },
            sources,
            side,
        }
    }
}

impl Query for DiscQuery {
    type Output = DiscField;
    const DOING: &'static str = "computing the disc";
    const WHEN_NEWER: WhenNewer = WhenNewer::FinishFirst;

    fn run(
        &self,
        _report: &mut dyn FnMut(Update<DiscField>) -> ControlFlow<()>,
    ) -> Option<DiscField> {
        let Sources { measured, model } = &self.sources;
        Some(
            self.spec
                .field(measured.as_ref(), model.as_ref(), self.side),
        )
    }
}
