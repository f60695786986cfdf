//! Reader of sessions, from text to data. What is not understood is left out and spoken about, the rest is taken.

use crate::app::session::differences::differences;
use crate::app::session::file::{SavedBrdf, SavedFit, SavedMaterial, SessionFile, VERSION};
use crate::app::session::sanitize;
use crate::app::state::Scene;
use crate::app::state::layout::Tiles;
use crate::app::state::settings_map::SettingsMap;
use crate::app::state::views::VIEWS;
use crate::brdf::{Brdf, Fresnel, MODELS};
use crate::files::path_text::PathText;
use crate::files::session::KEY;
use crate::json;
use crate::keys;
use crate::quote::shown;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::path::PathBuf;

/// Bytes of memory that a session takes at most while it is read: that of 50,000 fits.
const MOST_BYTES: usize = 256 << 20;

/// Number of places that are named in one line.
const NAMED: usize = 4;

/// A session, and a line on each thing in its file that was not taken as it stands there.
pub type Read = (SessionFile, Vec<String>);

/// Reads a session.
///
/// # Errors
/// One line that says why this is none.
pub fn read(text: &str) -> Result<Read, String> {
    let given = json::value(text, MOST_BYTES)?;
    match given.get(KEY) {
        None => return Err(format!("this is no session: it has no key \"{KEY}\"")),
        Some(version) if version.as_u64() == Some(VERSION) => {}
        Some(version) => {
            return Err(format!(
                "this session has the version {}; expected {VERSION}; \
                 newer ones need a newer Grazing",
                shown(&version.to_string())
            ));
        }
    }
    let Some(Value::Array(materials)) = given.get("materials") else {
        return Err("this session has no array \"materials\"".into());
    };
    if let Some(index) = materials.iter().position(|material| !material.is_object()) {
        return Err(format!("material {index} of this session is no object"));
    }
    let mut reader = Reader::default();
    let materials = materials
        .iter()
        .enumerate()
        .map(|(index, value)| reader.material(value, index))
        .collect();
    let session = reader.session(&given, materials);
    let kept = sanitize::session(session);
    let written = serde_json::to_value(&kept).unwrap_or_default();
    reader.report(&given, &written);
    Ok((kept, reader.remarks))
}

#[derive(Default)]
struct Reader {
    remarks: Vec<String>,
    /// Places that a remark speaks about.
    spoken_of: Vec<String>,
}

impl Reader {
    /// The value of a key; `usual` where there is none or it is not understood.
    fn part<T: DeserializeOwned>(&mut self, object: &Value, at: &str, key: &str, usual: T) -> T {
        match object.get(key) {
            None | Some(Value::Null) => usual,
            Some(value) => self.understood(value, join(at, key)).unwrap_or(usual),
        }
    }

    fn understood<T: DeserializeOwned>(&mut self, value: &Value, at: String) -> Option<T> {
        self.taken(T::deserialize(value), at)
    }

    /// Part that was read, or `None` and a remark that it was not understood.
    fn taken<T>(&mut self, read: serde_json::Result<T>, at: String) -> Option<T> {
        match read {
            Ok(part) => Some(part),
            Err(error) => {
                let (said, place) = (keys::with_proposal(&error), shown(&at));
                self.remarks.push(format!(
                    "\"{place}\" is not understood and left out: {said}"
                ));
                self.spoken_of.push(at);
                None
            }
        }
    }

    fn material(&mut self, value: &Value, index: usize) -> SavedMaterial {
        let at = format!("materials.{index}");
        let unset = SavedBrdf(Brdf::new(MODELS[0], Fresnel::None));
        let guess = self.part(value, &at, "guess", None);
        let model = self.part(value, &at, "model", None);
        let fits_at = join(&at, "fits");
        let mut fits: Vec<SavedFit> = Vec::new();
        match value.get("fits") {
            None | Some(Value::Null) => {}
            Some(Value::Array(items)) => {
                for (index, item) in items.iter().enumerate() {
                    match self.understood(item, join(&fits_at, &index.to_string())) {
                        Some(fit) => fits.push(fit),
                        // The places of those that follow are others now.
                        None => self.spoken_of.push(fits_at.clone()),
                    }
                }
            }
            Some(other) => {
                self.understood::<Vec<SavedFit>>(other, fits_at);
            }
        }
        SavedMaterial {
            name: self.part(value, &at, "name", String::new()),
            source: self.part(value, &at, "source", None),
            sample: self.part(value, &at, "sample", None),
            model: model.or(guess).unwrap_or(unset),
            guess: guess.or(model).unwrap_or(unset),
            beside: self.part(value, &at, "beside", false),
            fits,
        }
    }

    fn session(&mut self, given: &Value, materials: Vec<SavedMaterial>) -> SessionFile {
        let usual = Scene::default();
        let mut text = |key: &str| self.part(given, "", key, String::new());
        let (program, version) = (text("program"), text("version"));
        let layout: Option<Tiles> = self.part(given, "", "layout", None);
        self.spoken_of.push("layout".into());
        // Sessions once said which colours moved as one; all do now, at their hue.
        self.spoken_of.push("grey".into());
        SessionFile {
            grazing_session: VERSION,
            program,
            version,
            saved_as: self
                .part(given, "", "saved_as", None::<PathText>)
                .map(PathBuf::from),
            materials,
            shown: self.part(given, "", "shown", 0),
            hidden: self.part(given, "", "hidden", Vec::new()),
            lookup: self.part(given, "", "lookup", usual.lookup),
            views: self.views(given),
            fit: self.part(given, "", "fit", Default::default()),
            probe: self.part(given, "", "probe", None),
            layout,
        }
    }

    fn views(&mut self, given: &Value) -> SettingsMap {
        let mut all = SettingsMap::default();
        for about in VIEWS {
            let key = about.session_key();
            let value = given.get("views").and_then(|views| views.get(&key));
            let value = value.filter(|value| !value.is_null());
            let (Some(kind), Some(value)) = (about.settings, value) else {
                continue;
            };
            if let Some(settings) = self.taken(kind.read(value), join("views", &key)) {
                all.set(settings);
            }
        }
        all
    }

    /// Says what was out of range, and which keys are not known.
    fn report(&mut self, given: &Value, kept: &Value) {
        let found = differences(given, kept, &self.spoken_of);
        for (places, one, many) in [
            (
                found.changed,
                "a value is not possible and was replaced",
                "values are not possible and were replaced",
            ),
            (
                found.unknown,
                "a key is not known and left out",
                "keys are not known and left out",
            ),
        ] {
            let more = places.len().saturating_sub(NAMED);
            let named = places[..places.len() - more].iter();
            let mut named = named
                .map(|place| shown(place))
                .collect::<Vec<_>>()
                .join(", ");
            if more > 0 {
                named += &format!(" and {more} more");
            }
            match places.len() {
                0 => {}
                1 => self.remarks.push(format!("{one}: {named}")),
                count => self.remarks.push(format!("{count} {many}: {named}")),
            }
        }
    }
}

fn join(at: &str, key: &str) -> String {
    if at.is_empty() {
        key.to_owned()
    } else {
        format!("{at}.{key}")
    }
}
