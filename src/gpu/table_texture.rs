//! Measured table on the GPU.

use crate::measured::Table;
use crate::measured::grid::{THETA_D_BINS, THETA_H_BINS};

/// A table as a 2D array texture: x is φ_d, y is θ_d, the layer is θ_h; f32 RGB, alpha 1 where measured, else 0.
///
/// An array and not a volume: GL adapters hold volumes of 256 texels a side only, and a table may have 360 φ_d bins.
#[derive(Debug)]
pub struct TableTexture {
    /// View that shaders bind.
    pub view: wgpu::TextureView,
}

impl TableTexture {
    /// Uploads a table: 16 bytes per cell, 23 MB for the usual grid.
    pub fn upload(device: &wgpu::Device, queue: &wgpu::Queue, table: &Table) -> Self {
        let width = table.grid().phi_d_bins();
        let texture = create(
            device,
            width as u32,
            THETA_D_BINS as u32,
            THETA_H_BINS as u32,
        );
        let layer_cells = width * THETA_D_BINS;
        let mut texels = vec![[0.0f32; 4]; layer_cells];
        for (layer, cells) in table.cells().chunks_exact(layer_cells).enumerate() {
            for (texel, [r, g, b]) in texels.iter_mut().zip(cells) {
                *texel = if r.is_nan() {
                    [0.0; 4]
                } else {
                    [*r, *g, *b, 1.0]
                };
            }
            write_layer(queue, &texture, layer as u32, &texels);
        }
        Self::of(&texture)
    }

    /// Texture without measured values, where there is no table.
    pub fn empty(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        let texture = create(device, 1, 1, 2);
        for layer in 0..2 {
            write_layer(queue, &texture, layer, &[[0.0; 4]]);
        }
        Self::of(&texture)
    }

    fn of(texture: &wgpu::Texture) -> Self {
        let view = texture.create_view(&wgpu::TextureViewDescriptor {
            dimension: Some(wgpu::TextureViewDimension::D2Array),
            ..Default::default()
        });
        Self { view }
    }
}

fn create(device: &wgpu::Device, width: u32, height: u32, layers: u32) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("table"),
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: layers,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba32Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn write_layer(queue: &wgpu::Queue, texture: &wgpu::Texture, layer: u32, texels: &[[f32; 4]]) {
    let (width, height) = (texture.width(), texture.height());
    queue.write_texture(
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d {
                x: 0,
                y: 0,
                z: layer,
            },
            aspect: wgpu::TextureAspect::All,
        },
        bytemuck::cast_slice(texels),
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(16 * width),
            rows_per_image: Some(height),
        },
        wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
    );
}
