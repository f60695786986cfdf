//! The lobes of all subjects on one axis, made again only as far as their inputs have changed.

use super::mesh::{Detail, LobeMesh, layout, sample};
use crate::figure::cosine::CosineFactor;
use crate::figure::scale::{Axis, RadialScale, nice_limit};
use crate::figure::subject::{Channel, Look, Source, Subject};
use crate::geom::{Rgb, mirror};
use glam::DVec3;
use std::sync::Arc;

/// Settings that decide the shape of lobes, besides the subjects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Angle of incidence in radians.
    pub theta_i: f64,
    /// Law from values to radii.
    pub scale: RadialScale,
    /// Cosines that f_r is multiplied by.
    pub cosine: CosineFactor,
    /// Colour channel that is shown.
    pub channel: Channel,
    /// Fineness of the meshes.
    pub detail: Detail,
}

impl Shape {
    /// Unit vector to the light, which comes from the left.
    pub fn wi(&self) -> DVec3 {
        DVec3::new(-self.theta_i.sin(), 0.0, self.theta_i.cos())
    }

    /// Function from f_r towards a direction to the value that is shown.
    fn scalar(&self) -> impl Fn(Rgb, DVec3) -> f64 {
        let (cosine, channel, cos_theta_i) = (self.cosine, self.channel, self.theta_i.cos());
        move |f_r, wo| cosine.of(cos_theta_i, wo.z) * channel.of(f_r)
    }

    /// Value of a source towards `wo`, as it is shown; `None` where it has no finite value.
    pub fn value(&self, source: &Source, wo: DVec3) -> Option<f64> {
        let value = self.scalar()(source.f_r(self.wi(), wo)?, wo);
        value.is_finite().then_some(value)
    }
}

/// The lobe of one subject.
#[derive(Clone, Debug)]
pub struct Lobe {
    /// Subject whose f_r it is.
    pub subject: Subject,
    /// f_r of every direction of the layout.
    pub(super) samples: Arc<Vec<Option<Rgb>>>,
    /// Surface of the lobe; `None` where the subject is hidden.
    pub mesh: Option<Arc<LobeMesh>>,
}

impl Lobe {
    /// Whether it is drawn as a solid; else as wire.
    pub fn is_solid(&self) -> bool {
        self.subject.look == Look::Measured
    }
}

/// The lobes of some subjects.
#[derive(Clone, Debug)]
pub struct Lobes {
    /// Settings that the lobes were made with.
    pub shape: Shape,
    /// One per subject, in their order.
    pub list: Vec<Lobe>,
    /// The axis of all of them.
    pub axis: Axis,
    directions: Arc<Vec<DVec3>>,
}

impl Lobes {
    /// Makes the lobes, of `before` what is still right.
    pub fn new(shape: Shape, subjects: &[Subject], before: Option<&Self>) -> Self {
        let layout_of = |shape: &Shape| (shape.theta_i, shape.detail);
        let before = before.filter(|before| layout_of(&before.shape) == layout_of(&shape));
        let directions = before.map_or_else(
            || Arc::new(layout(shape.theta_i, shape.detail)),
            |before| Arc::clone(&before.directions),
        );
        let known = |source: &Source| {
            let list = &before?.list;
            let lobe = list.iter().find(|lobe| lobe.subject.source == *source)?;
            (!lobe.samples.is_empty()).then(|| Arc::clone(&lobe.samples))
        };
        let sampled = |subject: &Subject| match known(&subject.source) {
            Some(samples) => samples,
            None if subject.hidden => Arc::default(),
            None => Arc::new(sample(&subject.source, &directions)),
        };
        let mut list: Vec<Lobe> = subjects
            .iter()
            .map(|subject| Lobe {
                subject: subject.clone(),
                samples: sampled(subject),
                mesh: None,
            })
            .collect();
        let axis = axis_of(&shape, &directions, &list);
        let same_axis = before.filter(|before| before.shape == shape && before.axis == axis);
        for lobe in list.iter_mut().filter(|lobe| !lobe.subject.hidden) {
            let kept = same_axis.and_then(|before| {
                let mut list = before.list.iter();
                list.find(|old| Arc::ptr_eq(&old.samples, &lobe.samples))?
                    .mesh
                    .clone()
            });
            lobe.mesh = Some(kept.unwrap_or_else(|| {
                Arc::new(LobeMesh::new(
                    shape.detail,
                    (&directions, &lobe.samples),
                    shape.scalar(),
                    &axis,
                ))
            }));
        }
        Self {
            shape,
            list,
            axis,
            directions,
        }
    }

    /// Whether they are those of this shape and these subjects.
    pub fn are_of(&self, shape: &Shape, subjects: &[Subject]) -> bool {
        self.shape == *shape
            && self.list.len() == subjects.len()
            && self
                .list
                .iter()
                .zip(subjects)
                .all(|(lobe, subject)| lobe.subject == *subject)
    }

    /// The surfaces that are shown.
    pub fn meshes(&self) -> impl Iterator<Item = &LobeMesh> {
        self.list.iter().filter_map(|lobe| lobe.mesh.as_deref())
    }

    /// Unit vector to the light.
    pub fn wi(&self) -> DVec3 {
        mirror(self.directions[0])
    }
}

/// One axis for all that is shown.
fn axis_of(shape: &Shape, directions: &[DVec3], lobes: &[Lobe]) -> Axis {
    let scalar = shape.scalar();
    let shown = lobes.iter().filter(|lobe| !lobe.subject.hidden);
    let values = shown
        .flat_map(|lobe| lobe.samples.iter().zip(directions))
        .filter_map(|(f_r, wo)| f_r.map(|f_r| scalar(f_r, *wo)))
        .filter(|value| value.is_finite());
    let (mut largest, mut smallest) = (0.0_f64, f64::INFINITY);
    for value in values {
        largest = largest.max(value);
        if value > 0.0 {
            smallest = smallest.min(value);
        }
    }
    let smallest = smallest.is_finite().then_some(smallest);
    Axis::new(shape.scale, nice_limit(largest), smallest)
}
