// A finished picture put over the whole viewport, pixel by pixel; it is premultiplied.

@group(0) @binding(0) var picture: texture_2d<f32>;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) place: vec2f,
}

@vertex
fn vertex_blit(@builtin(vertex_index) index: u32) -> Corner {
    let place = vec2f(f32(index & 1u), f32(index >> 1u));
    return Corner(vec4f(2.0 * place - 1.0, 0.0, 1.0), vec2f(place.x, 1.0 - place.y));
}

@fragment
fn fragment_blit(in: Corner) -> @location(0) vec4f {
    let size = vec2f(textureDimensions(picture));
    let pixel = clamp(in.place * size, vec2f(0.0), size - 1.0);
    return textureLoad(picture, vec2u(pixel), 0);
}
