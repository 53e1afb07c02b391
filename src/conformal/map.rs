//! The pipeline of a frame: kernels → measures → matching → extension.
//!
//! [`ConformalMap::update`] recomputes only what a change touches: moving x₁
//! renews its kernel, the matching and the extension; moving y₁ re-anchors its
//! measure instead. After the first update nothing is allocated.
//!
//! With [`Extension::CauchyGreen`] an update gives the harmonic images, at once;
//! [`ConformalMap::refine`] then replaces them chunk by chunk, within the time that it is given.

use super::half::{Change, Half};
use super::refinement::Refinement;
use super::{
    BoundaryCorrespondence, CauchyGreenMode, Constraints, Direction, Extension, HarmonicMeasure, KernelScratch,
    MapSettings, PreparedDomain, Quality, Side, harmonic_extension, match_measures,
};
use crate::geometry::DVec2;
use crate::laplace::{Lanes, NotConverged};
use crate::mesh::{TriMesh, locate};
use std::sync::Arc;
use web_time::Instant;

/// What an update took, in milliseconds; a stage that was not needed took 0.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the fields are the stages")]
pub struct FrameTimings {
    pub kernel: f64,
    #[serde(rename = "match")]
    pub matching: f64,
    pub extend: f64,
}

/// Why there is no map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MapError {
    /// An interior point is not inside its (sampled) domain.
    #[error("the {side} point ({x}, {y}) is not inside the {side} outline as it is sampled")]
    PointOutside {
        /// Which domain.
        side: Side,
        /// Its position.
        x: f64,
        /// Its position.
        y: f64,
    },
    /// An anchor is not a number.
    #[error("the {side} anchor is not a finite fraction of the arc length")]
    AnchorNotFinite {
        /// Which domain.
        side: Side,
    },
    /// A domain's iterative solver did not converge; a domain with a complete factor has no such error.
    #[error("{side}: {error}")]
    NotConverged {
        /// Which domain.
        side: Side,
        /// What the solver said.
        error: NotConverged,
    },
}

/// The conformal map between two prepared domains under the current constraints.
#[derive(Debug)]
pub struct ConformalMap {
    source: Half,
    target: Half,
    settings: MapSettings,
    correspondence: BoundaryCorrespondence,
    images: Vec<DVec2>,
    /// Whether the last update came to its end.
    is_complete: bool,
    timings: FrameTimings,
    kernel_scratch: KernelScratch,
    extension_scratch: Vec<Lanes<2>>,
    refinement: Refinement,
}

impl ConformalMap {
    /// The map under `constraints`; with [`Extension::CauchyGreen`], see [`Self::update`].
    pub fn new(
        source: Arc<PreparedDomain>,
        target: Arc<PreparedDomain>,
        constraints: &Constraints,
        settings: MapSettings,
    ) -> Result<Self, MapError> {
        let mut map = Self {
            source: Half::new(source),
            target: Half::new(target),
            settings,
            correspondence: BoundaryCorrespondence::default(),
            images: Vec::new(),
            is_complete: false,
            timings: FrameTimings::default(),
            kernel_scratch: KernelScratch::default(),
            extension_scratch: Vec::new(),
            refinement: Refinement::default(),
        };
        map.update(constraints, settings)?;
        Ok(map)
    }

    /// Recomputes what the change of constraints or settings touches. After an
    /// error the map is unchanged (after [`MapError::NotConverged`], what the solve would have given is not).
    ///
    /// With [`Extension::CauchyGreen`] the images are the harmonic ones after a change, until
    /// [`Self::refine`] has replaced them all.
    pub fn update(&mut self, constraints: &Constraints, settings: MapSettings) -> Result<(), MapError> {
        let changes = [self.source.plan(Side::Source, constraints)?, self.target.plan(Side::Target, constraints)?];
        let touched = changes.iter().any(Change::is_some);
        if !touched && settings == self.settings && self.is_complete {
            return Ok(());
        }
        self.is_complete = false;
        self.settings = settings;
        let mut timings = FrameTimings::default();
        let start = Instant::now();
        self.source.apply(Side::Source, constraints, &changes[0], &mut self.kernel_scratch)?;
        self.target.apply(Side::Target, constraints, &changes[1], &mut self.kernel_scratch)?;
        timings.kernel = start.elapsed().as_secs_f64() * 1e3;
        self.match_boundaries(&mut timings);
        self.extend(&mut timings)?;
        self.timings = timings;
        self.is_complete = true;
        Ok(())
    }

    fn match_boundaries(&mut self, timings: &mut FrameTimings) {
        let start = Instant::now();
        let (mapped, other) = match self.settings.direction {
            Direction::Forward => (&self.source, &self.target),
            Direction::Backward => (&self.target, &self.source),
        };
        match_measures(&mapped.measure, &other.measure, &mut self.correspondence);
        timings.matching = start.elapsed().as_secs_f64() * 1e3;
    }

