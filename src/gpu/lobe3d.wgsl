// Lobes in space: solids, flat surfaces, lines of a width in pixels, and the finished picture put into the window's.
//
// Colours are sRGB-encoded, as blending in the window is.

struct Space {
    // From the surface's frame to clip space, and its rotation alone.
    clip_from_world: mat4x4f,
    view_from_world: mat4x4f,
    viewport_px: vec2f,
    // Pixels per point.
    density: f32,
    unused: f32,
}

@group(0) @binding(0) var<uniform> space: Space;

struct Solid {
    @builtin(position) position: vec4f,
    @location(0) normal: vec3f,
    @location(1) color: vec4f,
}

@vertex
fn vertex_solid(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec4f,
) -> Solid {
    let view_normal = (space.view_from_world * vec4f(normal, 0.0)).xyz;
    return Solid(space.clip_from_world * vec4f(position, 1.0), view_normal, color);
}

// From the upper left, beside the eye.
const LIGHT = vec3f(-0.40, 0.55, 0.73);

@fragment
fn fragment_solid(in: Solid, @builtin(front_facing) outside: bool) -> @location(0) vec4f {
    let across = length(in.normal);
    let normal = in.normal / max(across, 1e-6) * select(-1.0, 1.0, outside);
    let lit = 0.5 + 0.5 * dot(normal, LIGHT);
    // The inside, seen through a gap, is in the shade.
    let shade = select(0.35, 0.28 + 0.72 * lit * lit, outside);
    // A little towards white where the light falls straight on it.
    let gleam = select(0.0, 0.25 * pow(lit, 8.0), outside);
    return vec4f(mix(in.color.rgb * shade, vec3f(1.0), gleam), 1.0);
}

@vertex
fn vertex_flat(@location(0) position: vec3f, @location(1) color: vec4f) -> Solid {
    return Solid(space.clip_from_world * vec4f(position, 1.0), vec3f(0.0), color);
}

@fragment
fn fragment_flat(in: Solid) -> @location(0) vec4f {
    return premultiplied(in.color, 1.0);
}

fn premultiplied(color: vec4f, share: f32) -> vec4f {
    let opacity = color.a * share;
    return vec4f(color.rgb * opacity, opacity);
}

struct Line {
    @builtin(position) position: vec4f,
    @location(0) color: vec4f,
    // How much of the colour is left behind a solid.
    @location(1) behind: f32,
}

// A corner of the strip around a piece of a line: xyz and the width in points, xyz and `behind`.
@vertex
fn vertex_line(
    @builtin(vertex_index) index: u32,
    @location(0) start: vec4f,
    @location(1) end: vec4f,
    @location(2) color: vec4f,
) -> Line {
    let a = space.clip_from_world * vec4f(start.xyz, 1.0);
    let b = space.clip_from_world * vec4f(end.xyz, 1.0);
    let half_px = 0.5 * space.viewport_px;
    let along_px = (b.xy - a.xy) * half_px;
    let length_px = length(along_px);
    var along = vec2f(1.0, 0.0);
    if length_px > 1e-4 {
        along = along_px / length_px;
    }
    let across = vec2f(-along.y, along.x) * (f32(index & 1u) - 0.5) * start.w * space.density;
    // Pieces overlap by a little at their joints.
    let beyond = along * (f32(index >> 1u) - 0.5) * 0.5;
    var position = select(a, b, index > 1u);
    position.x += (across.x + beyond.x) / half_px.x;
    position.y += (across.y + beyond.y) / half_px.y;
    // In front of the solid that it lies on.
    position.z -= 0.002;
    return Line(position, color, end.w);
}

@fragment
fn fragment_line(in: Line) -> @location(0) vec4f {
    return premultiplied(in.color, 1.0);
}

@fragment
fn fragment_line_behind(in: Line) -> @location(0) vec4f {
    return premultiplied(in.color, in.behind);
}
