//! The font of figures, Liberation Sans (SIL Open Font License), fonts that stand in for letters that it lacks, and where the
//! letters stand.
//!
//! Letters stand at their own widths, without kerning: a part of the font that an SVG carries has none either.

use crate::figure::drawing::{Drawing, LINE_HEIGHT, Label};
use crate::figure::text::ScriptLevel;
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider as _};
use std::collections::BTreeSet;
use std::fmt;
use std::sync::{Arc, LazyLock};

/// The whole font.
pub static BYTES: &[u8] = include_bytes!("../../../assets/fonts/LiberationSans-Regular.ttf");

/// Family name of the font.
pub const FAMILY: &str = "Liberation Sans";

/// Baseline below the middle of a line of text, in units of the font size.
const BASELINE_EM: f32 = 0.345;
/// Distance of scripts from the line, in units of the size of the text around them; downwards.
const SUB_EM: f32 = 0.2;
const SUP_EM: f32 = -0.36;

/// A font that stands in for letters that the font of figures lacks. Cheap to copy.
#[derive(Clone, PartialEq)]
pub struct FallbackFont {
    /// Name of the family.
    pub family: String,
    /// Bytes of its file.
    pub data: Arc<Vec<u8>>,
    /// Position in the file, which may hold several.
    pub index: u32,
}

impl fmt::Debug for FallbackFont {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "FallbackFont({}, {} bytes)",
            self.family,
            self.data.len()
        )
    }
}

/// A letter of a font.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glyph {
    /// Position of the font among those that stand in; `None` for the font of figures.
    pub font: Option<usize>,
    /// Number of the glyph in the font; 0, an empty box, where no font has it.
    pub id: u32,
    /// Advance width in units of the font size.
    pub advance: f32,
}

/// The letter of a character, from the first font that has it.
pub fn glyph(character: char, fallback: &[FallbackFont]) -> Glyph {
    static FONT: LazyLock<Option<FontRef<'static>>> = LazyLock::new(|| FontRef::new(BYTES).ok());
    let own = FONT
        .as_ref()
        .and_then(|font| glyph_of(font, character, None));
    own.or_else(|| {
        let mut others = fallback.iter().enumerate();
        others.find_map(|(position, font)| {
            let font = FontRef::from_index(&font.data, font.index).ok()?;
            glyph_of(&font, character, Some(position))
        })
    })
    // Room for what stands in for it later: most letters that are lacking are set in squares.
    .unwrap_or(Glyph {
        font: None,
        id: 0,
        advance: 1.0,
    })
}

fn glyph_of(font: &FontRef, character: char, position: Option<usize>) -> Option<Glyph> {
    let id = font.charmap().map(character).filter(|id| id.to_u32() > 0)?;
    let metrics = font.glyph_metrics(Size::new(1.0), LocationRef::default());
    Some(Glyph {
        font: position,
        id: id.to_u32(),
        advance: metrics.advance_width(id)?,
    })
}

/// The letters of a drawing that neither the font of figures nor one that stands in has.
pub fn lacking(drawing: &Drawing, fallback: &[FallbackFont]) -> BTreeSet<char> {
    let runs = drawing.labels().flat_map(|label| &label.text.runs);
    let letters: BTreeSet<char> = runs.flat_map(|run| run.text.chars()).collect();
    letters
        .into_iter()
        .filter(|letter| !letter.is_control() && glyph(*letter, fallback).id == 0)
        .collect()
}

/// Width of a text in units of the font size.
pub fn width_em(text: &str, fallback: &[FallbackFont]) -> f32 {
    text.chars()
        .map(|character| glyph(character, fallback).advance)
        .sum()
}

/// A run of a label where it is drawn, seen from the label's position before it is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedRun<'a> {
    /// Characters of the piece.
    pub text: &'a str,
    /// Left end of the line it stands on, in points.
    pub start: [f32; 2],
    /// Font size in points.
    pub size: f32,
}

/// The runs of a label, and the box around all of them (upper left, lower right), before it is turned.
pub fn placed<'a>(
    label: &'a Label,
    fallback: &[FallbackFont],
) -> (Vec<PlacedRun<'a>>, [[f32; 2]; 2]) {
    let size_of = |level: ScriptLevel| label.size * level.relative_size();
    let runs = &label.text.runs;
    let widths: Vec<f32> = runs
        .iter()
        .map(|run| size_of(run.level) * width_em(&run.text, fallback))
        .collect();
    let [width, height] = [widths.iter().sum::<f32>(), LINE_HEIGHT * label.size];
    let [left, top] = [-label.anchor.x * width, -label.anchor.y * height];
    let line = top + 0.5 * height + BASELINE_EM * label.size;
    let mut x = left;
    let placed = runs.iter().zip(&widths).map(|(run, width)| {
        let start = [x, line + rise(run.level) * label.size];
        x += width;
        PlacedRun {
            text: &run.text,
            start,
            size: size_of(run.level),
        }
    });
    let placed = placed.collect();
    (placed, [[left, top], [left + width, top + height]])
}

fn rise(level: ScriptLevel) -> f32 {
    match level {
        ScriptLevel::Base => 0.0,
        ScriptLevel::Sub => SUB_EM,
        ScriptLevel::Sup => SUP_EM,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::drawing::Anchor;
    use crate::figure::palette::Role;
    use crate::figure::text::RichText;

    #[test]
    fn every_letter_that_figures_use_is_in_the_font() {
        let used = "fr ρθφωαηsk ∫−×·≤≥…°±²⁴½ΔΣπ√∞→′Λ–—μ";
        let missing: String = used.chars().filter(|c| glyph(*c, &[]).id == 0).collect();
        assert_eq!(missing, "");
        assert_eq!(glyph('\u{e000}', &[]).id, 0);
    }

    #[test]
    fn widths_are_those_of_the_font() {
        // From the font's hmtx table, 2048 units per em.
        assert!((width_em("M", &[]) - 1706.0 / 2048.0).abs() < 1e-4);
        assert!((width_em("iθ", &[]) - (455.0 + 1139.0) / 2048.0).abs() < 1e-4);
    }

    #[test]
    fn runs_follow_each_other_and_the_anchor_holds() {
        let label = |anchor| {
            Label::new(
                RichText::parse("k_{s}^{2}"),
                [0.0; 2],
                anchor,
                10.0,
                Role::Muted,
            )
        };
        let right = label(Anchor::RIGHT);
        let (runs, [min, max]) = placed(&right, &[]);
        assert_eq!(runs.len(), 3);
        assert!(max[0].abs() < 1e-4 && (max[1] + min[1]).abs() < 1e-4);
        let k = 10.0 * width_em("k", &[]);
        assert!((runs[1].start[0] - runs[0].start[0] - k).abs() < 1e-4);
        assert!(runs[1].start[1] > runs[0].start[1] && runs[2].start[1] < runs[0].start[1]);
        assert!(runs[1].size < 8.0 && runs[0].size == 10.0);
        let left = label(Anchor::LEFT);
        assert_eq!(placed(&left, &[]).0[0].start[0], 0.0);
    }
}
