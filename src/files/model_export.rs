//! Export of models as files for other programs.

use super::error::FileError;
use super::names::short;
use crate::brdf::{Brdf, codegen};
use crate::measured::{Grid, merl, tabulate};
use std::io::{self, Write};
use std::path::Path;

/// File format of an exported model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelFormat {
    /// MERL file with the model's values at the centres of the cells.
    Merl,
    /// `.brdf` file for Disney's BRDF Explorer.
    Disney,
    /// WGSL function to paste.
    Wgsl,
    /// GLSL function to paste.
    Glsl,
}

/// All formats in the order in which they are offered.
pub const MODEL_FORMATS: [ModelFormat; 4] = [
    ModelFormat::Merl,
    ModelFormat::Disney,
    ModelFormat::Wgsl,
    ModelFormat::Glsl,
];

impl ModelFormat {
    /// Name on the command line, e.g. "merl".
    pub fn key(self) -> &'static str {
        match self {
            Self::Merl => "merl",
            Self::Disney => "disney",
            Self::Wgsl => "wgsl",
            Self::Glsl => "glsl",
        }
    }

    /// Display name, e.g. "MERL file".
    pub fn name(self) -> &'static str {
        match self {
            Self::Merl => "MERL file",
            Self::Disney => "Disney .brdf",
            Self::Wgsl => "WGSL function",
            Self::Glsl => "GLSL function",
        }
    }

    /// Description in one phrase.
    pub fn help(self) -> &'static str {
        match self {
            Self::Merl => {
                "Save the model as a measured file, with a value at the centre of each cell"
            }
            Self::Disney => "Save the model with its numbers for Disney's BRDF Explorer",
            Self::Wgsl => "Save the model with its numbers as a WGSL function to paste",
            Self::Glsl => "Save the model with its numbers as a GLSL function to paste",
        }
    }

    /// File name extension, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Merl => "binary",
            Self::Disney => "brdf",
            Self::Wgsl => "wgsl",
            Self::Glsl => "glsl",
        }
    }

    /// Whether the format is text.
    pub fn is_text(self) -> bool {
        self != Self::Merl
    }

    /// The format with this `key`.
    pub fn by_key(key: &str) -> Option<Self> {
        MODEL_FORMATS.into_iter().find(|format| format.key() == key)
    }

    /// The format that a path's extension names.
    ///
    /// # Errors
    /// Names the extensions that are expected.
    pub fn of_path(path: &Path) -> Result<Self, FileError> {
        let extension = path.extension().unwrap_or_default();
        let mut formats = MODEL_FORMATS.into_iter();
        formats
            .find(|format| extension.eq_ignore_ascii_case(format.extension()))
            .ok_or_else(|| {
                let known = MODEL_FORMATS.map(|format| format!(".{}", format.extension()));
                let known = known.join(", ");
                let what = format!("the extension does not say what to write; expected {known}");
                FileError::new(path, what)
            })
    }

    /// Writes a model; a text names the `material`.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn write(
        self,
        brdf: &Brdf,
        material: Option<&str>,
        writer: &mut dyn Write,
    ) -> io::Result<()> {
        let text = match self {
            Self::Merl => return merl::write(&tabulate(brdf, Grid::FOLDED), writer),
            Self::Disney => codegen::disney(brdf, material),
            Self::Wgsl => codegen::wgsl(brdf, material),
            Self::Glsl => codegen::glsl(brdf, material),
        };
        writer.write_all(text.as_bytes())
    }

    /// Proposed file name, e.g. `teflon_combined-exact.wgsl`.
    pub fn file_name(self, brdf: &Brdf, material: &str) -> String {
        let fresnel = match brdf.fresnel.key() {
            "none" => String::new(),
            key => format!("-{key}"),
        };
        let (material, model) = (name_part(short(material)), brdf.model.key);
        format!("{material}_{model}{fresnel}.{}", self.extension())
    }
}

/// Name as a part of a file name: letters, digits, dashes, dots and underscores.
fn name_part(name: &str) -> String {
    let kept = |c: char| c.is_alphanumeric() || matches!(c, '-' | '.' | '_');
    let parts: Vec<&str> = name
        .split(|c| !kept(c))
        .filter(|part| !part.is_empty())
        .collect();
    let joined = parts.join("-");
    let bare = joined.trim_start_matches(['.', '-']);
    if bare.is_empty() {
        "model".into()
    } else {
        bare.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::{BLINN_PHONG, COMBINED, Fresnel};

    #[test]
    fn proposed_names_are_names_of_files() {
        let mut brdf = Brdf {
            model: &COMBINED,
            fresnel: Fresnel::Exact,
            params: COMBINED.default_params(),
        };
        let name = |brdf: &Brdf, material: &str| ModelFormat::Wgsl.file_name(brdf, material);
        assert_eq!(name(&brdf, "teflon"), "teflon_combined-exact.wgsl");
        assert_eq!(
            name(&brdf, "Teflon (synthetic)"),
            "Teflon-synthetic_combined-exact.wgsl"
        );
        assert_eq!(name(&brdf, "../a/b"), "a-b_combined-exact.wgsl");
        let long = name(&brdf, &"木".repeat(70_000));
        assert!((100..=255).contains(&long.len()), "{}", long.len());
        brdf.fresnel = Fresnel::None;
        brdf.model = &BLINN_PHONG;
        assert_eq!(name(&brdf, "?"), "model_blinn-phong.wgsl");
    }

    #[test]
    fn extensions_say_what_to_write() {
        for format in MODEL_FORMATS {
            let path = format!("a.{}", format.extension().to_uppercase());
            assert_eq!(
                ModelFormat::of_path(Path::new(&path)).expect("known"),
                format
            );
            assert_eq!(ModelFormat::by_key(format.key()), Some(format));
        }
        let error = ModelFormat::of_path(Path::new("a.txt")).expect_err("unknown");
        let said = error.to_string();
        assert!(
            said.ends_with("expected .binary, .brdf, .wgsl, .glsl: a.txt"),
            "{said}"
        );
    }
}
