//! The columns of the table of fits, and their heads.

use crate::app::msg::Msg;
use crate::app::msg::fit::FitMsg;
use crate::app::state::fitting::kept::SortBy;
use crate::app::widgets::paint::rich_text_job;
use crate::figure::text::RichText;
use egui::{Rect, Sense, Stroke, pos2, vec2};

/// Height of a row in points.
pub const ROW: f32 = 25.0;
/// Width below which the table scrolls, and below which it leaves the times out.
const NARROW: (f32, f32) = (430.0, 600.0);

/// Places of the columns in points from the left of a row.
pub struct Columns {
    /// Width of a row.
    pub width: f32,
    /// Whether names are short, and the times left out.
    pub narrow: bool,
    /// Left end of the names.
    pub name: f32,
    /// Right ends: E, E at grazing angles, s, α, η, and the time where there is room.
    pub right: Vec<f32>,
}

impl Columns {
    /// Columns of a tile of this width; wider than that where it is too narrow for a table.
    pub fn new(width: f32) -> Self {
        let width = width.max(NARROW.0);
        let narrow = width < NARROW.1;
        let widths: &[f32] = if narrow {
            &[50.0, 54.0, 50.0, 48.0, 42.0]
        } else {
            &[70.0, 78.0, 74.0, 62.0, 62.0, 66.0]
        };
        let mut left = width - widths.iter().sum::<f32>() - 8.0;
        let mut right = Vec::new();
        for width in widths {
            left += width;
            right.push(left);
        }
        Self {
            width,
            narrow,
            name: 64.0,
            right,
        }
    }

    /// Right end of the names.
    pub fn name_end(&self) -> f32 {
        self.right[0] - if self.narrow { 44.0 } else { 52.0 }
    }
}

const HEADS: [(&str, &str); 6] = [
    (
        "E [%]",
        "Error over all cells in percent. With the cosine weight: the share of reflected energy that is misplaced under uniform light.",
    ),
    (
        "E ≥ 70° [%]",
        "The same over the cells with θi or θo from 70° on, in percent.",
    ),
    ("s", "Specular exponent"),
    ("α", "0 is Phong, 1 is Blinn-Phong"),
    ("η", "Relative index of refraction"),
    ("time [s]", "How long the fit took"),
];

/// Draws the heads of the columns; a click sorts.
pub fn header_ui(ui: &mut egui::Ui, sort: SortBy, columns: &Columns, out: &mut Vec<Msg>) {
    let (rect, _) = ui.allocate_exact_size(vec2(columns.width, ROW), Sense::hover());
    let mut head = |right: Option<f32>, text: &str, help: &str, by: Option<SortBy>| {
        let sorted = by == Some(sort);
        let color = if sorted {
            ui.visuals().strong_text_color()
        } else {
            ui.visuals().weak_text_color()
        };
        let galley = ui
            .painter()
            .layout_job(rich_text_job(&RichText::parse(text), 12.5, color));
        let x = rect.left() + right.map_or(columns.name, |right| right - galley.size().x);
        let at = pos2(x, rect.center().y - 0.5 * galley.size().y);
        let cell = Rect::from_min_size(at, galley.size()).expand2(vec2(5.0, 4.0));
        ui.painter().galley(at, galley, color);
        if sorted {
            let base = pos2(cell.right() - 5.0, cell.bottom() - 3.0);
            let left = pos2(cell.left() + 5.0, base.y);
            ui.painter()
                .line_segment([left, base], Stroke::new(1.0, color));
        }
        let sense = if by.is_some() {
            Sense::click()
        } else {
            Sense::hover()
        };
        let response = ui.interact(cell, ui.scope_id().with(text), sense);
        if let Some(by) = by {
            response.widget_info(|| {
                egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Sort by {text}"))
            });
            if response.clicked() {
                out.push(Msg::Fit(FitMsg::SortBy(by)));
            }
        }
        response.on_hover_text(help);
    };
    head(
        None,
        "variant",
        "Model and Fresnel factor. A click on a row lays that fit over the material.",
        Some(SortBy::Name),
    );
    let sorts = [Some(SortBy::Error), Some(SortBy::Grazing)];
    for (k, (right, (text, help))) in columns.right.iter().zip(HEADS).enumerate() {
        let text = match text.split_once(" [") {
            // The unit is in the help, too.
            Some((short, _)) if columns.narrow => short,
            _ => text,
        };
        head(Some(*right), text, help, sorts.get(k).copied().flatten());
    }
    let line = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().hline(rect.x_range(), rect.bottom(), line);
}
