//! What is drawn, as data: a spec and its curves become a [`Drawing`], which the painter and the writers walk. Pure.
//!
//! A new figure is a file that builds a `Drawing`; a new format is a file that walks one.

pub mod drawing;
pub mod legend;
pub mod lobes;
pub mod mark;
pub mod palette;
mod placing;
pub mod scale;
pub mod scatter;
pub mod subject;
pub mod text;
pub mod trace;

pub use drawing::{Anchor, Drawing, Item, Label, Point};
pub use legend::LegendEntry;
pub use lobes::{LobePlot, LobeSpec};
pub use mark::Mark;
pub use palette::{Ink, Palette, Role};
pub use scale::{Axis, RadialScale};
pub use subject::{Channel, Look, Source, Subject};
pub use text::RichText;
