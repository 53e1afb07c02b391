// A planar mesh triangle by triangle, with cell_parts.wgsl: one color each, edges as thin lines, marks. Colors
// leave the shader linear; the target encodes.

struct View {
    // clip = position · placement.xy + placement.zw
    placement: vec4<f32>,
    edges: Edges,
}

@group(0) @binding(0) var<uniform> view: View;

struct Vertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) code: f32,
    // barycentric
    @location(1) corner: vec3<f32>,
}

@vertex
fn vs_main(@builtin(vertex_index) index: u32, @location(0) vertex: u32) -> Vertex {
    let position = textureLoad(positions, texel(vertex), 0).xy;
    var out: Vertex;
    out.clip = vec4<f32>(position * view.placement.xy + view.placement.zw, 0.0, 1.0);
    out.code = code_at(index);
    out.corner = corner_weights(index);
    return out;
}

@fragment
fn fs_colour(in: Vertex) -> @location(0) vec4<f32> {
    return cell_colour(in.code);
}

@fragment
fn fs_overlay(in: Vertex) -> @location(0) vec4<f32> {
    return overlay(in.corner, in.code);
}
