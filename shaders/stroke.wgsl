// Coverage of a polyline of constant screen width: one quad per segment, in which
// the distance to the segment is measured in pixels. The target keeps the maximum, so that
// overlapping segments give exactly the coverage of the union: round joins, and no
// beads, even for very short segments.

struct Stroke {
    // pixel = position · placement.xy + placement.zw
    placement: vec4<f32>,
    // xy: viewport size in pixels; z: half the stroke's width
    size: vec4<f32>,
}

@group(0) @binding(0) var<uniform> stroke: Stroke;

struct Vertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) pixel: vec2<f32>,
    @location(1) @interpolate(flat) ends: vec4<f32>,
}

@vertex
fn vs_main(
    @builtin(vertex_index) corner: u32,
    @location(0) start: vec2<f32>,
    @location(1) end: vec2<f32>,
) -> Vertex {
    let a = start * stroke.placement.xy + stroke.placement.zw;
    let b = end * stroke.placement.xy + stroke.placement.zw;
    let span = b - a;
    let along = select(vec2<f32>(1.0, 0.0), span / max(length(span), 1e-12), dot(span, span) > 1e-12);
    let across = vec2<f32>(-along.y, along.x);
    let reach = stroke.size.z + 1.0;
    let forward = select(-1.0, 1.0, (corner & 1u) == 1u);
    let side = select(-1.0, 1.0, (corner & 2u) == 2u);
    let pixel = select(a, b, forward > 0.0) + reach * (forward * along + side * across);

    var out: Vertex;
    let unit = pixel / stroke.size.xy;
    out.clip = vec4<f32>(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y, 0.0, 1.0);
    out.pixel = pixel;
    out.ends = vec4<f32>(a, b);
    return out;
}

@fragment
fn fs_main(in: Vertex) -> @location(0) vec4<f32> {
    let from_start = in.pixel - in.ends.xy;
    let span = in.ends.zw - in.ends.xy;
    let along = clamp(dot(from_start, span) / max(dot(span, span), 1e-12), 0.0, 1.0);
    let outside = length(from_start - along * span) - stroke.size.z;
    return vec4<f32>(clamp(0.5 - outside, 0.0, 1.0), 0.0, 0.0, 1.0);
}
