// Copies a viewport's finished picture into the caller's pass, over the whole
// viewport rectangle. The picture is linear when read and premultiplied.

@group(0) @binding(0) var picture: texture_2d<f32>;
@group(0) @binding(1) var picture_sampler: sampler;

struct Vertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) uv: vec2<f32>,
}

@vertex
fn vs_main(@builtin(vertex_index) corner: u32) -> Vertex {
    let x = f32(i32(corner & 1u) * 4 - 1);
    let y = f32(i32(corner & 2u) * 2 - 1);
    var out: Vertex;
    out.clip = vec4<f32>(x, y, 0.0, 1.0);
    out.uv = vec2<f32>(0.5 + 0.5 * x, 0.5 - 0.5 * y);
    return out;
}

fn srgb_from_linear(linear: vec3<f32>) -> vec3<f32> {
    let low = linear * 12.92;
    let high = 1.055 * pow(linear, vec3<f32>(1.0 / 2.4)) - 0.055;
    return select(high, low, linear <= vec3<f32>(0.0031308));
}

// For an sRGB target, which the hardware encodes.
@fragment
fn fs_linear(in: Vertex) -> @location(0) vec4<f32> {
    return textureSample(picture, picture_sampler, in.uv);
}

// For a target that holds encoded bytes: encode the straight colour, premultiply
// again.
@fragment
fn fs_encoded(in: Vertex) -> @location(0) vec4<f32> {
    let texel = textureSample(picture, picture_sampler, in.uv);
    let straight = clamp(texel.rgb / max(texel.a, 1e-6), vec3<f32>(0.0), vec3<f32>(1.0));
    return vec4<f32>(srgb_from_linear(straight) * texel.a, texel.a);
}
