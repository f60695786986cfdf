//! The numbers that a picture draws, for spreadsheets: a row per point that is drawn.
//!
//! Angles are in degrees, `value` is in the unit that the picture's title states. What has no value is empty.

use super::cosine::CosineFactor;
use super::heatmap::HeatField as Cells;
use super::subject::{Channel, Look, Subject};
use std::sync::Arc;

/// Content of a field.
#[derive(Clone, Debug, PartialEq)]
pub enum TableField {
    /// Words, shared by the rows that have the same.
    Text(Arc<str>),
    /// A number.
    Number(f64),
    /// No content.
    Empty,
}

impl From<f64> for TableField {
    /// Empty where it is no number.
    fn from(number: f64) -> Self {
        if number.is_finite() {
            Self::Number(number)
        } else {
            Self::Empty
        }
    }
}

impl From<Option<f64>> for TableField {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Empty, Self::from)
    }
}

impl From<&str> for TableField {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

/// Rows of fields under names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataTable {
    /// Names of the columns.
    pub columns: Vec<&'static str>,
    /// Rows, with as many fields in each as there are columns.
    pub rows: Vec<Vec<TableField>>,
}

impl DataTable {
    /// A table without rows.
    pub fn new(columns: &[&'static str]) -> Self {
        Self {
            columns: columns.to_vec(),
            rows: Vec::new(),
        }
    }

    /// Tables under each other. Each row says in `panel`, counted from 1, whose it is, and is empty in the columns of
    /// others.
    pub fn joined(tables: Vec<Self>) -> Self {
        let mut all = Self::new(&["panel"]);
        for table in &tables {
            for column in &table.columns {
                if !all.columns.contains(column) {
                    all.columns.push(column);
                }
            }
        }
        // Taken apart, so that no number is there twice.
        for (panel, table) in tables.into_iter().enumerate() {
            for row in table.rows {
                let mut fields = vec![TableField::Empty; all.columns.len()];
                fields[0] = TableField::Number((panel + 1) as f64);
                for (column, field) in table.columns.iter().zip(row) {
                    if let Some(at) = all.columns.iter().position(|other| other == column) {
                        fields[at] = field;
                    }
                }
                all.rows.push(fields);
            }
        }
        all
    }

    /// Text with `separator` between fields, quoted where they hold it. Numbers are read back as the same f64.
    pub fn text(&self, separator: char) -> String {
        let mut text = self.columns.join(&separator.to_string());
        text.push('\n');
        for row in &self.rows {
            for (k, field) in row.iter().enumerate() {
                if k > 0 {
                    text.push(separator);
                }
                match field {
                    TableField::Text(words) => text.push_str(&quoted(words, separator)),
                    // Whole numbers without a point.
                    TableField::Number(number) if number.fract() == 0.0 && number.abs() < 1e15 => {
                        text.push_str(&format!("{number:.0}"));
                    }
                    TableField::Number(number) => text.push_str(&format!("{number:?}")),
                    TableField::Empty => {}
                }
            }
            text.push('\n');
        }
        text
    }

    /// Cells by the middles of their edges, under two names and that of the value.
    pub fn of_cells(names: [&'static str; 3], cells: &Cells) -> Self {
        let mut table = Self::new(&names);
        let middle = |edges: &[f64], k: usize| 0.5 * (edges[k] + edges[k + 1]);
        for row in 0..cells.rows() {
            for column in 0..cells.columns() {
                if let Some(value) = cells.cell(column, row).value() {
                    let (x, y) = (middle(&cells.x, column), middle(&cells.y, row));
                    table.rows.push(vec![x.into(), y.into(), value.into()]);
                }
            }
        }
        table
    }
}

/// The fields that say what a curve shows: quantity, channel, name and kind of its subject.
pub fn curve_head(cosine: CosineFactor, channel: Channel, subject: &Subject) -> [TableField; 4] {
    [
        cosine.quantity().into(),
        channel.name().into(),
        subject.label.as_str().into(),
        kind(subject).into(),
    ]
}

/// Whether a subject is measured or a model, as it stands in a table.
pub fn kind(subject: &Subject) -> &'static str {
    match subject.look {
        Look::Measured => "measured",
        Look::Model | Look::Dashed | Look::Beside { .. } => "model",
    }
}

fn quoted(words: &str, separator: char) -> String {
    let plain: String = words
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    if plain.contains([separator, '"']) {
        format!("\"{}\"", plain.replace('"', "\"\""))
    } else {
        plain
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_joined_by_the_names_of_their_columns() {
        let table = |columns: &[&'static str], fields: Vec<TableField>| DataTable {
            columns: columns.to_vec(),
            rows: vec![fields],
        };
        let joined = DataTable::joined(vec![
            table(&["curve", "value"], vec!["a,\"b\"".into(), 0.1.into()]),
            table(&["s", "value"], vec![300.0.into(), f64::NAN.into()]),
        ]);
        assert_eq!(
            joined.text(','),
            "panel,curve,value,s\n1,\"a,\"\"b\"\"\",0.1,\n2,,,300\n"
        );
        let back: f64 = format!("{:?}", 0.1 + 0.2).parse().expect("a number");
        assert_eq!(back, 0.1 + 0.2);
    }

    #[test]
    fn names_cannot_break_rows() {
        let mut table = DataTable::new(&["material", "s", "alpha"]);
        let name = "two\nlines\tand a tab";
        table.rows.push(vec![name.into(), 1e-20.into(), 0.5.into()]);
        let text = table.text('\t');
        assert_eq!(
            text,
            "material\ts\talpha\ntwo lines and a tab\t1e-20\t0.5\n"
        );
    }
}
