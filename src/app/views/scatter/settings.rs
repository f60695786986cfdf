//! Settings of the materials: those of their figure.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::faults::Faults;
use crate::figure::panel::PanelView as _;
use crate::figure::scatter::ScatterSpec;

/// Settings of the materials.
pub type ScatterSettings = ScatterSpec;

/// Settings with these ends of the axis of s, if they can be shown.
pub fn with_window(settings: ScatterSettings, ends: [f64; 2]) -> ScatterSettings {
    let shown = ScatterSettings::are_ends(ends);
    ScatterSettings {
        window: if shown { Some(ends) } else { settings.window },
    }
}

impl Settings for ScatterSettings {
    const VIEW: ViewId = ViewId::Scatter;

    fn sanitized(mut self) -> Self {
        self.sanitize(&mut Faults::default());
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_that_show_nothing_are_not_taken() {
        let view = with_window(ScatterSettings::default(), [1.0, 10.0]);
        assert_eq!(view.window, Some([1.0, 10.0]));
        for odd in [
            [10.0, 1.0],
            [1.0, 1.01],
            [0.0, 1.0],
            [1.0, 1e9],
            [f64::NAN, 1.0],
        ] {
            assert_eq!(with_window(view, odd), view);
            assert_eq!(
                ScatterSettings { window: Some(odd) }.sanitized(),
                ScatterSettings::default()
            );
        }
    }
}
