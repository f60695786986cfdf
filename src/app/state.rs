//! Everything the window shows, as plain data. It changes in [`super::update::apply`] only.

use super::derived::Derived;
use super::fitting::{FitState, KeptFit};
use super::guide::GuideAt;
use super::history::History;
use super::lessons::LessonAt;
use super::library::{Library, Presence};
use super::paper::Views;
use super::probe::Probe;
use super::session::SessionState;
use super::subjects::SubjectKey;
use super::tiles::Tiles;
use super::views::{
    AlbedoView, ErrorMapView, ImageView, LandscapeView, Lobe3dView, ScatterView, Sight, SlicesView,
};
use crate::brdf::{Brdf, ParamId};
use crate::figure::Channel;
use crate::figure::scale::RadialScale;
use crate::files::SourceFile;
use crate::fit::Variant;
use crate::geom::degrees;
use crate::geom::sphere::SphereView;
use crate::geom::sphere_error::SphereError;
use crate::measured::Table;
use crate::measured::lookup::Lookup;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

pub use super::prefs::{MemoryLimit, Prefs, Theme};

/// Number of an opened material, never used twice in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u64);

/// Where a material comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A file.
    File(PathBuf),
    /// A row of [`crate::measured::samples::SAMPLES`], by position.
    Sample(usize),
}

/// A measured material in memory.
#[derive(Clone, Debug)]
pub struct Material {
    /// Name on screen.
    pub name: String,
    /// File or sample.
    pub origin: Origin,
    /// Which file it was and what was in it; `None` for a sample and for a model without data.
    pub source: Option<SourceFile>,
    /// The data; a table without values where they are not in memory.
    pub table: Arc<Table>,
    /// Whether `table` is the data.
    pub presence: Presence,
    /// When it was shown last, by [`Library::clock`].
    pub last_shown: u64,
    /// The first guess of a model over it, made when it was loaded.
    pub guess: Brdf,
    /// Its fits, at most one per variant.
    pub fits: Vec<KeptFit>,
}

impl Material {
    /// The kept fit of a variant.
    pub fn fit(&self, variant: Variant) -> Option<&KeptFit> {
        self.fits.iter().find(|kept| kept.variant() == variant)
    }

    /// The same, to be changed.
    pub fn fit_mut(&mut self, variant: Variant) -> Option<&mut KeptFit> {
        self.fits.iter_mut().find(|kept| kept.variant() == variant)
    }
}

/// Which parts of the picture the sphere shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Show {
    /// The data.
    Measured,
    /// The model.
    Model,
    /// Data left of a line, model right of it.
    Split,
    /// Two spheres.
    SideBySide,
    /// Data and model split by a line, and beside it how far they are apart.
    Error(SphereError),
}

/// All ways to show the sphere, in the order offered.
pub const SHOWS: [Show; 6] = [
    Show::Measured,
    Show::Model,
    Show::Split,
    Show::SideBySide,
    Show::Error(SphereError::Difference),
    Show::Error(SphereError::Ratio),
];

impl Show {
    /// Name on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Measured => "Measured",
            Self::Model => "Model",
            Self::Split => "Split",
            Self::SideBySide => "Side by side",
            Self::Error(SphereError::Difference) => "Difference",
            Self::Error(SphereError::Ratio) => "Ratio",
        }
    }
}

/// What the sphere tile shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SphereTile {
    /// Lights and exposure.
    pub view: SphereView,
    /// Measured, model or both.
    pub show: Show,
    /// Where the split line is: −1 at the left rim, 1 at the right.
    pub split: f64,
    /// What of it is in sight.
    #[serde(default)]
    pub sight: Sight,
}

/// What the lobe tile shows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LobeTile {
    /// Angles of incidence in radians.
    #[serde(with = "degrees")]
    pub theta_i: Vec<f64>,
    /// The one whose vectors are drawn.
    pub active: usize,
    /// Radius per f_r.
    pub scale: RadialScale,
    /// Whether f_r is multiplied by cos θi.
    pub with_cosine: bool,
    /// Which channel.
    pub channel: Channel,
    /// The values in the middle and at the rim, in 1/sr, where the wheel has set them.
    #[serde(default)]
    pub limits: Option<[f64; 2]>,
}

/// An open material: the model over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opened {
    /// Which material.
    pub id: MaterialId,
    /// The model that is drawn over it.
    pub brdf: Brdf,
    /// Whether the plots show it beside the shown one.
    pub beside: bool,
}

