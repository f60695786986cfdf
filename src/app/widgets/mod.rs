//! Pieces of user interface that views and panels share: painting, controls, gestures.

pub mod compare;
pub mod controls;
pub mod empty;
pub mod fit_details;
pub mod formula;
pub mod heat;
pub mod legend;
pub mod paint;
pub mod probe;
pub mod toolbar;
pub mod zoom;
