//! The two pictures: how each side is seen in the plane and in space, the texture's image, and what is uploaded of them.

use super::cells::CellUploads;
use super::gpu::Gpu;
use super::surface::OrbitView;
use super::view::View;
use crate::conformal::PerSide;
use image::RgbaImage;
use std::sync::Arc;

/// An image that can be the texture.
pub struct TextureImage {
    /// The file's.
    pub name: String,
    /// As the GPU has them, for pictures that are exported.
    pub pixels: Arc<RgbaImage>,
}

/// The state of the pictures that no session carries.
#[derive(Default)]
pub struct Pictures {
    /// `None` where nothing can be drawn by a GPU: then the pictures have their outlines only.
    pub gpu: Option<Gpu>,
    /// How each side is seen while it is planar. A surface's side has one too: it gives the place on the screen.
    pub views: PerSide<View>,
    /// How each side is seen while it is a surface.
    pub orbits: PerSide<OrbitView>,
    pub cells: CellUploads,
    /// The last image that was opened.
    pub image: Option<TextureImage>,
}
