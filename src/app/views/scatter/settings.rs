//! What the scatter of the materials is set to show.

use crate::app::state::view_id::ViewId;
use crate::app::state::view_settings::Settings;
use serde::{Deserialize, Serialize};

/// What the scatter shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ScatterSettings {
    /// Ends of the axis of s; around all materials without.
    pub window: Option<[f64; 2]>,
}

/// Ends that are farther out or nearer to each other show nothing more.
const ENDS: [f64; 2] = [1e-4, 1e8];
const CLOSEST: f64 = 1.05;

impl ScatterSettings {
    /// With these ends, if they can be shown.
    pub fn with_window(self, ends: [f64; 2]) -> Self {
        let [low, high] = ends;
        let shown = low >= ENDS[0] && high <= ENDS[1] && high >= CLOSEST * low;
        Self {
            window: if shown { Some(ends) } else { self.window },
        }
    }
}

impl Settings for ScatterSettings {
    const VIEW: ViewId = ViewId::Scatter;

    fn sanitized(self) -> Self {
        let whole = Self::default();
        self.window.map_or(whole, |ends| whole.with_window(ends))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_that_show_nothing_are_not_taken() {
        let view = ScatterSettings::default().with_window([1.0, 10.0]);
        assert_eq!(view.window, Some([1.0, 10.0]));
        for odd in [
            [10.0, 1.0],
            [1.0, 1.01],
            [0.0, 1.0],
            [1.0, 1e9],
            [f64::NAN, 1.0],
        ] {
            assert_eq!(view.with_window(odd), view);
            assert_eq!(
                ScatterSettings { window: Some(odd) }.sanitized(),
                ScatterSettings::default()
            );
        }
    }
}
