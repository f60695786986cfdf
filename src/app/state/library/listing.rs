//! List of the folder's files: which are shown, and in which order.

use crate::app::state::library::{Examined, FileKind, FolderFile, Library};
use crate::brdf::{MODELS, Model, ParamId};
use crate::figure::scatter::Quantity;
use crate::files::fits::FitRecord;
use std::cmp::Ordering;
use std::path::{Path, PathBuf};

/// Quantity that the files are ordered by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SortKey {
    /// Name, with numbers by value.
    #[default]
    Name,
    /// Half-width of the highlight.
    Width,
    /// E of the best fit.
    Error,
    /// E of the best fit over the cells towards grazing.
    Grazing,
    /// Parameter of the best fit of a model; of a colour the luminance.
    Param(&'static Model, ParamId),
}

/// Keys that need no model, in the order offered.
pub const SORT_KEYS: [SortKey; 4] = [
    SortKey::Name,
    SortKey::Width,
    SortKey::Error,
    SortKey::Grazing,
];

impl SortKey {
    /// Name on screen, in the markup of [`crate::figure::text`].
    pub fn name(self) -> String {
        match self {
            Self::Name => "Name".into(),
            Self::Width => "Width of the highlight".into(),
            Self::Error => "E of the best fit".into(),
            Self::Grazing => "Grazing E of the best fit".into(),
            Self::Param(model, id) => match model.param(id) {
                Some(row) => format!("{}, {}", row.symbol, row.name),
                None => id.key().into(),
            },
        }
    }
}

/// An order of the files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FileSort {
    /// Quantity that they are ordered by.
    pub key: SortKey,
    /// Whether the largest comes first.
    pub descending: bool,
}

impl Library {
    /// Kind of a file of the folder; `None` where the folder has no such file.
    pub fn kind_of(&self, path: &Path) -> Option<&FileKind> {
        let mut files = self.folder.as_ref()?.files.iter();
        files.find(|file| file.path == path).map(|file| &file.kind)
    }

    /// The measured files in the order in which they are listed.
    pub fn steps(&self) -> Vec<PathBuf> {
        let Some(folder) = &self.folder else {
            return Vec::new();
        };
        let rows = self.visible();
        let files = rows.iter().map(|index| &folder.files[*index]);
        files
            .filter(|file| file.is_measured())
            .map(|file| file.path.clone())
            .collect()
    }

    /// Positions of the files that the search leaves, in order. Files without a value come last in either direction.
    pub fn visible(&self) -> Vec<usize> {
        let Some(folder) = &self.folder else {
            return Vec::new();
        };
        let words: Vec<String> = self
            .search
            .to_lowercase()
            .split_whitespace()
            .map(str::to_owned)
            .collect();
        let found = |file: &FolderFile| {
            let name = file.name.to_lowercase();
            words.iter().all(|word| name.contains(word))
        };
        let mut rows: Vec<(usize, Option<f64>)> = folder
            .files
            .iter()
            .enumerate()
            .filter(|(_, file)| found(file))
            .map(|(index, file)| (index, self.value(file)))
            .collect();
        // They are in the order of their names.
        match (self.sort.key, self.sort.descending) {
            (SortKey::Name, false) => {}
            (SortKey::Name, true) => rows.reverse(),
            (_, descending) => rows.sort_by(|a, b| in_order(a.1, b.1, descending)),
        }
        rows.into_iter().map(|(index, _)| index).collect()
    }

    /// The fit that a file is listed with: the best one, of the model that the order is about where it is about one.
    pub fn listed_fit(&self, path: &Path) -> Option<&FitRecord> {
        let SortKey::Param(model, _) = self.sort.key else {
            return self.best_fit(path);
        };
        let fits = self.fits.get(path)?.iter();
        let of_model = fits.filter(|fit| fit.brdf.model == model);
        of_model.min_by(|a, b| a.errors.total.total_cmp(&b.errors.total))
    }

    /// The models that files of the folder have fits of.
    pub fn fitted_models(&self) -> impl Iterator<Item = &'static Model> {
        let of = |model: &Model| self.folder_fits().any(|fit| fit.brdf.model == model);
        MODELS.iter().copied().filter(move |model| of(model))
    }

    /// The number that a file is ordered by.
    fn value(&self, file: &FolderFile) -> Option<f64> {
        let fit = || self.listed_fit(&file.path);
        match self.sort.key {
            SortKey::Name => None,
            SortKey::Error => Some(fit()?.errors.total),
            SortKey::Grazing => fit()?.errors.grazing,
            SortKey::Param(_, id) => Quantity::Param(id).value(&fit()?.brdf, None),
            // What has no highlight has a wide one.
            SortKey::Width => Some(file.examined()?.half_width.unwrap_or(f64::INFINITY)),
        }
    }
}

