//! Why a file is not an outline, and where in the file.
//!
//! Lines, columns, points and rings are counted from 1.

use super::{GeoJsonFault, JsonFault, MAX_BYTES, PointFault, SvgFault};
use crate::counted::counted;
use crate::geometry::{DVec2, PolygonError};

/// Why a file is not an outline, and where in the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// The file is larger than [`MAX_BYTES`].
    #[error("the file has {bytes} bytes; files up to {} MiB can be read", MAX_BYTES >> 20)]
    TooLarge {
        /// Size of the file.
        bytes: usize,
    },
    /// The file is not UTF-8 text.
    #[error("the file is not UTF-8 text: the byte at offset {offset} does not belong there")]
    NotUtf8 {
        /// Offset of the first invalid byte, from 0.
        offset: usize,
    },
    /// The file holds nothing but blanks and comments.
    #[error("the file is empty")]
    Empty,
    /// The file is not valid JSON.
    #[error("this is no valid JSON: {message}, at line {line}, column {column}")]
    Json {
        /// Line of the error.
        line: usize,
        /// Column of the error.
        column: usize,
        /// The JSON reader's message.
        message: String,
    },
    /// A number beyond ±1.8e308, or NaN or infinity.
    #[error("the number at line {line}, column {column} is out of range")]
    NumberOutOfRange {
        /// Line of the number.
        line: usize,
        /// Column of the number.
        column: usize,
    },
    /// The text where a number was expected is not one.
    #[error("\"{found}\" at line {line}, column {column} is not a number")]
    NotANumber {
        /// Line of the text.
        line: usize,
        /// Column of the text.
        column: usize,
        /// The text there, shortened.
        found: String,
    },
    /// A field is empty.
    #[error("a number is missing at line {line}, column {column}")]
    MissingNumber {
        /// Line of the field.
        line: usize,
        /// Column of the field.
        column: usize,
    },
    /// A line of a table without exactly two numbers.
    #[error("{}", counted!(
        *count,
        "line {line} has 1 number; a point is two",
        "line {line} has {count} numbers; a point is two"
    ))]
    NumbersOnLine {
        /// Number of the line.
        line: usize,
        /// How many numbers the line has.
        count: usize,
    },
    /// A line of a table that is neither a row of numbers nor a title or a remark.
    #[error("line {line} is not understood: \"{text}\"")]
    NotUnderstood {
        /// Number of the line.
        line: usize,
        /// Its text, shortened.
        text: String,
    },
    /// A list of points on one line has an odd number of numbers.
    #[error("{}", counted!(
        *count,
        "this line has 1 number; a point is two",
        "this line has {count} numbers, an odd number; a point is two"
    ))]
    OddNumbers {
        /// How many numbers the line has.
        count: usize,
    },
    /// An element of a list of points that is not `[x, y]`.
    #[error("point {point} {found}; a point is [x, y]")]
    NotAPoint {
        /// Number of the element.
        point: usize,
        /// What was found instead.
        found: PointFault,
    },
    /// Valid JSON that holds no outline.
    #[error("this JSON holds no outline ({found}): expected [[x, y], …], {{\"points\": [[x, y], …]}} or GeoJSON")]
    NotAnOutline {
        /// What the JSON holds.
        found: JsonFault,
    },
    /// `GeoJSON` without a polygon.
    #[error("this GeoJSON holds no polygon (its type is {})", .kind.as_deref().unwrap_or("not given"))]
    NoPolygon {
        /// Its `type`, if it has one.
        kind: Option<String>,
    },
    /// `GeoJSON` whose structure does not agree with its type.
    #[error("this GeoJSON is malformed: {fault}")]
    GeoJson {
        /// The structural error.
        fault: GeoJsonFault,
    },
    /// The last point of a ring is not its first.
    #[error("ring {ring} is not closed: it starts at ({}, {}) and ends at ({}, {})", .first.x, .first.y, .last.x, .last.y)]
    RingNotClosed {
        /// Number of the ring.
        ring: usize,
        /// The ring's first point.
        first: DVec2,
        /// The ring's last point.
        last: DVec2,
    },
    /// `GeoJSON` whose coordinates are not longitude and latitude although these are needed.
    #[error("the coordinates are in {name}: convert them to longitude and latitude (EPSG:4326)")]
    ReferenceSystem {
        /// Name of the reference system.
        name: String,
    },
    /// There is no shape or feature of this name or number.
    #[error("{}", no_such_part(wanted, *count, names))]
    NoSuchPart {
        /// What was asked for.
        wanted: String,
        /// How many there are.
        count: usize,
        /// The names of those that have one, in a row, shortened.
        names: String,
    },
    /// Invalid SVG, or SVG that is nested too deeply.
    #[error("this SVG cannot be read: {fault}")]
    Svg {
        /// The reader's error, or the limit exceeded.
        fault: SvgFault,
    },
    /// SVG without any path or shape.
    #[error("this SVG has no path: convert texts to paths")]
    NoPath,
    /// SVG with open paths only.
    #[error("no path of this SVG is closed ({paths} open)")]
    NoClosedPath {
        /// Number of open paths.
        paths: usize,
    },
    /// The points do not form a simple polygon.
    #[error(transparent)]
    Polygon(#[from] PolygonError),
}

fn no_such_part(wanted: &str, count: usize, names: &str) -> String {
    match (count, names) {
        (0, _) => format!("there is no part \"{wanted}\": the file holds a single outline"),
        (_, "") => format!("there is no part \"{wanted}\": they are numbered from 1 to {count}"),
        (_, names) => format!("there is no part \"{wanted}\": they are numbered from 1 to {count} and named {names}"),
    }
}
