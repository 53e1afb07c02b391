//! The outline of the largest shape in a picture.
//!
//! In a picture with transparent parts the shape is the opaque part; otherwise it is the part whose brightness differs
//! from that of the picture's edge, separated by Otsu's threshold. Marching squares (crate `contour`) with
//! linear interpolation give rings with subpixel accuracy; the ring of largest area is simplified and rounded.

use crate::drawing::{curve_with_corners, simplified_ring};
use crate::geometry::{DVec2, PolygonError, SimplePolygon, sort_by_number};
use crate::language::{Message, key};
use crate::model::names;
use crate::outline::{Outline, OutlineNote};
use contour::ContourBuilder;
use image::RgbaImage;

/// Larger pictures are scaled down before tracing: at a finer resolution edges show the camera's noise.
pub const MAX_SIDE: u32 = 1024;

/// The smallest part of the picture that counts as a shape; smaller ones are specks.
const LEAST_SHARE: f64 = 1e-3;

/// The largest distance of the outline from the ring in pixels: the steps of a picture without antialiasing are half a
/// pixel high.
const TOLERANCE: f64 = 0.75;

/// The largest distance of the polygon from the rounded outline in pixels. The curve turns with every step of the ring,
/// so that a smaller distance would need a thousand points.
const INVISIBLE: f64 = 0.1;

/// The maximal number of points that the outline goes through; a ring that needs more is approximated more coarsely.
const MOST_POINTS: usize = 300;

/// Values that differ by less than this (of 1) count as one color: 5 of 255 steps.
const LEAST_CONTRAST: f64 = 0.02;

/// Why a picture has no outline.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceError {
    /// All pixels have one color.
    #[error("the whole picture has one color: there is no shape to trace")]
    OneColor,
    /// There are only specks.
    #[error("no shape was found in the picture: the largest one takes less than a thousandth of it")]
    NoShape,
    /// The ring is not a valid outline.
    #[error(transparent)]
    Outline(#[from] PolygonError),
}

impl From<&TraceError> for Message {
    fn from(error: &TraceError) -> Self {
        match error {
            TraceError::OneColor => key::trace_one_colour().into(),
            TraceError::NoShape => key::trace_no_shape().into(),
            TraceError::Outline(error) => error.into(),
        }
    }
}

/// The outline of the largest shape, in pixels, y up.
pub fn trace(name: &str, picture: &RgbaImage) -> Result<Outline, TraceError> {
    let (values, threshold) = strengths(picture)?;
    let mut rings = rings(&values, picture.dimensions(), threshold);
    sort_by_number(&mut rings, |ring| -area(ring));
    let whole = f64::from(picture.width()) * f64::from(picture.height());
    let count = rings.iter().filter(|ring| area(ring) >= LEAST_SHARE * whole).count();
    let ring = rings.into_iter().next().filter(|_| count > 0).ok_or(TraceError::NoShape)?;
    let notes = if count > 1 { vec![OutlineNote::LargestOf { rings: count }] } else { Vec::new() };
    let name = if name.is_empty() { String::from(names::TRACED) } else { name.to_owned() };
    Ok(Outline::new(name, simplified(&ring)?).with_notes(notes))
}

/// For each pixel how strongly it belongs to the shape, from 0 to 1, and the threshold from which it does.
fn strengths(picture: &RgbaImage) -> Result<(Vec<f64>, f64), TraceError> {
    let alpha: Vec<f64> = picture.pixels().map(|pixel| f64::from(pixel[3]) / 255.0).collect();
    if contrast(&alpha) > 0.5 {
        return Ok((alpha, 0.5));
    }
    // the luminance of Rec. 709
    let brightness =
        |[r, g, b, _]: [u8; 4]| (0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)) / 255.0;
    let mut values: Vec<f64> = picture.pixels().map(|pixel| brightness(pixel.0)).collect();
    if contrast(&values) < LEAST_CONTRAST {
        return Err(TraceError::OneColor);
    }
    let mut threshold = otsu(&values);
    if is_bright_at_the_edge(&values, picture.width() as usize, threshold) {
        for value in &mut values {
            *value = 1.0 - *value;
        }
        threshold = 1.0 - threshold;
    }
    Ok((values, threshold))
}

fn contrast(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &v| (l.min(v), h.max(v)));
    high - low
}

