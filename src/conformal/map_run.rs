//! An update of a map as a resumable sequence of stages.

use super::far_anchors::{FarAnchor, far_anchors};
use super::map_side::{Change, MapSide};
use super::stage::Stage;
use super::{
    ConformalMap, Constraints, FrameTimings, MapError, MapSettings, MeshedSurface, PerSide, Side,
    begin_disk_coordinates, match_measures,
};
use crate::laplace::Deadline;
use std::sync::Arc;
use web_time::Instant;

/// The state of an update in progress.
#[derive(Debug)]
pub(super) struct Run {
    pub constraints: Constraints,
    pub settings: MapSettings,
    pub changes: PerSide<Change>,
    stage: Stage,
    pub timings: FrameTimings,
    /// Where both boundaries are far from both points.
    pub far: Vec<FarAnchor>,
}

impl Run {
    pub fn new(constraints: Constraints, settings: MapSettings, changes: PerSide<Change>) -> Self {
        Self { constraints, settings, changes, stage: Stage::FIRST, timings: FrameTimings::default(), far: Vec::new() }
    }

    /// The sides whose measure, and all that depends on it, this update recomputes.
    pub fn renewed(&self) -> PerSide<bool> {
        self.changes.map(|change| change.renewal().measure)
    }

    fn mapped(&self) -> Side {
        self.settings.direction.mapped_side()
    }
}

impl ConformalMap {
    /// Continues the update until its last stage is complete (true) or `deadline` has passed.
    pub(super) fn go_on(&mut self, run: &mut Run, deadline: Deadline) -> Result<bool, MapError> {
        loop {
            let start = Instant::now();
            let is_done = self.advance_stage(run, deadline)?;
            run.stage.add_time(&mut run.timings, start);
            if !is_done {
                return Ok(false);
            }
            let Some(next) = run.stage.next(self.surfaces(run.mapped()).is_some()) else { return Ok(true) };
            run.stage = next;
            self.begin_stage(run);
            if deadline.is_over() {
                return Ok(false);
            }
        }
    }

    /// Starts the stage of `run`, and adds the time that this takes.
    pub(super) fn begin_stage(&mut self, run: &mut Run) {
        if matches!(run.stage, Stage::Extension | Stage::Location) {
            self.match_boundaries(run);
        }
        let start = Instant::now();
        match run.stage {
            Stage::Kernel(side) => self.sides[side].begin(&run.changes[side], &mut self.kernel_scratch),
            Stage::Extension => self.begin_extension(run.mapped()),
            Stage::Disk(side) if run.renewed()[side] => {
                let MapSide { prepared, measured, .. } = &self.sides[side];
                let measure = measured.coming_measure(run.changes[side].renewal());
                begin_disk_coordinates(prepared, measure, &mut self.extension_scratch);
            }
            Stage::Disk(_) => {}
            Stage::Location => {
                if let Some([mapped, other]) = self.surfaces(run.mapped()) {
                    let other = (&*other, run.mapped().other());
                    self.through_disk.begin(mapped.mesh().vertices().len(), other, &self.coming);
                }
            }
        }
        run.stage.add_time(&mut run.timings, start);
    }

    /// Continues the stage of `run` until it is complete (true) or `deadline` has passed.
    fn advance_stage(&mut self, run: &Run, deadline: Deadline) -> Result<bool, MapError> {
        let scratch = &mut self.extension_scratch;
        match run.stage {
            Stage::Kernel(side) => {
                let change = &run.changes[side];
                self.sides[side].advance(side, &run.constraints, change, &mut self.kernel_scratch, deadline)
            }
            Stage::Extension => {
                let side = run.mapped();
                let is_done = self.sides[side].prepared.advance_extension(scratch, &mut self.images, deadline);
                is_done.map_err(|error| MapError::NotConverged { side, error })
            }
            Stage::Disk(side) if run.renewed()[side] => {
                let values = self.through_disk.coming_disks[side].places_mut();
                let is_done = self.sides[side].prepared.advance_extension(scratch, values, deadline);
                is_done.map_err(|error| MapError::NotConverged { side, error })
            }
            Stage::Disk(_) => Ok(true),
            Stage::Location => {
                let side = run.mapped();
                let Some([mapped, other]) = self.surfaces(side) else { return Ok(true) };
                Ok(self.through_disk.advance((&mapped, side), &other, run.renewed(), deadline))
            }
        }
    }

    fn match_boundaries(&mut self, run: &mut Run) {
        let start = Instant::now();
        let side = run.mapped();
        let measures = PerSide::from_fn(|side| {
            let MapSide { prepared, measured, .. } = &self.sides[side];
            (&**prepared, measured.coming_measure(run.changes[side].renewal()))
        });
        match_measures(measures[side].1, measures[side.other()].1, &mut self.coming);
        if measures.iter().all(|(_, (_, measure))| measure.is_sharp()) {
            run.far = far_anchors(measures);
            self.coming.match_far(&run.far, side);
        }
        run.timings.matching += start.elapsed().as_secs_f64() * 1e3;
    }

    /// Starts computing the images of all vertices in the other domain.
    fn begin_extension(&mut self, side: Side) {
        if let Some(domain) = self.sides[side.other()].prepared.domain() {
            let boundary = self.coming.images(domain.samples());
            self.sides[side].prepared.begin_extension(boundary, &mut self.extension_scratch);
        }
    }

    /// The mapped side and the other one, if both are surfaces.
    fn surfaces(&self, mapped: Side) -> Option<[Arc<MeshedSurface>; 2]> {
        let surface = |side: Side| self.sides[side].prepared.surface().map(Arc::clone);
        Some([surface(mapped)?, surface(mapped.other())?])
    }
}
