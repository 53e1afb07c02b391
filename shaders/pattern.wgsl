// The patterns, evaluated from interpolated source coordinates: part of every module that draws a
// textured mesh, which declares a uniform block `view` with a member `pattern` of this type, and the image at
// group 1.
//
// Antialiasing: a pattern is averaged over the pixel's footprint, the gradient
// length of each pattern coordinate, with a box filter in closed form. Where cells
// approach the size of a pixel the pattern fades to its mean color, which
// avoids moiré. Colors are linear.
//
// Octaves: where the map or the camera makes cells larger or smaller by a factor of two than in a picture of the
// whole domain, they are divided or joined, so that a pixel lies between two octaves of the pattern, which fade into
// each other. The local scale is |f'| times that of the camera, from the vertices: derivatives by pixel are constant on
// triangles, which would be seen.

struct Pattern {
    // xy: texture coordinate → relative to the middle of the source's bounds;
    // z: cells per source unit; w: width of a thin line in pixels
    lookup: vec4<f32>,
    // x: lowest y, y: 1 / height, both relative to that middle; zw: the pole
    source: vec4<f32>,
    // xy: image coordinates per source unit; z: 1 if the pattern has octaves, else 0; w: log2 of the drawn mesh's
    // units per pixel over the source units per pixel in a picture of the whole domain
    image: vec4<f32>,
    // xy: the image's middle relative to that middle; z: the angle by which it is turned; w: 1 with paper around it
    placed: vec4<f32>,
    // sRGB-encoded control points of the hue change, from top to bottom
    hue_top: vec4<f32>,
    hue_middle: vec4<f32>,
    hue_bottom: vec4<f32>,
    // sRGB-encoded
    paper: vec4<f32>,
    // see tiling.wgsl
    tiling: vec4<f32>,
    tile: vec4<f32>,
}

@group(1) @binding(0) var picture: texture_2d<f32>;
@group(1) @binding(1) var picture_sampler: sampler;

fn linear_from_srgb(encoded: vec3<f32>) -> vec3<f32> {
    let low = encoded / 12.92;
    let high = pow((encoded + 0.055) / 1.055, vec3<f32>(2.4));
    return select(high, low, encoded <= vec3<f32>(0.04045));
}

fn paper() -> vec3<f32> {
    return linear_from_srgb(view.pattern.paper.rgb);
}

// Quadratic Bézier curve from the bottom's to the top's color, by height.
fn hue(source: vec2<f32>) -> vec3<f32> {
    let t = clamp((source.y - view.pattern.source.x) * view.pattern.source.y, 0.0, 1.0);
    let below = mix(view.pattern.hue_bottom.rgb, view.pattern.hue_middle.rgb, t);
    let above = mix(view.pattern.hue_middle.rgb, view.pattern.hue_top.rgb, t);
    return linear_from_srgb(mix(below, above, t));
}

// Cells are at least 2⁻¹² and at most 2⁶ times as wide as in the plain pattern: beyond the first, f32 no longer tells
// them apart (2⁻²⁴ of the domain, 20 cells across), beyond the second a cell exceeds the domain.
const FINEST: f32 = -12.0;
const COARSEST: f32 = 6.0;
// The part of an octave over which it fades into the next one. Outside of it cells are as crisp as in the plain pattern.
const FADE: vec2<f32> = vec2<f32>(0.4, 0.6);

// A power of two, exactly.
fn power_of_two(exponent: f32) -> f32 {
    return bitcast<f32>(u32(i32(exponent) + 127) << 23u);
}

// The octave of a vertex, 0 in a picture of the whole domain, larger where cells are smaller than there. `scale`: log2 of
// the source units per unit of the drawn mesh.
fn octave_at(scale: f32) -> f32 {
    return view.pattern.image.z * (scale + view.pattern.image.w);
}

// x: the number of cells of the finer octave per cell of the plain pattern, y: the share of the coarser octave, which
// has half as many.
fn around_octave(octave: f32, coarsest: f32) -> vec2<f32> {
    let level = clamp(octave, FINEST, coarsest);
    let below = floor(level);
    return vec2<f32>(power_of_two(-below), smoothstep(FADE.x, FADE.y, level - below));
}

// The length of the gradient of each coordinate, from its derivatives along the axes of the screen.
fn gradients(dx: vec2<f32>, dy: vec2<f32>) -> vec2<f32> {
    return max(sqrt(dx * dx + dy * dy), vec2<f32>(1e-12));
}

// 1 while cells are clearly larger than a pixel, 0 when they are not.
fn resolved(width: vec2<f32>) -> vec2<f32> {
    return 1.0 - smoothstep(vec2<f32>(0.5), vec2<f32>(1.1), width);
}

