//! The graphics adapter, and shaders run on it.

use grazing::gpu::adapter::{Gpu, headless};
use grazing::gpu::table_texture::TableTexture;

/// The adapter. Without one the test fails; with SKIP_GPU=1 the tests that want it are ignored (see `build.rs`).
pub fn gpu() -> Gpu {
    headless().unwrap_or_else(|reason| {
        panic!("no graphics adapter ({reason}); install mesa-vulkan-drivers or set SKIP_GPU=1")
    })
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
