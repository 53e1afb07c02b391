// The Cauchy–Green extension of a polygon's boundary values, one point per
// invocation: Cauchy's integral over the edges; γ is not stored. The formulas are
// those of `conformal/cauchy_green/contour.rs`; here they are arranged for f32.
//
// Positions are integers, so that differences are exact in any order of evaluation:
// a point 1e-9 of the extent beside an edge is on the correct side of it.
// Values are taken relative to the value at the boundary vertex nearest to z, which
// Σγ = 1 allows: the large logarithms of near edges multiply small values, constants
// are reproduced exactly, and the limit at a boundary vertex needs no angle there.

struct Sizes {
    edges: u32,
    points: u32,
    // from the scaled values to the caller's unit
    scale: f32,
    unused: u32,
}

// As `WORKGROUP` in `cauchy_green_pass.rs`.
const WORKGROUP: u32 = 64u;

const PI: f32 = 3.14159265;
const LN_2: f32 = 0.69314718;

// Up to this |q|² (an edge seen from four times its length) three terms of E are
// enough: the error is q⁸/9, below 2⁻²⁷.
const FAR: f32 = 0.015625;

// The rounding error of a cross product, relative to its two products: both have
// three roundings of 2⁻²⁴, their difference one.
const CROSS_ROUNDING: f32 = 2.4e-7;

@group(0) @binding(0) var<uniform> sizes: Sizes;
// xy: midpoint, zw: half the step from vertex k to k + 1
@group(0) @binding(1) var<storage, read> edges: array<vec4<i32>>;
// xy: position, z: the nearest boundary vertex
@group(0) @binding(2) var<storage, read_write> points: array<vec4<i32>>;
// w_k
@group(0) @binding(3) var<storage, read> values: array<vec2<f32>>;
@group(0) @binding(4) var<storage, read_write> images: array<vec2<f32>>;

var<workgroup> edge_tile: array<vec4<i32>, WORKGROUP>;
// w_{k+1}
var<workgroup> value_tile: array<vec2<f32>, WORKGROUP>;

fn times(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

// a · conj(b)
fn times_conjugate(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y);
}

// ln x for normal x > 0. WGSL's own may be off by 2⁻²¹. With x = 2^e y, y between
// √½ and √2, and f = (y − 1)/(y + 1): ln y = 2 artanh f, |f| < 0.172, off by f¹¹/11.
fn natural_log(x: f32) -> f32 {
    let bits = bitcast<u32>(x);
    var exponent = i32(bits >> 23u) - 127;
    var y = bitcast<f32>((bits & 0x7fffffu) | 0x3f800000u);
    if y > 1.41421356 {
        y = 0.5 * y;
        exponent += 1;
    }
    let f = (y - 1.0) / (y + 1.0);
    let g = f * f;
    let series = g * (1.0 / 3.0 + g * (0.2 + g * (1.0 / 7.0 + g * (1.0 / 9.0))));
    return f32(exponent) * LN_2 + 2.0 * (f + f * series);
}

// The angle of (x, y) ≠ 0, between −π and π. WGSL's atan2 may be off by 4096 ulp. The
// tangent of the half, the quarter, the eighth; |t| < 0.199 is left for the series, off by t¹¹/11.
fn angle(x: f32, y: f32) -> f32 {
    var t = y / (sqrt(x * x + y * y) + abs(x));
    t = t / (1.0 + sqrt(1.0 + t * t));
    t = t / (1.0 + sqrt(1.0 + t * t));
    let g = t * t;
    let series = g * (-1.0 / 3.0 + g * (0.2 + g * (-1.0 / 7.0 + g * (1.0 / 9.0))));
    let acute = 8.0 * (t + t * series);
    return select(acute, select(-PI, PI, y >= 0.0) - acute, x < 0.0);
}

