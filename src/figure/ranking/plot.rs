//! The plot: ranks along x, E on a logarithmic axis, a curve with a dot per material for each model.

use super::order::Ranking;
use super::spec::{RankingPart, RankingSpec};
use crate::brdf::{Brdf, Fresnel, Model};
use crate::figure::drawing::{Drawing, Point};
use crate::figure::legend::LegendEntry;
use crate::figure::palette::Role;
use crate::figure::plot::{Outline, Panel, Pen, Plot, PlotDot, PlotFrame};
use crate::figure::scale::{Axis, RadialScale, Steps};
use crate::figure::subject::{Source, Subject, model_line};
use crate::figure::text::RichText;
use crate::geom::limits::GRAZING_THETA_DEG;

/// Radius of a dot in points, of the model that sorts and of the others.
const RADII: (f32, f32) = (4.0, 3.0);
/// Width of the other models' curves beside that of the one that sorts.
const THINNER: f32 = 0.7;
/// Largest distance in points at which the pointer still means a dot.
const NEAR: f32 = 14.0;
/// Room beyond the errors, and the least ratio of the ends of their axis.
const ROOM: f64 = 1.15;
const LEAST_RATIO: f64 = 4.0;

/// The plot with what is where in it.
#[derive(Clone, Debug)]
pub struct RankingPlot {
    /// Picture of the plot.
    pub drawing: Drawing,
    /// Map between values and points of the drawing: ranks from 1 on, and E in percent.
    pub frame: PlotFrame,
    /// Places of the names of [`Ranking::models`], in their order.
    pub legend: Vec<LegendEntry>,
    /// Order of the materials.
    pub ranking: Ranking,
    /// Points of the dots with the positions of their row and their model.
    pub dots: Vec<(Point, usize, usize)>,
}

impl RankingPlot {
    /// A plot of `size` points.
    pub fn new(spec: &RankingSpec, size: [f32; 2]) -> Self {
        let ranking = Ranking::new(spec);
        let subjects: Vec<Subject> = (0..ranking.models.len())
            .map(|k| subject(&ranking, k))
            .collect();
        let e = match spec.part {
            RankingPart::Total => "E [%]".to_owned(),
            RankingPart::Grazing => format!("E from {GRAZING_THETA_DEG}° on [%]"),
        };
        let factor = spec.fresnel.map_or(String::new(), |fresnel| {
            format!(", Fresnel {}", fresnel.key())
        });
        let outline = Outline {
            title: vec![
                format!("{e} of each model{factor}, log_{{10}}"),
                format!("{e}{factor}, log_{{10}}"),
                format!("{e}, log_{{10}}"),
            ],
            subjects: &subjects,
            x: Axis::between(RadialScale::Linear, 0.5, ranking.rows.len() as f64 + 0.5),
            x_steps: Steps::Whole,
            x_names: ranking
                .rows
                .iter()
                .map(|row| spec.materials[row.material].name.clone())
                .collect(),
            x_name: match spec.sort.filter(|sort| ranking.models.contains(sort)) {
                Some(sort) => format!("materials by E of {}", sort.name),
                None => "materials by their least E".into(),
            },
            panels: vec![Panel {
                axis: axis(&ranking),
                height: 1.0,
                title: Vec::new(),
            }],
        };
        let mut plot = Plot::new(&outline, size);
        plot.axes();
        if ranking.rows.is_empty() {
            plot.say(0, &["no fits", "–"]);
        }
        let dots = draw(&mut plot, &ranking, &subjects, spec);
        let frame = plot.frames[0];
        let (drawing, legend) = plot.finish();
        Self {
            drawing,
            frame,
            legend,
            ranking,
            dots,
        }
    }

    /// The positions of the row and the model of the dot that is meant at a point: the nearest, if it is near.
    pub fn dot_at(&self, point: Point) -> Option<(usize, usize)> {
        let distance = |at: &Point| (at[0] - point[0]).hypot(at[1] - point[1]);
        let dots = self.dots.iter();
        let (at, row, model) = dots.min_by(|a, b| distance(&a.0).total_cmp(&distance(&b.0)))?;
        (distance(at) <= NEAR).then_some((*row, *model))
    }
}

/// The legend's entry of a model: its name, and how many materials it wins.
fn subject(ranking: &Ranking, k: usize) -> Subject {
    let model = ranking.models[k];
    let (series, look) = model_line(model);
    let label = match ranking.compared() {
        0 => model.name.to_owned(),
        all => format!("{}: {} of {all}", model.name, ranking.wins(k)),
    };
    Subject {
        label,
        look,
        series,
        hidden: false,
        source: Source::Model(Brdf::new(model, Fresnel::None)),
    }
}

/// The axis of E in percent around all errors.
fn axis(ranking: &Ranking) -> Axis {
    let (low, high) = ranking
        .errors()
        .fold((f64::INFINITY, 0.0_f64), |(low, high), error| {
            (low.min(100.0 * error), high.max(100.0 * error))
        });
    if low > high {
        return Axis::between(RadialScale::Log, 1.0, 100.0);
    }
    let wider = (LEAST_RATIO / (high / low * ROOM * ROOM)).max(1.0).sqrt();
    Axis::between(RadialScale::Log, low / ROOM / wider, high * ROOM * wider)
}

