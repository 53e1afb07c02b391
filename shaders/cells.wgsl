// A mesh triangle by triangle: one colour each, edges as thin lines, marks.
//
// Nothing depends on which vertex of a triangle provokes flat values (the first
// in WebGPU, the last in WebGL2): vertices are not shared, a triangle's code is
// looked up by its index and equal at its three corners. Colours leave the
// shader linear; the target encodes.

struct Cells {
    // clip = position · placement.xy + placement.zw
    placement: vec4<f32>,
    // of the edges: linear, straight alpha
    wire: vec4<f32>,
    // of flipped triangles: linear
    mark: vec4<f32>,
    // in pixels, x: half the width of an edge; y, z: cells of this height show
    // no edges, all of them
    size: vec4<f32>,
}

@group(0) @binding(0) var<uniform> cells: Cells;
@group(1) @binding(0) var positions: texture_2d<f32>;
@group(1) @binding(1) var codes: texture_2d<u32>;
@group(2) @binding(0) var palette: texture_2d<f32>;

struct Vertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) code: f32,
    // barycentric
    @location(1) corner: vec3<f32>,
}

const FLIPPED: u32 = 255u;

// As `ROW` in `cell_pass.rs`.
const ROW: u32 = 2048u;

fn texel(index: u32) -> vec2<i32> {
    return vec2<i32>(i32(index % ROW), i32(index / ROW));
}

@vertex
fn vs_main(@builtin(vertex_index) index: u32, @location(0) vertex: u32) -> Vertex {
    let position = textureLoad(positions, texel(vertex), 0).xy;
    let corner = index % 3u;
    var out: Vertex;
    out.clip = vec4<f32>(position * cells.placement.xy + cells.placement.zw, 0.0, 1.0);
    out.code = f32(textureLoad(codes, texel(index / 3u), 0).x);
    out.corner = vec3<f32>(
        select(0.0, 1.0, corner == 0u),
        select(0.0, 1.0, corner == 1u),
        select(0.0, 1.0, corner == 2u),
    );
    return out;
}

@fragment
fn fs_colour(in: Vertex) -> @location(0) vec4<f32> {
    return textureLoad(palette, vec2<i32>(i32(round(in.code)), 0), 0);
}

// Premultiplied: edges over the marks of flipped triangles.
@fragment
fn fs_overlay(in: Vertex) -> @location(0) vec4<f32> {
    let dx = dpdx(in.corner);
    let dy = dpdy(in.corner);
    // 1 / the height over each edge, in pixels
    let steepness = max(sqrt(dx * dx + dy * dy), vec3<f32>(1e-9));
    let height = 1.0 / steepness;
    let covered = clamp(cells.size.x + 0.5 - in.corner * height, vec3<f32>(0.0), vec3<f32>(1.0));
    let shown = covered * smoothstep(cells.size.yyy, cells.size.zzz, height);
    let line = cells.wire.a * max(shown.x, max(shown.y, shown.z));
    let marked = select(0.0, 1.0, u32(round(in.code)) == FLIPPED);
    return vec4<f32>(
        cells.mark.rgb * marked * (1.0 - line) + cells.wire.rgb * line,
        marked * (1.0 - line) + line,
    );
}
