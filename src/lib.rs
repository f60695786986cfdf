//! Grazing, a desktop BRDF explorer for the angles at which Phong models go wrong.
//!
//! Modules in dependency order; each may use those above it (`tests/tidy.rs` keeps it so):
//!
//! | module | what it is | may not |
//! |---|---|---|
//! | [`geom`] | directions, half/difference angles, colour | know egui, wgpu, files, threads, clock |
//! | [`brdf`] | models and their parameters, as rows; WGSL twins | the same |
//! | [`measured`] | tables on the MERL grid, lookup, layout, synthetic samples | the same |
//! | [`figure`] | what is drawn, as data: spec, curves, drawing | the same |
//! | [`app`] | the window: state, tiles, panels, the painter of drawings | |
//!
//! Conventions: z = n; `wi` to the light, `wo` to the viewer, unit vectors; radians inside, degrees on screen;
//! f_r in 1/sr without the cosine; RGB linear; an invalid cell has no value and is never 0.

pub mod app;
pub mod brdf;
pub mod figure;
pub mod files;
pub mod fit;
pub mod geom;
pub mod gpu;
pub mod measured;
