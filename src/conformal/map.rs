//! The pipeline of an update: kernels → measures → matching → extension; between two surfaces kernels → measures → both
//! disks → matching → location.
//!
//! [`ConformalMap::update`] recomputes only what depends on the change: moving x₁
//! recomputes its kernel, the matching and the extension; moving y₁ re-anchors its
//! measure instead. From the second update on nothing is allocated, except the tree for vertices that no walk locates
//! between two surfaces.
//!
//! [`ConformalMap::advance`] does the same in pieces, for maps whose update takes longer than a frame. The visible
//! state is always that of one complete update: kernels, measures and correspondence are computed
//! in separate buffers, images in the solver's memory, and all of them are replaced at the end.
//!
//! With [`Extension::CauchyGreen`] and [`Extension::Exact`] an update yields the harmonic images;
//! [`ConformalMap::refine`] then replaces them chunk by chunk, within the given time.

use super::far_anchors::FarAnchor;
use super::kernel::KernelScratch;
use super::map_run::Run;
use super::map_side::MapSide;
use super::refinement::Refinement;
use super::subdivision::Finest;
use super::through_disk::ThroughDisk;
use super::{
    BoundaryCorrespondence, CauchyGreenMode, Constraints, Differences, Direction, Extension, ExtensionScratch,
    MapError, MapSettings, PerSide, PreparedSide, ResolvedBoundary, Side,
};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use std::sync::Arc;
use web_time::Instant;

/// The time between two reports of the progress of exact images, in ms.
const REPORT_MS: f64 = 20.0;

/// The duration of an update by stage, in milliseconds; 0 for a stage that was not needed.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the fields are the stages")]
#[non_exhaustive]
pub struct FrameTimings {
    pub kernel: f64,
    #[serde(rename = "match")]
    pub matching: f64,
    pub extend: f64,
}

/// The conformal map between two sides under the current constraints.
///
/// A surface can be mapped, but not be mapped into: with one surface its mesh is mapped, in either direction. Between
/// two, both go to the unit disk, and the vertices of one are located in the image of the other
/// ([`super::SurfaceImages`]).
#[derive(Debug)]
pub struct ConformalMap {
    pub(super) sides: PerSide<MapSide>,
    pub(super) settings: MapSettings,
    pub(super) correspondence: BoundaryCorrespondence,
    pub(super) images: Vec<DVec2>,
    pub(super) timings: FrameTimings,
    /// The update in progress.
    run: Option<Run>,
    /// The correspondence computed by that update.
    pub(super) coming: BoundaryCorrespondence,
    pub(super) kernel_scratch: KernelScratch,
    pub(super) extension_scratch: ExtensionScratch,
    refinement: Refinement,
    pub(super) through_disk: ThroughDisk,
    /// The boundary of the mapped mesh, if it was refined for this map.
    pub(super) resolution: Option<Arc<ResolvedBoundary>>,
    /// The errors by comparison with finer meshes, if they were estimated.
    pub(super) compared: Option<Box<Differences>>,
    /// Where both boundaries are far from both points, if both measures are from the boundary integral.
    pub(super) far: Vec<FarAnchor>,
    /// The map on finer meshes that this one is taken from.
    pub(super) finest: Option<Box<Finest>>,
}

impl ConformalMap {
    /// The map under `constraints`; unless [`Extension::Harmonic`] is asked for, see [`Self::update`].
    pub fn new(
        source: Arc<PreparedSide>,
        target: Arc<PreparedSide>,
        constraints: &Constraints,
        settings: MapSettings,
    ) -> Result<Self, MapError> {
        let mut map = Self::unmapped(source, target);
        map.update(constraints, settings)?;
        Ok(map)
    }

