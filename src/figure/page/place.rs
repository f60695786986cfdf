//! Drawings put on a page: moved, scaled, with lines of another width.

use crate::figure::drawing::{Drawing, Item, Label, Point};
use crate::figure::write::POINTS_PER_MM;
use image::RgbaImage;
use image::imageops::{FilterType, resize};

/// How a drawing is put on a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placing {
    /// Where its upper left corner comes to lie.
    pub at: Point,
    /// Lengths on the page per length in the drawing.
    pub scale: f32,
    /// Widths and dashes of lines on the page per those in the drawing.
    pub lines: f32,
    /// Pixels to the inch that smooth pictures have at least.
    pub dpi: f64,
}

/// Adds the items of a drawing to a page.
pub(super) fn place(page: &mut Drawing, drawing: Drawing, how: Placing) {
    let at = |[x, y]: Point| [how.at[0] + how.scale * x, how.at[1] + how.scale * y];
    let items = drawing.items.into_iter().map(|item| match item {
        Item::Line {
            points,
            width,
            dash,
            ink,
        } => Item::Line {
            points: points.into_iter().map(at).collect(),
            width: how.lines * width,
            dash: dash.map(|lengths| lengths.map(|length| how.lines * length)),
            ink,
        },
        Item::Fill { points, ink } => Item::Fill {
            points: points.into_iter().map(at).collect(),
            ink,
        },
        Item::Dot {
            center,
            radius,
            ink,
            outline,
        } => Item::Dot {
            center: at(center),
            radius: how.scale * radius,
            ink,
            outline: outline.map(|(width, ink)| (how.lines * width, ink)),
        },
        Item::Text(label) => Item::Text(Label {
            pos: at(label.pos),
            size: how.scale * label.size,
            ..label
        }),
        Item::Image {
            min,
            max,
            width,
            height,
            rgba,
            smooth,
        } => {
            let (min, max) = (at(min), at(max));
            let image = Item::Image {
                min,
                max,
                width,
                height,
                rgba,
                smooth,
            };
            if smooth { finer(image, how.dpi) } else { image }
        }
    });
    page.items.extend(items);
}

/// A picture with enough pixels for print: viewers of files differ in how they fill in between.
fn finer(item: Item, dpi: f64) -> Item {
    const MOST: u32 = 4096;
    let Item::Image {
        min,
        max,
        width,
        height,
        rgba,
        smooth,
    } = item
    else {
        return item;
    };
    let wanted = |k: usize| (pixels(max[k] - min[k], dpi) as u32).min(MOST);
    let (wide, high) = (wanted(0), wanted(1));
    let whole = RgbaImage::from_raw(width as u32, height as u32, rgba.to_vec());
    match whole {
        Some(picture) if (width as u32) < wide && (height as u32) < high && width * height > 0 => {
            let larger = resize(&picture, wide, high, FilterType::Triangle);
            Item::Image {
                min,
                max,
                width: wide as usize,
                height: high as usize,
                rgba: larger.into_raw().into(),
                smooth,
            }
        }
        _ => Item::Image {
            min,
            max,
            width,
            height,
            rgba,
            smooth,
        },
    }
}

/// Pixels along a length in points.
pub(super) fn pixels(points: f32, dpi: f64) -> usize {
    (f64::from(points) / POINTS_PER_MM / 25.4 * dpi)
        .ceil()
        .max(1.0) as usize
}
