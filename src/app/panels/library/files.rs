//! The files of the folder, a row each. Only rows in sight are drawn.

use crate::app::msg::Msg;
use crate::app::msg::library::LibraryMsg;
use crate::app::state::State;
use crate::app::state::library::{Examined, FileKind, Folder, FolderFile, PendingTarget};
use crate::app::widgets::formula::{number, percent};
use crate::brdf::params::Scale;
use crate::figure::text::{RichText, elided};
use crate::files::fits::FitRecord;
use egui::{Color32, FontId, Rect, Sense, pos2, vec2};

/// Height of a row in points.
const ROW: f32 = 44.0;
/// Width and height of a thumbnail in points.
const THUMBNAIL: f32 = 36.0;

/// Draws the rows in sight.
pub fn files_ui(ui: &mut egui::Ui, state: &State, folder: &Folder, out: &mut Vec<Msg>) {
    let rows = state.library.visible();
    if rows.is_empty() && !folder.files.is_empty() {
        ui.weak("No file has these words in its name.");
        return;
    }
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut area = egui::ScrollArea::vertical()
        .id_salt(("files", folder.number))
        .auto_shrink([false, false]);
    if let Some(offset) = offset_to_reveal(ui, state, folder, &rows) {
        area = area.vertical_scroll_offset(offset);
    }
    let shown = area.show_rows(ui, ROW, rows.len(), |ui, range| {
        for index in &rows[range] {
            // The list may move between press and release.
            let id = egui::Id::unique(("file", folder.number, index));
            file_ui(ui, state, &folder.files[*index], id, out);
        }
    });
    let offset = shown.state.clamped_offset().y;
    ui.data_mut(|data| data.insert_temp(offset_id(), offset));
}

/// Id of the last scroll offset of the list.
fn offset_id() -> egui::Id {
    egui::Id::unique("library offset")
}

/// Scroll offset in points after a step by keys, so that its row is in sight with one more above and below.
fn offset_to_reveal(ui: &egui::Ui, state: &State, folder: &Folder, rows: &[usize]) -> Option<f32> {
    let id = egui::Id::unique("library has revealed");
    let seen: u64 = ui.data(|data| data.get_temp(id)).unwrap_or(0);
    if seen == state.library.reveal {
        return None;
    }
    ui.data_mut(|data| data.insert_temp(id, state.library.reveal));
    let cursor = state.library.cursor.as_ref()?;
    let row = rows
        .iter()
        .position(|index| folder.files[*index].path == *cursor)?;
    let offset: f32 = ui.data(|data| data.get_temp(offset_id())).unwrap_or(0.0);
    let (top, height) = (row as f32 * ROW, ui.available_height());
    let least = top + 2.0 * ROW - height;
    let most = (top - ROW).max(0.0);
    (offset < least || offset > most).then(|| offset.max(least).min(most).max(0.0))
}

fn file_ui(ui: &mut egui::Ui, state: &State, file: &FolderFile, id: egui::Id, out: &mut Vec<Msg>) {
    let (_, rect) = ui.allocate_space(vec2(ui.available_width(), ROW));
    let response = ui.interact(rect, id, Sense::click());
    let can_open = !matches!(file.kind, FileKind::Other(_));
    let position = state.position_of_file(&file.path);
    let shown = position == Some(state.scene.selected) && position.is_some();
    let is_pending = matches!(
        &state.library.pending,
        Some(pending) if matches!(&pending.target, PendingTarget::File { path, .. } if *path == file.path)
    );
    response.widget_info(|| {
        egui::WidgetInfo::selected(egui::Role::Button, can_open, shown, &file.name)
    });
    let visuals = ui.visuals().clone();
    if shown || is_pending {
        let strength = if shown { 0.55 } else { 0.3 };
        let fill = visuals.selection.bg_fill.gamma_multiply(strength);
        ui.painter().rect_filled(rect, 3.0, fill);
    } else if response.hovered() && can_open {
        let fill = visuals.widgets.hovered.weak_bg_fill.gamma_multiply(0.6);
        ui.painter().rect_filled(rect, 3.0, fill);
    }
    let best = state.library.listed_fit(&file.path);
    let [first, second] = if is_pending {
        ["Loading…".into(), String::new()]
    } else {
        lines(&file.kind, best)
    };
    picture_ui(ui, file, rect);
    let text = Text {
        ui,
        left: rect.left() + THUMBNAIL + 12.0,
        right: rect.right() - 4.0,
    };
    let weak = visuals.weak_text_color();
    let color = if can_open { visuals.text_color() } else { weak };
    // All that can be shown end alike.
    let stem = file.name.rsplit_once('.').map(|(stem, _)| stem);
    let name = match stem.filter(|stem| file.is_measured() && !stem.is_empty()) {
        Some(stem) => stem,
        None => &file.name,
    };
    if second.is_empty() {
        text.line(rect.top() + 14.0, name, 13.5, color);
        text.line(rect.top() + 30.0, &first, 11.0, weak);
    } else {
        text.line(rect.top() + 9.0, name, 13.5, color);
        text.line(rect.top() + 23.5, &first, 11.0, weak);
        text.line(rect.top() + 36.0, &second, 11.0, visuals.text_color());
    }
    let response = response.on_hover_ui(|ui| hover_ui(ui, file, best));
    if can_open && (response.clicked() || response.double_clicked()) {
        out.push(Msg::Library(LibraryMsg::Show {
            path: file.path.clone(),
            keep: response.double_clicked(),
        }));
    }
}

