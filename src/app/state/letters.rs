//! Letters for which fonts were looked for.

use std::collections::BTreeSet;

/// Letters that no font of the window had at first.
#[derive(Clone, Debug, Default)]
pub struct Letters {
    /// Those that a font was looked for, found or not.
    pub asked: BTreeSet<char>,
    /// Whether a notice has said that some have no font: it says so once.
    pub told: bool,
}