    fn extend(&mut self, timings: &mut FrameTimings) -> Result<(), MapError> {
        let start = Instant::now();
        let (mapped, other) = match self.settings.direction {
            Direction::Forward => (&self.source.domain, &self.target.domain),
            Direction::Backward => (&self.target.domain, &self.source.domain),
        };
        self.images.clear();
        self.images.extend(self.correspondence.images(&other.samples));
        match self.settings.extension {
            Extension::Harmonic => self.refinement.clear(),
            Extension::CauchyGreen => self.refinement.restart(mapped, &self.images),
        }
        self.images.resize(mapped.mesh.vertices.len(), DVec2::ZERO);
        harmonic_extension(mapped, &mut self.images, &mut self.extension_scratch)
            .map_err(|error| MapError::NotConverged { side: self.settings.direction.mapped_side(), error })?;
        timings.extend = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
    }

    /// Replaces harmonic images by Cauchy–Green ones for about `budget_ms` (the time is checked
    /// every few milliseconds; at least one chunk is done; infinity does all). Returns whether
    /// the extension is complete: at once, if it is [`Extension::Harmonic`].
    ///
    /// The coordinates of a mesh up to [`super::STORED_BYTES`] are kept while its domain is mapped.
    pub fn refine(&mut self, budget_ms: f64) -> bool {
        let start = Instant::now();
        let complete = self.refinement.advance(&mut self.images, budget_ms);
        self.timings.extend += start.elapsed().as_secs_f64() * 1e3;
        complete
    }

    /// As [`Self::refine`] without a limit, but all in f64 and without storing coordinates: for a map that is used once.
    pub fn refine_exactly(&mut self) {
        self.refine_exactly_with(&mut |_| ());
    }

    /// As [`Self::refine_exactly`]; after each chunk of a few milliseconds `progress` hears the fraction that is done.
    pub fn refine_exactly_with(&mut self, progress: &mut dyn FnMut(f64)) {
        let start = Instant::now();
        self.refinement.finish_exactly(&mut self.images, progress);
        self.timings.extend += start.elapsed().as_secs_f64() * 1e3;
    }

    /// The fraction of the vertices whose images are those of the extension that was asked for, in `[0, 1]`.
    pub fn extension_progress(&self) -> f64 {
        self.refinement.progress(self.images.len())
    }

    /// Whether the Cauchy–Green coordinates are stored; `None` if they were never asked for.
    pub fn cauchy_green_mode(&self) -> Option<CauchyGreenMode> {
        self.refinement.mode()
    }

    /// Takes over from `old` what depends on the mapped domain alone, if it is the same domain:
    /// the stored Cauchy–Green coordinates.
    pub fn adopt(&mut self, old: Self) {
        let mapped = Arc::clone(self.domain(self.settings.direction.mapped_side()));
        self.refinement.adopt(&mapped, old.refinement);
    }

    fn half(&self, side: Side) -> &Half {
        match side {
            Side::Source => &self.source,
            Side::Target => &self.target,
        }
    }

    /// The prepared domain of a side.
    pub fn domain(&self, side: Side) -> &Arc<PreparedDomain> {
        &self.half(side).domain
    }

    /// The Poisson kernel ψ of a side's interior point, per boundary vertex.
    pub fn kernel(&self, side: Side) -> &[f64] {
        &self.half(side).kernel
    }

    /// The harmonic measure of a side, from its anchor.
    pub fn measure(&self, side: Side) -> &HarmonicMeasure {
        &self.half(side).measure
    }

    /// Where the boundary vertices of the mapped side go.
    pub fn correspondence(&self) -> &BoundaryCorrespondence {
        &self.correspondence
    }

    /// Which mesh is mapped.
    pub fn direction(&self) -> Direction {
        self.settings.direction
    }

    /// How the boundary map is extended.
    pub fn extension(&self) -> Extension {
        self.settings.extension
    }

    /// The mesh whose vertices are mapped: the source's if forward, else the target's.
    pub fn mapped_mesh(&self) -> &TriMesh {
        &self.domain(self.settings.direction.mapped_side()).mesh
    }

    /// The images of the mapped mesh's vertices, in the other domain. Until [`Self::refine`] is
    /// done, those of the harmonic extension in part.
    pub fn images(&self) -> &[DVec2] {
        &self.images
    }

    /// What the last update took, with the refinements since.
    pub fn timings(&self) -> FrameTimings {
        self.timings
    }

    /// Angle distortion and flips. Cost O(triangles); call it when it is shown.
    pub fn quality(&self) -> Quality {
        Quality::of(self.mapped_mesh(), &self.images)
    }

    /// The image of a point of the mapped mesh (piecewise linear); `None` outside it.
    pub fn image_of(&self, x: DVec2) -> Option<DVec2> {
        let mesh = self.mapped_mesh();
        let hint = self.half(self.settings.direction.mapped_side()).located.triangle;
        let found = locate(mesh, x, hint)?;
        let corners = mesh.triangles[found.triangle as usize];
        Some(corners.iter().zip(found.weights).map(|(&v, w)| w * self.images[v as usize]).sum())
    }
}
