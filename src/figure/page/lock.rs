//! The same axis of values for all panels of a kind.

use super::panel_io::PanelDrawing;
use super::spec::{PageSpec, ViewSpec};
use super::style::SameAxes;
use crate::figure::image_slice::Shown;
use crate::figure::scale::{Axis, RadialScale};
use crate::figure::subject::Channel;

/// What two panels have in common whose values compare.
type Kind = (&'static str, RadialScale, bool, Channel);

fn kind(view: &ViewSpec) -> Option<Kind> {
    let name = view.key();
    match view {
        ViewSpec::Lobes(spec) => Some((name, spec.scale, spec.with_cosine, spec.channel)),
        ViewSpec::Slices(spec) => Some((name, spec.scale, spec.with_cosine, spec.channel)),
        ViewSpec::ImageSlice(spec) if matches!(spec.shown, Shown::Measured | Shown::Model) => {
            Some((name, spec.scale, spec.with_cosine, spec.channel))
        }
        ViewSpec::Albedo(spec) => Some((name, RadialScale::Linear, false, spec.channel)),
        _ => None,
    }
}

/// Where a view has its limits, if it can have any.
fn limits(view: &mut ViewSpec) -> Option<&mut Option<[f64; 2]>> {
    match view {
        ViewSpec::Lobes(spec) => Some(&mut spec.limits),
        ViewSpec::Slices(spec) => Some(&mut spec.limits),
        ViewSpec::ImageSlice(spec) => Some(&mut spec.limits),
        ViewSpec::Albedo(spec) => Some(&mut spec.limits),
        _ => None,
    }
}

/// Gives panels of a kind the limits that hold all of them; those that have limits keep theirs. `draw` draws a panel
/// by its number.
pub(super) fn lock(spec: &mut PageSpec, mut draw: impl FnMut(usize, &ViewSpec) -> PanelDrawing) {
    let in_rows = match spec.style.same_axes {
        SameAxes::Panel => return,
        SameAxes::Row => true,
        SameAxes::Figure => false,
    };
    let rows = || spec.rows.iter().enumerate();
    let panels = || rows().flat_map(|(row, spec)| spec.panels.iter().map(move |p| (row, p)));
    let mut groups: Vec<((Kind, usize), Vec<usize>)> = Vec::new();
    for (index, (row, panel)) in panels().enumerate() {
        let Some(kind) = kind(&panel.view) else {
            continue;
        };
        let key = (kind, if in_rows { row } else { 0 });
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, members)) => members.push(index),
            None => groups.push((key, vec![index])),
        }
    }
    groups.retain(|(_, members)| members.len() > 1);
    let views: Vec<ViewSpec> = panels().map(|(_, panel)| panel.view.clone()).collect();
    for (_, members) in groups {
        let axes: Vec<Axis> = members
            .iter()
            .filter_map(|member| draw(*member, &views[*member]).axis)
            .collect();
        let (low, high) = axes
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), axis| {
                (low.min(axis.floor), high.max(axis.limit))
            });
        if low > high {
            continue;
        }
        let mut panels = spec
            .rows
            .iter_mut()
            .flat_map(|row| &mut row.panels)
            .enumerate();
        for (index, panel) in &mut panels {
            if members.contains(&index)
                && let Some(limits) = limits(&mut panel.view)
                && limits.is_none()
            {
                *limits = Some([low, high]);
            }
        }
    }
}
