//! The order of the materials, and which model wins each.

use super::spec::{RankedFit, RankingSpec};
use crate::brdf::{MODELS, Model};

/// Errors that differ by less than this share are equal: a model that contains another ends where that one does.
const EQUAL: f64 = 1e-4;

/// Materials in order, with the errors of the shown models.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranking {
    /// Models that have a fit, in the order of [`MODELS`], without those that are hidden.
    pub models: Vec<&'static Model>,
    /// Materials that have a fit of a shown model, in order.
    pub rows: Vec<RankedRow>,
}

/// A material in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct RankedRow {
    /// Position in the list of the spec.
    pub material: usize,
    /// The best fit per model of [`Ranking::models`] with the shown part of E, as a share.
    pub fits: Vec<Option<(RankedFit, f64)>>,
    /// Position of the model that wins, where every shown model has a fit.
    pub winner: Option<usize>,
}

impl Ranking {
    /// Order of a spec.
    pub fn new(spec: &RankingSpec) -> Self {
        let best = |material: usize, model: &Model| {
            let fits = spec.materials[material].fits.iter();
            fits.filter(|fit| fit.model == model)
                .filter(|fit| spec.fresnel.is_none_or(|fresnel| fresnel == fit.fresnel))
                .filter_map(|fit| Some((*fit, fit.part(spec.part)?)))
                .min_by(|a, b| a.1.total_cmp(&b.1))
        };
        let all = 0..spec.materials.len();
        let models: Vec<&'static Model> = MODELS
            .iter()
            .copied()
            .filter(|model| spec.hidden.iter().all(|hidden| hidden.0 != *model))
            .filter(|model| all.clone().any(|material| best(material, model).is_some()))
            .collect();
        let mut rows: Vec<RankedRow> = all
            .map(|material| {
                let fits: Vec<_> = models.iter().map(|model| best(material, model)).collect();
                RankedRow {
                    material,
                    winner: winner(&models, &fits),
                    fits,
                }
            })
            .filter(|row| row.fits.iter().any(Option::is_some))
            .collect();
        let sort = spec.sort;
        let place = sort.and_then(|sort| models.iter().position(|model| *model == sort));
        // A stable sort: what is equal stays in the order of the spec.
        rows.sort_by(|a, b| {
            let of = |row: &RankedRow| match place {
                Some(place) => row.error(place),
                None => row.least(),
            };
            match (of(a), of(b)) {
                (Some(a), Some(b)) => a.total_cmp(&b),
                // Those without one come last.
                (a, b) => b.is_some().cmp(&a.is_some()),
            }
        });
        Self { models, rows }
    }

    /// Number of materials that every shown model is fitted to.
    pub fn compared(&self) -> usize {
        let rows = self.rows.iter();
        rows.filter(|row| row.winner.is_some()).count()
    }

    /// Number of materials that a model wins, by its position.
    pub fn wins(&self, model: usize) -> usize {
        let rows = self.rows.iter();
        rows.filter(|row| row.winner == Some(model)).count()
    }

    /// All errors that are shown, as shares.
    pub fn errors(&self) -> impl Iterator<Item = f64> {
        let fits = self.rows.iter().flat_map(|row| &row.fits);
        fits.flatten().map(|(_, error)| *error)
    }
}

impl RankedRow {
    /// The shown part of E of a model, by its position, as a share.
    pub fn error(&self, model: usize) -> Option<f64> {
        Some(self.fits.get(model)?.as_ref()?.1)
    }

    /// The least of all models.
    fn least(&self) -> Option<f64> {
        let errors = self.fits.iter().flatten().map(|(_, error)| *error);
        errors.min_by(f64::total_cmp)
    }
}

