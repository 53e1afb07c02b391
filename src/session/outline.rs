//! An outline in a session: a preset, or a loaded polygon that is known to be simple.

use crate::conformal::PrepareSettings;
use crate::geometry::SimplePolygon;
use crate::outline::{Outline, Preset};
use serde::{Serialize, Serializer};

/// Where a domain's outline comes from. As JSON a loaded outline is its points; `file` reads it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum OutlineSpec {
    /// A built-in outline.
    Preset(Preset),
    /// A loaded outline.
    Points {
        /// Its name.
        name: String,
        /// The polygon, checked when it was read.
        #[serde(rename = "points", serialize_with = "vertices")]
        polygon: SimplePolygon,
    },
}

impl OutlineSpec {
    /// The outline as a polygon; computed for a preset, a copy of a loaded one. Cost O(k).
    pub fn polygon(&self) -> SimplePolygon {
        match self {
            Self::Preset(preset) => preset.outline().into_polygon(),
            Self::Points { polygon, .. } => polygon.clone(),
        }
    }

    /// The number of points of a loaded outline; 0 for a preset.
    pub fn loaded_points(&self) -> usize {
        match self {
            Self::Preset(_) => 0,
            Self::Points { polygon, .. } => polygon.vertices().len(),
        }
    }
}

impl From<Outline> for OutlineSpec {
    /// Drops the reader's notes.
    fn from(outline: Outline) -> Self {
        Self::Points { name: outline.name().to_owned(), polygon: outline.into_polygon() }
    }
}

fn vertices<S: Serializer>(polygon: &SimplePolygon, serializer: S) -> Result<S::Ok, S::Error> {
    polygon.vertices().serialize(serializer)
}

/// An outline and how its interior is discretized.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DomainSpec {
    /// The outline.
    pub outline: OutlineSpec,
    /// How it is discretized.
    pub settings: PrepareSettings,
}

impl DomainSpec {
    /// An outline with these settings.
    pub fn new(outline: OutlineSpec, settings: PrepareSettings) -> Self {
        Self { outline, settings }
    }
}
