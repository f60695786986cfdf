//! Layout of a plot in its rectangle: title and legend above, numbers at the left and below, panels in what is left.

use super::outline::{Outline, Panel};
use crate::figure::drawing::{LINE_HEIGHT, Point, font_size};
use crate::figure::legend::{SWATCH_EM, listed};
use crate::figure::scale::{Axis, Steps, Ticks};
use crate::figure::subject::Subject;
use crate::figure::text::{RichText, elided};

/// Places and sizes in points.
pub(super) struct PlotLayout {
    pub font: f32,
    /// Title, and the left end of its text.
    pub title: (RichText, Point),
    /// One entry per subject: its position in the list, its name, the left end of its line.
    pub legend: Vec<(usize, RichText, Point)>,
    pub left: f32,
    pub right: f32,
    pub panels: Vec<PanelPlace>,
    pub x_marks: Ticks,
    /// Names below the horizontal axis in place of numbers.
    pub x_names: Option<NamesBelow>,
    /// Middle of the line with the numbers of x.
    pub numbers_y: f32,
    /// Middle of the line with the name of x; the numbers' own where there is no room for another.
    pub name_y: f32,
}

/// Names below an axis: upright where they are too long to lie beside each other.
pub(super) struct NamesBelow {
    /// Names, from left to right.
    pub names: Vec<RichText>,
    /// Size of the letters in points.
    pub size: f32,
    /// Height in points of all: the length of the longest where they are upright.
    pub height: f32,
    /// Whether they read upwards.
    pub upright: bool,
}

/// A panel's place.
pub(super) struct PanelPlace {
    /// Title of the panel, and the left end of its text.
    pub title: Option<(RichText, Point)>,
    pub top: f32,
    pub bottom: f32,
    pub marks: Ticks,
}

/// Between a number and its axis, in units of the font size: beside and below it. Below it is more, as the lowest number
/// beside it stands half lower than the axis.
pub(super) const NUMBER_GAP_EM: f32 = 0.45;
const BELOW_GAP_EM: f32 = 0.68;
/// Between the middles of the two lines below, in lines.
const LINE_STEP: f32 = 1.04;
/// A plot lower than this has the name of x beside its numbers.
const ROOMY: f32 = 240.0;
/// Size of the names below in units of the font size, at most, and in points at least: smaller ones are left out.
const NAMES_EM: f32 = 0.9;
const SMALLEST_NAMES: f32 = 5.0;
/// The largest share of the height that names below take, and of the distance between two that letters do.
const NAMES_SHARE: f32 = 0.3;
const NAMES_FILL: f32 = 0.85;
/// Least room in units of the font size between two names that lie.
const NAMES_APART: f32 = 1.0;
/// The largest share of the height that names in the legend take before they are cut shorter.
const LEGEND_SHARE: f32 = 0.3;

impl PlotLayout {
    pub(super) fn new(outline: &Outline, [width, height]: [f32; 2]) -> Self {
        let font = font_size([width, height]);
        let pad = 0.6 * font;
        let line = LINE_HEIGHT * font;
        let title = first_fitting(&outline.title, (width - 2.0 * pad) / font);
        let title_width = font * title.width_em();
        let first = pad + 0.5 * line;
        let (legend, rows) = legend(outline.subjects, font, [width, height], title_width);
        let top = pad + line * (1 + rows) as f32 + 0.6 * line;

        let below = if height >= ROOMY { 1.0 } else { 0.0 };
        let x_names = names_below(outline, font, [width, height]);
        // The names stand where the line of numbers would.
        let names = x_names.as_ref().map_or(0.0, |below| below.height - line);
        let bottom =
            height - 0.4 * pad - line * (1.0 + LINE_STEP * below) - BELOW_GAP_EM * font - names;
        let titles = outline.panels.iter().skip(1).map(|panel| {
            let named = !panel.title.is_empty();
            line * if named { 1.35 } else { 0.6 }
        });
        let room = (bottom - top - titles.clone().sum::<f32>()).max(0.0);
        let total: f32 = outline.panels.iter().map(|panel| panel.height).sum();
        let mut panels = Vec::new();
        let mut y = top;
        let gaps: Vec<f32> = std::iter::once(0.0).chain(titles).collect();
        for (panel, gap) in outline.panels.iter().zip(gaps) {
            y += gap;
            let high = (room * panel.height / total.max(1e-3)).max(4.0);
            panels.push(place(panel, y, high, font));
            y += high;
        }
        let number = |place: &PanelPlace| {
            let widths = place.marks.major.iter();
            widths.map(|tick| tick.label.width_em()).fold(0.0, f32::max)
        };
        let widest = panels.iter().map(number).fold(1.2, f32::max);
        let left = pad + font * (widest + NUMBER_GAP_EM + 0.3);
        let right = (width - 1.6 * pad).max(left + 4.0);
        for (place, panel) in panels.iter_mut().zip(&outline.panels) {
            if !panel.title.is_empty() {
                let text = first_fitting(&panel.title, (right - left) / font);
                place.title = Some((text, [left, place.top - 0.6 * line]));
            }
        }
        let x_marks = match &x_names {
            Some(below) => marks_of_names(&outline.x, below.names.len()),
            None => outline.x.marks(right - left, 4.2 * font, outline.x_steps),
        };
        let end = panels.last().map_or(bottom, |place| place.bottom);
        let numbers_y = end + BELOW_GAP_EM * font + 0.5 * line + names;
        Self {
            font,
            title: (title, [pad, first]),
            legend,
            left,
            right,
            panels,
            x_marks,
            x_names,
            numbers_y,
            name_y: numbers_y + LINE_STEP * line * below,
        }
    }
}

