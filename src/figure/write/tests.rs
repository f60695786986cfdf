use super::raster::{MOST_PIXELS, options, pixels, png};
use super::recipe::PictureKind;
use super::{Paper, font, pdf, svg};
use crate::figure::drawing::{Anchor, Drawing, Item, Label, Picture};
use crate::figure::palette::{Ink, Palette, Role};
use crate::figure::text::RichText;
use base64::Engine as _;
use resvg::usvg;
use std::f32::consts::FRAC_PI_2;

const RED: Role = Role::Fixed([200, 0, 0]);
const BLUE: Role = Role::Fixed([0, 0, 200]);

/// Text with what SVG has to escape, and letters of every kind.
const RECIPE: &str = "{\"label\": \"]]> <ü> & 漢\"}";

/// Drawing with one item of every kind on 100 × 60 points.
fn paper() -> Paper {
    let mut drawing = Drawing::new([100.0, 60.0]);
    let square = vec![[10.0, 10.0], [30.0, 10.0], [30.0, 30.0], [10.0, 30.0]];
    drawing.fill(square, RED.into());
    let line = vec![[40.0, 20.0], [60.123_45, 20.0], [60.0, 40.0]];
    drawing.dashed_line(line, 2.0, Some([6.0, 3.0]), BLUE.into());
    drawing.items.push(Item::Dot {
        center: [80.0, 20.0],
        radius: 6.0,
        ink: Ink::from(BLUE).faded(0.5),
        outline: Some((2.0, RED.into())),
    });
    drawing.items.push(Item::Image(Picture {
        min: [70.0, 40.0],
        max: [90.0, 50.0],
        width: 2,
        height: 1,
        rgba: [255, 255, 0, 255, 0, 255, 255, 255].into(),
        smooth: false,
    }));
    let mut label = Label::new(
        RichText::parse("ρ_{d}·cos θ_{i} < \"x\" & 10^{−3}"),
        [50.0, 52.0],
        Anchor::CENTER,
        8.0,
        RED,
    );
    label.halo = true;
    drawing.items.push(Item::Text(label.clone()));
    label.angle = -FRAC_PI_2;
    label.pos = [5.0, 30.0];
    drawing.items.push(Item::Text(label));
    Paper {
        drawing,
        palette: Palette::LIGHT,
        ground: Some([255; 3]),
        fallback: Vec::new(),
        title: "a <test> & more\u{7}".into(),
        recipe: Some(RECIPE.into()),
    }
}

fn tree(paper: &Paper) -> usvg::Tree {
    usvg::Tree::from_str(&svg::svg(paper), &options(&[])).expect("an SVG")
}

/// The texts in a group, in order.
fn texts(group: &usvg::Group, out: &mut Vec<String>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => texts(group, out),
            usvg::Node::Text(text) => {
                out.push(text.chunks().iter().map(|chunk| chunk.text()).collect());
            }
            _ => {}
        }
    }
}

#[test]
fn an_svg_keeps_its_text_and_is_as_large_as_it_says() {
    let text = svg::svg(&paper());
    assert!(
        text.contains("width=\"35.278mm\" height=\"21.167mm\""),
        "{text}"
    );
    let mut found = Vec::new();
    texts(tree(&paper()).root(), &mut found);
    assert_eq!(found, vec!["ρd·cos θi < \"x\" & 10−3"; 2]);
    assert!(text.contains("<title>a &lt;test&gt; &amp; more\u{fffd}</title>"));
}

#[test]
fn blanks_of_an_svg_are_kept_by_readers_that_know_no_white_space_property() {
    let mut spaced = paper();
    let text = RichText::parse("θ_{i}  = 30°, log_{10} scale");
    let label = Label::new(text, [9.0; 2], Anchor::LEFT, 8.0, RED);
    spaced.drawing.items = vec![Item::Text(label)];
    let whole = svg::svg(&spaced);
    let old = whole.replace("white-space: pre;", "");
    assert_ne!(old, whole);
    for (text, kept) in [
        (whole, true),
        (old.clone(), true),
        // Planted: without both, two blanks are one.
        (old.replace("xml:space", "id"), false),
    ] {
        let tree = usvg::Tree::from_str(&text, &options(&[])).expect("an SVG");
        let mut found = Vec::new();
        texts(tree.root(), &mut found);
        assert_eq!(found == ["θi  = 30°, log10 scale"], kept, "{found:?}");
    }
}

