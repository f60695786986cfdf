//! The names of the subjects of a plot, each behind a piece of its line. A click on one shows or hides it.

use super::drawing::{Anchor, Drawing, LINE_HEIGHT, Label, Point};
use super::palette::{Ink, Role};
use super::subject::Subject;
use super::text::RichText;

/// Length of the line before a name, with the space behind it, in units of the font size.
pub(super) const SWATCH_EM: f32 = 2.6;

/// Opacity of what is hidden.
const HIDDEN: f32 = 0.35;

/// An entry of a legend, for clicks on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LegendEntry {
    /// Position of the subject in the list that was plotted.
    pub subject: usize,
    /// Upper left and lower right corner in points of the drawing.
    pub bounds: [Point; 2],
}

/// The subjects that have an entry, with their positions: all but those without a name.
pub(super) fn listed(subjects: &[Subject]) -> impl Iterator<Item = (usize, &Subject)> {
    let named = |(_, subject): &(usize, &Subject)| !subject.label.is_empty();
    subjects.iter().enumerate().filter(named)
}

/// The position of the subject whose entry is at a point of the drawing.
pub fn subject_at(legend: &[LegendEntry], point: Point) -> Option<usize> {
    let inside = |[min, max]: [Point; 2]| (0..2).all(|k| (min[k]..=max[k]).contains(&point[k]));
    let entry = legend.iter().find(|entry| inside(entry.bounds))?;
    Some(entry.subject)
}

/// Draws the line of an entry whose left end is at `at`; its name is the caller's to place.
pub(super) fn draw_entry(
    drawing: &mut Drawing,
    index: usize,
    subject: &Subject,
    name: &RichText,
    at: Point,
    font: f32,
) -> (LegendEntry, Label) {
    let [x, y] = at;
    let opacity = if subject.hidden { HIDDEN } else { 1.0 };
    let swatch = (SWATCH_EM - 0.5) * font;
    drawing.dashed_line(
        vec![[x, y], [x + swatch, y]],
        subject.look.width(),
        subject.look.dash(),
        Ink::from(Role::Series(subject.series)).faded(opacity),
    );
    let label = Label::new(
        name.clone(),
        [x + SWATCH_EM * font, y],
        Anchor::LEFT,
        font,
        Ink::from(Role::Foreground).faded(opacity),
    );
    let half = 0.5 * LINE_HEIGHT * font;
    let end = label.bounds()[1][0];
    let bounds = [[x, y - half], [end, y + half]];
    (
        LegendEntry {
            subject: index,
            bounds,
        },
        label,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_entry_is_found_where_it_is() {
        let entry = |subject, top: f32| LegendEntry {
            subject,
            bounds: [[10.0, top], [90.0, top + 15.0]],
        };
        let legend = [entry(3, 0.0), entry(5, 20.0)];
        assert_eq!(subject_at(&legend, [50.0, 25.0]), Some(5));
        assert_eq!(subject_at(&legend, [50.0, 17.0]), None);
        assert_eq!(subject_at(&legend, [95.0, 5.0]), None);
    }
}
