//! Fitting the models to a table by L1, as the poster does it [Nielsen14] and then all parameters together. Pure.
//!
//! ```text
//! Table ── Problem::new(weight, limit) ──▶ Problem        what is measured, arranged for passes over all cells
//! Problem + Variant + FitOptions ── fit ──▶ Outcome       parameters, errors, stages; watched and stopped by a closure
//! ```
//!
//! From the data up: [`symmetric_cells`] hold f_r as the SIMD [`kernels`] read it; [`regression`] and [`exact_l1`] find
//! ρ_d and k_s for a given lobe; [`objective`] is E as a function of the lobe's parameters, which [`descent`] lowers from
//! where [`multistart`] begins; [`staged_fit`] runs the stages, [`variants`] one model or several.
//!
//! Work is spread over the threads of the current rayon pool; results do not depend on their number.

mod amplitudes;
mod descent;
pub mod diagnostics;
mod error;
pub mod error_map;
mod exact_l1;
pub mod initial_guess;
mod kernels;
pub mod landscape;
mod linear;
mod lobes;
mod multistart;
mod objective;
pub mod options;
pub mod outcome;
pub mod problem;
mod regression;
mod simd;
mod staged_fit;
pub mod stages;
mod symmetric_cells;
mod threads;
mod variables;
mod variants;
mod vertex_walk;

pub use error::ProblemError;
pub use options::{FitOptions, Partial, Variant, WEIGHTS, Weight};
pub use outcome::{Concern, EndReason, Errors, FitProgress, Outcome, StageReport, Watch};
pub use problem::Problem;
pub use stages::{STAGES, Stage, StageSet};
pub use variants::{fit, fit_all};

#[cfg(test)]
mod tests;
