//! What needs a window or a graphics adapter: the real window driven by accessible names, its pictures, and the WGSL
//! twins as numbers.

#[path = "../common"]
mod common {
    pub mod folder;
    pub mod font;
    pub mod gpu;
    pub mod merl;
    pub mod random;
    pub mod records;
    pub mod tables;
    pub mod wait;
    pub mod window;
}

mod albedo;
mod autosave;
mod closing;
mod disc;
mod error_map;
mod export;
mod figure;
mod first;
mod fit;
mod fonts;
mod guide;
mod image;
mod jobs;
mod landscape;
mod lessons;
mod library;
mod lobe3d;
mod look;
mod odd_names;
mod open_fit;
mod opening;
mod paper;
mod parity;
mod probe;
mod session;
mod share;
mod sizes;
mod slices;
mod sphere;
mod start;
mod tiles;
