//! How a heat map divides its rectangle: title, axes and colour bar around the cells.

use super::{Cell, Field, HeatFrame, HeatSpec};
use crate::figure::drawing::{LINE_HEIGHT, Point, font_size};
use crate::figure::scale::Tick;
use crate::figure::text::{RichText, elided};

/// Length of a tick in points.
pub(super) const TICK: f32 = 4.0;

/// Places and sizes in points.
pub(super) struct Plan {
    /// Font size.
    pub font: f32,
    /// What it is, and the left end of its text.
    pub title: (RichText, Point),
    /// Where the cells are.
    pub frame: HeatFrame,
    /// Upper left and lower right corner of the colour bar.
    pub bar: [Point; 2],
    /// Along the bar.
    pub bar_ticks: Vec<Tick>,
    /// Right end of the labels beside the bar.
    pub bar_end: f32,
    /// Whether there is room for the name of the bar.
    pub bar_title: bool,
    /// Along the cells.
    pub x_ticks: Vec<Tick>,
    /// Likewise, upwards.
    pub y_ticks: Vec<Tick>,
    /// Left end of the key of what is hatched, on the line of the title of x.
    pub key: Option<Point>,
}

impl Plan {
    pub(super) fn new(spec: &HeatSpec, field: &Field, [width, height]: [f32; 2]) -> Self {
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
        let bar_count = ((tall / (2.6 * font)) as usize).clamp(2, 9);
        let bar_ticks = spec.colors.ticks(bar_count);
        let left = pad + line + widest(&y_ticks) + TICK + 0.4 * font;
        let bar_width = 1.1 * font;
        let labels = widest(&bar_ticks) + 0.5 * font;
        let bar_title = width >= 230.0 && tall >= 5.0 * font;
        let named = if bar_title { 1.1 * line } else { 0.0 };
        let right = font + bar_width + labels + named + 0.5 * pad;
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
        let bar_left = max[0] + font;
        let bar = [[bar_left, min[1]], [bar_left + bar_width, max[1]]];
        let room = (width - min[0] - pad) / font;
        let titles: Vec<RichText> = spec
            .title
            .iter()
            .map(|text| RichText::parse(text))
            .collect();
        let fits = titles.iter().find(|title| title.width_em() <= room);
        let title = fits.cloned().unwrap_or_else(|| {
            let last = titles.last().map(RichText::plain).unwrap_or_default();
            elided(&last, room)
        });
        let key_width = font * (RichText::literal(spec.missing).width_em() + 1.8);
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
            bar_end: bar[1][0] + labels,
            bar_ticks,
            bar_title,
            x_ticks,
            y_ticks,
            key,
        }
    }
}
