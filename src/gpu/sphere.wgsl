// The sphere pass; twin of the definitions in geom/sphere.rs. Table and model are parts of a square with shaders of their own:
// a software rasteriser computes both sides of every branch.
//
// No @align or @size in uniforms: the GLSL that GL gets knows neither, and would read other numbers.

struct SphereLight {
    direction: vec3f,
    // Irradiance on the exposed picture.
    irradiance: vec3f,
}

struct Sphere {
    brdf: array<vec4f, BRDF_SLOTS>,
    lights: array<SphereLight, 4>,
    light_count: u32,
    // 1 between cells, 0 raw.
    smoothly: u32,
    // Left of it the table is shown, right of it the model; in units of the radius.
    split: f32,
    // Radius in pixels, for the soft rim.
    radius_px: f32,
    // What is in the middle of the square, and how far it is enlarged.
    sight: vec4f,
    hatch_dark: vec4f,
    hatch_light: vec4f,
    // Of the comparison: 0 for the difference and 1 for the ratio, its limit, that of the ratio in stops, and the
    // radiance below which there is nothing to compare.
    comparison: vec4f,
    // Colours of the comparison at even places from 0 to 1.
    colors: array<vec4f, 33>,
}

@group(0) @binding(0) var<uniform> sphere: Sphere;
@group(0) @binding(1) var table: texture_2d_array<f32>;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) point: vec2f,
}

// A corner of the part of the square between two abscissas in [-1, 1].
fn part(index: u32, left: f32, right: f32) -> Vertex {
    let x = select(left, right, (index & 1u) == 1u);
    let corner = vec2f(x, f32(index >> 1u) * 2.0 - 1.0);
    let place = (corner - sphere.sight.xy) * sphere.sight.z;
    return Vertex(vec4f(place, 0.0, 1.0), corner * margin());
}

// The square is two pixels wider than the sphere, in units of the radius.
fn margin() -> f32 {
    return 1.0 + 2.0 / sphere.radius_px;
}

fn cut() -> f32 {
    return clamp(sphere.split / margin(), -1.0, 1.0);
}

@vertex
fn vertex_measured(@builtin(vertex_index) index: u32) -> Vertex {
    return part(index, -1.0, cut());
}

@vertex
fn vertex_model(@builtin(vertex_index) index: u32) -> Vertex {
    return part(index, cut(), 1.0);
}

@vertex
fn vertex_compared(@builtin(vertex_index) index: u32) -> Vertex {
    return part(index, -1.0, 1.0);
}

@fragment
fn fragment_compared(in: Vertex) -> @location(0) vec4f {
    return with_soft_rim(compared(frame_at(in.point), in.position.xy), in.point);
}

@fragment
fn fragment_measured(in: Vertex) -> @location(0) vec4f {
    return with_soft_rim(measured(frame_at(in.point), in.position.xy), in.point);
}

@fragment
fn fragment_model(in: Vertex) -> @location(0) vec4f {
    return with_soft_rim(modelled(frame_at(in.point)), in.point);
}

// Premultiplied; transparent outside.
fn with_soft_rim(color: vec3f, point: vec2f) -> vec4f {
    let coverage = clamp((1.0 - length(point)) * sphere.radius_px + 0.5, 0.0, 1.0);
    return vec4f(color, 1.0) * coverage;
}

// From view space to the local frame of the surface at a point.
fn frame_at(point: vec2f) -> mat3x3f {
    // The soft rim is shaded as the last point of the sphere.
    let p = point * min(1.0, 0.9999 / max(length(point), 1e-6));
    let n = vec3f(p, sqrt(max(1.0 - dot(p, p), 0.0)));
    var tangent = VIEW - n * n.z;
    let across = length(tangent);
    if across > 1e-6 {
        tangent = tangent / across;
    } else {
        tangent = vec3f(1.0, 0.0, 0.0);
    }
    return transpose(mat3x3f(tangent, cross(n, tangent), n));
}

const VIEW = vec3f(0.0, 0.0, 1.0);

// sRGB-encoded colour by the model.
fn modelled(frame: mat3x3f) -> vec3f {
    let brdf = brdf_from_slots(sphere.brdf);
    let wo = frame * VIEW;
    var radiance = vec3f(0.0);
    for (var k = 0u; k < sphere.light_count; k++) {
        let wi = frame * sphere.lights[k].direction;
        let f_r = eval_brdf(brdf, cosines_from_directions(wi, wo));
        radiance += f_r * max(wi.z, 0.0) * sphere.lights[k].irradiance;
    }
    return srgb_encode(radiance);
}

// sRGB-encoded colour by the table; a hatch where a light that is above the horizon has no value.
fn measured(frame: mat3x3f, pixel: vec2f) -> vec3f {
    let wo = frame * VIEW;
    var radiance = vec3f(0.0);
    var unmeasured = false;
    for (var k = 0u; k < sphere.light_count; k++) {
        let wi = frame * sphere.lights[k].direction;
        if wi.z <= 0.0 {
            continue;
        }
        let value = lookup_table(table, sphere.smoothly == 1u, wi, wo);
        unmeasured = unmeasured || value.a == 0.0;
        // Far past white; a larger one could overflow.
        radiance += min(value.rgb, vec3f(1e15)) * wi.z * sphere.lights[k].irradiance;
    }
    if unmeasured {
        return hatch(pixel);
    }
    return srgb_encode(radiance);
}

fn hatch(pixel: vec2f) -> vec3f {
    let stripe = fract((pixel.x + pixel.y) / 8.0) < 0.5;
    return select(sphere.hatch_light.rgb, sphere.hatch_dark.rgb, stripe);
}

// How far the model is from the table, as a colour of the map; hatched as the table is, plain where no light is.
fn compared(frame: mat3x3f, pixel: vec2f) -> vec3f {
    let brdf = brdf_from_slots(sphere.brdf);
    let wo = frame * VIEW;
    var measured = vec3f(0.0);
    var model = vec3f(0.0);
    var unmeasured = false;
    for (var k = 0u; k < sphere.light_count; k++) {
        let wi = frame * sphere.lights[k].direction;
        if wi.z <= 0.0 {
            continue;
        }
        let value = lookup_table(table, sphere.smoothly == 1u, wi, wo);
        unmeasured = unmeasured || value.a == 0.0;
        let f_r = eval_brdf(brdf, cosines_from_directions(wi, wo));
        let irradiance = wi.z * sphere.lights[k].irradiance;
        measured += min(value.rgb, vec3f(1e15)) * irradiance;
        model += min(f_r, vec3f(1e15)) * irradiance;
    }
    let place = sphere_error(luminance(measured), luminance(model));
    if unmeasured {
        return hatch(pixel);
    }
    if place < 0.0 {
        return sphere.hatch_dark.rgb;
    }
    let x = place * 32.0;
    let low = min(u32(x), 31u);
    return mix(sphere.colors[low].rgb, sphere.colors[low + 1u].rgb, x - f32(low));
}

// Place on the colour map, in [0, 1]; negative where neither is lit. Twin of geom/sphere_error.rs.
fn sphere_error(measured: f32, model: f32) -> f32 {
    let no_light = sphere.comparison.w;
    if max(measured, model) < no_light {
        return -1.0;
    }
    let difference = abs(model - measured) / sphere.comparison.y;
    let stops = log2(max(model, no_light)) - log2(max(measured, no_light));
    let ratio = 0.5 + 0.5 * stops / sphere.comparison.z;
    return clamp(select(difference, ratio, sphere.comparison.x == 1.0), 0.0, 1.0);
}
