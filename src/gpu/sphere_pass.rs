//! Render pass of the sphere: pipelines, uniform, draw.

use super::shader;
use super::table_texture::TableTexture;
use crate::brdf::Brdf;
use crate::brdf::wgsl::{UNIFORM_SLOTS, uniform};
use crate::geom::sphere::{HATCH, MAX_LIGHTS, SphereView, irradiance};
use crate::geom::sphere_error::{DIFFERENCE_LIMIT, NO_LIGHT, RATIO_STOPS, SphereError};
use crate::measured::lookup::Lookup;

/// Uniform `Sphere` of `sphere.wgsl`, in its layout.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct SphereUniform {
    brdf: [[f32; 4]; UNIFORM_SLOTS],
    /// (x, y, z, 0) to the light in view space and irradiance (r, g, b, 0) of each light.
    lights: [[[f32; 4]; 2]; MAX_LIGHTS],
    light_count: u32,
    smoothly: u32,
    split: f32,
    radius_px: f32,
    sight: [f32; 4],
    hatch_dark: [f32; 4],
    hatch_light: [f32; 4],
    comparison: [f32; 4],
    colors: [[f32; 4]; COLORS],
}

/// Number of colours of a comparison's colour map, at even positions from 0 to 1.
pub const COLORS: usize = 33;

impl SphereUniform {
    /// Name and offset in bytes of every member, for the test that compares them with the shader.
    pub fn offsets() -> [(&'static str, usize); 11] {
        use std::mem::offset_of;
        [
            ("brdf", offset_of!(Self, brdf)),
            ("lights", offset_of!(Self, lights)),
            ("light_count", offset_of!(Self, light_count)),
            ("smoothly", offset_of!(Self, smoothly)),
            ("split", offset_of!(Self, split)),
            ("radius_px", offset_of!(Self, radius_px)),
            ("sight", offset_of!(Self, sight)),
            ("hatch_dark", offset_of!(Self, hatch_dark)),
            ("hatch_light", offset_of!(Self, hatch_light)),
            ("comparison", offset_of!(Self, comparison)),
            ("colors", offset_of!(Self, colors)),
        ]
    }

    /// Uniform of a sphere with a radius of `radius_px` pixels. Left of `split` (in units of the radius) is the table.
    pub fn new(view: &SphereView, brdf: &Brdf, lookup: Lookup, split: f64, radius_px: f32) -> Self {
        let mut lights = [[[0.0; 4]; 2]; MAX_LIGHTS];
        for (slot, light) in lights.iter_mut().zip(&view.lights) {
            let [x, y, z] = light.direction.as_vec3().to_array();
            let [r, g, b] = irradiance(light, view.exposure_stops).map(|x| x as f32);
            *slot = [[x, y, z, 0.0], [r, g, b, 0.0]];
        }
        Self {
            brdf: uniform(brdf),
            lights,
            light_count: view.lights.len().min(MAX_LIGHTS) as u32,
            smoothly: u32::from(lookup == Lookup::Smooth),
            // Infinities are not for shaders.
            split: split.clamp(-2.0, 2.0) as f32,
            radius_px: radius_px.max(1.0),
            sight: [0.0, 0.0, 1.0, 0.0],
            hatch_dark: HATCH[0],
            hatch_light: HATCH[1],
            comparison: [0.0, 1.0, 1.0, 1.0],
            colors: [[0.0; 4]; COLORS],
        }
    }

    /// Uniform with a zoomed view: `center`, in units of the radius with y up, in the middle of the square, and the
    /// sphere, whose radius is that given before, `zoom` times larger than the square.
    pub fn in_sight(self, center: [f64; 2], zoom: f64) -> Self {
        let [x, y, zoom] = [center[0], center[1], zoom].map(|x| x as f32);
        Self {
            sight: [x, y, zoom, 0.0],
            ..self
        }
    }

    /// Uniform for [`SpherePass::draw_compared`], with the sRGB colours of the map at even positions from 0 to 1.
    pub fn comparing(self, error: SphereError, colors: &[[u8; 3]; COLORS]) -> Self {
        let kind = f32::from(u8::from(error == SphereError::Ratio));
        Self {
            comparison: [
                kind,
                DIFFERENCE_LIMIT as f32,
                RATIO_STOPS as f32,
                NO_LIGHT as f32,
            ],
            colors: colors.map(|[r, g, b]| [r, g, b, 255].map(|x| f32::from(x) / 255.0)),
            ..self
        }
    }
}

/// Pipelines for one format of the target. The target is in gamma space; blending is premultiplied.
#[derive(Debug)]
pub struct SpherePass {
    measured: wgpu::RenderPipeline,
    model: wgpu::RenderPipeline,
    compared: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

/// Uniform buffer of a sphere and its bind group with a table.
#[derive(Debug)]
pub struct SphereSlot {
    uniform: wgpu::Buffer,
    bind_group: wgpu::BindGroup,
}

impl SpherePass {
    /// Compiles the shader and its pipelines.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("sphere"),
            source: wgpu::ShaderSource::Wgsl(shader::sphere().into()),
        });
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("sphere"),
            entries: &[
                wgpu::BindGroupLayoutEntry {
                    binding: 0,
                    visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                    ty: wgpu::BindingType::Buffer {
                        ty: wgpu::BufferBindingType::Uniform,
                        has_dynamic_offset: false,
                        min_binding_size: None,
                    },
                    count: None,
                },
                wgpu::BindGroupLayoutEntry {
                    binding: 1,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Texture {
                        sample_type: wgpu::TextureSampleType::Float { filterable: false },
                        view_dimension: wgpu::TextureViewDimension::D2Array,
                        multisampled: false,
                    },
                    count: None,
                },
            ],
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("sphere"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let part = |name| create_pipeline(device, &module, &pipeline_layout, format, name);
        Self {
            measured: part("measured"),
            model: part("model"),
            compared: part("compared"),
            layout,
        }
    }

