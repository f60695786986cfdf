//! Figures for papers: a page of panels as data, and from it a drawing and the numbers in it.
//!
//! ```text
//! PageSpec (rows, views, style) + subjects + FitOutput ── draw ──▶ Page: Paper, a Table per panel
//! ```
//!
//! A panel is the same drawing that the window shows, at the size at which its text has the wanted font size.

mod draw;
mod lock;
mod only_sphere;
mod place;
mod spec;
mod style;

pub use draw::{Page, draw};
pub use only_sphere::only_sphere;
pub use spec::{PageSpec, PanelSpec, RowSpec, sanitize};
pub use style::{COLUMNS, INKS, Inks, SAME_AXES, SameAxes, Style, style_limits};

#[cfg(test)]
mod tests;
