//! Looking at the files of a folder in the background, one at a time.

use super::{Examined, Hold, LibraryMsg, Thumbnail};
use crate::app::jobs::Outbox;
use crate::app::state::CancelFlag;
use crate::app::update::Msg;
use crate::figure::Source;
use crate::figure::sphere_image::{SphereSource, sphere_image};
use crate::files::{self, FileError, folder};
use crate::geom::color::srgb_bytes;
use crate::geom::sphere::SphereView;
use crate::measured::{Lookup, Table};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How many files are told at once: each message redraws the window.
const BATCH: usize = 32;
/// Width and height of a thumbnail in pixels.
pub const THUMBNAIL: usize = 72;

/// A scan of a folder.
pub struct Scanner {
    /// The folder's.
    pub number: u64,
    /// Ends the scan.
    pub cancel: CancelFlag,
    /// Makes it wait.
    pub hold: Hold,
    /// Where it is told.
    pub outbox: Outbox,
}

impl Scanner {
    /// Lists the folder, says of every file what it is, then reads every measured one.
    pub fn run(&self, path: &Path) {
        let number = self.number;
        let result = folder::list(path).map_err(|error| error.to_string());
        let files = result.as_ref().cloned().unwrap_or_default();
        self.say(LibraryMsg::Listed { number, result });
        for index in self.look(&files) {
            self.hold.wait(&self.cancel);
            let result = self.examine(&files[index]);
            if self.cancel.is_set() {
                return;
            }
            self.say(LibraryMsg::Examined {
                number,
                index,
                result: result.map_err(|error| error.reason()),
            });
        }
        self.say(LibraryMsg::Scanned { number });
    }

    /// Says what the files are; returns the positions of the measured ones.
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
                if matches!(content, Ok(folder::Content::Measured)) {
                    measured.push(index);
                }
                seen.push((index, content.map_err(|error| error.reason())));
            }
            self.say(LibraryMsg::Seen {
                number: self.number,
                seen,
            });
        }
        measured
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
            thumbnail: Thumbnail(self.outbox.texture(name, picture)),
        })
    }

    fn say(&self, msg: LibraryMsg) {
        if !self.cancel.is_set() {
            self.outbox.send(Msg::Library(msg));
        }
    }
}

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
