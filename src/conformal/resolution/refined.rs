//! The refinement of a map: the resolved boundary, its mesh, the map on it, and all again where triangles flip.

use super::straightened::FOLDS;
use super::{Refining, ResolveError, ResolvedBoundary};
use crate::conformal::{ConformalMap, Constraints, PrepareSettings, Side, Stage};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use std::sync::Arc;

impl ConformalMap {
    /// The map on a mesh refined for it, which [`ResolvedBoundary`] describes; `None` where that does not exist.
    /// `settings` are those of the mapped domain. Takes as long as two to three preparations of it.
    ///
    /// Where triangles still flip, the refinement is repeated from the measure on the refined mesh: with a limb in a
    /// re-entrant corner of nearly 360°, the images fold if the measure decays 5 % too fast along the limb, as it does
    /// on a mesh of four edges across. The better one of both maps is returned.
    pub fn refined(
        &self,
        settings: &PrepareSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Option<Self>, ResolveError> {
        let Some(mut refining) = Refining::new(self) else { return Ok(None) };
        while let Some(wanted) = refining.wanted() {
            match wanted.prepare(settings, progress) {
                Ok(mesh) => refining.take_mesh(self, mesh)?,
                Err(error) if !refining.go_on_without_mesh() => return Err(error.into()),
                Err(_) => {}
            }
            refining.advance(Deadline::NEVER)?;
        }
        Ok(refining.finish())
    }

    /// Whether this map is a refinement of `full`: under the same constraints and settings, into the same side.
    pub fn is_refinement_of(&self, full: &Self) -> bool {
        let other = self.mapped_side().other();
        let is_same = self.settings == full.settings && self.constraints() == full.constraints();
        self.resolution.is_some() && is_same && Arc::ptr_eq(self.side(other), full.side(other))
    }

    /// A map on the same meshes, to be updated to the constraints of this one so that it has the measures of these
    /// meshes; `None` before the first update.
    pub(super) fn unmeasured(&self) -> Option<(Self, Constraints)> {
        let [source, target] = Side::BOTH.map(|side| Arc::clone(self.side(side)));
        let mut map = Self::unmapped(source, target);
        map.settings.direction = self.direction();
        Some((map, self.constraints()?))
    }

    /// Whether so many triangles are flipped that [`Self::refined`] repeats the refinement.
    pub(crate) fn is_folded(&self) -> bool {
        self.folds() > FOLDS
    }

    /// The share of the triangles that are flipped.
    pub(crate) fn folds(&self) -> f64 {
        f64::from(self.quality().flipped) / self.mapped().triangles().len().max(1) as f64
    }

    /// The parts of a side's domain that the images do not cover because their preimages are too small.
    pub fn unresolved(&self, side: Side) -> &[Vec<DVec2>] {
        self.resolution().filter(|_| side != self.mapped_side()).map_or(&[], ResolvedBoundary::cuts)
    }

    /// The outline of a side's domain as it is drawn: its samples, and on the side of the images also these. Empty for
    /// a surface.
    pub fn drawn_outline(&self, side: Side) -> &[DVec2] {
        match self.resolution().filter(|_| side != self.mapped_side()) {
            Some(resolution) => resolution.outline(),
            None => self.domain(side).map_or(&[], |domain| domain.samples().points()),
        }
    }

    /// The resolved boundary of the mapped mesh, if it was refined for this map and the map has not changed since.
    pub fn resolution(&self) -> Option<&ResolvedBoundary> {
        self.resolution.as_deref()
    }
}
