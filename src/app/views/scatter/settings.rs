//! Settings of the materials: those of their figure.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use crate::figure::scatter::ScatterSpec;

/// Settings of the materials.
pub type ScatterSettings = ScatterSpec;

/// Ends that are farther out or nearer to each other show nothing more.
const ENDS: [f64; 2] = [1e-4, 1e8];
const CLOSEST: f64 = 1.05;

/// Settings with these ends of the axis of s, if they can be shown.
pub fn with_window(settings: ScatterSettings, ends: [f64; 2]) -> ScatterSettings {
    let [low, high] = ends;
    let shown = low >= ENDS[0] && high <= ENDS[1] && high >= CLOSEST * low;
    ScatterSettings {
        window: if shown { Some(ends) } else { settings.window },
    }
}

impl Settings for ScatterSettings {
    const VIEW: ViewId = ViewId::Scatter;

    fn sanitized(self) -> Self {
        let whole = Self::default();
        self.window.map_or(whole, |ends| with_window(whole, ends))
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
