//! The lit sphere as numbers: lights, exposure, and the geometry between a point of the picture and (wi, wo).
//!
//! View space: x to the right, y up, z to the viewer, who looks from infinitely far. The sphere fills the square
//! [−1, 1]²; a point of the picture is given in these units.

use super::{HalfDiff, Rgb};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Largest number of lights that are added up.
pub const MAX_LIGHTS: usize = 4;

/// A directional light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Unit vector towards the light in view space. z < 0 is behind the sphere.
    pub direction: DVec3,
    /// Colour and strength, linear RGB. At strength 1 the irradiance is π, so that a white diffuse surface that faces
    /// the light has the value 1 at 0 stops.
    pub strength: Rgb,
}

/// Lights and exposure of the sphere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SphereView {
    /// Lights, at most [`MAX_LIGHTS`].
    pub lights: Vec<Light>,
    /// Exposure in stops: radiance is multiplied by 2^stops.
    pub exposure_stops: f64,
}

impl Default for SphereView {
    /// The poster's pair of lights at 0 stops.
    fn default() -> Self {
        Self {
            lights: poster_lights(),
            exposure_stops: 0.0,
        }
    }
}

/// A named set of lights.
#[derive(Debug)]
pub struct LightPreset {
    /// Name on the command line, e.g. "poster".
    pub key: &'static str,
    /// Display name, e.g. "Glancing and grazing".
    pub name: &'static str,
    /// Description in one phrase.
    pub help: &'static str,
    /// Makes the lights of the set.
    pub lights: fn() -> Vec<Light>,
}

/// All light presets, in the order in which they are offered.
pub static LIGHT_PRESETS: [LightPreset; 4] = [
    LightPreset {
        key: "poster",
        name: "Glancing and grazing",
        help: "The poster's pair: a glancing light from the upper right, a grazing one from the lower left",
        lights: poster_lights,
    },
    LightPreset {
        key: "glancing",
        name: "Glancing",
        help: "One light from the upper right",
        lights: || vec![glancing()],
    },
    LightPreset {
        key: "grazing",
        name: "Grazing",
        help: "One light from the lower left, behind the sphere",
        lights: || vec![grazing()],
    },
    LightPreset {
        key: "viewer",
        name: "From the viewer",
        help: "One light beside the viewer's eye",
        lights: || vec![light(0.0, 0.0, 1.0)],
    },
];

