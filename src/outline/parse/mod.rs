//! Outlines from files: JSON, `GeoJSON`, SVG, and tables of numbers.
//!
//! Every reader yields one closed chain of points, which then becomes a
//! [`SimplePolygon`]. Nothing is repaired silently: what was left out or
//! reversed is reported in a note, and what cannot be an outline is an error with its place.
//! No input makes a reader panic, and readers access nothing but the given bytes.

mod error;
mod fault;
mod geojson;
mod json;
mod point_list;
mod repair;
mod ring;
mod svg;
mod svg_exact;
mod svg_path;
mod table;

use super::{CurveForm, CurveSource, Outline, OutlineNote, Segment, flattened};
use crate::geometry::{DVec2, SimplePolygon};
pub use error::OutlineError;
pub use fault::{GeoJsonFault, JsonFault, JsonKind, PointFault, SvgFault};
pub use geojson::GeoRing;
use ring::Ring;

/// The largest accepted file size.
pub const MAX_BYTES: usize = 64 << 20;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Json,
    Svg,
    /// The `d` attribute of an SVG path, on its own.
    SvgPathData,
    /// All points on one line.
    PointList,
    Table,
}

/// Reads an outline from a file's name and bytes.
///
/// The extension decides the format (`json`, `geojson`, `svg`, `csv`, `tsv`);
/// with any other, the first character does. The outline's name is the one in
/// the file, or else the file's stem.
///
/// - JSON: `[[x, y], …]` or `{"name": …, "points": [[x, y], …]}`;
/// - `GeoJSON`: the outer ring of largest area; holes are left out;
/// - SVG: the first closed path in document order, transformed, with y upwards; of several closed subpaths the
///   largest. Its lines, arcs and Bézier curves are kept; the polygon is flattened from them;
/// - tables: two numbers on a line, between them spaces, a tab, a comma or a
///   semicolon; `#` begins a comment; the first line may be a header;
/// - with any other extension or none, also the data of an SVG path (`M 0 0 L …`), and points on one
///   line, as in an SVG polygon.
///
/// A last point equal to the first is dropped. Files may have up to
/// [`MAX_BYTES`], and outlines up to 200,000 points.
pub fn parse(file_name: &str, bytes: &[u8]) -> Result<Outline, OutlineError> {
    let ring = read(file_name, bytes)?;
    outline(ring, stem_and_extension(file_name).0)
}

/// Like [`parse`], but where the outline touches itself in a vertex or folds back, the smaller part is
/// removed and a note says so; crossings stay errors.
pub fn parse_repaired(file_name: &str, bytes: &[u8]) -> Result<Outline, OutlineError> {
    let mut ring = read(file_name, bytes)?;
    let dropped = repair::cut_loops_and_spikes(&mut ring.points);
    if dropped > 0 {
        // the path has the loops that the points no longer have
        ring.segments.clear();
        ring.notes.push(OutlineNote::Repaired { dropped });
    }
    outline(ring, stem_and_extension(file_name).0)
}

/// Reads a table of points that are no outline: two numbers on a line, as in a table of [`parse`]. At least one point;
/// their number is limited by [`MAX_BYTES`] only.
pub fn parse_points(bytes: &[u8]) -> Result<Vec<DVec2>, OutlineError> {
    table::points(text(bytes)?)
}

/// Reads the outer rings of all polygons of a `GeoJSON` file (RFC 7946), in its order and with its numbers: nothing is
/// projected, closed, reversed or checked but the structure. Holes are counted and left out.
pub fn parse_geo_rings(bytes: &[u8]) -> Result<Vec<GeoRing>, OutlineError> {
    json::read_geo_rings(text(bytes)?)
}

/// The file as text, which is not blank.
fn text(bytes: &[u8]) -> Result<&str, OutlineError> {
    if bytes.len() > MAX_BYTES {
        return Err(OutlineError::TooLarge { bytes: bytes.len() });
    }
    let text = std::str::from_utf8(bytes).map_err(|e| OutlineError::NotUtf8 { offset: e.valid_up_to() })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() { Err(OutlineError::Empty) } else { Ok(text) }
}

fn read(file_name: &str, bytes: &[u8]) -> Result<Ring, OutlineError> {
    let text = text(bytes)?;
    match format_of(stem_and_extension(file_name).1, text) {
        Format::Json => json::read(text),
        Format::Svg => svg::read(text),
        Format::SvgPathData => svg::read_path_data(text),
        Format::PointList => point_list::read(text),
        Format::Table => table::read(text),
    }
}

fn outline(ring: Ring, stem: &str) -> Result<Outline, OutlineError> {
    let Ring { name, points, mut notes, mut segments } = ring;
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

/// `("leaf", "json")` from `some/folder/leaf.json`.
fn stem_and_extension(file_name: &str) -> (&str, &str) {
    let base = file_name.rsplit(['/', '\\']).next().unwrap_or(file_name);
    match base.rsplit_once('.') {
        Some((stem, extension)) if !stem.is_empty() => (stem, extension),
        _ => (base, ""),
    }
}

fn format_of(extension: &str, text: &str) -> Format {
    match extension.to_ascii_lowercase().as_str() {
        "json" | "geojson" => Format::Json,
        "svg" => Format::Svg,
        "csv" | "tsv" => Format::Table,
        _ => match text.trim_start().chars().next() {
            Some('[' | '{') => Format::Json,
            Some('<') => Format::Svg,
            Some('M' | 'm') if text.chars().all(|c| "MmLlHhVvCcSsQqTtAaZz0123456789eE+-., \t\r\n".contains(c)) => {
                Format::SvgPathData
            }
            _ if point_list::is_one(text) => Format::PointList,
            _ => Format::Table,
        },
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, clippy::format_collect, reason = "tests")]
#[path = "tests.rs"]
mod tests;

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod svg_tests;