/// Curves, then dots over them; the model that sorts above the others.
fn draw(
    plot: &mut Plot,
    ranking: &Ranking,
    subjects: &[Subject],
    spec: &RankingSpec,
) -> Vec<(Point, usize, usize)> {
    let sorts = |model: &Model| spec.sort.is_some_and(|sort| sort == model);
    let mut order: Vec<usize> = (0..ranking.models.len()).collect();
    order.sort_by_key(|k| !sorts(ranking.models[*k]));
    let value = |row: usize, model: usize| ranking.rows[row].error(model).map(|e| 100.0 * e);
    let rows = ranking.rows.len();
    for k in order.iter().rev() {
        let pen = Pen::of(&subjects[*k], true);
        let strong = spec.sort.is_none() || sorts(ranking.models[*k]);
        let width = pen.width * if strong { 1.0 } else { THINNER };
        let samples = (0..rows).map(|row| ((row + 1) as f64, value(row, *k)));
        plot.curve(0, samples, Pen { width, ..pen });
    }
    let mut spots = Vec::new();
    let mut of = Vec::new();
    for k in order {
        let radius = if sorts(ranking.models[k]) {
            RADII.0
        } else {
            RADII.1
        };
        for row in 0..rows {
            let Some(y) = value(row, k) else { continue };
            spots.push(PlotDot {
                x: (row + 1) as f64,
                y,
                radius,
                ink: Role::Series(subjects[k].series).into(),
                name: RichText::default(),
            });
            of.push((row, k));
        }
    }
    let places = plot.dots(0, &spots).into_iter();
    let dots = places.zip(of);
    dots.filter_map(|(at, (row, model))| Some((at?, row, model)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::spec::{RankedFit, RankedMaterial};
    use super::*;

    fn spec(materials: usize) -> RankingSpec {
        let fit = |key: &str, error: f64| RankedFit {
            model: Model::by_key(key).expect("a model"),
            fresnel: Fresnel::Exact,
            error,
            grazing: None,
        };
        // Phong falls and GGX rises from material to material.
        let material = |k: usize| RankedMaterial {
            name: format!("material {k}"),
            fits: vec![
                fit("phong", 0.4 / (k + 1) as f64),
                fit("ggx", 0.01 * (k + 1) as f64),
            ],
        };
        RankingSpec {
            sort: Model::by_key("phong"),
            materials: (0..materials).map(material).collect(),
            ..RankingSpec::default()
        }
    }

    fn texts(plot: &RankingPlot) -> Vec<String> {
        let labels = plot.drawing.labels();
        labels.map(|label| label.text.plain()).collect()
    }

    #[test]
    fn dots_are_where_their_errors_are() {
        let plot = RankingPlot::new(&spec(4), [600.0, 400.0]);
        let PlotFrame { min, max, x, y } = plot.frame;
        assert_eq!((x.floor, x.limit), (0.5, 4.5));
        // 1 % to 40 %, and 15 % beyond.
        assert!((y.floor - 1.0 / 1.15).abs() < 1e-9 && (y.limit - 46.0).abs() < 1e-9);
        let at = |rank: f32, percent: f64| {
            let up = (percent / y.floor).ln() / (y.limit / y.floor).ln();
            [
                min[0] + (max[0] - min[0]) * (rank - 0.5) / 4.0,
                max[1] - (max[1] - min[1]) * up as f32,
            ]
        };
        let near = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]) < 0.01;
        let dot = |row: usize, model: usize| {
            let mut dots = plot.dots.iter();
            let found = dots.find(|(_, r, m)| (*r, *m) == (row, model));
            found.expect("a dot").0
        };
        // The last material has Phong's least error and comes first; GGX is 4 % there.
        assert!(near(dot(0, 0), at(1.0, 10.0)) && near(dot(0, 1), at(1.0, 4.0)));
        assert!(near(dot(3, 0), at(4.0, 40.0)) && near(dot(3, 1), at(4.0, 1.0)));
        // Not on a linear axis, nor in the order of the list.
        let share = (10.0 - y.floor) / (y.limit - y.floor);
        let linear = max[1] - (max[1] - min[1]) * share as f32;
        assert!((dot(0, 0)[1] - linear).abs() > 10.0);
        assert!(!near(dot(0, 0), at(1.0, 40.0)));
        let [x, y] = dot(1, 1);
        assert_eq!(plot.dot_at([x + 5.0, y + 5.0]), Some((1, 1)));
        assert_eq!(plot.dot_at([min[0], min[1] - 30.0]), None);
    }

    #[test]
    fn names_stand_below_where_there_is_room_and_wins_in_the_legend() {
        let words = texts(&RankingPlot::new(&spec(4), [600.0, 400.0]));
        for word in [
            "material 3",
            "Phong: 0 of 4",
            "GGX: 4 of 4",
            "materials by E of Phong",
        ] {
            assert!(words.contains(&word.into()), "{words:?}");
        }
        let turned = |materials: usize| {
            let plot = RankingPlot::new(&spec(materials), [600.0, 400.0]);
            let mut labels = plot.drawing.labels();
            let name = labels.find(|label| label.text.plain() == "material 1");
            name.expect("a name").angle != 0.0
        };
        assert!(!turned(4) && turned(30));
        let words = texts(&RankingPlot::new(&spec(300), [600.0, 400.0]));
        assert!(!words.iter().any(|word| word.starts_with("material ")));
        assert!(words.contains(&"200".into()), "{words:?}");
    }

    #[test]
    fn nothing_and_nonsense_are_drawn_too() {
        let mut odd = spec(2);
        odd.materials[0].fits[0].error = 1e12;
        odd.materials[1].fits[1].error = f64::MIN_POSITIVE;
        let mut all_equal = spec(1);
        all_equal.materials[0].fits[1].error = 0.4;
        for spec in [RankingSpec::default(), odd, all_equal] {
            for size in [[300.0, 200.0], [10.0, 10.0]] {
                let plot = RankingPlot::new(&spec, size);
                let mut places = plot.dots.iter().flat_map(|dot| dot.0);
                assert!(places.all(f32::is_finite));
            }
        }
    }
}
