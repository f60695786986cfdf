//! Layout of a heat map in its rectangle: title, axes and colour bar around the cells.

use super::bar::{ColorBar, key_width_em};
use super::{Cell, HeatField, HeatFrame, HeatSpec};
use crate::figure::drawing::{LINE_HEIGHT, Point, font_size};
use crate::figure::scale::Tick;
use crate::figure::text::{RichText, elided};

/// Length of a tick in points.
pub(super) const TICK: f32 = 4.0;

/// Places and sizes in points.
pub(super) struct HeatLayout {
    /// Font size.
    pub font: f32,
    /// Title, and the left end of its text.
    pub title: (RichText, Point),
    /// Place of the cells.
    pub frame: HeatFrame,
    /// Right of the cells.
    pub bar: ColorBar,
    /// Along the cells.
    pub x_ticks: Vec<Tick>,
    /// Likewise, upwards.
    pub y_ticks: Vec<Tick>,
    /// Left end of the key of what is hatched, on the line of the title of x.
    pub key: Option<Point>,
}

impl HeatLayout {
    pub(super) fn new(spec: &HeatSpec, field: &HeatField, [width, height]: [f32; 2]) -> Self {
        let font = font_size([width, height]);
        let (pad, line) = (0.6 * font, LINE_HEIGHT * font);
        let top = pad + line + 0.5 * pad;
        let bottom = TICK + 2.0 * line + 0.6 * pad;
        let tall = (height - top - bottom).max(8.0);

        let widest = |ticks: &[Tick]| {
            let width = |tick: &Tick| font * tick.label.width_em();
            ticks.iter().map(width).fold(0.0, f32::max)
        };
        let y_ticks = spec.y.ticks(spec.view.y, f64::from(2.7 * font / tall));
        let bar = ColorBar::new(&spec.colors, width, tall, font);
        let left = pad + line + widest(&y_ticks) + TICK + 0.4 * font;
        let right = bar.width() + 0.5 * pad;
        let wide = (width - left - right).max(8.0);

        let (wide, tall, aside) = if spec.square {
            let side = wide.min(tall);
            (side, side, [0.5 * (wide - side), 0.5 * (tall - side)])
        } else {
            (wide, tall, [0.0, 0.0])
        };
        let min = [left + aside[0], top + aside[1]];
        let max = [min[0] + wide, min[1] + tall];
        let frame = HeatFrame {
            min,
            max,
            x: spec.x.clone(),
            y: spec.y.clone(),
            view: spec.view,
        };
        let x_gap = 1.6 * font + 0.4 * font * f32::from(spec.x.degrees);
        let x_ticks = spec.x.ticks(spec.view.x, f64::from(x_gap / wide));
        let room = (width - min[0] - pad) / font;
        let title = fitting_title(&spec.title, room);
        let key_width = font * key_width_em(spec.missing);
        let x_title = font * RichText::parse(&spec.x.title).width_em();
        let has_missing = field.cells.contains(&Cell::Missing);
        let free = 0.5 * (wide - x_title) - font;
        let key = (has_missing && key_width <= free)
            .then(|| [max[0] - key_width, max[1] + TICK + 1.5 * line]);
        Self {
            font,
            title: (title, [min[0], min[1] - 0.5 * pad - 0.5 * line]),
            frame,
            bar,
            x_ticks,
            y_ticks,
            key,
        }
    }
}

/// The first of some titles that is not wider than `room_em` font sizes; the last one cut, where none is.
pub fn fitting_title(titles: &[String], room_em: f32) -> RichText {
    let mut parsed = titles.iter().map(|text| RichText::parse(text));
    parsed
        .find(|title| title.width_em() <= room_em)
        .unwrap_or_else(|| {
            let last = titles.last().map(|text| RichText::parse(text).plain());
            elided(&last.unwrap_or_default(), room_em)
        })
}
