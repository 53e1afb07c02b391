// A surface in space triangle by triangle, with cell_parts.wgsl: one color each, lit by space.wgsl; edges as
// thin lines, marks. Colours leave the shader linear; the target encodes.

struct View {
    eye: Eye,
    edges: Edges,
}

@group(0) @binding(0) var<uniform> view: View;

struct Vertex {
    @builtin(position) @invariant clip: vec4<f32>,
    @location(0) code: f32,
    // barycentric
    @location(1) corner: vec3<f32>,
    @location(2) normal: vec3<f32>,
}

fn corner_vertex(index: u32, vertex: u32) -> Vertex {
    let position = textureLoad(positions, texel(vertex), 0);
    var out: Vertex;
    out.clip = view.eye.clip * vec4<f32>(position.xyz, 1.0);
    out.code = code_at(index);
    out.corner = corner_weights(index);
    out.normal = view.eye.turn * unpacked_normal(position.w);
    return out;
}

@vertex
fn vs_main(@builtin(vertex_index) index: u32, @location(0) vertex: u32) -> Vertex {
    return corner_vertex(index, vertex);
}

@fragment
fn fs_colour(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return vec4<f32>(lit(cell_colour(in.code).rgb, in.normal, front), 1.0);
}

// Edges lie on the surface, so they are drawn slightly in front of it.
@vertex
fn vs_overlay(@builtin(vertex_index) index: u32, @location(0) vertex: u32) -> Vertex {
    var out = corner_vertex(index, vertex);
    out.clip = lifted(out.clip);
    return out;
}

@fragment
fn fs_overlay(in: Vertex) -> @location(0) vec4<f32> {
    return overlay(in.corner, in.code);
}
