//! Materials in the plane of the combined model's shape: α over s, one dot each. α = 0 is Phong, α = 1 Blinn-Phong.

use super::drawing::{Anchor, Drawing, Item, LINE_HEIGHT, Label, Point};
use super::palette::{Ink, Role};
use super::placing::Placing;
use super::scale::power_of_ten;
use super::text::{RichText, elided};

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct ScatterDot {
    /// Its name.
    pub name: String,
    /// Exponent of the combined model, > 0.
    pub s: f64,
    /// Blend of the combined model, in [0, 1].
    pub alpha: f64,
    /// The dot's colour.
    pub fill: Role,
    /// The rim's colour.
    pub rim: Role,
    /// Whether it is the shown material: larger, and named first.
    pub shown: bool,
}

/// Fewest decades of s.
const DECADES: i32 = 2;
/// How near in points a dot must be to be meant.
const NEAR: f32 = 14.0;

/// Where values are in the plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScatterFrame {
    /// Upper left corner in points of the drawing: the smallest s, α = 1.
    pub min: Point,
    /// Lower right corner: the largest s, α = 0.
    pub max: Point,
    /// Powers of ten of s at the left and at the right.
    pub decades: (i32, i32),
}

impl ScatterFrame {
    /// The point of a pair of values; those outside are at the edge.
    pub fn at(&self, s: f64, alpha: f64) -> Point {
        let (from, to) = (f64::from(self.decades.0), f64::from(self.decades.1));
        let x = ((s.max(1e-300).log10() - from) / (to - from)).clamp(0.0, 1.0);
        let y = 1.0 - alpha.clamp(0.0, 1.0);
        [
            self.min[0] + (self.max[0] - self.min[0]) * x as f32,
            self.min[1] + (self.max[1] - self.min[1]) * y as f32,
        ]
    }
}

/// The plot with what is where in it.
#[derive(Clone, Debug)]
pub struct ScatterPlot {
    /// What is painted.
    pub drawing: Drawing,
    /// Where values are.
    pub frame: ScatterFrame,
    /// Where the dots are, in the order of the list.
    pub places: Vec<Point>,
}

impl ScatterPlot {
    /// A plot of `size` points.
    pub fn new(dots: &[ScatterDot], size: [f32; 2]) -> Self {
        let [width, height] = size;
        let font = (width.min(1.4 * height) / 38.0).clamp(9.5, 14.0);
        let line = LINE_HEIGHT * font;
        // A line for the words beyond α = 0 and 1, and one each for title, numbers and name of s.
        let frame = ScatterFrame {
            min: [4.0 * font, 2.4 * line],
            max: [
                (width - 1.2 * font).max(5.0 * font),
                (height - 3.6 * line).max(3.4 * line),
            ],
            decades: decades(dots),
        };
        let mut sheet = Sheet {
            drawing: Drawing::new(size),
            placing: Placing::default(),
            font,
        };
        sheet.axes(&frame, line);
        let places: Vec<Point> = dots.iter().map(|dot| frame.at(dot.s, dot.alpha)).collect();
        sheet.dots(dots, &places, &frame);
        Self {
            drawing: sheet.drawing,
            frame,
            places,
        }
    }

    /// The position of the dot that is meant at a point: the nearest one, if it is near.
    pub fn dot_at(&self, point: Point) -> Option<usize> {
        let distance = |place: &Point| (place[0] - point[0]).hypot(place[1] - point[1]);
        let nearest = self
            .places
            .iter()
            .map(distance)
            .enumerate()
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        (nearest.1 <= NEAR).then_some(nearest.0)
    }
}

/// Whole decades that hold every s: 1 to 1000 where there is none.
fn decades(dots: &[ScatterDot]) -> (i32, i32) {
    let logs = dots.iter().map(|dot| dot.s.max(1e-300).log10());
    let (low, high) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), log| {
        (low.min(log), high.max(log))
    });
    if !(low.is_finite() && high.is_finite()) {
        return (0, 3);
    }
    let (from, to) = ((low - 0.05).floor() as i32, (high + 0.05).ceil() as i32);
    (from, to.max(from + DECADES))
}

