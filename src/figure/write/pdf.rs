//! A drawing as a PDF of one page. Text stays text, in a font that is embedded.

use super::font::FallbackFont;
use super::recipe::ATTACHMENT;
use super::svg::HALO;
use super::{CREATOR, Paper, font};
use crate::figure::drawing::{Item, Label, Point};
use crate::figure::palette::{Ink, Palette, Role};
use krilla::color::rgb;
use krilla::configure::{ConfigurationBuilder, PdfVersion};
use krilla::embed::{AssociationKind, EmbeddedFile, MimeType};
use krilla::geom::{Path, PathBuilder, Point as PdfPoint, Rect, Size, Transform};
use krilla::image::Image;
use krilla::metadata::Metadata;
use krilla::num::NormalizedF32;
use krilla::page::PageSettings;
use krilla::paint::{Fill, LineJoin, Stroke, StrokeDash};
use krilla::surface::Surface;
use krilla::text::{Font, GlyphId, KrillaGlyph};
use krilla::{Document, SerializeSettings};
use std::sync::Arc;

/// Why there is no PDF: one sentence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("cannot make the PDF: {0}")]
pub struct PdfError(String);

/// Writes the drawing on a page of its size.
///
/// # Errors
/// If the drawing has no area, or the writer refuses something.
pub fn pdf(paper: &Paper) -> Result<Vec<u8>, PdfError> {
    let [width, height] = paper.drawing.size;
    let fail = |what: &str| PdfError(what.into());
    let page = PageSettings::from_wh(width, height).ok_or_else(|| fail("the page has no area"))?;
    let fonts = Fonts::new(&paper.fallback).ok_or_else(|| fail("a font cannot be read"))?;
    let mut document = Document::new_with(settings()?);
    document.set_metadata(
        Metadata::new()
            .title(paper.title.clone())
            .creator(CREATOR.into()),
    );
    if let Some(recipe) = &paper.recipe {
        let attached = document.embed_file(attachment(recipe));
        attached.ok_or_else(|| fail("the recipe cannot be attached"))?;
    }
    let mut page = document.start_page_with(page);
    let mut surface = page.surface();
    if let Some([r, g, b]) = paper.ground {
        let sheet = Rect::from_xywh(0.0, 0.0, width, height).and_then(rectangle);
        shape(&mut surface, sheet, Some(fill([r, g, b, 255])), None);
    }
    for item in &paper.drawing.items {
        draw(&mut surface, item, paper, &fonts);
    }
    surface.finish();
    page.finish();
    document
        .finish()
        .map_err(|error| PdfError(format!("{error:?}")))
}

/// The recipe as a file in the PDF; without a date, so that the same figure has the same bytes.
fn attachment(recipe: &str) -> EmbeddedFile {
    EmbeddedFile {
        path: ATTACHMENT.into(),
        mime_type: MimeType::new("application/json"),
        description: Some("The spec of this figure, from which Grazing draws it again".into()),
        association_kind: AssociationKind::Source,
        data: recipe.as_bytes().to_vec().into(),
        modification_date: None,
        compress: Some(true),
        location: None,
    }
}

/// PDF 1.5: pdfTeX warns of what is newer than the documents that it makes, and nothing in a figure needs more. PDF 1.4
/// would do, but has limits on numbers and lists that a large figure could meet.
fn settings() -> Result<SerializeSettings, PdfError> {
    let configuration = ConfigurationBuilder::new()
        .with_version(PdfVersion::Pdf15)
        .finish()
        .map_err(|error| PdfError(format!("{error:?}")))?;
    Ok(SerializeSettings {
        configuration,
        ..SerializeSettings::default()
    })
}

/// The font of figures and those that stand in; only the letters in use are embedded.
struct Fonts {
    own: Font,
    fallback: Vec<Font>,
}

impl Fonts {
    /// `None` where one cannot be read.
    fn new(fallback: &[FallbackFont]) -> Option<Self> {
        let fallback = fallback.iter().map(|font| {
            let data: Arc<dyn AsRef<[u8]> + Send + Sync> = font.data.clone();
            Font::new(data.into(), font.index)
        });
        Some(Self {
            own: Font::new(font::BYTES.into(), 0)?,
            fallback: fallback.collect::<Option<_>>()?,
        })
    }

    fn of(&self, glyph: &font::Glyph) -> &Font {
        let found = glyph.font.and_then(|position| self.fallback.get(position));
        found.unwrap_or(&self.own)
    }
}

fn draw(surface: &mut Surface, item: &Item, paper: &Paper, fonts: &Fonts) {
    let palette = &paper.palette;
    match item {
        Item::Line {
            points,
            width,
            dash,
            ink,
        } => {
            let mut stroke = stroke(palette, *ink, *width);
            stroke.dash = dash.map(|dash| StrokeDash {
                array: dash.to_vec(),
                offset: 0.0,
            });
            shape(surface, path(points, false), None, Some(stroke));
        }
        Item::Fill { points, ink } => {
            let fill = fill(palette.resolve(*ink));
            shape(surface, path(points, true), Some(fill), None);
        }
        Item::Dot {
            center,
            radius,
            ink,
            outline,
        } => {
            let rim = outline.map(|(width, ink)| stroke(palette, ink, width));
            let inside = fill(palette.resolve(*ink));
            shape(surface, circle(*center, *radius), Some(inside), rim);
        }
        Item::Text(label) => text(surface, label, paper, fonts),
        Item::Image(picture) => {
            let ([left, top], [right, bottom]) = (picture.min, picture.max);
            let size = Size::from_wh(right - left, bottom - top);
            if let (Some(size), true) = (size, picture.is_whole()) {
                let (width, height) = (picture.width as u32, picture.height as u32);
                let image = Image::from_rgba8(picture.rgba.to_vec(), width, height);
                surface.push_transform(&Transform::from_translate(left, top));
                surface.draw_image(image, size);
                surface.pop();
            }
        }
    }
}

