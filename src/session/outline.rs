//! An outline in the session: a built-in one by its name, or a loaded one with its proof.

use crate::conformal::PrepareSettings;
use crate::geometry::SimplePolygon;
use crate::outline::{Outline, Preset};
use serde::{Serialize, Serializer};

/// Where a domain's outline comes from. Written as JSON it holds a loaded outline's points; `file` reads it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum OutlineSpec {
    /// A built-in outline.
    Preset(Preset),
    /// A loaded one.
    Points {
        /// Its name.
        name: String,
        /// The outline, checked where it was read.
        #[serde(rename = "points", serialize_with = "vertices")]
        polygon: SimplePolygon,
    },
}

impl OutlineSpec {
    /// The outline as a polygon; computed for a preset, a copy of a loaded one. Cost O(k).
    pub fn polygon(&self) -> SimplePolygon {
        match self {
            Self::Preset(preset) => preset.outline().polygon,
            Self::Points { polygon, .. } => polygon.clone(),
        }
    }

    /// How many points a loaded one has; 0 for a preset.
    pub fn loaded_points(&self) -> usize {
        match self {
            Self::Preset(_) => 0,
            Self::Points { polygon, .. } => polygon.vertices().len(),
        }
    }
}

impl From<Outline> for OutlineSpec {
    /// Without the reader's notes.
    fn from(Outline { name, polygon, .. }: Outline) -> Self {
        Self::Points { name, polygon }
    }
}

fn vertices<S: Serializer>(polygon: &SimplePolygon, serializer: S) -> Result<S::Ok, S::Error> {
    polygon.vertices().serialize(serializer)
}

/// An outline and how its inside is discretised.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DomainSpec {
    /// The outline.
    pub outline: OutlineSpec,
    /// How it is discretised.
    pub settings: PrepareSettings,
}