/// Whether most of the pixels at the picture's edge are brighter than `threshold`.
fn is_bright_at_the_edge(values: &[f64], width: usize, threshold: f64) -> bool {
    let rows = values.chunks_exact(width.max(1));
    let last = rows.len().saturating_sub(1);
    let (mut bright, mut all) = (0, 0);
    for (k, row) in rows.enumerate() {
        let step = if k == 0 || k == last { 1 } else { (width - 1).max(1) };
        for value in row.iter().step_by(step) {
            all += 1;
            bright += usize::from(*value > threshold);
        }
    }
    2 * bright > all
}

/// Otsu's threshold (1979), which maximizes the variance between the two classes. If there is an empty
/// part of the histogram between them, the threshold is its middle.
fn otsu(values: &[f64]) -> f64 {
    let mut histogram = [0.0; 256];
    for value in values {
        histogram[(255.0 * value).round() as usize] += 1.0;
    }
    let total = values.len() as f64;
    let sum: f64 = (0..256_u32).map(|k| f64::from(k) * histogram[k as usize]).sum();
    let (mut below, mut below_sum) = (0.0, 0.0);
    let mut best = (0.0, [0, 0]);
    for (k, count) in histogram.iter().enumerate().take(255) {
        below += count;
        below_sum += k as f64 * count;
        let above = total - below;
        if below == 0.0 || above == 0.0 {
            continue;
        }
        let difference = below_sum / below - (sum - below_sum) / above;
        let variance = below * above * difference * difference;
        if variance > best.0 {
            best = (variance, [k, k]);
        } else if variance == best.0 {
            best.1[1] = k;
        }
    }
    (0.5 * (best.1[0] + best.1[1]) as f64 + 0.5) / 255.0
}

/// The level lines at `threshold`, y up. The picture is framed by zeros, so that all lines are closed.
fn rings(values: &[f64], (width, height): (u32, u32), threshold: f64) -> Vec<Vec<DVec2>> {
    let (w, h) = (width as usize, height as usize);
    let mut framed = vec![0.0; (w + 2) * (h + 2)];
    for (row, line) in values.chunks_exact(w.max(1)).enumerate() {
        let start = (row + 1) * (w + 2) + 1;
        framed[start..start + w].copy_from_slice(line);
    }
    // the frame has exactly the size given to the builder
    let lines = ContourBuilder::new(w + 2, h + 2, true).lines(&framed, &[threshold]).unwrap_or_default();
    let places = lines.iter().flat_map(contour::Line::geometry).map(|ring| ring.coords().map(|p| (p.x, p.y)));
    places.map(|ring| closed(&ring.collect::<Vec<_>>(), f64::from(height))).collect()
}

/// A ring without its repeated last point.
fn closed(ring: &[(f64, f64)], height: f64) -> Vec<DVec2> {
    // the frame shifts by one; the builder places pixel k at k + ½
    let mut points: Vec<DVec2> = ring.iter().map(|&(x, y)| DVec2::new(x - 1.0, height - (y - 1.0))).collect();
    points.dedup();
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    points
}

fn area(ring: &[DVec2]) -> f64 {
    let Some(&origin) = ring.first() else { return 0.0 };
    let next = ring.iter().cycle().skip(1);
    0.5 * ring.iter().zip(next).map(|(&a, &b)| (a - origin).perp_dot(b - origin)).sum::<f64>().abs()
}

/// The outline of a ring: a curve with corners through few of its points, or the ring itself if the curve crosses
/// itself.
fn simplified(ring: &[DVec2]) -> Result<SimplePolygon, PolygonError> {
    let mut tolerance = TOLERANCE;
    let mut points = at(ring, &simplified_ring(ring, tolerance));
    while points.len() > MOST_POINTS {
        tolerance *= 1.25;
        points = at(ring, &simplified_ring(ring, tolerance));
    }
    let curve = curve_with_corners(&points);
    SimplePolygon::try_from(at(&curve, &simplified_ring(&curve, INVISIBLE)))
        .or_else(|_| SimplePolygon::try_from(points))
        .or_else(|_| SimplePolygon::try_from(ring.to_vec()))
}

