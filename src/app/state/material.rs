//! Materials: measured data with the models laid over them.

use crate::app::state::fitting::kept::KeptFit;
use crate::brdf::Brdf;
use crate::files;
use crate::files::SourceFile;
use crate::fit::Variant;
use crate::measured::Table;
use std::path::PathBuf;
use std::sync::Arc;

/// Number of an opened material, never used twice in a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u64);

/// Origin of a material.
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
    /// Name on screen; [`Self::own_name`], with a folder where another open material has that too.
    pub name: String,
    /// Name that its file, sample or model has.
    pub own_name: String,
    /// File or sample.
    pub origin: Origin,
    /// File it was read from, with its length and SHA-256; `None` for a sample and for a model without data.
    pub source: Option<SourceFile>,
    /// The data; a table without values where they are not in memory.
    pub table: Arc<Table>,
    /// Whether `table` is the data.
    pub presence: Presence,
    /// Time at which it was shown last, by [`crate::app::state::library::Library::clock`].
    pub last_shown: u64,
    /// The first guess of a model over it, made when it was loaded.
    pub guess: Brdf,
    /// Whether it has been opened and is yet to be fitted.
    pub fit_due: bool,
    /// Kept fits, at most one per variant.
    pub fits: Vec<KeptFit>,
}

impl Material {
    /// The kept fit of a variant.
    pub fn fit(&self, variant: Variant) -> Option<&KeptFit> {
        self.fits.iter().find(|kept| kept.variant() == variant)
    }

    /// Kept fit of a variant, to be changed.
    pub fn fit_mut(&mut self, variant: Variant) -> Option<&mut KeptFit> {
        self.fits.iter_mut().find(|kept| kept.variant() == variant)
    }
}

/// An open material: the model over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opened {
    /// Material that the model lies over.
    pub id: MaterialId,
    /// The model that is drawn over it.
    pub brdf: Brdf,
    /// Whether the plots show it beside the shown one.
    pub beside: bool,
}

/// Whether the table of a material is in memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Presence {
    /// In memory.
    #[default]
    Loaded,
    /// Let go, and read again when the material is shown.
    Evicted,
    /// Being read by this job.
    Loading(u64),
    /// Not to be read again: its file is not there or cannot be read.
    Missing,
}

impl Material {
    /// The measured file it was read from, from the root on.
    pub fn file(&self) -> Option<PathBuf> {
        match &self.origin {
            Origin::File(path) if self.source.is_some() => Some(files::absolute(path)),
            _ => None,
        }
    }

    /// Whether its data are on their way.
    pub fn is_loading(&self) -> bool {
        matches!(self.presence, Presence::Loading(_) | Presence::Evicted)
    }
}