/// A drawing in the making.
struct Sheet {
    drawing: Drawing,
    placing: Placing,
    font: f32,
}

impl Sheet {
    fn label(&self, text: RichText, pos: Point, anchor: Anchor, role: Role) -> Label {
        Label {
            text,
            pos,
            anchor,
            angle: 0.0,
            size: self.font,
            ink: role.into(),
            halo: false,
        }
    }

    fn place(&mut self, markup: &str, pos: Point, anchor: Anchor) {
        let label = self.label(RichText::parse(markup), pos, anchor, Role::Muted);
        self.placing.place(&mut self.drawing, label);
    }

    fn axes(&mut self, frame: &ScatterFrame, line: f32) {
        let ([left, top], [right, bottom]) = (frame.min, frame.max);
        let (grid, font) = (Ink::from(Role::Faint), self.font);
        let (over, under) = (top - 0.9 * line, bottom + 0.9 * line);
        for alpha in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let y = frame.at(1.0, alpha)[1];
            let strong = alpha == 0.0 || alpha == 1.0;
            let (width, dash) = if strong {
                (1.2, Some([5.0, 4.0]))
            } else {
                (1.0, None)
            };
            let ink = if strong {
                Role::Muted.into()
            } else {
                grid.faded(0.7)
            };
            self.drawing
                .dashed_line(vec![[left, y], [right, y]], width, dash, ink);
            let text = format!("{alpha}");
            self.place(&text, [left - 0.5 * font, y], Anchor::RIGHT);
        }
        let (from, to) = frame.decades;
        for decade in from..=to {
            let x = frame.at(10f64.powi(decade), 0.0)[0];
            self.drawing
                .line(vec![[x, over], [x, under]], 1.0, grid.faded(0.7));
            let text = power_of_ten(10f64.powi(decade));
            self.place(&text, [x, under + 0.6 * line], Anchor::CENTER);
            for digit in (2..10).filter(|_| decade < to) {
                let x = frame.at(f64::from(digit) * 10f64.powi(decade), 0.0)[0];
                let tick = vec![[x, under], [x, under - 4.0]];
                self.drawing
                    .line(tick, 1.0, Ink::from(Role::Muted).faded(0.6));
            }
        }
        let outline = vec![[left, over], [left, under], [right, under]];
        self.drawing
            .line(outline, 1.0, Ink::from(Role::Muted).faded(0.8));
        let words = [
            (over + 0.4 * line, "Blinn-Phong"),
            (under - 0.45 * line, "Phong"),
        ];
        for (y, word) in words {
            self.place(word, [left + 0.5 * font, y], Anchor::LEFT);
        }
        let title = [0.6 * font, 0.7 * line];
        self.place("α over s of the combined model", title, Anchor::LEFT);
        let name = [0.5 * (left + right), under + 1.75 * line];
        self.place("s, log_{10}", name, Anchor::CENTER);
        self.place("α", [0.9 * font, 0.5 * (top + bottom)], Anchor::LEFT);
    }

    /// The dots, the shown one over all, then the names where there is room.
    fn dots(&mut self, dots: &[ScatterDot], places: &[Point], frame: &ScatterFrame) {
        let mut order: Vec<usize> = (0..dots.len()).collect();
        order.sort_by_key(|index| dots[*index].shown);
        for index in &order {
            let dot = &dots[*index];
            let radius = if dot.shown { 6.5 } else { 4.5 };
            self.placing.keep_free(places[*index], radius);
            self.drawing.items.push(Item::Dot {
                center: places[*index],
                radius,
                ink: dot.fill.into(),
                outline: Some((if dot.shown { 2.0 } else { 1.2 }, dot.rim.into())),
            });
        }
        for index in order.iter().rev() {
            self.name(&dots[*index], places[*index], frame);
        }
    }

    fn name(&mut self, dot: &ScatterDot, at: Point, frame: &ScatterFrame) {
        let gap = 8.0 + 0.2 * self.font;
        let text = elided(&dot.name, 14.0);
        for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
            let pos = [at[0] + gap * dx, at[1] + gap * dy];
            let anchor = Anchor::towards(-dx, -dy);
            let mut label = self.label(text.clone(), pos, anchor, Role::Foreground);
            label.size *= 0.9;
            label.halo = true;
            let inside = label.bounds()[0][0] >= frame.min[0];
            if inside && self.placing.try_place(&mut self.drawing, label) {
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(name: &str, s: f64, alpha: f64) -> ScatterDot {
        ScatterDot {
            name: name.into(),
            s,
            alpha,
            fill: Role::Fixed([200, 10, 10]),
            rim: Role::Muted,
            shown: false,
        }
    }

    #[test]
    fn dots_are_where_their_values_are() {
        let dots = [
            dot("a", 10.0, 0.0),
            dot("b", 1000.0, 1.0),
            dot("c", 100.0, 0.25),
        ];
        let plot = ScatterPlot::new(&dots, [600.0, 400.0]);
        let ScatterFrame { min, max, decades } = plot.frame;
        // Ends on a decade get one more, so that no dot lies on the frame.
        assert_eq!(decades, (0, 4));
        let across = |share: f32| min[0] + share * (max[0] - min[0]);
        let near = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]) < 0.01;
        assert!(near(plot.places[0], [across(0.25), max[1]]));
        assert!(near(plot.places[1], [across(0.75), min[1]]));
        let quarter = max[1] - 0.25 * (max[1] - min[1]);
        assert!(near(plot.places[2], [across(0.5), quarter]));
        // Not the same on a linear axis, nor upside down.
        assert!(!near(plot.places[2], [across(0.1), quarter]));
        assert_eq!(plot.dot_at(plot.places[1]), Some(1));
        let [x, y] = plot.places[1];
        assert_eq!(plot.dot_at([x + 9.0, y + 9.0]), Some(1));
        assert_eq!(plot.dot_at([x + 12.0, y + 12.0]), None);
        let drawn = |text: &str| {
            plot.drawing
                .labels()
                .any(|label| label.text.plain() == text)
        };
        assert!(
            ["a", "b", "c", "Phong", "Blinn-Phong"]
                .into_iter()
                .all(drawn)
        );
    }

    #[test]
    fn names_that_would_meet_are_left_out_but_the_shown_one() {
        let mut dots: Vec<ScatterDot> = (0..40)
            .map(|k| {
                dot(
                    &format!("a material with a name {k}"),
                    50.0 + 0.1 * f64::from(k),
                    0.5,
                )
            })
            .collect();
        dots[7].shown = true;
        let plot = ScatterPlot::new(&dots, [300.0, 200.0]);
        let names: Vec<String> = plot
            .drawing
            .labels()
            .map(|label| label.text.plain())
            .filter(|text| text.starts_with("a mat"))
            .collect();
        assert!(!names.is_empty() && names.len() < 10, "{names:?}");
        assert!(
            names[0].ends_with('7') || names[0].contains('…'),
            "{names:?}"
        );
        assert_eq!(plot.places.len(), 40);
    }

    #[test]
    fn nothing_and_nonsense_are_drawn_too() {
        for dots in [vec![], vec![dot("x", f64::NAN, 2.0), dot("y", 1e300, -1.0)]] {
            for size in [[300.0, 200.0], [10.0, 10.0]] {
                let plot = ScatterPlot::new(&dots, size);
                assert!(plot.places.iter().flatten().all(|x| x.is_finite()));
            }
        }
    }
}
