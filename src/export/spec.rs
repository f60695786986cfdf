//! A figure as a file: everything that it takes to draw it again.

use super::fit_output;
use crate::brdf::Brdf;
use crate::figure::faults::Faults;
use crate::figure::page::{self, PageSpec, RowSpec, Style};
use crate::figure::subject::Look;
use crate::files;
use crate::files::fits::SourceFile;
use crate::json;
use crate::keys;
use crate::measured::{Lookup, SAMPLES, SyntheticMaterial};
use crate::quote::shown;
use serde::de::IgnoredAny;
use serde::{Deserialize, Serialize};
use serde_path_to_error::Segment;
use std::path::{Path, PathBuf};

/// A figure: whose f_r, how it is shown, how it looks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FigureSpec {
    /// Program that made it.
    #[serde(default = "program")]
    pub program: String,
    /// Version of that program.
    #[serde(default = "version")]
    pub version: String,
    /// The measurements and models, which panels name by position.
    pub subjects: Vec<SubjectSpec>,
    /// The panels.
    pub rows: Vec<RowSpec>,
    /// Look on paper.
    #[serde(default)]
    pub style: Style,
}

fn program() -> String {
    env!("CARGO_PKG_NAME").into()
}

fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// A measurement or a model in a figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SubjectSpec {
    /// Name in legends and titles.
    pub label: String,
    /// Look of its curves; that of its source where it is `None`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub look: Option<SubjectLook>,
    /// The number of its colour.
    #[serde(default)]
    pub series: usize,
    /// Source of the values.
    pub source: SubjectSource,
}

/// Look of curves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SubjectLook {
    /// Solid.
    Measured,
    /// Dashed.
    Model,
    /// Dotted.
    Dotted,
    /// Long dashes.
    LongDashes,
    /// Dashed, over the first measurement of its panel.
    Dashed,
}

impl SubjectLook {
    /// Look in the terms of plots.
    pub fn look(self) -> Look {
        match self {
            Self::Measured => Look::Measured,
            Self::Model => Look::Model,
            Self::Dotted => Look::Beside { long: false },
            Self::LongDashes => Look::Beside { long: true },
            Self::Dashed => Look::Dashed,
        }
    }
}

impl From<Look> for SubjectLook {
    fn from(look: Look) -> Self {
        match look {
            Look::Measured => Self::Measured,
            Look::Model => Self::Model,
            Look::Beside { long: false } => Self::Dotted,
            Look::Beside { long: true } => Self::LongDashes,
            Look::Dashed => Self::Dashed,
        }
    }
}

/// Source of values.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SubjectSource {
    /// A MERL file.
    Measured {
        /// File by its path, length and SHA-256.
        file: SourceFile,
        /// Lookup by which values are taken from its table.
        lookup: Lookup,
    },
    /// A synthetic sample.
    Sample {
        /// Key of the synthetic material.
        key: String,
        /// Lookup by which values are taken from its table.
        lookup: Lookup,
    },
    /// A model with its numbers.
    Model(Brdf),
}

impl FigureSpec {
    /// A figure made by this program.
    pub fn new(subjects: Vec<SubjectSpec>, page: PageSpec) -> Self {
        Self {
            program: program(),
            version: version(),
            subjects,
            rows: page.rows,
            style: page.style,
        }
    }

    /// Reads a figure.
    ///
    /// # Errors
    /// One sentence that says where the text is no figure.
    pub fn from_json(text: &str) -> Result<Self, String> {
        if json::has_keys(text, ["rows"]) == [false] {
            serde_json::from_str::<IgnoredAny>(text).map_err(|error| json::problem(&error))?;
            return Err("this is no figure: \"rows\" is missing; expected a .figure.json that Grazing has written".into());
        }
        // From the text again: an error in it says line and column.
        let mut reader = serde_json::Deserializer::from_str(text);
        serde_path_to_error::deserialize(&mut reader).map_err(|error| {
            let said = keys::with_proposal(error.inner());
            let keys: Vec<String> = error.path().iter().filter_map(key_of).collect();
            match keys.as_slice() {
                [] => format!("not a figure: {said}"),
                keys => format!("not a figure: {}: {said}", shown(&keys.join("."))),
            }
        })
    }

    /// Brings every value to the nearest that can be drawn, and names those that it changed.
    pub fn sanitize(&mut self, faults: &mut Faults) {
        faults.inside("subjects", |faults| {
            for (position, subject) in self.subjects.iter().enumerate() {
                faults.inside(position.to_string(), |faults| subject.check(faults));
            }
        });
        let count = self.subjects.len();
        page::sanitize(&mut self.rows, &mut self.style, count, faults);
        faults.inside("rows", |faults| {
            for (position, row) in self.rows.iter_mut().enumerate() {
                faults.inside(position.to_string(), |faults| sanitize_weights(row, faults));
            }
        });
    }

    /// The text of its file. The same figure gives the same text.
    pub fn to_json(&self) -> String {
        // Plain data: there is nothing that cannot be written.
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Whether a file has this very text.
    pub fn is_in(&self, path: &Path) -> bool {
        files::read_text(path).is_ok_and(|text| text == self.to_json())
    }

    /// The figure as it is read back from its file, where angles are rounded, with every value that cannot be drawn brought
    /// to the nearest: what is drawn now and what is drawn from the file are the same.
    pub fn settled(&self) -> Self {
        let mut spec = Self::from_json(&self.to_json()).unwrap_or_else(|_| self.clone());
        spec.sanitize(&mut Faults::default());
        spec
    }

    /// Spec of its page.
    pub fn page(&self) -> PageSpec {
        PageSpec {
            rows: self.rows.clone(),
            style: self.style.clone(),
        }
    }
}

impl SubjectSpec {
    /// Names a sample that there is not; there is none that is nearest.
    fn check(&self, faults: &mut Faults) {
        let SubjectSource::Sample { key, .. } = &self.source else {
            return;
        };
        if SyntheticMaterial::by_key(key).is_none() {
            let known = SAMPLES.each_ref().map(|sample| sample.key);
            let proposal = keys::did_you_mean(key, known);
            let expected = format!("one of {}{proposal}", known.join(", "));
            faults.inside("source.sample", |faults| {
                faults.add("key", format_args!("{key:?}"), expected);
            });
        }
    }
}

fn sanitize_weights(row: &mut RowSpec, faults: &mut Faults) {
    faults.inside("panels", |faults| {
        for (position, panel) in row.panels.iter_mut().enumerate() {
            let view = &mut panel.view;
            faults.inside(format!("{position}.view"), |faults| {
                fit_output::sanitize(view, faults);
            });
        }
    });
}

/// A step of the way to a value in JSON; a case of an enum is a key too.
fn key_of(step: &Segment) -> Option<String> {
    match step {
        Segment::Seq { index } => Some(index.to_string()),
        Segment::Map { key } => Some(key.clone()),
        Segment::Enum { .. } | Segment::Unknown => None,
    }
}

/// Path of the spec that is kept beside a figure, under its name.
pub fn spec_beside(figure: &Path) -> PathBuf {
    figure.with_extension("figure.json")
}
