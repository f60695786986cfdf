use super::{Inks, PageSpec, PanelSpec, RowSpec, SameAxes, Style, draw};
use crate::figure::ViewSpec;
use crate::figure::drawing::{Drawing, Item};
use crate::figure::lobes::{LobeScale, LobeSpec};
use crate::figure::sphere_image::{SphereShow, SphereSpec};
use crate::figure::subject::{Look, Source, Subject};
use crate::figure::table::TableField;
use crate::figure::write::POINTS_PER_MM;
use std::f64::consts::FRAC_1_PI;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A diffuse material of albedo `albedo`.
fn lambert(label: &str, look: Look, albedo: f64) -> Subject {
    Subject {
        label: label.into(),
        look,
        series: 0,
        hidden: false,
        source: Source::Function(Arc::new(move |_, _| Some([albedo * FRAC_1_PI; 3]))),
    }
}

fn subjects() -> Vec<Subject> {
    vec![
        lambert("dark", Look::Measured, 0.1),
        lambert("bright", Look::Model, 0.9),
    ]
}

fn lobes(subjects: &[usize]) -> PanelSpec {
    PanelSpec {
        heading: None,
        subjects: subjects.to_vec(),
        view: ViewSpec::Lobes(LobeSpec {
            scale: LobeScale::Linear,
            ..LobeSpec::default()
        }),
    }
}

fn row(panels: Vec<PanelSpec>) -> RowSpec {
    RowSpec {
        panels,
        ..RowSpec::default()
    }
}

fn page(rows: Vec<RowSpec>, style: Style) -> Drawing {
    let spec = PageSpec { rows, style };
    draw(&spec, &subjects(), &[], true)
        .expect("a page")
        .paper
        .drawing
}

fn sizes(drawing: &Drawing) -> Vec<f32> {
    drawing.labels().map(|label| label.size).collect()
}

#[test]
fn a_page_is_as_wide_and_its_text_as_large_as_wanted() {
    for (width_mm, columns) in [(85.0, 1), (178.0, 1), (178.0, 4), (60.0, 2)] {
        for font_pt in [6.0, 8.0, 11.0] {
            let style = Style {
                width_mm,
                font_pt,
                ..Style::default()
            };
            let drawing = page(vec![row(vec![lobes(&[0, 1]); columns])], style);
            assert!((f64::from(drawing.size[0]) - width_mm * POINTS_PER_MM).abs() < 1e-3);
            let plain = sizes(&drawing)
                .into_iter()
                .filter(|size| (size - font_pt as f32).abs() < 1e-3);
            assert!(plain.count() >= 5, "{width_mm} {columns} {font_pt}");
            let inside = drawing.labels().all(|label| {
                let [x, y] = label.pos;
                (0.0..=drawing.size[0]).contains(&x) && (0.0..=drawing.size[1]).contains(&y)
            });
            assert!(inside);
        }
    }
}

/// The widths of all lines.
fn widths(drawing: &Drawing) -> Vec<f32> {
    let width = |item: &Item| match item {
        Item::Line { width, .. } => Some(*width),
        _ => None,
    };
    drawing.items.iter().filter_map(width).collect()
}

#[test]
fn curves_are_as_wide_as_wanted() {
    for line_pt in [0.5, 1.0, 2.5] {
        let style = Style {
            line_pt,
            ..Style::default()
        };
        let drawing = page(vec![row(vec![lobes(&[0])])], style);
        let widest = widths(&drawing).into_iter().fold(0.0, f32::max);
        assert!((f64::from(widest) - line_pt).abs() < 1e-5, "{widest}");
    }
}

/// Numbers below the surface line: the values of the rings.
fn values(drawing: &Drawing) -> Vec<String> {
    drawing.labels().map(|label| label.text.plain()).collect()
}

#[test]
fn panels_of_a_kind_share_their_axis_as_asked() {
    let draw = |same_axes| {
        let style = Style {
            same_axes,
            ..Style::default()
        };
        values(&page(
            vec![row(vec![lobes(&[0])]), row(vec![lobes(&[1])])],
            style,
        ))
    };
    // 0.1/π is shown up to 0.04 and 0.9/π up to 0.3.
    let has = |texts: &[String], value: &str| texts.iter().any(|text| text == value);
    let own = draw(SameAxes::Panel);
    assert!(
        has(&own, "0.03") || has(&own, "0.04") || has(&own, "0.02"),
        "{own:?}"
    );
    assert!(has(&own, "0.3") || has(&own, "0.2"), "{own:?}");
    assert_eq!(draw(SameAxes::Row), own);
    let same = draw(SameAxes::Figure);
    assert!(!has(&same, "0.03") && !has(&same, "0.02"), "{same:?}");
}

