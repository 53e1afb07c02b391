//! `GeoJSON` (RFC 7946): the outer ring of largest area among all polygons.
//!
//! Longitude and latitude are taken as plane coordinates, without projection, which a note says where the numbers may be
//! such; altitudes and holes are left out.

use serde_json::Value;

use super::json::position;
use super::ring::{Ring, largest};
use super::{GeoJsonFault, JsonKind, OutlineError, OutlineNote};
use crate::geometry::DVec2;

/// The largest longitude, of regions beyond the antimeridian, and latitude, in degrees.
const MOST_LONGITUDE: f64 = 360.0;
const MOST_LATITUDE: f64 = 90.0;

/// The polygons collected while walking the tree.
#[derive(Debug, Default)]
struct Collected<'a> {
    outer_rings: Vec<Vec<DVec2>>,
    /// Number of holes in each ring's polygon.
    holes: Vec<usize>,
    /// The `properties.name` of the feature around each ring.
    names: Vec<Option<&'a str>>,
}

/// The outer ring of one polygon of a `GeoJSON` file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GeoRing {
    /// The `properties.name` of the feature around it.
    pub name: Option<String>,
    /// Longitude and latitude as in the file, without the last point, which repeats the first.
    pub points: Vec<DVec2>,
    /// The number of holes of its polygon.
    pub holes: usize,
}

impl GeoRing {
    /// A ring without a name and holes.
    pub fn new(points: Vec<DVec2>) -> Self {
        Self { name: None, points, holes: 0 }
    }

    /// The same ring with a name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        Self { name: Some(name.to_owned()), ..self }
    }
}

/// The outer rings of all polygons, in the file's order; at least one.
pub(super) fn rings(value: &Value) -> Result<Vec<GeoRing>, OutlineError> {
    let mut found = Collected::default();
    collect(value, None, &mut found)?;
    if found.outer_rings.is_empty() {
        return Err(OutlineError::NoPolygon { kind: text(value, "type").map(str::to_owned) });
    }
    let of = found.outer_rings.into_iter().zip(found.holes).zip(found.names);
    Ok(of.map(|((points, holes), name)| GeoRing { name: name.map(str::to_owned), points, holes }).collect())
}

pub(super) fn read(value: &Value) -> Result<Ring, OutlineError> {
    let mut found = Collected::default();
    collect(value, None, &mut found)?;
    let Collected { outer_rings, holes, names } = found;
    let none = || OutlineError::NoPolygon { kind: text(value, "type").map(str::to_owned) };
    let index = largest(&outer_rings).ok_or_else(none)?;
    let mut ring = Ring::largest_of(outer_rings).ok_or_else(none)?;
    if holes[index] > 0 {
        ring.notes.push(OutlineNote::HolesIgnored { holes: holes[index] });
    }
    if ring.points.iter().all(|p| p.x.abs() <= MOST_LONGITUDE && p.y.abs() <= MOST_LATITUDE) {
        ring.notes.push(OutlineNote::Geographic);
    }
    ring.name = names[index].map(str::to_owned);
    Ok(ring)
}

fn text<'a>(value: &'a Value, key: &str) -> Option<&'a str> {
    value.get(key).and_then(Value::as_str)
}

fn list<'a>(value: &'a Value, key: &'static str) -> Result<&'a [Value], OutlineError> {
    let fault = match value.get(key) {
        Some(Value::Array(list)) => return Ok(list),
        Some(other) => GeoJsonFault::NoList { key, kind: JsonKind::of(other) },
        None => GeoJsonFault::Missing(key),
    };
    Err(OutlineError::GeoJson { fault })
}

/// Walks features and collections; the nesting is bounded by the JSON reader.
fn collect<'a>(value: &'a Value, name: Option<&'a str>, found: &mut Collected<'a>) -> Result<(), OutlineError> {
    match text(value, "type") {
        Some("FeatureCollection") => list(value, "features")?.iter().try_for_each(|f| collect(f, name, found)),
        Some("GeometryCollection") => list(value, "geometries")?.iter().try_for_each(|g| collect(g, name, found)),
        Some("Feature") => match value.get("geometry") {
            None | Some(Value::Null) => Ok(()),
            Some(geometry) => {
                let own = value.get("properties").and_then(|p| text(p, "name").or_else(|| text(p, "NAME")));
                collect(geometry, own.or(name), found)
            }
        },
        Some("Polygon") => polygon(list(value, "coordinates")?, name, found),
        Some("MultiPolygon") => list(value, "coordinates")?.iter().try_for_each(|rings| match rings {
            Value::Array(rings) => polygon(rings, name, found),
            other => Err(OutlineError::GeoJson { fault: GeoJsonFault::Polygon(JsonKind::of(other)) }),
        }),
        Some("Point" | "MultiPoint" | "LineString" | "MultiLineString") => Ok(()),
        Some(other) => Err(OutlineError::GeoJson { fault: GeoJsonFault::UnknownType(other.to_owned()) }),
        None => Err(OutlineError::GeoJson { fault: GeoJsonFault::NoType }),
    }
}

fn polygon<'a>(rings: &'a [Value], name: Option<&'a str>, found: &mut Collected<'a>) -> Result<(), OutlineError> {
    let Some((outer, holes)) = rings.split_first() else { return Ok(()) };
    let Value::Array(positions) = outer else {
        return Err(OutlineError::GeoJson { fault: GeoJsonFault::Ring(JsonKind::of(outer)) });
    };
    let ring = found.outer_rings.len() + 1;
    let mut points = Vec::with_capacity(positions.len());
    for (value, point) in positions.iter().zip(1..) {
        points.push(position(value, true).map_err(|found| OutlineError::NotAPoint { point, found })?);
    }
    match (points.first().copied(), points.pop()) {
        (Some(first), Some(last)) if first == last && !points.is_empty() => {}
        (Some(first), Some(last)) => return Err(OutlineError::RingNotClosed { ring, first, last }),
        _ => return Err(OutlineError::GeoJson { fault: GeoJsonFault::EmptyRing(ring) }),
    }
    found.outer_rings.push(points);
    found.holes.push(holes.len());
    found.names.push(name);
    Ok(())
}
