//! Panels in rows on a page, with what names them.

use super::lock::lock;
use super::place::{PagePlacement, place};
use super::spec::{PageSpec, PanelSpec, sanitize};
use super::style::Style;
use crate::figure::ViewSpec;
use crate::figure::albedo::KnownAlbedos;
use crate::figure::drawing::{
    Anchor, Drawing, Item, LARGEST_FONT, LINE_HEIGHT, Label, SMALLEST_FONT,
};
use crate::figure::faults::Faults;
use crate::figure::fit_output::FitOutput;
use crate::figure::legend::{SWATCH_EM, draw_entry};
use crate::figure::palette::Role;
use crate::figure::panel::PanelInput;
use crate::figure::subject::{Look, Subject};
use crate::figure::table::DataTable;
use crate::figure::text::{RichText, elided};
use crate::figure::write::{POINTS_PER_MM, Paper, font};

/// A figure that is drawn.
#[derive(Clone, Debug)]
pub struct Page {
    /// Drawing with its palette and ground.
    pub paper: Paper,
    /// The numbers in it, a table per panel that has some.
    pub table: DataTable,
}

/// Between panels, in units of the font size.
const GAP_EM: f32 = 1.0;
/// Around the page, in points.
const MARGIN: f32 = 2.0;

/// Draws a page. `made` has an entry per panel, row by row; `numbers` says whether the table is wanted too.
///
/// # Errors
/// One sentence where the spec cannot be drawn: no panels, a number out of range, a subject that is not there.
pub fn draw(
    spec: &PageSpec,
    subjects: &[Subject],
    made: &[Option<FitOutput>],
    numbers: bool,
) -> Result<Page, String> {
    let mut spec = spec.clone();
    let mut faults = Faults::default();
    sanitize(&mut spec.rows, &mut spec.style, subjects.len(), &mut faults);
    faults.result()?;
    let palette = spec.style.palette.palette();
    let unlocked = spec.clone();
    let layout = PageLayout::new(&unlocked);
    let places = layout.places();
    let albedos = KnownAlbedos::default();
    let draw_panel = |panel: &PanelSpec, view: &ViewSpec, index: usize, numbers: bool| {
        let named: Vec<Subject> = panel
            .subjects
            .iter()
            .map(|at| subjects[*at].clone())
            .collect();
        let mut measured = named.iter();
        let name = measured.find(|subject| subject.look == Look::Measured);
        let [_, _, width, height] = places[index];
        let scale = layout.scale(width, height);
        view.panel().draw(&PanelInput {
            subjects: &unnamed(&named, view),
            named: &named,
            made: made.get(index).and_then(Option::as_ref),
            name: name.map_or("", |subject| &subject.label),
            size: [width / scale, height / scale],
            density: scale * (layout.style.dpi / 72.0) as f32,
            palette: &palette,
            numbers,
            albedos: &albedos,
        })
    };
    let panels: Vec<PanelSpec> = spec
        .rows
        .iter()
        .flat_map(|row| row.panels.clone())
        .collect();
    lock(&mut spec, |index, view| {
        draw_panel(&panels[index], view, index, false)
    });
    let mut page = Drawing::new([layout.width, 0.0]);
    let mut tables = Vec::new();
    let panels = spec.rows.iter().flat_map(|row| &row.panels);
    for (index, panel) in panels.enumerate() {
        let drawn = draw_panel(panel, &panel.view, index, numbers);
        let [x, y, width, height] = places[index];
        let how = PagePlacement {
            at: [x, y],
            scale: layout.scale(width, height),
            lines: layout.lines,
            dpi: layout.style.dpi,
        };
        place(&mut page, drawn.drawing, how);
        layout.name_panel(&mut page, panel, index, [x, y, width]);
        tables.push(drawn.table);
    }
    layout.name_rows(&mut page, &spec);
    let end = layout.legend(&mut page, &spec, subjects);
    page.size[1] = end + MARGIN;
    Ok(Page {
        paper: Paper {
            drawing: page,
            palette,
            ground: (!spec.style.transparent).then_some([255; 3]),
            fallback: Vec::new(),
            title: title(&spec, subjects),
            recipe: None,
        },
        table: DataTable::joined(tables),
    })
}

/// Subjects as a panel draws them: curves are named below the page and not in each panel.
fn unnamed(named: &[Subject], view: &ViewSpec) -> Vec<Subject> {
    let mut subjects = named.to_vec();
    for subject in &mut subjects {
        if view.panel().has_curves() {
            subject.label.clear();
        }
    }
    subjects
}

/// Title of the page in one line: names of subjects and views, each once.
fn title(spec: &PageSpec, subjects: &[Subject]) -> String {
    let mut words: Vec<&str> = Vec::new();
    for panel in spec.rows.iter().flat_map(|row| &row.panels) {
        for word in panel
            .subjects
            .iter()
            .map(|at| subjects[*at].label.as_str())
            .chain([panel.view.key()])
        {
            if !words.contains(&word) {
                words.push(word);
            }
        }
    }
    words.join(", ")
}

/// Lengths on a page, in points.
struct PageLayout<'a> {
    spec: &'a PageSpec,
    style: Style,
    width: f32,
    font: f32,
    /// Width of lines per their width in a drawing.
    lines: f32,
}

impl<'a> PageLayout<'a> {
    fn new(spec: &'a PageSpec) -> Self {
        let style = spec.style.clone();
        Self {
            spec,
            width: (style.width_mm * POINTS_PER_MM) as f32,
            font: style.font_pt as f32,
            lines: style.line_pt as f32 / Look::Measured.width(),
            style,
        }
    }

