//! A session as plain data, as its file has it. `docs/formats.md` documents the keys.

use crate::app::state::fitting::table::{Column, FitTable};
use crate::app::state::layout::Tiles;
use crate::app::state::settings_map::SettingsMap;
use crate::brdf;
use crate::brdf::params::ETA;
use crate::brdf::{Brdf, Model, ParamId, param_by_key};
use crate::files::fits;
use crate::files::fits::FitRecord;
use crate::files::path_text;
use crate::files::session::SavedSource;
use crate::fit::Weight;
use crate::fit::options::NO_LIMIT;
use crate::geom::degrees;
use crate::json;
use crate::measured::lookup::Lookup;
use glam::DVec3;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The version of the format that is written, and the only one that is read.
pub const VERSION: u64 = 1;

/// All that a session file holds, in the order in which it is written.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SessionFile {
    /// [`VERSION`]
    pub grazing_session: u64,
    /// The program that wrote it.
    pub program: String,
    /// Version of that program.
    pub version: String,
    /// The session file that an autosave belongs to.
    #[serde(
        serialize_with = "path_text::serialize",
        skip_serializing_if = "Option::is_none"
    )]
    pub saved_as: Option<PathBuf>,
    /// Open materials in their order.
    pub materials: Vec<SavedMaterial>,
    /// Position of the shown one.
    pub shown: usize,
    /// Subjects that the plots do not show.
    pub hidden: Vec<SavedKey>,
    /// Interpolation of the tables.
    pub lookup: Lookup,
    /// Settings of the views.
    pub views: SettingsMap,
    /// Settings of the next fit.
    pub fit: SavedFitting,
    /// The pinned pair of directions.
    pub probe: Option<SavedProbe>,
    /// The tiles and where they are; `None` leaves them as they are.
    #[serde(serialize_with = "sorted")]
    pub layout: Option<Tiles>,
}

/// A material with what lies over it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SavedMaterial {
    /// Name on screen.
    pub name: String,
    /// The measured file; `None` for a sample and for a model alone.
    pub source: Option<SavedSource>,
    /// Key of a synthetic sample.
    pub sample: Option<String>,
    /// The model over it.
    pub model: SavedBrdf,
    /// The first guess from its data.
    pub guess: SavedBrdf,
    /// Whether the plots show it beside the shown one.
    pub beside: bool,
    /// Kept fits, at most one per variant.
    pub fits: Vec<SavedFit>,
}

/// A model with all its numbers, η too where no Fresnel factor uses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SavedBrdf(pub Brdf);

impl Serialize for SavedBrdf {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut value = brdf::json::to_value(&self.0);
        value[ParamId::ETA.key()] = json!(self.0.params.eta);
        value.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for SavedBrdf {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut value = json::bounded(deserializer, json::MOST_OF_MODEL)?;
        // Sessions once kept the numbers of parameters that the model does not have.
        let model = value.get("model").and_then(Value::as_str);
        if let Some(model) = model.and_then(Model::by_key)
            && let Some(object) = value.as_object_mut()
        {
            object.retain(|key, _| param_by_key(key).is_none_or(|id| model.param(id).is_some()));
        }
        let mut brdf = brdf::json::from_value(&value).map_err(D::Error::custom)?;
        let eta = value.get(ParamId::ETA.key()).and_then(Value::as_f64);
        if let Some(eta) = eta.filter(|eta| ETA.accepts(*eta)) {
            brdf.params.eta = eta;
        }
        Ok(Self(brdf))
    }
}

/// A kept fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedFit {
    /// The fit as fit files have it.
    #[serde(serialize_with = "write_record", deserialize_with = "read_record")]
    pub record: FitRecord,
    /// Duration in seconds.
    #[serde(default)]
    pub seconds: Option<f64>,
    /// Whether its lobes are drawn beside the model's.
    #[serde(default)]
    pub overlaid: bool,
}

fn write_record<S: Serializer>(record: &FitRecord, serializer: S) -> Result<S::Ok, S::Error> {
    fits::to_value(record).serialize(serializer)
}

fn read_record<'de, D: Deserializer<'de>>(deserializer: D) -> Result<FitRecord, D::Error> {
    fits::from_value(Value::deserialize(deserializer)?).map_err(D::Error::custom)
}

/// A name in the legends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedKey {
    /// Position of its material.
    pub material: usize,
    /// Values of it: data, model or a fit.
    pub what: SavedWhat,
}

/// Values of a material: data, model or a fit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SavedWhat {
    /// The data.
    Measured,
    /// The model over them.
    Model,
    /// A kept fit.
    Fit {
        /// Key of the model.
        model: String,
        /// Key of the Fresnel factor.
        fresnel: String,
    },
}

/// Settings of the next fit, and the order of the table of fits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedFitting {
    /// Weight of the cells in E.
    pub weight: Weight,
    /// Grazing limit: degrees in the file, radians here.
    #[serde(with = "degrees")]
    pub limit: f64,
    /// Numbers of the stages that are run.
    pub stages: Vec<usize>,
    /// Keys of the parameters that are held.
    pub held: Vec<String>,
    /// Bounds that are not the default, smallest and largest, by key of the parameter.
    pub bounds: BTreeMap<String, (f64, f64)>,
    /// Whether the fit begins at the sliders.
    pub from_sliders: bool,
    /// Whether ρ_d and k_s follow the other parameters.
    pub keep_optimal: bool,
    /// Column that the table is ordered by.
    pub sort: Column,
    /// Whether the largest value comes first.
    pub descending: bool,
    /// Keys of the columns that the table does not show.
    pub hidden_columns: Vec<String>,
}

impl Default for SavedFitting {
    fn default() -> Self {
        let table = FitTable::default();
        Self {
            weight: Weight::default(),
            limit: NO_LIMIT,
            stages: vec![1, 2, 3, 4],
            held: Vec::new(),
            bounds: BTreeMap::new(),
            from_sliders: false,
            keep_optimal: false,
            sort: table.sort,
            descending: table.descending,
            hidden_columns: keys_of_hidden(&table),
        }
    }
}

/// Keys of the hidden columns of a table, in their order.
pub fn keys_of_hidden(table: &FitTable) -> Vec<String> {
    let hidden = table.hidden.iter();
    hidden.map(|column| column.key().into()).collect()
}

/// A pair of unit vectors in the local frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedProbe {
    /// Unit vector to the light.
    pub wi: DVec3,
    /// Unit vector to the viewer.
    pub wo: DVec3,
}

impl SessionFile {
    /// The text of the file: the same for the same session.
    ///
    /// # Errors
    /// None that can be expected: every part is data that JSON has.
    pub fn text(&self) -> serde_json::Result<String> {
        let mut text = serde_json::to_string_pretty(self)?;
        text.push('\n');
        Ok(text)
    }

    /// Sets the relative paths for a session file in this folder.
    pub fn place_in(&mut self, folder: &Path) {
        let sources = self.materials.iter_mut().flat_map(|m| &mut m.source);
        sources.for_each(|source| source.place_in(folder));
    }
}

/// Writes the layout with sorted keys, as it has them in no order, and without a counter that depends on the past.
fn sorted<S: Serializer>(layout: &Option<Tiles>, serializer: S) -> Result<S::Ok, S::Error> {
    let mut value = serde_json::to_value(layout).map_err(serde::ser::Error::custom)?;
    if let Some(next) = value.pointer_mut("/tree/tiles/next_tile_id") {
        *next = json!(1);
    }
    value.serialize(serializer)
}
