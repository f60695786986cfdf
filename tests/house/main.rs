//! The house itself: its source and its README, read as text.

mod readme;
mod tidy;
