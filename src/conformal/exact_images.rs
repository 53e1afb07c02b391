//! The exact images of a mesh's interior vertices, computed in slices so that a large mesh does not block a frame.
//!
//! Boundary vertices keep their images, and so do interior ones that lie on the curve or beyond it, next to a concave
//! part of it which the mesh's edges cut off.

use super::{ConformalMap, SlicedInterior};
use crate::geometry::DVec2;
use crate::laplace::Deadline;

/// The progress of replacing harmonic images by exact ones.
#[derive(Debug)]
pub(super) struct ExactImages {
    interior: SlicedInterior,
    /// The first vertex that is not replaced yet.
    next: usize,
}

impl ExactImages {
    /// Begins with the first interior vertex of the mapped side; `None` if a side has finite elements.
    pub fn begin(map: &ConformalMap) -> Option<Self> {
        let side = map.mapped_side();
        let next = map.domain(side)?.samples().len();
        Some(Self { interior: map.begin_interior(side)?, next })
    }

    /// Replaces `images` until `deadline`, at least one; returns whether all are replaced.
    pub fn advance(&mut self, map: &ConformalMap, images: &mut [DVec2], deadline: Deadline) -> bool {
        let Some(domain) = map.domain(map.mapped_side()) else { return true };
        if !self.interior.advance(map, deadline) {
            return false;
        }
        let vertices = domain.mesh().vertices();
        while self.next < images.len() {
            if let Some(exact) = self.interior.evaluate(vertices[self.next]) {
                images[self.next] = exact.value;
            }
            self.next += 1;
            if deadline.is_over() {
                break;
            }
        }
        self.next == images.len()
    }

    /// How many vertices have their final images.
    pub fn done(&self) -> usize {
        if self.interior.is_made() { self.next } else { 0 }
    }
}