    /// Slot of a sphere, bound to a table.
    pub fn slot(&self, device: &wgpu::Device, table: &TableTexture) -> SphereSlot {
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("sphere"),
            size: size_of::<SphereUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sphere"),
            layout: &self.layout,
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: uniform.as_entire_binding(),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: wgpu::BindingResource::TextureView(&table.view),
                },
            ],
        });
        SphereSlot {
            uniform,
            bind_group,
        }
    }

    /// Draws table and model of a slot over the whole viewport of a pass.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, slot: &SphereSlot) {
        pass.set_bind_group(0, &slot.bind_group, &[]);
        // A part that is not seen has no area, and costs nothing.
        for pipeline in [&self.measured, &self.model] {
            pass.set_pipeline(pipeline);
            pass.draw(0..4, 0..1);
        }
    }

    /// Draws the error of a slot's model against its table over the whole viewport of a pass.
    pub fn draw_compared(&self, pass: &mut wgpu::RenderPass<'_>, slot: &SphereSlot) {
        pass.set_bind_group(0, &slot.bind_group, &[]);
        pass.set_pipeline(&self.compared);
        pass.draw(0..4, 0..1);
    }
}

impl SphereSlot {
    /// Uploads the uniform for the next draw.
    pub fn write(&self, queue: &wgpu::Queue, uniform: &SphereUniform) {
        queue.write_buffer(&self.uniform, 0, bytemuck::bytes_of(uniform));
    }
}

/// Pipeline of a part of the sphere, `measured` or `model`, or of their comparison, `compared`.
fn create_pipeline(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::PipelineLayout,
    format: wgpu::TextureFormat,
    name: &str,
) -> wgpu::RenderPipeline {
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(name),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(&format!("vertex_{name}")),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..Default::default()
        },
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(&format!("fragment_{name}")),
            compilation_options: Default::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format,
                blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}
