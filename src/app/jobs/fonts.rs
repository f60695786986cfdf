//! Letters that no font of the window has: they are gathered as they are laid out, and fonts for them are looked for in the
//! background.

use crate::app::msg::Msg;
use crate::app::msg::work::Work;
use crate::export::fonts::for_screen;
use crate::figure::write::font::FallbackFont;
use egui::epaint::text::{
    FallbackRequest, FontInsert, FontPriority, FontProvider, InsertFontFamily,
};
use egui::{FontData, FontFamily};
use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, PoisonError};

/// Letters that were laid out and that no font has, since they were taken last.
#[derive(Clone, Default)]
pub struct LackingLetters(Arc<Mutex<BTreeSet<char>>>);

impl LackingLetters {
    /// Takes what has come together.
    pub fn take(&self) -> BTreeSet<char> {
        std::mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl FontProvider for LackingLetters {
    /// Notes the letter and provides nothing: a font comes when it has been found.
    fn font_for(&self, request: &FallbackRequest<'_>) -> Option<FontInsert> {
        let mut letters = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        letters.extend(request.cluster.chars().next());
        None
    }
}

/// Looks for fonts that have these letters.
pub fn find(letters: BTreeSet<char>) -> Work {
    Work::new("looking for a font", move |send| {
        let (fonts, lacking) = for_screen(&letters);
        send(Msg::FontsFound { fonts, lacking });
    })
    .in_turn("fonts")
}

/// Lets the window draw letters with these fonts, where none before them has one.
pub fn add(ctx: &egui::Context, fonts: Vec<FallbackFont>) {
    for font in fonts {
        let family = |family| InsertFontFamily {
            family,
            priority: FontPriority::Lowest,
        };
        ctx.add_font(FontInsert {
            name: format!("{} {}", font.family, font.index),
            data: FontData::from_blob(font.data, font.index),
            families: [FontFamily::Proportional, FontFamily::Monospace]
                .map(family)
                .to_vec(),
        });
    }
}
