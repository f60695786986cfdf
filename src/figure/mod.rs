//! What is drawn, as data: a spec becomes a [`drawing::Drawing`], which the window paints and a file writer writes. Pure.

pub mod drawing;
pub mod lobes;
pub mod scale;
pub mod text;
