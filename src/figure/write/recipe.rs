//! The recipe of a figure inside its picture: the text of its spec in the metadata of SVG, PDF and PNG.
//!
//! SVG has it as an element of `<metadata>`, PDF as an attached file, PNG as a compressed iTXt chunk.

use hayro_syntax::Pdf;
use hayro_syntax::object::{Dict, Object, Stream, String as PdfString};
use resvg::usvg::roxmltree;
use std::fmt::Write as _;
use std::io::Cursor;

/// Name of the attached file in a PDF.
pub(super) const ATTACHMENT: &str = "grazing.figure.json";
/// Keyword of the chunk in a PNG.
pub(super) const KEYWORD: &str = "Grazing figure";
/// Namespace of the element in an SVG.
pub(super) const NAMESPACE: &str = "urn:grazing:figure";
/// Name of the element in an SVG.
pub(super) const ELEMENT: &str = "recipe";
/// Longest recipe that is read, in bytes.
const MOST: usize = 64 << 20;

/// A kind of picture that can carry a recipe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureKind {
    /// Text that begins with a tag.
    Svg,
    /// A PDF.
    Pdf,
    /// A PNG.
    Png,
}

impl PictureKind {
    /// The kind of a file by its first bytes; `None` where it is no such picture.
    pub fn of_head(head: &[u8]) -> Option<Self> {
        let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
        if head.starts_with(b"\x89PNG\r\n\x1a\n") {
            Some(Self::Png)
        } else if head.starts_with(b"%PDF-") {
            Some(Self::Pdf)
        } else if text.trim_ascii_start().starts_with(b"<") {
            Some(Self::Svg)
        } else {
            None
        }
    }

    /// The recipe in the bytes of a picture; `None` where it carries none.
    ///
    /// # Errors
    /// One sentence where they are no such picture.
    pub fn recipe(self, bytes: Vec<u8>) -> Result<Option<String>, String> {
        match self {
            Self::Svg => of_svg(&bytes),
            Self::Pdf => of_pdf(bytes),
            Self::Png => of_png(&bytes),
        }
    }
}

/// JSON as text that XML can hold: what it cannot is only in strings, and is written there as its number.
pub fn plain(json: &str) -> String {
    let mut plain = String::with_capacity(json.len());
    for c in json.chars() {
        if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' {
            let _ = write!(plain, "\\u{:04x}", u32::from(c));
        } else {
            plain.push(c);
        }
    }
    plain
}

fn of_svg(bytes: &[u8]) -> Result<Option<String>, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "not a valid SVG: it is no UTF-8 text")?;
    let tree = roxmltree::Document::parse(text.trim_start_matches('\u{feff}'))
        .map_err(|error| format!("not a valid SVG: {error}"))?;
    let name = (NAMESPACE, ELEMENT);
    let found = tree.descendants().find(|node| node.has_tag_name(name));
    Ok(found.and_then(|node| node.text()).map(str::to_owned))
}

fn of_pdf(bytes: Vec<u8>) -> Result<Option<String>, String> {
    let pdf = Pdf::new(bytes).map_err(|_| "not a valid PDF")?;
    let attached = |object| {
        let Object::Dict(file) = object else {
            return None;
        };
        let name: PdfString = file.get("F")?;
        if name.as_bytes() != ATTACHMENT.as_bytes() {
            return None;
        }
        let stream: Stream = file.get::<Dict>("EF")?.get("F")?;
        String::from_utf8(stream.decoded().ok()?.into_owned()).ok()
    };
    Ok(pdf.objects().into_iter().find_map(attached))
}

fn of_png(bytes: &[u8]) -> Result<Option<String>, String> {
    let said = |error: png::DecodingError| format!("not a valid PNG: {error}");
    let reader = png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .map_err(said)?;
    let mut chunks = reader.info().utf8_text.iter();
    let Some(mut chunk) = chunks.find(|chunk| chunk.keyword == KEYWORD).cloned() else {
        return Ok(None);
    };
    chunk.decompress_text_with_limit(MOST).map_err(said)?;
    chunk.get_text().map(Some).map_err(said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kind_is_told_by_the_first_bytes() {
        for (head, kind) in [
            (&b"\x89PNG\r\n\x1a\n\0\0"[..], Some(PictureKind::Png)),
            (b"%PDF-1.5\n", Some(PictureKind::Pdf)),
            (b"\xef\xbb\xbf <?xml", Some(PictureKind::Svg)),
            (b"{\"rows\": []}", None),
            (b"Z\0\0\0", None),
            (b"", None),
        ] {
            assert_eq!(PictureKind::of_head(head), kind);
        }
    }

    #[test]
    fn what_xml_cannot_hold_is_still_the_same_json() {
        let label = "a\u{1}\u{85}\u{ffff}é\n\"<&";
        let json = serde_json::to_string(label).expect("a text");
        let text = plain(&json);
        assert!(!text.contains(char::is_control), "{text}");
        let back: String = serde_json::from_str(&text).expect("JSON");
        assert_eq!(back, label);
    }

    #[test]
    fn what_is_damaged_is_named_and_what_has_no_recipe_has_none() {
        for (kind, bytes) in [
            (PictureKind::Svg, &b"<svg"[..]),
            (PictureKind::Svg, b"<svg>\xff</svg>"),
            (PictureKind::Pdf, b"%PDF-1.5\nnothing"),
            (PictureKind::Png, b"\x89PNG\r\n\x1a\n\0\0"),
        ] {
            let said = kind.recipe(bytes.to_vec()).expect_err("is damaged");
            assert!(said.starts_with("not a valid"), "{said}");
        }
        let plain = b"<svg xmlns='http://www.w3.org/2000/svg'><recipe>no</recipe></svg>";
        assert_eq!(PictureKind::Svg.recipe(plain.to_vec()), Ok(None));
    }
}