/// The names below a plot, where they are wanted and there is room for them.
fn names_below(outline: &Outline, font: f32, [width, height]: [f32; 2]) -> Option<NamesBelow> {
    let apart = width / (outline.x.limit - outline.x.floor).max(1.0) as f32;
    let size = (NAMES_EM * font).min(NAMES_FILL * apart / LINE_HEIGHT);
    if outline.x_names.is_empty() || size < SMALLEST_NAMES {
        return None;
    }
    let most = NAMES_SHARE * height / size;
    let names = outline.x_names.iter().map(|name| elided(name, most));
    let names: Vec<RichText> = names.collect();
    let longest = names.iter().map(RichText::width_em).fold(0.0, f32::max);
    let upright = size * (longest + NAMES_APART) > apart;
    Some(NamesBelow {
        names,
        size,
        height: if upright {
            size * longest
        } else {
            LINE_HEIGHT * font
        },
        upright,
    })
}

/// Marks at 1, 2, … for names.
fn marks_of_names(axis: &Axis, count: usize) -> Ticks {
    let ends = 0.0..=1.0;
    Ticks {
        major: Vec::new(),
        minor: (1..=count)
            .map(|k| axis.share(k as f64))
            .filter(|share| ends.contains(share))
            .collect(),
    }
}

fn place(panel: &Panel, top: f32, height: f32, font: f32) -> PanelPlace {
    PanelPlace {
        title: None,
        top,
        bottom: top + height,
        marks: panel.axis.marks(height, 1.9 * font, Steps::Decimal),
    }
}

/// The first of the texts that is no wider, else the last.
fn first_fitting(texts: &[String], room_em: f32) -> RichText {
    let mut parsed = texts.iter().map(|text| RichText::parse(text));
    let fitting = parsed.clone().find(|text| text.width_em() <= room_em);
    fitting.or_else(|| parsed.next_back()).unwrap_or_default()
}

/// Names with their places, and how many rows of their own they have: none where they fit behind the title.
fn legend(
    subjects: &[Subject],
    font: f32,
    [width, height]: [f32; 2],
    title_width: f32,
) -> (Vec<(usize, RichText, Point)>, usize) {
    let pad = 0.6 * font;
    let line = LINE_HEIGHT * font;
    let (gap, end) = (1.6 * font, width - pad);
    let room_em = ((end - pad) / font - SWATCH_EM).max(3.0);
    let names = |most: f32| -> Vec<RichText> {
        listed(subjects)
            .map(|(_, subject)| elided(&subject.label, room_em.min(most)))
            .collect()
    };
    let entry = |name: &RichText| font * (SWATCH_EM + name.width_em());
    let whole = names(26.0);
    let total = whole.iter().map(|name| entry(name) + gap).sum::<f32>();
    if pad + title_width + total + gap <= end {
        let mut x = end - total + gap;
        let placed = listed(subjects).zip(whole).map(|((index, _), name)| {
            let at = [x, pad + 0.5 * line];
            x += entry(&name) + gap;
            (index, name, at)
        });
        return (placed.collect(), 0);
    }
    let mut placed = Vec::new();
    let mut rows = 0;
    for most in [26.0, 16.0, 10.0, 6.0] {
        placed.clear();
        rows = 0;
        let mut x = f32::INFINITY;
        for ((index, _), name) in listed(subjects).zip(names(most)) {
            if x + entry(&name) > end {
                (x, rows) = (pad, rows + 1);
            }
            let at = [x, pad + line * (0.5 + rows as f32)];
            x += entry(&name) + gap;
            placed.push((index, name, at));
        }
        if line * rows as f32 <= LEGEND_SHARE * height {
            break;
        }
    }
    (placed, rows)
}
