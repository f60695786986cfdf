//! CSV files of direction pairs: their columns found by name, their other columns kept.
//!
//! The text is the only thing that is kept of a file: its rows are read from it a second time when they are used.

use super::error::FileError;
use crate::encoding::{WIDE, is_wide};
use crate::geom::direction;
use crate::quote::{quoted, shown};
use csv::StringRecord;
use glam::DVec3;
use std::collections::HashSet;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The columns that make a direction pair, in degrees.
pub const ANGLES: [&str; 4] = ["theta_i", "phi_i", "theta_o", "phi_o"];

/// Bytes of a file at most, those of 20 million pairs.
pub const MOST: u64 = 512 << 20;

/// A turn: what is more is a slip, radians times something, or a mark for a missing value.
const MAX_DEGREES: f64 = 360.0;

/// A CSV of direction pairs in which every row is good.
#[derive(Debug)]
pub struct Directions {
    text: String,
    /// Names of all columns.
    pub header: StringRecord,
    /// The columns of [`ANGLES`].
    pub columns: [usize; 4],
}

/// Reads a file, or standard input for `-`. `added` are the columns that will be added: they must not be there yet.
///
/// # Errors
/// Says in one line what is wrong, what was expected and, last, the path.
pub fn read(path: &Path, added: &[&str]) -> Result<Directions, FileError> {
    let (path, bytes) = if path == Path::new("-") {
        let path = Path::new("standard input");
        (path, read_all(io::stdin().lock()))
    } else if path.is_dir() {
        return Err(FileError::new(
            path,
            "this is a directory; expected a CSV file",
        ));
    } else {
        (path, File::open(path).and_then(read_all))
    };
    let bytes = bytes.map_err(|error| FileError::io(path, "cannot read the file", &error))?;
    if bytes.len() as u64 > MOST {
        let what = format!(
            "the file is too large; CSV is read up to {} MiB; split it",
            MOST >> 20
        );
        return Err(FileError::new(path, what));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let what = if is_wide(error.as_bytes()) {
            WIDE
        } else {
            "it is no UTF-8 text"
        };
        FileError::new(path, format!("not a CSV file: {what}"))
    })?;
    parse(text, added).map_err(|what| FileError::new(path, what))
}

/// All bytes, or one more than are taken.
fn read_all(reader: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    reader.take(MOST + 1).read_to_end(&mut bytes)?;
    bytes.shrink_to_fit();
    Ok(bytes)
}

/// Checks a text and each of its rows.
///
/// # Errors
/// Says in one sentence what is wrong, with the line.
pub fn parse(text: String, added: &[&str]) -> Result<Directions, String> {
    let mut reader = reader(&text);
    let header = reader
        .headers()
        .map_err(|error| shown(&error.to_string()))?
        .clone();
    let columns = columns(&header, added)?;
    let mut row = StringRecord::new();
    while next(&mut reader, &mut row)? {
        pair(&row, columns, header.len())
            .map_err(|what| format!("line {}{what}", line_of(&text, &row)))?;
    }
    Ok(Directions {
        text,
        header,
        columns,
    })
}

impl Directions {
    /// Calls `each` with all rows as they were written, each with wi and wo.
    ///
    /// # Errors
    /// The first error of `each`.
    pub fn for_each<E>(
        &self,
        mut each: impl FnMut(&StringRecord, DVec3, DVec3) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut reader = reader(&self.text);
        let mut row = StringRecord::new();
        // All rows were good when they were read first.
        while let Ok(true) = next(&mut reader, &mut row) {
            if let Ok([wi, wo]) = pair(&row, self.columns, self.header.len()) {
                each(&row, wi, wo)?;
            }
        }
        Ok(())
    }
}

fn reader(text: &str) -> csv::Reader<&[u8]> {
    let text = text.trim_start_matches('\u{feff}');
    csv::ReaderBuilder::new()
        .flexible(true)
        .from_reader(text.as_bytes())
}

fn next(reader: &mut csv::Reader<&[u8]>, row: &mut StringRecord) -> Result<bool, String> {
    reader
        .read_record(row)
        .map_err(|error| shown(&error.to_string()))
}

