//! Grazing, a desktop BRDF explorer for the angles at which Phong models go wrong.
//!
//! Modules in dependency order; each may use those above it, and `tests/house/tidy.rs` keeps the arrows one-way:
//!
//! | module | what it is | knows nothing of |
//! |---|---|---|
//! | [`geom`] | directions, half/difference angles, colour, the lit sphere | egui, wgpu, files, threads, the clock |
//! | [`brdf`] | models and their parameters, as rows; WGSL twins | the same |
//! | [`measured`] | tables on the MERL grid, lookup, layout, synthetic samples | the same |
//! | [`fit`] | from a table to parameters | the same |
//! | [`figure`] | what is drawn, as data | the same |
//! | [`files`] | opening materials and models, writing whole files | egui, wgpu, threads |
//! | [`export`] | figures from files to files: open, fit, draw, write | egui, wgpu, threads |
//! | [`gpu`] | adapters, tables as textures, the sphere pass, pictures without a window | egui |
//! | [`app`] | the window: state, messages, jobs, panels, tiles | – |
//! | [`cli`] | the command line: the window, or the same work without one | – |
//!
//! Conventions: z = n; `wi` to the light, `wo` to the viewer, unit vectors; radians inside, degrees on screen;
//! f_r in 1/sr without the cosine; RGB linear; an invalid cell has no value and is never 0. The CPU in f64 is the
//! truth, and a file `x.wgsl` beside `x.rs` is its tested twin.
//!
//! Invariants: state changes in [`app::update::apply`] only; panels read it and push messages; what a fit says reaches
//! the window through a slot that is emptied once a frame ([`app::fitting`]); a plot is a
//! [`figure::drawing::Drawing`] before anything paints it; user data never panic.

pub mod app;
pub mod brdf;
pub mod cli;
pub mod export;
pub mod figure;
pub mod files;
pub mod fit;
pub mod geom;
pub mod gpu;
pub mod measured;
