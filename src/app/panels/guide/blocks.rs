//! The blocks of a page as widgets.

mod table;

use crate::app::guide::markdown::{Block, Span};
use crate::app::guide::{BLOCKS, picture, target};
use egui::cache::FramePublisher;
use egui::text::LayoutJob;
use egui::{
    Color32, ColorImage, FontId, Frame, Label, Link, Rect, Role, ScrollArea, Sense, TextFormat,
    TextureHandle, TextureOptions, Ui, WidgetInfo, pos2, vec2,
};
use std::sync::Arc;

/// Size of running text in points.
const TEXT: f32 = 14.0;
/// Size of code blocks in points.
const CODE: f32 = 12.0;
/// Sizes of headings by level.
const HEADINGS: [f32; 4] = [24.0, 19.0, 16.0, 14.5];
/// Height of a line by the size of its letters.
const LINE: f32 = 1.35;
/// Between blocks.
const SPACE: f32 = 8.0;
/// Running text is no wider, so that lines can be read; code and tables may be.
const LONGEST: f32 = 740.0;
/// Between the page and its scroll bar.
const MARGIN: f32 = 14.0;

/// A page that was drawn.
pub struct Drawn {
    /// Rectangle of the page's beginning.
    pub top: Rect,
    /// Rectangles of the headings, in order.
    pub headings: Vec<Rect>,
    /// The link that was clicked.
    pub clicked: Option<String>,
}

/// Draws a page. Blocks out of sight take their room only, once it is known.
pub fn page_ui(ui: &mut Ui, page: usize) -> Drawn {
    let width = ui.available_width() - MARGIN;
    ui.set_max_width(width);
    let top = Rect::from_min_size(ui.cursor().min, vec2(width, 1.0));
    ui.spacing_mut().item_spacing.y = SPACE;
    let mut drawn = Drawn {
        top,
        headings: Vec::new(),
        clicked: None,
    };
    let scale = ui.pixels_per_point();
    let room = ui
        .scope_id()
        .with(("room", page, width.to_bits(), scale.to_bits()));
    let known: Arc<Vec<f32>> = ui.data(|data| data.get_temp(room)).unwrap_or_default();
    let mut heights = Vec::new();
    for (index, block) in BLOCKS[page].iter().enumerate() {
        let start = ui.cursor().min;
        let height = known.get(index).copied();
        let rect = Rect::from_min_size(start, vec2(width, height.unwrap_or(1.0)));
        if matches!(block, Block::Heading { .. }) {
            drawn.headings.push(rect);
        }
        if let Some(height) = height.filter(|_| !ui.is_rect_visible(rect)) {
            ui.allocate_space(vec2(width, height - SPACE));
        } else {
            ui.push_id(index, |ui| block_ui(ui, page, block, &mut drawn.clicked));
        }
        heights.push(ui.cursor().top() - start.y);
    }
    if *known != heights {
        ui.data_mut(|data| data.insert_temp(room, Arc::new(heights)));
    }
    drawn
}

fn block_ui(ui: &mut Ui, page: usize, block: &Block, clicked: &mut Option<String>) {
    match block {
        Block::Heading { level, spans, .. } => {
            let size = HEADINGS[usize::from(*level).clamp(1, HEADINGS.len()) - 1];
            if *level > 1 {
                ui.add_space(size - 6.0);
            }
            spans_ui(ui, page, spans, (size, true), clicked);
        }
        Block::Paragraph(spans) => {
            ui.set_max_width(ui.available_width().min(LONGEST));
            spans_ui(ui, page, spans, (TEXT, false), clicked);
        }
        Block::Code(code) => code_ui(ui, code),
        Block::List { first, items } => {
            ui.set_max_width(ui.available_width().min(LONGEST));
            for (index, item) in items.iter().enumerate() {
                let mark = match first {
                    Some(first) => format!("{}.", first + index as u64),
                    None => "•".into(),
                };
                ui.horizontal_top(|ui| {
                    ui.spacing_mut().item_spacing.x = 6.0;
                    ui.add_space(4.0);
                    ui.label(one(ui, &mark, (TEXT, false)));
                    ui.vertical(|ui| {
                        for block in item {
                            block_ui(ui, page, block, clicked);
                        }
                    });
                });
            }
        }
        Block::Table { head, rows } => table::table_ui(ui, page, (head, rows), clicked),
        Block::Picture { path, words } => picture_ui(ui, path, words),
    }
}

