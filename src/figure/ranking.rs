//! E of several models over many materials: a curve for each model, the materials in the order of one model's E, as [Ngan05]
//! and [Low12] compare models.

mod order;
mod panel;
mod plot;
mod spec;

pub use order::{RankedRow, Ranking};
pub use plot::RankingPlot;
pub use spec::{ModelKey, RANKING_PARTS, RankedFit, RankedMaterial, RankingPart, RankingSpec};
