// Handles: one quad per disc with a white ring and a soft shadow, antialiased by
// the distance from the centre in pixels. Premultiplied, linear.

struct View {
    // pixel = position · placement.xy + placement.zw
    placement: vec4<f32>,
    // xy: viewport size in pixels, z: the radii' scale
    size: vec4<f32>,
}

@group(0) @binding(0) var<uniform> view: View;

struct Vertex {
    @builtin(position) clip: vec4<f32>,
    // from the centre, in pixels
    @location(0) offset: vec2<f32>,
    @location(1) @interpolate(flat) radius: f32,
    @location(2) @interpolate(flat) colour: vec4<f32>,
}

// The radius of the shadow, in radii of the disc.
const SHADOW: f32 = 1.7;

@vertex
fn vs_main(
    @builtin(vertex_index) corner: u32,
    @location(0) center: vec2<f32>,
    @location(1) radius: f32,
    @location(2) colour: vec4<f32>,
) -> Vertex {
    let side = vec2<f32>(
        select(-1.0, 1.0, (corner & 1u) == 1u),
        select(-1.0, 1.0, (corner & 2u) == 2u),
    );
    var out: Vertex;
    let scaled = radius * view.size.z;
    out.offset = side * (SHADOW * scaled + 1.0);
    let unit = (center * view.placement.xy + view.placement.zw + out.offset) / view.size.xy;
    out.clip = vec4<f32>(2.0 * unit.x - 1.0, 1.0 - 2.0 * unit.y, 0.0, 1.0);
    out.radius = scaled;
    out.colour = colour;
    return out;
}

@fragment
fn fs_main(in: Vertex) -> @location(0) vec4<f32> {
    let distance = length(in.offset);
    let disc = clamp(in.radius + 0.5 - distance, 0.0, 1.0);
    let face = clamp(0.74 * in.radius + 0.5 - distance, 0.0, 1.0);
    let solid = in.colour.a * disc;
    let colour = mix(vec3<f32>(1.0), in.colour.rgb, face);
    let fade = 1.0 - smoothstep(0.8, SHADOW, distance / in.radius);
    let shadow = 0.45 * in.colour.a * fade * fade * (1.0 - solid);
    return vec4<f32>(colour * solid, solid + shadow);
}
