//! A drawing on the screen and on paper: the painter of the window and the rasterised SVG draw the same picture.

use egui::{Color32, Rect, pos2, vec2};
use egui_kittest::Harness;
use grazing::app::widgets::paint::paint;
use grazing::brdf::params::lobe_values;
use grazing::brdf::{Brdf, COMBINED, Fresnel, PHONG, Params};
use grazing::figure::drawing::{Drawing, Item};
use grazing::figure::heatmap::HeatMap;
use grazing::figure::image_slice::ImageSpec;
use grazing::figure::lobes::{LobePlot, LobeSpec};
use grazing::figure::page::Inks;
use grazing::figure::palette::Palette;
use grazing::figure::slices::{SlicePlot, SliceSpec};
use grazing::figure::subject::{Look, Source, Subject};
use grazing::figure::write::Paper;
use grazing::figure::write::raster::pixels;

const SIZE: [f32; 2] = [480.0, 320.0];

/// sRGB of a picture, three bytes a pixel.
type Picture = Vec<[u8; 3]>;

fn on_screen(drawing: &Drawing, palette: Palette) -> Picture {
    let drawing = drawing.clone();
    let mut harness = Harness::builder()
        .with_size(vec2(SIZE[0], SIZE[1]))
        .wgpu()
        .build_ui(move |ui| {
            let painter = ui.ctx().layer_painter(egui::LayerId::background());
            let all = Rect::from_min_size(pos2(0.0, 0.0), vec2(SIZE[0], SIZE[1]));
            painter.rect_filled(all, 0.0, Color32::WHITE);
            paint(&painter, all.min, &drawing, &palette);
        });
    harness.run();
    let image = harness.render().expect("a picture");
    assert_eq!(image.width() as f32, SIZE[0]);
    image.pixels().map(|p| [p[0], p[1], p[2]]).collect()
}

fn on_paper(drawing: &Drawing, palette: Palette) -> Picture {
    let paper = Paper {
        drawing: drawing.clone(),
        palette,
        ground: Some([255; 3]),
        fallback: Vec::new(),
        title: String::new(),
        recipe: None,
    };
    let picture = pixels(&paper, 72.0).expect("pixels");
    let pixels = picture.rgba.chunks_exact(4);
    pixels.map(|p| [p[0], p[1], p[2]]).collect()
}

/// The share of pixels that differ by more than edges do when they are softened in another way.
fn apart(a: &Picture, b: &Picture) -> f64 {
    assert_eq!(a.len(), b.len());
    let far = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).any(|k| a[k].abs_diff(b[k]) > 110);
    a.iter().zip(b).filter(|pair| far(*pair)).count() as f64 / a.len() as f64
}

fn drawings() -> Vec<(&'static str, Drawing)> {
    let brdf = Brdf {
        model: &COMBINED,
        fresnel: Fresnel::Exact,
        params: Params {
            rho_d: [0.3, 0.2, 0.1],
            k_s: [20.0; 3],
            lobe: lobe_values([30.0, 0.5]),
            eta: 1.5,
        },
    };
    let subject = |look, source| Subject {
        label: "m".into(),
        look,
        series: 0,
        hidden: false,
        source,
    };
    let grey = Brdf {
        model: &PHONG,
        ..brdf
    };
    let subjects = [
        subject(Look::Measured, Source::Model(brdf)),
        subject(Look::Model, Source::Model(grey)),
    ];
    let spec = ImageSpec::default();
    let field = spec.field(Some(&subjects[0].source), None);
    let heat = spec.heat_spec("m", &field, &field);
    vec![
        (
            "lobes",
            LobePlot::new(&LobeSpec::default(), &subjects, SIZE).drawing,
        ),
        (
            "slices",
            SlicePlot::new(&SliceSpec::default(), &subjects, SIZE).drawing,
        ),
        ("image slice", HeatMap::new(&heat, &field, SIZE).drawing),
    ]
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_screen_and_the_paper_show_the_same_picture() {
    let palette = Inks::Color.palette();
    for (name, mut drawing) in drawings() {
        // The window has another font.
        drawing.items.retain(|item| !matches!(item, Item::Text(_)));
        let screen = on_screen(&drawing, palette);
        let found = apart(&screen, &on_paper(&drawing, palette));
        assert!(found < 0.002, "{name}: {found}");
        // Planted: everything three points further right.
        for item in &mut drawing.items {
            match item {
                Item::Line { points, .. } | Item::Fill { points, .. } => {
                    points.iter_mut().for_each(|point| point[0] += 3.0);
                }
                Item::Image(picture) => {
                    picture.min[0] += 3.0;
                    picture.max[0] += 3.0;
                }
                _ => {}
            }
        }
        let planted = apart(&screen, &on_paper(&drawing, palette));
        assert!(
            planted > 3.0 * found && planted > 0.002,
            "{name}: {planted}"
        );
    }
}
