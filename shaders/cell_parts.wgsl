// Draws a mesh triangle by triangle, in the plane and in space: part of a module
// that declares a uniform block `view` with a member `edges` of this type.
//
// Nothing depends on which vertex of a triangle provokes flat values (the first
// in WebGPU, the last in WebGL2): vertices are not shared, a triangle's code is
// looked up by its index and equal at its three corners. Colours are linear.

struct Edges {
    // linear, straight alpha
    wire: vec4<f32>,
    // color of flipped triangles: linear
    mark: vec4<f32>,
    // in pixels, x: half the width of an edge; y: cells lower than this show no edges;
    // z: cells higher than this show them in full
    size: vec4<f32>,
}

@group(1) @binding(0) var positions: texture_2d<f32>;
@group(1) @binding(1) var codes: texture_2d<u32>;
@group(2) @binding(0) var palette: texture_2d<f32>;

const FLIPPED: u32 = 255u;

// As `ROW` in `cell_pass.rs`.
const ROW: u32 = 2048u;

fn texel(index: u32) -> vec2<i32> {
    return vec2<i32>(i32(index % ROW), i32(index / ROW));
}

// The code of the triangle that has this corner.
fn code_at(corner: u32) -> f32 {
    return f32(textureLoad(codes, texel(corner / 3u), 0).x);
}

// The barycentric coordinates of a corner.
fn corner_weights(index: u32) -> vec3<f32> {
    let corner = index % 3u;
    return vec3<f32>(
        select(0.0, 1.0, corner == 0u),
        select(0.0, 1.0, corner == 1u),
        select(0.0, 1.0, corner == 2u),
    );
}

fn cell_colour(code: f32) -> vec4<f32> {
    return textureLoad(palette, vec2<i32>(i32(round(code)), 0), 0);
}

// Edges over the marks of flipped triangles, premultiplied.
fn overlay(corner: vec3<f32>, code: f32) -> vec4<f32> {
    let dx = dpdx(corner);
    let dy = dpdy(corner);
    // 1 / the height over each edge, in pixels
    let steepness = max(sqrt(dx * dx + dy * dy), vec3<f32>(1e-9));
    let height = 1.0 / steepness;
    let size = view.edges.size;
    // on either side of an edge the same: a pixel that is partly covered has its center beyond the edge
    let covered = clamp(size.x + 0.5 - abs(corner) * height, vec3<f32>(0.0), vec3<f32>(1.0));
    let shown = covered * smoothstep(size.yyy, size.zzz, height);
    let line = view.edges.wire.a * max(shown.x, max(shown.y, shown.z));
    let marked = select(0.0, 1.0, u32(round(code)) == FLIPPED);
    return vec4<f32>(
        view.edges.mark.rgb * marked * (1.0 - line) + view.edges.wire.rgb * line,
        marked * (1.0 - line) + line,
    );
}
