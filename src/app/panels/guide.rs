//! The guide in the window: the pages and the headings of the one that is read at the left, that page at the right.

mod blocks;

use crate::app::guide::markdown::words;
use crate::app::guide::{BLOCKS, GuideAt, LinkTarget, PAGES, headings, target};
use crate::app::msg::Msg;
use blocks::page_ui;
use egui::{Id, OpenUrl, ScrollArea, Ui, vec2};

/// Width of the list of headings in points.
const LIST_WIDTH: f32 = 178.0;
/// The guide is no larger.
const LARGEST: egui::Vec2 = vec2(1070.0, 760.0);
/// Width and height in points that the frame and the button below the page take of the window.
const AROUND: egui::Vec2 = vec2(80.0, 120.0);

/// Draws the page that is read, and what else there is to read.
pub fn guide_ui(ui: &mut Ui, at: GuideAt, out: &mut Vec<Msg>) {
    let size = (ui.ctx().content_rect().size() - AROUND).min(LARGEST);
    let go = |page: usize, heading: Option<usize>| {
        Msg::ReadGuide(GuideAt {
            page,
            heading,
            jump: at.jump + 1,
        })
    };
    ui.set_width(size.x);
    ui.horizontal_top(|ui| {
        ui.set_height(size.y);
        ui.allocate_ui(vec2(LIST_WIDTH, size.y), |ui| {
            ui.set_width(LIST_WIDTH);
            if let Some((page, heading)) = list_ui(ui, at) {
                out.push(go(page, heading));
            }
        });
        ui.separator();
        ui.vertical(|ui| {
            if let Some(link) = read_ui(ui, at) {
                match target(at.page, &link) {
                    Some(LinkTarget::Page(page, heading)) => out.push(go(page, heading)),
                    Some(LinkTarget::Web(url)) => ui.ctx().open_url(OpenUrl::new_tab(url)),
                    None => {}
                }
            }
        });
    });
}

/// The pages, and the headings of the one that is read; returns where a click leads.
fn list_ui(ui: &mut Ui, at: GuideAt) -> Option<(usize, Option<usize>)> {
    let mut chosen = None;
    ScrollArea::vertical()
        .id_salt("headings")
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.with_layout(egui::Layout::top_down_justified(egui::Align::LEFT), |ui| {
                for (page, row) in PAGES.iter().enumerate() {
                    let name = egui::RichText::new(row.name).strong();
                    if ui.selectable_label(page == at.page, name).clicked() {
                        chosen = Some((page, None));
                    }
                    if page != at.page {
                        continue;
                    }
                    for (index, heading) in headings(&BLOCKS[page]).enumerate() {
                        if heading.level == 1 {
                            continue;
                        }
                        let indent = 10.0 * f32::from(heading.level - 1);
                        let entry = ui.horizontal(|ui| {
                            ui.add_space(indent);
                            let words = words(heading.spans);
                            let button = egui::Button::selectable(at.heading == Some(index), words);
                            ui.add(button.truncate())
                        });
                        if entry.inner.clicked() {
                            chosen = Some((page, Some(index)));
                        }
                    }
                    ui.add_space(6.0);
                }
            });
        });
    chosen
}

/// The page; returns the link that was clicked.
fn read_ui(ui: &mut Ui, at: GuideAt) -> Option<String> {
    // A jump is made once; then the page is the reader's to scroll.
    let made = Id::unique("guide jump");
    let is_new = ui.data(|data| data.get_temp(made)) != Some(at);
    ui.data_mut(|data| data.insert_temp(made, at));
    ScrollArea::vertical()
        .id_salt("page")
        .auto_shrink(false)
        .show(ui, |ui| {
            let page = page_ui(ui, at.page);
            if is_new {
                let to = at.heading.and_then(|index| page.headings.get(index));
                let rect = to.copied().unwrap_or(page.top);
                ui.scroll_to_rect_animation(
                    rect,
                    Some(egui::Align::TOP),
                    egui::style::ScrollAnimation::none(),
                );
            }
            page.clicked
        })
        .inner
}
