//! Errors of a table that cannot be fitted.

/// Error of a table without anything to fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ProblemError {
    /// No cell is valid and within the grazing limit.
    #[error("no cell is measured within the grazing limit; raise the limit")]
    NoCells,
    /// Σ w f is 0.
    #[error("every measured value within the grazing limit is 0; there is nothing to fit")]
    Black,
}
