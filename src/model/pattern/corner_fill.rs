//! The triangles of a mapped surface in the plane, with those that fill the outline's corners.
//!
//! The images of boundary edges cut the corners off. Where triangles are painted one by one, each gap has the color of the
//! triangle beside it; saved files divide the edges instead.

use crate::conformal::{PreparedSide, Side};
use crate::geometry::DVec2;
use crate::model::{Model, shown::Shown};
use crate::render::CellCode;
use std::sync::{Arc, Weak};

/// The triangles with the fill; empty where there is no surface over an outline with corners.
#[derive(Debug, Default)]
pub struct CornerFill {
    /// The outline whose corners are known.
    outline: Weak<PreparedSide>,
    corners: Vec<DVec2>,
    /// The images of the map that the fill is of, as counted by the model.
    generation: Option<u64>,
    positions: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
    /// The triangle whose color each triangle of the fill has.
    parents: Vec<u32>,
    codes: Vec<CellCode>,
}

impl CornerFill {
    /// The number of triangles that fill corners.
    pub fn count(&self) -> usize {
        self.parents.len()
    }

    /// The vertices, with three for each corner.
    pub fn positions(&self) -> &[DVec2] {
        &self.positions
    }

    /// The surface's triangles, and those at the corners.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The codes of all triangles.
    pub fn codes(&self) -> &[CellCode] {
        &self.codes
    }

    /// The same, for an upload that pads them.
    pub fn codes_mut(&mut self) -> &mut Vec<CellCode> {
        &mut self.codes
    }

    /// Brings the triangles up to date with the map; `codes` are those of the surface's.
    pub fn update(&mut self, model: &Model, map: Option<Shown<'_>>, codes: &[CellCode], is_recolored: bool) {
        let Some(map) = map.filter(|map| map.planar.is_none() && !map.is_through_disk) else {
            return *self = Self::default();
        };
        let is_moved = self.generation != Some(model.generation());
        if is_moved {
            self.generation = Some(model.generation());
            self.find(model, map);
        }
        if is_moved || is_recolored {
            let own = map.triangles.len().min(codes.len());
            self.codes.clear();
            self.codes.extend_from_slice(&codes[..own]);
            self.codes.extend(self.parents.iter().filter_map(|parent| codes.get(*parent as usize)));
        }
    }

    fn find(&mut self, model: &Model, map: Shown<'_>) {
        self.know_corners(model, map.mapped_side().other());
        self.positions.clear();
        self.triangles.clear();
        self.parents.clear();
        let cut_off = model.map().and_then(|map| map.cut_off(&self.corners)).unwrap_or_default();
        if cut_off.is_empty() {
            return;
        }
        self.positions.extend_from_slice(map.images);
        self.triangles.extend_from_slice(map.triangles);
        for (triangle, parent) in cut_off {
            let first = self.positions.len() as u32;
            self.positions.extend(triangle);
            self.triangles.push([first, first + 1, first + 2]);
            self.parents.push(parent);
        }
    }

    fn know_corners(&mut self, model: &Model, side: Side) {
        let outline = model.prepared(side).map_or_else(Weak::new, Arc::downgrade);
        if !self.outline.ptr_eq(&outline) {
            self.corners = model.session().domain(side).outline.corner_places();
            self.outline = outline;
        }
    }
}
