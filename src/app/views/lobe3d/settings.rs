//! The lobes in space: what the tile shows is what a figure shows.

pub use crate::figure::page::Lobe3dSpec as Lobe3dView;
