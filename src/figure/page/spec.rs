//! What is on a page, as data: rows of panels, each a view of some subjects.

use super::style::Style;
use crate::figure::albedo::AlbedoSpec;
use crate::figure::error_map::Plane;
use crate::figure::heatmap::View;
use crate::figure::image_slice::ImageSpec;
use crate::figure::lobe3d::Camera;
use crate::figure::lobes::LobeSpec;
use crate::figure::scale::RadialScale;
use crate::figure::slices::{Residual, SliceSpec};
use crate::figure::subject::Channel;
use crate::geom::degrees;
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;
use crate::geom::sphere_error::SphereError;
use serde::{Deserialize, Serialize};

/// A page of panels.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PageSpec {
    /// From above to below.
    pub rows: Vec<RowSpec>,
    /// How it looks.
    #[serde(default)]
    pub style: Style,
}

/// Panels beside each other, all of the same width.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RowSpec {
    /// Written at the left, upwards.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Height of the panels in millimetres; from their kinds without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height_mm: Option<f64>,
    /// From left to right.
    pub panels: Vec<PanelSpec>,
}

/// One view of some subjects.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PanelSpec {
    /// Written above it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heading: Option<String>,
    /// Positions in the figure's list of subjects, in the order in which they are drawn and named. A sphere, an image
    /// slice and an error map take the first measurement and the first model; a landscape takes the measurement.
    pub subjects: Vec<usize>,
    /// What is shown of them.
    pub view: ViewSpec,
}

/// What is shown, by kind of view.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ViewSpec {
    /// A lit sphere.
    Sphere(SphereSpec),
    /// Polar lobes in the plane of incidence.
    Lobes(LobeSpec),
    /// f_r over one angle.
    Slices(SliceSpec),
    /// f_r over θh and θd.
    ImageSlice(ImageSpec),
    /// Albedo over θi.
    Albedo(AlbedoSpec),
    /// Lobes in space.
    Lobe3d(Lobe3dSpec),
    /// Where E comes from.
    ErrorMap(ErrorMapSpec),
    /// The best E over s and α.
    Landscape(LandscapePanel),
    /// Models by s and α.
    Scatter,
}

/// A sphere on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SphereSpec {
    /// Lights and exposure.
    pub view: SphereView,
    /// What is on it.
    pub show: SphereShow,
    /// Where the line between data and model is: −1 at the left rim, 1 at the right.
    pub split: f64,
    /// The part in sight.
    #[serde(skip_serializing_if = "is_all")]
    pub sight: Sight,
}

impl Default for SphereSpec {
    fn default() -> Self {
        Self {
            view: SphereView::default(),
            show: SphereShow::Measured,
            split: 0.0,
            sight: Sight::default(),
        }
    }
}

fn is_all(sight: &Sight) -> bool {
    *sight == Sight::default()
}

/// What is on a sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SphereShow {
    /// The data.
    Measured,
    /// The model.
    Model,
    /// Data left of a line, model right of it.
    Split,
    /// How far they are apart, in colours.
    Error(SphereError),
}

/// Lobes in space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Lobe3dSpec {
    /// Angle of incidence in radians; in the window that where there is no probe.
    #[serde(with = "degrees")]
    pub theta_i: f64,
    /// Radius per f_r.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi.
    pub with_cosine: bool,
    /// What of the colours is shown.
    pub channel: Channel,
    /// Where it is seen from.
    pub camera: Camera,
}

impl Default for Lobe3dSpec {
    fn default() -> Self {
        Self {
            theta_i: 45f64.to_radians(),
            scale: RadialScale::CubeRoot,
            with_cosine: false,
            channel: Channel::Luminance,
            camera: Camera::default(),
        }
    }
}

/// An error map on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ErrorMapSpec {
    /// Which axes.
    pub plane: Plane,
    /// How shares become colours.
    pub scale: RadialScale,
    /// The part in sight.
    pub view: View,
    /// How much a cell counts: the key of a weight.
    pub weight: String,
    /// Grazing limit in radians.
    #[serde(with = "degrees")]
    pub limit: f64,
}

impl Default for ErrorMapSpec {
    fn default() -> Self {
        Self {
            plane: Plane::default(),
            scale: RadialScale::CubeRoot,
            view: View::default(),
            weight: "cosine".into(),
            limit: std::f64::consts::FRAC_PI_2,
        }
    }
}

/// An error landscape on paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LandscapePanel {
    /// The Fresnel factor: its key.
    pub fresnel: String,
    /// η everywhere; the best one at each point without.
    pub eta: Option<f64>,
    /// How much a cell counts: the key of a weight.
    pub weight: String,
    /// Grazing limit in radians.
    #[serde(with = "degrees")]
    pub limit: f64,
    /// (s, α) of a fit, from its start to its end.
    pub path: Vec<[f64; 2]>,
    /// (s, α) of a model.
    pub here: Option<[f64; 2]>,
    /// The part in sight.
    pub view: View,
}

impl Default for LandscapePanel {
    fn default() -> Self {
        Self {
            fresnel: "exact".into(),
            eta: Some(1.5),
            weight: "cosine".into(),
            limit: std::f64::consts::FRAC_PI_2,
            path: Vec::new(),
            here: None,
            view: View::default(),
        }
    }
}

impl ViewSpec {
    /// Name in files and on the command line.
    pub fn key(&self) -> &'static str {
        match self {
            Self::Sphere(_) => "sphere",
            Self::Lobes(_) => "lobes",
            Self::Slices(_) => "slices",
            Self::ImageSlice(_) => "image-slice",
            Self::Albedo(_) => "albedo",
            Self::Lobe3d(_) => "lobe3d",
            Self::ErrorMap(_) => "error-map",
            Self::Landscape(_) => "landscape",
            Self::Scatter => "scatter",
        }
    }

    /// The height of a panel of some width that suits it: room for the picture and for words of the size `font`.
    pub(super) fn height(&self, width: f32, font: f32) -> f32 {
        match self {
            Self::Sphere(spec) => match spec.show {
                SphereShow::Error(_) => 0.85 * width,
                _ => width,
            },
            // Half a disc, its title, and the values below it.
            Self::Lobes(_) => 0.5 * width + 4.0 * font,
            Self::Slices(spec) => match spec.residual {
                Residual::None => 0.6 * width + 3.0 * font,
                _ => 0.8 * width + 4.0 * font,
            },
            Self::Albedo(_) | Self::Scatter => 0.6 * width + 3.0 * font,
            Self::ImageSlice(_) | Self::ErrorMap(_) | Self::Landscape(_) => {
                0.65 * width + 4.0 * font
            }
            Self::Lobe3d(_) => 0.7 * width + 2.0 * font,
        }
    }

    /// Whether it has curves that a legend names.
    pub(super) fn has_curves(&self) -> bool {
        matches!(
            self,
            Self::Lobes(_) | Self::Slices(_) | Self::Albedo(_) | Self::Lobe3d(_)
        )
    }
}
