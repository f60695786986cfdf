use super::*;
use crate::measured::Grid;

/// Bytes of a MERL file: dimensions, then each plane filled with one number.
fn file(bins: [i32; 3], cells: usize, planes: [f64; 3]) -> Vec<u8> {
    let mut bytes: Vec<u8> = bins.iter().flat_map(|n| n.to_le_bytes()).collect();
    for stored in planes {
        bytes.extend(std::iter::repeat_n(stored.to_le_bytes(), cells).flatten());
    }
    bytes
}

/// Overwrites the stored value of a channel in a cell of a folded file.
fn plant(bytes: &mut [u8], channel: usize, cell: usize, stored: f64) {
    let at = 12 + 8 * (channel * 1_458_000 + cell);
    bytes[at..at + 8].copy_from_slice(&stored.to_le_bytes());
}

fn read_bytes(bytes: &[u8]) -> Result<Table, MerlError> {
    read(
        bytes,
        bytes.len() as u64,
        &mut |_| ControlFlow::Continue(()),
    )
}

fn said(bytes: &[u8]) -> String {
    read_bytes(bytes).expect_err("is wrong").to_string()
}

#[test]
fn the_constants_and_the_order_are_those_of_the_format() {
    let mut bytes = file([90, 90, 180], 1_458_000, [1500.0; 3]);
    assert_eq!(bytes.len(), 34_992_012);
    // Bins θ_h = 2, θ_d = 3, φ_d = 4.
    plant(&mut bytes, 1, 4 + 180 * (3 + 90 * 2), 3000.0);
    let table = read_bytes(&bytes).expect("a good file");
    assert_eq!(table.grid(), Grid::FOLDED);
    assert_eq!(table.valid_count(), 1_458_000);
    assert_eq!(table.cells()[0], [1.0, 1.15, 1.66]);
    assert_eq!(table.cells()[Grid::FOLDED.index(2, 3, 4)], [1.0, 2.3, 1.66]);
    let others = table.cells().iter().filter(|cell| cell[1] != 1.15).count();
    assert_eq!(others, 1, "the planted number is in one cell only");
}

#[test]
fn files_with_the_whole_turn_are_read() {
    let bytes = file([90, 90, 360], 2_916_000, [1.0, 2.0, 3.0]);
    assert_eq!(bytes.len(), 69_984_012);
    let table = read_bytes(&bytes).expect("a good file");
    assert_eq!(table.grid(), Grid::FULL);
    assert_eq!(table.valid_count(), 2_916_000);
}

#[test]
fn negative_and_non_finite_channels_make_a_cell_invalid() {
    let mut bytes = file([90, 90, 180], 1_458_000, [0.0, 1.0, 2.0]);
    let bad = [
        -1.0,
        -1e-300,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e300,
    ];
    for (k, stored) in bad.into_iter().enumerate() {
        for channel in 0..3 {
            plant(&mut bytes, channel, 3 * k + channel, stored);
        }
    }
    let table = read_bytes(&bytes).expect("a good file");
    assert_eq!(table.valid_count(), 1_458_000 - 3 * bad.len());
    assert!((0..3 * bad.len()).all(|cell| table.cell(cell).is_none()));
    assert!(table.cell(3 * bad.len()).is_some());
}

#[test]
fn writing_and_reading_gives_the_same_table() {
    let cells = (0..Grid::FOLDED.len())
        .map(|k| {
            let x = k as f32;
            [
                x * 1e-3,
                1.0 / (1.0 + x),
                if k % 7 == 0 { -1.0 } else { x * x },
            ]
        })
        .collect();
    let table = Table::new(Grid::FOLDED, cells);
    let mut bytes = Vec::new();
    write(&table, &mut bytes).expect("memory takes it");
    let back = read_bytes(&bytes).expect("a good file");
    let bits = |table: &Table| -> Vec<[u32; 3]> {
        table
            .cells()
            .iter()
            .map(|cell| cell.map(f32::to_bits))
            .collect()
    };
    assert_eq!(bits(&back), bits(&table));
    let stored =
        |cell: usize| f64::from_le_bytes(std::array::from_fn(|byte| bytes[12 + 8 * cell + byte]));
    assert_eq!(stored(0), -1.0, "an invalid cell is −1");
    assert!((stored(1000) - 1500.0).abs() < 1e-4);
}

#[test]
fn wrong_bytes_are_named() {
    assert!(said(b"").starts_with("the file is empty"));
    assert!(said(b"\x89PNG\r\n\x1a\n0000").contains("PNG"));
    assert!(said(b"theta_i,phi_i,theta_o,phi_o").contains("text"));
    assert!(said(&[90, 0, 0]).contains("shorter than a header"));
    let header = |bins| file(bins, 0, [0.0; 3]);
    assert!(said(&header([45, 90, 180])).contains("45 × 90 × 180"));
    // The right product with the wrong factors, and one that overflows.
    assert!(said(&header([180, 90, 90])).contains("180 × 90 × 90"));
    assert!(said(&header([i32::MAX; 3])).contains("2147483647 × 2147483647"));
    assert!(said(&header([-90, -90, 180])).contains("-90 × -90 × 180"));
    assert!(said(&header([90, 90, 180])).contains("it has 12 bytes, expected 34,992,012"));
    let invalid = file([90, 90, 180], 1_458_000, [-1.0, 0.0, 0.0]);
    assert!(said(&invalid).contains("all 1,458,000 cells are invalid"));
}

#[test]
fn a_length_that_lies_is_found_out() {
    let mut bytes = file([90, 90, 180], 1_458_000, [1.0; 3]);
    let go_on = &mut |_: f32| ControlFlow::Continue(());
    let short = read(&bytes[..30_000_000], bytes.len() as u64, go_on);
    assert!(matches!(
        short,
        Err(MerlError::Truncated {
            found: 30_000_000,
            expected: 34_992_012
        })
    ));
    bytes.push(0);
    let long = read(&bytes[..], 34_992_012, go_on);
    assert!(matches!(long, Err(MerlError::TooLong { .. })));
    assert!(said(&bytes).contains("too long: it has 34,992,013 bytes"));
}

#[test]
fn progress_rises_to_one_and_may_stop() {
    let bytes = file([90, 90, 180], 1_458_000, [1.0; 3]);
    let mut shares = Vec::new();
    let mut collect = |share| {
        shares.push(share);
        ControlFlow::Continue(())
    };
    read(&bytes[..], bytes.len() as u64, &mut collect).expect("a good file");
    assert!(shares.is_sorted() && shares.len() > 100);
    assert_eq!(shares.last(), Some(&1.0));
    let stopped = read(&bytes[..], bytes.len() as u64, &mut |share| {
        if share > 0.5 {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    });
    assert!(matches!(stopped, Err(MerlError::Cancelled)));
}
