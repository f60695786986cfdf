//! The lesson on five models from 45° to 85°.

use crate::app::lessons::{Lesson, LessonStep, LookAt, Set};
use crate::app::state::view_settings::AnySettings;
use crate::app::state::views::ViewId;
use crate::app::views::disc::settings::DiscSettings;
use crate::app::views::sphere::settings::Show;
use crate::brdf::{Fresnel, ParamId};
use crate::figure::RadialScale;
use crate::figure::shown::Shown;

/// Five models under a light that is turned from 45° to 85°.
pub const LESSON: Lesson = Lesson {
    title: "Five models at grazing angles",
    about: "What Phong, Blinn-Phong, Combined, GGX and Lafortune do from 45° to 85°",
    steps: &[
        LessonStep {
            text: "Phong first. Take the handle of the light at 45° and drag it to 85°: in the plane of incidence the \
                   lobe follows ω_{r} and only turns, at one height, until the horizon cuts it off.",
            set: &[
                Set::Sample("copper-glaze"),
                Set::Model("phong"),
                Set::Fresnel(Fresnel::None),
                Set::Param(ParamId::RHO_D, 0.1),
                Set::Param(ParamId::K_S, 1.0),
                Set::Param(ParamId("s"), 30.0),
                Set::Sphere(Show::Model),
                Set::Scale(RadialScale::CubeRoot),
                Set::Angles(&[45.0], 0),
                Set::Tile(ViewId::Lobes),
            ],
            look_at: LookAt::Tile(ViewId::Lobes),
        },
        LessonStep {
            text: "Blinn-Phong does the same in that plane. Across it they part: here are all view directions, seen from \
                   above, for light at 70°. Blinn-Phong is narrower across, by cos θ_{i}. Switch to Phong, which is round, \
                   and to Combined: with α between 0 and 1 it is between them.",
            set: &[
                Set::Model("blinn-phong"),
                Set::Param(ParamId("s"), 120.0),
                Set::View(|| {
                    AnySettings::new(DiscSettings {
                        shown: Shown::Model,
                        theta_i: 70f64.to_radians(),
                        scale: RadialScale::Log,
                        ..DiscSettings::default()
                    })
                }),
                Set::Tile(ViewId::Disc),
            ],
            look_at: LookAt::Tile(ViewId::Disc),
        },
        LessonStep {
            text: "GGX also asks for the half vector, but divides by the cosines of both angles. Drag the light from 45° to \
                   85° once more: the lobe becomes some twenty times as high, leaves ω_{r} and lies down towards the \
                   horizon. That is how slopes of a rough surface reflect, before any Fresnel factor.",
            set: &[
                Set::Model("ggx"),
                Set::Param(ParamId("roughness"), 0.25),
                Set::Param(ParamId::K_S, 0.4),
                Set::Angles(&[45.0], 0),
                Set::Tile(ViewId::Lobes),
            ],
            look_at: LookAt::Tile(ViewId::Lobes),
        },
        LessonStep {
            text: "Lafortune weights the normal components with c_{z}; 1 is Phong. At 0.8 there is hardly a lobe from above, \
                   and at 45° it is a twentieth of what it is at 85°, leaning past ω_{r}. Drag c_{z}, then the light: above 1 it \
                   is the other way round.",
            set: &[
                Set::Model("lafortune"),
                Set::Param(ParamId("s"), 30.0),
                Set::Param(ParamId("c_z"), 0.8),
                Set::Param(ParamId::K_S, 1.0),
            ],
            look_at: LookAt::Param(ParamId("c_z")),
        },
        LessonStep {
            text: "Now the data. Press Compare: all five are fitted, with the exact Fresnel factor. The sample was made to lie \
                   between Phong and Blinn-Phong; the table says what each model leaves, and how much more from 70° on.",
            set: &[
                Set::Model("combined"),
                Set::Fresnel(Fresnel::Exact),
                Set::Param(ParamId::K_S, 6.0),
                Set::Param(ParamId("s"), 12.0),
                Set::Param(ParamId("alpha"), 0.5),
                Set::Param(ParamId::ETA, 1.5),
                Set::Sphere(Show::Split),
                Set::Compare(
                    &["phong", "blinn-phong", "combined", "ggx", "lafortune"],
                    Fresnel::Exact,
                ),
            ],
            look_at: LookAt::Fit,
        },
        LessonStep {
            text: "Tick the rows of the table: the lobes of these fits lie over the data. Drag the light from 45° to 85° and \
                   see which of them follow. For your own materials open a folder and choose Compare on the folder.",
            set: &[Set::Tile(ViewId::Fits)],
            look_at: LookAt::Tile(ViewId::Fits),
        },
    ],
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::brdf::{Brdf, Model};
    use glam::DVec3;

    /// Highest value in the plane of incidence, and its θo in degrees, under a light from this angle in degrees.
    fn peak(model: &str, values: &[f64], theta_i: f64) -> (f64, f64) {
        let model = Model::by_key(model).expect("a model");
        let mut brdf = Brdf::new(model, Fresnel::None);
        brdf.params.rho_d = [0.0; 3];
        brdf.params.k_s = [1.0; 3];
        brdf.params.lobe[..values.len()].copy_from_slice(values);
        let toward = |degrees: f64| {
            let theta = degrees.to_radians();
            DVec3::new(theta.sin(), 0.0, theta.cos())
        };
        (-1799..1800)
            .map(|k| 0.05 * f64::from(k))
            .map(|theta_o| {
                let f_r = brdf.f_r(toward(-theta_i), toward(theta_o));
                (f_r.map_or(0.0, |f_r| f_r[0]), theta_o)
            })
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .expect("angles")
    }

    #[test]
    fn the_models_do_what_the_text_says() {
        let close = |a: f64, b: f64, by: f64| (a - b).abs() <= by;
        for theta_i in [45.0, 65.0, 85.0] {
            let alike = [
                peak("phong", &[30.0], theta_i),
                peak("blinn-phong", &[120.0], theta_i),
                peak("combined", &[30.0, 0.5], theta_i),
            ];
            for (height, theta_o) in alike {
                assert!(close(height, 1.0, 1e-6) && close(theta_o, theta_i, 0.06));
            }
        }
        let ggx = [45.0, 85.0].map(|theta_i| peak("ggx", &[0.25], theta_i));
        assert!(close(ggx[1].0 / ggx[0].0, 21.0, 1.5), "{ggx:?}");
        assert!(ggx[0].1 > 48.0 && ggx[1].1 > 89.0, "{ggx:?}");
        let leaning = [0.0, 45.0, 85.0].map(|theta_i| peak("lafortune", &[30.0, 0.8], theta_i));
        assert!(leaning[0].0 < 0.002, "{leaning:?}");
        assert!(close(leaning[2].0 / leaning[1].0, 19.0, 1.5), "{leaning:?}");
        assert!(leaning[1].1 > 50.0 && leaning[2].1 > 85.5, "{leaning:?}");
        let other = [45.0, 85.0].map(|theta_i| peak("lafortune", &[30.0, 1.2], theta_i));
        assert!(
            other[1].0 < 0.1 * other[0].0 && other[0].1 < 41.0,
            "{other:?}"
        );
    }
}
