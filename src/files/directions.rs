//! A CSV of direction pairs: its columns found by name, its other columns kept.

use crate::files::FileError;
use crate::geom::direction;
use csv::StringRecord;
use glam::DVec3;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The columns that make a direction pair, in degrees.
pub const ANGLES: [&str; 4] = ["theta_i", "phi_i", "theta_o", "phi_o"];

/// A CSV of direction pairs.
pub struct Directions {
    /// Names of all columns.
    pub header: StringRecord,
    /// All rows as they were written, with wi and wo.
    pub rows: Vec<(StringRecord, DVec3, DVec3)>,
    /// The columns of [`ANGLES`].
    pub columns: [usize; 4],
}

/// Reads a file, or standard input for `-`. `added` are the columns that will be added: they must not be there yet.
pub fn read(path: &Path, added: &[&str]) -> Result<Directions, FileError> {
    let (path, bytes) = if path == Path::new("-") {
        let path = Path::new("standard input");
        let mut bytes = Vec::new();
        let read = io::stdin().lock().read_to_end(&mut bytes);
        (path, read.map(|_| bytes))
    } else if path.is_dir() {
        return Err(FileError::new(
            path,
            "this is a directory; expected a CSV file",
        ));
    } else {
        (path, fs::read(path))
    };
    let bytes = bytes.map_err(|error| FileError::io(path, "cannot read the file", &error))?;
    let text = std::str::from_utf8(&bytes)
        .map_err(|_| FileError::new(path, "not a CSV file: it is no UTF-8 text"))?;
    parse(text.trim_start_matches('\u{feff}'), added).map_err(|what| FileError::new(path, what))
}

/// A turn: what is more is a slip, radians times something, or a mark for a missing value.
const MAX_DEGREES: f64 = 360.0;

fn parse(text: &str, added: &[&str]) -> Result<Directions, String> {
    let expected = ANGLES.join(",");
    let mut reader = csv::ReaderBuilder::new()
        .flexible(true)
        .from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| error.to_string())?.clone();
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
    let titles: Vec<&str> = header.iter().map(str::trim).collect();
    let twice =
        (1..titles.len()).find(|k| !titles[*k].is_empty() && titles[..*k].contains(&titles[*k]));
    if let Some(k) = twice {
        return Err(format!("line 1: there are two columns {}", titles[k]));
    }
    let mut rows = Vec::new();
    for row in reader.records() {
        let row = row.map_err(|error| error.to_string())?;
        let line = || line_of(text, &row);
        if row.len() != header.len() {
            return Err(format!(
                "line {}: the row has {} columns; expected {}",
                line(),
                row.len(),
                header.len()
            ));
        }
        let mut radians = [0.0; 4];
        for ((radians, column), name) in radians.iter_mut().zip(columns).zip(ANGLES) {
            let number = row[column]
                .trim()
                .parse::<f64>()
                .ok()
                .filter(|x| x.is_finite());
            if number.is_some_and(|degrees| degrees.abs() > MAX_DEGREES) {
                return Err(format!(
                    "line {}, column {name}: {} is out of range; expected −{MAX_DEGREES} to {MAX_DEGREES} degrees",
                    line(),
                    &row[column]
                ));
            }
            let Some(degrees) = number else {
                return Err(format!(
                    "line {}, column {name}: {:?} is no number; expected an angle in degrees",
                    line(),
                    &row[column]
                ));
            };
            *radians = degrees.to_radians();
        }
        let [theta_i, phi_i, theta_o, phi_o] = radians;
        let (wi, wo) = (direction(theta_i, phi_i), direction(theta_o, phi_o));
        rows.push((row, wi, wo));
    }
    Ok(Directions {
        header,
        rows,
        columns,
    })
}

/// The line at which a row starts. The reader counts blank lines before a row to the row.
fn line_of(text: &str, row: &StringRecord) -> usize {
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
        parse(text, &["r"]).err().unwrap_or_default()
    }

    #[test]
    fn columns_are_found_by_name() {
        let text = "name, phi_o ,theta_i,phi_i,theta_o\n\"a,b\",0,90,0,0\n\nc, 180 ,0,0,9e1\n";
        let directions = parse(text, &["r"]).expect("is good");
        assert_eq!(directions.columns, [2, 3, 4, 1]);
        assert_eq!(directions.rows.len(), 2);
        let (row, wi, wo) = &directions.rows[0];
        assert_eq!(&row[0], "a,b");
        assert!((*wi - DVec3::X).length() < 1e-15 && *wo == DVec3::Z);
        assert!((directions.rows[1].2 + DVec3::X).length() < 1e-15);
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
