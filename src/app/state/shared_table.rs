//! Tables that are told apart by where they are in memory.

use crate::measured::Table;
use std::fmt;
use std::sync::Arc;

/// A table that is equal to another only where both are the same one in memory.
#[derive(Clone)]
pub struct SharedTable(pub Arc<Table>);

impl PartialEq for SharedTable {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for SharedTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SharedTable({} valid)", self.0.valid_count())
    }
}