fn in_order(a: Option<f64>, b: Option<f64>, descending: bool) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) if descending => b.total_cmp(&a),
        (Some(a), Some(b)) => a.total_cmp(&b),
        (a, b) => b.is_some().cmp(&a.is_some()),
    }
}

impl FolderFile {
    /// Content of the file, once it has been read.
    pub fn examined(&self) -> Option<&Examined> {
        match &self.kind {
            FileKind::Measured(examined) => examined.as_ref(),
            _ => None,
        }
    }

    /// Whether it can be opened as a material, as far as is known.
    pub fn is_measured(&self) -> bool {
        matches!(self.kind, FileKind::Measured(_))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::state::library::Folder;
    use crate::app::state::library::Scan;
    use crate::app::state::library::fixtures::record;
    use crate::brdf::{Brdf, COMBINED, Fresnel, PHONG};
    use std::path::PathBuf;

    fn library(names: &[&str]) -> Library {
        let files = names.iter().map(|name| FolderFile {
            path: PathBuf::from(name),
            name: (*name).into(),
            kind: FileKind::Measured(None),
        });
        Library {
            folder: Some(Folder {
                number: 1,
                path: PathBuf::new(),
                files: files.collect(),
                scan: Scan::Done,
                cancel: Default::default(),
            }),
            ..Library::default()
        }
    }

    #[test]
    fn every_typed_word_is_in_the_name() {
        let mut library = library(&["blue paint", "Blue rubber", "red paint"]);
        let found = |library: &mut Library, text: &str| {
            library.search = text.into();
            library.visible()
        };
        assert_eq!(found(&mut library, ""), [0, 1, 2]);
        assert_eq!(found(&mut library, " BLUE "), [0, 1]);
        assert_eq!(found(&mut library, "paint blue"), [0]);
        assert_eq!(found(&mut library, "green"), [0; 0]);
    }

    #[test]
    fn what_has_no_value_comes_last_in_either_direction() {
        let mut library = library(&["a", "b", "c", "d"]);
        for (name, error, s) in [("b", 0.2, 5.0), ("d", 0.1, 9.0), ("d", 0.3, 1.0)] {
            let mut fit = record(s, error);
            fit.errors.grazing = (name == "b").then_some(0.05);
            if s == 1.0 {
                fit.brdf.model = &PHONG;
            }
            library.keep_fit(name.as_ref(), fit);
        }
        let mut order = |key, descending| {
            library.sort = FileSort { key, descending };
            library.visible()
        };
        assert_eq!(order(SortKey::Name, true), [3, 2, 1, 0]);
        assert_eq!(order(SortKey::Error, false), [3, 1, 0, 2]);
        assert_eq!(order(SortKey::Error, true), [1, 3, 0, 2]);
        assert_eq!(order(SortKey::Grazing, true), [1, 0, 2, 3]);
        assert_eq!(order(SortKey::Width, false), [0, 1, 2, 3]);
        // Of two models the one that is meant.
        let of = |model| SortKey::Param(model, ParamId("s"));
        assert_eq!(order(of(&COMBINED), false), [1, 3, 0, 2]);
        assert_eq!(order(of(&PHONG), false), [3, 0, 1, 2]);
        let models: Vec<_> = library.fitted_models().collect();
        assert_eq!(models, [&PHONG, &COMBINED]);
        let fit = library.listed_fit("d".as_ref()).expect("a fit");
        assert_eq!(fit.brdf.model, &PHONG);
    }

    #[test]
    fn every_parameter_of_every_model_is_a_key_with_a_value() {
        for model in MODELS {
            for row in model.rows() {
                let mut library = library(&["a", "b"]);
                let mut fit = record(1.0, 0.1);
                fit.brdf = Brdf::new(model, Fresnel::Exact);
                library.keep_fit("b".as_ref(), fit);
                let key = SortKey::Param(model, row.id);
                library.sort = FileSort {
                    key,
                    descending: false,
                };
                assert_eq!(library.visible(), [1, 0], "{}", key.name());
                assert!(key.name().starts_with(row.symbol));
            }
        }
    }
}
