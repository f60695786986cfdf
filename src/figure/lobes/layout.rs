//! Layout of a lobe plot in its rectangle: the half disc as large as title and legend leave it.

use super::LobeSpec;
use crate::figure::drawing::{LINE_HEIGHT, Point, font_size};
use crate::figure::legend::{SWATCH_EM, listed};
use crate::figure::scale::RadialScale;
use crate::figure::subject::Subject;
use crate::figure::text::{RichText, elided};

/// Places and sizes in points.
pub(super) struct LobeLayout {
    /// Font size.
    pub font: f32,
    /// Middle of the surface line.
    pub origin: Point,
    /// Radius of the half disc in points.
    pub radius: f32,
    /// Title, and the left end of its text.
    pub title: (RichText, Point),
    /// One entry per subject: its position in the list, its name, the left end of its line.
    pub legend: Vec<(usize, RichText, Point)>,
}

impl LobeLayout {
    pub(super) fn new(
        spec: &LobeSpec,
        scale: RadialScale,
        subjects: &[Subject],
        [width, height]: [f32; 2],
    ) -> Self {
        let font = font_size([width, height]);
        let pad = 0.7 * font;
        let line = LINE_HEIGHT * font;
        let title = title(spec, scale, (width - 2.0 * pad) / font);
        let named = |share: f32| -> Vec<RichText> {
            let room_em = ((share * width - 2.0 * pad) / font - SWATCH_EM).clamp(3.0, 24.0);
            listed(subjects)
                .map(|(_, subject)| elided(&subject.label, room_em))
                .collect()
        };
        let names = named(0.5);
        let entry = |name: &RichText| font * (SWATCH_EM + name.width_em());
        let title_width = font * title.width_em();
        let legend_width = names.iter().map(entry).fold(0.0, f32::max);

        // Around the half disc: angles outside its rim, values below its surface line.
        let (rim, below) = (2.2 * font, 1.7 * font + pad);
        let widest = 0.5 * width - rim - 0.4 * pad;
        // In the corners: title at the left, legend at the right, as far as the disc leaves them free.
        let in_corners = {
            let blocks = [
                (title_width, line),
                (legend_width, line * names.len() as f32),
            ];
            let fits = |r: f32| {
                let center_y = height - below;
                blocks.iter().all(|(w, h)| {
                    let (dx, dy) = (0.5 * width - pad - w, center_y - pad - h);
                    *h == 0.0 || dx > 0.0 && dx.hypot(dy.max(0.0)) >= r + rim
                })
            };
            largest(widest.min(height - below - rim - 0.4 * pad), fits)
        };
        // In rows above the disc.
        let one_row =
            title_width + names.iter().map(entry).sum::<f32>() + 2.0 * font * (names.len() as f32)
                <= width - 2.0 * pad;
        // In rows of its own a name has more room.
        let long_names = named(1.0);
        let rows = if one_row { 1 } else { 1 + names.len() };
        let in_rows = widest.min(height - below - rim - pad - line * rows as f32);

        let corners = in_corners + 0.5 >= in_rows;
        let radius = in_corners.max(in_rows).max(8.0);
        let top = if corners {
            rim + 0.4 * pad
        } else {
            pad + line * rows as f32 + rim
        };
        // What is left over goes above and below alike.
        let slack = (height - below - top - radius).max(0.0) * 0.5;
        // Texts in the corners stay at the top until that is far from the disc.
        let lowered = if corners {
            (slack - 4.0 * font).max(0.0)
        } else {
            slack
        };
        let (left, first) = (pad, pad + 0.5 * line + lowered);

        let mut legend = Vec::new();
        let mut end = width - pad;
        let names = if corners || one_row {
            names
        } else {
            long_names
        };
        for (row, name) in names.into_iter().enumerate().rev() {
            let pos = if corners {
                [width - pad - legend_width, first + line * row as f32]
            } else if one_row {
                end -= entry(&name);
                let pos = [end, first];
                end -= 2.0 * font;
                pos
            } else {
                [left, first + line * (row + 1) as f32]
            };
            legend.push((row, name, pos));
        }
        legend.reverse();
        for (entry, (index, _)) in legend.iter_mut().zip(listed(subjects)) {
            entry.0 = index;
        }
        Self {
            font,
            origin: [0.5 * width, top + slack + radius],
            radius,
            title: (title, [left, first]),
            legend,
        }
    }
}

/// Title: the quantity, its unit, the channel and the scale; without the lesser words where there is no room.
fn title(spec: &LobeSpec, scale: RadialScale, room_em: f32) -> RichText {
    let mut what = format!("f_{{r}}{}", spec.cosine.markup());
    what += if spec.shape_only {
        " / its maximum"
    } else {
        " [sr^{−1}]"
    };
    let (channel, scale) = (spec.channel.name(), scale.phrase());
    let long = RichText::parse(&format!("{what}, {channel}, {scale} scale"));
    if long.width_em() <= room_em {
        return long;
    }
    RichText::parse(&format!("{what}, {channel}, {scale}"))
}

/// The largest radius up to `most` that `fits`, which small ones do sooner than large ones.
fn largest(most: f32, fits: impl Fn(f32) -> bool) -> f32 {
    if most <= 0.0 || fits(most) {
        return most;
    }
    let (mut low, mut high) = (0.0, most);
    for _ in 0..20 {
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}