/// The columns of [`ANGLES`], each there once.
fn columns(header: &StringRecord, added: &[&str]) -> Result<[usize; 4], String> {
    let expected = ANGLES.join(",");
    if header.is_empty() {
        return Err(format!(
            "the CSV file is empty; expected the columns {expected}"
        ));
    }
    let mut columns = [0; 4];
    for (column, name) in columns.iter_mut().zip(ANGLES) {
        let mut found = header
            .iter()
            .enumerate()
            .filter(|(_, title)| title.trim() == name);
        *column = match (found.next(), found.next()) {
            (Some((column, _)), None) => column,
            (Some(_), Some(_)) => return Err(format!("line 1: there are two columns {name}")),
            (None, _) if header.len() == 1 && header[0].contains([';', '\t']) => {
                return Err(format!(
                    "line 1: the columns are not separated by commas; expected {expected}"
                ));
            }
            (None, _) => {
                return Err(format!(
                    "line 1: there is no column {name}; expected the columns {expected}, in degrees"
                ));
            }
        };
    }
    if let Some(title) = header.iter().find(|title| added.contains(&title.trim())) {
        return Err(format!(
            "line 1: there is a column {} already, which is what is added; rename it",
            title.trim()
        ));
    }
    let mut seen = HashSet::new();
    let twice = header
        .iter()
        .map(str::trim)
        .find(|title| !title.is_empty() && !seen.insert(*title));
    match twice {
        Some(title) => Err(format!("line 1: there are two columns {}", shown(title))),
        None => Ok(columns),
    }
}

/// wi and wo of a row of `width` columns; or what is wrong with it, to be put behind its line.
fn pair(row: &StringRecord, columns: [usize; 4], width: usize) -> Result<[DVec3; 2], String> {
    if row.len() != width {
        return Err(format!(
            ": the row has {} columns; expected {width}",
            row.len()
        ));
    }
    let mut radians = [0.0; 4];
    for ((radians, column), name) in radians.iter_mut().zip(columns).zip(ANGLES) {
        let field = &row[column];
        let number = field.trim().parse::<f64>().ok().filter(|x| x.is_finite());
        let Some(degrees) = number else {
            return Err(format!(
                ", column {name}: {} is no number; expected an angle in degrees",
                quoted(field)
            ));
        };
        if degrees.abs() > MAX_DEGREES {
            return Err(format!(
                ", column {name}: {} is out of range; expected −{MAX_DEGREES} to {MAX_DEGREES} degrees",
                shown(field)
            ));
        }
        *radians = degrees.to_radians();
    }
    let [theta_i, phi_i, theta_o, phi_o] = radians;
    Ok([direction(theta_i, phi_i), direction(theta_o, phi_o)])
}

/// The line at which a row starts. The reader counts blank lines before a row to the row.
fn line_of(text: &str, row: &StringRecord) -> usize {
    let text = text.trim_start_matches('\u{feff}');
    let start = row
        .position()
        .map_or(0, |position| position.byte() as usize);
    let blank = text[start..].len() - text[start..].trim_start_matches(['\r', '\n']).len();
    1 + text[..start + blank].matches('\n').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> String {
        parse(text.into(), &["r"]).err().unwrap_or_default()
    }

    #[test]
    fn columns_are_found_by_name() {
        let text = "name, phi_o ,theta_i,phi_i,theta_o\n\"a,b\",0,90,0,0\n\nc, 180 ,0,0,9e1\n";
        let directions = parse(text.into(), &["r"]).expect("is good");
        let mut rows = Vec::new();
        let kept = directions.for_each(|row, wi, wo| {
            rows.push((row.clone(), wi, wo));
            Ok::<(), ()>(())
        });
        assert_eq!(kept, Ok(()));
        assert_eq!(directions.columns, [2, 3, 4, 1]);
        assert_eq!(rows.len(), 2);
        let (row, wi, wo) = &rows[0];
        assert_eq!(&row[0], "a,b");
        assert!((*wi - DVec3::X).length() < 1e-15 && *wo == DVec3::Z);
        assert!((rows[1].2 + DVec3::X).length() < 1e-15);
    }

    #[test]
    fn what_is_wrong_is_named_by_line_and_column() {
        const HEADER: &str = "theta_i,phi_i,theta_o,phi_o\n";
        assert!(said("").contains("empty"));
        assert!(said("theta_i,phi_i,theta_o\n").contains("no column phi_o"));
        assert!(said("theta_i,phi_i,theta_o,phi_o,phi_o\n").contains("two columns phi_o"));
        assert!(said("theta_i,phi_i,theta_o,phi_o,r\n").contains("column r already"));
        let bad = said(&format!("{HEADER}1,2,3,4\n1,2,x,4\n"));
        assert!(bad.starts_with("line 3, column theta_o: \"x\""), "{bad}");
        let bad = said(&format!("{HEADER}1,2,3,4\r\n\r\n\r\n1,2,3,\r\n"));
        assert!(bad.starts_with("line 5, column phi_o: \"\""), "{bad}");
        assert!(said(&format!("{HEADER}1,inf,3,4")).starts_with("line 2, column phi_i"));
        assert!(said(&format!("{HEADER}1,2,3,4\n1,2,3")).starts_with("line 3: the row has 3"));
        assert!(said(&format!("{HEADER}1,2,3,4,5")).starts_with("line 2: the row has 5"));
        let quoted = format!("{HEADER}1,2,3,4\n\"1\",\"\n\",3,4\n");
        assert!(said(&quoted).starts_with("line 3, column phi_i: \"\\n\""));
    }
}
