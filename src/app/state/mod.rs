//! State of the window, as plain data. It changes in [`crate::app::reduce::apply`] only.

pub mod about;
pub mod cache;
pub mod figure;
pub mod fits;
pub mod fitted;
pub mod fitting;
pub mod folder_fit;
pub mod history;
pub mod job;
pub mod layout;
pub mod layout_check;
pub mod lesson;
pub mod letters;
pub mod library;
pub mod material;
pub mod memory;
pub mod notice;
pub mod prefs;
pub mod probe;
pub mod queries;
pub mod sanitize;
pub mod session;
pub mod session_mark;
pub mod settings_map;
pub mod shared_table;
pub mod side_panels;
pub mod sources;
pub mod subject_key;
pub mod subjects;
pub mod values;
pub mod view_id;
pub mod view_settings;
pub mod views;

use crate::app::state::cache::Caches;
use crate::app::state::figure::FigureViews;
use crate::app::state::fitting::FitState;
use crate::app::state::history::History;
use crate::app::state::job::Job;
use crate::app::state::layout::Tiles;
use crate::app::state::lesson::LessonAt;
use crate::app::state::letters::Letters;
use crate::app::state::library::Library;
use crate::app::state::material::{Material, MaterialId, Opened};
use crate::app::state::notice::{Dialog, Notice};
use crate::app::state::prefs::Prefs;
use crate::app::state::probe::Probe;
use crate::app::state::session::SessionState;
use crate::app::state::settings_map::SettingsMap;
use crate::app::state::subject_key::SubjectKey;
use crate::measured::lookup::Lookup;
use std::collections::BTreeMap;

/// The part of the state that undo brings back.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Session it belongs to: a number in [`SessionState::files`], 0 at first.
    pub session: u64,
    /// Open materials in the order of the library.
    pub opened: Vec<Opened>,
    /// Position of the shown one in `opened`.
    pub selected: usize,
    /// Subjects that the plots do not show, though their names are in the legends.
    pub hidden: Vec<SubjectKey>,
    /// Interpolation of the table in all views.
    pub lookup: Lookup,
    /// Settings of the views.
    pub views: SettingsMap,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            session: 0,
            opened: Vec::new(),
            selected: 0,
            hidden: Vec::new(),
            lookup: Lookup::Smooth,
            views: SettingsMap::default(),
        }
    }
}

/// The whole state.
#[derive(Debug, Default)]
pub struct State {
    /// Part of the state that undo brings back.
    pub scene: Scene,
    /// The steps.
    pub history: History<Scene>,
    /// Data of every material that the scene or its history names.
    pub materials: BTreeMap<MaterialId, Material>,
    /// The tiles and where they are.
    pub tiles: Tiles,
    /// Results that views show and cannot compute within a frame.
    pub caches: Caches,
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
    pub views: FigureViews,
    /// Place of a learner in the lessons.
    pub lesson: Option<LessonAt>,
    /// Letters that the fonts of the window lack.
    pub letters: Letters,
    /// Jobs under way, the oldest first.
    pub jobs: Vec<Job>,
    /// Notices, the oldest first.
    pub notices: Vec<Notice>,
    /// The open dialog.
    pub dialog: Option<Dialog>,
    /// Text typed in the open dialog: words of a command, or a path.
    pub typed: String,
    /// Preferences, kept between runs.
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
