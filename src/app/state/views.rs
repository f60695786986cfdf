//! The views as plain data: identity, name, help and place. [`crate::app::views`] has what draws them.

use crate::app::state::view_settings::SettingsKind;
use crate::app::views::albedo::settings::AlbedoSettings;
use crate::app::views::error_map::settings::ErrorMapSettings;
use crate::app::views::image::settings::ImageSettings;
use crate::app::views::landscape::settings::LandscapeSettings;
use crate::app::views::lobe3d::settings::Lobe3dSettings;
use crate::app::views::lobes::settings::LobeSettings;
use crate::app::views::scatter::settings::ScatterSettings;
use crate::app::views::slices::settings::SliceSettings;
use crate::app::views::sphere::settings::SphereSettings;

pub use crate::app::state::view_id::ViewId;

/// The half of the default layout in which a view is at first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// With the sphere.
    Upper,
    /// With the lobes.
    Lower,
}

/// When a figure can show a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnPaper {
    /// It cannot.
    Never,
    /// Where a material is open.
    Always,
    /// Where the shown material has data.
    WithData,
    /// Where some material has a fit of the combined model.
    WithCombinedFits,
}

/// What there is to know about a view without drawing it.
#[derive(Debug)]
pub struct About {
    /// Which one.
    pub id: ViewId,
    /// Name in ids and file names.
    pub key: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Three lines behind its "?".
    pub help: [&'static str; 3],
    /// Where it is at first.
    pub home: Home,
    /// When a figure can show it.
    pub on_paper: OnPaper,
    /// How its settings are made and read; `None` where it has none.
    pub settings: Option<SettingsKind>,
}

impl About {
    /// Its name in the settings of a session.
    pub fn session_key(&self) -> String {
        self.key.replace('-', "_")
    }
}

impl ViewId {
    /// The row of this view.
    pub fn about(self) -> &'static About {
        // Every identity has a row: a test below.
        let row = VIEWS.iter().find(|row| row.id == self);
        row.unwrap_or(&VIEWS[0])
    }
}

/// All views in the order of their tabs.
pub const VIEWS: &[About] = &[
    About {
        id: ViewId::Sphere,
        key: "sphere",
        name: "Sphere",
        help: [
            "The material on a sphere, lit from far away: data, model, or both.",
            "Drag a highlight to move its light, or the line to compare; the wheel zooms. Double click puts all back.",
            "Point at it to read angles and values in the status bar; a click pins them.",
        ],
        home: Home::Upper,
        on_paper: OnPaper::Always,
        settings: Some(SettingsKind::of::<SphereSettings>()),
    },
    About {
        id: ViewId::Fits,
        key: "fits",
        name: "Fits",
        help: [
            "Every fit of this material, the best first; E is the share of misplaced reflection.",
            "A click on a row shows that model.",
            "A tick draws it beside the model in the plots.",
        ],
        home: Home::Upper,
        on_paper: OnPaper::Never,
        settings: None,
    },
    About {
        id: ViewId::Landscape,
        key: "landscape",
        name: "Error landscape",
        help: [
            "The least E that the combined model has at each s and α, with ρd and ks solved there; below is Phong, above Blinn-Phong.",
            "Line: the way of the last fit from its ring. Dot: the sliders. Diamond: the best. E is estimated on some of the cells.",
            "A click takes what is under the pointer. Drag moves, the wheel zooms, double click shows all.",
        ],
        home: Home::Upper,
        on_paper: OnPaper::WithData,
        settings: Some(SettingsKind::of::<LandscapeSettings>()),
    },
    About {
        id: ViewId::Scatter,
        key: "scatter",
        name: "Materials",
        help: [
            "Every material with a fit of the combined model: α over s.",
            "At α = 0 a material is Phong-like, at α = 1 Blinn-Phong-like. Open ones have a ring.",
            "Point to read a name and its numbers; a click shows that material. The wheel zooms, double click shows all.",
        ],
        home: Home::Upper,
        on_paper: OnPaper::WithCombinedFits,
        settings: Some(SettingsKind::of::<ScatterSettings>()),
    },
    About {
        id: ViewId::Lobes,
        key: "lobes",
        name: "Polar lobes",
        help: [
            "f_r over the view angle in the plane of incidence: a curve per angle of incidence.",
            "Light comes from the left. Drag a handle on the rim to move it, the wheel zooms; double click puts all back.",
            "Point to read values, click to pin. A click on a name hides it, a double click shows it alone.",
        ],
        home: Home::Lower,
        on_paper: OnPaper::Always,
        settings: Some(SettingsKind::of::<LobeSettings>()),
    },
    About {
        id: ViewId::Slices,
        key: "slices",
        name: "Slices",
        help: [
            "f_r over one angle with the others fixed, and what is between model and measurement below.",
            "The wheel zooms the angle, over the numbers at the left or with Ctrl the values; drag to pan, double click resets.",
            "Point to read values, click to pin. \"Follow\" takes the fixed angles from the other views.",
        ],
        home: Home::Lower,
        on_paper: OnPaper::Always,
        settings: Some(SettingsKind::of::<SliceSettings>()),
    },
    About {
        id: ViewId::Albedo,
        key: "albedo",
        name: "Albedo",
        help: [
            "The share of the light from one angle that comes back, over all view directions; more than 1 is marked.",
            "Of a measurement it is the sum over what was measured; the dotted line says which share that is.",
            "Point to read values, click to pin. The wheel zooms, double click resets.",
        ],
        home: Home::Lower,
        on_paper: OnPaper::Always,
        settings: Some(SettingsKind::of::<AlbedoSettings>()),
    },
    About {
        id: ViewId::Lobe3d,
        key: "lobe3d",
        name: "3D lobe",
        help: [
            "f_r over all view directions for one angle of incidence: data as a solid, models as wire.",
            "Drag to turn it, wheel to zoom, double click puts the view back.",
            "The light is that of the probe. Point at the lobe to read values, click to pin.",
        ],
        home: Home::Lower,
        on_paper: OnPaper::Always,
        settings: Some(SettingsKind::of::<Lobe3dSettings>()),
    },
    About {
        id: ViewId::Image,
        key: "image",
        name: "Image slice",
        help: [
            "f_r over half and difference angle at one φd, cell by cell: data, model, residual or ratio.",
            "Hatched was not measured, blank is below the horizon; past the dashed line light or view is beyond 80°.",
            "Point to read values, click to pin. Drag moves, the wheel zooms, double click shows all.",
        ],
        home: Home::Lower,
        on_paper: OnPaper::Always,
        settings: Some(SettingsKind::of::<ImageSettings>()),
    },
    About {
        id: ViewId::ErrorMap,
        key: "error-map",
        name: "Error map",
        help: [
            "Where the E of the model comes from: its share in each direction, with the weight and limit of the fit.",
            "The shares add up to all of E. Swapped light and view are the same, so each counts half.",
            "Point to read shares, click to pin. Drag moves, the wheel zooms, double click shows all.",
        ],
        home: Home::Lower,
        on_paper: OnPaper::WithData,
        settings: Some(SettingsKind::of::<ErrorMapSettings>()),
    },
];