impl Light {
    /// White light of strength 1 at the angle `theta` from the viewer's axis, and there at `phi` from the right towards
    /// above; radians.
    pub fn from_angles(theta: f64, phi: f64) -> Self {
        let (sin_theta, cos_theta) = theta.sin_cos();
        let (sin_phi, cos_phi) = phi.sin_cos();
        light(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
    }
}

fn poster_lights() -> Vec<Light> {
    vec![glancing(), grazing()]
}

fn glancing() -> Light {
    light(0.6, 0.6, 0.55)
}

fn grazing() -> Light {
    light(-0.72, -0.6, -0.45)
}

fn light(x: f64, y: f64, z: f64) -> Light {
    Light {
        direction: DVec3::new(x, y, z).normalize(),
        strength: [1.0; 3],
    }
}

/// Direction to the viewer in view space.
const VIEW: DVec3 = DVec3::Z;

/// Unit normal in view space at a point of the picture; `None` outside the sphere.
pub fn normal_at(x: f64, y: f64) -> Option<DVec3> {
    let rest = 1.0 - x * x - y * y;
    (rest > 0.0).then(|| DVec3::new(x, y, rest.sqrt()))
}

/// Directions (wi, wo) in the local frame at a point of the picture; `None` outside the sphere.
///
/// The frame is turned such that wo has azimuth 0.
pub fn local_directions(x: f64, y: f64, light: &Light) -> Option<(DVec3, DVec3)> {
    let n = normal_at(x, y)?;
    let tangent = (VIEW - n * n.z)
        .try_normalize()
        .unwrap_or_else(|| n.any_orthonormal_vector());
    let bitangent = n.cross(tangent);
    let local = |w: DVec3| DVec3::new(w.dot(tangent), w.dot(bitangent), w.dot(n));
    Some((local(light.direction), local(VIEW)))
}

/// Point of the picture at which the light and the viewer have this θ_h and φ_d, and the θ_d in radians that they have
/// on the whole sphere; `None` where that point is not lit or not visible.
pub fn point_of(angles: HalfDiff, light: &Light) -> Option<((f64, f64), f64)> {
    let frame = |wi: DVec3, wo: DVec3| {
        let wh = (wi + wo).try_normalize()?;
        let across = (wi - wo).try_normalize();
        let across = across.unwrap_or_else(|| wh.any_orthonormal_vector());
        Some([wh, across, wh.cross(across)])
    };
    let theta_d = 0.5 * light.direction.angle_between(VIEW);
    let (wi, wo) = HalfDiff { theta_d, ..angles }.to_directions();
    let (local, seen) = (frame(wi, wo)?, frame(light.direction, VIEW)?);
    let n: DVec3 = (0..3).map(|k| seen[k] * local[k].z).sum();
    (n.z >= 0.0 && n.dot(light.direction) >= 0.0).then_some(((n.x, n.y), theta_d))
}

/// Direction of the light whose mirror highlight is at a point of the picture; points outside count as the rim.
pub fn light_for_highlight_at(x: f64, y: f64) -> DVec3 {
    let radius = x.hypot(y);
    let scale = if radius > MAX_HIGHLIGHT_RADIUS {
        MAX_HIGHLIGHT_RADIUS / radius
    } else {
        1.0
    };
    let (x, y) = (x * scale, y * scale);
    let n = DVec3::new(x, y, (1.0 - x * x - y * y).sqrt());
    2.0 * n.z * n - VIEW
}

/// Largest radius to which a highlight is dragged. There the light is 176° from the viewer's axis.
const MAX_HIGHLIGHT_RADIUS: f64 = 0.9994;

/// Point of the picture at which the mirror highlight of a light is.
pub fn highlight_of(light: &Light) -> (f64, f64) {
    let n = (light.direction + VIEW).try_normalize().unwrap_or(DVec3::X);
    (n.x, n.y)
}

/// Irradiance on a surface that faces a light, times 2^stops.
pub fn irradiance(light: &Light, exposure_stops: f64) -> Rgb {
    let gain = PI * exposure_stops.exp2();
    light.strength.map(|strength| gain * strength)
}

/// The two sRGB colours with alpha of the hatch on unmeasured directions: visible on light and dark ground.
pub const HATCH: [[f32; 4]; 2] = [[0.36, 0.36, 0.40, 1.0], [0.62, 0.62, 0.66, 1.0]];

#[cfg(test)]
mod tests {
    use super::super::directions::half_vector;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_highlight_is_where_its_light_was_dragged(radius in 0.0..0.999, angle in 0.0..6.2) {
            let (x, y) = (radius * f64::cos(angle), radius * f64::sin(angle));
            let light = Light { direction: light_for_highlight_at(x, y), strength: [1.0; 3] };
            prop_assert!((light.direction.length() - 1.0).abs() < 1e-12);
            let (hx, hy) = highlight_of(&light);
            prop_assert!((hx - x).hypot(hy - y) < 1e-9);
            // In the local frame there, the half vector is the normal.
            let (wi, wo) = local_directions(x, y, &light).expect("on the sphere");
            prop_assert!((half_vector(wi, wo) - DVec3::Z).length() < 1e-6);
        }

        #[test]
        fn a_point_is_found_again_by_its_angles(x in -0.7..0.7, y in -0.7..0.7) {
            for light in poster_lights() {
                let (wi, wo) = local_directions(x, y, &light).expect("on the sphere");
                let angles = HalfDiff::from_directions(wi, wo).expect("not opposite");
                let found = point_of(angles, &light);
                prop_assert_eq!(found.is_some(), wi.z >= 0.0);
                if let Some(((px, py), theta_d)) = found {
                    prop_assert!((px - x).hypot(py - y) < 1e-6, "{} {}", px, py);
                    prop_assert!((theta_d - angles.theta_d).abs() < 1e-9);
                }
            }
        }

        #[test]
        fn local_directions_keep_lengths_and_angles(x in -0.7..0.7, y in -0.7..0.7) {
            for light in poster_lights() {
                let (wi, wo) = local_directions(x, y, &light).expect("on the sphere");
                prop_assert!((wi.length() - 1.0).abs() < 1e-12 && (wo.length() - 1.0).abs() < 1e-12);
                prop_assert!((wi.dot(wo) - light.direction.z).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn the_posters_lights_are_glancing_and_grazing() {
        let [glancing, grazing] = poster_lights()[..] else {
            panic!("two lights")
        };
        assert!(
            glancing.direction.x > 0.0 && glancing.direction.y > 0.0 && glancing.direction.z > 0.0
        );
        assert!(grazing.direction.x < 0.0 && grazing.direction.y < 0.0);
        // At its highlight the grazing light comes in at more than 50° from the normal, the glancing one at less.
        let theta = |light: &Light| 0.5 * light.direction.z.acos().to_degrees();
        assert!(theta(&grazing) > 50.0 && theta(&glancing) < 40.0);
    }
}
