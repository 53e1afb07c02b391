//! `[[x, y], …]` and `{"name": …, "points": [[x, y], …]}`; `GeoJSON` is passed to its own reader.

use serde_json::Value;

use super::ring::Ring;
use super::{JsonFault, JsonKind, OutlineError, PointFault, geojson};
use crate::geometry::DVec2;

pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    let value: Value = serde_json::from_str(text).map_err(|e| syntax_error(&e))?;
    match &value {
        Value::Array(points) => Ok(Ring::implicitly_closed(read_points(points)?)),
        Value::Object(object) => match (object.get("points"), object.get("type")) {
            (Some(Value::Array(points)), _) => {
                let name = object.get("name").and_then(Value::as_str).map(str::to_owned);
                Ok(Ring { name, ..Ring::implicitly_closed(read_points(points)?) })
            }
            (Some(other), _) => Err(OutlineError::NotAnOutline { found: JsonFault::Points(JsonKind::of(other)) }),
            (None, Some(Value::String(_))) => geojson::read(&value),
            (None, _) => Err(OutlineError::NotAnOutline { found: JsonFault::NoPoints }),
        },
        other => Err(OutlineError::NotAnOutline { found: JsonFault::Value(JsonKind::of(other)) }),
    }
}

/// The outer rings of a `GeoJSON` text.
pub(super) fn read_geo_rings(text: &str) -> Result<Vec<geojson::GeoRing>, OutlineError> {
    let value: Value = serde_json::from_str(text).map_err(|e| syntax_error(&e))?;
    geojson::rings(&value)
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

/// The point `[x, y]`; further numbers are allowed only if `more_allowed`. Otherwise an error that says what was found.
pub(super) fn position(value: &Value, more_allowed: bool) -> Result<DVec2, PointFault> {
    let Value::Array(numbers) = value else { return Err(PointFault::NoList(JsonKind::of(value))) };
    match numbers.as_slice() {
        [x, y, rest @ ..] if rest.is_empty() || more_allowed => match (x.as_f64(), y.as_f64()) {
            (Some(x), Some(y)) => Ok(DVec2::new(x, y)),
            (None, _) => Err(PointFault::NoNumber(JsonKind::of(x))),
            (_, None) => Err(PointFault::NoNumber(JsonKind::of(y))),
        },
        other => Err(PointFault::Numbers { count: other.len() }),
    }
}
