//! Tiles that have nothing to show.

/// One muted sentence in the middle of an empty tile.
pub fn empty_ui(ui: &egui::Ui, rect: egui::Rect, text: &str) {
    let color = ui.visuals().weak_text_color();
    let mut job = egui::text::LayoutJob::simple(
        text.to_string(),
        egui::FontId::proportional(14.0),
        color,
        rect.width() - 24.0,
    );
    job.halign = egui::Align::Center;
    let galley = ui.painter().layout_job(job);
    let top = rect.center() - egui::vec2(0.0, 0.5 * galley.size().y);
    ui.painter().galley(top, galley, color);
}
