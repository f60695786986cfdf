//! Shared axes of values: the same ends for all panels of a kind.

use super::spec::PageSpec;
use super::style::SameAxes;
use crate::figure::ViewSpec;
use crate::figure::panel::{PanelDrawing, SharedAxis};
use crate::figure::scale::Axis;

/// The panels that get one axis: a kind of view, what its axis shows, and the row where rows are apart.
type Group = (&'static str, SharedAxis, usize);

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
    let mut groups: Vec<(Group, Vec<usize>)> = Vec::new();
    for (index, (row, panel)) in panels().enumerate() {
        let Some(axis) = panel.view.panel().shared_axis() else {
            continue;
        };
        let key = (panel.view.key(), axis, if in_rows { row } else { 0 });
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
        let Some(axis) = axes.into_iter().reduce(Axis::around) else {
            continue;
        };
        let mut panels = spec
            .rows
            .iter_mut()
            .flat_map(|row| &mut row.panels)
            .enumerate();
        for (index, panel) in &mut panels {
            if members.contains(&index) {
                panel.view.panel_mut().share_axis(axis);
            }
        }
    }
}
