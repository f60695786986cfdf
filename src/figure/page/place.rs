//! Drawings put on a page: moved, scaled, with lines of another width.

use crate::figure::drawing::{Drawing, Item, Label, Picture, Point};
use crate::figure::write::POINTS_PER_MM;
use image::RgbaImage;
use image::imageops::{FilterType, resize};

/// Placement of a drawing on a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PagePlacement {
    /// Upper left corner of the drawing on the page, in points.
    pub at: Point,
    /// Lengths on the page per length in the drawing.
    pub scale: f32,
    /// Widths and dashes of lines on the page per those in the drawing.
    pub lines: f32,
    /// Pixels to the inch that smooth pictures have at least.
    pub dpi: f64,
}

/// Adds the items of a drawing to a page.
pub(super) fn place(page: &mut Drawing, drawing: Drawing, how: PagePlacement) {
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
        Item::Image(mut picture) => {
            (picture.min, picture.max) = (at(picture.min), at(picture.max));
            if picture.smooth {
                refine(&mut picture, how.dpi);
            }
            Item::Image(picture)
        }
    });
    page.items.extend(items);
}

/// Gives a picture enough pixels for print: viewers of files differ in how they fill in between.
fn refine(picture: &mut Picture, dpi: f64) {
    const MOST: u32 = 4096;
    let [width, height] = [picture.width as u32, picture.height as u32];
    let wanted = |k: usize| (pixels(picture.max[k] - picture.min[k], dpi) as u32).min(MOST);
    let (wide, high) = (wanted(0), wanted(1));
    if !picture.is_whole() || width >= wide || height >= high {
        return;
    }
    if let Some(coarse) = RgbaImage::from_raw(width, height, picture.rgba.to_vec()) {
        (picture.width, picture.height) = (wide as usize, high as usize);
        picture.rgba = resize(&coarse, wide, high, FilterType::Triangle)
            .into_raw()
            .into();
    }
}

/// Pixels along a length in points.
pub(super) fn pixels(points: f32, dpi: f64) -> usize {
    (f64::from(points) / POINTS_PER_MM / 25.4 * dpi)
        .ceil()
        .max(1.0) as usize
}
