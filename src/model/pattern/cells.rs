//! The colors and the style of the mapped mesh's triangles.

use super::colouring::{self, ColourScale};
use super::corner_fill::CornerFill;
use crate::conformal::{MeshedSurface, Side};
use crate::geometry::DVec2;
use crate::model::{Model, shown::Shown};
use crate::render::{CellCode, CellStyle, ColourMap, StrokeStyle};
use crate::session::Colouring;
use std::sync::Arc;

/// The triangles' colors.
#[derive(Debug, Default)]
pub struct Cells {
    /// The measurement and the coloring that `scale` and `codes` are of.
    colored: Option<(u64, Colouring)>,
    codes: Vec<CellCode>,
    /// Whether the codes have changed since [`Self::take_recoloured`] was last called.
    recolored: bool,
    scale: Option<ColourScale>,
    style: Option<CellStyle>,
    fill: CornerFill,
}

/// What is drawn of the mapped mesh in the plane.
#[derive(Debug, Clone, Copy)]
pub struct PlanarCells<'a> {
    /// The vertices.
    pub positions: &'a [DVec2],
    /// The triangles.
    pub triangles: &'a [[u32; 3]],
    /// Their codes.
    pub codes: &'a [CellCode],
}

impl Cells {
    /// How the triangles are shown; `None` if only the texture is shown.
    pub fn style(&self) -> Option<CellStyle> {
        self.style
    }

    /// The codes of the mapped mesh's triangles.
    pub fn codes(&self) -> &[CellCode] {
        &self.codes
    }

    /// The codes of the triangles on a side of the map, with those at corners, for an upload that pads them.
    pub fn codes_mut(&mut self, is_mapped: bool) -> &mut Vec<CellCode> {
        if is_mapped || self.fill.count() == 0 { &mut self.codes } else { self.fill.codes_mut() }
    }

    /// How many triangles fill corners of the outline that a surface is mapped to.
    pub fn filled_corners(&self) -> usize {
        self.fill.count()
    }

    /// The mapped mesh on a side in the plane, with the outline's corners filled; `None` on a surface.
    pub fn in_plane<'a>(&'a self, map: &Shown<'a>, side: Side) -> Option<PlanarCells<'a>> {
        if side != map.mapped_side() && self.fill.count() > 0 {
            let fill = &self.fill;
            return Some(PlanarCells { positions: fill.positions(), triangles: fill.triangles(), codes: fill.codes() });
        }
        let positions = map.places(side)?;
        Some(PlanarCells { positions, triangles: map.triangles, codes: &self.codes })
    }

    /// The scale of the colors; `None` if the texture is shown.
    pub fn scale(&self) -> Option<&ColourScale> {
        self.scale.as_ref()
    }

    /// Whether the codes have changed since the last call.
    pub fn take_recoloured(&mut self) -> bool {
        std::mem::take(&mut self.recolored)
    }

    /// Brings colors and style up to date with the model.
    pub fn update(&mut self, model: &Model, pixels_per_point: f32) {
        self.colour(model);
        self.style = self.choose_style(model, pixels_per_point);
        let map = model.shown().filter(|_| self.style.is_some());
        self.fill.update(model, map, &self.codes, self.recolored);
    }

    /// Renews scale and codes when there is a new measurement or another coloring.
    fn colour(&mut self, model: &Model) {
        let session = model.session();
        let wanted = (model.measured_generation(), session.colouring());
        if self.colored == Some(wanted) {
            return;
        }
        self.colored = Some(wanted);
        let triangles = model.triangles();
        let direction = model.shown().map_or(session.direction(), |map| map.direction);
        // what fills a hole is not measured, and gray
        let is_repaired = |surface: &Arc<MeshedSurface>| !surface.surface().repairs().is_empty();
        let repaired = model.map().filter(|map| map.mapped().surface().is_some_and(is_repaired));
        let given: Option<Vec<_>> = repaired.map(|map| map.given(triangles).copied().collect());
        let measured = given.as_deref().unwrap_or(triangles);
        self.scale = ColourScale::new(session.colouring(), direction, measured, self.scale.as_ref());
        colouring::codes(self.scale.as_ref(), triangles, &mut self.codes);
        if let Some(surface) = repaired.and_then(|map| map.mapped().surface()) {
            colouring::grey_added(surface.surface().origins_of_triangles(), &mut self.codes);
        }
        self.codes.truncate(model.shown().map_or(0, |map| map.triangles.len()));
        self.recolored = true;
    }

    fn choose_style(&self, model: &Model, pixels_per_point: f32) -> Option<CellStyle> {
        let session = model.session();
        let map = self.scale.as_ref().map(|scale| scale.map);
        let light = map == Some(ColourMap::Cividis);
        let wire = session.wireframe().then(|| StrokeStyle::wire(light, pixels_per_point));
        let marks = model.quality().is_some_and(|quality| quality.flipped > 0);
        let shown = model.shown().is_some() && (map.is_some() || wire.is_some() || marks);
        shown.then_some(CellStyle { map, wire, marks, pixels_per_point })
    }
}
