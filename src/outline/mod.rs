//! Outlines: reading them from files, the built-in ones, and sampling their boundary.
//!
//! `parse` and [`Preset::outline`] give an [`Outline`]; [`sample`] turns its
//! polygon into the [`BoundarySamples`] on which everything else is computed.

#[cfg(feature = "io")]
mod parse;
mod pen;
mod preset;
mod sampling;
mod shapes;

use std::fmt;

use crate::counted::counted;
use crate::geometry::SimplePolygon;
#[cfg(feature = "io")]
pub use parse::{
    GeoJsonFault, JsonFault, JsonKind, MAX_BYTES, OutlineError, PointFault, SvgFault, parse, parse_repaired,
};
pub use preset::{Preset, UnknownPreset};
pub use sampling::{BoundaryPoint, BoundarySamples, BrokenSamples, MAX_SAMPLES, Sampling, SamplingError, sample};

/// An outline: a simple polygon, counter-clockwise, with a name and the notes from reading it.
///
/// [`SimplePolygon`] carries the proof that the boundary does not cross itself; nothing here weakens it.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    name: String,
    polygon: SimplePolygon,
    notes: Vec<OutlineNote>,
}

impl Outline {
    /// The outline of a polygon, without notes.
    pub fn new(name: impl Into<String>, polygon: SimplePolygon) -> Self {
        Self { name: name.into(), polygon, notes: Vec::new() }
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

    /// The boundary, without name and notes.
    pub fn into_polygon(self) -> SimplePolygon {
        self.polygon
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
}

impl fmt::Display for OutlineNote {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reversed => f.write_str("The points ran clockwise and were reversed."),
            Self::LargestOf { rings } => write!(f, "Of {rings} closed rings, the largest was taken."),
            Self::ClosingPointDropped => f.write_str("The last point repeated the first one and was dropped."),
            Self::Repaired { dropped } => f.write_str(&counted!(
                *dropped,
                "A repeated point or spike was cut off.",
                "{dropped} points of loops and spikes were cut off."
            )),
            Self::HolesIgnored { holes } => {
                f.write_str(&counted!(*holes, "A hole was left out.", "{holes} holes were left out."))
            }
        }
    }
}
