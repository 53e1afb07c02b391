//! The state of the two pictures: the cameras of each side, the texture's image, and the GPU's uploads.

use super::cells::CellUploads;
use super::gpu::Gpu;
use super::surface::OrbitView;
use super::view::View;
use crate::conformal::PerSide;
use crate::model::{PointedImage, ProbeImage};
use image::RgbaImage;
use std::sync::Arc;

/// An image that can be the texture.
pub struct TextureImage {
    /// The file's name.
    pub name: String,
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
    /// The map at the point under the pointer.
    pub pointed: Option<PointedImage>,
    /// The image of the probe.
    pub probe: Option<ProbeImage>,
    /// The image that was opened last.
    pub image: Option<TextureImage>,
}
