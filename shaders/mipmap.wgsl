// One mip level from the level above: the mean of four texels in linear color.

@group(0) @binding(0) var above: texture_2d<f32>;
@group(0) @binding(1) var above_sampler: sampler;

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

@fragment
fn fs_main(in: Vertex) -> @location(0) vec4<f32> {
    return textureSample(above, above_sampler, in.uv);
}
