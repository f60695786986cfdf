//! The identity of a view. [`crate::app::state::views`] has their rows.

use serde::{Deserialize, Serialize};

/// Identity of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the rows below say what each one is")]
pub enum ViewId {
    Sphere,
    Fits,
    Landscape,
    Scatter,
    Ranking,
    Lobes,
    Slices,
    Albedo,
    Lobe3d,
    Image,
    Disc,
    ErrorMap,
}
