//! The page that is nothing but a sphere.

use super::spec::PageSpec;
use crate::figure::ViewSpec;
use crate::figure::sphere_image::SphereSource;
use crate::figure::subject::{Look, Subject};
use crate::geom::sight::Sight;
use crate::geom::sphere::SphereView;

/// The sphere of a page that has nothing else on it, its lights, and the part in sight.
pub fn only_sphere(
    page: &PageSpec,
    subjects: &[Subject],
) -> Option<(SphereSource, SphereView, Sight)> {
    let mut panels = page.rows.iter().flat_map(|row| &row.panels);
    let (Some(panel), None) = (panels.next(), panels.next()) else {
        return None;
    };
    let ViewSpec::Sphere(spec) = &panel.view else {
        return None;
    };
    let of_panel = || panel.subjects.iter().filter_map(|at| subjects.get(*at));
    let of = |measured| {
        let found = of_panel().find(|s| (s.look == Look::Measured) == measured);
        found.map(|subject| subject.source.clone())
    };
    Some((spec.source(of)?, spec.view.clone(), spec.sight))
}
