//! Reducer of the window, the one place where the state changes: `apply(state, message) → tasks`.

pub(crate) mod closing;
pub mod command;
pub(crate) mod context;
pub mod figure;
pub mod fit;
pub mod fit_files;
pub mod folder_fit;
pub mod lesson;
pub mod letters;
pub mod library;
pub mod listing;
pub mod memory;
pub mod names;
pub mod open_session;
pub mod opening;
pub mod opening_fit;
pub mod session;
pub mod show;

use crate::app::msg::{Msg, Task};
use crate::app::reduce::context::{Context, Edit};
use crate::app::reduce::opening::load;
use crate::app::state::material::Origin;
use crate::app::state::notice::{Dialog, Severity};
use crate::app::state::subjects::Subjects;
use crate::app::state::{Scene, State, subjects};
use crate::brdf::{Brdf, ParamId};
use crate::files::session::has_ending;
use crate::geom::color::luminance;

/// Changes the state. Whatever happened, open materials have names of their own, what was opened is fitted in its turn,
/// what is shown stays in memory, and the rest within its limit.
pub fn apply(state: &mut State, msg: Msg) -> Vec<Task> {
    let mut tasks = change(state, msg);
    names::tell_apart(state);
    tasks.extend(opening_fit::next(state));
    tasks.extend(memory::keep(state));
    tasks
}

fn change(state: &mut State, msg: Msg) -> Vec<Task> {
    match msg {
        Msg::Run(command) => return command::run(state, command),
        Msg::OpenFiles(mut paths) => {
            // A session takes the place of what is open; what comes with it is added.
            paths.sort_by_key(|path| !has_ending(path));
            return paths
                .into_iter()
                .map(|path| load(state, Origin::File(path)))
                .collect();
        }
        Msg::Progress { job, progress } => {
            if let Some(job) = state.jobs.iter_mut().find(|other| other.id == job) {
                job.progress = progress;
            }
        }
        Msg::Loaded {
            job,
            origin,
            result,
        } => {
            let mut tasks = show::loaded(state, job, origin, result);
            tasks.extend(lesson::perform(state));
            return tasks;
        }
        Msg::FitsRead { job, path, fits } => {
            state.jobs.retain(|other| other.id != job);
            return fit_files::open(state, &path, fits);
        }
        Msg::Cancel(job) => {
            if let Some(job) = state.jobs.iter().find(|other| other.id == job) {
                job.cancel.set();
            }
        }
        Msg::Select(index) => return show::select(state, index),
        Msg::Close(index) => opening::close(state, index),
        Msg::SetParam { id, channel, value } => return set_param(state, id, channel, value),
        Msg::ResetParam(id) => {
            edit_brdf(state, |brdf| {
                if let Some(row) = brdf.model.param(id) {
                    brdf.get_mut(id).fill(row.default);
                }
            });
            return fit::refit(state);
        }
        Msg::SetColor { id, rgb } => {
            edit_brdf(state, |brdf| {
                if let Some(row) = brdf.model.param(id) {
                    let values = brdf.get_mut(id);
                    for (value, to) in values.iter_mut().zip(rgb) {
                        *value = row.clamp(to);
                    }
                }
            });
            return fit::refit(state);
        }
        Msg::MakeGrey(id) => edit_brdf(state, |brdf| make_grey(brdf, id)),
        Msg::Cache(msg) => {
            return msg
                .apply(&mut state.caches)
                .map(Task::Start)
                .into_iter()
                .collect();
        }
        Msg::Lesson { lesson, step } => return lesson::go(state, lesson, step),
        Msg::EndLesson => state.lesson = None,
        Msg::Fit(msg) => return fit::apply(state, msg),
        Msg::Figure(msg) => {
            let mut part = figure::FigurePart {
                views: &mut state.views,
                prefs: &mut state.prefs.figure,
                dialog: &mut state.dialog,
            };
            return figure::apply(&mut part, msg);
        }
        Msg::Library(msg) => return library::apply(state, msg),
        Msg::Session(msg) => return session::apply(state, msg),
        Msg::SetView(settings) => edit(state, |scene| scene.views.set(settings)),
        Msg::SetLayout(tiles) => state.tiles = tiles,
        Msg::SetPrefs(prefs) => state.prefs = *prefs,
        Msg::TakeModel(brdf) => return fit::take(state, brdf),
        Msg::Hover(probe) => state.hovered = probe,
        Msg::Pin(probe) => state.pinned = probe,
        Msg::Legend { key, solo } => {
            let all = Subjects::of(state).keys;
            edit(state, |scene| subjects::toggle(scene, &all, key, solo));
        }
        Msg::SetBeside(index, beside) => edit(state, |scene| {
            if let Some(opened) = scene.opened.get_mut(index) {
                opened.beside = beside;
            }
        }),
        Msg::Typed(text) => state.typed = text,
        Msg::ReadGuide(at) => state.dialog = Some(Dialog::Guide(at)),
        Msg::CloseDialog => state.dialog = None,
        Msg::Narrow(narrow) => state.prefs.panels.is_narrow = narrow,
        Msg::ShowTab(tab) => state.prefs.panels.tab = tab,
        Msg::Notify(level, text) => notify(state, level, text),
        Msg::Letters(found) => return letters::look_for(state, found),
        Msg::FontsFound { fonts, lacking } => {
            letters::lacking(state, &lacking);
            return vec![Task::AddFonts(fonts)];
        }
        Msg::Dismiss(id) => state.notices.retain(|notice| notice.id != id),
        Msg::Settle => state.history.settle(&state.scene),
    }
    Vec::new()
}

/// Gives a channel of a parameter a value; all channels where `channel` is `None`.
pub(crate) fn set_param(
    state: &mut State,
    id: ParamId,
    channel: Option<usize>,
    value: f64,
) -> Vec<Task> {
    edit_brdf(state, |brdf| {
        let Some(row) = brdf.model.param(id) else {
            return;
        };
        let value = row.clamp(value);
        let values = brdf.get_mut(id);
        match channel {
            Some(channel) => values[channel] = value,
            None => values.fill(value),
        }
    });
    fit::refit(state)
}

fn make_grey(brdf: &mut Brdf, id: ParamId) {
    let values = brdf.get_mut(id);
    if let [r, g, b] = *values {
        values.fill(luminance([r, g, b]));
    }
}

/// Changes the scene, in a step that undo takes back.
pub(crate) fn edit(state: &mut State, change: impl FnOnce(&mut Scene)) {
    let State { scene, history, .. } = state;
    Edit { scene, history }.edit(change);
}

/// Changes the shown model. A fit that moves it is stopped: its best so far is what is changed.
pub(crate) fn edit_brdf(state: &mut State, change: impl FnOnce(&mut Brdf)) {
    fit::release_model(state);
    // A person has laid a model over it: that is what is to be seen.
    if let Some(id) = state.current().map(|(_, opened)| opened.id) {
        opening_fit::set_due(state, id, false);
    }
    edit(state, |scene| {
        if let Some(opened) = scene.opened.get_mut(scene.selected) {
            change(&mut opened.brdf);
        }
    });
}

/// Says something in the corner of the window.
pub(crate) fn notify(state: &mut State, level: Severity, text: String) {
    let State {
        notices, next_id, ..
    } = state;
    Context { notices, next_id }.notify(level, text);
}
