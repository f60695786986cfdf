//! Fitting the models to a table. Pure.

pub mod start;
