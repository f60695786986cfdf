//! The numbers that a picture draws, for spreadsheets: a row per point that is drawn.
//!
//! Angles are in degrees, `value` is in the unit that the picture's title states. What has no value is empty.

use super::albedo::AlbedoPoint;
use super::heatmap::{Cell, Field as Cells};
use super::image_slice::{ImageSpec, Shown};
use super::landscape::Terrain;
use super::lobes::{LobePlot, LobeSpec};
use super::scatter::ScatterDot;
use super::slices::{Over, Residual, SlicePlot, SliceSpec};
use super::subject::{Channel, Look, Subject};
use crate::geom::degrees::rounded;

/// What stands in a field.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// Words.
    Text(String),
    /// A number.
    Number(f64),
    /// Nothing.
    Empty,
}

impl From<f64> for Field {
    /// Empty where it is no number.
    fn from(number: f64) -> Self {
        if number.is_finite() {
            Self::Number(number)
        } else {
            Self::Empty
        }
    }
}

impl From<Option<f64>> for Field {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::Empty, Self::from)
    }
}

impl From<&str> for Field {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

/// Rows of fields under names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Names of the columns.
    pub columns: Vec<&'static str>,
    /// As many fields as columns in each.
    pub rows: Vec<Vec<Field>>,
}

impl Table {
    fn new(columns: &[&'static str]) -> Self {
        Self {
            columns: columns.to_vec(),
            rows: Vec::new(),
        }
    }

    /// Tables under each other. Each row says in `panel`, counted from 1, whose it is, and is empty in the columns of
    /// others.
    pub fn joined(tables: &[Self]) -> Self {
        let mut all = Self::new(&["panel"]);
        for table in tables {
            for column in &table.columns {
                if !all.columns.contains(column) {
                    all.columns.push(column);
                }
            }
        }
        for (panel, table) in tables.iter().enumerate() {
            for row in &table.rows {
                let mut fields = vec![Field::Empty; all.columns.len()];
                fields[0] = Field::Number((panel + 1) as f64);
                for (column, field) in table.columns.iter().zip(row) {
                    if let Some(at) = all.columns.iter().position(|other| other == column) {
                        fields[at] = field.clone();
                    }
                }
                all.rows.push(fields);
            }
        }
        all
    }

    /// As text with `separator` between fields, quoted where they hold it. Numbers are read back as the same f64.
    pub fn text(&self, separator: char) -> String {
        let mut text = self.columns.join(&separator.to_string());
        text.push('\n');
        for row in &self.rows {
            for (k, field) in row.iter().enumerate() {
                if k > 0 {
                    text.push(separator);
                }
                match field {
                    Field::Text(words) => text.push_str(&quoted(words, separator)),
                    // Whole numbers without a point.
                    Field::Number(number) if number.fract() == 0.0 && number.abs() < 1e15 => {
                        text.push_str(&format!("{number:.0}"));
                    }
                    Field::Number(number) => text.push_str(&format!("{number:?}")),
                    Field::Empty => {}
                }
            }
            text.push('\n');
        }
        text
    }

    /// The curves of a lobe plot.
    pub fn of_lobes(plot: &LobePlot, spec: &LobeSpec, subjects: &[Subject]) -> Self {
        let mut table = Self::new(&[
            "quantity", "channel", "curve", "kind", "theta_i", "theta_o", "value",
        ]);
        for trace in &plot.traces {
            let head = head(spec.with_cosine, spec.channel, &subjects[trace.subject]);
            for sample in &trace.samples {
                let mut row = head.to_vec();
                row.push(rounded(spec.theta_i[trace.lobe]).into());
                row.push(rounded(sample.x).into());
                row.push(sample.value.into());
                table.rows.push(row);
            }
        }
        table
    }

    /// The curves of a plot of slices, and the residuals below them.
    pub fn of_slices(plot: &SlicePlot, spec: &SliceSpec, subjects: &[Subject]) -> Self {
        let mut table = Self::new(&[
            "quantity", "channel", "curve", "kind", "theta_i", "theta_o", "theta_h", "theta_d",
            "phi_d", "value",
        ]);
        let angles = |slice: usize, x: f64| -> [Field; 5] {
            let (x, fixed) = (Field::from(rounded(x)), |angle: f64| {
                Field::from(rounded(angle))
            });
            match spec.over {
                Over::ThetaO => {
                    let theta_i = fixed(spec.theta_i[slice]);
                    [theta_i, x, Field::Empty, Field::Empty, Field::Empty]
                }
                Over::ThetaH => [
                    Field::Empty,
                    Field::Empty,
                    x,
                    fixed(spec.theta_d),
                    fixed(spec.phi_d),
                ],
                Over::ThetaD => [
                    Field::Empty,
                    Field::Empty,
                    fixed(spec.theta_h),
                    x,
                    fixed(spec.phi_d),
                ],
                Over::PhiD => [
                    Field::Empty,
                    Field::Empty,
                    fixed(spec.theta_h),
                    fixed(spec.theta_d),
                    x,
                ],
            }
        };
        for trace in &plot.traces {
            let head = head(spec.with_cosine, spec.channel, &subjects[trace.subject]);
            for sample in &trace.samples {
                let mut row = head.to_vec();
                row.extend(angles(trace.slice, sample.x));
                row.push(sample.value.into());
                table.rows.push(row);
            }
        }
        for trace in &plot.residuals {
            let mut head = head(spec.with_cosine, spec.channel, &subjects[trace.model]);
            head[0] = match spec.residual {
                Residual::Ratio => "model / measured".into(),
                Residual::None | Residual::Difference => "model − measured".into(),
            };
            for sample in &trace.samples {
                let mut row = head.to_vec();
                row.extend(angles(trace.slice, sample.x));
                row.push(sample.value.into());
                table.rows.push(row);
            }
        }
        table
    }

    /// The cells of an image slice that are above the horizon; a value that was not measured is empty.
    pub fn of_image(spec: &ImageSpec, cells: &Cells) -> Self {
        let mut table = Self::new(&[
            "quantity", "channel", "theta_h", "theta_d", "phi_d", "value",
        ]);
        let what = match spec.shown {
            Shown::Measured | Shown::Model => quantity(spec.with_cosine),
            Shown::Residual => "model − measured",
            Shown::Ratio => "model / measured",
        };
        for row in 0..cells.rows() {
            for column in 0..cells.columns() {
                let cell = cells.cell(column, row);
                if cell == Cell::Outside {
                    continue;
                }
                let angles = spec.angles(column, row);
                table.rows.push(vec![
                    what.into(),
                    spec.channel.name().into(),
                    rounded(angles.theta_h).into(),
                    rounded(angles.theta_d).into(),
                    rounded(angles.phi_d).into(),
                    cell.value().into(),
                ]);
            }
        }
        table
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

    /// E in percent at the nodes of a landscape.
    pub fn of_terrain(terrain: &Terrain) -> Self {
        let mut table = Self::new(&["s", "alpha", "percent_e"]);
        let nodes = terrain
            .alpha
            .iter()
            .flat_map(|alpha| terrain.s.iter().map(move |s| (*s, *alpha)));
        for ((s, alpha), percent) in nodes.zip(&terrain.percent) {
            table
                .rows
                .push(vec![s.into(), alpha.into(), (*percent).into()]);
        }
        table
    }

    /// Albedos of subjects, in the same order.
    pub fn of_albedos(channel: Channel, subjects: &[Subject], curves: &[Vec<AlbedoPoint>]) -> Self {
        let mut table = Self::new(&[
            "quantity",
            "channel",
            "curve",
            "kind",
            "theta_i",
            "value",
            "measured_share",
        ]);
        for (subject, curve) in subjects.iter().zip(curves) {
            for point in curve {
                table.rows.push(vec![
                    "albedo".into(),
                    channel.name().into(),
                    subject.label.as_str().into(),
                    kind(subject).into(),
                    rounded(point.theta_i).into(),
                    channel.of(point.rgb).into(),
                    point.measured.into(),
                ]);
            }
        }
        table
    }

    /// Materials by s and α.
    pub fn of_dots(dots: &[ScatterDot]) -> Self {
        let mut table = Self::new(&["material", "s", "alpha"]);
        for dot in dots {
            let name = dot.name.as_str().into();
            table.rows.push(vec![name, dot.s.into(), dot.alpha.into()]);
        }
        table
    }
}

fn head(with_cosine: bool, channel: Channel, subject: &Subject) -> [Field; 4] {
    [
        quantity(with_cosine).into(),
        channel.name().into(),
        subject.label.as_str().into(),
        kind(subject).into(),
    ]
}

fn quantity(with_cosine: bool) -> &'static str {
    if with_cosine {
        "f_r cos theta_i"
    } else {
        "f_r"
    }
}

fn kind(subject: &Subject) -> &'static str {
    match subject.look {
        Look::Measured => "measured",
        Look::Model | Look::Beside { .. } => "model",
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
        let table = |columns: &[&'static str], fields: Vec<Field>| Table {
            columns: columns.to_vec(),
            rows: vec![fields],
        };
        let joined = Table::joined(&[
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
        let dot = ScatterDot {
            name: "two\nlines\tand a tab".into(),
            s: 1e-20,
            alpha: 0.5,
            fill: super::super::Role::Muted,
            ring: None,
            shown: false,
        };
        let text = Table::of_dots(&[dot]).text('\t');
        assert_eq!(
            text,
            "material\ts\talpha\ntwo lines and a tab\t1e-20\t0.5\n"
        );
    }
}
