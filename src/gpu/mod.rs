//! wgpu without egui: the adapter, tables as textures, the sphere pass, pictures off screen.
//!
//! WGSL mirrors the CPU function by function; `tests/window/parity.rs` compares the two as numbers.

pub mod adapter;
pub mod lobe3d_pass;
pub mod offscreen;
pub mod shader;
pub mod sphere_pass;
pub mod table_texture;
