//! Render pass of lobes in 3D: solids, flat surfaces and lines with a depth buffer, drawn into a texture of their own.
//!
//! A window's pass has no depth; the finished texture is copied into it, and kept as long as nothing moves.

mod pipelines;

use glam::{DMat4, DQuat};
use pipelines::Pipelines;
use wgpu::util::DeviceExt;

/// Vertex of a solid: position, normal, colour.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct SolidVertex {
    /// Position in the surface's frame.
    pub position: [f32; 3],
    /// Outward normal in the surface's frame.
    pub normal: [f32; 3],
    /// sRGB colour; solids are opaque, so that the fourth component does not count.
    pub color: [u8; 4],
}

/// Vertex of a flat surface.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct FlatVertex {
    /// Position in the surface's frame.
    pub position: [f32; 3],
    /// sRGB colour with opacity.
    pub color: [u8; 4],
}

/// Straight segment of a line.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LinePiece {
    /// One end, in the surface's frame.
    pub start: [f32; 3],
    /// Width in points.
    pub width: f32,
    /// Other end, in the surface's frame.
    pub end: [f32; 3],
    /// Factor on the opacity behind a solid, in [0, 1].
    pub behind: f32,
    /// sRGB colour with opacity.
    pub color: [u8; 4],
}

/// Geometry of a 3D scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpaceScene {
    /// Vertices of the solids.
    pub solid: Vec<SolidVertex>,
    /// Indices into `solid`, three per triangle.
    pub triangles: Vec<u32>,
    /// Vertices of the flat surfaces, three per triangle.
    pub flat: Vec<FlatVertex>,
    /// Line segments, later ones drawn over earlier ones.
    pub lines: Vec<LinePiece>,
}

/// Orthographic view of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceView {
    /// Rotation from the surface's frame to view space: x to the right, y up, z to the eye.
    pub rotation: DQuat,
    /// Point of view space that is placed at `offset_px`.
    pub center: [f64; 2],
    /// Pixels from the middle of the picture at which `center` is placed, y down.
    pub offset_px: [f64; 2],
    /// Scale in pixels per unit.
    pub scale_px: f64,
    /// Width and height of the picture in pixels.
    pub size_px: [u32; 2],
    /// Pixels per point.
    pub density: f32,
}

/// Half the depth of the clip volume, in units.
const DEPTH: f64 = 4.0;

impl SpaceView {
    /// Transformation from the surface's frame to clip space.
    fn clip_from_world(&self) -> DMat4 {
        let [width, height] = self.size_px.map(|n| 0.5 * f64::from(n.max(1)));
        let (sx, sy) = (self.scale_px / width, self.scale_px / height);
        let (x, y) = (
            self.offset_px[0] / width - sx * self.center[0],
            -self.offset_px[1] / height - sy * self.center[1],
        );
        DMat4::from_translation(glam::DVec3::new(x, y, 0.5))
            * DMat4::from_scale(glam::DVec3::new(sx, sy, -0.5 / DEPTH))
            * DMat4::from_quat(self.rotation)
    }

    fn uniform(&self) -> SpaceUniform {
        SpaceUniform {
            clip_from_world: self.clip_from_world().as_mat4().to_cols_array_2d(),
            view_from_world: DMat4::from_quat(self.rotation).as_mat4().to_cols_array_2d(),
            viewport_px: self.size_px.map(|n| n.max(1) as f32),
            density: self.density,
            unused: 0.0,
        }
    }
}

/// Uniform `Space` of `lobe3d.wgsl`, in its layout.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct SpaceUniform {
    clip_from_world: [[f32; 4]; 4],
    view_from_world: [[f32; 4]; 4],
    viewport_px: [f32; 2],
    density: f32,
    unused: f32,
}

