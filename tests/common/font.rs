//! A font that has letters of another script: the font of figures, with its M and its W in the places of two Chinese letters.

use grazing::figure::write::font::BYTES;
use skrifa::{FontRef, MetadataProvider as _};

/// Family name of the font.
pub const FAMILY: &str = "Plantation Sans";

/// The font has these letters and no others; the last stands for bytes that are no text.
pub const LETTERS: [char; 3] = ['木', '林', '\u{fffd}'];

/// Bytes of the font.
pub fn font() -> Vec<u8> {
    let map = FontRef::new(BYTES).expect("a font").charmap();
    let glyphs = ['M', 'W', '?'].map(|letter| map.map(letter).expect("a letter").to_u32());
    with_letters(&renamed(BYTES), &LETTERS, &glyphs)
}

/// The font under another name of the same length, in both encodings in which it is there.
fn renamed(font: &[u8]) -> Vec<u8> {
    let mut font = font.to_vec();
    let wide = |name: &str| name.bytes().flat_map(|byte| [0, byte]).collect::<Vec<u8>>();
    let plain = |name: &str| name.as_bytes().to_vec();
    let encodings = [&wide as &dyn Fn(&str) -> Vec<u8>, &plain];
    let short = FAMILY.replace(' ', "");
    for (encoded, old, new) in encodings.into_iter().flat_map(|encoded| {
        [
            (encoded, "Liberation Sans", FAMILY),
            (encoded, "LiberationSans", &short),
        ]
    }) {
        let (old, new) = (encoded(old), encoded(new));
        assert_eq!(old.len(), new.len());
        for at in 0..font.len() - old.len() {
            if font[at..at + old.len()] == old {
                font[at..at + old.len()].copy_from_slice(&new);
            }
        }
    }
    font
}

/// The font with another table of characters, which is put at its end.
fn with_letters(font: &[u8], letters: &[char], glyphs: &[u32]) -> Vec<u8> {
    let mut font = font.to_vec();
    let start = font.len().next_multiple_of(4);
    font.resize(start, 0);
    let groups = letters.len() as u32;
    // One table, for Windows and all of Unicode, in format 12: groups of first, last and glyph.
    let head: [u16; 6] = [0, 1, 3, 10, 0, 12];
    font.extend(head.iter().flat_map(|word| word.to_be_bytes()));
    font.extend([12u16, 0].iter().flat_map(|word| word.to_be_bytes()));
    let body = [16 + 12 * groups, 0, groups];
    font.extend(body.iter().flat_map(|word| word.to_be_bytes()));
    for (letter, glyph) in letters.iter().zip(glyphs) {
        let code = u32::from(*letter);
        font.extend(
            [code, code, *glyph]
                .iter()
                .flat_map(|word| word.to_be_bytes()),
        );
    }
    let length = (font.len() - start) as u32;
    let tables = usize::from(u16::from_be_bytes([font[4], font[5]]));
    let entry = (0..tables)
        .map(|k| 12 + 16 * k)
        .find(|at| &font[*at..at + 4] == b"cmap");
    let entry = entry.expect("a table of characters");
    font[entry + 8..entry + 12].copy_from_slice(&(start as u32).to_be_bytes());
    font[entry + 12..entry + 16].copy_from_slice(&length.to_be_bytes());
    font
}
