// The sphere pass: one draw of a square; twin of the definitions in sphere.rs.

struct SphereLight {
    direction: vec3f,
    // Irradiance on the exposed picture.
    irradiance: vec3f,
}

struct Sphere {
    brdf: Brdf,
    lights: array<SphereLight, 4>,
    light_count: u32,
    // 1 between cells, 0 raw.
    smoothly: u32,
    // Left of it the table is shown, right of it the model; in units of the radius.
    split: f32,
    // Radius in pixels, for the soft rim.
    radius_px: f32,
    hatch_dark: vec4f,
    hatch_light: vec4f,
}

@group(0) @binding(0) var<uniform> sphere: Sphere;
@group(0) @binding(1) var table: texture_2d_array<f32>;

struct Vertex {
    @builtin(position) position: vec4f,
    @location(0) point: vec2f,
}

@vertex
fn vertex_main(@builtin(vertex_index) index: u32) -> Vertex {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 2.0 - 1.0;
    return Vertex(vec4f(corner, 0.0, 1.0), corner * (1.0 + 2.0 / sphere.radius_px));
}

@fragment
fn fragment_main(in: Vertex) -> @location(0) vec4f {
    let radius = length(in.point);
    let coverage = clamp((1.0 - radius) * sphere.radius_px + 0.5, 0.0, 1.0);
    if coverage <= 0.0 {
        return vec4f(0.0);
    }
    // The soft rim is shaded as the last point of the sphere.
    let p = in.point * min(1.0, 0.9999 / max(radius, 1e-6));
    let n = vec3f(p, sqrt(max(1.0 - dot(p, p), 0.0)));
    let color = shade(n, in.point.x < sphere.split, in.position.xy);
    return vec4f(color, 1.0) * coverage;
}

// sRGB-encoded colour at a point with this normal.
fn shade(n: vec3f, measured: bool, pixel: vec2f) -> vec3f {
    let view = vec3f(0.0, 0.0, 1.0);
    var tangent = view - n * n.z;
    let across = length(tangent);
    if across > 1e-6 {
        tangent = tangent / across;
    } else {
        tangent = vec3f(1.0, 0.0, 0.0);
    }
    let bitangent = cross(n, tangent);
    let frame = transpose(mat3x3f(tangent, bitangent, n));
    let wo = frame * view;
    var radiance = vec3f(0.0);
    var unmeasured = false;
    for (var k = 0u; k < sphere.light_count; k++) {
        let wi = frame * sphere.lights[k].direction;
        if wi.z <= 0.0 {
            continue;
        }
        var f_r = vec3f(0.0);
        if measured {
            let value = lookup_table(table, sphere.smoothly == 1u, wi, wo);
            f_r = value.rgb;
            unmeasured = unmeasured || value.a == 0.0;
        } else {
            f_r = eval_brdf(sphere.brdf, cosines_from_directions(wi, wo));
        }
        radiance += f_r * wi.z * sphere.lights[k].irradiance;
    }
    if unmeasured {
        let stripe = fract((pixel.x + pixel.y) / 8.0) < 0.5;
        return select(sphere.hatch_light.rgb, sphere.hatch_dark.rgb, stripe);
    }
    return srgb_encode(radiance);
}