#[test]
fn the_font_in_an_svg_has_the_letters_that_are_used() {
    let text = svg::svg(&paper());
    let (_, rest) = text.split_once("base64,").expect("a font");
    let (data, _) = rest.split_once(')').expect("its end");
    let font = base64::engine::general_purpose::STANDARD
        .decode(data)
        .expect("base64");
    assert!(
        font.len() < 40_000,
        "{} bytes for a few letters",
        font.len()
    );
    let part = font_subset::Font::opentype(&font).expect("a font");
    assert!("ρdcosθi<x&−·".chars().all(|c| part.contains_char(c)));
    assert!(!part.contains_char('Q'));
}

#[test]
fn text_that_the_font_lacks_or_that_is_not_there_is_no_harm() {
    let mut none = paper();
    none.drawing
        .items
        .retain(|item| !matches!(item, Item::Text(_)));
    assert!(!svg::svg(&none).contains("@font-face"));
    let mut foreign = none.clone();
    let text = RichText::literal("\u{6728}\u{e000}");
    let label = Label::new(text, [9.0; 2], Anchor::LEFT, 8.0, RED);
    foreign.drawing.items.push(Item::Text(label));
    for paper in [none, foreign] {
        assert!(pixels(&paper, 72.0).is_ok() && pdf::pdf(&paper).is_ok());
    }
}

#[test]
fn corners_of_lines_are_where_the_drawing_has_them() {
    let text = svg::svg(&paper());
    assert!(text.contains("M40 20L60.123 20L60 40\""), "{text}");
    assert!(text.contains("stroke-dasharray=\"6 3\""));
}

/// The colour of the pixel at a point.
fn pixel(paper: &Paper, dpi: f64, at: [f64; 2]) -> [u8; 4] {
    let picture = pixels(paper, dpi).expect("pixels");
    let [x, y] = at.map(|points| (points * dpi / 72.0) as usize);
    let start = 4 * (x + picture.width as usize * y);
    std::array::from_fn(|k| picture.rgba[start + k])
}

#[test]
fn pixels_have_the_colours_of_what_is_there() {
    for dpi in [72.0, 288.0] {
        let at = |x, y| pixel(&paper(), dpi, [x, y]);
        assert_eq!(at(20.0, 20.0), [200, 0, 0, 255]);
        assert_eq!(at(50.0, 15.0), [255; 4]);
        assert_eq!(at(43.0, 19.9), [0, 0, 200, 255]);
        // In a gap between dashes.
        assert_eq!(at(47.5, 19.9), [255; 4]);
        // Half of it over white, to a rounding.
        let near = |found: u8, wanted: u8| found.abs_diff(wanted) <= 1;
        let half = at(80.0, 20.0);
        assert!(near(half[0], 128) && near(half[2], 228), "{half:?}");
        assert_eq!(at(75.0, 45.0), [255, 255, 0, 255]);
        assert_eq!(at(85.0, 45.0), [0, 255, 255, 255]);
    }
    let clear = Paper {
        ground: None,
        ..paper()
    };
    assert_eq!(pixel(&clear, 72.0, [50.0, 15.0])[3], 0);
    assert_eq!(pixel(&clear, 72.0, [20.0, 20.0]), [200, 0, 0, 255]);
    // Planted: another colour there.
    let mut wrong = paper();
    if let Item::Fill { ink, .. } = &mut wrong.drawing.items[0] {
        *ink = BLUE.into();
    }
    assert_ne!(pixel(&wrong, 72.0, [20.0, 20.0]), [200, 0, 0, 255]);
}

