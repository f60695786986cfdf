//! Lobes in space on paper.

use super::{Camera, Detail, Lobes, Overlay, Shape, picture};
use crate::figure::cosine::CosineFactor;
use crate::figure::drawing::Drawing;
use crate::figure::faults::Faults;
use crate::figure::panel::{PanelDrawing, PanelInput, PanelView};
use crate::figure::scale::RadialScale;
use crate::figure::subject::Channel;
use crate::geom::degrees;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_2;

/// Lobes in space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Lobe3dSpec {
    /// Angle of incidence in radians; in the window that where there is no probe.
    #[serde(with = "degrees")]
    pub theta_i: f64,
    /// Radius per f_r.
    pub scale: RadialScale,
    /// Cosines that f_r is multiplied by.
    #[serde(rename = "with_cosine")]
    pub cosine: CosineFactor,
    /// Colour channel that is shown.
    pub channel: Channel,
    /// Camera of the picture.
    pub camera: Camera,
}

impl Default for Lobe3dSpec {
    fn default() -> Self {
        Self {
            theta_i: 45f64.to_radians(),
            scale: RadialScale::CubeRoot,
            cosine: CosineFactor::NONE,
            channel: Channel::Luminance,
            camera: Camera::default(),
        }
    }
}

impl PanelView for Lobe3dSpec {
    fn sanitize(&mut self, faults: &mut Faults) {
        faults.angle("theta_i", &mut self.theta_i, [0.0, FRAC_PI_2]);
        faults.inside("camera", |faults| self.camera.sanitize(faults));
    }

    fn height(&self, width: f32, font: f32) -> f32 {
        0.7 * width + 2.0 * font
    }

    fn has_curves(&self) -> bool {
        true
    }

    fn draw(&self, input: &PanelInput) -> PanelDrawing {
        let shape = Shape {
            theta_i: self.theta_i,
            scale: self.scale,
            cosine: self.cosine,
            channel: self.channel,
            detail: Detail::Fine,
        };
        let lobes = Lobes::new(shape, input.subjects, None);
        let overlay = Overlay::new(&lobes, self.camera, None, input.size);
        let space = picture(
            &lobes,
            &overlay.projection,
            input.palette,
            input.size,
            input.density,
        );
        let mut drawing = Drawing::new(input.size);
        drawing.items.push(space);
        drawing.items.extend(overlay.drawing.items);
        PanelDrawing {
            drawing,
            ..PanelDrawing::default()
        }
    }
}
