//! What is in an outline's file where something else should be.

use crate::counted::counted;
use serde_json::Value;

/// The kind of a JSON value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
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

/// What stands where a point `[x, y]` should be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PointFault {
    /// No list.
    #[error("is {0}")]
    NoList(JsonKind),
    /// A list with something else than numbers.
    #[error("has {0} where a number should be")]
    NoNumber(JsonKind),
    /// A list of another length.
    #[error("{}", counted!(*count, "has 1 number", "has {count} numbers"))]
    Numbers {
        /// How long it is.
        count: usize,
    },
}

/// What JSON holds in place of an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum JsonFault {
    /// An object whose points are no list.
    #[error("\"points\" is {0}")]
    Points(JsonKind),
    /// An object of another kind.
    #[error("an object without \"points\"")]
    NoPoints,
    /// No object and no list.
    #[error("{0}")]
    Value(JsonKind),
}

/// What is built otherwise in `GeoJSON` than its type says.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GeoJsonFault {
    /// A member is no list.
    #[error("\"{key}\" is {kind}, not a list")]
    NoList {
        /// Its name.
        key: &'static str,
        /// What it is.
        kind: JsonKind,
    },
    /// A member is missing.
    #[error("\"{0}\" is missing")]
    Missing(&'static str),
    /// A polygon is no list of rings.
    #[error("a polygon is {0}, not a list")]
    Polygon(JsonKind),
    /// A ring is no list of points.
    #[error("a ring is {0}, not a list")]
    Ring(JsonKind),
    /// A type that `GeoJSON` does not have.
    #[error("\"{0}\" is no GeoJSON type")]
    UnknownType(String),
    /// An object without a type.
    #[error("an object has no \"type\"")]
    NoType,
    /// A ring has no points.
    #[error("ring {0} has no points")]
    EmptyRing(usize),
}

/// Why SVG is not read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SvgFault {
    /// What the SVG reader found, with line and column where it knows them.
    #[error("{0}")]
    Reader(String),
    /// Elements within elements, too many of them.
    #[error("elements are nested too deeply")]
    Elements,
    /// Uses of what contains uses, too many of them.
    #[error("\"use\" elements are nested too deeply")]
    Uses,
}
