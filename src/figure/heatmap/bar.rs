//! The colour bar beside a picture of values, and the key of what is hatched in it.

use super::ColorScale;
use crate::figure::drawing::{Anchor, Drawing, Item, LINE_HEIGHT, Label, Picture, Point};
use crate::figure::palette::{Ink, Role};
use crate::figure::scale::Tick;
use crate::figure::text::RichText;
use std::f32::consts::FRAC_PI_2;

/// Steps of the colour bar.
const STEPS: usize = 256;

/// A colour bar with its ticks and its title.
#[derive(Clone, Debug)]
pub struct ColorBar {
    ticks: Vec<Tick>,
    /// Whether there is room for the title.
    titled: bool,
    /// Font size in points.
    font: f32,
}

impl ColorBar {
    /// The bar of a plot `width` points wide beside a picture `tall` points high.
    pub fn new(colors: &ColorScale, width: f32, tall: f32, font: f32) -> Self {
        let count = ((tall / (2.6 * font)) as usize).clamp(2, 9);
        Self {
            ticks: colors.ticks(count),
            titled: width >= 230.0 && tall >= 5.0 * font,
            font,
        }
    }

    /// Width of the labels with the gap before them.
    fn labels(&self) -> f32 {
        let widths = self.ticks.iter().map(|tick| tick.label.width_em());
        self.font * (0.5 + widths.fold(0.0, f32::max))
    }

    fn thickness(&self) -> f32 {
        1.1 * self.font
    }

    /// Width of everything right of the picture, the gap included.
    pub fn width(&self) -> f32 {
        let title = if self.titled { 1.1 * LINE_HEIGHT } else { 0.0 };
        self.font * (1.0 + title) + self.thickness() + self.labels()
    }

    /// Draws it right of a picture with this upper right and lower right corner. `title` is in the markup of
    /// [`crate::figure::text`].
    pub fn draw(
        &self,
        drawing: &mut Drawing,
        colors: &ColorScale,
        title: &str,
        [[x, top], [_, bottom]]: [Point; 2],
    ) {
        let font = self.font;
        let left = x + font;
        let right = left + self.thickness();
        let corners = [[left, top], [right, bottom]];
        let map = colors.map();
        let rgba: Vec<u8> = (0..STEPS)
            .rev()
            .flat_map(|k| {
                let [r, g, b] = map.color(k as f64 / (STEPS - 1) as f64);
                [r, g, b, 255]
            })
            .collect();
        drawing.items.push(Item::Image(Picture {
            min: corners[0],
            max: corners[1],
            width: 1,
            height: STEPS,
            rgba: rgba.into(),
            smooth: true,
        }));
        let ink = Ink::from(Role::Muted).faded(0.8);
        drawing.line(rectangle(corners), 1.0, ink);
        for tick in &self.ticks {
            let y = bottom - (bottom - top) * tick.position as f32;
            drawing.line(vec![[right, y], [right + 3.0, y]], 1.0, ink);
            let at = [right + 0.5 * font, y];
            let label = Label::new(tick.label.clone(), at, Anchor::LEFT, font, Role::Muted);
            drawing.items.push(Item::Text(label));
        }
        if self.titled {
            let at = [
                right + self.labels() + 0.6 * LINE_HEIGHT * font,
                0.5 * (top + bottom),
            ];
            let name = RichText::parse(title);
            let mut label = Label::new(name, at, Anchor::CENTER, font, Role::Foreground);
            label.angle = -FRAC_PI_2;
            drawing.items.push(Item::Text(label));
        }
    }
}

/// The outline of a rectangle between two corners, closed.
pub(super) fn rectangle([a, b]: [Point; 2]) -> Vec<Point> {
    vec![a, [b[0], a[1]], b, [a[0], b[1]], a]
}

/// Width of the key of what is hatched, in units of the font size.
pub fn key_width_em(missing: &str) -> f32 {
    RichText::literal(missing).width_em() + 1.8
}

/// Draws a small hatched box and what it means, from its left end on.
pub fn draw_key(drawing: &mut Drawing, missing: &str, at: Point, font: f32) {
    let (width, half) = (1.4 * font, 0.4 * font);
    let corners = [[at[0], at[1] - half], [at[0] + width, at[1] + half]];
    let ink = Ink::from(Role::Muted).faded(0.9);
    for k in 1..4 {
        let x = at[0] + width * k as f32 / 4.0;
        let lean = half.min(0.25 * width);
        drawing.line(
            vec![[x - lean, at[1] + half], [x + lean, at[1] - half]],
            1.0,
            ink,
        );
    }
    drawing.line(rectangle(corners), 1.0, ink);
    let name = RichText::literal(missing);
    let label = Label::new(
        name,
        [at[0] + width + 0.4 * font, at[1]],
        Anchor::LEFT,
        font,
        Role::Muted,
    );
    drawing.items.push(Item::Text(label));
}
