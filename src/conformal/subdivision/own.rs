//! A map between finer meshes, at the vertices of the sides' own ones, and its errors.

use super::{Cuts, Subdivided, finer};
use crate::conformal::map_side::MapSide;
use crate::conformal::{ConformalMap, Constraints, MapError, MapSettings, PerSide, PreparedSide, Side};
use std::sync::Arc;

/// The map from which that at the own vertices is taken.
#[derive(Debug)]
pub struct Finest {
    pub map: ConformalMap,
    pub cuts: PerSide<Cuts>,
}

impl ConformalMap {
    /// The map under `constraints` between the sides' own meshes, computed on their finest ones: measures, images and all
    /// else are at the own vertices.
    ///
    /// Errors: as [`Self::new`].
    pub fn subdivided(
        sides: &PerSide<Subdivided>,
        constraints: &Constraints,
        settings: MapSettings,
    ) -> Result<Self, MapError> {
        let [source, target] = Side::BOTH.map(|side| Arc::clone(sides[side].finest()));
        let map = Self::new(source, target, &sides.finest(constraints), settings)?;
        let is_cut = sides.iter().any(|(_, side)| side.is_cut());
        Ok(if is_cut { map.at_own_vertices(sides, constraints) } else { map })
    }

    /// The map on the finest meshes, if this one is [taken](Self::subdivided) from it; else this one.
    pub fn finest(&self) -> &Self {
        self.finest.as_ref().map_or(self, |finest| &finest.map)
    }

    fn at_own_vertices(self, sides: &PerSide<Subdivided>, constraints: &Constraints) -> Self {
        let mapped = self.mapped_side();
        let cuts = PerSide::from_fn(|side| sides[side].cuts);
        let own = PerSide::from_fn(|side| sides[side].own());
        let [source, target] = Side::BOTH.map(|side| Arc::clone(own[side]));
        let mut map = Self::unmapped(source, target);
        for side in Side::BOTH {
            let constraint = (constraints.points[side], constraints.anchors[side]);
            map.sides[side] = MapSide::on_own_mesh(own[side], &self.sides[side], constraint, cuts[side]);
        }
        map.correspondence = self.correspondence.at_own_vertices(own[mapped].boundary_count(), cuts, mapped);
        if self.is_through_disk() {
            let [here, there] =
                [vertices(own[mapped], cuts[mapped]), vertices(own[mapped.other()], cuts[mapped.other()])];
            map.through_disk.images = self.through_disk.images.at_own_vertices(&here, cuts[mapped.other()]);
            for (side, vertices) in [(mapped, here), (mapped.other(), there)] {
                let places = self.through_disk.disks[side].places();
                map.through_disk.disks[side].places_mut().extend(vertices.into_iter().map(|v| places[v]));
            }
        } else {
            map.images = vertices(own[mapped], cuts[mapped]).into_iter().map(|v| self.images[v]).collect();
        }
        (map.settings, map.timings) = (self.settings, self.timings);
        map.finest = Some(Box::new(Finest { map: self, cuts }));
        map
    }

    /// Keeps the estimate of the errors that comparing the meshes before the last cut with the finest ones gives; a side
    /// that is not cut is compared with the one in `others`. False if the maps cannot be compared.
    ///
    /// Errors: as [`Self::new`].
    pub fn compare_subdivided(
        &mut self,
        sides: &PerSide<Subdivided>,
        others: &PerSide<Arc<PreparedSide>>,
    ) -> Result<bool, MapError> {
        let Some(constraints) = self.constraints() else { return Ok(false) };
        let cuts = PerSide::from_fn(|side| sides[side].cuts_before());
        let [source, target] = Side::BOTH.map(|side| Arc::clone(sides[side].before()));
        let coarse = Self::new(source, target, &finer(&constraints, cuts), self.settings)?;
        let finest = |side: Side| Arc::clone(if sides[side].is_cut() { sides[side].finest() } else { &others[side] });
        let Some(fine) = coarse.on_finer(&PerSide::from_fn(finest))? else { return Ok(false) };
        let found = coarse.differences_from(&fine, PerSide::from_fn(|side| cuts[side].stride()));
        self.compared = found.map(Box::new);
        Ok(self.compared.is_some())
    }
}

/// The numbers of the own vertices in the mesh that is cut.
fn vertices(own: &PreparedSide, cuts: Cuts) -> Vec<usize> {
    (0..own.vertex_count()).map(|v| cuts.vertex(v, own.boundary_count())).collect()
}
