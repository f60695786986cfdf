//! Looking at the files of a folder in the background, one at a time.

use super::{Examined, Hold, LibraryMsg, Thumbnail};
use crate::app::jobs::Outbox;
use crate::app::state::CancelFlag;
use crate::app::update::Msg;
use crate::files::{self, FileError, folder};
use crate::geom::color::srgb_bytes;
use crate::measured::Table;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

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
        let color = srgb_bytes(table.mean_reflectance());
        let picture = thumbnail(&table, color);
        let name = file.display().to_string();
        Ok(Examined {
            valid_share: table.valid_count() as f64 / table.grid().len() as f64,
            half_width: table.highlight_half_width(),
            color,
            thumbnail: Thumbnail(self.outbox.texture(name, picture)),
        })
    }

    fn say(&self, msg: LibraryMsg) {
        if !self.cancel.is_set() {
            self.outbox.send(Msg::Library(msg));
        }
    }
}

/// A disc in the colour of the material.
fn thumbnail(_table: &Table, [r, g, b]: [u8; 3]) -> egui::ColorImage {
    let radius = 0.5 * THUMBNAIL as f32;
    let pixel = |index: usize| {
        let at = |k: usize| k as f32 + 0.5 - radius;
        let from_center = at(index % THUMBNAIL).hypot(at(index / THUMBNAIL));
        let cover = (radius - from_center).clamp(0.0, 1.0);
        egui::Color32::from_rgb(r, g, b).gamma_multiply(cover)
    };
    let pixels = (0..THUMBNAIL * THUMBNAIL).map(pixel).collect();
    egui::ColorImage::new([THUMBNAIL; 2], pixels)
}
