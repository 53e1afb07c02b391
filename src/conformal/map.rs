//! The pipeline of a frame: kernels → measures → matching → extension.

use super::PreparedDomain;
use crate::geometry::DVec2;
use crate::mesh::TriMesh;
use std::sync::Arc;

/// One of the two domains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Ω₁.
    Source,
    /// Ω₂.
    Target,
}

/// Which mesh is mapped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// The source's vertices are mapped into the target.
    Forward,
    /// The target's vertices are mapped into the source, as texture coordinates.
    #[default]
    Backward,
}

/// `f(x₁) = x₂`, `f(y₁) = y₂`.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Constraints {
    /// `x₁`, inside Ω₁.
    pub source_point: DVec2,
    /// `x₂`, inside Ω₂.
    pub target_point: DVec2,
    /// `y₁`, as a fraction of the arc length of the source outline from its first point.
    pub source_anchor: f64,
    /// `y₂`, likewise on the target outline.
    pub target_anchor: f64,
}

/// What an update took, in milliseconds; a stage that was not needed took 0.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the fields are the stages")]
pub struct FrameTimings {
    pub kernel: f64,
    #[serde(rename = "match")]
    pub matching: f64,
    pub extend: f64,
}

/// Angle distortion of the mapped mesh, `Q = σ₁/σ₂` per triangle.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Quality {
    /// Area-weighted mean of Q.
    pub q_mean: f64,
    /// The largest Q.
    pub q_max: f64,
    /// How many triangles changed their orientation.
    pub flipped: u32,
}

/// Why there is no map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MapError {
    /// An interior point is not inside its domain.
    #[error("the {side} point ({x}, {y}) is not inside the {side} outline")]
    PointOutside {
        /// "source" or "target".
        side: &'static str,
        /// Its position.
        x: f64,
        /// Its position.
        y: f64,
    },
}

/// The conformal map between two prepared domains under the current constraints.
#[derive(Debug)]
pub struct ConformalMap {
    source: Arc<PreparedDomain>,
    target: Arc<PreparedDomain>,
    direction: Direction,
    images: Vec<DVec2>,
    timings: FrameTimings,
}

impl ConformalMap {
    /// The map under `constraints`.
    pub fn new(
        source: Arc<PreparedDomain>,
        target: Arc<PreparedDomain>,
        constraints: &Constraints,
        direction: Direction,
    ) -> Result<Self, MapError> {
        let mut map = Self { source, target, direction, images: Vec::new(), timings: FrameTimings::default() };
        map.update(constraints, direction)?;
        Ok(map)
    }

    /// Recomputes what the change of constraints or direction touches. After an
    /// error the map is unchanged.
    pub fn update(&mut self, constraints: &Constraints, direction: Direction) -> Result<(), MapError> {
        let _ = constraints;
        self.direction = direction; // skeleton: the identity
        self.images = self.mapped_mesh().vertices.clone();
        Ok(())
    }

    /// The prepared domain of a side.
    pub fn domain(&self, side: Side) -> &Arc<PreparedDomain> {
        match side {
            Side::Source => &self.source,
            Side::Target => &self.target,
        }
    }

    /// Which mesh is mapped.
    pub fn direction(&self) -> Direction {
        self.direction
    }

    /// The mesh whose vertices are mapped: the source's if forward, else the target's.
    pub fn mapped_mesh(&self) -> &TriMesh {
        match self.direction {
            Direction::Forward => &self.source.mesh,
            Direction::Backward => &self.target.mesh,
        }
    }

    /// The images of the mapped mesh's vertices, in the other domain.
    pub fn images(&self) -> &[DVec2] {
        &self.images
    }

    /// What the last update took.
    pub fn timings(&self) -> FrameTimings {
        self.timings
    }

    /// Angle distortion and flips. Cost O(triangles); call it when it is shown.
    pub fn quality(&self) -> Quality {
        Quality { q_mean: 1.0, q_max: 1.0, flipped: 0 } // skeleton
    }

    /// The image of a point of the mapped mesh (piecewise linear); `None` outside it.
    pub fn image_of(&self, x: DVec2) -> Option<DVec2> {
        Some(x) // skeleton
    }
}
