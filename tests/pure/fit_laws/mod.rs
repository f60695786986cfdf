//! The laws of the fit, on its public face alone: what must hold whatever way it searches.
//!
//! Where a law compares, a planted error shows that the comparison can fail. Tables are thinned at random where all
//! cells would only cost time.

mod amplitudes;
mod errors;
mod invariance;
mod making;
mod odd;
mod recovery;
mod reference;
mod stages;