    /// Points of the page per point of a drawing that is to fill a panel: the one with which its text has the wanted
    /// size.
    fn scale(&self, width: f32, height: f32) -> f32 {
        // What `font_size` says of the panel where it does not hold to its limits; it does not depend on the scale.
        let free = width.min(1.4 * height) / 38.0;
        let own = if free < self.font {
            SMALLEST_FONT
        } else {
            LARGEST_FONT
        };
        self.font / own
    }

    /// Left edge of the panels.
    fn left(&self) -> f32 {
        let named = self.spec.rows.iter().any(|row| row.name.is_some());
        MARGIN + if named { 1.6 * self.font } else { 0.0 }
    }

    fn has_head(&self, row: usize) -> bool {
        let mut panels = self.spec.rows[row].panels.iter();
        self.style.letters || panels.any(|panel| panel.heading.is_some())
    }

    /// Left, top, width and height of every panel, row by row.
    fn places(&self) -> Vec<[f32; 4]> {
        let gap = GAP_EM * self.font;
        let (left, mut y) = (self.left(), MARGIN);
        let mut places = Vec::new();
        for (index, row) in self.spec.rows.iter().enumerate() {
            let count = row.panels.len().max(1) as f32;
            let room = self.width - left - MARGIN - gap * (count - 1.0);
            let width = (room / count).max(10.0);
            let heights = row.panels.iter();
            let heights = heights.map(|panel| panel.view.panel().height(width, self.font));
            let height = row.height_mm.map_or_else(
                || heights.fold(0.2 * width, f32::max),
                |mm| (mm * POINTS_PER_MM) as f32,
            );
            if self.has_head(index) {
                y += 1.3 * LINE_HEIGHT * self.font;
            }
            for column in 0..row.panels.len() {
                places.push([left + (width + gap) * column as f32, y, width, height]);
            }
            y += height + 0.5 * gap;
        }
        places
    }

    /// Heading and letter.
    fn name_panel(
        &self,
        page: &mut Drawing,
        panel: &PanelSpec,
        index: usize,
        [x, y, width]: [f32; 3],
    ) {
        let line = y - 0.6 * LINE_HEIGHT * self.font;
        let mut put = |text: RichText, x: f32, anchor: Anchor| {
            let label = Label::new(text, [x, line], anchor, self.font, Role::Foreground);
            page.items.push(Item::Text(label));
        };
        if let Some(heading) = &panel.heading {
            let text = elided(heading, 1.15 * width / self.font);
            put(text, x + 0.5 * width, Anchor::CENTER);
        }
        if self.style.letters {
            put(RichText::literal(&letter(index)), x, Anchor::LEFT);
        }
    }

    fn name_rows(&self, page: &mut Drawing, spec: &PageSpec) {
        let places = self.places();
        let mut first = 0;
        for row in &spec.rows {
            if let (Some(name), Some([_, y, _, height])) = (&row.name, places.get(first)) {
                let at = [MARGIN + 0.7 * self.font, y + 0.5 * height];
                let text = elided(name, height / self.font);
                let mut label = Label::new(text, at, Anchor::CENTER, self.font, Role::Foreground);
                label.angle = -std::f32::consts::FRAC_PI_2;
                page.items.push(Item::Text(label));
            }
            first += row.panels.len();
        }
    }

    /// The curves by name below the panels, in as many lines as it takes. Gives back where the page ends.
    fn legend(&self, page: &mut Drawing, spec: &PageSpec, subjects: &[Subject]) -> f32 {
        let mut end = self
            .places()
            .iter()
            .map(|[_, y, _, height]| y + height)
            .fold(0.0, f32::max);
        let mut named: Vec<&Subject> = Vec::new();
        let panels = spec.rows.iter().flat_map(|row| &row.panels);
        for panel in panels.filter(|panel| panel.view.panel().has_curves()) {
            for subject in panel.subjects.iter().map(|at| &subjects[*at]) {
                let same = |other: &&Subject| {
                    (&other.label, other.look, other.series)
                        == (&subject.label, subject.look, subject.series)
                };
                if !named.iter().any(same) {
                    named.push(subject);
                }
            }
        }
        if !self.style.legend || named.is_empty() {
            return end;
        }
        let (font, line) = (self.font, LINE_HEIGHT * self.font);
        let (left, right) = (self.left(), self.width - MARGIN);
        let mut rows: Vec<Vec<(f32, &Subject, RichText)>> = vec![Vec::new()];
        let mut x = left;
        for subject in named {
            let room = ((right - left) / font - SWATCH_EM).max(4.0);
            let name = elided(&subject.label, room);
            let width = font * (SWATCH_EM + font::width_em(&name.plain(), &[]));
            if x > left && x + width > right {
                (x, _) = (left, rows.push(Vec::new()));
            }
            if let Some(row) = rows.last_mut() {
                row.push((x, subject, name));
            }
            x += width + 1.6 * font;
        }
        let mut drawing = Drawing::default();
        end += 0.3 * line;
        for row in rows {
            for (index, (x, subject, name)) in row.into_iter().enumerate() {
                let at = [x, end + 0.5 * line];
                let (_, label) = draw_entry(&mut drawing, index, subject, &name, at, font);
                drawing.items.push(Item::Text(label));
            }
            end += line;
        }
        let how = PagePlacement {
            at: [0.0; 2],
            scale: 1.0,
            lines: self.lines,
            dpi: self.style.dpi,
        };
        place(page, drawing, how);
        end
    }
}

/// (a), (b), … (z), (aa), …
fn letter(index: usize) -> String {
    let (mut rest, mut word) = (index, String::new());
    loop {
        word.insert(0, char::from(b'a' + (rest % 26) as u8));
        match (rest / 26).checked_sub(1) {
            Some(next) => rest = next,
            None => return format!("({word})"),
        }
    }
}
