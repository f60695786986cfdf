//! A drawing as SVG. Text stays text; the letters that it uses are carried along as a font.

use super::font::FallbackFont;
use super::recipe::{ELEMENT, NAMESPACE};
use super::{CREATOR, POINTS_PER_MM, Paper, font};
use crate::figure::drawing::{Item, Label, Picture, Point};
use crate::figure::palette::{Ink, Palette, Role};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::Cursor;

/// Writes the drawing. One unit of the SVG is a point.
pub fn svg(paper: &Paper) -> String {
    let [width, height] = paper.drawing.size;
    let mm = |points: f32| number((f64::from(points) / POINTS_PER_MM) as f32);
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    // librsvg and Inkscape do not read `white-space` and would drop the blanks beside a subscript.
    let _ = writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xml:space=\"preserve\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\">",
        mm(width),
        mm(height),
        number(width),
        number(height)
    );
    let _ = writeln!(out, "<title>{}</title>", escaped(&paper.title));
    let _ = writeln!(out, "<desc>{CREATOR}</desc>");
    if let Some(recipe) = &paper.recipe {
        let _ = writeln!(
            out,
            "<metadata><{ELEMENT} xmlns=\"{NAMESPACE}\">{}</{ELEMENT}></metadata>",
            escaped(recipe)
        );
    }
    let _ = writeln!(out, "<style>\n{}</style>", style(paper));
    if let Some([r, g, b]) = paper.ground {
        let _ = writeln!(
            out,
            "<rect width=\"{}\" height=\"{}\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>",
            number(width),
            number(height)
        );
    }
    for item in &paper.drawing.items {
        draw(&mut out, item, paper);
    }
    out.push_str("</svg>\n");
    out
}

/// The font for the letters in use, and what all texts have in common.
fn style(paper: &Paper) -> String {
    let used: BTreeSet<char> = paper
        .drawing
        .labels()
        .flat_map(|label| &label.text.runs)
        .flat_map(|run| run.text.chars())
        .collect();
    let mut style = String::new();
    // Without it a viewer takes what it has under the name.
    if let Some(part) = part_of_font(used) {
        let _ = writeln!(
            style,
            "@font-face {{ font-family: '{}'; src: url(data:font/ttf;base64,{}); }}",
            font::FAMILY,
            BASE64.encode(part)
        );
    }
    let _ = writeln!(
        style,
        "text {{ font-family: '{}'{}, Arial, Helvetica, sans-serif; font-kerning: none; white-space: pre; }}",
        font::FAMILY,
        paper.fallback.iter().map(named).collect::<String>()
    );
    style
}

/// A font that stands in, in the list of families. It is the viewer's: one with so many letters is too large to carry.
fn named(font: &FallbackFont) -> String {
    let plain = |c: &char| !c.is_control() && !"'\"\\<>&".contains(*c);
    let family: String = font.family.chars().filter(plain).collect();
    format!(", '{family}'")
}

/// The font with some letters alone; `None` where it has none of them.
fn part_of_font(mut letters: BTreeSet<char>) -> Option<Vec<u8>> {
    let whole = font_subset::Font::opentype(font::BYTES).ok()?;
    letters.retain(|letter| whole.contains_char(*letter));
    if letters.is_empty() {
        return None;
    }
    Some(whole.subset(&letters).ok()?.to_opentype())
}

fn draw(out: &mut String, item: &Item, paper: &Paper) {
    let palette = &paper.palette;
    match item {
        Item::Line {
            points,
            width,
            dash,
            ink,
        } => {
            let dash = dash.map_or_else(String::new, |[on, off]| {
                format!(" stroke-dasharray=\"{} {}\"", number(on), number(off))
            });
            let _ = writeln!(
                out,
                "<path d=\"{}\" fill=\"none\"{} stroke-width=\"{}\" stroke-linejoin=\"round\"{dash}/>",
                path(points),
                color("stroke", palette, *ink),
                number(*width)
            );
        }
        Item::Fill { points, ink } => {
            let fill = color("fill", palette, *ink);
            let _ = writeln!(out, "<path d=\"{}Z\"{fill}/>", path(points));
        }
        Item::Dot {
            center,
            radius,
            ink,
            outline,
        } => {
            let rim = outline.map_or_else(String::new, |(width, ink)| {
                let stroke = color("stroke", palette, ink);
                format!("{stroke} stroke-width=\"{}\"", number(width))
            });
            let _ = writeln!(
                out,
                "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}{rim}/>",
                number(center[0]),
                number(center[1]),
                number(*radius),
                color("fill", palette, *ink)
            );
        }
        Item::Text(label) => text(out, label, paper),
        Item::Image(picture) => {
            let Some(png) = png(picture) else {
                return;
            };
            let ([left, top], [right, bottom]) = (picture.min, picture.max);
            let rendering = if picture.smooth {
                "smooth"
            } else {
                "pixelated"
            };
            let _ = writeln!(
                out,
                "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" \
                 style=\"image-rendering: {rendering}\" href=\"data:image/png;base64,{}\"/>",
                number(left),
                number(top),
                number(right - left),
                number(bottom - top),
                BASE64.encode(png)
            );
        }
    }
}

