// Regular hyperbolic tilings of the unit disk, with pattern.wgsl. As in src/tiling/fold.rs, half-turns about the middles of
// the central tile's edges bring a point into that tile.
//
// In view.pattern, tiling: x: p; y: the center of the circle in which the edge on the positive real axis lies; z: its
// radius; w: the style (0: tiles, 1: edges, 2: triangles, 3: picture). tile: x: sin π/p; y: cos π/p; z: the hyperbolic
// distance from the tile's center to an edge; w: 1 if two colors suffice for the tiles.
//
// Three things limit what is resolved, and the tiling fades to its mean color before they do: tiles of less than two
// pixels; f32, which next to the circle does not tell points apart; the mesh, whose triangles at the circle are straight
// where the map is not: they are off by the square of an edge's length over eight, and by more at corners.

// More than the half-turns from the points where f32 ends: 40 in {3, 7}, whose tiles are the smallest.
const MOST_TURNS: i32 = 64;
// 1 − |g|² where f32 ends: a rounding of 6e-8 is a hundredth of a tile at the first, and less beyond the second. Magnified
// ten times, edges in the hand's little finger are still smooth there.
const ROUNDED: vec2<f32> = vec2<f32>(1e-5, 4e-5);
// The distance to the circle, in edges of the mesh, up to which the mesh hides the tiles.
const MESH: vec2<f32> = vec2<f32>(0.06, 0.15);
// The width of a pixel in inradii of a tile from which on tiles fade, and up to which: tiles of two pixels.
const FADING: vec2<f32> = vec2<f32>(0.35, 1.0);
// The width of a triangle of the reflections over that of its tile.
const TRIANGLE: f32 = 0.4;
// The sectors by which a tile's picture is turned are turned by this part of a sector themselves, so that the direction to
// the disk's center is not at the border of two.
const TIE: f32 = 0.02;

