//! What an outline's file contains where something else is required.

use crate::counted::counted;
use serde_json::Value;

/// The kind of a JSON value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JsonKind {
    /// `null`.
    #[error("null")]
    Null,
    /// `true` or `false`.
    #[error("a truth value")]
    TruthValue,
    /// A number.
    #[error("a number")]
    Number,
    /// A string.
    #[error("a text")]
    Text,
    /// An array.
    #[error("a list")]
    List,
    /// An object.
    #[error("an object")]
    Object,
}

impl JsonKind {
    pub(super) fn of(value: &Value) -> Self {
        match value {
            Value::Null => Self::Null,
            Value::Bool(_) => Self::TruthValue,
            Value::Number(_) => Self::Number,
            Value::String(_) => Self::Text,
            Value::Array(_) => Self::List,
            Value::Object(_) => Self::Object,
        }
    }
}

/// What was found where a point `[x, y]` is required.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PointFault {
    /// The value is not a list.
    #[error("is {0}")]
    NoList(JsonKind),
    /// The list contains something other than numbers.
    #[error("has {0} where a number should be")]
    NoNumber(JsonKind),
    /// The list has the wrong length.
    #[error("{}", counted!(*count, "has 1 number", "has {count} numbers"))]
    Numbers {
        /// Length of the list.
        count: usize,
    },
}

/// What a JSON file holds instead of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum JsonFault {
    /// The object's `points` is not a list.
    #[error("\"points\" is {0}")]
    Points(JsonKind),
    /// An object without `points`.
    #[error("an object without \"points\"")]
    NoPoints,
    /// The lists of coordinates have different lengths.
    #[error("{x} numbers in \"x\" and {y} in \"y\"")]
    Lengths {
        /// Length of the list `x`.
        x: usize,
        /// Length of the list `y`.
        y: usize,
    },
    /// Neither an object nor a list.
    #[error("{0}")]
    Value(JsonKind),
}

/// A structural error in `GeoJSON`.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GeoJsonFault {
    /// A member is not a list.
    #[error("\"{key}\" is {kind}, not a list")]
    NoList {
        /// Name of the member.
        key: &'static str,
        /// Kind of its value.
        kind: JsonKind,
    },
    /// A member is missing.
    #[error("\"{0}\" is missing")]
    Missing(&'static str),
    /// A polygon is not a list of rings.
    #[error("a polygon is {0}, not a list")]
    Polygon(JsonKind),
    /// A ring is not a list of points.
    #[error("a ring is {0}, not a list")]
    Ring(JsonKind),
    /// The type is not one of `GeoJSON`.
    #[error("\"{0}\" is no GeoJSON type")]
    UnknownType(String),
    /// An object without a type.
    #[error("an object has no \"type\"")]
    NoType,
    /// A ring has no points.
    #[error("ring {0} has no points")]
    EmptyRing(usize),
}

/// Why an SVG file was not read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SvgFault {
    /// The SVG reader's message, with line and column if it knows them.
    #[error("{0}")]
    Reader(String),
    /// The elements are nested too deeply.
    #[error("elements are nested too deeply")]
    Elements,
    /// The `use` references are nested too deeply.
    #[error("\"use\" elements are nested too deeply")]
    Uses,
}
