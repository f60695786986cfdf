//! The plot: axes, dots, names. Where the model equals another, at an end of a blend say, a line bears that one's name.

use super::quantity::Quantity;
use super::spec::ScatterSpec;
use crate::figure::drawing::{Drawing, Point};
use crate::figure::palette::{Ink, Role};
use crate::figure::plot::{Outline, Panel, Pen, Plot, PlotDot, PlotFrame};
use crate::figure::scale::{Axis, RadialScale, Steps};
use crate::figure::text::{RichText, elided};

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct ScatterDot {
    /// Display name.
    pub name: String,
    /// Value along x; NaN where there is none.
    pub x: f64,
    /// Value along y; NaN where there is none.
    pub y: f64,
    /// The dot's colour.
    pub fill: Role,
    /// The colour of the ring around it, if any.
    pub ring: Option<Role>,
    /// Whether it is the shown material: larger, over the others and named first.
    pub shown: bool,
}

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
    /// A plot of `size` points.
    pub fn new(dots: &[ScatterDot], spec: &ScatterSpec, size: [f32; 2]) -> Self {
        let [x, y] = spec.rows();
        let over = format!("{} over {}", y.label(), x.label());
        let outline = Outline {
            title: vec![
                format!("{over} of the {} model", spec.model.word),
                format!("{over}, {}", spec.model.word),
            ],
            subjects: &[],
            x: x.axis(spec.window, dots.iter().map(|dot| dot.x)),
            x_steps: Steps::Decimal,
            x_names: Vec::new(),
            x_name: match x.scale {
                RadialScale::Linear => x.label(),
                scale => format!("{}, {}", x.label(), scale.phrase()),
            },
            panels: vec![Panel {
                axis: y.axis(spec.y_window, dots.iter().map(|dot| dot.y)),
                height: 1.0,
                title: Vec::new(),
            }],
        };
        let mut plot = Plot::new(&outline, size);
        plot.axes();
        contained(&mut plot, spec);
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

/// Lines where the model equals another one, with its name: beside the line, or between it and the end of the axis.
fn contained(plot: &mut Plot, spec: &ScatterSpec) {
    let frame = plot.frames[0];
    let pen = Pen {
        dash: Some([5.0, 4.0]),
        ..Pen::thin(Role::Muted.into())
    };
    for inner in spec.model.contains {
        // Models that are equal at a single value of one parameter.
        let (Some(row), [value]) = (spec.model.params.get(inner.factors.len()), inner.fixed) else {
            continue;
        };
        let [x, y] = spec.quantities().map(|one| one == Quantity::Param(row.id));
        let inside = |axis: &Axis| (0.0..=1.0).contains(&axis.share(*value));
        let name = RichText::parse(inner.model.name);
        if y && inside(&frame.y) {
            plot.level(0, *value, pen);
            let at = match value {
                low if *low == row.domain.0 => 0.5 * (low + frame.y.floor),
                high if *high == row.domain.1 => 0.5 * (high + frame.y.limit),
                between => *between,
            };
            plot.tag(0, frame.x.floor, at, &name, Role::Muted);
        }
        if x && inside(&frame.x) {
            plot.upright(*value, pen);
            plot.tag(0, *value, frame.y.limit, &name, Role::Muted);
        }
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
            x: dot.x,
            y: dot.y,
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

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(name: &str, x: f64, y: f64) -> ScatterDot {
        ScatterDot {
            name: name.into(),
            x,
            y,
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
        let plot = ScatterPlot::new(&dots, &ScatterSpec::default(), [600.0, 400.0]);
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
        let plot = ScatterPlot::new(&dots, &ScatterSpec::default(), [300.0, 200.0]);
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

    fn of_model(key: &str) -> ScatterSpec {
        ScatterSpec {
            model: crate::brdf::Model::by_key(key).expect("a model"),
            ..ScatterSpec::default()
        }
    }

    fn texts(plot: &ScatterPlot) -> Vec<String> {
        plot.drawing
            .labels()
            .map(|label| label.text.plain())
            .collect()
    }

    #[test]
    fn axes_and_words_are_those_of_the_rows() {
        let [low, high] = [dot("low", 0.01, 1.2), dot("high", 0.3, 2.4)];
        let plot = ScatterPlot::new(&[low, high], &of_model("ggx"), [600.0, 400.0]);
        let words = texts(&plot);
        assert!(
            words.contains(&"η over a of the GGX model".into()),
            "{words:?}"
        );
        assert!(!words.contains(&"Phong".into()), "{words:?}");
        assert_eq!(plot.frame.x.scale, RadialScale::Log);
        assert_eq!(plot.frame.y.scale, RadialScale::Linear);
        let [low, high] = [plot.places[0], plot.places[1]].map(|place| place.expect("a place"));
        assert!(low[0] < high[0] && low[1] > high[1]);
        // Along x its lines stand upright, and the words go with the axis.
        let turned = ScatterSpec {
            x: Some(Quantity::Param(crate::brdf::ParamId("alpha"))),
            y: Some(Quantity::Param(crate::brdf::ParamId("s"))),
            ..ScatterSpec::default()
        };
        let plot = ScatterPlot::new(&[dot("a", 1.0, 10.0)], &turned, [600.0, 400.0]);
        let words = texts(&plot);
        for word in ["Phong", "Blinn-Phong", "s over α of the combined model"] {
            assert!(words.contains(&word.into()), "{words:?}");
        }
        let inside = ScatterPlot::new(
            &[dot("a", 50.0, 0.7)],
            &of_model("lafortune"),
            [600.0, 400.0],
        );
        let words = texts(&inside);
        assert!(
            !words.contains(&"Phong".into()),
            "c_z = 1 is not in sight: {words:?}"
        );
        let around = [dot("a", 50.0, 0.7), dot("b", 50.0, 1.3)];
        let words = texts(&ScatterPlot::new(
            &around,
            &of_model("lafortune"),
            [600.0, 400.0],
        ));
        assert!(words.contains(&"Phong".into()), "{words:?}");
    }

    #[test]
    fn every_quantity_of_every_model_is_an_axis() {
        for model in crate::brdf::MODELS {
            let mut brdf = crate::brdf::Brdf::new(model, crate::brdf::Fresnel::Exact);
            brdf.params.k_s = [0.1, 4.0, 0.1];
            let all = Quantity::all(model);
            for (x, y) in all.iter().zip(all.iter().rev()) {
                let spec = ScatterSpec {
                    model,
                    x: Some(*x),
                    y: Some(*y),
                    ..ScatterSpec::default()
                };
                let [x, y] = spec.values(&brdf, Some(0.2)).expect("its own");
                let plot = ScatterPlot::new(&[dot("a", x, y)], &spec, [600.0, 400.0]);
                assert!(plot.places[0].is_some(), "{} {spec:?}", model.key);
                // Of the ends that are shown all can be asked for again.
                let PlotFrame { x, y, .. } = plot.frame;
                for (row, axis) in spec.rows().iter().zip([x, y]) {
                    assert!(
                        row.are_ends([axis.floor, axis.limit]),
                        "{} {spec:?}",
                        model.key
                    );
                }
            }
        }
    }

    #[test]
    fn a_contained_model_is_where_it_equals_the_shown_one() {
        let spec = ScatterSpec::default();
        let mut brdf = crate::brdf::Brdf::new(&crate::brdf::PHONG, crate::brdf::Fresnel::None);
        brdf.params.lobe[0] = 8.0;
        assert_eq!(spec.values(&brdf, None), Some([8.0, 0.0]));
        brdf.model = &crate::brdf::BLINN_PHONG;
        assert_eq!(spec.values(&brdf, None), Some([2.0, 1.0]));
        assert_eq!(of_model("ggx").values(&brdf, None), None);
        assert_eq!(of_model("phong").values(&brdf, None), None);
    }

    #[test]
    fn nothing_and_nonsense_are_drawn_too() {
        for dots in [vec![], vec![dot("x", f64::NAN, 2.0), dot("y", 1e300, -1.0)]] {
            for size in [[300.0, 200.0], [10.0, 10.0]] {
                let plot = ScatterPlot::new(&dots, &ScatterSpec::default(), size);
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
