//! The state of the two pictures: the cameras of each side, the texture's image, and the GPU's uploads.

use super::cells::CellUploads;
use super::gpu::Gpu;
use super::surface::OrbitView;
use super::uv::UvGrid;
use super::view::View;
use crate::conformal::PerSide;
use crate::model::{PointedImage, ProbeImage};
use crate::session::file::Attachment;
use image::RgbaImage;
use std::sync::Arc;

/// An image that can be the texture.
pub struct TextureImage {
    /// The file, which is saved and kept with the session.
    pub file: Attachment,
    /// The same pixels as on the GPU, for exported pictures.
    pub pixels: Arc<RgbaImage>,
}

/// The state of the pictures that is not part of a session.
#[derive(Default)]
pub struct Pictures {
    /// `None` without a graphics device: then the meshes are not drawn.
    pub gpu: Option<Gpu>,
    /// The planar cameras, with the viewports' rectangles; a side that is a surface uses the rectangle only.
    pub views: PerSide<View>,
    /// The cameras of sides that are surfaces.
    pub orbits: PerSide<OrbitView>,
    pub cells: CellUploads,
    /// The texture coordinates over the outline of a surface's layout.
    pub uv: UvGrid,
    /// The map at the point under the pointer.
    pub pointed: Option<PointedImage>,
    /// The image of the probe.
    pub probe: Option<ProbeImage>,
    /// The image that was opened last.
    pub image: Option<TextureImage>,
}

impl Pictures {
    /// Draws with another device from now on, to which nothing has been uploaded yet.
    pub fn renew(&mut self, gpu: Option<Gpu>) {
        (self.gpu, self.cells) = (gpu, CellUploads::default());
        if let (Some(gpu), Some(image)) = (&self.gpu, &self.image) {
            let (width, height) = image.pixels.dimensions();
            // it fitted on the former device; on a smaller one the checkerboard of a missing image is shown
            if gpu.set_image(image.pixels.as_raw(), width, height).is_err() {
                self.image = None;
            }
        }
    }
}
