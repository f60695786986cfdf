//! What the tests on the graphics adapter share.
#![allow(dead_code, reason = "every test uses its own part of this")]

pub mod window;

use grazing::gpu::adapter::{Gpu, headless};
use grazing::gpu::table_texture::TableTexture;

/// Whether SKIP_GPU=1 asks to leave out what needs an adapter; says so.
pub fn skip_gpu() -> bool {
    let skip = std::env::var("SKIP_GPU").is_ok_and(|value| value == "1");
    if skip {
        eprintln!("SKIP_GPU=1: skipped");
    }
    skip
}

/// The adapter; `None` if SKIP_GPU=1. Without either the test fails.
pub fn gpu() -> Option<Gpu> {
    if skip_gpu() {
        return None;
    }
    match headless() {
        Ok(gpu) => Some(gpu),
        Err(reason) => {
            panic!("no graphics adapter ({reason}); install mesa-vulkan-drivers or set SKIP_GPU=1")
        }
    }
}

/// Runs `fn item(index: u32) -> vec4f` of a shader for every index; the shader reads `inputs: array<vec4f>` and
/// may read `table`.
pub fn evaluate(
    gpu: &Gpu,
    shader: &str,
    inputs: &[[f32; 4]],
    count: usize,
    table: Option<&TableTexture>,
) -> Vec<[f32; 4]> {
    let source = format!(
        "{shader}
@group(0) @binding(0) var<storage, read> inputs: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> outputs: array<vec4f>;
@group(0) @binding(2) var table: texture_2d_array<f32>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {{
    if id.x < arrayLength(&outputs) {{ outputs[id.x] = item(id.x); }}
    // The texture is bound whether the item reads it or not.
    _ = textureDimensions(table);
}}"
    );
    let Gpu { device, queue, .. } = gpu;
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &module,
        entry_point: Some("main"),
        compilation_options: Default::default(),
        cache: None,
    });
    let buffer = |size: usize, usage| {
        device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: size as u64,
            usage,
            mapped_at_creation: false,
        })
    };
    let input = buffer(
        size_of_val(inputs),
        wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
    );
    queue.write_buffer(&input, 0, bytemuck::cast_slice(inputs));
    let output = buffer(
        16 * count,
        wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
    );
    let readback = buffer(
        16 * count,
        wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
    );
    let empty = TableTexture::empty(device, queue);
    let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry {
                binding: 0,
                resource: input.as_entire_binding(),
            },
            wgpu::BindGroupEntry {
                binding: 1,
                resource: output.as_entire_binding(),
            },
            wgpu::BindGroupEntry {
                binding: 2,
                resource: wgpu::BindingResource::TextureView(&table.unwrap_or(&empty).view),
            },
        ],
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
    }
    encoder.copy_buffer_to_buffer(&output, 0, &readback, 0, 16 * count as u64);
    queue.submit([encoder.finish()]);
    readback.slice(..).map_async(wgpu::MapMode::Read, |_| {});
    device
        .poll(wgpu::PollType::wait_indefinitely())
        .expect("the device answers");
    let mapped = readback.slice(..).get_mapped_range().expect("mapped");
    bytemuck::cast_slice(&mapped).to_vec()
}

/// Numbers in [0, 1) from a counter (SplitMix64): the same in every run.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

/// Writes a small made-up material in MERL layout: a grey diffuse one, unmeasured below the horizon.
pub fn write_merl(path: &std::path::Path) {
    let grid = grazing::measured::Grid::FOLDED;
    let mut bytes = Vec::with_capacity(34_992_012);
    for n in [90i32, 90, 180] {
        bytes.extend(n.to_le_bytes());
    }
    for scale in [1.0, 1.15, 1.66] {
        for index in 0..grid.len() {
            let (h, d, phi) = grid.bins(index);
            let c = grid.center(h, d, phi).cosines();
            let stored: f64 = if c.above_horizon() {
                0.1 * 1500.0 / scale
            } else {
                -1.0
            };
            bytes.extend(stored.to_le_bytes());
        }
    }
    std::fs::write(path, bytes).expect("written");
}
