// Lays a stroke's colour over the picture, weighted by its coverage.

struct Colour {
    // linear, straight alpha
    stroke: vec4<f32>,
}

@group(0) @binding(0) var<uniform> colour: Colour;
@group(1) @binding(0) var coverage: texture_2d<f32>;

@vertex
fn vs_main(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let x = f32(i32(corner & 1u) * 4 - 1);
    let y = f32(i32(corner & 2u) * 2 - 1);
    return vec4<f32>(x, y, 0.0, 1.0);
}

@fragment
fn fs_main(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let alpha = colour.stroke.a * textureLoad(coverage, vec2<i32>(pixel.xy), 0).r;
    return vec4<f32>(colour.stroke.rgb * alpha, alpha);
}
