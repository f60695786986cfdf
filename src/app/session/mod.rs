//! Sessions: what is open as a file, and back; what is kept for the case that the program ends unexpectedly.
//!
//! ```text
//! State ── write.rs ──▶ SessionFile (file.rs) ── text ──▶ study.grazing.json, or a file in the autosave folder
//! text ── read.rs, sanitize.rs ──▶ SessionFile ── places.rs: which files are there ──▶ FoundSession ── reduce/open_session.rs ──▶ State
//! ```
//!
//! Opening is one edit of the scene: its materials are in it at once, and their data come one by one through the jobs
//! that bring back what was let go ([`crate::app::state::memory`]). One that is not found stays without its data and is
//! asked for; what lies over it is kept, and is saved again.
//!
//! The session file that a scene belongs to is a number in the scene, so that undo brings the name back with it.

pub mod differences;
pub mod file;
pub mod places;
pub mod read;
pub mod sanitize;
#[cfg(test)]
mod tests;
pub mod write;
