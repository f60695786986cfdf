//! Data and model of the shown material, as pictures compare them.

use crate::app::state::State;
use crate::figure::subject::Source;

/// Data and model of the shown material.
#[derive(Clone, Debug, PartialEq)]
pub struct Sources {
    /// The data; `None` where there are none.
    pub measured: Option<Source>,
    /// The model over them; `None` where no material is open.
    pub model: Option<Source>,
}

impl Sources {
    /// Sources of the shown material.
    pub fn of(state: &State) -> Self {
        let Some((material, opened)) = state.current() else {
            return Self {
                measured: None,
                model: None,
            };
        };
        let lookup = state.scene.lookup;
        let has_data = material.table.valid_count() > 0;
        Self {
            measured: has_data.then(|| Source::Measured(material.table.clone(), lookup)),
            model: Some(Source::Model(opened.brdf)),
        }
    }
}
