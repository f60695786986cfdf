//! Trace of a fit: E over evaluations, stage after stage.

use super::drawing::{Anchor, Drawing, Item, Label, Point};
use super::palette::{Ink, Role};
use super::placing::Placing;
use super::scale::{number, whole};
use super::text::RichText;

/// A word of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TracePoint {
    /// Number of the stage, from 1.
    pub stage: usize,
    /// Evaluations of this stage so far.
    pub evaluations: usize,
    /// E, 1 for 100 %.
    pub error: f64,
    /// Whether E is over all cells; estimated on a part of them otherwise, and drawn lighter.
    pub all_cells: bool,
}

/// Settings and data of a trace.
#[derive(Clone, Copy, Debug)]
pub struct TraceSpec<'a> {
    /// Points in the order in which they were reported.
    pub points: &'a [TracePoint],
    /// The material, which gives the colour.
    pub series: usize,
}

/// Opacity of what is estimated.
const ESTIMATED: f32 = 0.45;
/// Marks and ends of the logarithmic axis of E, within a decade.
const ROUND: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 5.0, 7.0];
/// E below this share of the highest is drawn at the bottom: an exact fit has no place on a logarithmic axis.
const DEEPEST: f64 = 1e-4;
const FONT: f32 = 10.5;

/// Draws a trace into `size` points; nothing where no point has an E.
pub fn draw(spec: &TraceSpec, size: [f32; 2]) -> Drawing {
    let mut canvas = TraceCanvas::new(size);
    let points = laid_out(spec.points);
    if points.is_empty() {
        return canvas.drawing;
    }
    let view = TraceView::of(&points, &canvas);
    canvas.frame();
    axes(&mut canvas, &view);
    stages(&mut canvas, &view, &points);
    curve(&mut canvas, &view, &points, spec.series);
    canvas.drawing
}

/// A point with its place on the axes.
struct Placed {
    stage: usize,
    /// Evaluations of all stages so far.
    x: f64,
    /// E in percent.
    percent: f64,
    all_cells: bool,
}

/// Counts evaluations on from stage to stage.
fn laid_out(points: &[TracePoint]) -> Vec<Placed> {
    let (mut before, mut last): (usize, Option<&TracePoint>) = (0, None);
    let mut placed = Vec::new();
    for point in points.iter().filter(|point| point.error.is_finite()) {
        if let Some(last) = last.filter(|last| last.stage != point.stage) {
            before += last.evaluations;
        }
        last = Some(point);
        placed.push(Placed {
            stage: point.stage,
            x: (before + point.evaluations) as f64,
            percent: 100.0 * point.error.max(0.0),
            all_cells: point.all_cells,
        });
    }
    placed
}

/// The ends of both axes, and where values are on the canvas.
struct TraceView {
    last: f64,
    low: f64,
    high: f64,
    corners: [Point; 2],
}

impl TraceView {
    fn of(points: &[Placed], canvas: &TraceCanvas) -> Self {
        let most = points.iter().map(|p| p.percent).fold(0.0, f64::max);
        let most = if most > 0.0 { most } else { 1.0 };
        let least = points.iter().map(|p| p.percent).fold(most, f64::min);
        let high = round_above(most);
        let mut low = round_below(least.max(DEEPEST * high));
        while high < 1.9 * low {
            low = round_below(0.999 * low);
        }
        Self {
            last: points.last().map_or(1.0, |point| point.x.max(1.0)),
            low,
            high,
            corners: [[canvas.left, canvas.top], [canvas.right, canvas.bottom]],
        }
    }

    fn x(&self, evaluations: f64) -> f32 {
        let [[left, _], [right, _]] = self.corners;
        left + (right - left) * (evaluations / self.last).clamp(0.0, 1.0) as f32
    }

    fn y(&self, percent: f64) -> f32 {
        let [[_, top], [_, bottom]] = self.corners;
        let share = (percent.max(self.low) / self.low).ln() / (self.high / self.low).ln();
        bottom - (bottom - top) * share.min(1.0) as f32
    }
}

/// Round values of the axis of E around this decade, ascending.
fn round_values(around: f64) -> impl Iterator<Item = f64> {
    let decade = whole(around.log10().floor());
    (decade - 1..=decade + 1).flat_map(|exponent| ROUND.map(|digit| digit * 10f64.powi(exponent)))
}

fn round_above(value: f64) -> f64 {
    round_values(value)
        .find(|round| *round >= value * (1.0 - 1e-9))
        .unwrap_or(value)
}

fn round_below(value: f64) -> f64 {
    round_values(value)
        .filter(|round| *round <= value * (1.0 + 1e-9))
        .last()
        .unwrap_or(value)
}

