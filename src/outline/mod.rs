//! Outlines: reading them from files, the built-in ones, and sampling their boundary.
//!
//! `parse` and [`Preset::outline`] give an [`Outline`]: a polygon, and how its curve is found ([`CurveForm`]).
//! [`sample`] turns the polygon into the [`BoundarySamples`] on which finite elements are computed.

mod corners;
mod crossing;
mod flatten;
mod interpretation;
mod overlaps;
#[cfg(feature = "io")]
mod parse;
mod pen;
mod preset;
mod sampling;
mod segment;
mod shapes;
mod smooth;

use std::fmt;

use crate::counted::counted;
use crate::geometry::{CurveError, DVec2, SimplePolygon};
pub use flatten::flattened;
pub use interpretation::{CurveForm, CurveSource, Interpretation, Interpreted, LEAST_SMOOTH, OutlineCurve};
#[cfg(feature = "io")]
pub use parse::{
    Contents, GeoJsonFault, GeoRing, JsonFault, JsonKind, MAX_BYTES, OutlineError, Part, PartChoice, Parts, PointFault,
    Reading, SvgFault, parse, parse_as, parse_contents, parse_geo_rings, parse_points,
};
pub use preset::{Preset, UnknownPreset};
pub use sampling::{BoundaryPoint, BoundarySamples, BrokenSamples, MAX_SAMPLES, Sampling, SamplingError, sample};
pub use segment::Segment;
pub use smooth::StaysPolygon;

/// An outline: a curve and the simple polygon, counter-clockwise, that samples it, with a name and the notes from
/// reading it. The curve is found from the polygon and the [`CurveForm`], by [`Self::curve`].
///
/// [`SimplePolygon`] carries the proof that the boundary does not cross itself; nothing here weakens it.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    name: String,
    polygon: SimplePolygon,
    form: CurveForm,
    notes: Vec<OutlineNote>,
}

impl Outline {
    /// The outline of a list of points, without notes, to be interpreted automatically.
    pub fn new(name: impl Into<String>, polygon: SimplePolygon) -> Self {
        Self { name: name.into(), polygon, form: CurveForm::default(), notes: Vec::new() }
    }

    /// The same outline with another form of its curve.
    #[must_use]
    pub fn with_form(self, form: CurveForm) -> Self {
        Self { form, ..self }
    }

    /// The same outline, interpreted otherwise.
    #[must_use]
    pub fn interpreted(mut self, interpretation: Interpretation) -> Self {
        self.form.interpretation = interpretation;
        self
    }

    /// The same outline with the notes of its reader in place of those it had.
    #[must_use]
    pub fn with_notes(self, notes: Vec<OutlineNote>) -> Self {
        Self { notes, ..self }
    }

    /// The name inside the file, the file's stem, or the preset's name; may be empty.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The boundary.
    pub fn polygon(&self) -> &SimplePolygon {
        &self.polygon
    }

    /// How the curve is found.
    pub fn form(&self) -> &CurveForm {
        &self.form
    }

    /// The curve that the polygon samples. Errors: as [`CurveForm::curve`].
    pub fn curve(&self) -> Result<OutlineCurve, CurveError> {
        self.form.curve(&self.polygon)
    }

    /// The places of the corners: [`CurveForm::corner_places`].
    pub fn corner_places(&self) -> Vec<DVec2> {
        self.form.corner_places(&self.polygon)
    }

    /// The boundary, without name and notes.
    pub fn into_polygon(self) -> SimplePolygon {
        self.polygon
    }

    /// Whether its coordinates may be longitudes and latitudes.
    pub fn is_geographic(&self) -> bool {
        self.notes.contains(&OutlineNote::Geographic)
    }

    /// Changes that the reader made, in the order in which it made them (largest of several rings, reversed, …).
    pub fn notes(&self) -> &[OutlineNote] {
        &self.notes
    }
}

/// A change made while reading an outline; not an error.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum OutlineNote {
    /// The points were clockwise and have been reversed.
    Reversed,
    /// Of several shapes of a drawing this one was taken.
    ShapeTaken {
        /// Its number in the order of the drawing, from 1.
        number: usize,
        /// How many shapes there are.
        count: usize,
        /// The `id` of its path.
        name: Option<String>,
    },
    /// The y axis of a drawing points down, and up here.
    Upwards,
    /// Points equal to the one before them were dropped.
    RepeatedPointsDropped {
        /// Number of points dropped.
        count: usize,
    },
    /// Columns of a table beside x and y were left out.
    ColumnsDropped {
        /// Number of columns.
        columns: usize,
    },
    /// There were several rings; the largest was taken.
    LargestOf {
        /// Number of rings in the file.
        rings: usize,
    },
    /// The last point repeated the first one and was dropped.
    ClosingPointDropped,
    /// The polygon had holes, which were left out.
    HolesIgnored {
        /// Number of holes.
        holes: usize,
    },
    /// Points where the outline touched itself or folded back were removed.
    Repaired {
        /// Number of points dropped.
        dropped: usize,
    },
    /// The points of a `GeoJSON` file, whose numbers may be longitudes and latitudes, were taken as plane coordinates.
    Geographic,
}

impl fmt::Display for OutlineNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reversed => f.write_str("The points ran clockwise and were reversed."),
            Self::Upwards => f.write_str("y points up: (x, y) of the drawing is (x, −y) here."),
            Self::ShapeTaken { number, count, name: None } => write!(f, "Shape {number} of {count} was taken."),
            Self::ShapeTaken { number, count, name: Some(name) } => {
                write!(f, "Shape {number} of {count} was taken, \"{name}\".")
            }
            Self::RepeatedPointsDropped { count } => f.write_str(&counted!(
                *count,
                "A point equal to the one before it was dropped.",
                "{count} points equal to the one before them were dropped."
            )),
            Self::ColumnsDropped { columns } => f.write_str(&counted!(
                *columns,
                "A column beside x and y was left out.",
                "{columns} columns beside x and y were left out."
            )),
            Self::LargestOf { rings } => write!(f, "Of {rings} closed rings, the largest was taken."),
            Self::ClosingPointDropped => f.write_str("The last point repeated the first one and was dropped."),
            Self::Repaired { dropped } => f.write_str(&counted!(
                *dropped,
                "A repeated point or spike was cut off.",
                "{dropped} points of loops and spikes were cut off."
            )),
            Self::Geographic => f.write_str("Longitudes and latitudes were taken as plane coordinates."),
            Self::HolesIgnored { holes } => {
                f.write_str(&counted!(*holes, "A hole was left out.", "{holes} holes were left out."))
            }
        }
    }
}
