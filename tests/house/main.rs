//! The house itself: its source and its README, read as text.

mod links;
mod readme;
mod tidy;