fn axes(canvas: &mut TraceCanvas, view: &TraceView) {
    canvas.text(
        "E [%], log",
        [canvas.left, 0.5 * canvas.top],
        Anchor::LEFT,
        Role::Muted,
    );
    // The ends first, then the roundest where there is room.
    let mut marks = vec![view.low, view.high];
    let decades = whole(view.low.log10().floor())..=whole(view.high.log10().ceil());
    for digits in [&[1.0][..], &[5.0, 2.0], &[3.0, 7.0, 1.5]] {
        for exponent in decades.clone() {
            marks.extend(digits.iter().map(|digit| digit * 10f64.powi(exponent)));
        }
    }
    for mark in marks {
        if !(view.low..=view.high).contains(&mark) {
            continue;
        }
        let y = view.y(mark);
        let label = canvas.label(
            &number(mark),
            [canvas.left - 5.0, y],
            Anchor::RIGHT,
            Role::Muted,
        );
        if canvas.placing.try_place(&mut canvas.drawing, label) {
            let line = vec![[canvas.left, y], [canvas.right, y]];
            canvas
                .drawing
                .line(line, 1.0, Ink::from(Role::Faint).faded(0.6));
        }
    }
    let below = canvas.bottom + 0.8 * FONT;
    canvas.text("0", [canvas.left, below], Anchor::CENTER, Role::Muted);
    let last = [canvas.right, below];
    let count = format!("{} evaluations", view.last);
    canvas.text(&count, last, Anchor::RIGHT, Role::Muted);
}

/// A line where a stage begins, and its number.
fn stages(canvas: &mut TraceCanvas, view: &TraceView, points: &[Placed]) {
    let mut begin = 0.0;
    for stage in points.chunk_by(|a, b| a.stage == b.stage) {
        let end = stage.last().map_or(begin, |point| point.x);
        let (left, right) = (view.x(begin), view.x(end));
        if begin > 0.0 {
            let line = vec![[left, canvas.top], [left, canvas.bottom]];
            canvas
                .drawing
                .dashed_line(line, 1.0, Some([2.0, 3.0]), Role::Muted.into());
        }
        let label = canvas.label(
            &stage[0].stage.to_string(),
            [0.5 * (left + right), canvas.top + 0.75 * FONT],
            Anchor::CENTER,
            Role::Muted,
        );
        // A stage of a few evaluations is narrower than its number; the number stands over it all the same.
        canvas.placing.try_place(&mut canvas.drawing, label);
        begin = end;
    }
}

fn curve(canvas: &mut TraceCanvas, view: &TraceView, points: &[Placed], series: usize) {
    let ink = Ink::from(Role::Series(series));
    let at = |point: &Placed| [view.x(point.x), view.y(point.percent)];
    let mut line: Vec<Point> = Vec::new();
    let mut exact = true;
    for pair in points.windows(2) {
        let both = pair[0].all_cells && pair[1].all_cells;
        if line.is_empty() || both != exact {
            let last = line.last().copied();
            canvas
                .drawing
                .line(std::mem::take(&mut line), 1.6, faded(ink, exact));
            line.push(last.unwrap_or_else(|| at(&pair[0])));
            exact = both;
        }
        let next = at(&pair[1]);
        // Thousands of words in a few hundred points: what cannot be told apart is left out.
        let near = |p: &Point| (p[0] - next[0]).abs() < 0.4 && (p[1] - next[1]).abs() < 0.4;
        if !line.last().is_some_and(near) {
            line.push(next);
        }
    }
    canvas.drawing.line(line, 1.6, faded(ink, exact));
    if let Some(last) = points.last() {
        canvas.drawing.items.push(Item::Dot {
            center: at(last),
            radius: 3.0,
            ink,
            outline: Some((1.0, Role::Background.into())),
        });
    }
}

fn faded(ink: Ink, exact: bool) -> Ink {
    ink.faded(if exact { 1.0 } else { ESTIMATED })
}

/// The drawing and the rectangle of the plot in it.
struct TraceCanvas {
    drawing: Drawing,
    placing: Placing,
    left: f32,
    right: f32,
    top: f32,
    bottom: f32,
}

impl TraceCanvas {
    fn new(size: [f32; 2]) -> Self {
        Self {
            drawing: Drawing::new(size),
            placing: Placing::default(),
            left: 3.0 * FONT,
            right: size[0] - 0.6 * FONT,
            top: 1.5 * FONT,
            bottom: (size[1] - 1.6 * FONT).max(2.0 * FONT),
        }
    }

    fn frame(&mut self) {
        let corners = vec![
            [self.left, self.top],
            [self.left, self.bottom],
            [self.right, self.bottom],
        ];
        self.drawing.line(corners, 1.0, Role::Muted.into());
    }

    fn label(&self, text: &str, pos: Point, anchor: Anchor, role: Role) -> Label {
        Label::new(RichText::parse(text), pos, anchor, FONT, role)
    }

    fn text(&mut self, text: &str, pos: Point, anchor: Anchor, role: Role) {
        let label = self.label(text, pos, anchor, role);
        self.placing.place(&mut self.drawing, label);
    }
}

#[cfg(test)]
mod tests;
