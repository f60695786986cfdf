//! The rows of the table: kept fits and the run under way, ordered.

use crate::app::state::State;
use crate::app::state::fitting::kept::KeptFit;
use crate::app::state::fitting::run::{FitRun, Part};
use crate::app::state::fitting::table::{Column, FitTable};
use crate::brdf::Brdf;
use crate::fit::Variant;

/// A row.
pub struct FitRow<'a> {
    /// Model and Fresnel factor that were or are fitted.
    pub variant: Variant,
    /// The fit that is kept, if one is.
    pub kept: Option<&'a KeptFit>,
    /// The numbers shown.
    pub brdf: Option<Brdf>,
    /// E over all cells.
    pub error: Option<f64>,
    /// E over the grazing cells.
    pub grazing: Option<f64>,
    /// Duration in seconds.
    pub seconds: Option<f64>,
    /// Remark beside its name.
    pub mark: RowRemark,
    /// Whether the sliders stand where it ended.
    pub shown: bool,
}

/// Remark on a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowRemark {
    /// No remark.
    None,
    /// The smallest E of those that were asked the same.
    Best,
    /// Being fitted.
    Fitting,
    /// Yet to be fitted.
    Waiting,
    /// Made with other settings than those set now.
    Stale,
    /// Stopped before its end.
    Cancelled,
}

impl RowRemark {
    /// Word of the remark.
    pub fn text(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Best => Some("best"),
            Self::Fitting => Some("fitting"),
            Self::Waiting => Some("waiting"),
            Self::Stale => Some("other settings"),
            Self::Cancelled => Some("cancelled"),
        }
    }
}

/// The rows of the shown material, in order.
pub fn rows(state: &State) -> Vec<FitRow<'_>> {
    let Some((material, opened)) = state.current() else {
        return Vec::new();
    };
    let mut rows: Vec<FitRow> = material
        .fits
        .iter()
        .map(|kept| of_kept(state, kept, &opened.brdf))
        .collect();
    if let Some(run) = state.current_run() {
        for (position, part) in run.parts.iter().enumerate() {
            let row = of_part(run, position, part);
            match rows.iter_mut().find(|other| other.variant == part.variant) {
                Some(other) if row.error.is_none() => other.mark = row.mark,
                Some(other) => {
                    *other = FitRow {
                        kept: other.kept,
                        ..row
                    };
                }
                None => rows.push(row),
            }
        }
    }
    mark_best(&mut rows);
    let by_name = |row: &FitRow| (row.variant.fresnel.index(), row.variant.model.index());
    rows.sort_by_key(by_name);
    sort(&mut rows, &state.fit.table);
    rows
}

/// Number of a row in a column; `None` where it has none.
pub fn value(row: &FitRow, column: Column) -> Option<f64> {
    let outcome = row.kept.map(|kept| &kept.outcome);
    match column {
        Column::Name => None,
        Column::Error => row.error,
        Column::Grazing => row.grazing,
        Column::Channel(channel) => outcome?.errors.channels.get(channel).copied(),
        Column::Param(id) => row.brdf.filter(|brdf| brdf.uses(id))?.number(id),
        Column::Evaluations => outcome.map(|outcome| outcome.evaluations as f64),
        Column::Time => row.seconds,
    }
}

/// Orders rows that are in the order of their names. Those without a value come last in either direction.
fn sort(rows: &mut [FitRow], table: &FitTable) {
    if table.sort == Column::Name {
        if table.descending {
            rows.reverse();
        }
        return;
    }
    let of = |row: &FitRow| value(row, table.sort);
    rows.sort_by(|a, b| match (of(a), of(b)) {
        (Some(a), Some(b)) if table.descending => b.total_cmp(&a),
        (Some(a), Some(b)) => a.total_cmp(&b),
        (a, b) => b.is_some().cmp(&a.is_some()),
    });
}

fn of_kept<'a>(state: &State, kept: &'a KeptFit, shown: &Brdf) -> FitRow<'a> {
    let outcome = &kept.outcome;
    FitRow {
        variant: kept.variant(),
        kept: Some(kept),
        brdf: Some(outcome.brdf),
        error: Some(outcome.errors.total),
        grazing: outcome.errors.grazing,
        seconds: kept.seconds,
        mark: if state.is_stale(kept) {
            RowRemark::Stale
        } else if kept.is_cancelled() {
            RowRemark::Cancelled
        } else {
            RowRemark::None
        },
        shown: outcome.brdf == *shown,
    }
}

fn of_part<'a>(run: &FitRun, position: usize, part: &Part) -> FitRow<'a> {
    let best = part.best();
    FitRow {
        variant: part.variant,
        kept: None,
        brdf: best.map(|best| best.brdf),
        error: best.map(|best| best.error),
        grazing: None,
        seconds: None,
        mark: if position == run.at && !run.stopping {
            RowRemark::Fitting
        } else if best.is_some() || run.stopping {
            RowRemark::None
        } else {
            RowRemark::Waiting
        },
        shown: false,
    }
}

/// The best of those that were asked the same; of one alone it says nothing.
fn mark_best(rows: &mut [FitRow]) {
    let mut comparable: Vec<&mut FitRow> = rows
        .iter_mut()
        .filter(|row| row.kept.is_some() && row.mark == RowRemark::None && row.error.is_some())
        .collect();
    if comparable.len() < 2 {
        return;
    }
    comparable.sort_by(|a, b| a.error.unwrap_or(1e9).total_cmp(&b.error.unwrap_or(1e9)));
    if let Some(best) = comparable.first_mut() {
        best.mark = RowRemark::Best;
    }
}
