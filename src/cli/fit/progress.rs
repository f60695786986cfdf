//! Progress of `grazing fit`: one bar over all files and variants where standard error is a terminal, else nothing.

use crate::files::folder::shown_name;
use crate::fit::{FitProgress, Variant};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;

/// Steps of the bar per fit.
const STEPS: f64 = 1000.0;

/// The bar, and the file under way.
pub struct Bar {
    bar: ProgressBar,
    variants: Vec<String>,
    files: usize,
    file: usize,
    name: String,
    /// Progress of each variant of the file, in [0, 1].
    shares: Vec<f64>,
}

impl Bar {
    /// A bar on standard error; one that shows nothing where that is no terminal.
    pub fn new(files: usize, variants: &[Variant]) -> Self {
        let bar = ProgressBar::new((files * variants.len()) as u64 * STEPS as u64);
        let style = ProgressStyle::with_template("{prefix} [{bar:16}] {percent:>3} %  {wide_msg}");
        if let Ok(style) = style {
            bar.set_style(style.progress_chars("=> "));
        }
        let name = |variant: &Variant| format!("{} {}", variant.model.key, variant.fresnel.key());
        Self {
            bar,
            variants: variants.iter().map(name).collect(),
            files,
            file: 0,
            name: String::new(),
            shares: Vec::new(),
        }
    }

    /// A file begins; those before it are done, good or bad.
    pub fn file(&mut self, index: usize, path: &Path) {
        self.file = index;
        self.name = shown_name(path);
        self.shares = vec![0.0; self.variants.len()];
        self.bar.set_prefix(format!("{}/{}", index + 1, self.files));
        self.bar.set_message(format!("{}  reading", self.name));
        self.advance();
    }

    /// The fit of a variant goes on.
    pub fn progress(&mut self, variant: usize, progress: &FitProgress) {
        if let Some(share) = self.shares.get_mut(variant) {
            // The variants may take turns, and the bar only goes forward.
            *share = share.max(f64::from(progress.share).clamp(0.0, 1.0));
        }
        let variant = self.variants.get(variant).map_or("", String::as_str);
        self.bar.set_message(format!(
            "stage {}  E {:.4}  {}  {variant}",
            progress.stage.number(),
            progress.error,
            self.name
        ));
        self.advance();
    }

    fn advance(&self) {
        let fits = (self.file * self.variants.len()) as f64 + self.shares.iter().sum::<f64>();
        self.bar.set_position((fits * STEPS) as u64);
    }

    /// Takes the bar away while `say` writes to standard error.
    pub fn suspend(&self, say: impl FnOnce()) {
        self.bar.suspend(say);
    }

    /// Takes the bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
