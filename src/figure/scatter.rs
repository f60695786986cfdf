//! Materials in the plane of the combined model's shape: α over s, one dot each. α = 0 is Phong, α = 1 Blinn-Phong.

mod panel;

pub use panel::ScatterSpec;

use super::drawing::{Drawing, Point};
use super::palette::{Ink, Role};
use super::plot::{Outline, Panel, Pen, Plot, PlotDot, PlotFrame};
use super::scale::{Axis, RadialScale, Steps};
use super::text::{RichText, elided};

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct ScatterDot {
    /// Display name.
    pub name: String,
    /// Exponent of the combined model, > 0.
    pub s: f64,
    /// Blend of the combined model, in [0, 1].
    pub alpha: f64,
    /// The dot's colour.
    pub fill: Role,
    /// The colour of the ring around it, if any.
    pub ring: Option<Role>,
    /// Whether it is the shown material: larger, over the others and named first.
    pub shown: bool,
}

/// Fewest decades of s.
const DECADES: f64 = 2.0;
/// α at the lower and upper edge: what is beyond 0 and 1 is room for words.
const EDGES: (f64, f64) = (-0.1, 1.1);
/// Largest distance in points at which the pointer still means a dot.
const NEAR: f32 = 14.0;
/// Longest name in units of the font size.
const NAME_EM: f32 = 14.0;

/// The plot with what is where in it.
#[derive(Clone, Debug)]
pub struct ScatterPlot {
    /// Picture of the plot.
    pub drawing: Drawing,
    /// Map between values and points of the drawing.
    pub frame: PlotFrame,
    /// Points of the dots, in the order of the list; `None` for what has no place on the axes.
    pub places: Vec<Option<Point>>,
}

impl ScatterPlot {
    /// A plot of `size` points; around all dots without ends of the axis of s.
    pub fn new(dots: &[ScatterDot], window: Option<[f64; 2]>, size: [f32; 2]) -> Self {
        let [from, to] = window.unwrap_or_else(|| ends(dots));
        let outline = Outline {
            title: vec![
                "α over s of the combined model".into(),
                "α over s, combined".into(),
            ],
            subjects: &[],
            x: Axis::between(RadialScale::Log, from, to),
            x_steps: Steps::Decimal,
            x_name: "s, log_{10}".into(),
            panels: vec![Panel {
                axis: Axis::between(RadialScale::Linear, EDGES.0, EDGES.1),
                height: 1.0,
                title: Vec::new(),
            }],
        };
        let mut plot = Plot::new(&outline, size);
        plot.axes();
        for (alpha, beyond, word) in [(0.0, EDGES.0, "Phong"), (1.0, EDGES.1, "Blinn-Phong")] {
            let pen = Pen {
                dash: Some([5.0, 4.0]),
                ..Pen::thin(Role::Muted.into())
            };
            plot.level(0, alpha, pen);
            let middle = 0.5 * (alpha + beyond);
            plot.tag(0, from, middle, &RichText::parse(word), Role::Muted);
        }
        let places = draw(&mut plot, dots);
        let frame = plot.frames[0];
        Self {
            drawing: plot.finish().0,
            frame,
            places,
        }
    }

    /// The position of the dot that is meant at a point: the nearest one, if it is near.
    pub fn dot_at(&self, point: Point) -> Option<usize> {
        let distance = |place: &Point| (place[0] - point[0]).hypot(place[1] - point[1]);
        let places = self.places.iter().enumerate();
        let nearest = places
            .filter_map(|(index, place)| Some((index, distance(place.as_ref()?))))
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        (nearest.1 <= NEAR).then_some(nearest.0)
    }
}

/// Dots, the rings behind them, and names. Gives back where the dots are.
fn draw(plot: &mut Plot, dots: &[ScatterDot]) -> Vec<Option<Point>> {
    let mut order: Vec<usize> = (0..dots.len()).collect();
    order.sort_by_key(|index| !dots[*index].shown);
    // The name keeps off the ring, where there is one.
    let mut spots: Vec<PlotDot> = Vec::new();
    let mut at = Vec::new();
    for dot in order.iter().map(|index| &dots[*index]) {
        at.push(spots.len());
        let spot = |wider: f32, ink: Ink, named: bool| PlotDot {
            x: dot.s,
            y: dot.alpha,
            radius: wider + if dot.shown { 6.0 } else { 4.5 },
            ink,
            name: if named {
                elided(&dot.name, NAME_EM)
            } else {
                RichText::default()
            },
        };
        spots.push(spot(0.0, dot.fill.into(), dot.ring.is_none()));
        spots.extend(dot.ring.map(|ring| spot(2.5, ring.into(), true)));
    }
    let drawn = plot.dots(0, &spots);
    let mut places = vec![None; dots.len()];
    for (index, at) in order.into_iter().zip(at) {
        places[index] = drawn[at];
    }
    places
}

/// Ends for the axis of s, with some room beyond all values: 1 to 1000 where there is none.
fn ends(dots: &[ScatterDot]) -> [f64; 2] {
    let logs = dots.iter().map(|dot| dot.s.log10());
    let (low, high) = logs
        .filter(|log| log.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), log| {
            (low.min(log), high.max(log))
        });
    if low > high {
        return [1.0, 1e3];
    }
    let half = (0.5 * (high - low) * 1.12 + 0.1).max(0.5 * DECADES);
    let middle = 0.5 * (low + high);
    [middle - half, middle + half].map(|log| 10f64.powf(log))
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
            ring: None,
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
        let plot = ScatterPlot::new(&dots, None, [600.0, 400.0]);
        // Two decades and 0.22 at each end, so that no dot lies on the frame.
        let PlotFrame { min, max, x, .. } = plot.frame;
        assert!((x.floor.log10() - 0.78).abs() < 1e-9 && (x.limit.log10() - 3.22).abs() < 1e-9);
        let share = |log: f32| (log - 0.78) / 2.44;
        let point = |across: f32, alpha: f32| {
            let up = (alpha + 0.1) / 1.2;
            let [width, height] = [max[0] - min[0], max[1] - min[1]];
            [min[0] + across * width, max[1] - up * height]
        };
        let near = |place: Option<Point>, b: Point| {
            let a = place.expect("it has a place");
            (a[0] - b[0]).hypot(a[1] - b[1]) < 0.01
        };
        assert!(near(plot.places[0], point(share(1.0), 0.0)));
        assert!(near(plot.places[1], point(share(3.0), 1.0)));
        assert!(near(plot.places[2], point(share(2.0), 0.25)));
        // Not the same on a linear axis, nor upside down.
        assert!(!near(plot.places[2], point(0.057, 0.25)));
        assert!(!near(plot.places[2], point(share(2.0), 0.75)));
        let [x, y] = point(share(3.0), 1.0);
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
        let plot = ScatterPlot::new(&dots, None, [300.0, 200.0]);
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
                let plot = ScatterPlot::new(&dots, None, size);
                assert!(
                    plot.places
                        .iter()
                        .flatten()
                        .flatten()
                        .all(|x| x.is_finite())
                );
            }
        }
    }
}