fn text(out: &mut String, label: &Label, paper: &Paper) {
    let (runs, [min, max]) = font::placed(label, &paper.fallback);
    let turn = match label.angle.to_degrees() {
        0.0 => String::new(),
        degrees => format!(" rotate({})", number(degrees)),
    };
    let transform = format!(
        "transform=\"translate({} {}){turn}\"",
        number(label.pos[0]),
        number(label.pos[1])
    );
    if label.halo && paper.ground.is_some() {
        let ground = Ink::from(Role::Background).faded(HALO);
        let _ = writeln!(
            out,
            "<rect {transform} x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"2\"{}/>",
            number(min[0] - 1.0),
            number(min[1] + 1.0),
            number(max[0] - min[0] + 2.0),
            number(max[1] - min[1] - 2.0),
            color("fill", &paper.palette, ground)
        );
    }
    // A viewer with a font of its own keeps the middle or the end where it belongs.
    let (anchor, share) = match label.anchor.x {
        x if x < 0.25 => ("start", 0.0),
        x if x <= 0.75 => ("middle", 0.5),
        _ => ("end", 1.0),
    };
    let fill = color("fill", &paper.palette, label.ink);
    let Some(first) = runs.first() else {
        return;
    };
    let _ = write!(
        out,
        "<text {transform} x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\" font-size=\"{}\"{fill}>",
        number(min[0] + share * (max[0] - min[0])),
        number(first.start[1]),
        number(label.size)
    );
    let mut line = first.start[1];
    for run in &runs {
        let (step, words) = (run.start[1] - line, escaped(run.text));
        line = run.start[1];
        if step == 0.0 && run.size == label.size {
            out.push_str(&words);
        } else {
            let _ = write!(
                out,
                "<tspan dy=\"{}\" font-size=\"{}\">{words}</tspan>",
                number(step),
                number(run.size)
            );
        }
    }
    out.push_str("</text>\n");
}

/// Opacity of a halo over what is behind it.
pub(super) const HALO: f32 = 0.75;

fn path(points: &[Point]) -> String {
    let mut path = String::new();
    for (k, [x, y]) in points.iter().enumerate() {
        let step = if k == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{step}{} {}", number(*x), number(*y));
    }
    path
}

/// A colour as the attribute `kind` with its opacity.
fn color(kind: &str, palette: &Palette, ink: Ink) -> String {
    let [r, g, b] = palette.color(ink.role);
    let mut text = format!(" {kind}=\"#{r:02x}{g:02x}{b:02x}\"");
    if ink.opacity < 1.0 {
        let _ = write!(text, " {kind}-opacity=\"{}\"", number(ink.opacity.max(0.0)));
    }
    text
}

/// Thousandths of a point, without zeros at the end.
fn number(value: f32) -> String {
    if !value.is_finite() {
        return "0".into();
    }
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

/// Text without what XML cannot hold.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}

/// Rows of straight RGBA as PNG; `None` where the sizes do not fit.
fn png(picture: &Picture) -> Option<Vec<u8>> {
    if !picture.is_whole() {
        return None;
    }
    let (width, height) = (picture.width as u32, picture.height as u32);
    let pixels = image::RgbaImage::from_raw(width, height, picture.rgba.to_vec())?;
    let mut bytes = Cursor::new(Vec::new());
    pixels.write_to(&mut bytes, image::ImageFormat::Png).ok()?;
    Some(bytes.into_inner())
}
