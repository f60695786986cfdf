//! The table of fits: its columns, which of them are shown, and its order.

use crate::brdf::{ParamId, all_params};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A column of the table of fits.
///
/// In files: its key, which for a parameter is that of the parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum Column {
    /// Model, then Fresnel factor.
    Name,
    /// E over all cells.
    #[default]
    Error,
    /// E over the grazing cells.
    Grazing,
    /// E over all cells of a channel: R, G or B.
    Channel(usize),
    /// A parameter with one number: of a lobe, or η.
    Param(ParamId),
    /// Number of evaluations of E.
    Evaluations,
    /// Duration of the fit.
    Time,
}

const CHANNELS: [&str; 3] = ["error_r", "error_g", "error_b"];

impl Column {
    /// All columns from left to right.
    pub fn all() -> impl Iterator<Item = Self> {
        let errors = [Self::Name, Self::Error, Self::Grazing].into_iter();
        let params = all_params().filter(|row| !row.id.is_color());
        errors
            .chain((0..CHANNELS.len()).map(Self::Channel))
            .chain(params.map(|row| Self::Param(row.id)))
            .chain([Self::Evaluations, Self::Time])
    }

    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Name => "name",
            Self::Error => "error",
            Self::Grazing => "grazing",
            Self::Channel(channel) => CHANNELS[channel % CHANNELS.len()],
            Self::Param(id) => id.key(),
            Self::Evaluations => "evaluations",
            Self::Time => "time",
        }
    }

    /// The column with this key.
    pub fn by_key(key: &str) -> Option<Self> {
        Self::all().find(|column| column.key() == key)
    }
}

impl TryFrom<String> for Column {
    type Error = String;

    fn try_from(key: String) -> Result<Self, String> {
        Self::by_key(&key).ok_or_else(|| {
            let known: Vec<&str> = Self::all().map(Self::key).collect();
            format!("no column `{key}`; expected one of {}", known.join(", "))
        })
    }
}

impl From<Column> for String {
    fn from(column: Column) -> Self {
        column.key().into()
    }
}

/// Order of the table of fits, and its hidden columns.
#[derive(Clone, Debug, PartialEq)]
pub struct FitTable {
    /// Column that the rows are ordered by.
    pub sort: Column,
    /// Whether the largest value comes first.
    pub descending: bool,
    /// Columns that are not shown.
    pub hidden: BTreeSet<Column>,
}

impl Default for FitTable {
    fn default() -> Self {
        let channels = (0..CHANNELS.len()).map(Column::Channel);
        Self {
            sort: Column::Error,
            descending: false,
            hidden: channels.chain([Column::Evaluations]).collect(),
        }
    }
}

impl FitTable {
    /// Orders by a column; the other way round where that is the order already.
    pub fn sort_by(&mut self, column: Column) {
        self.descending = self.sort == column && !self.descending;
        self.sort = column;
    }

    /// Shows a column, or hides it. Names are always shown.
    pub fn show(&mut self, column: Column, shown: bool) {
        if shown {
            self.hidden.remove(&column);
        } else if column != Column::Name {
            self.hidden.insert(column);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_its_own_key_and_is_found_by_it() {
        let keys: BTreeSet<&str> = Column::all().map(Column::key).collect();
        assert_eq!(keys.len(), Column::all().count());
        for column in Column::all() {
            let text = serde_json::to_string(&column).expect("JSON");
            assert_eq!(serde_json::from_str::<Column>(&text).expect("read"), column);
        }
        let wrong = serde_json::from_str::<Column>(r#""gloss""#).expect_err("no such column");
        assert!(
            wrong
                .to_string()
                .contains("no column `gloss`; expected one of name, error")
        );
    }

    #[test]
    fn a_second_click_turns_the_order_round() {
        let mut table = FitTable::default();
        table.sort_by(Column::Error);
        assert!(table.descending);
        table.sort_by(Column::Error);
        assert!(!table.descending);
        table.sort_by(Column::Time);
        assert_eq!((table.sort, table.descending), (Column::Time, false));
    }

    #[test]
    fn names_cannot_be_hidden() {
        let mut table = FitTable::default();
        table.show(Column::Name, false);
        table.show(Column::Error, false);
        table.show(Column::Evaluations, true);
        assert!(!table.hidden.contains(&Column::Name));
        assert!(table.hidden.contains(&Column::Error));
        assert!(!table.hidden.contains(&Column::Evaluations));
    }
}
