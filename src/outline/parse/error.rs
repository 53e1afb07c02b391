//! Why a file is no outline, and where in it.
//!
//! Lines, columns, points and rings count from 1, as people do.

use super::{GeoJsonFault, JsonFault, MAX_BYTES, PointFault, SvgFault};
use crate::counted::counted;
use crate::geometry::{DVec2, PolygonError};

/// Why a file is no outline, and where in it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// More than [`MAX_BYTES`].
    #[error("the file has {bytes} bytes; files up to {} MiB can be read", MAX_BYTES >> 20)]
    TooLarge {
        /// Its size.
        bytes: usize,
    },
    /// Not text in UTF-8.
    #[error("the file is not UTF-8 text: the byte at offset {offset} does not belong there")]
    NotUtf8 {
        /// The first bad byte, from 0.
        offset: usize,
    },
    /// Nothing but blanks and comments.
    #[error("the file is empty")]
    Empty,
    /// Not JSON.
    #[error("this is no valid JSON: {message}, at line {line}, column {column}")]
    Json {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
        /// What the JSON reader found.
        message: String,
    },
    /// A number beyond ±1.8e308, or no finite number.
    #[error("the number at line {line}, column {column} is out of range")]
    NumberOutOfRange {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
    },
    /// Something else where a number was needed.
    #[error("\"{found}\" at line {line}, column {column} is not a number")]
    NotANumber {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
        /// The text there, shortened.
        found: String,
    },
    /// A field without content.
    #[error("a number is missing at line {line}, column {column}")]
    MissingNumber {
        /// The line.
        line: usize,
        /// The column.
        column: usize,
    },
    /// A line of a table without exactly two numbers.
    #[error("{}", counted!(
        *count,
        "line {line} has 1 number; a point is two",
        "line {line} has {count} numbers; a point is two"
    ))]
    NumbersOnLine {
        /// The line.
        line: usize,
        /// How many it has.
        count: usize,
    },
    /// A line of points with a number too many, or too few.
    #[error("{}", counted!(
        *count,
        "this line has 1 number; a point is two",
        "this line has {count} numbers, an odd number; a point is two"
    ))]
    OddNumbers {
        /// How many it has.
        count: usize,
    },
    /// An element of a list of points that is not `[x, y]`.
    #[error("point {point} {found}; a point is [x, y]")]
    NotAPoint {
        /// Which one.
        point: usize,
        /// What it is instead.
        found: PointFault,
    },
    /// JSON of another kind.
    #[error("this JSON holds no outline ({found}): expected [[x, y], …], {{\"points\": [[x, y], …]}} or GeoJSON")]
    NotAnOutline {
        /// What it holds.
        found: JsonFault,
    },
    /// `GeoJSON` without any polygon.
    #[error("this GeoJSON holds no polygon (its type is {})", .kind.as_deref().unwrap_or("not given"))]
    NoPolygon {
        /// Its `type`, if it has one.
        kind: Option<String>,
    },
    /// `GeoJSON` that is not built as its type says.
    #[error("this GeoJSON is malformed: {fault}")]
    GeoJson {
        /// What is wrong.
        fault: GeoJsonFault,
    },
    /// The last point of a ring is not its first.
    #[error("ring {ring} is not closed: it starts at ({}, {}) and ends at ({}, {})", .first.x, .first.y, .last.x, .last.y)]
    RingNotClosed {
        /// Which one.
        ring: usize,
        /// Its first point.
        first: DVec2,
        /// Its last point.
        last: DVec2,
    },
    /// Not SVG, or SVG that is too deep to read.
    #[error("this SVG cannot be read: {fault}")]
    Svg {
        /// What is wrong.
        fault: SvgFault,
    },
    /// SVG without any path or shape.
    #[error("this SVG has no path")]
    NoPath,
    /// SVG with open paths only.
    #[error("no path of this SVG is closed ({paths} open)")]
    NoClosedPath {
        /// How many paths there are.
        paths: usize,
    },
    /// The points are no simple polygon.
    #[error(transparent)]
    Polygon(#[from] PolygonError),
}