impl SpaceUniform {
    /// Name and offset in bytes of every member, for the test that compares them with the shader.
    pub fn offsets() -> [(&'static str, usize); 5] {
        use std::mem::offset_of;
        [
            ("clip_from_world", offset_of!(Self, clip_from_world)),
            ("view_from_world", offset_of!(Self, view_from_world)),
            ("viewport_px", offset_of!(Self, viewport_px)),
            ("density", offset_of!(Self, density)),
            ("unused", offset_of!(Self, unused)),
        ]
    }
}

/// Pipelines for one format of the target. The target is in gamma space; blending is premultiplied.
#[derive(Debug)]
pub struct SpacePass {
    pipelines: Pipelines,
}

/// Scene on the GPU with the texture that it is drawn into.
#[derive(Debug)]
pub struct SpacePicture {
    uniform: wgpu::Buffer,
    bind_group: wgpu::BindGroup,
    solid: wgpu::Buffer,
    triangles: wgpu::Buffer,
    flat: wgpu::Buffer,
    lines: wgpu::Buffer,
    counts: [u32; 3],
    target: Option<PictureTarget>,
    /// View that the target shows.
    shown: Option<SpaceView>,
}

#[derive(Debug)]
struct PictureTarget {
    size_px: [u32; 2],
    color: wgpu::TextureView,
    smoothed: wgpu::TextureView,
    depth: wgpu::TextureView,
    bind_group: wgpu::BindGroup,
}

impl SpacePass {
    /// Compiles shaders and pipelines.
    pub fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        Self {
            pipelines: Pipelines::new(device, format),
        }
    }

    /// Uploads a scene.
    pub fn picture(&self, device: &wgpu::Device, scene: &SpaceScene) -> SpacePicture {
        let buffer = |contents: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("lobe3d"),
                contents,
                usage,
            })
        };
        let uniform = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("lobe3d"),
            size: size_of::<SpaceUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("lobe3d"),
            layout: &self.pipelines.space_layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: uniform.as_entire_binding(),
            }],
        });
        let (vertex, index) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
        SpacePicture {
            uniform,
            bind_group,
            solid: buffer(bytemuck::cast_slice(&scene.solid), vertex),
            triangles: buffer(bytemuck::cast_slice(&scene.triangles), index),
            flat: buffer(bytemuck::cast_slice(&scene.flat), vertex),
            lines: buffer(bytemuck::cast_slice(&scene.lines), vertex),
            counts: [
                scene.triangles.len() as u32,
                scene.flat.len() as u32,
                scene.lines.len() as u32,
            ],
            target: None,
            shown: None,
        }
    }

    /// Draws a picture, unless its target shows this view already.
    pub fn render(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        picture: &mut SpacePicture,
        view: &SpaceView,
    ) {
        // A window beyond what the device can draw is about to shrink.
        let most = device.limits().max_texture_dimension_2d;
        let view = &SpaceView {
            size_px: view.size_px.map(|n| n.min(most)),
            ..*view
        };
        if picture.shown.as_ref() == Some(view) {
            return;
        }
        let target = match picture.target.take() {
            Some(target) if target.size_px == view.size_px => target,
            _ => self.pipelines.target(device, view.size_px),
        };
        queue.write_buffer(&picture.uniform, 0, bytemuck::bytes_of(&view.uniform()));
        self.pipelines.draw(encoder, picture, &target);
        picture.target = Some(target);
        picture.shown = Some(*view);
    }

    /// Copies the picture over the whole viewport of a pass.
    pub fn blit(&self, pass: &mut wgpu::RenderPass<'_>, picture: &SpacePicture) {
        if let Some(target) = &picture.target {
            pass.set_pipeline(&self.pipelines.blit);
            pass.set_bind_group(0, &target.bind_group, &[]);
            pass.draw(0..4, 0..1);
        }
    }
}

impl SpacePicture {
    /// Takes over the target of a picture that this one replaces.
    pub fn inherit(&mut self, before: Self) {
        self.target = before.target;
    }
}
