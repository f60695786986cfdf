//! The lessons themselves.

use crate::app::lessons::{Lesson, LessonStep, LookAt, Set, five_models};
use crate::app::state::view_settings::AnySettings;
use crate::app::state::views::ViewId;
use crate::app::views::disc::settings::DiscSettings;
use crate::app::views::sphere::settings::Show;
use crate::brdf::{Fresnel, ParamId};
use crate::figure::RadialScale;
use crate::figure::shown::Shown;
use crate::fit::StageSet;

/// All lessons in the order of the menu.
pub const LESSONS: [Lesson; 5] = [
    Lesson {
        title: "Two cosines",
        about: "Phong against Blinn-Phong: what each measures, and what it does to a highlight",
        steps: &[
            LessonStep {
                text: "Light comes in along ω_{i}; a mirror would send it out along ω_{r}. Phong asks how far the viewer \
                       ω_{o} is from ω_{r}: f_{r} falls with (ω_{r}·ω_{o})^{s}. Point at the lobe to move ω_{o}.",
                set: &[
                    Set::Sample("copper-glaze"),
                    Set::Model("phong"),
                    Set::Fresnel(Fresnel::None),
                    Set::Param(ParamId::RHO_D, 0.1),
                    Set::Param(ParamId::K_S, 1.0),
                    Set::Param(ParamId("s"), 30.0),
                    Set::Sphere(Show::Model),
                    Set::Scale(RadialScale::Linear),
                    Set::Angles(&[30.0], 0),
                    Set::Tile(ViewId::Lobes),
                ],
                look_at: LookAt::Tile(ViewId::Lobes),
            },
            LessonStep {
                text: "Blinn-Phong takes the half vector ω_{h} between ω_{i} and ω_{o} and asks how far it is from the \
                       normal: (ω_{h}·n)^{s}. Near the mirror direction ω_{h} turns half as far as ω_{o}, so s has to be \
                       four times as large for the same highlight.",
                set: &[Set::Model("blinn-phong"), Set::Param(ParamId("s"), 120.0)],
                look_at: LookAt::Model,
            },
            LessonStep {
                text: "On a sphere under a glancing light: Phong's highlight is elongated, across the plane in which \
                       the light comes in. Switch to Blinn-Phong and back: there it is circular.",
                set: &[
                    Set::Model("phong"),
                    Set::Param(ParamId("s"), 30.0),
                    Set::Lights(1),
                    Set::Tile(ViewId::Sphere),
                ],
                look_at: LookAt::Tile(ViewId::Sphere),
            },
            LessonStep {
                text: "Now the light grazes, from behind the sphere. Phong's highlight is a wide band along the rim; \
                       Blinn-Phong's is condensed. This difference is what tells measured materials apart.",
                set: &[Set::Lights(2)],
                look_at: LookAt::Tile(ViewId::Sphere),
            },
            LessonStep {
                text: "Seen from above, over all view directions under light at 70°: Phong's highlight is round about \
                       ω_{r}. Switch to Blinn-Phong: it is as long in the plane of incidence, but narrower across, by \
                       cos θ_{i}. That is what condenses it on the sphere.",
                set: &[
                    Set::Lights(0),
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
                text: "In the plane of incidence alone the two are alike: at 80° as at 30° each keeps its shape and only \
                       turns, until the horizon cuts it off. Try both models and drag the handle of the light. A curve in \
                       this plane does not tell them apart; the sphere and the disc do.",
                set: &[
                    Set::Angles(&[30.0, 60.0, 80.0], 2),
                    Set::Tile(ViewId::Lobes),
                ],
                look_at: LookAt::Tile(ViewId::Lobes),
            },
        ],
    },
    Lesson {
        title: "Between the two",
        about: "Why the new model has α, and why its half-vector cosine has a fourth power",
        steps: &[
            LessonStep {
                text: "The combined model raises a blend of both cosines to the power s: \
                       (1 − α)(ω_{r}·ω_{o}) + α(ω_{h}·n)^{4}. At α = 0 it is Phong itself.",
                set: &[
                    Set::Sample("copper-glaze"),
                    Set::Model("combined"),
                    Set::Fresnel(Fresnel::None),
                    Set::Param(ParamId::RHO_D, 0.1),
                    Set::Param(ParamId::K_S, 1.0),
                    Set::Param(ParamId("s"), 30.0),
                    Set::Param(ParamId("alpha"), 0.0),
                    Set::Sphere(Show::Model),
                    Set::Scale(RadialScale::CubeRoot),
                    Set::Angles(&[5.0, 60.0, 80.0], 0),
                    Set::Tile(ViewId::Lobes),
                ],
                look_at: LookAt::Model,
            },
            LessonStep {
                text: "At α = 1 it is Blinn-Phong with exponent 4s. Look at the lobe of 5°: it is as it was. For a small \
                       angle x, cos^{4}(x/2) and cos x are the same up to x^{4}. So α does not touch the highlight seen from \
                       above, and s keeps its meaning.",
                set: &[Set::Param(ParamId("alpha"), 1.0)],
                look_at: LookAt::Tile(ViewId::Lobes),
            },
            LessonStep {
                text: "Drag α. Here are all view directions for light at 70°: what changes is the width across the plane \
                       of incidence. α says how a material behaves at grazing angles, and nothing else.",
                set: &[
                    Set::Param(ParamId("alpha"), 0.5),
                    Set::Angles(&[5.0, 60.0, 80.0], 2),
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
                look_at: LookAt::Param(ParamId("alpha")),
            },
            LessonStep {
                text: "This material was made to lie between the two. The left sphere is the data. Drag α until the \
                       highlight along the rim has the same shape on both; then let the fit find it.",
                set: &[
                    Set::Fresnel(Fresnel::Exact),
                    Set::Param(ParamId::K_S, 6.0),
                    Set::Param(ParamId("s"), 12.0),
                    Set::Param(ParamId::ETA, 1.5),
                    Set::Lights(2),
                    Set::Sphere(Show::SideBySide),
                    Set::Tile(ViewId::Sphere),
                    Set::Tile(ViewId::Lobes),
                ],
                look_at: LookAt::Tile(ViewId::Sphere),
            },
        ],
    },
    Lesson {
        title: "Fresnel at grazing angles",
        about: "Why a highlight grows towards the horizon, and what k_s and η share",
        steps: &[
            LessonStep {
                text: "Without a Fresnel factor Phong's lobes at 30°, 60° and 80° are of one height. The measured lobes \
                       grow: a coat reflects more, the more the light grazes.",
                set: &[
                    Set::Sample("green-lacquer"),
                    Set::Model("phong"),
                    Set::Fresnel(Fresnel::None),
                    Set::Param(ParamId::K_S, 1.0),
                    Set::Param(ParamId("s"), 60.0),
                    Set::Param(ParamId::ETA, 1.5),
                    Set::Scale(RadialScale::CubeRoot),
                    Set::Angles(&[30.0, 60.0, 80.0], 2),
                    Set::Tile(ViewId::Lobes),
                ],
                look_at: LookAt::Tile(ViewId::Lobes),
            },
            LessonStep {
                text: "The Fresnel equations give that factor for a smooth dielectric of refractive index η: R_{F} is \
                       about 4 % from above at η = 1.5 and 1 at the horizon. k_{s} was raised by 1/R_{F}(0), so the lobe seen \
                       from above is what it was.",
                set: &[Set::Fresnel(Fresnel::Exact), Set::Param(ParamId::K_S, 25.0)],
                look_at: LookAt::Model,
            },
            LessonStep {
                text: "Drag η. Towards 1 the factor at 0° vanishes and only the product k_{s}·R_{F}(0) means anything; it \
                       stands below the sliders. The larger η, the less the lobes grow.",
                set: &[Set::Param(ParamId::ETA, 1.2)],
                look_at: LookAt::Param(ParamId::ETA),
            },
            LessonStep {
                text: "Schlick's approximation is a fifth power with the same value at 0°. Switch between Exact and \
                       Schlick: between 60° and 85° they part, most of all for a small η.",
                set: &[Set::Fresnel(Fresnel::Schlick)],
                look_at: LookAt::Tile(ViewId::Lobes),
            },
        ],
    },
    Lesson {
        title: "Why L1, and why stages",
        about: "What the fit minimises, how it goes on, and what a poor start does",
        steps: &[
            LessonStep {
                text: "The fit minimises the sum of |model − data|, not of squares. A few cells at the peak are a \
                       thousand times as bright as the rest: squares would fit these alone. With absolute values the broad \
                       base of the highlight decides.",
                set: &[
                    Set::Sample("blue-porcelain"),
                    Set::Model("combined"),
                    Set::Fresnel(Fresnel::Exact),
                    Set::Param(ParamId::RHO_D, 0.3),
                    Set::Param(ParamId::K_S, 5.0),
                    Set::Param(ParamId("s"), 5.0),
                    Set::Param(ParamId("alpha"), 0.1),
                    Set::Param(ParamId::ETA, 1.5),
                    Set::Sphere(Show::Split),
                    Set::Scale(RadialScale::CubeRoot),
                    Set::Angles(&[30.0, 60.0, 80.0], 1),
                ],
                look_at: LookAt::Tile(ViewId::Lobes),
            },
            LessonStep {
                text: "Only stage 1 is ticked, and it begins at the sliders. Press Fit: for a given s, α and η the best \
                       ρ_{d} and k_{s} are found exactly. With an s this poor there is not much to win.",
                set: &[Set::Stages(
                    StageSet {
                        amplitudes: true,
                        ..StageSet::NONE
                    },
                    true,
                )],
                look_at: LookAt::Fit,
            },
            LessonStep {
                text: "Now stages 1 to 3, as on the poster: ρ_{d} and k_{s}, then s, α and η, then these with k_{s}. Press \
                       Fit and watch E fall in the trace. Each stage keeps what it does not move, so ρ_{d} is still that \
                       of the poor start.",
                set: &[Set::Stages(StageSet::POSTER, true)],
                look_at: LookAt::Fit,
            },
            LessonStep {
                text: "With stage 4 all parameters move together, and the fit begins at several places that the data \
                       suggest. Press Fit: E falls once more, and no start is poor any longer.",
                set: &[Set::Stages(StageSet::ALL, false)],
                look_at: LookAt::Fit,
            },
        ],
    },
    five_models::LESSON,
];
