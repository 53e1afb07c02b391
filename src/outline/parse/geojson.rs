//! `GeoJSON` (RFC 7946): the outer ring of largest area among all polygons.
//!
//! Longitude and latitude are taken as plane coordinates, without projection, which a note says where the numbers may be
//! such; altitudes and holes are left out. A `crs` member (RFC 7946 has none, files have it) tells coordinates of other
//! reference systems.

use serde_json::Value;

use super::json::position;
use super::ring::{Ring, area, largest};
use super::{GeoJsonFault, JsonKind, OutlineError, OutlineNote, Part, PartChoice, Parts, part, repair};
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
    /// The number of the feature around each ring, from 0.
    features: Vec<usize>,
    /// The names of all features with a geometry, in the file's order.
    names: Vec<Option<&'a str>>,
}

impl<'a> Collected<'a> {
    fn of(value: &'a Value) -> Result<Self, OutlineError> {
        let mut found = Self::default();
        collect(value, &mut found)?;
        if found.outer_rings.is_empty() {
            return Err(OutlineError::NoPolygon { kind: text(value, "type").map(str::to_owned) });
        }
        Ok(found)
    }

    fn name(&self, ring: usize) -> Option<&'a str> {
        self.names.get(self.features[ring]).copied().flatten()
    }

    /// The rings of the feature with the name or number `wanted`, or all.
    fn rings_of(&self, wanted: Option<PartChoice>) -> Result<Vec<usize>, OutlineError> {
        let feature = wanted.map(|wanted| part::find(wanted, &self.names)).transpose()?;
        let is_wanted = |ring: &usize| feature.is_none_or(|feature| self.features[*ring] == feature);
        let rings: Vec<usize> = (0..self.outer_rings.len()).filter(is_wanted).collect();
        if rings.is_empty() { Err(OutlineError::NoPolygon { kind: Some("Feature".to_owned()) }) } else { Ok(rings) }
    }

    /// The features, each with the picture of its largest ring, of which that around `ring` is read.
    fn parts(&self, ring: usize) -> Option<Parts> {
        let mut largest: Vec<Option<(usize, f64)>> = vec![None; self.names.len()];
        for (k, feature) in self.features.iter().enumerate() {
            let area = area(&self.outer_rings[k]);
            if largest[*feature].is_none_or(|(_, most)| area > most) {
                largest[*feature] = Some((k, area));
            }
        }
        let areas: Vec<f64> = largest.iter().map(|found| found.map_or(0.0, |(_, area)| area)).collect();
        Parts::of(&areas, self.features[ring] + 1, |k| {
            largest[k].map(|(ring, _)| Part::new(k + 1, self.names[k], &self.outer_rings[ring]))
        })
    }
}

/// The outer ring of one polygon of a `GeoJSON` file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct GeoRing {
    /// The name of the feature around it, from its properties or its `id`.
    pub name: Option<String>,
    /// The number of that feature, counted from 1.
    pub feature: usize,
    /// Longitude and latitude as in the file, without the last point, which repeats the first.
    pub points: Vec<DVec2>,
    /// The number of holes of its polygon.
    pub holes: usize,
    /// The number of points that a repair cut off, if it changed the ring.
    pub cut: Option<usize>,
}

impl GeoRing {
    /// A ring without a name and holes.
    pub fn new(points: Vec<DVec2>) -> Self {
        Self { name: None, feature: 1, points, holes: 0, cut: None }
    }

    /// Mends the ring where it crosses or touches itself. A ring around a pole stays as it is.
    pub(super) fn mend(&mut self) {
        // steps of more than half a turn go the other way around
        let turn = |[from, to]: [DVec2; 2]| {
            let step = to.x - from.x;
            if step.abs() > 180.0 { -(step / 360.0).round() } else { 0.0 }
        };
        let count = self.points.len();
        let mut turns = 0.0;
        let mut unrolled = Vec::with_capacity(count);
        for k in 0..count {
            unrolled.push(self.points[k] + DVec2::new(360.0 * turns, 0.0));
            turns += turn([self.points[k], self.points[(k + 1) % count]]);
        }
        if turns != 0.0 {
            return;
        }
        unrolled.dedup();
        if let Some(OutlineNote::Repaired { dropped }) = repair::mend(&mut unrolled) {
            (self.points, self.cut) = (unrolled, Some(dropped.min(count)));
        }
    }

    /// The same ring with a name.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        Self { name: Some(name.to_owned()), ..self }
    }
}

/// The outer rings of all polygons, or of those of one feature, in the file's order; at least one.
pub(super) fn rings(value: &Value, part: Option<PartChoice>) -> Result<Vec<GeoRing>, OutlineError> {
    if let Some(crs) = projected_crs(value) {
        return Err(OutlineError::ReferenceSystem { name: crs });
    }
    let mut found = Collected::of(value)?;
    let rings = found.rings_of(part)?;
    let ring = |k: usize| {
        let name = found.name(k).map(str::to_owned);
        let points = std::mem::take(&mut found.outer_rings[k]);
        GeoRing { name, feature: found.features[k] + 1, points, holes: found.holes[k], cut: None }
    };
    Ok(rings.into_iter().map(ring).collect())
}

