//! Measured files.

use super::tables::table;
use grazing::geom::{Cosines, Rgb};
use grazing::measured::{Grid, merl};

/// The bytes of a MERL file of what a closure says of the cosines above the horizon; `None` is unmeasured.
pub fn merl_file(f_r: impl Fn(&Cosines) -> Option<Rgb>) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(34_992_012);
    let table = table(Grid::FOLDED, |_, cosines| f_r(cosines));
    merl::write(&table, &mut bytes).expect("memory takes it");
    bytes
}
