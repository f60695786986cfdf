//! A drawing as pixels: the SVG, rasterised.

use super::font::FallbackFont;
use super::recipe::KEYWORD;
use super::{CREATOR, Paper, font, svg};
use png::text_metadata::ITXtChunk;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg;
use std::sync::{Arc, LazyLock};

/// Pixels on a side at most: larger pictures are a mistake of the resolution.
pub const MOST_PIXELS: u32 = 20_000;

/// Why there are no pixels: one sentence.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct RasterError(String);

/// Rows of pixels from above, four bytes each: sRGB and opacity, not multiplied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The bytes.
    pub rgba: Vec<u8>,
}

/// Draws with `dpi` pixels to the inch.
///
/// # Errors
/// If the picture would have no pixels or too many.
pub fn pixels(paper: &Paper, dpi: f64) -> Result<Pixels, RasterError> {
    let sides = paper.drawing.size.map(|points| pixels_of(points, dpi));
    let [width, height] = sides;
    if !sides.iter().all(|side| (1..=MOST_PIXELS).contains(side)) {
        return Err(RasterError(format!(
            "a picture of {width} × {height} pixels; expected 1 to {MOST_PIXELS} on a side: change the size or the dpi"
        )));
    }
    let fail = |what: String| RasterError(format!("cannot draw the picture: {what}"));
    let tree = usvg::Tree::from_str(&svg::svg(paper), &options(&paper.fallback))
        .map_err(|error| fail(error.to_string()))?;
    let mut pixmap = Pixmap::new(width, height).ok_or_else(|| fail("it is too large".into()))?;
    let size = tree.size();
    let scale = Transform::from_scale(width as f32 / size.width(), height as f32 / size.height());
    resvg::render(&tree, scale, &mut pixmap.as_mut());
    let rgba = pixmap
        .pixels()
        .iter()
        .flat_map(|pixel| {
            let pixel = pixel.demultiply();
            [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()]
        })
        .collect();
    Ok(Pixels {
        width,
        height,
        rgba,
    })
}

/// The nearest whole number of pixels.
fn pixels_of(points: f32, dpi: f64) -> u32 {
    let pixels = f64::from(points) * dpi / 72.0;
    // Casts saturate.
    pixels.round() as u32
}

/// Options for reading our SVG: with the fonts that it was made for.
pub fn options(fallback: &[FallbackFont]) -> usvg::Options<'static> {
    static FONTS: LazyLock<Arc<usvg::fontdb::Database>> = LazyLock::new(|| {
        let mut fonts = usvg::fontdb::Database::new();
        fonts.load_font_data(font::BYTES.to_vec());
        Arc::new(fonts)
    });
    let mut fonts = Arc::clone(&FONTS);
    for font in fallback {
        let source = usvg::fontdb::Source::Binary(font.data.clone());
        Arc::make_mut(&mut fonts).load_font_source(source);
    }
    usvg::Options {
        font_family: font::FAMILY.into(),
        fontdb: fonts,
        ..usvg::Options::default()
    }
}

/// A PNG that says how large it is on paper.
///
/// # Errors
/// As [`pixels`].
pub fn png(paper: &Paper, dpi: f64) -> Result<Vec<u8>, RasterError> {
    let pixels = pixels(paper, dpi)?;
    encoded(&pixels, dpi, paper)
        .map_err(|error| RasterError(format!("cannot make the PNG: {error}")))
}

fn encoded(pixels: &Pixels, dpi: f64, paper: &Paper) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut info = png::Info::with_size(pixels.width, pixels.height);
    if let Some(recipe) = &paper.recipe {
        let mut chunk = ITXtChunk::new(KEYWORD, recipe.as_str());
        chunk.compressed = true;
        chunk.compress_text()?;
        info.utf8_text.push(chunk);
    }
    let mut encoder = png::Encoder::with_info(&mut bytes, info)?;
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let per_metre = (dpi / 0.0254).round() as u32;
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: per_metre,
        yppu: per_metre,
        unit: png::Unit::Meter,
    }));
    encoder.add_itxt_chunk("Title".into(), paper.title.clone())?;
    encoder.add_itxt_chunk("Software".into(), CREATOR.into())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels.rgba)?;
    writer.finish()?;
    Ok(bytes)
}