/// Draws lines that end where the row does.
struct Text<'a> {
    ui: &'a egui::Ui,
    left: f32,
    right: f32,
}

impl Text<'_> {
    fn line(&self, middle: f32, text: &str, size: f32, color: Color32) {
        let (painter, font) = (self.ui.painter(), FontId::proportional(size));
        let mut galley = painter.layout_no_wrap(text.to_owned(), font.clone(), color);
        let room = self.right - self.left;
        if galley.size().x > room {
            galley = painter.layout_no_wrap(elided(text, room / size).plain(), font, color);
        }
        let at = pos2(self.left, middle - 0.5 * galley.size().y);
        painter.galley(at, galley, color);
    }
}

/// The thumbnail, or an empty circle in its place.
fn picture_ui(ui: &egui::Ui, file: &FolderFile, row: Rect) {
    let center = pos2(row.left() + 5.0 + 0.5 * THUMBNAIL, row.center().y);
    let rect = Rect::from_center_size(center, vec2(THUMBNAIL, THUMBNAIL));
    if let Some(examined) = file.examined() {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        let texture = examined.thumbnail.0.id();
        ui.painter().image(texture, rect, whole, Color32::WHITE);
    } else if !matches!(file.kind, FileKind::Other(_)) {
        let stroke = egui::Stroke::new(1.0, ui.visuals().weak_text_color().gamma_multiply(0.4));
        let radius = 0.5 * THUMBNAIL - 1.0;
        ui.painter().circle_stroke(center, radius, stroke);
    }
}

/// Lines of a row below the name: what is known of the file, and its best fit.
fn lines(kind: &FileKind, best: Option<&FitRecord>) -> [String; 2] {
    let first = match kind {
        FileKind::Unknown => String::new(),
        FileKind::Measured(None) => "…".into(),
        FileKind::Measured(Some(examined)) => {
            format!(
                "{}, {:.0} % valid",
                width(examined),
                100.0 * examined.valid_share
            )
        }
        FileKind::Models(None) => "Large fit file".into(),
        FileKind::Models(Some(1)) => "Fit file, 1 material".into(),
        FileKind::Models(Some(count)) => format!("Fit file, {count} materials"),
        FileKind::Other(reason) => reason.clone(),
    };
    [first, best.map(fit_text).unwrap_or_default()]
}

/// The width of the highlight in words.
fn width(examined: &Examined) -> String {
    match examined.half_width {
        Some(width) => format!("peak ±{}°", number(width.to_degrees())),
        None => "no peak".into(),
    }
}

fn fit_text(fit: &FitRecord) -> String {
    let mut text = format!("E {}", percent(fit.errors.total));
    for (row, value) in fit.brdf.model.params.iter().zip(fit.brdf.params.lobe) {
        let value = match row.scale {
            Scale::Linear => format!("{value:.2}"),
            Scale::Log { .. } => number(value),
        };
        text += &format!("  {} {value}", row.symbol);
    }
    RichText::parse(&text).plain()
}

fn hover_ui(ui: &mut egui::Ui, file: &FolderFile, best: Option<&FitRecord>) {
    ui.set_max_width(380.0);
    ui.label(&file.name);
    match &file.kind {
        FileKind::Other(reason) => {
            ui.weak(reason);
        }
        FileKind::Models(_) => {
            ui.weak("A click opens its materials with their models.");
        }
        FileKind::Unknown | FileKind::Measured(None) => {
            ui.weak("Not read yet.");
        }
        FileKind::Measured(Some(examined)) => {
            ui.weak(format!(
                "{:.1} % of the cells are valid.",
                100.0 * examined.valid_share
            ));
            ui.weak(match examined.half_width {
                Some(width) => format!(
                    "The highlight falls to half its height at θh = {}° (mean over θd from 5° to 45°).",
                    number(width.to_degrees())
                ),
                None => "No highlight stands out.".into(),
            });
        }
    }
    if let Some(fit) = best {
        let variant = crate::fit::Variant::from(&fit.brdf);
        let name = crate::app::state::fitting::kept::variant_name(variant);
        ui.weak(format!("Best fit: {name}, {}", fit_text(fit)));
    }
    if file.is_measured() {
        ui.weak("Click or arrows show it; a double click or Enter leaves it open.");
    }
}
