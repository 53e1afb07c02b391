//! Keeps the triangles on the GPU as the model has them: uploaded when they are
//! shown, and only what changed since.
//!
//! The mapped mesh is drawn on both sides: on its own with its vertices, on the
//! other at their images. A surface's own side is a viewport in space, with buffers of its own.

use super::colouring::{self, ColourScale};
use super::gpu::Gpu;
use super::model::Model;
use crate::conformal::Side;
use crate::render::{CellCode, CellStyle, ColourMap, StrokeStyle};
use crate::session::Colouring;

/// What has been uploaded, by the model's counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Uploaded {
    mesh: u64,
    images: u64,
}

/// The triangles' state on the screen.
#[derive(Debug, Default)]
pub struct Cells {
    uploaded: Uploaded,
    /// The measurement and the colouring that `scale` and `codes` are of.
    coloured: Option<(u64, Colouring)>,
    codes: Vec<CellCode>,
    /// The codes are others than the uploaded ones.
    recoloured: bool,
    scale: Option<ColourScale>,
    style: Option<CellStyle>,
}

impl Cells {
    /// How the triangles are shown; `None` where there is nothing to show but the texture.
    pub fn style(&self) -> Option<CellStyle> {
        self.style
    }

    /// The codes of the mapped mesh's triangles.
    pub fn codes(&self) -> &[CellCode] {
        &self.codes
    }

    /// What the colours mean, where they are not the texture's.
    pub fn scale(&self) -> Option<&ColourScale> {
        self.scale.as_ref()
    }

    /// Brings colours and uploads up to date with the model.
    pub fn update(&mut self, model: &Model, gpu: Option<&Gpu>, pixels_per_point: f32) {
        self.colour(model);
        self.style = self.choose_style(model, pixels_per_point);
        let Some(gpu) = gpu else { return };
        if self.style.is_some() {
            self.upload(model, gpu);
        }
        gpu.set_cell_style(self.style);
    }

    /// Renews scale and codes when there is a new measurement or another colouring.
    fn colour(&mut self, model: &Model) {
        let session = model.session();
        let wanted = (model.measured_generation(), session.colouring);
        if self.coloured == Some(wanted) {
            return;
        }
        self.coloured = Some(wanted);
        let triangles = model.triangles();
        let direction = model.shown().map_or(session.direction, |map| map.direction);
        // what fills a hole is not measured, and grey
        let repaired = model.surface_map().filter(|map| !map.surface().surface.repairs.is_empty());
        let given: Option<Vec<_>> = repaired.map(|map| map.given(triangles).copied().collect());
        let measured = given.as_deref().unwrap_or(triangles);
        self.scale = ColourScale::new(session.colouring, direction, measured, self.scale.as_ref());
        colouring::codes(self.scale.as_ref(), triangles, &mut self.codes);
        if let Some(map) = repaired {
            colouring::grey_added(&map.surface().surface.triangle_origins, &mut self.codes);
        }
        self.recoloured = true;
    }

    fn choose_style(&self, model: &Model, pixels_per_point: f32) -> Option<CellStyle> {
        let session = model.session();
        let map = self.scale.as_ref().map(|scale| scale.map);
        let light = map == Some(ColourMap::Cividis);
        let wire = session.wireframe.then(|| StrokeStyle::wire(light, pixels_per_point));
        let marks = model.quality().is_some_and(|quality| quality.flipped > 0);
        let shown = model.shown().is_some() && (map.is_some() || wire.is_some() || marks);
        shown.then_some(CellStyle { map, wire, marks, pixels_per_point })
    }

    fn upload(&mut self, model: &Model, gpu: &Gpu) {
        let Some(map) = model.shown() else { return };
        let wanted = Uploaded { mesh: model.mesh_generation(), images: model.generation() };
        let another_mesh = self.uploaded.mesh != wanted.mesh;
        for side in Side::BOTH {
            let is_mapped = side == map.mapped_side();
            let Some(positions) = map.places(side) else { continue };
            if another_mesh {
                gpu.upload_cells(side, positions, map.triangles);
            } else if !is_mapped && self.uploaded.images != wanted.images {
                gpu.move_cells(side, positions);
            }
        }
        if std::mem::take(&mut self.recoloured) || another_mesh {
            gpu.colour_cells(&mut self.codes);
        }
        self.uploaded = wanted;
    }
}
