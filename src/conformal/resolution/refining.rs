//! The refinement of a map in steps: its meshes can be prepared elsewhere, the rest is done within a time limit.
//!
//! [`ConformalMap::refined`] takes the same steps without a pause, so the result is the same to the last bit.

use super::straightened::Straightening;
use super::{Resampled, ResolveError, ResolvedBoundary};
use crate::conformal::{ConformalMap, Constraints, MapError, PreparedSide};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use std::sync::Arc;

/// A refinement in progress. Of the map that it began with, every call needs the same.
#[derive(Debug)]
pub struct Refining {
    step: Step,
    /// The number of samples and the default point of the mapped domain before.
    coarse: (usize, DVec2),
    /// The best map so far: that of the first pass, if its triangles flip.
    best: Option<Box<ConformalMap>>,
}

/// What comes next.
#[derive(Debug)]
enum Step {
    /// A mesh with this boundary is needed; in the second pass, with the map whose measures it is made for.
    Mesh { wanted: Box<Resampled>, boundary: Arc<ResolvedBoundary>, measured: Option<Box<ConformalMap>> },
    /// The images of the vertices.
    Extend(Box<ConformalMap>),
    /// Images next to corners.
    Straighten(Box<ConformalMap>, Straightening),
    /// The measures on the refined mesh, for a second pass.
    Remeasure(Box<ConformalMap>, Constraints),
    /// Nothing.
    Done,
}

impl Refining {
    /// The refinement of `map`, which begins with a mesh; `None` where there is none to make, see
    /// [`ResolvedBoundary::of`]. Cost O(m log m).
    pub fn new(map: &ConformalMap) -> Option<Self> {
        let coarse = map.mapped().domain()?;
        let coarse = (coarse.samples().len(), coarse.default_point());
        Some(Self { step: mesh_for(map, coarse)?, coarse, best: None })
    }

    /// The boundary of the mesh that is needed next; `None` if something else comes next.
    pub fn wanted(&self) -> Option<&Resampled> {
        if let Step::Mesh { wanted, .. } = &self.step { Some(wanted) } else { None }
    }

    /// Whether [`Self::finish`] has the result.
    pub fn is_done(&self) -> bool {
        matches!(self.step, Step::Done)
    }

    /// Continues the refinement of `map` with the mesh that was [wanted](Self::wanted).
    ///
    /// Errors: as [`ConformalMap::update`].
    pub fn take_mesh(&mut self, map: &ConformalMap, mesh: PreparedSide) -> Result<(), ResolveError> {
        let step = std::mem::replace(&mut self.step, Step::Done);
        let Step::Mesh { boundary, measured, .. } = step else { return Ok(()) };
        let resolved = measured.as_deref().unwrap_or(map).resolved(boundary, mesh, map.settings);
        self.go_to(resolved.map(|mut resolved| {
            resolved.begin_resolved_extension();
            Step::Extend(Box::new(resolved))
        }))
    }

    /// Ends the refinement where a mesh cannot be prepared; returns whether there is a map, that of the first pass.
    pub fn go_on_without_mesh(&mut self) -> bool {
        self.step = Step::Done;
        self.best.is_some()
    }

    /// Continues until another mesh is wanted or all is done (true), or until `deadline` has passed; it is checked every
    /// few milliseconds.
    ///
    /// Errors: as [`ConformalMap::update`].
    pub fn advance(&mut self, deadline: Deadline) -> Result<bool, ResolveError> {
        while !matches!(self.step, Step::Mesh { .. } | Step::Done) {
            let step = std::mem::replace(&mut self.step, Step::Done);
            let next = self.next(step, deadline);
            self.go_to(next)?;
            if deadline.is_over() {
                break;
            }
        }
        Ok(matches!(self.step, Step::Mesh { .. } | Step::Done))
    }

    /// The refined map; `None` before [`Self::is_done`], and after an error.
    pub fn finish(self) -> Option<ConformalMap> {
        self.best.filter(|_| matches!(self.step, Step::Done)).map(|map| *map)
    }

    /// A second pass that fails leaves the map of the first one.
    fn go_to(&mut self, next: Result<Step, MapError>) -> Result<(), ResolveError> {
        match next {
            Ok(next) => self.step = next,
            Err(_) if self.best.is_some() => self.step = Step::Done,
            Err(error) => return Err(error.into()),
        }
        Ok(())
    }

    fn next(&mut self, step: Step, deadline: Deadline) -> Result<Step, MapError> {
        Ok(match step {
            Step::Extend(mut map) => {
                if !map.advance_resolved_extension(deadline)? {
                    return Ok(Step::Extend(map));
                }
                let straightening = Straightening::new(&map);
                Step::Straighten(map, straightening)
            }
            Step::Straighten(mut map, mut straightening) => {
                if straightening.advance(&mut map)? {
                    map.begin_refinement();
                    return Ok(self.end_pass(map));
                }
                Step::Straighten(map, straightening)
            }
            Step::Remeasure(mut map, constraints) => {
                let direction = map.direction();
                if !map.advance(&constraints, direction.into(), deadline)? {
                    return Ok(Step::Remeasure(map, constraints));
                }
                match mesh_for(&map, self.coarse) {
                    Some(Step::Mesh { wanted, boundary, .. }) => Step::Mesh { wanted, boundary, measured: Some(map) },
                    _ => Step::Done,
                }
            }
            other => other,
        })
    }

    /// Keeps the better map; begins a second pass if the first one's triangles flip.
    fn end_pass(&mut self, map: Box<ConformalMap>) -> Step {
        if let Some(first) = self.best.take() {
            self.best = Some(if map.folds() < first.folds() { map } else { first });
            return Step::Done;
        }
        let again = map.is_folded().then(|| map.unmeasured()).flatten();
        self.best = Some(map);
        again.map_or(Step::Done, |(map, constraints)| Step::Remeasure(Box::new(map), constraints))
    }
}

fn mesh_for(measured: &ConformalMap, (coarse_count, default_point): (usize, DVec2)) -> Option<Step> {
    let boundary = ResolvedBoundary::of(measured)?;
    let wanted = Box::new(Resampled { samples: boundary.samples().clone(), coarse_count, default_point });
    Some(Step::Mesh { wanted, boundary: Arc::new(boundary), measured: None })
}
