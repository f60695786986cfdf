//! Reading files and making samples in the background.

use crate::app::msg::library::LibraryMsg;
use crate::app::msg::session::SessionMsg;
use crate::app::msg::work::{SendMsg, Work};
use crate::app::msg::{Loaded, Msg};
use crate::app::session;
use crate::app::session::places::find;
use crate::app::state::job::CancelFlag;
use crate::app::state::material::Origin;
use crate::app::state::notice::Severity;
use crate::files;
use crate::files::fits::MaterialFits;
use crate::files::{FileError, Json, fits};
use crate::measured::Table;
use crate::measured::samples::SAMPLES;
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
