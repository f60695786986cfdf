//! A figure as a file: everything that it takes to draw it again.

use crate::brdf::Brdf;
use crate::figure::page::{PageSpec, RowSpec, Style};
use crate::figure::subject::Look;
use crate::files::fits::SourceFile;
use crate::files::{self, FileError};
use crate::keys;
use crate::measured::Lookup;
use serde::{Deserialize, Serialize};
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
}

impl SubjectLook {
    /// Look in the terms of plots.
    pub fn look(self) -> Look {
        match self {
            Self::Measured => Look::Measured,
            Self::Model => Look::Model,
            Self::Dotted => Look::Beside { long: false },
            Self::LongDashes => Look::Beside { long: true },
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
        let value: serde_json::Value =
            serde_json::from_str(text).map_err(|error| format!("not valid JSON: {error}"))?;
        if value.get("rows").is_none() {
            return Err("this is no figure: \"rows\" is missing; expected a .figure.json that Grazing has written".into());
        }
        // From the text again: an error in it says line and column.
        serde_json::from_str(text)
            .map_err(|error| format!("not a figure: {}", keys::with_proposal(&error)))
    }

    /// Reads a figure from a file.
    ///
    /// # Errors
    /// One line with the path last.
    pub fn open(path: &Path) -> Result<Self, FileError> {
        let text = files::read_text(path)?;
        Self::from_json(&text).map_err(|what| FileError::new(path, what))
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

    /// The figure as it is read back from its file, where angles are rounded: what is drawn now and what is drawn from
    /// the file are the same.
    pub fn settled(&self) -> Self {
        Self::from_json(&self.to_json()).unwrap_or_else(|_| self.clone())
    }

    /// Spec of its page.
    pub fn page(&self) -> PageSpec {
        PageSpec {
            rows: self.rows.clone(),
            style: self.style.clone(),
        }
    }
}

/// Path of the spec that is kept beside a figure, under its name.
pub fn spec_beside(figure: &Path) -> PathBuf {
    figure.with_extension("figure.json")
}
