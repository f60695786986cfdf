//! Grazing, a desktop BRDF explorer for the angles at which Phong models go wrong.
//!
//! Modules in dependency order; each may use those above it, and `tests/house/tidy.rs` keeps the arrows one-way:
//!
//! | module | what it is | knows nothing of |
//! |---|---|---|
//! | `encoding` | text that is no UTF-8 | the other modules |
//! | `keys` | names of enum variants, as serde has them | the other modules |
//! | `json` | JSON of others in bounded memory | the other modules but `quote` |
//! | `quote` | text of others in messages | the other modules |
//! | [`geom`] | directions, half/difference angles, colour, the lit sphere | egui, wgpu, files, threads, the clock |
//! | [`brdf`] | models and their parameters, as rows; WGSL twins; code for other programs | the same |
//! | [`measured`] | tables on the MERL grid, lookup, layout, synthetic samples | egui, wgpu, files, the clock; may use rayon |
//! | [`fit`] | from a table to parameters | egui, wgpu, files, the clock; uses rayon |
//! | [`figure`] | what is drawn, as data | egui, wgpu, files, the clock; may use rayon |
//! | [`files`] | opening materials and models, writing whole files | egui, wgpu |
//! | [`export`] | figures from files to files: open, fit, draw, write | egui, wgpu |
//! | [`gpu`] | adapters, tables as textures, the sphere pass, pictures without a window | egui |
//! | [`app`] | the window: state, messages, jobs, panels, tiles | – |
//! | [`cli`] | the command line: the window, or the same work without one | – |
//!
//! rayon's pool is the caller's, and results do not depend on the number of its threads.
//!
//! Conventions: z = n; `wi` to the light, `wo` to the viewer, unit vectors; radians inside, degrees on screen;
//! f_r in 1/sr without the cosine; RGB linear; an invalid cell has no value and is never 0. The CPU in f64 is the
//! truth, and a file `x.wgsl` beside `x.rs` is its tested twin. A bound that several modules keep stands once, in
//! [`geom::limits`].
//!
//! Invariants: panels and tiles read the state and push messages; messages change it in [`app`] alone, on the thread of
//! the window, and so do the results of jobs, which are taken in once a frame; a plot is a
//! [`figure::drawing::Drawing`] before anything paints it; user data never panic.

pub mod app;
pub mod brdf;
pub mod cli;
mod encoding;
pub mod export;
pub mod figure;
pub mod files;
pub mod fit;
pub mod geom;
pub mod gpu;
mod json;
mod keys;
pub mod measured;
mod quote;
mod signals;