fn times(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

fn conjugate(a: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(a.x, -a.y);
}

fn over(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {
    return times(a, conjugate(b)) / dot(b, b);
}

// The direction of the edge in whose sector a point lies; sectors are turned by a part of them.
fn edge_direction(z: vec2<f32>, shift: f32) -> vec2<f32> {
    let p = view.pattern.tiling.x;
    let angle = round(atan2(z.y, z.x) * 0.15915494 * p - shift) * 6.2831853 / p;
    return vec2<f32>(cos(angle), sin(angle));
}

// A point as it lies in the central tile.
struct Folded {
    // in the sector of the first edge
    place: vec2<f32>,
    // in the frame of its tile
    in_tile: vec2<f32>,
    // the disk's center in that frame
    center: vec2<f32>,
    // the derivative of in_tile by the point
    slope: vec2<f32>,
    // 1 after an odd number of half-turns
    odd: f32,
}

// z ↦ u(1 − cw)/(c − w) with w = ūz, the half-turn about the middle of the edge in the direction u.
fn half_turned(w: vec2<f32>, u: vec2<f32>) -> vec2<f32> {
    let center = view.pattern.tiling.y;
    return times(u, over(vec2<f32>(1.0, 0.0) - center * w, vec2<f32>(center, 0.0) - w));
}

fn folded(point: vec2<f32>) -> Folded {
    let center = view.pattern.tiling.y;
    let radius = view.pattern.tiling.z;
    var at: Folded;
    at.in_tile = point;
    at.slope = vec2<f32>(1.0, 0.0);
    for (var turn = 0; turn < MOST_TURNS; turn += 1) {
        let u = edge_direction(at.in_tile, 0.0);
        at.place = times(conjugate(u), at.in_tile);
        // beyond the edge |w − c|² < ρ² = c² − 1
        if dot(at.place, at.place) + 1.0 - 2.0 * center * at.place.x > -1e-6 {
            break;
        }
        let back = vec2<f32>(center, 0.0) - at.place;
        at.slope = times(at.slope, over(vec2<f32>(-radius * radius, 0.0), times(back, back)));
        at.in_tile = half_turned(at.place, u);
        at.center = half_turned(times(conjugate(u), at.center), u);
        at.odd = 1.0 - at.odd;
    }
    return at;
}

fn arsinh(x: f32) -> f32 {
    return sign(x) * log(abs(x) + sqrt(x * x + 1.0));
}

// The hyperbolic distances from the sides of the triangle: its tile's axis, the line to a corner, the edge.
fn mirror_distances(w: vec2<f32>) -> vec3<f32> {
    let gap = max(1.0 - dot(w, w), 1e-6);
    let along = 2.0 * abs(w.y);
    let across = 2.0 * (w.x * view.pattern.tile.x - abs(w.y) * view.pattern.tile.y);
    let edge = (dot(w, w) + 1.0 - 2.0 * view.pattern.tiling.y * w.x) / view.pattern.tiling.z;
    return vec3<f32>(arsinh(along / gap), arsinh(across / gap), arsinh(edge / gap));
}

// Blue at the circle, orange in the middle, by the hyperbolic distance d from there: tanh d/4 of the way, tanh d/2 being
// the radius.
fn depth_hue(radius: f32) -> vec3<f32> {
    let r = min(radius, 1.0);
    let way = r / (1.0 + sqrt(1.0 - r * r));
    return hue(vec2<f32>(0.0, view.pattern.source.x + (1.0 - way) / view.pattern.source.y));
}

// The share of the pixel that lies on this side of a mirror, in one of two colors, which are equal where `seen` is 0.
fn color_share(distance: f32, width: f32, is_other: bool, seen: f32) -> f32 {
    let near = clamp(0.5 + distance / width, 0.0, 1.0);
    return mix(0.5, select(near, 1.0 - near, is_other), seen);
}

// The share of the pixel that a line along an edge covers; lines cover at most a quarter of a tile's width.
fn edge_share(distance: f32, width: f32, line: f32) -> f32 {
    let half_line = min(0.5 * line, 0.12 * view.pattern.tile.z / width);
    let pixels = distance / width;
    return clamp(pixels + 0.5, -half_line, half_line) - clamp(pixels - 0.5, -half_line, half_line);
}

// The picture stands upright in the central tile; in the others its lower side is towards the disk's center.
fn tile_picture(at: Folded, dx: vec2<f32>, dy: vec2<f32>) -> vec3<f32> {
    let out = times(edge_direction(at.center, TIE), vec2<f32>(0.0, 1.0));
    let upright = select(conjugate(out), vec2<f32>(1.0, 0.0), dot(at.center, at.center) < 1e-3);
    let slope = times(upright, at.slope);
    return picture_at(times(upright, at.in_tile), times(slope, dx), times(slope, dy));
}

// `edge`: the length of an edge of the mesh in the disk.
fn tiling_pattern(g: vec2<f32>, edge: f32) -> vec3<f32> {
    let dx = dpdx(g);
    let dy = dpdy(g);
    let gap = 1.0 - dot(g, g);
    let style = i32(view.pattern.tiling.w + 0.5);
    // of a pixel, in the metric
    let width = max(2.0 * max(length(dx), length(dy)) / max(gap, 1e-7), 1e-7);
    let smallest = view.pattern.tile.z * select(1.0, TRIANGLE, style == 2);
    let seen = (1.0 - smoothstep(FADING.x, FADING.y, width / smallest))
        * smoothstep(ROUNDED.x, ROUNDED.y, gap)
        * smoothstep(MESH.x, MESH.y, 0.5 * gap / max(edge, 1e-7));
    let at = folded(select(vec2<f32>(0.0), g, gap > ROUNDED.x));
    let mirrors = mirror_distances(at.place);
    let line = view.pattern.lookup.w;
    let depth = depth_hue(length(g));
    let tile_hue = mix(depth, depth_hue(length(at.center)), seen);
    if style == 3 {
        let mean = textureSampleLevel(picture, picture_sampler, vec2<f32>(0.5), 16.0).rgb;
        let tile = mix(tile_picture(at, dx, dy), paper(), edge_share(mirrors.z, width, line));
        return mix(mean, tile, seen);
    }
    if style == 2 {
        let distance = min(mirrors.x, min(mirrors.y, mirrors.z));
        return mix(paper(), depth, color_share(distance, width, at.place.y < 0.0, seen));
    }
    if style == 0 && view.pattern.tile.w > 0.5 {
        return mix(paper(), tile_hue, color_share(mirrors.z, width, at.odd > 0.5, seen));
    }
    let share = seen * edge_share(mirrors.z, width, 1.7 * line);
    return mix(select(tile_hue, depth, style == 1), paper(), share);
}
