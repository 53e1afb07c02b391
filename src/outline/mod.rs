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

/// A valid outline with its name and the notes from reading it.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The file's stem, the name inside the file, or the preset's name.
    pub name: String,
    /// The boundary.
    pub polygon: SimplePolygon,
    /// Changes that the reader made and the user should know (reversed, largest of several rings, …).
    pub notes: Vec<OutlineNote>,
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