    /// A map without images: it has none until its first [`Self::advance`] is complete.
    pub fn unmapped(source: Arc<PreparedSide>, target: Arc<PreparedSide>) -> Self {
        let sides = PerSide::new(MapSide::new(source), MapSide::new(target));
        Self {
            settings: possible(&sides, MapSettings::default()),
            sides,
            correspondence: BoundaryCorrespondence::default(),
            images: Vec::new(),
            timings: FrameTimings::default(),
            run: None,
            coming: BoundaryCorrespondence::default(),
            kernel_scratch: KernelScratch::default(),
            extension_scratch: ExtensionScratch::default(),
            refinement: Refinement::default(),
            through_disk: ThroughDisk::default(),
            resolution: None,
            compared: None,
            far: Vec::new(),
            finest: None,
        }
    }

    /// A copy of the last complete update between outlines; an extension that is not complete begins anew.
    #[must_use]
    pub fn copied(&self) -> Self {
        let [source, target] = Side::BOTH.map(|side| Arc::clone(self.side(side)));
        let mut copy = Self {
            sides: PerSide::from_fn(|side| self.sides[side].copied()),
            settings: self.settings,
            correspondence: self.correspondence.clone(),
            images: self.images.clone(),
            timings: self.timings,
            resolution: self.resolution.clone(),
            compared: self.compared.clone(),
            far: self.far.clone(),
            ..Self::unmapped(source, target)
        };
        if self.extension_progress() < 1.0 {
            copy.begin_refinement();
        }
        copy
    }

    /// Recomputes what depends on the changed constraints or settings. After an error the map is unchanged.
    ///
    /// With [`Extension::CauchyGreen`] and [`Extension::Exact`] the images are harmonic after a change, until
    /// [`Self::refine`] has replaced them all.
    pub fn update(&mut self, constraints: &Constraints, settings: MapSettings) -> Result<(), MapError> {
        self.advance(constraints, settings, Deadline::NEVER).map(|_| ())
    }

    /// Continues [`Self::update`] until it is complete (true) or `deadline` has passed. Until then all accessors return
    /// the state of the last complete update. Another call with the same
    /// arguments continues where this one stopped, one with others starts over; the result is
    /// bit-identical to that of one call. The deadline is checked every few milliseconds; the longest step between two
    /// checks is writing the vertices of a mesh.
    pub fn advance(
        &mut self,
        constraints: &Constraints,
        settings: MapSettings,
        deadline: Deadline,
    ) -> Result<bool, MapError> {
        let settings = possible(&self.sides, settings);
        let same = self.run.take().filter(|run| run.constraints == *constraints && run.settings == settings);
        let run = if same.is_some() { same } else { self.begin(constraints, settings)? };
        let Some(mut run) = run else { return Ok(true) };
        let is_done = self.go_on(&mut run, deadline)?;
        if is_done {
            self.commit(run);
        } else {
            self.run = Some(run);
        }
        Ok(is_done)
    }

    /// Checks and plans an update; `None` if nothing changes.
    fn begin(&mut self, constraints: &Constraints, settings: MapSettings) -> Result<Option<Run>, MapError> {
        let source = self.sides.source.plan(Side::Source, constraints)?;
        let changes = PerSide::new(source, self.sides.target.plan(Side::Target, constraints)?);
        let touched = changes.iter().any(|(_, change)| change.renewal().measure);
        if !touched && settings == self.settings {
            return Ok(None);
        }
        let mut run = Run::new(*constraints, settings, changes);
        self.begin_stage(&mut run);
        Ok(Some(run))
    }

    /// Makes the results of a complete update visible; its images are already in place.
    fn commit(&mut self, run: Run) {
        for side in Side::BOTH {
            self.sides[side].commit(side, &run.constraints, &run.changes[side]);
        }
        if self.is_through_disk() {
            self.through_disk.commit(run.renewed());
        }
        std::mem::swap(&mut self.correspondence, &mut self.coming);
        (self.settings, self.timings) = (run.settings, run.timings);
        (self.resolution, self.compared, self.finest) = (None, None, None);
        self.far = run.far;
        self.begin_refinement();
    }

