// The boundary loop of a surface in space, of constant width on the screen: one quad per segment, in which
// the distance to the segment is measured in pixels. Uncovered samples are not written, and the surface hides the
// line: it is drawn slightly in front of the surface, on whose edge it lies.

struct View {
    eye: Eye,
    // linear, straight alpha
    colour: vec4<f32>,
    // xy: viewport size in pixels; z: half the line's width
    size: vec4<f32>,
}

@group(0) @binding(0) var<uniform> view: View;

struct Vertex {
    // already divided by w
    @builtin(position) clip: vec4<f32>,
    @location(0) pixel: vec2<f32>,
    @location(1) @interpolate(flat) ends: vec4<f32>,
}

// The least distance from the eye that is drawn, relative to that of the other end.
const NEAREST: f32 = 1e-4;

// `end`, or, if it is behind the eye, the point where the segment comes in front of it.
fn cut(end: vec4<f32>, other: vec4<f32>) -> vec4<f32> {
    let nearest = NEAREST * max(abs(other.w), 1e-20);
    let along = (nearest - end.w) / (other.w - end.w);
    return select(end, mix(end, other, along), end.w < nearest && other.w > nearest);
}

fn pixel_of(clip: vec4<f32>) -> vec2<f32> {
    return (0.5 + vec2<f32>(0.5, -0.5) * clip.xy / clip.w) * view.size.xy;
}

@vertex
fn vs_main(
    @builtin(vertex_index) corner: u32,
    @location(0) start: vec3<f32>,
    @location(1) end: vec3<f32>,
) -> Vertex {
    let p = view.eye.clip * vec4<f32>(start, 1.0);
    let q = view.eye.clip * vec4<f32>(end, 1.0);
    var out: Vertex;
    if p.w <= 0.0 && q.w <= 0.0 {
        out.clip = vec4<f32>(0.0, 0.0, 2.0, 1.0);
        return out;
    }
    let from_clip = lifted(cut(p, q));
    let to_clip = lifted(cut(q, p));
    let a = pixel_of(from_clip);
    let b = pixel_of(to_clip);
    let span = b - a;
    let along = select(vec2<f32>(1.0, 0.0), span / max(length(span), 1e-12), dot(span, span) > 1e-12);
    let across = vec2<f32>(-along.y, along.x);
    let reach = view.size.z + 1.0;
    let forward = select(-1.0, 1.0, (corner & 1u) == 1u);
    let side = select(-1.0, 1.0, (corner & 2u) == 2u);
    let here = select(from_clip, to_clip, forward > 0.0);
    let pixel = select(a, b, forward > 0.0) + reach * (forward * along + side * across);
    let unit = pixel / view.size.xy;
    out.clip = vec4<f32>(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y, here.z / here.w, 1.0);
    out.pixel = pixel;
    out.ends = vec4<f32>(a, b);
    return out;
}

// Alpha decides how many samples are covered.
@fragment
fn fs_main(in: Vertex) -> @location(0) vec4<f32> {
    let from_start = in.pixel - in.ends.xy;
    let span = in.ends.zw - in.ends.xy;
    let along = clamp(dot(from_start, span) / max(dot(span, span), 1e-12), 0.0, 1.0);
    let coverage = clamp(0.5 + view.size.z - length(from_start - along * span), 0.0, 1.0);
    if coverage <= 0.0 {
        discard;
    }
    return vec4<f32>(view.colour.rgb, coverage);
}
