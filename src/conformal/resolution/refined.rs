//! The refinement of a map: the resolved boundary, its mesh, the map on it, and all again where triangles flip.

use super::straightened::FOLDS;
use super::{ResolveError, ResolvedBoundary, prepare_resampled};
use crate::conformal::{ConformalMap, MapError, PrepareSettings, Side, Stage};
use crate::geometry::DVec2;
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
        let Some(first) = self.refined_from(self, settings, progress)? else { return Ok(None) };
        if !first.is_folded() {
            return Ok(Some(first));
        }
        // a second pass that fails, or is no better, leaves the first one
        let measured = first.remeasured().ok().flatten();
        let second = measured.and_then(|measured| self.refined_from(&measured, settings, progress).ok().flatten());
        Ok(Some(second.filter(|second| second.folds() < first.folds()).unwrap_or(first)))
    }

    /// The map refined for the measures of `measured`, a map under the same constraints.
    fn refined_from(
        &self,
        measured: &Self,
        settings: &PrepareSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Option<Self>, ResolveError> {
        let (Some(boundary), Some(coarse)) = (ResolvedBoundary::of(measured), self.mapped().domain()) else {
            return Ok(None);
        };
        let refined = prepare_resampled(&boundary.resampled(coarse), settings, progress)?;
        Ok(Some(measured.resolved(Arc::new(boundary), refined, self.settings)?))
    }

    /// The same map on the same meshes, with the measures of these meshes; `None` before the first update.
    pub(crate) fn remeasured(&self) -> Result<Option<Self>, MapError> {
        let Some(constraints) = self.constraints() else { return Ok(None) };
        let [source, target] = Side::BOTH.map(|side| Arc::clone(self.side(side)));
        Self::new(source, target, &constraints, self.direction().into()).map(Some)
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