    /// Begins to replace the harmonic images, if the extension is another one.
    pub(super) fn begin_refinement(&mut self) {
        match self.settings.extension {
            Extension::Harmonic => self.refinement.clear(),
            Extension::CauchyGreen => {
                let start = Instant::now();
                if let Some(domain) = self.sides[self.mapped_side()].prepared.domain() {
                    self.refinement.restart(domain, &self.images[..domain.samples().len()]);
                }
                self.timings.extend += start.elapsed().as_secs_f64() * 1e3;
            }
            Extension::Exact => self.refinement.restart_exactly(),
        }
    }

    /// Replaces harmonic images by Cauchy–Green or exact ones for about `budget_ms` (the clock is checked
    /// every few milliseconds; at least one chunk of Cauchy–Green images is done; infinity completes all). Returns
    /// whether the extension is complete; with [`Extension::Harmonic`] it always is, and with [`Extension::Exact`] where
    /// a side has finite elements: there images stay harmonic.
    ///
    /// The coordinates of a mesh up to [`super::STORED_BYTES`] are kept while its domain is mapped.
    pub fn refine(&mut self, budget_ms: f64) -> bool {
        let start = Instant::now();
        let complete = if self.settings.extension == Extension::Exact {
            self.refine_by_integral(budget_ms)
        } else {
            self.refinement.advance(&mut self.images, budget_ms)
        };
        self.timings.extend += start.elapsed().as_secs_f64() * 1e3;
        complete
    }

    fn refine_by_integral(&mut self, budget_ms: f64) -> bool {
        let (mut refinement, mut images) = (std::mem::take(&mut self.refinement), std::mem::take(&mut self.images));
        let complete = refinement.advance_exactly(self, &mut images, budget_ms);
        (self.refinement, self.images) = (refinement, images);
        complete
    }

    /// As [`Self::refine`] without a limit, entirely in f64 and without storing coordinates: for a map that is used
    /// once.
    pub fn refine_exactly(&mut self) {
        self.refine_exactly_with(&mut |_| ());
    }

    /// As [`Self::refine_exactly`]; `progress` is called with the completed fraction after each chunk of a few
    /// milliseconds.
    pub fn refine_exactly_with(&mut self, progress: &mut dyn FnMut(f64)) {
        if self.settings.extension == Extension::Exact {
            while !self.refine(REPORT_MS) {
                progress(self.extension_progress());
            }
            return;
        }
        let start = Instant::now();
        self.refinement.finish_exactly(&mut self.images, progress);
        self.timings.extend += start.elapsed().as_secs_f64() * 1e3;
    }

    /// The fraction of the vertices whose images are those of the requested extension, in `[0, 1]`.
    pub fn extension_progress(&self) -> f64 {
        self.refinement.progress(self.images.len())
    }

    /// Whether the Cauchy–Green coordinates are stored; `None` if they were never needed.
    pub fn cauchy_green_mode(&self) -> Option<CauchyGreenMode> {
        self.refinement.mode()
    }

    /// Takes from `old` what depends on the mapped domain alone, if it is the same domain:
    /// the stored Cauchy–Green coordinates.
    pub fn adopt(&mut self, old: Self) {
        if let Some(domain) = self.sides[self.mapped_side()].prepared.domain() {
            self.refinement.adopt(domain, old.refinement);
        }
    }
}

/// The settings with the only possible values for surfaces: a surface is mapped, not mapped into, and extended
/// harmonically.
fn possible(sides: &PerSide<MapSide>, settings: MapSettings) -> MapSettings {
    let direction = match sides.as_ref().map(|side| side.prepared.is_surface()).into_array() {
        [false, false] => return settings,
        [true, true] => settings.direction,
        [true, false] => Direction::mapping(Side::Source),
        [false, true] => Direction::mapping(Side::Target),
    };
    MapSettings { direction, extension: Extension::Harmonic }
}
