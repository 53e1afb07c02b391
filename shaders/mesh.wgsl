// The textured mesh in the plane, one fragment entry point per pattern of pattern.wgsl. Colours leave
// the shader linear; the target encodes.

struct View {
    // clip = position · placement.xy + placement.zw
    placement: vec4<f32>,
    pattern: Pattern,
}

@group(0) @binding(0) var<uniform> view: View;

struct Vertex {
    @builtin(position) clip: vec4<f32>,
    // relative to the middle of the source's bounds
    @location(0) source: vec2<f32>,
    @location(1) octave: f32,
    // the length of an edge of the mesh in the texture
    @location(2) edge: f32,
}

@vertex
fn vs_main(
    @location(0) position: vec2<f32>,
    @location(1) texture_coordinate: vec2<f32>,
    @location(2) scale: vec2<f32>,
) -> Vertex {
    var out: Vertex;
    out.clip = vec4<f32>(position * view.placement.xy + view.placement.zw, 0.0, 1.0);
    out.source = texture_coordinate + view.pattern.lookup.xy;
    out.octave = octave_at(scale.x);
    out.edge = scale.y;
    return out;
}

@fragment
fn fs_checker(in: Vertex) -> @location(0) vec4<f32> {
    return vec4<f32>(checker_pattern(in.source, in.octave), 1.0);
}

@fragment
fn fs_grid(in: Vertex) -> @location(0) vec4<f32> {
    return vec4<f32>(grid_pattern(in.source, in.octave), 1.0);
}

@fragment
fn fs_polar(in: Vertex) -> @location(0) vec4<f32> {
    return vec4<f32>(polar_pattern(in.source, in.octave), 1.0);
}

@fragment
fn fs_conformal(in: Vertex) -> @location(0) vec4<f32> {
    return vec4<f32>(conformal_pattern(in.source, in.octave), 1.0);
}

@fragment
fn fs_image(in: Vertex) -> @location(0) vec4<f32> {
    return vec4<f32>(image_pattern(in.source), 1.0);
}

@fragment
fn fs_tiling(in: Vertex) -> @location(0) vec4<f32> {
    return vec4<f32>(tiling_pattern(in.source, in.edge), 1.0);
}
