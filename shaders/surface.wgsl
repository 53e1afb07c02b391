// A textured surface in space, one fragment entry point per pattern of pattern.wgsl, lit as space.wgsl
// says. Colours leave the shader linear; the target encodes.

struct View {
    eye: Eye,
    pattern: Pattern,
}

@group(0) @binding(0) var<uniform> view: View;

struct Vertex {
    @builtin(position) @invariant clip: vec4<f32>,
    // relative to the middle of the source's bounds
    @location(0) source: vec2<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) octave: f32,
    // the length of an edge of the mesh in the texture
    @location(3) edge: f32,
}

@vertex
fn vs_main(
    @location(0) position: vec4<f32>,
    @location(1) texture_coordinate: vec2<f32>,
    @location(2) scale: vec2<f32>,
) -> Vertex {
    var out: Vertex;
    out.clip = view.eye.clip * vec4<f32>(position.xyz, 1.0);
    out.source = texture_coordinate + view.pattern.lookup.xy;
    // a pixel is as long as the distance from the eye, which is w; foreshortening does not change the octave
    out.octave = octave_at(scale.x + log2(max(out.clip.w, 1e-6)));
    out.edge = scale.y;
    out.normal = view.eye.turn * unpacked_normal(position.w);
    return out;
}

fn shown(colour: vec3<f32>, in: Vertex, front: bool) -> vec4<f32> {
    return vec4<f32>(lit(colour, in.normal, front), 1.0);
}

@fragment
fn fs_checker(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return shown(checker_pattern(in.source, in.octave), in, front);
}

@fragment
fn fs_grid(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return shown(grid_pattern(in.source, in.octave), in, front);
}

@fragment
fn fs_polar(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return shown(polar_pattern(in.source, in.octave), in, front);
}

@fragment
fn fs_conformal(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return shown(conformal_pattern(in.source, in.octave), in, front);
}

@fragment
fn fs_image(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return shown(image_pattern(in.source), in, front);
}

@fragment
fn fs_tiling(in: Vertex, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return shown(tiling_pattern(in.source, in.edge), in, front);
}
