//! Outlines: where they come from (files, presets) and how they are sampled.
//!
//! `parse` and [`Preset::outline`] give an [`Outline`]; [`sample`] turns its
//! polygon into the [`BoundarySamples`] on which everything else is computed.

mod pen;
mod preset;
mod sampling;
mod shapes;

use crate::geometry::SimplePolygon;
pub use preset::{Preset, UnknownPreset};
pub use sampling::{BoundaryPoint, BoundarySamples, BrokenSamples, MAX_SAMPLES, Sampling, SamplingError, sample};

/// A named, valid outline with what was said about it on the way in.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The file's stem, the name inside the file, or the preset's name.
    pub name: String,
    /// The boundary.
    pub polygon: SimplePolygon,
    /// What was accepted but should be said (reversed, largest of several rings, …).
    pub notes: Vec<OutlineNote>,
}

/// Something that a reader of the file may want to know; no error.
#[derive(Debug, Clone, PartialEq)]
pub enum OutlineNote {
    /// The points ran clockwise and were reversed.
    Reversed,
    /// There were several rings; the largest was taken.
    LargestOf {
        /// How many rings there were.
        rings: usize,
    },
    /// The last point repeated the first one and was dropped.
    ClosingPointDropped,
}