// Share of the footprint covered by lines of `line` pixels at the integers.
// A line covers at most a quarter of a cell.
fn line_share(coordinate: f32, width: f32, line: f32) -> f32 {
    let half_line = min(0.5 * line, 0.125 / width);
    let pixels = (coordinate - round(coordinate)) / width;
    let share = clamp(pixels + 0.5, -half_line, half_line) - clamp(pixels - 0.5, -half_line, half_line);
    return mix(share, 2.0 * half_line * width, smoothstep(0.4, 1.0, width));
}

// Mean over the footprint of a square wave: 1 on [0, 1), −1 on [1, 2). Only the
// nearest edge counts, exact up to a footprint of one cell, where `resolved` ends.
fn square_wave(cells: vec2<f32>, width: vec2<f32>) -> vec2<f32> {
    let edge = round(cells);
    let rising = 1.0 - 4.0 * fract(0.5 * edge);
    return rising * clamp(2.0 * (cells - edge) / width, vec2<f32>(-1.0), vec2<f32>(1.0));
}

// The share of the colored cells.
fn checker_share(cells: vec2<f32>, width: vec2<f32>) -> f32 {
    let wave = square_wave(cells, width) * resolved(width);
    return 0.5 - 0.5 * wave.x * wave.y;
}

// A point in cells of the finer octave, the width of its pixel there, and the share of the coarser octave.
struct CellPoint {
    cells: vec2<f32>,
    width: vec2<f32>,
    coarser: f32,
}

fn in_cells(source: vec2<f32>, octave: f32) -> CellPoint {
    let level = around_octave(octave, COARSEST);
    let per_unit = view.pattern.lookup.z * level.x;
    return CellPoint(source * per_unit, gradients(dpdx(source), dpdy(source)) * per_unit, level.y);
}

fn checker_pattern(source: vec2<f32>, octave: f32) -> vec3<f32> {
    let at = in_cells(source, octave);
    let share = mix(checker_share(at.cells, at.width), checker_share(0.5 * at.cells, 0.5 * at.width), at.coarser);
    return mix(paper(), hue(source), share);
}

// The share of the paper's color of thin and strong lines.
fn ruled_share(thin: f32, strong: f32) -> f32 {
    return max(0.62 * thin, strong);
}

// The hue, with lines in the paper's color over it.
fn ruled(source: vec2<f32>, share: f32) -> vec3<f32> {
    return mix(hue(source), paper(), share);
}

fn grid_share(cells: vec2<f32>, width: vec2<f32>) -> f32 {
    let line = view.pattern.lookup.w;
    let thin = max(line_share(cells.x, width.x, line), line_share(cells.y, width.y, line));
    let strong = max(
        line_share(0.25 * cells.x, 0.25 * width.x, 1.7 * line),
        line_share(0.25 * cells.y, 0.25 * width.y, 1.7 * line),
    );
    return ruled_share(thin, strong);
}

fn grid_pattern(source: vec2<f32>, octave: f32) -> vec3<f32> {
    let at = in_cells(source, octave);
    return ruled(source, mix(grid_share(at.cells, at.width), grid_share(0.5 * at.cells, 0.5 * at.width), at.coarser));
}

// The doublings of the rays: beyond them the angle in f32 does not tell rays apart.
const MOST_RAYS: f32 = 14.0;

// Circles at whole radii; rays as on polar graph paper: 6, doubled at the radii
// 1, 2, 4, …, so that cells stay between half and one cell wide.
// `radial` and `around`: units per pixel along the radius and across it.
fn polar_share(p: vec2<f32>, radial: f32, around: f32) -> f32 {
    let radius = max(length(p), 1e-6);
    let line = view.pattern.lookup.w;
    let beyond_pole = smoothstep(0.4, 0.6, radius);
    let circle = beyond_pole * line_share(radius, radial, line);
    let strong_circle = smoothstep(1.5, 2.5, radius) * line_share(0.25 * radius, 0.25 * radial, 1.7 * line);

    let turns = atan2(p.y, p.x) * 0.15915494;
    let angular = max(around / radius * 0.15915494, 1e-9);
    let rays = 6.0 * exp2(clamp(floor(log2(radius)) + 1.0, 0.0, MOST_RAYS));
    let ray = line_share(turns * rays, angular * rays, line);
    let strong_ray = line_share(turns * 6.0, angular * 6.0, 1.7 * line);
    return ruled_share(max(circle, ray), max(strong_circle, strong_ray));
}

