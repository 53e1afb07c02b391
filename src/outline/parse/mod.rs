//! Outlines from files: JSON, `GeoJSON`, SVG, well-known text, and tables of numbers.
//!
//! Every reader yields one closed chain of points, which then becomes a
//! [`SimplePolygon`]. Nothing is repaired silently: what was left out or
//! reversed is reported in a note, and what cannot be an outline is an error with its place.
//! No input makes a reader panic, and readers access nothing but the given bytes.

mod bracketed;
mod error;
mod fault;
mod geojson;
mod json;
mod part;
mod point_list;
mod repair;
mod ring;
mod svg;
mod svg_exact;
mod svg_path;
mod svg_shapes;
mod table;
mod well_known_text;

use super::{CurveForm, CurveSource, Outline, OutlineNote, Segment, flattened};
use crate::geometry::{DVec2, SimplePolygon};
use crate::utf16::decoded;
pub use error::OutlineError;
pub use fault::{GeoJsonFault, JsonFault, JsonKind, PointFault, SvgFault};
pub use geojson::GeoRing;
pub use part::{Part, PartChoice, Parts};
use ring::Ring;
use std::borrow::Cow;

/// The largest accepted file size.
pub const MAX_BYTES: usize = 64 << 20;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Json,
    Svg,
    /// The `d` attribute of an SVG path, on its own.
    SvgPathData,
    /// `POLYGON ((…))`.
    WellKnownText,
    /// All points in parentheses.
    Bracketed,
    /// All points on one line.
    PointList,
    Table,
}

/// What is read of a file, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Reading<'a> {
    /// Whether what makes the outline cross or touch itself is mended where one part of it is much larger than the others;
    /// a note says so.
    pub repair: bool,
    /// The shape of an SVG file or the feature of a `GeoJSON` file, by its name or its number from 1; by default the
    /// largest.
    pub part: Option<PartChoice<'a>>,
}

/// What a file gives.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Contents {
    /// The outline that was read.
    pub outline: Outline,
    /// The points of the file in its order: those of a list, or where the segments of a path begin. A point that repeats
    /// another one is among them, but not a last one that repeats the first.
    pub vertices: Vec<DVec2>,
    /// What else could have been read, if there is more than the outline.
    pub parts: Option<Parts>,
}

/// Reads an outline from a file's name and bytes, as [`parse_as`] without repairs.
pub fn parse(file_name: &str, bytes: &[u8]) -> Result<Outline, OutlineError> {
    parse_as(file_name, bytes, &Reading::default())
}

/// Reads an outline from a file's name and bytes.
///
/// The content decides the format, and the outline's name is the one in the file, or else the file's stem.
///
/// - JSON: `[[x, y], …]`, `{"name": …, "points": [[x, y], …]}` or `{"x": […], "y": […]}`;
/// - `GeoJSON`: the outer ring of largest area; holes are left out;
/// - SVG: the shape of the largest painted area, in user space, with y upwards; a background is none. Its lines, arcs
///   and Bézier curves are kept; the polygon is flattened from them;
/// - the data of an SVG path (`M 0 0 L …`) without the rest; well-known text (`POLYGON ((x y, …))`);
/// - tables: two numbers on a line, between them blanks, a tab, a comma or a semicolon, with titles, headers, remarks
///   and a third column (`table`); airfoils as Selig and Lednicer write them;
/// - points on one line, as in an SVG polygon, or in brackets, as programming languages print them.
///
/// Repeated points are dropped, and a last point equal to the first up to rounding is. Files may have up to
/// [`MAX_BYTES`], and outlines up to 200,000 points.
pub fn parse_as(file_name: &str, bytes: &[u8], how: &Reading) -> Result<Outline, OutlineError> {
    parse_contents(file_name, bytes, how).map(|contents| contents.outline)
}

/// As [`parse_as`], with what the file holds besides.
pub fn parse_contents(file_name: &str, bytes: &[u8], how: &Reading) -> Result<Contents, OutlineError> {
    let mut ring = read(bytes, how.part)?;
    let parts = ring.parts.take();
    let vertices =
        if ring.segments.is_empty() { ring.points.clone() } else { ring.segments.iter().map(Segment::start).collect() };
    Ok(Contents { outline: outline(mended(ring, how), stem(file_name))?, vertices, parts })
}

fn mended(mut ring: Ring, how: &Reading) -> Ring {
    ring.drop_repeated_points();
    if how.repair
        && let Some(note) = repair::mend(&mut ring.points)
    {
        // the path has the loops that the points no longer have
        ring.segments.clear();
        ring.notes.push(note);
    }
    ring
}

