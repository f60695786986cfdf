//! Heat maps of tiles: painting them, and the gestures that move what is in sight.

use crate::app::widgets::paint;
use crate::figure::heatmap::{HeatField, HeatMap, HeatSpec, HeatView};
use crate::figure::palette::Palette;
use egui::{CursorIcon, PointerButton, Rect, Response, Sense, Vec2};

/// A heat map on screen.
pub struct HeatOnScreen {
    /// Heat map that is drawn.
    pub map: HeatMap,
    /// Over all of it.
    pub response: Response,
}

/// Points of the wheel that make something e times larger.
const WHEEL: f64 = 240.0;
/// Opacity of an old picture while the next one is made.
pub const DIMMED: f32 = 0.45;

/// Draws a heat map into what is left of the tile.
pub fn heat_ui(
    ui: &mut egui::Ui,
    name: &str,
    spec: &HeatSpec,
    field: &HeatField,
    dimmed: bool,
) -> HeatOnScreen {
    let size = ui.available_size().max(Vec2::splat(60.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, name));
    let palette = Palette::of_theme(ui.visuals().dark_mode);
    let map = HeatMap::new(spec, field, [rect.width(), rect.height()]);
    let mut painter = ui.painter().with_clip_rect(rect);
    if dimmed {
        painter.multiply_opacity(DIMMED);
    }
    paint::paint(&painter, rect.min, &map.drawing, &palette);
    HeatOnScreen { map, response }
}

impl HeatOnScreen {
    /// The values under the pointer, where it is over the cells and not covered.
    pub fn hovered(&self) -> Option<[f64; 2]> {
        self.under(self.response.hover_pos()?)
    }

    /// The values at a click.
    pub fn clicked(&self) -> Option<[f64; 2]> {
        let pointer = self.response.interact_pointer_pos()?;
        self.response.clicked().then(|| self.under(pointer))?
    }

    fn under(&self, pointer: egui::Pos2) -> Option<[f64; 2]> {
        let point = pointer - self.response.rect.min;
        self.map.frame.locate(point.into())
    }

    /// View after a drag, the wheel or a double click; `None` where they leave it.
    pub fn moved_view(&self, ui: &egui::Ui, view: HeatView) -> Option<HeatView> {
        let [width, height] = self.map.frame.size();
        let mut moved = view;
        if self.response.dragged_by(PointerButton::Primary) {
            let by = self.response.drag_delta();
            moved = view.moved([f64::from(-by.x / width), f64::from(by.y / height)]);
            ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
        }
        if let Some(pointer) = self.response.hover_pos() {
            let (scroll, pinch) = ui.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta()));
            let factor = (-f64::from(scroll) / WHEEL).exp() / f64::from(pinch);
            let cells = Rect::from_min_max(
                self.response.rect.min + Vec2::from(self.map.frame.min),
                self.response.rect.min + Vec2::from(self.map.frame.max),
            );
            if factor != 1.0 && cells.contains(pointer) {
                let point = pointer - self.response.rect.min;
                moved = moved.zoomed(self.map.frame.share_at(point.into()), factor);
            }
        }
        if self.response.double_clicked() {
            moved = HeatView::default();
        }
        (moved != view).then_some(moved)
    }
}
