//! Looking at the files of a folder in the background: names, then kinds, then every measured file.

use crate::app::jobs::Jobs;
use crate::app::msg::Msg;
use crate::app::msg::library::FolderMsg;
use crate::app::msg::work::{SendMsg, Work};
use crate::app::state::job::{CancelFlag, Hold};
use crate::app::state::library::{Examined, Thumbnail};
use crate::figure::Source;
use crate::figure::sphere_image::{SphereSource, sphere_image};
use crate::files;
use crate::files::{FileError, folder};
use crate::geom::color::srgb_bytes;
use crate::geom::sphere::SphereView;
use crate::measured::{Lookup, Table};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Number of files reported at once: each message redraws the window.
const BATCH: usize = 32;
/// Width and height of a thumbnail in pixels.
pub const THUMBNAIL: usize = 72;

/// A scan of a folder.
#[derive(Clone)]
pub struct Scanner {
    /// Number of the folder.
    pub number: u64,
    /// Ends the scan.
    pub cancel: CancelFlag,
    /// Makes it wait.
    pub hold: Hold,
    /// Starts the jobs of the scan.
    pub jobs: Jobs,
}

impl Scanner {
    /// Starts the scan of this folder.
    pub fn start(self, path: PathBuf) {
        let jobs = self.jobs.clone();
        let number = self.number;
        let doing = format!("looking at {}", folder::shown_name(&path));
        let failed = move |text| {
            let result = Err(text);
            Msg::Library(FolderMsg::Listed { number, result }.into())
        };
        jobs.start(Work::new(doing, move |_| self.run(&path)).or_tell(failed));
    }

    /// Lists the folder, tells the kind of every file, then starts a job for every measured one.
    fn run(&self, path: &Path) {
        let number = self.number;
        let result = folder::list(path).map_err(|error| error.to_string());
        let files = result.as_ref().cloned().unwrap_or_default();
        self.send(FolderMsg::Listed { number, result });
        for index in self.look(&files) {
            self.jobs
                .start(self.clone().examine_in_turn(index, files[index].clone()));
        }
        let scanner = self.clone();
        let end = move |_: &SendMsg| scanner.send(FolderMsg::Scanned { number });
        self.jobs
            .start(Work::new("ending the scan", end).in_turn(LANE));
    }

    /// Tells the kinds of the files; returns the positions of the measured ones.
    fn look(&self, files: &[PathBuf]) -> Vec<usize> {
        let mut measured = Vec::new();
        for (k, batch) in files.chunks(BATCH).enumerate() {
            self.hold.wait(&self.cancel);
            let mut seen = Vec::new();
            for (index, file) in (k * BATCH..).zip(batch) {
                if self.cancel.is_set() {
                    return Vec::new();
                }
                let content = folder::inspect(file);
                if matches!(content, Ok(folder::FileContent::Measured)) {
                    measured.push(index);
                }
                seen.push((index, content.map_err(|error| error.reason())));
            }
            self.send(FolderMsg::Seen {
                number: self.number,
                seen,
            });
        }
        measured
    }

    fn examine_in_turn(self, index: usize, file: PathBuf) -> Work {
        let number = self.number;
        let examined = move |result| FolderMsg::Examined {
            number,
            index,
            result,
        };
        let doing = format!("reading {}", folder::shown_name(&file));
        Work::new(doing, move |_| {
            self.hold.wait(&self.cancel);
            if !self.cancel.is_set() {
                let result = self.examine(&file).map_err(|error| error.reason());
                self.send(examined(result));
            }
        })
        .in_turn(LANE)
        .or_tell(move |text| Msg::Library(examined(Err(text)).into()))
    }

    fn examine(&self, file: &Path) -> Result<Examined, FileError> {
        let table = files::open_table(file, &mut |_| {
            self.hold.wait(&self.cancel);
            if self.cancel.is_set() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })?;
        let table = Arc::new(table);
        let picture = thumbnail(&table);
        let name = file.display().to_string();
        Ok(Examined {
            valid_share: table.valid_count() as f64 / table.grid().len() as f64,
            half_width: table.highlight_half_width(),
            color: srgb_bytes(table.mean_reflectance()),
            thumbnail: Thumbnail(self.jobs.sender().texture(name, picture)),
        })
    }

    fn send(&self, msg: FolderMsg) {
        if !self.cancel.is_set() {
            self.jobs.sender().send(Msg::Library(msg.into()));
        }
    }
}

const LANE: &str = "scan";

/// The material on a sphere under the first lights.
fn thumbnail(table: &Arc<Table>) -> egui::ColorImage {
    let source = Source::Measured(Arc::clone(table), Lookup::Smooth);
    let bytes = sphere_image(
        &SphereSource::One(source),
        &SphereView::default(),
        THUMBNAIL,
    );
    egui::ColorImage::from_rgba_premultiplied([THUMBNAIL; 2], &bytes)
}
