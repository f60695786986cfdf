//! Figures for papers out of the window: what is on one, how it looks, and the jobs that preview, write and copy it.

pub mod figure;
pub mod work;
