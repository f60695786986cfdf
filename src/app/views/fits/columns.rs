//! The columns of the table of fits: words, widths and values.

use crate::app::state::fitting::table::Column;
use crate::app::views::fits::rows::{FitRow, value};
use crate::app::widgets::formula::{hundredths, number};
use crate::brdf::{MODELS, ParamId, all_params};

/// Words and widths of a column.
pub struct Words {
    /// Head, in markup; a unit stands behind it in brackets.
    pub head: String,
    /// One sentence.
    pub help: String,
    /// Width in points, in a narrow tile and in a wide one.
    pub width: (f32, f32),
}

/// Words of a column.
pub fn words(column: Column) -> Words {
    let words = |head: &str, help: &str, width| Words {
        head: head.into(),
        help: help.into(),
        width,
    };
    match column {
        Column::Name => words(
            "variant",
            "Model and Fresnel factor. A click on a row lays that fit over the material.",
            (0.0, 0.0),
        ),
        Column::Error => words(
            "E [%]",
            "Error over all cells in percent. With the cosine weight: the share of reflected energy that is misplaced under uniform light.",
            (50.0, 70.0),
        ),
        Column::Grazing => words(
            "E ≥ 70° [%]",
            "The same over the cells with θi or θo from 70° on, in percent.",
            (54.0, 78.0),
        ),
        Column::Channel(channel) => {
            let (symbol, name) = [("R", "red"), ("G", "green"), ("B", "blue")][channel % 3];
            words(
                &format!("E {symbol} [%]"),
                &format!("Error over all cells of {name}, in percent."),
                (48.0, 66.0),
            )
        }
        Column::Param(id) => Words {
            head: symbol(id),
            help: help(id),
            width: if id == ParamId::ETA {
                (42.0, 62.0)
            } else {
                (50.0, 70.0)
            },
        },
        Column::Evaluations => words(
            "evaluations",
            "How often the fit evaluated E.",
            (76.0, 84.0),
        ),
        Column::Time => words("time [s]", "How long the fit took.", (46.0, 66.0)),
    }
}

/// Symbols of a parameter, in markup: models may write the same one differently.
fn symbol(id: ParamId) -> String {
    let mut symbols = Vec::new();
    for model in MODELS {
        let row = model.param(id);
        symbols.extend(row.map(|row| row.symbol).filter(|s| !symbols.contains(s)));
    }
    symbols.join(", ")
}

/// Name of a parameter and the models that have it.
fn help(id: ParamId) -> String {
    let name = all_params().find(|row| row.id == id);
    let name = name.map_or("", |row| row.name);
    if id == ParamId::ETA {
        return format!("{}, where there is a Fresnel factor.", first_upper(name));
    }
    let models = MODELS.iter().filter(|model| model.param(id).is_some());
    let models: Vec<&str> = models.map(|model| model.name).collect();
    format!("{} of {}.", first_upper(name), models.join(", "))
}

fn first_upper(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_uppercase().collect::<String>() + letters.as_str()
    })
}

/// Number of a row in a column, as markup; `None` where it has none.
pub fn cell(row: &FitRow, column: Column) -> Option<String> {
    let value = value(row, column)?;
    Some(match column {
        Column::Error | Column::Grazing | Column::Channel(_) => hundredths(value),
        Column::Evaluations => format!("{value:.0}"),
        Column::Time => format!("{value:.1}"),
        Column::Name | Column::Param(_) => number(value),
    })
}

/// Whether a column says something of these rows: parameters only where a model has them.
pub fn is_of_use(column: Column, rows: &[FitRow]) -> bool {
    match column {
        Column::Param(id) => rows.iter().any(|row| {
            let of_model = row.variant.model.param(id).is_some();
            of_model && row.variant.defaults().uses(id)
        }),
        _ => true,
    }
}

/// Places of the columns in points from the left of a row.
pub struct Columns {
    /// Width of a row.
    pub width: f32,
    /// Whether names are short.
    pub narrow: bool,
    /// Left end of the names.
    pub name: f32,
    /// Columns of numbers with their right ends.
    pub numbers: Vec<(Column, f32)>,
}

/// Width below which names are short and columns close, however few there are.
const NARROW: f32 = 600.0;
/// Least room for the names, in a narrow tile and in a wide one.
const NAMES: (f32, f32) = (124.0, 190.0);
/// Left end of the names: the check box and the line are before it.
const NAME: f32 = 64.0;
/// Room at the right end.
const MARGIN: f32 = 8.0;

impl Columns {
    /// Columns of a tile of this width; wider than that where it is too narrow for a table.
    pub fn new(width: f32, shown: &[Column]) -> Self {
        let widths = |narrow: bool| -> Vec<f32> {
            let of = |column: &Column| pick(narrow, words(*column).width);
            shown.iter().map(of).collect()
        };
        let all =
            |narrow: bool| NAME + pick(narrow, NAMES) + widths(narrow).iter().sum::<f32>() + MARGIN;
        let narrow = width < all(false).max(NARROW);
        let width = width.max(all(narrow));
        let widths = widths(narrow);
        let numbers: f32 = widths.iter().sum();
        let mut right = width - numbers - MARGIN;
        let ends = widths.into_iter().map(|width| {
            right += width;
            right
        });
        Self {
            width,
            narrow,
            name: NAME,
            numbers: shown.iter().copied().zip(ends).collect(),
        }
    }

    /// Right end of the names.
    pub fn name_end(&self) -> f32 {
        let first = self.numbers.first();
        first.map_or(self.width, |(column, right)| {
            right - pick(self.narrow, words(*column).width) + 8.0
        })
    }
}

fn pick(narrow: bool, (close, wide): (f32, f32)) -> f32 {
    if narrow { close } else { wide }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_has_words() {
        for column in Column::all() {
            let words = words(column);
            assert!(
                !words.head.is_empty() && !words.help.is_empty(),
                "{column:?}"
            );
        }
        assert!(help(ParamId::ETA).starts_with("Index of refraction"));
        assert!(help(ParamId("s")).contains("Lafortune"));
    }

    #[test]
    fn a_table_that_is_too_wide_for_its_tile_leaves_room_for_the_names() {
        let all: Vec<Column> = Column::all().skip(1).collect();
        for width in [200.0, 430.0, 599.0, 600.0, 2000.0] {
            for shown in [&all[..], &all[..2], &[]] {
                let columns = Columns::new(width, shown);
                assert!(columns.width >= width);
                assert!(columns.name_end() - columns.name >= NAMES.0);
                let ends: Vec<f32> = columns.numbers.iter().map(|(_, right)| *right).collect();
                assert!(ends.is_sorted() && ends.last().is_none_or(|end| *end <= columns.width));
            }
        }
    }
}
