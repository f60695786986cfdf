//! Tables on the terminal: columns that align, numbers at their decimal points.

use crate::quote::within;
use std::io::{self, Write};
use unicode_width::UnicodeWidthStr as _;

/// Columns that a text takes at most: a file may hold names of any length.
const WIDEST: usize = 40;

/// Stands where there is no value.
const NOTHING: &str = "–";

/// Values of a column, from above.
pub enum Column {
    /// Texts, from the left; long ones are cut in the middle.
    Text(Vec<String>),
    /// Numbers, right-aligned on their decimal points; `None` where there is none.
    Numbers(Vec<Option<String>>),
}

/// Writes a line of heads and a line per row, with two blanks between columns.
///
/// # Errors
/// Errors of the writer.
pub fn write(columns: Vec<(&str, Column)>, out: &mut dyn Write) -> io::Result<()> {
    let columns: Vec<Vec<String>> = columns.into_iter().map(aligned).collect();
    let rows = columns.iter().map(Vec::len).max().unwrap_or(0);
    for row in 0..rows {
        let cells: Vec<&str> = columns
            .iter()
            .map(|column| column.get(row).map_or("", String::as_str))
            .collect();
        writeln!(out, "{}", cells.join("  ").trim_end())?;
    }
    Ok(())
}

/// Head and cells of a column, all as wide.
fn aligned((head, column): (&str, Column)) -> Vec<String> {
    let (cells, right) = match column {
        Column::Text(cells) => (
            cells.iter().map(|cell| within(cell, WIDEST)).collect(),
            false,
        ),
        Column::Numbers(cells) => (at_points(&cells), true),
    };
    let all: Vec<String> = std::iter::once(head.to_owned()).chain(cells).collect();
    let width = all.iter().map(|cell| cell.width()).max().unwrap_or(0);
    let padded = |cell: String| {
        let room = " ".repeat(width - cell.width());
        if right { room + &cell } else { cell + &room }
    };
    all.into_iter().map(padded).collect()
}

/// Numbers with as many blanks behind them as bring their points under each other.
fn at_points(cells: &[Option<String>]) -> Vec<String> {
    let behind = |cell: &Option<String>| {
        let point = cell
            .as_ref()
            .and_then(|cell| Some(cell.len() - cell.find('.')?));
        point.unwrap_or(0)
    };
    let most = cells.iter().map(behind).max().unwrap_or(0);
    let place = |cell: &Option<String>| {
        let text = cell.as_deref().unwrap_or(NOTHING);
        format!("{text}{}", " ".repeat(most - behind(cell)))
    };
    cells.iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(columns: Vec<(&str, Column)>) -> String {
        let mut out = Vec::new();
        write(columns, &mut out).expect("memory takes it");
        String::from_utf8(out).expect("UTF-8")
    }

    fn numbers(cells: &[&str]) -> Column {
        let cell = |cell: &&str| (!cell.is_empty()).then(|| (*cell).to_owned());
        Column::Numbers(cells.iter().map(cell).collect())
    }

    #[test]
    fn points_are_under_each_other_and_names_of_any_script_align() {
        let names = ["gold", "黄金"].map(String::from).to_vec();
        let found = text(vec![
            ("material", Column::Text(names)),
            ("E", numbers(&["0.25", "12.5"])),
            ("s", numbers(&["7", ""])),
        ]);
        let wanted = "material      E  s\ngold       0.25  7\n黄金      12.5   –\n";
        assert_eq!(found, wanted);
    }

    #[test]
    fn a_long_name_is_cut_in_the_middle_and_widens_nothing_further() {
        let long = |middle: &str| format!("begin{}end", middle.repeat(100));
        for name in [long("x"), long("木")] {
            let found = text(vec![
                ("material", Column::Text(vec![name, "gold".into()])),
                ("E", numbers(&["0.1", "0.2"])),
            ]);
            for line in found.lines() {
                assert!(line.width() <= WIDEST + 5, "{found}");
            }
            assert!(found.contains("begin") && found.contains("end "), "{found}");
            assert!(found.contains('…'), "{found}");
        }
        let just = "x".repeat(WIDEST);
        assert_eq!(within(&just, WIDEST), just);
    }
}
