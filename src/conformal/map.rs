//! The pipeline of a frame: kernels → measures → matching → extension.
//!
//! [`ConformalMap::update`] recomputes only what a change touches: moving x₁
//! renews its kernel, the matching and the extension; moving y₁ re-anchors its
//! measure instead. From the second update on nothing is allocated.
//!
//! [`ConformalMap::advance`] does the same in pieces, for maps whose update would block a
//! screen. What is shown is never torn: kernels, measures and correspondence are made
//! beside those that are there, images in the solver's memory, and all change at once.
//!
//! With [`Extension::CauchyGreen`] an update gives the harmonic images, at once;
//! [`ConformalMap::refine`] then replaces them chunk by chunk, within the time that it is given.

use super::half::{Change, Half};
use super::refinement::Refinement;
use super::stage::{Stage, Staged};
use super::{
    BoundaryCorrespondence, CauchyGreenMode, Constraints, Direction, Extension, ExtensionScratch, HarmonicMeasure,
    KernelScratch, MapSettings, PreparedDomain, Quality, Side, advance_extension, match_measures,
};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};
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
    /// Source and target.
    halves: [Half; 2],
    settings: MapSettings,
    correspondence: BoundaryCorrespondence,
    images: Vec<DVec2>,
    timings: FrameTimings,
    /// The update that is under way.
    run: Option<Run>,
    /// What it has matched.
    coming: BoundaryCorrespondence,
    kernel_scratch: KernelScratch,
    extension_scratch: ExtensionScratch,
    refinement: Refinement,
}

/// An update that is under way.
#[derive(Debug)]
pub(super) struct Run {
    constraints: Constraints,
    settings: MapSettings,
    /// By side.
    changes: [Change; 2],
    stage: Stage,
    timings: FrameTimings,
}

impl ConformalMap {
    /// The map under `constraints`; with [`Extension::CauchyGreen`], see [`Self::update`].
    pub fn new(
        source: Arc<PreparedDomain>,
        target: Arc<PreparedDomain>,
        constraints: &Constraints,
        settings: MapSettings,
    ) -> Result<Self, MapError> {
        let mut map = Self::unmapped(source, target);
        map.update(constraints, settings)?;
        Ok(map)
    }

    /// No map yet: it has no images before its first [`Self::advance`] has come to its end.
    pub fn unmapped(source: Arc<PreparedDomain>, target: Arc<PreparedDomain>) -> Self {
        Self {
            halves: [Half::new(source), Half::new(target)],
            settings: MapSettings::default(),
            correspondence: BoundaryCorrespondence::default(),
            images: Vec::new(),
            timings: FrameTimings::default(),
            run: None,
            coming: BoundaryCorrespondence::default(),
            kernel_scratch: KernelScratch::default(),
            extension_scratch: ExtensionScratch::default(),
            refinement: Refinement::default(),
        }
    }

    /// Recomputes what the change of constraints or settings touches. After an error the map is unchanged.
    ///
    /// With [`Extension::CauchyGreen`] the images are the harmonic ones after a change, until
    /// [`Self::refine`] has replaced them all.
    pub fn update(&mut self, constraints: &Constraints, settings: MapSettings) -> Result<(), MapError> {
        self.advance(constraints, settings, Deadline::NEVER).map(|_| ())
    }

    /// Goes on with [`Self::update`] until it is done (true) or `deadline` is over. Until it is done
    /// the map is that of the last update in all that it says. Another call with the same
    /// arguments goes on where this one stopped, one with others starts over; the result is
    /// the same to the bit. Between two looks at the clock lie some milliseconds, and the
    /// writing of a mesh's vertices at most.
    pub fn advance(
        &mut self,
        constraints: &Constraints,
        settings: MapSettings,
        deadline: Deadline,
    ) -> Result<bool, MapError> {
        let same = self.run.take().filter(|run| run.constraints == *constraints && run.settings == settings);
        let run = if same.is_some() { same } else { self.begin(constraints, settings)? };
        let Some(mut run) = run else { return Ok(true) };
        let is_done = self.go_on(&mut run, deadline)?;
        if is_done {
            self.commit(&run);
        } else {
            self.run = Some(run);
        }
        Ok(is_done)
    }

