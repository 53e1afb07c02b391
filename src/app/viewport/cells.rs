//! Keeps the triangles on the GPU in step with the model: uploaded only while they are
//! shown, and only what has changed.
//!
//! The mapped mesh is drawn on both sides: with its vertices on its own side, with their
//! images on the other. The viewport of a surface has separate buffers; between two surfaces the mapped mesh is drawn
//! on its own side only.

use crate::app::viewport::gpu::Gpu;
use crate::conformal::Side;
use crate::model::Model;
use crate::model::pattern::cells::{Cells, PlanarCells};
use crate::model::pattern::colouring::ColourScale;
use crate::render::CellStyle;

/// The generations of the uploaded mesh and images, as counted by the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Uploaded {
    mesh: u64,
    images: u64,
    filled_corners: usize,
}

/// The triangles' colors, and what of them has been uploaded.
#[derive(Debug, Default)]
pub struct CellUploads {
    cells: Cells,
    uploaded: Uploaded,
}

impl CellUploads {
    /// How the triangles are shown; `None` where only the texture is shown.
    pub fn style(&self) -> Option<CellStyle> {
        self.cells.style()
    }

    /// The scale of the colors; `None` where the texture is shown.
    pub fn scale(&self) -> Option<&ColourScale> {
        self.cells.scale()
    }

    /// Brings colors and uploads up to date with the model.
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
        let filled_corners = self.cells.filled_corners();
        let wanted = Uploaded { mesh: model.mesh_generation(), images: model.generation(), filled_corners };
        let known = self.uploaded;
        let another_mesh = (known.mesh, known.filled_corners) != (wanted.mesh, wanted.filled_corners);
        for side in Side::BOTH {
            let is_mapped = side == map.mapped_side();
            let Some(PlanarCells { positions, triangles, .. }) = self.cells.in_plane(&map, side) else { continue };
            if another_mesh {
                gpu.upload_cells(side, positions, triangles);
            } else if !is_mapped && known.images != wanted.images {
                gpu.move_cells(side, positions);
            }
        }
        if self.cells.take_recoloured() || another_mesh {
            let mapped = map.mapped_side();
            gpu.colour_surface(mapped, self.cells.codes_mut(true));
            for side in Side::BOTH {
                gpu.colour_cells(side, self.cells.codes_mut(side == mapped));
            }
        }
        self.uploaded = wanted;
    }
}
