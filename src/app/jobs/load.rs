//! Reading files and making samples in the background.

use crate::app::msg::command::Command;
use crate::app::msg::library::LibraryMsg;
use crate::app::msg::session::SessionMsg;
use crate::app::msg::work::{SendMsg, Work};
use crate::app::msg::{Loaded, Msg};
use crate::app::session;
use crate::app::session::places::find;
use crate::app::state::job::CancelFlag;
use crate::app::state::material::Origin;
use crate::app::state::notice::Severity;
use crate::export::{FigureSpec, SubjectSource, recipe_in};
use crate::files;
use crate::files::fits::MaterialFits;
use crate::files::{FileError, Json, fits};
use crate::measured::Table;
use crate::measured::samples::SAMPLES;
use crate::quote::{quoted, shown};
use std::ops::ControlFlow;
use std::path::Path;

/// Reads a file or makes a sample: a material, with what a fit file has for it; or a fit file, a session, a folder.
pub fn load(job: u64, origin: Origin, fits: Option<Box<MaterialFits>>, cancel: CancelFlag) -> Work {
    let doing = match &origin {
        Origin::Sample(index) => format!("making {}", SAMPLES[*index].name),
        Origin::File(path) => format!("reading {}", files::folder::shown_name(path)),
    };
    let failed_origin = origin.clone();
    Work::new(doing, move |send| read(job, origin, fits, &cancel, send))
        // One after the other, so that a hundred dropped files do not fight for disk and memory.
        .in_turn("reading")
        .or_tell(move |text| Msg::Loaded {
            job,
            origin: failed_origin,
            result: Err(Some(text)),
        })
}

fn read(
    job: u64,
    origin: Origin,
    fits: Option<Box<MaterialFits>>,
    cancel: &CancelFlag,
    send: &SendMsg,
) {
    let mut progress = |fraction: f32| {
        send(Msg::Progress {
            job,
            progress: fraction,
        });
        if cancel.is_set() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let result = if progress(0.0).is_break() {
        Err(None)
    } else {
        match &origin {
            Origin::Sample(index) => {
                let sample = &SAMPLES[*index];
                let name = sample.name.to_string();
                Ok(Loaded::new(name, None, sample.synthesize()))
            }
            Origin::File(path) => match (open_file(path, fits.is_some(), &mut progress), fits) {
                (Ok(Content::Material(loaded)), fits) => Ok(Loaded { fits, ..*loaded }),
                (Ok(Content::Folder), _) => {
                    send(Msg::Loaded {
                        job,
                        origin: origin.clone(),
                        result: Err(None),
                    });
                    send(Msg::Library(LibraryMsg::Open(path.clone())));
                    return;
                }
                (Ok(Content::Fits(fits)), _) => {
                    let path = path.clone();
                    send(Msg::FitsRead { job, path, fits });
                    return;
                }
                (Ok(Content::Session(found)), _) => {
                    let path = path.clone();
                    send(Msg::Session(SessionMsg::Read { job, path, found }));
                    return;
                }
                (Ok(Content::Figure(shown)), _) => {
                    send(Msg::Loaded {
                        job,
                        origin: origin.clone(),
                        result: Err(None),
                    });
                    open_each(shown, send);
                    let name = files::folder::shown_name(path);
                    let text = format!(
                        "The data of the figure {name} are opened; grazing figure {name} -o FILE.pdf draws it."
                    );
                    send(Msg::Notify(Severity::Info, text));
                    return;
                }
                (Err(_), _) if cancel.is_set() => Err(None),
                (Err(error), Some(fits)) => {
                    send(Msg::Notify(Severity::Error, error.to_string()));
                    Ok(Loaded::alone(fits))
                }
                (Err(error), None) => Err(Some(error.to_string())),
            },
        }
    };
    send(Msg::Loaded {
        job,
        origin,
        result,
    });
}

/// Content of a file.
enum Content {
    Material(Box<Loaded>),
    Fits(Vec<MaterialFits>),
    Session(Box<session::places::FoundSession>),
    /// The data that a figure shows.
    Figure(Vec<Origin>),
    Folder,
}

/// `measured`: a fit file names it as its data. A fit file that names itself must not be read for ever.
fn open_file(
    path: &Path,
    measured: bool,
    progress: files::OnProgress,
) -> Result<Content, FileError> {
    if !measured && path.is_dir() {
        return Ok(Content::Folder);
    }
    if !measured && let Some(recipe) = recipe_in(path)? {
        return data_of_figure(path, &recipe).map(Content::Figure);
    }
    let json = if measured {
        None
    } else {
        files::open_json(path)?
    };
    if let Some(Json::Session(text)) = &json {
        let found = find(path, text)?;
        // Made here and not on the window's thread.
        Table::unmeasured();
        return Ok(Content::Session(Box::new(found)));
    }
    if let Some(Json::Figure(text)) = &json {
        return data_of_figure(path, text).map(Content::Figure);
    }
    if let Some(Json::Models(entries)) = json {
        let fits = fits::by_material(path, entries);
        if fits.iter().any(|fits| fits.found.is_none()) {
            // Made here and not on the window's thread.
            Table::unmeasured();
        }
        return Ok(Content::Fits(fits));
    }
    let (table, source) = files::open_measured(path, progress)?;
    let loaded = Loaded::new(files::material_name(path), Some(source), table);
    Ok(Content::Material(Box::new(loaded)))
}

/// Opens samples and files.
fn open_each(origins: Vec<Origin>, send: &SendMsg) {
    let mut paths = Vec::new();
    for origin in origins {
        match origin {
            Origin::Sample(index) => send(Msg::Run(Command::OpenSample(index))),
            Origin::File(path) => paths.push(path),
        }
    }
    if !paths.is_empty() {
        send(Msg::OpenFiles(paths));
    }
}

/// The data that a figure shows, each once; its models have their numbers in the figure alone.
fn data_of_figure(path: &Path, text: &str) -> Result<Vec<Origin>, FileError> {
    let error = |what: String| FileError::new(path, what);
    let spec = FigureSpec::from_json(text).map_err(error)?;
    let folder = files::absolute(path);
    let folder = folder.parent().unwrap_or(Path::new(""));
    let mut found = Vec::new();
    for subject in spec.subjects {
        let origin = match &subject.source {
            SubjectSource::Model(_) => continue,
            SubjectSource::Sample { key, .. } => {
                let index = SAMPLES.iter().position(|sample| sample.key == key);
                Origin::Sample(
                    index.ok_or_else(|| error(format!("unknown sample {}", quoted(key))))?,
                )
            }
            SubjectSource::Measured { file, .. } => {
                let mut places = file.places(folder).into_iter();
                let place = places.find(|place| place.is_file());
                let missing = || {
                    let label = shown(&subject.label);
                    error(format!(
                        "the measured file of {label} is missing; put it where the figure says or beside it"
                    ))
                };
                Origin::File(place.ok_or_else(missing)?)
            }
        };
        if !found.contains(&origin) {
            found.push(origin);
        }
    }
    if found.is_empty() {
        let what = "this figure shows models only; grazing figure FILE -o FILE.pdf draws it";
        return Err(error(what.into()));
    }
    Ok(found)
}
