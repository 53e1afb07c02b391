// The patterns, evaluated from interpolated source coordinates: part of every module that draws a
// textured mesh, which declares a uniform block `view` with a member `pattern` of this type, and the image at
// group 1.
//
// Antialiasing: a pattern is averaged over the pixel's footprint, the gradient
// length of each pattern coordinate, with a box filter in closed form. Where cells
// approach the size of a pixel the pattern fades to its mean color, which
// avoids moiré. Colors are linear.

struct Pattern {
    // xy: texture coordinate → relative to the middle of the source's bounds;
    // z: cells per source unit; w: width of a thin line in pixels
    lookup: vec4<f32>,
    // x: lowest y, y: 1 / height, both relative to that middle; zw: the pole
    source: vec4<f32>,
    // xy: image coordinates per source unit
    image: vec4<f32>,
    // xy: the image's middle relative to that middle; z: the angle by which it is turned; w: 1 with paper around it
    placed: vec4<f32>,
    // sRGB-encoded control points of the hue change, from top to bottom
    hue_top: vec4<f32>,
    hue_middle: vec4<f32>,
    hue_bottom: vec4<f32>,
    // sRGB-encoded
    paper: vec4<f32>,
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

// Pattern units per pixel of each coordinate.
fn footprint(cells: vec2<f32>) -> vec2<f32> {
    let dx = dpdx(cells);
    let dy = dpdy(cells);
    return max(sqrt(dx * dx + dy * dy), vec2<f32>(1e-6));
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

fn checker_pattern(source: vec2<f32>) -> vec3<f32> {
    let cells = source * view.pattern.lookup.z;
    let width = footprint(cells);
    let wave = square_wave(cells, width) * resolved(width);
    let share = 0.5 - 0.5 * wave.x * wave.y;
    return mix(paper(), hue(source), share);
}

// The hue, with lines in the paper's color over it.
fn ruled(source: vec2<f32>, thin: f32, strong: f32) -> vec3<f32> {
    let share = max(0.62 * thin, strong);
    return mix(hue(source), paper(), share);
}

fn grid_pattern(source: vec2<f32>) -> vec3<f32> {
    let cells = source * view.pattern.lookup.z;
    let width = footprint(cells);
    let line = view.pattern.lookup.w;
    let thin = max(line_share(cells.x, width.x, line), line_share(cells.y, width.y, line));
    let strong = max(
        line_share(0.25 * cells.x, 0.25 * width.x, 1.7 * line),
        line_share(0.25 * cells.y, 0.25 * width.y, 1.7 * line),
    );
    return ruled(source, thin, strong);
}

// Circles at whole radii; rays as on polar graph paper: 6, doubled at the radii
// 1, 2, 4, …, so that cells stay between half and one cell wide.
fn polar_pattern(source: vec2<f32>) -> vec3<f32> {
    let p = (source - view.pattern.source.zw) * view.pattern.lookup.z;
    let dx = dpdx(p);
    let dy = dpdy(p);
    let radius = max(length(p), 1e-6);
    let out = p / radius;
    let around = vec2<f32>(-out.y, out.x);
    let line = view.pattern.lookup.w;

    let radial = max(length(vec2<f32>(dot(out, dx), dot(out, dy))), 1e-6);
    let beyond_pole = smoothstep(0.4, 0.6, radius);
    let circle = beyond_pole * line_share(radius, radial, line);
    let strong_circle = smoothstep(1.5, 2.5, radius) * line_share(0.25 * radius, 0.25 * radial, 1.7 * line);

    let turns = atan2(p.y, p.x) * 0.15915494;
    let angular = max(length(vec2<f32>(dot(around, dx), dot(around, dy))) / radius * 0.15915494, 1e-6);
    let rays = 6.0 * exp2(clamp(floor(log2(radius)) + 1.0, 0.0, 6.0));
    let ray = line_share(turns * rays, angular * rays, line);
    let strong_ray = line_share(turns * 6.0, angular * 6.0, 1.7 * line);
    return ruled(source, max(circle, ray), max(strong_circle, strong_ray));
}

// Circles and rays of the unit disk, in log-polar coordinates: the whole numbers of
// −ln|g| · n/2π and arg g · n/2π. The square cells shrink towards the center; lines fade
// where cells are too small to be distinguished, the strong ones at a fourth of the size.
// The boundary, also a circle of the grid, is left out: it has its own stroke, and where
// the domain crowds, all of it is mapped within f32 onto that circle, at a single point.
fn conformal_pattern(source: vec2<f32>) -> vec3<f32> {
    let g = source;
    let dx = dpdx(g);
    let dy = dpdy(g);
    let radius = max(length(g), 1e-6);
    let out = g / radius;
    let around = vec2<f32>(-out.y, out.x);
    let line = view.pattern.lookup.w;
    let per_radian = 0.15915494 * 4.0 * round(1.5 * view.pattern.lookup.z);

    let gradient = per_radian / radius * vec2<f32>(
        length(vec2<f32>(dot(out, dx), dot(out, dy))),
        length(vec2<f32>(dot(around, dx), dot(around, dy))),
    );
    let width = max(gradient, vec2<f32>(1e-6));
    let cells = per_radian * vec2<f32>(-log(radius), atan2(g.y, g.x));
    let seen = vec2<f32>(smoothstep(0.4, 0.6, cells.x), smoothstep(1e-6, 1e-4, gradient.y));
    let thin = seen * vec2<f32>(line_share(cells.x, width.x, line), line_share(cells.y, width.y, line));
    let strong = seen * vec2<f32>(
        line_share(0.25 * cells.x, 0.25 * width.x, 1.7 * line),
        line_share(0.25 * cells.y, 0.25 * width.y, 1.7 * line),
    );
    let size = max(width.x, width.y);
    let fade = 1.0 - smoothstep(vec2<f32>(0.08), vec2<f32>(0.22), vec2<f32>(1.0, 0.25) * size);
    // blue at the boundary, orange at the centre
    let depth = vec2<f32>(0.0, view.pattern.source.x + (1.0 - min(radius, 1.0)) / view.pattern.source.y);
    return ruled(depth, fade.x * max(thin.x, thin.y), fade.y * max(strong.x, strong.y));
}

fn image_pattern(source: vec2<f32>) -> vec3<f32> {
    let from_middle = source - view.pattern.placed.xy;
    let right = vec2<f32>(cos(view.pattern.placed.z), sin(view.pattern.placed.z));
    let turned = vec2<f32>(dot(from_middle, right), dot(from_middle, vec2<f32>(-right.y, right.x)));
    let uv = turned * view.pattern.image.xy * vec2<f32>(1.0, -1.0) + 0.5;
    let dx = dpdx(uv);
    let dy = dpdy(uv);
    let pixel = max(sqrt(dx * dx + dy * dy), vec2<f32>(1e-9));
    // full up to half a pixel beyond the edge: a picture that ends with the domain has no paper along its boundary
    let share = clamp(1.5 - (abs(uv - 0.5) - 0.5) / pixel, vec2<f32>(0.0), vec2<f32>(1.0));
    let colour = textureSample(picture, picture_sampler, uv).rgb;
    return mix(colour, paper(), view.pattern.placed.w * (1.0 - share.x * share.y));
}
