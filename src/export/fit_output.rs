//! Fit output of panels: landscapes and error maps.

use super::error::ExportError;
use crate::brdf::Fresnel;
use crate::figure::ViewSpec;
use crate::figure::error_map::{ErrorMapSpec, Plane};
use crate::figure::faults::Faults;
use crate::figure::fit_output::FitOutput;
use crate::figure::heatmap::HeatView;
use crate::figure::landscape::{LandscapePanel, Terrain};
use crate::figure::subject::{Source, Subject};
use crate::fit::error_map::{Bin, DIRECTION_BINS, ErrorMap, error_map};
use crate::fit::landscape::{self, Eta, Landscape, landscape};
use crate::fit::{Problem, ProblemError, WEIGHTS, Weight};
use crate::keys;
use crate::measured::Table;
use crate::measured::grid::THETA_H_BINS;
use std::ops::ControlFlow;

/// Brings the weight of the cells, where a view has one, to one that there is.
pub(super) fn sanitize(view: &mut ViewSpec, faults: &mut Faults) {
    let view_key = view.key();
    let (ViewSpec::Landscape(LandscapePanel { weight, .. })
    | ViewSpec::ErrorMap(ErrorMapSpec { weight, .. })) = view
    else {
        return;
    };
    if Weight::by_key(weight).is_none() {
        let keys = WEIGHTS.map(Weight::key);
        let proposal = keys::did_you_mean(weight, keys);
        let expected = format!("one of {}{proposal}", keys.join(", "));
        faults.inside(view_key, |faults| {
            faults.add("weight", format_args!("{weight:?}"), expected);
        });
        *weight = Weight::default().key().into();
    }
}

/// The view without what does not change its fit output; `None` where it shows none.
pub(super) fn wanted(view: &ViewSpec) -> Option<ViewSpec> {
    match view {
        ViewSpec::Landscape(spec) => Some(ViewSpec::Landscape(LandscapePanel {
            path: Vec::new(),
            here: None,
            view: HeatView::default(),
            ..spec.clone()
        })),
        ViewSpec::ErrorMap(spec) => Some(ViewSpec::ErrorMap(ErrorMapSpec {
            scale: ErrorMapSpec::default().scale,
            view: HeatView::default(),
            ..spec.clone()
        })),
        _ => None,
    }
}

/// Fit output that a panel of these subjects shows and cannot compute itself.
///
/// # Errors
/// One sentence where the panel lacks data or a model, or a key is unknown.
pub(super) fn of_panel(
    view: &ViewSpec,
    subjects: &[&Subject],
    follow: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Option<FitOutput>, ExportError> {
    match view {
        ViewSpec::Landscape(spec) => of_landscape(spec, data(subjects, view)?, follow).map(Some),
        ViewSpec::ErrorMap(spec) => of_error_map(spec, subjects, view).map(Some),
        _ => Ok(None),
    }
}

fn of_landscape(
    spec: &LandscapePanel,
    table: &Table,
    follow: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<FitOutput, ExportError> {
    let fresnel = spec.fresnel;
    let eta = match (fresnel, spec.eta) {
        (Fresnel::None, _) => Eta::Fixed(1.0),
        (_, Some(eta)) => Eta::Fixed(eta),
        (_, None) => Eta::Optimised,
    };
    let problem = Problem::new(table, weight(&spec.weight), spec.limit).map_err(no_problem)?;
    let made = landscape(&problem, fresnel, eta, &mut |_| follow()).ok_or(ExportError::Stopped)?;
    let best = made
        .best
        .map(|(brdf, error)| (landscape::place(&brdf), 100.0 * error));
    Ok(FitOutput::Landscape {
        terrain: terrain(&made),
        best,
    })
}

fn of_error_map(
    spec: &ErrorMapSpec,
    subjects: &[&Subject],
    view: &ViewSpec,
) -> Result<FitOutput, ExportError> {
    let table = data(subjects, view)?;
    let model = subjects.iter().find_map(|subject| match &subject.source {
        Source::Model(brdf) => Some(brdf),
        _ => None,
    });
    let model = model.ok_or_else(|| {
        ExportError::Other("an error map needs a model; add one to the panel's subjects".into())
    })?;
    let map = error_map(table, weight(&spec.weight), spec.limit, model).map_err(no_problem)?;
    let (bins, columns) = bins(spec.plane, &map);
    Ok(FitOutput::ErrorMap {
        parts: bins.iter().map(|bin| bin.map(|bin| bin.error)).collect(),
        columns,
        total: map.total,
        channels: map.channels,
    })
}

fn data<'a>(subjects: &[&'a Subject], view: &ViewSpec) -> Result<&'a Table, ExportError> {
    let mut tables = subjects.iter().filter_map(|subject| match &subject.source {
        Source::Measured(table, _) => Some(&**table),
        _ => None,
    });
    tables.next().ok_or_else(|| {
        ExportError::Other(format!(
            "the view {} needs a measured material; add one to the panel's subjects",
            view.key()
        ))
    })
}

/// The weight of a view that is sanitized.
fn weight(key: &str) -> Weight {
    Weight::by_key(key).unwrap_or_default()
}

fn no_problem(error: ProblemError) -> ExportError {
    ExportError::Other(error.to_string())
}

/// E of a landscape in percent.
pub fn terrain(landscape: &Landscape) -> Terrain {
    Terrain {
        s: landscape.s.clone(),
        alpha: landscape.alpha.clone(),
        percent: landscape
            .nodes
            .iter()
            .map(|node| 100.0 * node.error)
            .collect(),
    }
}

/// The bins of an error map in rows from the smallest angle upwards, and how many are in a row.
pub fn bins(plane: Plane, map: &ErrorMap) -> (Vec<Option<Bin>>, usize) {
    match plane {
        Plane::Directions => {
            // No light was measured there.
            let bins = map.directions.iter();
            let known =
                bins.map(|bin| Some(*bin).filter(|bin| bin.energy > 0.0 || bin.error > 0.0));
            (known.collect(), DIRECTION_BINS)
        }
        Plane::HalfDiff => (map.half_diff.clone(), THETA_H_BINS),
    }
}