#[test]
fn every_curve_is_named_once_below_the_panels() {
    let rows = vec![row(vec![lobes(&[0, 1]), lobes(&[0, 1])])];
    let count = |style: Style| {
        let texts = values(&page(rows.clone(), style));
        let named = |name: &str| texts.iter().filter(|text| *text == name).count();
        (named("dark"), named("bright"))
    };
    assert_eq!(count(Style::default()), (1, 1));
    let without = Style {
        legend: false,
        ..Style::default()
    };
    assert_eq!(count(without), (0, 0));
}

#[test]
fn headings_letters_and_names_of_rows_are_there() {
    let mut first = lobes(&[0]);
    first.heading = Some("a heading".into());
    let mut named = row(vec![first, lobes(&[1])]);
    named.name = Some("a row".into());
    let style = Style {
        letters: true,
        ..Style::default()
    };
    let texts = values(&page(vec![named], style));
    for wanted in ["a heading", "a row", "(a)", "(b)"] {
        assert!(
            texts.iter().any(|text| text == wanted),
            "{wanted} {texts:?}"
        );
    }
}

#[test]
fn a_sphere_has_the_pixels_that_print_needs() {
    let sphere = PanelSpec {
        heading: None,
        subjects: vec![0],
        view: ViewSpec::Sphere(SphereSpec {
            show: SphereShow::Measured,
            ..SphereSpec::default()
        }),
    };
    let pixels = |dpi: f64| {
        let style = Style {
            dpi,
            width_mm: 40.0,
            ..Style::default()
        };
        let drawing = page(vec![row(vec![sphere.clone()])], style);
        drawing.items.iter().find_map(|item| match item {
            Item::Image(picture) => Some((picture.width, picture.max[0] - picture.min[0])),
            _ => None,
        })
    };
    let (count, points) = pixels(150.0).expect("a picture");
    assert!((count as f32 - points / 72.0 * 150.0).abs() <= 1.0);
    assert!(pixels(300.0).expect("a picture").0 > 2 * count - 3);
}

#[test]
fn the_table_has_the_numbers_that_are_drawn() {
    let spec = PageSpec {
        rows: vec![row(vec![lobes(&[0]), lobes(&[1])])],
        style: Style::default(),
    };
    let table = draw(&spec, &subjects(), &[], true).expect("a page").table;
    assert_eq!(table.columns[0], "panel");
    let value = table.columns.iter().position(|name| *name == "value");
    let value = value.expect("a column");
    for row in &table.rows {
        let (TableField::Number(panel), TableField::Number(found)) = (&row[0], &row[value]) else {
            panic!("{row:?}");
        };
        let wanted = if *panel == 1.0 { 0.1 } else { 0.9 } * FRAC_1_PI;
        assert!((found - wanted).abs() < 1e-12);
    }
    let names: Vec<&TableField> = table.rows.iter().map(|row| &row[3]).collect();
    assert!(
        names.contains(&&TableField::Text("dark".into())),
        "{:?}",
        table.rows[0]
    );
}

#[test]
fn greys_are_grey_and_a_clear_page_has_no_ground() {
    let grey = Inks::Grey.palette();
    assert!(grey.series.iter().all(|[r, g, b]| r == g && g == b));
    let spec = PageSpec {
        rows: vec![row(vec![lobes(&[0])])],
        style: Style {
            transparent: true,
            ..Style::default()
        },
    };
    let paper = draw(&spec, &subjects(), &[], true).expect("a page").paper;
    assert_eq!(paper.ground, None);
    assert!(paper.title.contains("dark"));
}

#[test]
fn an_albedo_is_computed_once_for_all_panels_and_their_axis() {
    let asked = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&asked);
    let source = Source::Function(Arc::new(move |_, _| {
        counted.fetch_add(1, Ordering::Relaxed);
        Some([0.3; 3])
    }));
    let subject = Subject {
        label: "x".into(),
        look: Look::Measured,
        series: 0,
        hidden: false,
        source,
    };
    let count = |panels: usize| {
        let panel = PanelSpec {
            heading: None,
            subjects: vec![0],
            view: ViewSpec::Albedo(Default::default()),
        };
        let row = RowSpec {
            panels: vec![panel; panels],
            ..RowSpec::default()
        };
        let spec = PageSpec {
            rows: vec![row],
            style: Style::default(),
        };
        asked.store(0, Ordering::Relaxed);
        draw(&spec, std::slice::from_ref(&subject), &[], false).expect("a page");
        asked.load(Ordering::Relaxed)
    };
    let once = count(1);
    assert!(once > 0);
    assert_eq!(count(10), once);
}

#[test]
fn numbers_are_made_where_they_are_wanted() {
    let spec = PageSpec {
        rows: vec![RowSpec {
            panels: vec![PanelSpec {
                heading: None,
                subjects: vec![0],
                view: ViewSpec::Lobes(Default::default()),
            }],
            ..RowSpec::default()
        }],
        style: Style::default(),
    };
    let page = |numbers| draw(&spec, &subjects(), &[], numbers).expect("a page");
    assert!(page(false).table.rows.is_empty() && !page(true).table.rows.is_empty());
    assert_eq!(page(false).paper, page(true).paper);
}
