//! Starting tasks: what [`crate::app::reduce::apply`] asks to be done outside the state.

use crate::app::jobs::dialogs::{Picker, Purpose, ask, ask_and_write};
use crate::app::jobs::fit::{Problems, fit, refit_amplitudes};
use crate::app::jobs::load::load;
use crate::app::jobs::{Jobs, fonts, library, session};
use crate::app::msg::figure::FigureTask;
use crate::app::msg::work::SendMsg;
use crate::app::msg::{Msg, Task};
use crate::app::paper::figure::figure_of;
use crate::app::paper::work;
use crate::app::state::State;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use std::io;
use std::io::Write;
use std::path::PathBuf;
use std::sync::Arc;

/// Tools that tasks are done with.
pub struct Tools {
    /// Starts jobs.
    pub jobs: Jobs,
    /// The last fit problem.
    pub problems: Arc<Problems>,
    /// Asks for files.
    pub picker: Picker,
}

/// Starts a task of this state. None waits here.
pub fn start(task: Task, state: &State, tools: &Tools, ctx: &egui::Context) {
    let Tools {
        jobs,
        problems,
        picker,
    } = tools;
    match task {
        Task::Load {
            job,
            origin,
            fits,
            cancel,
        } => jobs.start(load(job, origin, fits, cancel)),
        Task::Fit(task) => jobs.start(fit(task, Arc::clone(problems))),
        Task::RefitAmplitudes(task) => jobs.start(refit_amplitudes(task, Arc::clone(problems))),
        Task::Library(task) => library::start(task, jobs, picker),
        Task::Session(task) => session::start(task, jobs, picker),
        Task::Start(work) => jobs.start(work),
        Task::PickFiles => {
            let open = Arc::clone(&picker.open);
            let some = move || Some(open()).filter(|paths| !paths.is_empty());
            let opened = |paths: Vec<PathBuf>, send: &SendMsg| send(Msg::OpenFiles(paths));
            ask(
                jobs,
                picker,
                "asking for files",
                Purpose::Open,
                some,
                opened,
            );
        }
        Task::Figure(task) => start_figure(task, state, tools),
        Task::ExportModel(export) => {
            let name = export.format.file_name(&export.brdf, &export.material);
            ask_and_write(jobs, picker, name, move |file| {
                let material = Some(export.material.as_str());
                export.format.write(&export.brdf, material, file)
            });
        }
        Task::SavePicture => {
            let (jobs, picker) = (jobs.clone(), picker.clone());
            let arrived = move |picture: Arc<egui::ColorImage>| {
                ask_and_write(&jobs, &picker, "grazing.png".into(), move |file| {
                    write_png(&picture, file)
                });
            };
            ctx.send_viewport_cmd(egui::ViewportCommand::Screenshot(
                egui::ScreenshotCallback::new(arrived),
            ));
        }
        Task::FindFonts(letters) => jobs.start(fonts::find(letters)),
        Task::AddFonts(found) => fonts::add(ctx, found),
        Task::Copy(text) => ctx.copy_text(text),
        Task::Quit => ctx.send_viewport_cmd(egui::ViewportCommand::Close),
    }
}

/// Figures are made from what the state shows when they are asked for.
fn start_figure(task: FigureTask, state: &State, tools: &Tools) {
    let (jobs, prefs) = (&tools.jobs, &state.prefs.figure);
    match task {
        FigureTask::Export(views) => {
            let figure = figure_of(state, &views, prefs.columns, &prefs.style);
            if let Some(figure) = figure {
                let (format, name) = (prefs.format, work::file_name(state, &views, prefs.format));
                work::export(figure, format, name, jobs, &tools.picker);
            }
        }
        FigureTask::CopyPicture(view) => {
            if let Some(figure) = figure_of(state, &[view], 1, &prefs.style) {
                work::copy_picture(figure, view.about().name, jobs);
            }
        }
        FigureTask::CopyNumbers(view) => {
            if let Some(figure) = figure_of(state, &[view], 1, &prefs.style) {
                work::copy_numbers(figure, view.about().name, jobs);
            }
        }
    }
}

fn write_png(picture: &egui::ColorImage, file: &mut dyn Write) -> io::Result<()> {
    let [width, height] = picture.size.map(|n| n as u32);
    let bytes: Vec<u8> = picture
        .pixels
        .iter()
        .flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b()])
        .collect();
    PngEncoder::new(file)
        .write_image(&bytes, width, height, ExtendedColorType::Rgb8)
        .map_err(io::Error::other)
}
