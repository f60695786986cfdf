//! Reducer of commands: how each changes the state.

use crate::app::command::Command;
use crate::app::guide::GuideAt;
use crate::app::msg::figure::FigureTask;
use crate::app::msg::fit::FitMsg;
use crate::app::msg::library::LibraryTask;
use crate::app::msg::{ModelExport, Task};
use crate::app::reduce::opening::load;
use crate::app::reduce::{
    edit, edit_brdf, figure, fit, folder_fit, lesson, library, opening, session, show,
};
use crate::app::state::State;
use crate::app::state::fitting::settings::FitSettings;
use crate::app::state::layout::Tiles;
use crate::app::state::material::Origin;
use crate::app::state::notice::Dialog;
use crate::app::views::lobes::settings::LobeSettings;
use crate::app::views::sphere::settings::SphereSettings;
use crate::brdf::{Brdf, Fresnel, MODELS, Model, PHONG_FAMILY};
use crate::geom::sphere::LIGHT_PRESETS;
use crate::measured::lookup::Lookup;
use crate::measured::samples::SAMPLES;

/// Runs a command.
pub(crate) fn run(state: &mut State, command: Command) -> Vec<Task> {
    match command {
        Command::Open => return vec![Task::PickFiles],
        Command::OpenSample(index) if index < SAMPLES.len() => {
            return vec![load(state, Origin::Sample(index))];
        }
        Command::OpenSample(_) => {}
        Command::OpenRecent(index) => {
            let path = state.prefs.recent.get(index).cloned();
            return path
                .map(|path| load(state, Origin::File(path)))
                .into_iter()
                .collect();
        }
        Command::Close => opening::close(state, state.scene.selected),
        Command::ExportModel(format) => {
            let export = state.current().map(|(material, opened)| ModelExport {
                format,
                material: material.own_name.clone(),
                brdf: opened.brdf,
            });
            return export.map(Task::ExportModel).into_iter().collect();
        }
        Command::SaveSession => return session::save(state, false),
        Command::SaveSessionAs => return session::save(state, true),
        Command::SavePicture => return vec![Task::SavePicture],
        Command::Quit => return vec![Task::Quit],
        Command::Undo => {
            // A fit under way is the step that is taken back.
            fit::release_model(state);
            fit::forget_refits(state);
            let State { history, scene, .. } = state;
            history.undo(scene);
        }
        Command::Redo => {
            fit::release_model(state);
            fit::forget_refits(state);
            let State { history, scene, .. } = state;
            history.redo(scene);
        }
        Command::GuessParams => {
            if let Some(guess) = state.current().map(|(material, _)| material.guess) {
                edit_brdf(state, |brdf| *brdf = guess.with_model(brdf.model));
                return fit::refit(state);
            }
        }
        Command::ResetParams => {
            edit_brdf(state, |brdf| {
                brdf.params = brdf.model.default_params();
            });
            return fit::refit(state);
        }
        Command::UseModel(index) => {
            let model: &'static Model = MODELS[index.min(MODELS.len() - 1)];
            edit_brdf(state, |brdf| *brdf = brdf.with_model(model));
            return fit::refit(state);
        }
        Command::UseFresnel(fresnel) => {
            edit_brdf(state, |brdf| change_fresnel(brdf, fresnel));
            return fit::refit(state);
        }
        Command::Fit => return fit::start(state),
        Command::Compare => return fit::compare(state),
        Command::CompareFamily => state.prefs.comparison.set_models(PHONG_FAMILY),
        Command::CompareEvery => state.prefs.comparison.set_models(MODELS),
        Command::ToggleCompared(index) => {
            if let Some(model) = MODELS.get(index) {
                state.prefs.comparison.toggle_model(model);
            }
        }
        Command::ToggleComparedFresnel(fresnel) => state.prefs.comparison.toggle_fresnel(fresnel),
        Command::CancelFit => fit::stop(state),
        Command::ToggleKeepOptimal => {
            state.fit.keep_optimal = !state.fit.keep_optimal;
            fit::forget_refits(state);
            return fit::refit_as_step(state);
        }
        Command::ToggleFromSliders => {
            state.fit.settings.from_sliders = !state.fit.settings.from_sliders;
        }
        Command::ToggleFitOnOpening => {
            state.prefs.fit_on_opening.0 = !state.prefs.fit_on_opening.0;
        }
        Command::UseWeight(weight) => {
            let settings = FitSettings {
                weight,
                ..state.fit.settings.clone()
            };
            return fit::apply(state, FitMsg::Settings(settings));
        }
        Command::NextMaterial => return show::step(state, 1),
        Command::PreviousMaterial => return show::step(state, -1),
        Command::OpenFolder => return vec![Task::Library(LibraryTask::Pick)],
        Command::CloseFolder => library::close(state),
        Command::FitFolder => return folder_fit::start(state, false),
        Command::CompareFolder => return folder_fit::start(state, true),
        Command::CancelFitFolder => state.library.run = None,
        Command::SaveFits => {
            let fits = state.library.folder_fits().cloned().collect();
            return vec![Task::Library(LibraryTask::Save(fits))];
        }
        Command::UseShow(show) => edit(state, |scene| {
            scene.views.get_mut::<SphereSettings>().show = show;
        }),
        Command::UseLights(index) => edit(state, |scene| {
            if let Some(preset) = LIGHT_PRESETS.get(index) {
                scene.views.get_mut::<SphereSettings>().view.lights = (preset.lights)();
            }
        }),
        Command::UseScale(scale) => edit(state, |scene| {
            scene.views.get_mut::<LobeSettings>().scale = scale;
        }),
        Command::ToggleShapeOnly => edit(state, |scene| {
            let lobes = scene.views.get_mut::<LobeSettings>();
            lobes.shape_only = !lobes.shape_only;
            // Shares and values have other ends.
            lobes.limits = None;
        }),
        Command::ToggleCosine => edit(state, |scene| {
            let cosine = &mut scene.views.get_mut::<LobeSettings>().cosine;
            cosine.theta_i = !cosine.theta_i;
        }),
        Command::ToggleCosineO => edit(state, |scene| {
            let cosine = &mut scene.views.get_mut::<LobeSettings>().cosine;
            cosine.theta_o = !cosine.theta_o;
        }),
        Command::ToggleRaw => edit(state, |scene| {
            scene.lookup = if scene.lookup == Lookup::Nearest {
                Lookup::Smooth
            } else {
                Lookup::Nearest
            };
        }),
        Command::UseTheme(theme) => state.prefs.theme = theme,
        Command::ZoomIn => state.prefs.zoom = state.prefs.zoom.larger(),
        Command::ZoomOut => state.prefs.zoom = state.prefs.zoom.smaller(),
        Command::ZoomReset => state.prefs.zoom = Default::default(),
        Command::TogglePanel(side) => state.prefs.panels.toggle(side),
        Command::ResetLayout => state.tiles = Tiles::default(),
        Command::ToggleTile(pane) => state.tiles.toggle(pane),
        Command::Unpin => state.pinned = None,
        Command::ExportFigure => {
            state.views.chosen = figure::first_views(state);
            state.dialog = Some(Dialog::Figure);
        }
        Command::Copy => {
            let values = state.pinned.is_some() || state.views.pointed.is_none();
            return if values && Command::CopyProbe.is_enabled(state) {
                copy_probe(state)
            } else {
                figure::copy(state, FigureTask::CopyPicture)
            };
        }
        Command::CopyPicture => return figure::copy(state, FigureTask::CopyPicture),
        Command::CopyNumbers => return figure::copy(state, FigureTask::CopyNumbers),
        Command::CopyProbe => return copy_probe(state),
        Command::CopyParams => {
            if let Some((_, opened)) = state.current() {
                return vec![Task::Copy(
                    crate::brdf::json::to_value(&opened.brdf).to_string(),
                )];
            }
        }
        Command::ClearRecent => state.prefs.recent.clear(),
        Command::Palette => {
            state.typed.clear();
            state.dialog = Some(Dialog::Palette);
        }
        Command::OpenPath => {
            state.typed.clear();
            state.dialog = Some(Dialog::OpenPath);
        }
        Command::Lesson(lesson) => return lesson::go(state, lesson, 0),
        Command::Guide => state.dialog = Some(Dialog::Guide(GuideAt::default())),
        Command::Conventions => state.dialog = Some(Dialog::Conventions),
        Command::About => state.dialog = Some(Dialog::About),
    }
    Vec::new()
}

/// Puts the row of the probe on the clipboard.
fn copy_probe(state: &State) -> Vec<Task> {
    state.probe_row().map(Task::Copy).into_iter().collect()
}

/// k_s·R_F(0) stays, so that the highlight seen from above does.
fn change_fresnel(brdf: &mut Brdf, fresnel: Fresnel) {
    let before = brdf.specular_at_normal();
    let r0 = fresnel.reflectance(1.0, brdf.params.eta);
    brdf.fresnel = fresnel;
    if r0 > 0.0 {
        brdf.params.k_s = before.map(|amplitude| amplitude / r0);
    }
}
