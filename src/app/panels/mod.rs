//! The parts around the tiles. Each reads the state and pushes messages.

pub mod dialogs;
pub mod figure;
pub mod fit;
pub mod fit_result;
pub mod fit_stages;
pub mod guide;
pub mod lesson;
pub mod library;
pub mod menu;
pub mod model;
pub mod notices;
pub mod palette;
pub mod params;
pub mod session;
pub mod sides;
pub mod status;
pub mod tiles;