/// The part of the state that undo brings back.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Which session it belongs to: a number in [`SessionState::files`], 0 at first.
    pub session: u64,
    /// Open materials in the order of the library.
    pub opened: Vec<Opened>,
    /// Position of the shown one in `opened`.
    pub selected: usize,
    /// Whether the three channels of a colour parameter move as one: ρ_d, k_s.
    pub grey: [bool; 2],
    /// What the plots do not show, though its name is in their legends.
    pub hidden: Vec<SubjectKey>,
    /// Interpolation of the table in all views.
    pub lookup: Lookup,
    /// The sphere.
    pub sphere: SphereTile,
    /// The polar lobes.
    pub lobes: LobeTile,
    /// The slices.
    pub slices: SlicesView,
    /// The albedo.
    pub albedo: AlbedoView,
    /// The lobes in space.
    pub lobe3d: Lobe3dView,
    /// The image slice.
    pub image: ImageView,
    /// The error map.
    pub error_map: ErrorMapView,
    /// The error landscape.
    pub landscape: LandscapeView,
    /// The scatter of the materials.
    pub scatter: ScatterView,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            session: 0,
            opened: Vec::new(),
            selected: 0,
            grey: [false; 2],
            hidden: Vec::new(),
            lookup: Lookup::Smooth,
            sphere: SphereTile {
                view: SphereView::default(),
                show: Show::Split,
                split: 0.0,
                sight: Sight::default(),
            },
            lobes: LobeTile {
                theta_i: [30.0, 60.0, 80.0].map(f64::to_radians).to_vec(),
                active: 1,
                scale: RadialScale::CubeRoot,
                with_cosine: false,
                channel: Channel::Luminance,
                limits: None,
            },
            slices: SlicesView::default(),
            albedo: AlbedoView::default(),
            lobe3d: Lobe3dView::default(),
            image: ImageView::default(),
            error_map: ErrorMapView::default(),
            landscape: LandscapeView::default(),
            scatter: ScatterView::default(),
        }
    }
}

impl Scene {
    /// Position of a colour parameter in `grey`.
    pub fn grey_index(id: ParamId) -> Option<usize> {
        match id {
            ParamId::RhoD => Some(0),
            ParamId::KS => Some(1),
            _ => None,
        }
    }
}

/// A job under way.
#[derive(Clone, Debug)]
pub struct Job {
    /// Its number.
    pub id: u64,
    /// What it does, for the status bar.
    pub label: String,
    /// How far it is, in [0, 1].
    pub progress: f32,
    /// Set to make it stop.
    pub cancel: CancelFlag,
    /// What becomes of what it brings.
    pub purpose: Purpose,
}

/// What becomes of what a job brings.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Purpose {
    /// A new material.
    #[default]
    Open,
    /// A material that a person steps through, if it is still wished.
    Preview,
    /// The data of this material, which were let go.
    Reload(MaterialId),
}

/// A flag that a job looks at.
#[derive(Clone, Debug, Default)]
pub struct CancelFlag(Arc<AtomicBool>);

impl CancelFlag {
    /// Asks the job to stop.
    pub fn set(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether the job is to stop.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// How bad a notice is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Good to know.
    Info,
    /// Something did not work.
    Error,
}

/// A sentence in the corner of the window, until it is closed.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// Its number.
    pub id: u64,
    /// How bad.
    pub level: Level,
    /// One line.
    pub text: String,
}

/// A window over the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialog {
    /// All commands, to be searched.
    Palette,
    /// A path to open, typed.
    OpenPath,
    /// A figure to export.
    Figure,
    /// The pages of the guide, at a place.
    Guide(GuideAt),
    /// Angles, vectors, units.
    Conventions,
    /// Version and graphics adapter.
    About,
}

/// The whole state.
#[derive(Debug, Default)]
pub struct State {
    /// What undo brings back.
    pub scene: Scene,
    /// The steps.
    pub history: History<Scene>,
    /// Data of every material that the scene or its history names.
    pub materials: BTreeMap<MaterialId, Material>,
    /// The tiles and where they are.
    pub tiles: Tiles,
    /// What views show and cannot compute within a frame.
    pub derived: Derived,
    /// Fits asked for and under way.
    pub fit: FitState,
    /// The open folder, and what is in memory.
    pub library: Library,
    /// Session files, and what is asked about them.
    pub session: SessionState,
    /// The pair of directions under the pointer.
    pub hovered: Option<Probe>,
    /// The pair of directions that stays marked wherever the pointer goes.
    pub pinned: Option<Probe>,
    /// The views that commands and figures are about.
    pub views: Views,
    /// Where a learner is.
    pub lesson: Option<LessonAt>,
    /// Jobs under way, the oldest first.
    pub jobs: Vec<Job>,
    /// Notices, the oldest first.
    pub notices: Vec<Notice>,
    /// The open dialog.
    pub dialog: Option<Dialog>,
    /// What is typed in the open dialog: words of a command, or a path.
    pub typed: String,
    /// What is kept between runs.
    pub prefs: Prefs,
    /// Source of numbers for materials, jobs and notices.
    pub next_id: u64,
}

impl State {
    /// A number not used before in this run.
    pub fn fresh_id(&mut self) -> u64 {
        self.next_id += 1;
        self.next_id
    }

    /// The shown material and the model over it: while a fit of it runs, the best so far.
    pub fn current(&self) -> Option<(&Material, &Opened)> {
        let opened = self.scene.opened.get(self.scene.selected)?;
        let live = self.fit.run.as_ref().and_then(|run| run.live.as_ref());
        let opened = live.filter(|live| live.id == opened.id).unwrap_or(opened);
        Some((self.materials.get(&opened.id)?, opened))
    }
}
