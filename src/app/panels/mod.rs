//! The parts around the tiles. Each reads the state and pushes messages.

pub mod dialogs;
pub mod library;
pub mod menu;
pub mod model;
pub mod notices;
pub mod status;
