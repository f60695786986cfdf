//! Figure of the window: the shown views of the shown subjects, as a spec.

use crate::app::state::State;
use crate::app::state::views::ViewId;
use crate::app::views::ViewRow;
use crate::app::views::on_paper::{FigureSubjects, Naming};
use crate::export::{FigureSpec, SubjectSource};
use crate::figure::page::{PageSpec, PanelSpec, RowSpec, Style};
use crate::files::names::short;
use crate::measured::Table;
use std::sync::Arc;

/// A figure with the data that it is drawn from.
#[derive(Clone, Debug)]
pub struct Drawable {
    /// The figure.
    pub spec: FigureSpec,
    /// The data of its measured subjects.
    pub tables: Vec<(SubjectSource, Arc<Table>)>,
}

impl PartialEq for Drawable {
    /// The spec names its data.
    fn eq(&self, other: &Self) -> bool {
        self.spec == other.spec
    }
}

/// The figure of some tiles, `columns` beside each other; `None` where nothing can be drawn.
pub fn figure_of(
    state: &State,
    panes: &[ViewId],
    columns: usize,
    style: &Style,
) -> Option<Drawable> {
    let mut subjects = FigureSubjects::new(state)?;
    let panels: Vec<PanelSpec> = panes
        .iter()
        .filter(|pane| state.can_draw(**pane))
        .filter_map(|pane| ViewRow::of(*pane)?.paper.as_ref())
        .flat_map(|paper| (paper.panels)(&mut subjects))
        .collect();
    if panels.is_empty() {
        return None;
    }
    let row = |panels: &[PanelSpec]| RowSpec {
        panels: panels.to_vec(),
        ..RowSpec::default()
    };
    let page = PageSpec {
        rows: panels.chunks(columns.max(1)).map(row).collect(),
        style: style.clone(),
    };
    Some(Drawable {
        // As it is read back from its file, so that the file draws the same.
        spec: FigureSpec::new(subjects.list, page).settled(),
        tables: subjects.tables,
    })
}

/// Default name of a figure of some tiles: material, plot, angles, model, scale.
pub fn default_name(state: &State, panes: &[ViewId]) -> String {
    let Some((material, opened)) = state.current() else {
        return "figure".into();
    };
    let model = opened.brdf.model.key;
    let words = match panes {
        [pane] => {
            let naming = Naming {
                state,
                material: short(&material.name),
                view: pane.about().key,
                model,
            };
            let paper = ViewRow::of(*pane).and_then(|row| row.paper.as_ref());
            paper.map_or_else(|| naming.words(&[]), |paper| (paper.name)(&naming))
        }
        _ => vec![short(&material.name).into(), "figure".into(), model.into()],
    };
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '-'
        }
    };
    words.join("_").chars().map(plain).collect()
}
