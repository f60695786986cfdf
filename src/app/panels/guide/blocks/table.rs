//! Tables, with columns as wide as their words need.

use super::{TEXT, job, one, spans_ui};
use crate::app::guide::markdown::Span;
use egui::{Ui, vec2};

/// Between columns.
const GAP: f32 = 16.0;

type Cells = [Vec<Span>];

/// Draws a head and rows.
pub fn table_ui(
    ui: &mut Ui,
    page: usize,
    (head, rows): (&Cells, &[Vec<Vec<Span>>]),
    clicked: &mut Option<String>,
) {
    let all: Vec<&Cells> = std::iter::once(head)
        .chain(rows.iter().map(Vec::as_slice))
        .collect();
    let widths = widths(ui, head.len(), &all);
    ui.vertical(|ui| {
        ui.spacing_mut().item_spacing = vec2(GAP, 4.0);
        for (index, cells) in all.into_iter().enumerate() {
            ui.horizontal_top(|ui| {
                for (cell, width) in cells.iter().zip(&widths) {
                    ui.allocate_ui(vec2(*width, 0.0), |ui| {
                        ui.set_width(*width);
                        ui.vertical(|ui| spans_ui(ui, page, cell, (TEXT, index == 0), clicked));
                    });
                }
            });
            let line = ui.visuals().widgets.noninteractive.bg_stroke;
            let y = ui.cursor().top() - 2.0;
            let x = ui.min_rect().left()..=ui.min_rect().left() + ui.available_width();
            ui.painter().hline(x, y, line);
        }
        ui.allocate_space(vec2(1.0, 2.0));
    });
}

/// Widths of the columns in points: each gets what its longest word needs, and of what is left as much as its text
/// would take in one line.
fn widths(ui: &Ui, columns: usize, rows: &[&Cells]) -> Vec<f32> {
    let (mut least, mut wish) = (vec![0.0_f32; columns], vec![0.0_f32; columns]);
    for (index, cells) in rows.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate().take(columns) {
            let look = (TEXT, index == 0);
            let width = |job| ui.painter().layout_job(job).size().x.ceil();
            wish[column] = wish[column].max(width(job(ui, cell, look, None)));
            for span in cell {
                for word in span.text.split_whitespace() {
                    let mut word_job = one(ui, word, look);
                    if span.code {
                        let word = Span {
                            text: word.into(),
                            ..span.clone()
                        };
                        word_job = job(ui, &[word], look, None);
                    }
                    least[column] = least[column].max(width(word_job));
                }
            }
        }
    }
    shared(
        &least,
        &wish,
        ui.available_width() - GAP * (columns as f32 - 1.0),
    )
}

/// Widths between the least and the wished ones that together take no more than `room`, as far as that can be.
fn shared(least: &[f32], wish: &[f32], room: f32) -> Vec<f32> {
    let (low, high): (f32, f32) = (least.iter().sum(), wish.iter().sum());
    if high <= room {
        return wish.to_vec();
    }
    if low >= room {
        return least.iter().map(|least| least * room / low).collect();
    }
    let share = (room - low) / (high - low);
    let between = |(least, wish): (&f32, &f32)| least + share * (wish - least);
    least.iter().zip(wish).map(between).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_share_the_room() {
        let (least, wish) = ([10.0, 30.0], [20.0, 130.0]);
        assert_eq!(shared(&least, &wish, 200.0), [20.0, 130.0]);
        assert_eq!(shared(&least, &wish, 40.0), [10.0, 30.0]);
        assert_eq!(shared(&least, &wish, 20.0), [5.0, 15.0]);
        let widths = shared(&least, &wish, 95.0);
        assert_eq!(widths, [15.0, 80.0]);
    }
}