/// Reads a table of points that are no outline: two numbers on a line, as in a table of [`parse`]. At least one point;
/// their number is limited by [`MAX_BYTES`] only.
pub fn parse_points(bytes: &[u8]) -> Result<Vec<DVec2>, OutlineError> {
    table::points(&text(bytes)?)
}

/// Reads the outer rings of all polygons of a `GeoJSON` file (RFC 7946), or of one feature, in its order and with its
/// numbers: nothing is projected or reversed; holes are counted and left out. With [`Reading::repair`], rings that cross
/// or touch themselves in the plane of longitude and latitude are mended.
pub fn parse_geo_rings(bytes: &[u8], how: &Reading) -> Result<Vec<GeoRing>, OutlineError> {
    let mut rings = json::read_geo_rings(&text(bytes)?, how.part)?;
    if how.repair {
        rings.iter_mut().for_each(GeoRing::mend);
    }
    Ok(rings)
}

/// The file as text, which is not blank: UTF-8, UTF-16, or the Latin-1 of a table whose titles have
/// umlauts. Other bytes are refused.
fn text(bytes: &[u8]) -> Result<Cow<'_, str>, OutlineError> {
    if bytes.len() > MAX_BYTES {
        return Err(OutlineError::TooLarge { bytes: bytes.len() });
    }
    let text = match (decoded(bytes), std::str::from_utf8(bytes)) {
        (Some(text), _) => Cow::Owned(text),
        (None, Ok(text)) => Cow::Borrowed(text.strip_prefix('\u{feff}').unwrap_or(text)),
        (None, Err(_)) if bytes.iter().all(|&b| b >= b' ' && b != 0x7f || b.is_ascii_whitespace()) => {
            Cow::Owned(bytes.iter().map(|&b| char::from(b)).collect())
        }
        (None, Err(error)) => return Err(OutlineError::NotUtf8 { offset: error.valid_up_to() }),
    };
    // lines as on old Macs
    let text = if text.contains('\r') && !text.contains('\n') { Cow::Owned(text.replace('\r', "\n")) } else { text };
    if text.trim().is_empty() { Err(OutlineError::Empty) } else { Ok(text) }
}

fn read(bytes: &[u8], part: Option<PartChoice>) -> Result<Ring, OutlineError> {
    let text = text(bytes)?;
    let text = text.as_ref();
    let format = format_of(text);
    match (format, part) {
        (Format::Json, _) => json::read(text, part),
        (Format::Svg, _) => svg::read(text, part),
        (_, Some(wanted)) => Err(part::single(wanted)),
        (Format::SvgPathData, None) => svg::read_path_data(text),
        (Format::WellKnownText, None) => well_known_text::read(text),
        (Format::Bracketed, None) => bracketed::points(text).map(Ring::of).ok_or(OutlineError::Empty),
        (Format::PointList, None) => point_list::read(text),
        (Format::Table, None) => table::read(text),
    }
}

fn outline(ring: Ring, stem: &str) -> Result<Outline, OutlineError> {
    let Ring { name, points, mut notes, mut segments, .. } = ring;
    let mut polygon = SimplePolygon::try_from(points)?;
    if polygon.was_clockwise() {
        notes.push(OutlineNote::Reversed);
        if !segments.is_empty() {
            // the same points up to rounding, so that the path as it is kept gives the polygon again
            segments = segments.into_iter().rev().map(Segment::reversed).collect();
            polygon = SimplePolygon::try_from(flattened(&segments))?;
        }
    }
    let source = if segments.is_empty() { CurveSource::Points } else { CurveSource::Segments(segments) };
    let name = name.filter(|n| !n.trim().is_empty()).unwrap_or_else(|| stem.to_owned());
    Ok(Outline::new(name, polygon).with_form(CurveForm::of_source(source)).with_notes(notes))
}

/// `leaf` from `some/folder/leaf.json`.
fn stem(file_name: &str) -> &str {
    let base = file_name.rsplit(['/', '\\']).next().unwrap_or(file_name);
    base.rsplit_once('.').map(|(stem, _)| stem).filter(|stem| !stem.is_empty()).unwrap_or(base)
}

/// The format of a text, by its content: names end in anything.
fn format_of(text: &str) -> Format {
    match text.trim_start().chars().next() {
        Some('[' | '{') => Format::Json,
        Some('<') => Format::Svg,
        Some('(') if bracketed::points(text).is_some() => Format::Bracketed,
        Some('M' | 'm') if svg_exact::is_path_data(text) => Format::SvgPathData,
        _ if well_known_text::is_one(text) => Format::WellKnownText,
        _ if point_list::is_one(text) => Format::PointList,
        _ => Format::Table,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, clippy::format_collect, reason = "tests")]
#[path = "tests.rs"]
mod tests;

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod svg_tests;
