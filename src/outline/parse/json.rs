//! `[[x, y], …]`, `{"name": …, "points": [[x, y], …]}` and `{"x": […], "y": […]}`; `GeoJSON` is passed to its own
//! reader.

use serde_json::Value;

use super::ring::Ring;
use super::{JsonFault, JsonKind, OutlineError, PartChoice, PointFault, bracketed, geojson, part};
use crate::geometry::DVec2;

/// Reads a list of points, or of `GeoJSON` the feature with the name or number `wanted`, or its largest ring.
pub(super) fn read(text: &str, wanted: Option<PartChoice>) -> Result<Ring, OutlineError> {
    let value: Value = match serde_json::from_str(text) {
        Ok(value) => value,
        Err(error) => {
            let points = bracketed::points(text).filter(|_| wanted.is_none());
            return points.map(Ring::of).ok_or_else(|| syntax_error(&error));
        }
    };
    if let Value::Object(object) = &value
        && !object.contains_key("points")
        && matches!(object.get("type"), Some(Value::String(_)))
    {
        return geojson::read(&value, wanted);
    }
    if let Some(wanted) = wanted {
        return Err(part::single(wanted));
    }
    match &value {
        Value::Array(points) => Ok(Ring::of(read_points(points)?)),
        Value::Object(object) => {
            let name = object.get("name").and_then(Value::as_str).map(str::to_owned);
            let points = match (object.get("points"), object.get("x"), object.get("y")) {
                (Some(Value::Array(points)), ..) => read_points(points)?,
                (Some(other), ..) => {
                    return Err(OutlineError::NotAnOutline { found: JsonFault::Points(JsonKind::of(other)) });
                }
                (None, Some(Value::Array(x)), Some(Value::Array(y))) => from_coordinates(x, y)?,
                (None, ..) => return Err(OutlineError::NotAnOutline { found: JsonFault::NoPoints }),
            };
            Ok(Ring { name, ..Ring::of(points) })
        }
        other => Err(OutlineError::NotAnOutline { found: JsonFault::Value(JsonKind::of(other)) }),
    }
}

/// The points whose coordinates are in two lists.
fn from_coordinates(x: &[Value], y: &[Value]) -> Result<Vec<DVec2>, OutlineError> {
    if x.len() != y.len() {
        return Err(OutlineError::NotAnOutline { found: JsonFault::Lengths { x: x.len(), y: y.len() } });
    }
    let point = |((x, y), point)| of_numbers(x, y).map_err(|found| OutlineError::NotAPoint { point, found });
    x.iter().zip(y).zip(1..).map(point).collect()
}

/// The outer rings of a `GeoJSON` text, or of one feature.
pub(super) fn read_geo_rings(text: &str, part: Option<PartChoice>) -> Result<Vec<geojson::GeoRing>, OutlineError> {
    let value: Value = serde_json::from_str(text).map_err(|e| syntax_error(&e))?;
    geojson::rings(&value, part)
}

fn syntax_error(error: &serde_json::Error) -> OutlineError {
    let (line, column) = (error.line(), error.column());
    let message = error.to_string();
    let message = message.split(" at line ").next().unwrap_or_default().to_owned();
    if message == "number out of range" {
        OutlineError::NumberOutOfRange { line, column }
    } else {
        OutlineError::Json { line, column, message }
    }
}

fn read_points(points: &[Value]) -> Result<Vec<DVec2>, OutlineError> {
    points
        .iter()
        .zip(1..)
        .map(|(value, point)| position(value, false).map_err(|found| OutlineError::NotAPoint { point, found }))
        .collect()
}

/// The point `[x, y]` or `{"x": x, "y": y}`; further numbers are allowed only if `more_allowed`. Otherwise an error that
/// says what was found.
pub(super) fn position(value: &Value, more_allowed: bool) -> Result<DVec2, PointFault> {
    if let Value::Object(object) = value
        && let (Some(x), Some(y)) = (object.get("x").and_then(Value::as_f64), object.get("y").and_then(Value::as_f64))
    {
        return Ok(DVec2::new(x, y));
    }
    let Value::Array(numbers) = value else { return Err(PointFault::NoList(JsonKind::of(value))) };
    match numbers.as_slice() {
        [x, y, rest @ ..] if rest.is_empty() || more_allowed => of_numbers(x, y),
        other => Err(PointFault::Numbers { count: other.len() }),
    }
}

fn of_numbers(x: &Value, y: &Value) -> Result<DVec2, PointFault> {
    match (x.as_f64(), y.as_f64()) {
        (Some(x), Some(y)) => Ok(DVec2::new(x, y)),
        (None, _) => Err(PointFault::NoNumber(JsonKind::of(x))),
        (_, None) => Err(PointFault::NoNumber(JsonKind::of(y))),
    }
}