fn code_ui(ui: &mut Ui, code: &str) {
    Frame::new()
        .fill(code_ground(ui))
        .corner_radius(4.0)
        .inner_margin(8.0)
        .show(ui, |ui| {
            ScrollArea::horizontal()
                .auto_shrink([false, true])
                .show(ui, |ui| {
                    let format = TextFormat {
                        line_height: Some(LINE * CODE),
                        ..TextFormat::simple(FontId::monospace(CODE), text_color(ui))
                    };
                    let job = LayoutJob::single_section(code.to_string(), format);
                    ui.add(Label::new(job).extend());
                });
        });
}

/// Running text of some size, strong or not.
fn spans_ui(
    ui: &mut Ui,
    page: usize,
    spans: &[Span],
    look: (f32, bool),
    clicked: &mut Option<String>,
) {
    let leads = |span: &Span| {
        let link = span.link.as_deref()?;
        target(page, link).map(|_| link.to_string())
    };
    if spans.iter().all(|span| leads(span).is_none()) {
        ui.add(Label::new(job(ui, spans, look, None)).wrap());
        return;
    }
    ui.scope(|ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(0.0, 0.0);
            for run in spans.chunk_by(|a, b| a.link == b.link) {
                match leads(&run[0]) {
                    None => {
                        ui.label(job(ui, run, look, None));
                    }
                    Some(link) => {
                        let color = ui.visuals().hyperlink_color;
                        let response = ui.add(Link::new(job(ui, run, look, Some(color))));
                        if response.on_hover_text(&link).clicked() {
                            *clicked = Some(link);
                        }
                    }
                }
            }
        });
    });
}

/// Clearer than that of labels: there is much to read.
fn text_color(ui: &Ui) -> Color32 {
    ui.visuals().widgets.inactive.text_color()
}

/// Background colour of code.
fn code_ground(ui: &Ui) -> Color32 {
    ui.visuals().text_color().gamma_multiply(0.13)
}

fn one(ui: &Ui, text: &str, look: (f32, bool)) -> LayoutJob {
    let span = Span {
        text: text.into(),
        ..Span::default()
    };
    job(ui, &[span], look, None)
}

/// Spans as text with its looks; in `color` where it is given.
fn job(ui: &Ui, spans: &[Span], (size, strong): (f32, bool), color: Option<Color32>) -> LayoutJob {
    let visuals = ui.visuals();
    let mut job = LayoutJob::default();
    for span in spans {
        let ink = if strong || span.strong {
            visuals.strong_text_color()
        } else {
            text_color(ui)
        };
        let font = if span.code {
            FontId::monospace(0.9 * size)
        } else {
            FontId::proportional(size)
        };
        let format = TextFormat {
            italics: span.emphasis,
            background: if span.code {
                code_ground(ui)
            } else {
                Color32::TRANSPARENT
            },
            line_height: Some(LINE * size),
            ..TextFormat::simple(font, color.unwrap_or(ink))
        };
        job.append(&span.text, 0.0, format);
    }
    job
}

/// A picture, no wider than the page; its words where it is not built in.
fn picture_ui(ui: &mut Ui, path: &str, words: &str) {
    let found = picture(path).and_then(|(name, png)| Some((name, png, png_size(png)?)));
    let Some((name, png, size)) = found else {
        ui.weak(words);
        return;
    };
    let size = size * (ui.available_width() / size.x).min(1.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, words));
    if ui.is_rect_visible(rect)
        && let Some(texture) = texture(ui.ctx(), name, png)
    {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        ui.painter()
            .image(texture.id(), rect, whole, Color32::WHITE);
    }
    response.on_hover_text(words);
}

/// Width and height in pixels, as the header says.
fn png_size(png: &[u8]) -> Option<egui::Vec2> {
    let number = |at: usize| {
        let bytes = png.get(at..at + 4)?.try_into().ok()?;
        Some(u32::from_be_bytes(bytes) as f32)
    };
    Some(vec2(number(16)?, number(20)?)).filter(|size| size.min_elem() >= 1.0)
}

/// The picture as a texture, which stays as long as it is in sight.
fn texture(ctx: &egui::Context, name: &'static str, png: &[u8]) -> Option<TextureHandle> {
    type Kept = FramePublisher<&'static str, TextureHandle>;
    let kept = ctx.memory_mut(|memory| memory.caches.cache::<Kept>().get(&name).cloned());
    let texture = match kept {
        Some(texture) => texture,
        None => {
            let image = image::load_from_memory(png).ok()?.to_rgba8();
            let size = [image.width() as usize, image.height() as usize];
            let image = ColorImage::from_rgba_unmultiplied(size, image.as_raw());
            ctx.load_texture(name, image, TextureOptions::LINEAR)
        }
    };
    let keep = texture.clone();
    ctx.memory_mut(|memory| memory.caches.cache::<Kept>().set(name, keep));
    Some(texture)
}
