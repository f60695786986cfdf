//! Reader and writer of the MERL file format [Matusik03], on streams of bytes.
//!
//! Three little-endian int32 (bins of θ_h, θ_d, φ_d: 90, 90, and 180 or 360), then the planes R, G, B of little-endian
//! float64 in the order of [`Grid::index`]. f_r = stored × (1, 1.15, 1.66)/1500 in 1/sr.

use super::grid::{Grid, PHI_D_BINS_FOLDED, PHI_D_BINS_FULL, THETA_D_BINS, THETA_H_BINS};
use super::table::Table;
use crate::encoding::{WIDE, is_wide};
use std::io::{self, ErrorKind, Read, Write};
use std::ops::ControlFlow;

/// f_r in 1/sr per stored unit, by channel: (1, 1.15, 1.66)/1500.
pub const SCALE: [f64; 3] = [1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0];

/// Stored value in each channel of an invalid cell.
const INVALID: f64 = -1.0;

const HEADER_BYTES: usize = 12;
/// Buffer size in bytes: small enough to stay in the cache between reading and converting; a multiple of 8.
const CHUNK_BYTES: usize = 64 * 1024;

/// Error of bytes that are no usable MERL file: one sentence, without the path, which the caller puts last.
#[derive(Debug, thiserror::Error)]
pub enum MerlError {
    /// The file has no bytes.
    #[error(
        "the file is empty; a MERL file has {} bytes",
        grouped(byte_count(Grid::FOLDED))
    )]
    Empty,
    /// The file is of another kind; the text says which.
    #[error(
        "not a MERL file: {0}; expected a header with 90 × 90 × 180 bins and {bytes} bytes",
        bytes = grouped(byte_count(Grid::FOLDED))
    )]
    NotMerl(&'static str),
    /// Header with other bins than 90 × 90 × 180 or 360, as found.
    #[error(
        "not a MERL file: its header says {} × {} × {} bins; expected 90 × 90 × 180 or 90 × 90 × 360",
        .0[0], .0[1], .0[2]
    )]
    WrongGrid([i32; 3]),
    /// The file has fewer bytes than the header implies.
    #[error(
        "the file is truncated: it has {} bytes, expected {}; copy or download it again",
        grouped(*found), grouped(*expected)
    )]
    Truncated {
        /// Number of bytes in the file.
        found: u64,
        /// Number of bytes that the header implies.
        expected: u64,
    },
    /// The file has more bytes than the header implies.
    #[error(
        "the file is too long: it has {} bytes, expected {}; copy or download it again",
        grouped(*found), grouped(*expected)
    )]
    TooLong {
        /// Number of bytes in the file, as far as read.
        found: u64,
        /// Number of bytes that the header implies.
        expected: u64,
    },
    /// Every cell is negative or not finite in some channel; the number of cells.
    #[error("nothing was measured: all {} cells are invalid; expected some that are not", grouped(*.0 as u64))]
    AllInvalid(usize),
    /// Error of the reader.
    #[error("reading failed: {0}")]
    Io(#[from] io::Error),
    /// `progress` stopped the reading.
    #[error("reading was cancelled")]
    Cancelled,
}

/// Reads a table of `len` bytes. `progress` gets the share read, in [0, 1], about a thousand times, and may stop it.
///
/// The header and `len` are checked before any data are read or memory is taken. A cell with a negative or
/// non-finite channel becomes invalid, also where the number is too large for f32.
///
/// # Errors
/// Each of [`MerlError`]; a reader that ends before `len` is truncated, one that goes on after it too long.
pub fn read(
    mut reader: impl Read,
    len: u64,
    progress: &mut dyn FnMut(f32) -> ControlFlow<()>,
) -> Result<Table, MerlError> {
    let grid = read_header(&mut reader, len)?;
    let expected = byte_count(grid);
    let mut cells = vec![[0.0_f32; 3]; grid.len()];
    let mut buffer = vec![0; CHUNK_BYTES];
    let mut done = HEADER_BYTES as u64;
    for (channel, scale) in SCALE.into_iter().enumerate() {
        for cells in cells.chunks_mut(CHUNK_BYTES / 8) {
            let bytes = &mut buffer[..8 * cells.len()];
            let found = read_fully(&mut reader, bytes)?;
            done += found as u64;
            if found < bytes.len() {
                return Err(MerlError::Truncated {
                    found: done,
                    expected,
                });
            }
            for (cell, stored) in cells.iter_mut().zip(bytes.as_chunks::<8>().0) {
                let stored = f64::from_le_bytes(*stored);
                // The test is on the f64: a negative number too small for f32 would become a valid −0.
                cell[channel] = if stored >= 0.0 {
                    (stored * scale) as f32
                } else {
                    f32::NAN
                };
            }
            if progress(done as f32 / expected as f32).is_break() {
                return Err(MerlError::Cancelled);
            }
        }
    }
    if read_fully(&mut reader, &mut [0])? > 0 {
        return Err(MerlError::TooLong {
            found: expected + 1,
            expected,
        });
    }
    let table = Table::new(grid, cells);
    if table.valid_count() == 0 {
        return Err(MerlError::AllInvalid(grid.len()));
    }
    Ok(table)
}

