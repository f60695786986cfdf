//! Pipelines of lobes in 3D, and the textures that they draw into.

use super::{FlatVertex, LinePiece, PictureTarget, SolidVertex, SpacePicture};
use crate::gpu::shader;

/// Samples per pixel of the multisampled textures; every adapter supports 4.
const SAMPLES: u32 = 4;
const COLOR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

#[derive(Debug)]
pub(super) struct Pipelines {
    solid: wgpu::RenderPipeline,
    flat: wgpu::RenderPipeline,
    line: wgpu::RenderPipeline,
    line_behind: wgpu::RenderPipeline,
    pub(super) blit: wgpu::RenderPipeline,
    pub(super) space_layout: wgpu::BindGroupLayout,
    blit_layout: wgpu::BindGroupLayout,
}

/// State in which the 3D pipelines differ.
struct PipelineKind<'a> {
    vertex: &'a str,
    fragment: &'a str,
    buffer: wgpu::VertexBufferLayout<'a>,
    strip: bool,
    compare: wgpu::CompareFunction,
    writes_depth: bool,
}

impl Pipelines {
    pub(super) fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let entry = |visibility, ty| wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility,
            ty,
            count: None,
        };
        let layout = |label, entry| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some(label),
                entries: &[entry],
            })
        };
        let space_layout = layout(
            "lobe3d",
            entry(
                wgpu::ShaderStages::VERTEX,
                wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
            ),
        );
        let blit_layout = layout(
            "blit",
            entry(
                wgpu::ShaderStages::FRAGMENT,
                wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
            ),
        );
        let module = |label, source: String| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            })
        };
        let space = module("lobe3d", shader::lobe3d());
        let solid = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Unorm8x4];
        let flat = wgpu::vertex_attr_array![0 => Float32x3, 1 => Unorm8x4];
        let line = wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x4, 2 => Unorm8x4];
        let make = |kind: &PipelineKind<'_>| in_space(device, &space, &space_layout, kind);
        let lines = |fragment, compare| PipelineKind {
            vertex: "vertex_line",
            fragment,
            buffer: rows::<LinePiece>(wgpu::VertexStepMode::Instance, &line),
            strip: true,
            compare,
            writes_depth: false,
        };
        Self {
            solid: make(&PipelineKind {
                vertex: "vertex_solid",
                fragment: "fragment_solid",
                buffer: rows::<SolidVertex>(wgpu::VertexStepMode::Vertex, &solid),
                strip: false,
                compare: wgpu::CompareFunction::Less,
                writes_depth: true,
            }),
            flat: make(&PipelineKind {
                vertex: "vertex_flat",
                fragment: "fragment_flat",
                buffer: rows::<FlatVertex>(wgpu::VertexStepMode::Vertex, &flat),
                strip: false,
                compare: wgpu::CompareFunction::Less,
                writes_depth: false,
            }),
            line: make(&lines("fragment_line", wgpu::CompareFunction::LessEqual)),
            line_behind: make(&lines(
                "fragment_line_behind",
                wgpu::CompareFunction::Greater,
            )),
            blit: blit(
                device,
                &module("blit", shader::blit()),
                &blit_layout,
                format,
            ),
            space_layout,
            blit_layout,
        }
    }

    /// Textures of this size to draw into.
    pub(super) fn target(&self, device: &wgpu::Device, size_px: [u32; 2]) -> PictureTarget {
        let texture = |format, sample_count, usage| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some("lobe3d"),
                size: wgpu::Extent3d {
                    width: size_px[0].max(1),
                    height: size_px[1].max(1),
                    depth_or_array_layers: 1,
                },
                mip_level_count: 1,
                sample_count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | usage,
                view_formats: &[],
            });
            texture.create_view(&Default::default())
        };
        let smoothed = texture(COLOR, 1, wgpu::TextureUsages::TEXTURE_BINDING);
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("lobe3d"),
            layout: &self.blit_layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&smoothed),
            }],
        });
        PictureTarget {
            size_px,
            color: texture(COLOR, SAMPLES, wgpu::TextureUsages::empty()),
            smoothed,
            depth: texture(DEPTH, SAMPLES, wgpu::TextureUsages::empty()),
            bind_group,
        }
    }

    pub(super) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        picture: &SpacePicture,
        target: &PictureTarget,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("lobe3d"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target.color,
                depth_slice: None,
                resolve_target: Some(&target.smoothed),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &target.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(1.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        let [corners, flat, lines] = picture.counts;
        pass.set_bind_group(0, &picture.bind_group, &[]);
        if corners > 0 {
            pass.set_pipeline(&self.solid);
            pass.set_vertex_buffer(0, picture.solid.slice(..));
            pass.set_index_buffer(picture.triangles.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..corners, 0, 0..1);
        }
        if flat > 0 {
            pass.set_pipeline(&self.flat);
            pass.set_vertex_buffer(0, picture.flat.slice(..));
            pass.draw(0..flat, 0..1);
        }
        if lines > 0 {
            pass.set_vertex_buffer(0, picture.lines.slice(..));
            for pipeline in [&self.line_behind, &self.line] {
                pass.set_pipeline(pipeline);
                pass.draw(0..4, 0..lines);
            }
        }
    }
}

fn rows<T>(
    step_mode: wgpu::VertexStepMode,
    attributes: &[wgpu::VertexAttribute],
) -> wgpu::VertexBufferLayout<'_> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<T>() as u64,
        step_mode,
        attributes,
    }
}

fn in_space(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::BindGroupLayout,
    kind: &PipelineKind<'_>,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("lobe3d"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(kind.fragment),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(kind.vertex),
            compilation_options: Default::default(),
            buffers: &[Some(kind.buffer.clone())],
        },
        primitive: wgpu::PrimitiveState {
            topology: if kind.strip {
                wgpu::PrimitiveTopology::TriangleStrip
            } else {
                wgpu::PrimitiveTopology::TriangleList
            },
            ..Default::default()
        },
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(kind.writes_depth),
            depth_compare: Some(kind.compare),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: wgpu::MultisampleState {
            count: SAMPLES,
            ..Default::default()
        },
        fragment: Some(fragment(module, kind.fragment, &[target(COLOR)])),
        multiview_mask: None,
        cache: None,
    })
}

fn blit(
    device: &wgpu::Device,
    module: &wgpu::ShaderModule,
    layout: &wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("blit"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("blit"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some("vertex_blit"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState {
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            ..Default::default()
        },
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(fragment(module, "fragment_blit", &[target(format)])),
        multiview_mask: None,
        cache: None,
    })
}

fn fragment<'a>(
    module: &'a wgpu::ShaderModule,
    name: &'a str,
    targets: &'a [Option<wgpu::ColorTargetState>],
) -> wgpu::FragmentState<'a> {
    wgpu::FragmentState {
        module,
        entry_point: Some(name),
        compilation_options: Default::default(),
        targets,
    }
}

fn target(format: wgpu::TextureFormat) -> Option<wgpu::ColorTargetState> {
    Some(wgpu::ColorTargetState {
        format,
        blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        write_mask: wgpu::ColorWrites::ALL,
    })
}