fn polar_pattern(source: vec2<f32>, octave: f32) -> vec3<f32> {
    let dx = dpdx(source);
    let dy = dpdy(source);
    let level = around_octave(octave, COARSEST);
    let per_unit = view.pattern.lookup.z * level.x;
    let to = source - view.pattern.source.zw;
    let out = to / max(length(to), 1e-12);
    let across = vec2<f32>(-out.y, out.x);
    let radial = max(per_unit * length(vec2<f32>(dot(out, dx), dot(out, dy))), 1e-6);
    let around = per_unit * length(vec2<f32>(dot(across, dx), dot(across, dy)));
    let p = per_unit * to;
    let fine = polar_share(p, radial, around);
    return ruled(source, mix(fine, polar_share(0.5 * p, 0.5 * radial, 0.5 * around), level.y));
}

// Circles and rays of the unit disk, in log-polar coordinates: the whole numbers of
// −ln|g| · n/2π and arg g · n/2π. The square cells shrink towards the center; lines fade
// where cells are too small to be distinguished, the strong ones at a fourth of the size.
// The boundary, also a circle of the grid, is left out: it has its own stroke, and where
// the domain crowds, all of it is mapped within f32 onto that circle, at a single point.
// Cells are divided where the map or the camera makes them larger than at the boundary of a picture of the whole disk;
// they are not joined, since the number of rays is no power of two.
fn conformal_share(cells: vec2<f32>, width: vec2<f32>, turning: f32) -> f32 {
    let seen = vec2<f32>(smoothstep(0.4, 0.6, cells.x), turning);
    let line = view.pattern.lookup.w;
    let thin = seen * vec2<f32>(line_share(cells.x, width.x, line), line_share(cells.y, width.y, line));
    let strong = seen * vec2<f32>(
        line_share(0.25 * cells.x, 0.25 * width.x, 1.7 * line),
        line_share(0.25 * cells.y, 0.25 * width.y, 1.7 * line),
    );
    let size = max(width.x, width.y);
    let fade = 1.0 - smoothstep(vec2<f32>(0.08), vec2<f32>(0.22), vec2<f32>(1.0, 0.25) * size);
    return ruled_share(fade.x * max(thin.x, thin.y), fade.y * max(strong.x, strong.y));
}

fn conformal_pattern(source: vec2<f32>, octave: f32) -> vec3<f32> {
    let g = source;
    let dx = dpdx(g);
    let dy = dpdy(g);
    let radius = max(length(g), 1e-6);
    let out = g / radius;
    let around = vec2<f32>(-out.y, out.x);
    let per_radian = 0.15915494 * 4.0 * round(1.5 * view.pattern.lookup.z);

    let gradient = per_radian / radius * vec2<f32>(
        length(vec2<f32>(dot(out, dx), dot(out, dy))),
        length(vec2<f32>(dot(around, dx), dot(around, dy))),
    );
    // in log-polar coordinates, whose unit at the boundary is as long as that of the disk
    let level = around_octave(octave - view.pattern.image.z * log2(radius), 0.0);
    let width = level.x * max(gradient, vec2<f32>(1e-9));
    let cells = level.x * per_radian * vec2<f32>(-log(radius), atan2(g.y, g.x));
    let turning = smoothstep(1e-6, 1e-4, gradient.y);
    let fine = conformal_share(cells, width, turning);
    let share = mix(fine, conformal_share(0.5 * cells, 0.5 * width, turning), level.y);
    // blue at the boundary, orange at the centre
    let depth = vec2<f32>(0.0, view.pattern.source.x + (1.0 - min(radius, 1.0)) / view.pattern.source.y);
    return ruled(depth, share);
}

// A vector in the coordinates of the placed picture.
fn in_picture(p: vec2<f32>) -> vec2<f32> {
    let right = vec2<f32>(cos(view.pattern.placed.z), sin(view.pattern.placed.z));
    let turned = vec2<f32>(dot(p, right), dot(p, vec2<f32>(-right.y, right.x)));
    return turned * view.pattern.image.xy * vec2<f32>(1.0, -1.0);
}

fn image_pattern(source: vec2<f32>) -> vec3<f32> {
    return picture_at(source, dpdx(source), dpdy(source));
}

// The picture at a point, with the point's derivatives along the axes of the screen.
fn picture_at(source: vec2<f32>, along_x: vec2<f32>, along_y: vec2<f32>) -> vec3<f32> {
    let uv = in_picture(source - view.pattern.placed.xy) + 0.5;
    let dx = in_picture(along_x);
    let dy = in_picture(along_y);
    let pixel = max(sqrt(dx * dx + dy * dy), vec2<f32>(1e-9));
    // full up to half a pixel beyond the edge: a picture that ends with the domain has no paper along its boundary
    let share = clamp(1.5 - (abs(uv - 0.5) - 0.5) / pixel, vec2<f32>(0.0), vec2<f32>(1.0));
    let colour = textureSampleGrad(picture, picture_sampler, uv, dx, dy).rgb;
    return mix(colour, paper(), view.pattern.placed.w * (1.0 - share.x * share.y));
}
