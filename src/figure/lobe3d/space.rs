//! Scenery around the lobes in space: the surface with its circles, the plane of incidence with its rings, vectors.

use super::lobes::Lobes;
use crate::figure::palette::{Ink, Palette, Role};
use crate::geom::limits::UNRELIABLE_THETA_DEG;
use crate::geom::{direction, mirror};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Polar angles in degrees that are circles on the surface: at sin θ, under the directions of that θ.
pub const CIRCLES_DEG: [f64; 3] = [30.0, 60.0, UNRELIABLE_THETA_DEG];

/// Distance of the vectors' tips from the origin, in units of the dome's radius.
pub const VECTOR: f64 = 1.1;

/// A line in space.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceLine {
    /// Corners, at least two, in units of the dome's radius.
    pub points: Vec<DVec3>,
    /// Width in points.
    pub width: f32,
    /// Colour of the line.
    pub ink: Ink,
    /// Share of its opacity that is left where a solid is in front of it.
    pub behind: f32,
}

/// A flat surface in space that lets through what is behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceFill {
    /// A convex polygon.
    pub points: Vec<DVec3>,
    /// Fill colour.
    pub ink: Ink,
}

/// The surface and the plane of incidence with their lines, and the vectors n, ωi, ωr and, with a probe, ωo.
pub fn ground(lobes: &Lobes, wo: Option<DVec3>) -> (Vec<SpaceFill>, Vec<SpaceLine>) {
    let circle = |radius: f64| -> Vec<DVec3> {
        let turn = |k: u32| TAU * f64::from(k) / 96.0;
        (0..=96)
            .map(|k| radius * direction(FRAC_PI_2, turn(k)).with_z(0.0))
            .collect()
    };
    let ring = |radius: f64| -> Vec<DVec3> {
        (-48..=48_i32)
            .map(|k| in_plane(radius, FRAC_PI_2 * f64::from(k) / 48.0))
            .collect()
    };
    let line = |points, width, ink, behind| SpaceLine {
        points,
        width,
        ink,
        behind,
    };
    let (faint, muted) = (Ink::from(Role::Faint), Ink::from(Role::Muted));
    let fills = vec![
        SpaceFill {
            points: circle(1.0),
            ink: faint.faded(0.45),
        },
        SpaceFill {
            points: ring(1.0),
            ink: muted.faded(0.10),
        },
    ];
    let mut lines = vec![
        line(circle(1.0), 1.2, muted.faded(0.8), 0.3),
        line(ring(1.0), 1.2, muted, 0.3),
        line(vec![DVec3::NEG_X, DVec3::X], 1.2, muted, 0.3),
    ];
    for degrees in CIRCLES_DEG {
        let points = circle(degrees.to_radians().sin());
        lines.push(line(points, 1.0, muted.faded(0.45), 0.3));
    }
    for tick in lobes.axis.ticks(4) {
        if tick.position < 1.0 - 1e-6 {
            lines.push(line(ring(tick.position), 1.0, muted.faded(0.45), 0.3));
        }
    }
    let wi = lobes.wi();
    let ink = Ink::from(Role::Foreground);
    for tip in [DVec3::Z, wi, mirror(wi)].into_iter().chain(wo) {
        let points = vec![DVec3::ZERO, VECTOR * tip];
        lines.push(line(points, 1.5, ink.faded(0.9), 0.35));
    }
    if let Some(wo) = wo {
        // Where it is over the surface.
        let foot = wo.with_z(0.0);
        let points = vec![wo, foot, DVec3::ZERO];
        lines.push(line(points, 1.0, ink.faded(0.5), 0.35));
    }
    (fills, lines)
}

/// Width in points of the wire of a model.
const WIRE: f32 = 1.2;
/// Share of the wire's opacity that is left behind a solid.
const WIRE_BEHIND: f32 = 0.22;

/// The models as wire. A model has the colour of its material: on the solid it is seen by being nearer to the colour of
/// text.
pub fn wires(lobes: &Lobes, palette: &Palette) -> Vec<SpaceLine> {
    let models = lobes.list.iter().filter(|lobe| !lobe.is_solid());
    let meshes = models.filter_map(|lobe| Some((lobe.subject.series, lobe.mesh.as_ref()?)));
    let text = palette.color(Role::Foreground);
    meshes
        .flat_map(|(series, mesh)| {
            let own = palette.color(Role::Series(series));
            let mixed: [u8; 3] =
                std::array::from_fn(|k| (u16::from(own[k]) + u16::from(text[k])).div_ceil(2) as u8);
            mesh.wire().into_iter().map(move |points| SpaceLine {
                points,
                width: WIRE,
                ink: Role::Fixed(mixed).into(),
                behind: WIRE_BEHIND,
            })
        })
        .collect()
}

/// A point of the plane of incidence, θ to the right in radians.
pub(super) fn in_plane(radius: f64, theta: f64) -> DVec3 {
    radius * DVec3::new(theta.sin(), 0.0, theta.cos())
}