    /// Checks and plans an update; `None` if it changes nothing.
    fn begin(&mut self, constraints: &Constraints, settings: MapSettings) -> Result<Option<Run>, MapError> {
        let [source, target] = &self.halves;
        let changes = [source.plan(Side::Source, constraints)?, target.plan(Side::Target, constraints)?];
        let touched = changes.iter().any(|change| change.renewal().measure);
        if !touched && settings == self.settings {
            return Ok(None);
        }
        let (constraints, timings) = (*constraints, FrameTimings::default());
        let mut run = Run { constraints, settings, changes, stage: Stage::FIRST, timings };
        self.begin_stage(&mut run);
        Ok(Some(run))
    }

    fn match_boundaries(&mut self, run: &mut Run) {
        let start = Instant::now();
        let mapped = run.settings.direction.mapped_side();
        let [mapped, other] = [mapped, mapped.other()]
            .map(|side| self.halves[side as usize].measured.coming_measure(run.changes[side as usize].renewal()));
        match_measures(mapped, other, &mut self.coming);
        run.timings.matching += start.elapsed().as_secs_f64() * 1e3;
    }

    /// Shows what an update has come to; its images are there already.
    fn commit(&mut self, run: &Run) {
        for side in Side::BOTH {
            self.halves[side as usize].commit(side, &run.constraints, &run.changes[side as usize]);
        }
        std::mem::swap(&mut self.correspondence, &mut self.coming);
        (self.settings, self.timings) = (run.settings, run.timings);
        match self.settings.extension {
            Extension::Harmonic => self.refinement.clear(),
            Extension::CauchyGreen => {
                let start = Instant::now();
                let domain = Arc::clone(self.domain(self.settings.direction.mapped_side()));
                self.refinement.restart(&domain, &self.images[..domain.samples.len()]);
                self.timings.extend += start.elapsed().as_secs_f64() * 1e3;
            }
        }
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
        &self.halves[side as usize]
    }

    /// The prepared domain of a side.
    pub fn domain(&self, side: Side) -> &Arc<PreparedDomain> {
        &self.half(side).domain
    }

    /// The Poisson kernel ψ of a side's interior point, per boundary vertex.
    pub fn kernel(&self, side: Side) -> &[f64] {
        &self.half(side).measured.kernel
    }

    /// The harmonic measure of a side, from its anchor.
    pub fn measure(&self, side: Side) -> &HarmonicMeasure {
        &self.half(side).measured.measure
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

    /// The images of the mapped mesh's vertices, in the other domain; none before the first update. Until [`Self::refine`] is
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

    /// The image of a point of the mapped mesh (piecewise linear); `None` outside it, and before the first update.
    pub fn image_of(&self, x: DVec2) -> Option<DVec2> {
        let mesh = self.mapped_mesh();
        let hint = self.half(self.settings.direction.mapped_side()).located.triangle;
        let found = locate(mesh, x, hint)?;
        let corners = mesh.triangles[found.triangle as usize];
        let images = (!self.images.is_empty()).then_some(&self.images)?;
        Some(corners.iter().zip(found.weights).map(|(&v, w)| w * images[v as usize]).sum())
    }
}

impl Staged for ConformalMap {
    type Run = Run;
    type Error = MapError;

    fn progress(run: &mut Run) -> (&mut Stage, &mut FrameTimings) {
        (&mut run.stage, &mut run.timings)
    }

    fn begin_stage(&mut self, run: &mut Run) {
        match run.stage {
            Stage::Kernel(side) => {
                let start = Instant::now();
                self.halves[side as usize].begin(&run.changes[side as usize], &mut self.kernel_scratch);
                run.stage.add_time(&mut run.timings, start);
            }
            Stage::Extension => {
                self.match_boundaries(run);
                let start = Instant::now();
                let mapped = run.settings.direction.mapped_side();
                let [domain, other] = [mapped, mapped.other()].map(|side| &self.halves[side as usize].domain);
                let boundary = self.coming.images(&other.samples);
                domain.system().begin_extension(boundary, &mut self.extension_scratch);
                run.stage.add_time(&mut run.timings, start);
            }
        }
    }

    fn advance_stage(&mut self, run: &Run, deadline: Deadline) -> Result<bool, MapError> {
        match run.stage {
            Stage::Kernel(side) => {
                let change = &run.changes[side as usize];
                self.halves[side as usize].advance(side, &run.constraints, change, &mut self.kernel_scratch, deadline)
            }
            Stage::Extension => {
                let side = run.settings.direction.mapped_side();
                let domain = &self.halves[side as usize].domain;
                advance_extension(domain, &mut self.extension_scratch, &mut self.images, deadline)
                    .map_err(|error| MapError::NotConverged { side, error })
            }
        }
    }
}