/// The model with the least error where all have one and there are several; of equal ones that with the fewest
/// parameters, then the first.
fn winner(models: &[&'static Model], fits: &[Option<(RankedFit, f64)>]) -> Option<usize> {
    let errors: Vec<f64> = fits
        .iter()
        .map(|fit| Some(fit.as_ref()?.1))
        .collect::<Option<_>>()?;
    if errors.len() < 2 {
        return None;
    }
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    (0..errors.len())
        .filter(|k| errors[*k] <= least * (1.0 + EQUAL))
        .min_by_key(|k| models[*k].params.len())
}

#[cfg(test)]
mod tests {
    use super::super::spec::{ModelKey, RankedMaterial, RankingPart};
    use super::*;
    use crate::brdf::Fresnel;

    pub fn fit(key: &str, fresnel: Fresnel, error: f64, grazing: f64) -> RankedFit {
        RankedFit {
            model: Model::by_key(key).expect("a model"),
            fresnel,
            error,
            grazing: Some(grazing),
        }
    }

    fn spec() -> RankingSpec {
        let exact = Fresnel::Exact;
        let material = |name: &str, phong: f64, combined: f64, ggx: f64| RankedMaterial {
            name: name.into(),
            fits: vec![
                fit("ggx", exact, ggx, 0.5 * ggx),
                fit("phong", Fresnel::None, 2.0 * phong, 4.0 * phong),
                fit("phong", exact, phong, 9.0 * phong),
                fit("combined", exact, combined, 3.0 * combined),
            ],
        };
        let mut alone = material("alone", 0.0, 0.0, 0.02);
        alone.fits.truncate(1);
        RankingSpec {
            materials: vec![
                material("a", 0.3, 0.2, 0.4),
                material("b", 0.1, 0.1, 0.2),
                alone,
                material("c", 0.5, 0.4, 0.05),
            ],
            ..RankingSpec::default()
        }
    }

    fn names(spec: &RankingSpec) -> Vec<&str> {
        let rows = Ranking::new(spec).rows;
        rows.iter()
            .map(|row| spec.materials[row.material].name.as_str())
            .collect()
    }

    #[test]
    fn materials_are_in_the_order_of_a_models_errors() {
        let mut spec = spec();
        assert_eq!(names(&spec), ["alone", "c", "b", "a"]);
        spec.sort = Model::by_key("phong");
        assert_eq!(names(&spec), ["b", "a", "c", "alone"]);
        spec.sort = Model::by_key("ggx");
        assert_eq!(names(&spec), ["alone", "c", "b", "a"]);
        spec.part = RankingPart::Grazing;
        spec.sort = Model::by_key("combined");
        assert_eq!(names(&spec), ["b", "a", "c", "alone"]);
        // A model that nobody has: by the least of all.
        spec.sort = Model::by_key("ward");
        assert_eq!(names(&spec), ["alone", "c", "b", "a"]);
    }

    #[test]
    fn of_each_model_the_best_factor_counts_for_the_shown_part() {
        let mut spec = spec();
        let error_of_a = |spec: &RankingSpec, model: usize| {
            let ranking = Ranking::new(spec);
            let row = ranking.rows.iter().find(|row| row.material == 0);
            row.expect("a").error(model)
        };
        assert_eq!(error_of_a(&spec, 0), Some(0.3));
        spec.part = RankingPart::Grazing;
        assert_eq!(error_of_a(&spec, 0), Some(1.2));
        spec.fresnel = Some(Fresnel::Exact);
        assert_eq!(error_of_a(&spec, 0), Some(9.0 * 0.3));
        spec.fresnel = Some(Fresnel::None);
        assert_eq!(Ranking::new(&spec).models.len(), 1);
    }

    #[test]
    fn wins_are_counted_where_every_model_is_fitted() {
        let mut spec = spec();
        let wins = |spec: &RankingSpec| {
            let ranking = Ranking::new(spec);
            let wins = (0..ranking.models.len()).map(|k| ranking.wins(k));
            (wins.collect::<Vec<_>>(), ranking.compared())
        };
        // Phong, Combined, GGX. On b Combined is Phong, which has fewer parameters.
        assert_eq!(wins(&spec), (vec![1, 1, 1], 3));
        spec.hidden = vec![ModelKey(Model::by_key("phong").expect("a model"))];
        assert_eq!(wins(&spec), (vec![2, 1], 3));
        // Errors of 0 have no place, and nothing wins alone.
        spec.hidden
            .push(ModelKey(Model::by_key("ggx").expect("a model")));
        assert_eq!(wins(&spec), (vec![0], 0));
        spec.hidden.clear();
        spec.materials[0].fits[0].error = 0.0;
        assert_eq!(wins(&spec), (vec![1, 0, 1], 2));
    }
}