pub(super) fn read(value: &Value, part: Option<PartChoice>) -> Result<Ring, OutlineError> {
    let mut found = Collected::of(value)?;
    let rings = found.rings_of(part)?;
    let none = || OutlineError::NoPolygon { kind: text(value, "type").map(str::to_owned) };
    let index = rings[largest(rings.iter().map(|&k| &found.outer_rings[k])).ok_or_else(none)?];
    let parts = found.parts(index);
    let chains: Vec<Vec<DVec2>> = rings.iter().map(|&k| std::mem::take(&mut found.outer_rings[k])).collect();
    let mut ring = Ring { parts, ..Ring::largest_of(chains).ok_or_else(none)? };
    if found.holes[index] > 0 {
        ring.notes.push(OutlineNote::HolesIgnored { holes: found.holes[index] });
    }
    let may_be_degrees = ring.points.iter().all(|p| p.x.abs() <= MOST_LONGITUDE && p.y.abs() <= MOST_LATITUDE);
    if may_be_degrees && projected_crs(value).is_none() {
        ring.notes.push(OutlineNote::Geographic);
    }
    ring.name = found.name(index).map(str::to_owned);
    Ok(ring)
}

/// Codes of the EPSG registry for longitude and latitude on the usual ellipsoids.
const GEOGRAPHIC: [&str; 8] = ["4326", "4979", "4258", "4269", "4267", "4283", "4674", "4490"];

/// The name of the reference system that a file names, if its coordinates are not longitude and latitude.
fn projected_crs(value: &Value) -> Option<String> {
    let crs = value.get("crs").filter(|crs| !crs.is_null())?;
    let properties = crs.get("properties");
    let coded = properties.and_then(|properties| properties.get("code")).map(|code| format!("EPSG:{code}"));
    let name = properties.and_then(|properties| text(properties, "name")).map(str::to_owned).or(coded);
    let Some(name) = name else { return Some(crs.to_string().chars().take(60).collect()) };
    let code = name.rsplit([':', '/', '#']).next().unwrap_or(&name).trim_matches('"').to_ascii_uppercase();
    if code.starts_with("CRS") || code.replace(' ', "") == "WGS84" || GEOGRAPHIC.contains(&code.as_str()) {
        return None;
    }
    Some(if name.to_ascii_uppercase().contains("EPSG") { format!("EPSG:{code}") } else { name })
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

/// Walks features and collections; the nesting is bounded by the JSON reader. What is outside of features is one, without
/// a name.
fn collect<'a>(value: &'a Value, found: &mut Collected<'a>) -> Result<(), OutlineError> {
    match text(value, "type") {
        Some("FeatureCollection") => list(value, "features")?.iter().try_for_each(|feature| collect(feature, found)),
        Some("Feature") => match value.get("geometry") {
            None | Some(Value::Null) => Ok(()),
            Some(geometry) => {
                found.names.push(name(value));
                geometries(geometry, found)
            }
        },
        _ => {
            found.names.push(None);
            geometries(value, found)
        }
    }
}

/// The properties that name a feature, in any case, the most usual ones first.
const NAMES: [&str; 12] = [
    "name",
    "admin",
    "name_en",
    "name_long",
    "gen",
    "name_2",
    "name_1",
    "nom",
    "title",
    "label",
    "state_name",
    "sovereignt",
];

fn name(feature: &Value) -> Option<&str> {
    let properties = feature.get("properties").and_then(Value::as_object);
    let called = |name: &&str| {
        let all = properties.into_iter().flatten();
        all.filter(|(key, _)| key.eq_ignore_ascii_case(name)).find_map(|(_, value)| value.as_str())
    };
    NAMES.iter().find_map(called).or_else(|| text(feature, "id"))
}

fn geometries(value: &Value, found: &mut Collected) -> Result<(), OutlineError> {
    match text(value, "type") {
        Some("GeometryCollection") => list(value, "geometries")?.iter().try_for_each(|g| geometries(g, found)),
        Some("Polygon") => polygon(list(value, "coordinates")?, found),
        Some("MultiPolygon") => list(value, "coordinates")?.iter().try_for_each(|rings| match rings {
            Value::Array(rings) => polygon(rings, found),
            other => Err(OutlineError::GeoJson { fault: GeoJsonFault::Polygon(JsonKind::of(other)) }),
        }),
        Some("Point" | "MultiPoint" | "LineString" | "MultiLineString") => Ok(()),
        Some(other) => Err(OutlineError::GeoJson { fault: GeoJsonFault::UnknownType(other.to_owned()) }),
        None => Err(OutlineError::GeoJson { fault: GeoJsonFault::NoType }),
    }
}

fn polygon(rings: &[Value], found: &mut Collected) -> Result<(), OutlineError> {
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
        (Some(first), Some(last)) if is_closed(first, last) && !points.is_empty() => {}
        (Some(first), Some(last)) => return Err(OutlineError::RingNotClosed { ring, first, last }),
        _ => return Err(OutlineError::GeoJson { fault: GeoJsonFault::EmptyRing(ring) }),
    }
    found.outer_rings.push(points);
    found.holes.push(holes.len());
    found.features.push(found.names.len().saturating_sub(1));
    Ok(())
}

/// Points nearer to each other, relative to their coordinates, are one.
const SAME_POINT: f64 = 1e-9;

/// Whether a ring's last point is its first one: up to rounding, and up to whole turns where the numbers may be longitudes.
fn is_closed(first: DVec2, last: DVec2) -> bool {
    let gap = last - first;
    let size = first.abs().max(last.abs()).max_element();
    let is_turn = gap.x.abs() == 360.0 && first.x.abs() <= MOST_LONGITUDE && first.y.abs() <= MOST_LATITUDE;
    gap.length() <= SAME_POINT * size || (is_turn && gap.y == 0.0)
}
