//! The recipe of a figure inside its picture: the text of its spec in the metadata of SVG, PDF and PNG.
//!
//! SVG has it as an element of `<metadata>`, PDF as an attached file, PNG as a compressed iTXt chunk.

use flate2::read::ZlibDecoder;
use hayro_syntax::Pdf;
use hayro_syntax::object::{Dict, Name, Object, Stream, String as PdfString};
use png::text_metadata::ITXtChunk;
use resvg::usvg::roxmltree;
use std::fmt::Write as _;
use std::io::{Cursor, Read as _};

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
/// Most attributes of an element of an SVG that is read.
const MOST_ATTRIBUTES: usize = 1000;

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
    if !text.contains(NAMESPACE) {
        return Ok(None);
    }
    if has_many_attributes(text) {
        return Err(format!(
            "not a valid SVG: an element has more than {MOST_ATTRIBUTES} attributes"
        ));
    }
    let options = roxmltree::ParsingOptions {
        // As many programs write it over an SVG.
        allow_dtd: true,
        ..Default::default()
    };
    let text = text.trim_start_matches('\u{feff}');
    let tree = roxmltree::Document::parse_with_options(text, options)
        .map_err(|error| format!("not a valid SVG: {error}"))?;
    let name = (NAMESPACE, ELEMENT);
    let found = tree.descendants().find(|node| node.has_tag_name(name));
    Ok(found.and_then(|node| node.text()).map(str::to_owned))
}

/// Whether a tag has more attributes than the reader, which compares each with all others, gets through in a moment.
fn has_many_attributes(text: &str) -> bool {
    let (mut in_tag, mut quote, mut count) = (false, None, 0);
    let mut bytes = text.bytes().peekable();
    while let Some(byte) = bytes.next() {
        match (in_tag, quote, byte) {
            (false, _, b'<') => {
                in_tag = bytes.peek().is_some_and(u8::is_ascii_alphabetic);
                count = 0;
            }
            (true, None, b'>') => in_tag = false,
            (true, None, b'"' | b'\'') => {
                quote = Some(byte);
                count += 1;
            }
            (true, Some(open), _) if open == byte => quote = None,
            _ => {}
        }
        if count > MOST_ATTRIBUTES {
            return true;
        }
    }
    false
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
        let packed = stream.raw_data();
        // Bounded, as a small file may unpack to any size.
        let mut text = Vec::new();
        let filter = stream.dict().get::<Name>("Filter");
        match (stream.filters().len(), filter.as_deref()) {
            (0, _) => text.extend_from_slice(&packed),
            (1, Some(b"FlateDecode")) => {
                let mut unpacked = ZlibDecoder::new(&*packed).take(MOST as u64 + 1);
                unpacked.read_to_end(&mut text).ok()?;
            }
            _ => return None,
        }
        String::from_utf8(text)
            .ok()
            .filter(|text| text.len() <= MOST)
    };
    Ok(pdf.objects().into_iter().find_map(attached))
}

fn of_png(bytes: &[u8]) -> Result<Option<String>, String> {
    let said = |error: png::DecodingError| format!("not a valid PNG: {error}");
    let mut reader = png::Decoder::new(Cursor::new(bytes))
        .read_info()
        .map_err(said)?;
    let is_ours = |chunk: &&ITXtChunk| chunk.keyword == KEYWORD;
    if !reader.info().utf8_text.iter().any(|chunk| is_ours(&chunk)) {
        // Some programs put texts behind the pixels. A picture that is cut off has none there.
        let _ = reader.finish();
    }
    let mut chunks = reader.info().utf8_text.iter();
    let Some(mut chunk) = chunks.find(is_ours).cloned() else {
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
            (PictureKind::Svg, &b"<svg xmlns='urn:grazing:figure'"[..]),
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

    #[test]
    fn an_svg_of_any_shape_is_read_in_a_moment_or_refused() {
        let svg = |attributes: usize, inside: &str| {
            let attributes: String = (0..attributes).map(|k| format!(" a{k}='>'")).collect();
            format!("<?xml version=\"1.0\"?><!DOCTYPE svg><svg{attributes}>{inside}</svg>")
        };
        let recipe = "<metadata><recipe xmlns=\"urn:grazing:figure\">{}</recipe></metadata>";
        let of = |text: String| PictureKind::Svg.recipe(text.into_bytes());
        assert_eq!(of(svg(100, recipe)), Ok(Some("{}".into())));
        let said = of(svg(200_000, recipe)).expect_err("is refused");
        assert!(said.contains("more than 1000 attributes"), "{said}");
        // Without a recipe nobody has to know what it is.
        assert_eq!(of(svg(200_000, "")), Ok(None));
    }

    #[test]
    fn a_recipe_behind_the_pixels_of_a_png_is_found() {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(png::ColorType::Rgb);
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(&[0; 3]).expect("a pixel");
        let chunk = ITXtChunk::new(KEYWORD, "{}");
        writer.write_text_chunk(&chunk).expect("a text");
        drop(writer);
        assert_eq!(PictureKind::Png.recipe(bytes), Ok(Some("{}".into())));
    }
}
