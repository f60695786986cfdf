//! Drawing figures in the background: for the preview, for files and for the clipboard.

use crate::app::jobs::Jobs;
use crate::app::jobs::dialogs::{Picker, ask_and_do};
use crate::app::msg::Msg;
use crate::app::msg::work::Work;
use crate::app::paper::figure::{Drawable, default_name};
use crate::app::state::State;
use crate::app::state::cache::{Query, Update, WhenNewer};
use crate::app::state::notice::Severity;
use crate::app::state::views::ViewId;
use crate::export::{
    ExportError, FigureFormat, FigureSpec, Prepared, SubjectSource, check_writable, prepare,
    spec_beside, write_figure,
};
use crate::figure::page::Page;
use crate::figure::write::POINTS_PER_MM;
use crate::figure::write::raster::{Pixels, pixels};
use crate::files::FileError;
use crate::measured::Table;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

/// Pictures in a preview have this many pixels to the inch at most: it is there sooner.
const PREVIEW_DPI: f64 = 110.0;

/// The preview of a figure on the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct PreviewQuery {
    /// The figure.
    pub drawable: Drawable,
    /// Pixels to the inch of the paper.
    pub dpi: f64,
}

/// A figure as it will be written.
#[derive(Debug)]
pub struct FigurePreview {
    /// The paper.
    pub pixels: Pixels,
    /// Width and height in millimetres.
    pub size_mm: [f64; 2],
    /// Number of rows of its table of numbers.
    pub numbers: usize,
}

impl Query for PreviewQuery {
    type Output = Result<FigurePreview, String>;
    const DOING: &'static str = "drawing the preview of a figure";
    const WHEN_NEWER: WhenNewer = WhenNewer::FinishFirst;

    fn run(
        &self,
        report: &mut dyn FnMut(Update<Self::Output>) -> ControlFlow<()>,
    ) -> Option<Self::Output> {
        let mut drawable = self.drawable.clone();
        let style = &mut drawable.spec.style;
        style.dpi = style.dpi.min(PREVIEW_DPI);
        let mut go_on = || report(Update::Progress(0.5));
        match draw(&drawable, &mut go_on) {
            Err(ExportError::Stopped) => None,
            Err(error) => Some(Err(error.to_string())),
            Ok(page) => Some(self.sheet(&page)),
        }
    }
}

impl PreviewQuery {
    fn sheet(&self, page: &Page) -> Result<FigurePreview, String> {
        let mm = |points: f32| f64::from(points) / POINTS_PER_MM;
        Ok(FigurePreview {
            pixels: pixels(&page.paper, self.dpi).map_err(|error| error.to_string())?,
            size_mm: page.paper.drawing.size.map(mm),
            numbers: page.table.rows.len(),
        })
    }
}

fn draw(
    drawable: &Drawable,
    go_on: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Page, ExportError> {
    let prepared = prepared(drawable, go_on)?;
    drawable.spec.draw(&prepared, true)
}

fn prepared(
    drawable: &Drawable,
    go_on: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Prepared, ExportError> {
    let mut table = |source: &SubjectSource| -> Result<Arc<Table>, ExportError> {
        let mut known = drawable.tables.iter();
        let found = known.find(|(other, _)| other == source);
        let missing = || ExportError::Other("the data are no longer in memory".into());
        found
            .map(|(_, table)| Arc::clone(table))
            .ok_or_else(missing)
    };
    prepare(&drawable.spec, &mut table, go_on)
}

fn drawn(drawable: &Drawable) -> Result<Page, ExportError> {
    draw(drawable, &mut || ControlFlow::Continue(()))
}

/// Asks where to, and writes a figure and its spec there.
pub fn export(
    drawable: Drawable,
    format: FigureFormat,
    name: String,
    jobs: &Jobs,
    picker: &Picker,
) {
    let sender = jobs.sender().clone();
    ask_and_do(jobs, picker, name, move |path| {
        // The name may say another format than the dialog.
        let format = FigureFormat::of_path(&path).unwrap_or(format);
        let path = match path.extension() {
            Some(_) => path,
            None => path.with_extension(format.extension()),
        };
        let beside = spec_beside(&path);
        if let Some(what) = conflict(&drawable.spec, &path, &beside) {
            return Err(FileError::new(&beside, what).to_string());
        }
        // Said now and not after the work.
        check_writable(&path, true).map_err(|error| error.to_string())?;
        let go_on = &mut || ControlFlow::Continue(());
        // The dialog has asked about an existing file.
        let write = |prepared: Prepared| {
            let figure = (&drawable.spec, &prepared);
            write_figure(&[(path.clone(), format)], figure, true, None)
        };
        let lacking = prepared(&drawable, go_on)
            .and_then(write)
            .map_err(|error| error.to_string())?;
        if !lacking.is_empty() {
            sender.send(Msg::Letters(lacking));
        }
        Ok(path)
    });
}

/// Why the spec of a figure cannot be written beside it, if so. A spec goes with its figure, and the dialog has asked about
/// a figure that is replaced.
fn conflict(spec: &FigureSpec, figure: &Path, beside: &Path) -> Option<&'static str> {
    if !beside.is_file() || spec.is_in(beside) {
        None
    } else if FigureSpec::open(beside).is_err() {
        Some(
            "a file with the name of the figure's spec is there and is no figure; choose another name",
        )
    } else if !figure.exists() {
        Some("the spec of another figure is there under this name; choose another name")
    } else {
        None
    }
}

/// The name that a dialog proposes for a figure of these views.
pub fn file_name(state: &State, views: &[ViewId], format: FigureFormat) -> String {
    format!("{}.{}", default_name(state, views), format.extension())
}

/// Puts the picture of a figure on the clipboard.
pub fn copy_picture(drawable: Drawable, view: &'static str, jobs: &Jobs) {
    let ctx = jobs.sender().ctx().clone();
    on_clipboard(drawable, view, "picture", jobs, move |drawable, page| {
        let found = pixels(&page.paper, drawable.spec.style.dpi);
        let found = found.map_err(|error| error.to_string())?;
        let size = [found.width as usize, found.height as usize];
        ctx.copy_image(egui::ColorImage::from_rgba_unmultiplied(size, &found.rgba));
        Ok(())
    });
}

/// Puts the numbers of a figure on the clipboard, with tabs between them.
pub fn copy_numbers(drawable: Drawable, view: &'static str, jobs: &Jobs) {
    let ctx = jobs.sender().ctx().clone();
    on_clipboard(drawable, view, "numbers", jobs, move |_, page| {
        if page.table.rows.is_empty() {
            return Err("this view has no numbers to copy; copy its picture".into());
        }
        ctx.copy_text(page.table.text('\t'));
        Ok(())
    });
}

fn on_clipboard(
    drawable: Drawable,
    view: &'static str,
    what: &'static str,
    jobs: &Jobs,
    put: impl FnOnce(&Drawable, &Page) -> Result<(), String> + Send + 'static,
) {
    let doing = format!("copying the {what} of {view}");
    jobs.start(Work::new(doing, move |send| {
        let page = drawn(&drawable).map_err(|error| error.to_string());
        send(match page.and_then(|page| put(&drawable, &page)) {
            Ok(()) => Msg::Notify(Severity::Info, format!("Copied the {what} of {view}")),
            Err(reason) => Msg::Notify(Severity::Error, format!("{view}: {reason}")),
        });
    }));
}