// The contribution of a near edge to Σ(P u_k + Q u_{k+1}): `s` from z to its
// midpoint, `h` half the edge, both exact; `u` and `v` the relative values at its ends.
fn near_edge(s: vec2<i32>, h: vec2<i32>, u: vec2<f32>, v: vec2<f32>) -> vec2<f32> {
    let begin = s - h;
    let end = s + h;
    // z is a vertex, whose relative value is 0: Q = 1 on the edge that begins
    // there, P = −1 on the one that ends there
    if all(begin == vec2<i32>(0)) {
        return v;
    }
    if all(end == vec2<i32>(0)) {
        return -u;
    }
    let a = vec2<f32>(begin);
    let b = vec2<f32>(end);
    let left = a.x * b.y;
    let right = a.y * b.x;
    var cross = left - right;
    let along = dot(a, b);
    // z is inside: if it is on an edge up to rounding, it is on the inner side
    if along < 0.0 && abs(cross) <= CROSS_ROUNDING * (abs(left) + abs(right)) {
        cross = abs(cross);
    }
    let half_log = 0.5 * vec2<f32>(0.5 * natural_log(dot(b, b) / dot(a, a)), angle(along, cross));
    let half_edge = vec2<f32>(h);
    let inverse_q = times_conjugate(vec2<f32>(s), half_edge) / dot(half_edge, half_edge);
    let rest = times(half_log, inverse_q) - vec2<f32>(1.0, 0.0);
    return times(half_log, u + v) + times(rest, u - v);
}

// Half of L is q (1 + E), E = q²/3 + q⁴/5 + q⁶/7.
fn far_edge(s: vec2<f32>, h: vec2<f32>, square: f32, u: vec2<f32>, v: vec2<f32>) -> vec2<f32> {
    let q = times_conjugate(h, s) / square;
    let g = times(q, q);
    var rest = g * (1.0 / 7.0) + vec2<f32>(0.2, 0.0);
    rest = times(g, rest) + vec2<f32>(1.0 / 3.0, 0.0);
    rest = times(g, rest);
    return times(q + times(q, rest), u + v) + times(rest, u - v);
}

fn edge_term(z: vec2<i32>, edge: vec4<i32>, u: vec2<f32>, v: vec2<f32>) -> vec2<f32> {
    let to_middle = edge.xy - z;
    let s = vec2<f32>(to_middle);
    let h = vec2<f32>(edge.zw);
    let square = dot(s, s);
    if dot(h, h) >= FAR * square {
        return near_edge(to_middle, edge.zw, u, v);
    }
    return far_edge(s, h, square, u, v);
}

@compute @workgroup_size(WORKGROUP)
fn cs_evaluate(
    @builtin(global_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) lane: u32,
) {
    let point = points[min(id.x, sizes.points - 1u)];
    let reference = values[point.z];
    var total = vec2<f32>(0.0);
    var here = values[0] - reference;
    for (var first = 0u; first < sizes.edges; first += WORKGROUP) {
        let mine = min(first + lane, sizes.edges - 1u);
        edge_tile[lane] = edges[mine];
        value_tile[lane] = values[select(mine + 1u, 0u, mine + 1u == sizes.edges)];
        workgroupBarrier();
        // tile by tile: rounding grows with the tiles and their length, not with their product
        var part = vec2<f32>(0.0);
        let count = min(WORKGROUP, sizes.edges - first);
        for (var k = 0u; k < count; k++) {
            let next = value_tile[k] - reference;
            part += edge_term(point.xy, edge_tile[k], here, next);
            here = next;
        }
        total += part;
        workgroupBarrier();
    }
    if id.x < sizes.points {
        let image = reference + vec2<f32>(total.y, -total.x) / (2.0 * PI);
        images[id.x] = sizes.scale * image;
    }
}

// Run once per upload: finds the boundary vertex nearest to every point.
@compute @workgroup_size(WORKGROUP)
fn cs_nearest(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= sizes.points {
        return;
    }
    let z = points[id.x].xy;
    var nearest = 0u;
    var least = 3.4e38;
    for (var k = 0u; k < sizes.edges; k++) {
        let to = vec2<f32>(edges[k].xy - edges[k].zw - z);
        let square = dot(to, to);
        if square < least {
            nearest = k;
            least = square;
        }
    }
    points[id.x].z = i32(nearest);
}
