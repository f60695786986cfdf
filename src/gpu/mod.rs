//! wgpu without egui: adapters, tables as textures, the passes of sphere and 3D lobe, off-screen pictures.
//!
//! WGSL mirrors the CPU function by function; `tests/window/parity.rs` compares the two as numbers.

pub mod adapter;
pub mod lobe3d_pass;
pub mod offscreen;
pub mod shader;
pub mod sphere_pass;
pub mod table_texture;