fn at(ring: &[DVec2], kept: &[usize]) -> Vec<DVec2> {
    kept.iter().map(|&k| ring[k]).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use image::Rgba;

    const WHITE: Rgba<u8> = Rgba([255, 255, 255, 255]);
    const INK: Rgba<u8> = Rgba([30, 40, 60, 255]);

    /// A picture of the set `inside`, 200 by 160 pixels with three pixels per unit, without antialiasing.
    fn picture(colours: [Rgba<u8>; 2], inside: impl Fn(f64, f64) -> bool) -> RgbaImage {
        let place = |pixel: u32| (f64::from(pixel) + 0.5) / 3.0;
        RgbaImage::from_fn(600, 480, |x, y| colours[usize::from(inside(place(x), place(y)))])
    }

    fn is_in_disk(x: f64, y: f64) -> bool {
        (x - 90.0).hypot(y - 60.0) < 50.0
    }

    fn assert_is_disk(outline: &Outline) {
        let area = outline.polygon().area();
        let expected = std::f64::consts::PI * 150.0 * 150.0;
        assert!((area / expected - 1.0).abs() < 0.01, "{area}, expected {expected}");
        let bounds = outline.polygon().bounds();
        assert!(bounds.center().distance(DVec2::new(270.0, 300.0)) < 1.0, "y upwards: {}", bounds.center());
        assert!(outline.polygon().vertices().len() < 400, "{}", outline.polygon().vertices().len());
    }

    #[test]
    fn a_disk_is_traced_within_a_per_cent_whether_dark_bright_or_on_nothing() {
        for colours in [[WHITE, INK], [INK, WHITE], [Rgba([0; 4]), INK], [Rgba([0; 4]), Rgba([0, 0, 0, 255])]] {
            let outline = trace("disk", &picture(colours, is_in_disk)).unwrap();
            assert_is_disk(&outline);
            assert!(outline.notes().is_empty() && outline.name() == "disk");
        }
    }

    #[test]
    fn a_soft_edge_is_where_it_is_half_transparent_whatever_color_the_ground_has() {
        for ground in [[0, 0, 0], [255, 255, 255]] {
            let picture = RgbaImage::from_fn(600, 480, |x, y| {
                let within = 150.0 - (f64::from(x) + 0.5 - 270.0).hypot(f64::from(y) + 0.5 - 180.0);
                let share = (0.5 + within / 8.0).clamp(0.0, 1.0);
                let [red, green, blue] = if share > 0.0 { [30, 40, 60] } else { ground };
                Rgba([red, green, blue, (255.0 * share).round() as u8])
            });
            assert_is_disk(&trace("disk", &picture).unwrap());
        }
    }

    #[test]
    fn of_several_shapes_the_largest_is_taken_without_its_holes() {
        let speck = |x: f64, y: f64| (x - 180.0).hypot(y - 140.0) < 9.0;
        let hole = |x: f64, y: f64| (x - 90.0).hypot(y - 60.0) < 20.0;
        let outline =
            trace("", &picture([WHITE, INK], |x, y| (is_in_disk(x, y) && !hole(x, y)) || speck(x, y))).unwrap();
        assert_is_disk(&outline);
        assert_eq!(outline.notes(), [OutlineNote::LargestOf { rings: 3 }]);
        assert_eq!(outline.name(), "Traced");
    }

    #[test]
    fn a_square_keeps_its_corners_also_at_the_edge_of_the_picture() {
        let outline = trace("square", &picture([WHITE, INK], |x, y| x < 80.0 && y > 60.0)).unwrap();
        let polygon = outline.polygon();
        assert!((polygon.area() / 72_000.0 - 1.0).abs() < 0.01, "{}", polygon.area());
        for corner in [(0.0, 0.0), (240.0, 0.0), (240.0, 300.0), (0.0, 300.0)].map(DVec2::from) {
            let nearest = polygon.vertices().iter().map(|p| p.distance(corner)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1.5, "{corner}: {nearest}");
        }
    }

    #[test]
    fn one_color_and_specks_are_no_shapes() {
        assert_eq!(trace("", &picture([WHITE, WHITE], is_in_disk)), Err(TraceError::OneColor));
        let speck = |x: f64, y: f64| (x - 90.0).hypot(y - 60.0) < 2.0;
        assert_eq!(trace("", &picture([WHITE, INK], speck)), Err(TraceError::NoShape));
        assert_eq!(trace("", &RgbaImage::new(0, 0)), Err(TraceError::OneColor));
    }
}