#[test]
fn text_is_drawn_in_the_middle_of_its_place() {
    let mut only = paper();
    let text = only.drawing.items[4].clone();
    only.drawing.items = vec![text];
    let picture = pixels(&only, 288.0).expect("pixels");
    let width = picture.width as usize;
    let inked = |k: usize| picture.rgba[4 * k + 1] < 128;
    let columns: Vec<usize> = (0..picture.rgba.len() / 4)
        .filter(|k| inked(*k))
        .map(|k| k % width)
        .collect();
    let (first, last) = (columns.iter().min(), columns.iter().max());
    let (first, last) = (*first.expect("ink"), *last.expect("ink"));
    let middle = (first + last) as f32 / 8.0;
    assert!((middle - 50.0).abs() < 0.6, "{middle}");
    let label = only.drawing.labels().next().expect("a label");
    let (_, [min, max]) = font::placed(label, &[]);
    let drawn = (last - first) as f32 / 4.0;
    assert!((drawn / (max[0] - min[0]) - 1.0).abs() < 0.03, "{drawn}");
}

#[test]
fn a_png_knows_its_resolution_and_one_too_large_is_refused() {
    // 100 × 60 points, and pixels to the metre.
    for (dpi, size, density) in [
        (72.0, (100, 60), 2835),
        (96.0, (133, 80), 3780),
        (300.0, (417, 250), 11811),
        (333.3, (463, 278), 13122),
        (1200.0, (1667, 1000), 47244),
    ] {
        let bytes = png(&paper(), dpi).expect("a PNG");
        let reader = png::Decoder::new(std::io::Cursor::new(bytes));
        let reader = reader.read_info().expect("a header");
        let info = reader.info();
        assert_eq!((info.width, info.height), size, "{dpi} dpi");
        let found = info.pixel_dims.expect("a resolution");
        assert_eq!((found.xppu, found.yppu), (density, density), "{dpi} dpi");
        assert_eq!(found.unit, png::Unit::Meter);
    }
    let mut huge = paper();
    huge.drawing.size = [1e5, 10.0];
    let said = png(&huge, 300.0).expect_err("too large").to_string();
    assert!(said.contains(&format!("1 to {MOST_PIXELS}")), "{said}");
    huge.drawing.size = [0.0, 10.0];
    assert!(png(&huge, 300.0).is_err() && pdf::pdf(&huge).is_err());
}

#[test]
fn a_pdf_is_made_and_always_the_same() {
    let bytes = pdf::pdf(&paper()).expect("a PDF");
    // The version that pdfTeX takes without a warning, in the header and in the metadata.
    assert!(bytes.starts_with(b"%PDF-1.5") && bytes.len() < 60_000);
    let found = String::from_utf8_lossy(&bytes);
    assert!(found.contains("<pdf:PDFVersion>1.5<"), "{found}");
    assert_eq!(pdf::pdf(&paper()).expect("a PDF"), bytes);
    assert_eq!(svg::svg(&paper()), svg::svg(&paper()));
    let mut other = paper();
    other.drawing.items.pop();
    assert_ne!(pdf::pdf(&other).expect("a PDF"), bytes);
}

#[test]
fn every_picture_carries_its_recipe() {
    let paper = paper();
    let of = |paper: &Paper| {
        [
            (PictureKind::Svg, svg::svg(paper).into_bytes()),
            (PictureKind::Pdf, pdf::pdf(paper).expect("a PDF")),
            (PictureKind::Png, png(paper, 72.0).expect("a PNG")),
        ]
    };
    let without = Paper {
        recipe: None,
        ..paper.clone()
    };
    for ((kind, with), (_, without)) in of(&paper).into_iter().zip(of(&without)) {
        assert_eq!(PictureKind::of_head(&with), Some(kind));
        assert_eq!(kind.recipe(with), Ok(Some(RECIPE.into())), "{kind:?}");
        assert_eq!(kind.recipe(without), Ok(None), "{kind:?}");
    }
}