fn text(surface: &mut Surface, label: &Label, paper: &Paper, fonts: &Fonts) {
    let (runs, [min, max]) = font::placed(label, &paper.fallback);
    let [x, y] = label.pos;
    surface.push_transform(&Transform::from_translate(x, y));
    surface.push_transform(&Transform::from_rotate(label.angle.to_degrees()));
    if label.halo && paper.ground.is_some() {
        let ground = Ink::from(Role::Background).faded(HALO);
        let patch = Rect::from_ltrb(min[0] - 1.0, min[1] + 1.0, max[0] + 1.0, max[1] - 1.0);
        let fill = fill(paper.palette.resolve(ground));
        shape(surface, patch.and_then(rectangle), Some(fill), None);
    }
    surface.set_stroke(None);
    surface.set_fill(Some(fill(paper.palette.resolve(label.ink))));
    for run in runs {
        let letters: Vec<(char, font::Glyph)> = run
            .text
            .chars()
            .map(|letter| (letter, font::glyph(letter, &paper.fallback)))
            .collect();
        let [mut x, y] = run.start;
        for part in letters.chunk_by(|(_, a), (_, b)| a.font == b.font) {
            let (text, glyphs) = glyphs(part);
            let font = fonts.of(&part[0].1).clone();
            let start = PdfPoint::from_xy(x, y);
            surface.draw_glyphs(start, &glyphs, font, &text, run.size, false);
            x += run.size * part.iter().map(|(_, glyph)| glyph.advance).sum::<f32>();
        }
    }
    surface.pop();
    surface.pop();
}

/// Letters of one font as a text and the glyphs of its characters.
fn glyphs(letters: &[(char, font::Glyph)]) -> (String, Vec<KrillaGlyph>) {
    let text: String = letters.iter().map(|(letter, _)| letter).collect();
    let places = text.char_indices().map(|(at, c)| at..at + c.len_utf8());
    let glyph = |((_, glyph), text_range): (&(char, font::Glyph), _)| KrillaGlyph {
        glyph_id: GlyphId::new(glyph.id),
        text_range,
        x_advance: glyph.advance,
        x_offset: 0.0,
        y_offset: 0.0,
        y_advance: 0.0,
        location: None,
    };
    let glyphs = letters.iter().zip(places).map(glyph).collect();
    (text, glyphs)
}

fn shape(surface: &mut Surface, path: Option<Path>, fill: Option<Fill>, stroke: Option<Stroke>) {
    if let Some(path) = path {
        surface.set_fill(fill);
        surface.set_stroke(stroke);
        surface.draw_path(&path);
    }
}

fn path(points: &[Point], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    for (k, [x, y]) in points.iter().enumerate() {
        if k == 0 {
            path.move_to(*x, *y);
        } else {
            path.line_to(*x, *y);
        }
    }
    if closed {
        path.close();
    }
    path.finish()
}

fn rectangle(rect: Rect) -> Option<Path> {
    let mut path = PathBuilder::new();
    path.push_rect(rect);
    path.finish()
}

/// A circle as four cubic curves, right to 0.03 % of the radius.
fn circle([x, y]: Point, radius: f32) -> Option<Path> {
    const HANDLE: f32 = 0.552_284_8;
    let mut path = PathBuilder::new();
    path.move_to(x + radius, y);
    for [ux, uy] in [[1.0_f32, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
        // From the direction (ux, uy) to the one a quarter turn on, (−uy, ux).
        let at = |a: f32, b: f32| {
            (
                x + radius * (a * ux - b * uy),
                y + radius * (a * uy + b * ux),
            )
        };
        let ((x1, y1), (x2, y2), (x3, y3)) = (at(1.0, HANDLE), at(HANDLE, 1.0), at(0.0, 1.0));
        path.cubic_to(x1, y1, x2, y2, x3, y3);
    }
    path.close();
    path.finish()
}

fn opacity(alpha: u8) -> NormalizedF32 {
    NormalizedF32::new(f32::from(alpha) / 255.0).unwrap_or(NormalizedF32::ONE)
}

fn fill([r, g, b, alpha]: [u8; 4]) -> Fill {
    Fill {
        paint: rgb::Color::new(r, g, b).into(),
        opacity: opacity(alpha),
        ..Fill::default()
    }
}

fn stroke(palette: &Palette, ink: Ink, width: f32) -> Stroke {
    let [r, g, b, alpha] = palette.resolve(ink);
    Stroke {
        paint: rgb::Color::new(r, g, b).into(),
        opacity: opacity(alpha),
        width,
        line_join: LineJoin::Round,
        ..Stroke::default()
    }
}