/// Writes a table in the MERL format; an invalid cell is −1 in each channel. Reading it again gives the same table.
///
/// # Errors
/// Errors of the writer.
pub fn write(table: &Table, mut writer: impl Write) -> io::Result<()> {
    for bins in [THETA_H_BINS, THETA_D_BINS, table.grid().phi_d_bins()] {
        writer.write_all(&(bins as i32).to_le_bytes())?;
    }
    let mut bytes = Vec::with_capacity(CHUNK_BYTES);
    for (channel, scale) in SCALE.into_iter().enumerate() {
        for cells in table.cells().chunks(CHUNK_BYTES / 8) {
            bytes.clear();
            for cell in cells {
                let f_r = f64::from(cell[channel]);
                let stored = if f_r.is_nan() { INVALID } else { f_r / scale };
                bytes.extend_from_slice(&stored.to_le_bytes());
            }
            writer.write_all(&bytes)?;
        }
    }
    writer.flush()
}

/// Size in bytes of a file with this grid.
pub fn byte_count(grid: Grid) -> u64 {
    (HEADER_BYTES + 3 * 8 * grid.len()) as u64
}

/// Reads the header and checks its three dimensions and the file length: all that can be checked without the data.
///
/// # Errors
/// Errors of [`read`], less those that only the data show.
pub fn read_header(reader: &mut impl Read, len: u64) -> Result<Grid, MerlError> {
    let mut header = [0; HEADER_BYTES];
    let found = read_fully(reader, &mut header)?;
    if found == 0 {
        return Err(MerlError::Empty);
    }
    if let Some(what) = known_format(&header[..found]) {
        return Err(MerlError::NotMerl(what));
    }
    if found < HEADER_BYTES {
        return Err(MerlError::NotMerl("it is shorter than a header"));
    }
    let bins = std::array::from_fn(|k| {
        i32::from_le_bytes(std::array::from_fn(|byte| header[4 * k + byte]))
    });
    // One by one: the product of nonsense may well be right, or overflow.
    let grid = match bins.map(|n| usize::try_from(n).unwrap_or(0)) {
        [THETA_H_BINS, THETA_D_BINS, PHI_D_BINS_FOLDED] => Grid::FOLDED,
        [THETA_H_BINS, THETA_D_BINS, PHI_D_BINS_FULL] => Grid::FULL,
        _ => return Err(MerlError::WrongGrid(bins)),
    };
    let expected = byte_count(grid);
    match len.cmp(&expected) {
        std::cmp::Ordering::Less => Err(MerlError::Truncated {
            found: len,
            expected,
        }),
        std::cmp::Ordering::Greater => Err(MerlError::TooLong {
            found: len,
            expected,
        }),
        std::cmp::Ordering::Equal => Ok(grid),
    }
}

/// Description of a usual file format that starts with these bytes; `None` for bytes that may be a MERL header.
fn known_format(start: &[u8]) -> Option<&'static str> {
    const KNOWN: [(&[u8], &str); 8] = [
        (b"\x89PNG", "it is a PNG image"),
        (b"\xff\xd8\xff", "it is a JPEG image"),
        (b"\x76\x2f\x31\x01", "it is an OpenEXR image"),
        (b"\x1f\x8b", "it is compressed by gzip; unpack it first"),
        (b"PK\x03\x04", "it is a zip archive; unpack it first"),
        (b"%PDF", "it is a PDF document"),
        (b"\x93NUMPY", "it is a NumPy array"),
        (b"tensor_f", "it is a tensor file of the RGL database"),
    ];
    let known = KNOWN
        .iter()
        .find_map(|(magic, what)| start.starts_with(magic).then_some(*what));
    // A header always holds zero bytes, text never does.
    let text = || !start.iter().any(|byte| *byte < 9 || *byte == 0x7f);
    let wide = || is_wide(start).then_some(WIDE);
    known
        .or_else(wide)
        .or_else(|| text().then_some("it is a text"))
}

/// Fills the buffer as far as the reader goes; returns the number of bytes read.
fn read_fully(reader: &mut impl Read, buffer: &mut [u8]) -> io::Result<usize> {
    let mut filled = 0;
    while filled < buffer.len() {
        match reader.read(&mut buffer[filled..]) {
            Ok(0) => break,
            Ok(count) => filled += count,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(filled)
}

/// Decimal digits of a whole number with commas between thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests;
