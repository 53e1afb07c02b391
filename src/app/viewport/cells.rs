//! Keeps the triangles on the GPU as the model has them: uploaded when they are
//! shown, and only what changed since.
//!
//! The mapped mesh is drawn on both sides: on its own with its vertices, on the
//! other at their images. A surface's own side is a viewport in space, with buffers of its own.

use crate::app::viewport::gpu::Gpu;
use crate::conformal::Side;
use crate::model::Model;
use crate::model::pattern::cells::Cells;
use crate::model::pattern::colouring::ColourScale;
use crate::render::CellStyle;

/// What has been uploaded, by the model's counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Uploaded {
    mesh: u64,
    images: u64,
}

/// The triangles' state on the screen.
#[derive(Debug, Default)]
pub struct CellUploads {
    cells: Cells,
    uploaded: Uploaded,
}

impl CellUploads {
    /// How the triangles are shown; `None` where there is nothing to show but the texture.
    pub fn style(&self) -> Option<CellStyle> {
        self.cells.style()
    }

    /// What the colours mean, where they are not the texture's.
    pub fn scale(&self) -> Option<&ColourScale> {
        self.cells.scale()
    }

    /// Brings colours and uploads up to date with the model.
    pub fn update(&mut self, model: &Model, gpu: Option<&Gpu>, pixels_per_point: f32) {
        self.cells.update(model, pixels_per_point);
        let Some(gpu) = gpu else { return };
        if self.cells.style().is_some() {
            self.upload(model, gpu);
        }
        gpu.set_cell_style(self.cells.style());
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
        if self.cells.take_recoloured() || another_mesh {
            gpu.colour_cells(self.cells.codes_mut());
        }
        self.uploaded = wanted;
    }
}
