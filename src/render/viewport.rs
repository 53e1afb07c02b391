//! The renderer behind the viewports: uploads, off-screen rendering, the blit.
//!
//! A viewport whose picture has changed is rendered in three passes (mesh and its triangles, multisampled and
//! resolved; the outline's coverage; outline and handles over the picture), then painted into
//! the caller's pass. Nothing is allocated per frame while the sizes stay the same.
//!
//! A viewport index out of range, arrays of the wrong length and
//! inconsistent meshes are refused: the methods return `false` and change nothing.

use super::blit_pass::BlitPass;
use super::cell_pass::{CellBuffers, CellPass};
use super::disc_pass::{DiscBuffers, DiscPass};
use super::drawn::Drawn;
use super::image_texture::{ImageTexture, ImageTextures};
use super::mesh_pass::{MeshBuffers, MeshFrame, MeshPass};
use super::stroke_pass::{StrokeBuffers, StrokePass};
use super::style::linear_color;
use super::surface_viewport::{SurfacePasses, SurfaceViewport};
use super::targets::{Targets, attachment, clamped_size};
use super::{
    CauchyGreenBuffers, CellCode, CellStyle, Detail, Handle, ImageError, MeshFault, Pace, Pattern, PlanarFrame,
    StrokeStyle,
};
use glam::DVec2;

/// Thin pattern lines relative to the outline's stroke.
pub(super) const LINE_TO_STROKE: f32 = 0.7;

/// Geometry of one viewport.
#[derive(Clone, Copy, Debug)]
pub struct MeshGeometry<'a> {
    /// The position at which each vertex is drawn, in the viewport's world.
    pub positions: &'a [DVec2],
    /// The texture coordinates of each vertex, in source coordinates.
    pub texture_coordinates: &'a [DVec2],
    /// Vertex indices of the triangles; either orientation is drawn.
    pub triangles: &'a [[u32; 3]],
}

impl MeshGeometry<'_> {
    /// Ok if there are as many texture coordinates as positions and every
    /// triangle has existing vertices; otherwise the fault. `O(triangles)`.
    pub fn check(&self) -> Result<(), MeshFault> {
        let (count, coordinates) = (self.positions.len(), self.texture_coordinates.len());
        if count != coordinates {
            return Err(MeshFault::Coordinates { positions: count, coordinates });
        }
        match self.triangles.iter().position(|corners| corners.iter().any(|&v| v as usize >= count)) {
            Some(t) => Err(MeshFault::Vertex { triangle: t, corners: self.triangles[t], vertices: count }),
            None => Ok(()),
        }
    }
}

/// Pipelines, and buffers and targets of every viewport.
#[derive(Debug)]
pub struct ViewportRenderer {
    pub(super) samples: u32,
    mesh: MeshPass,
    cells: CellPass,
    stroke: StrokePass,
    pub(super) disc: DiscPass,
    pub(super) blit: BlitPass,
    pub(super) images: ImageTextures,
    pub(super) image: ImageTexture,
    pub(super) viewports: Vec<Viewport>,
    /// Created with the first surface.
    pub(super) surface_passes: Option<SurfacePasses>,
    pub(super) staging: Vec<[f32; 2]>,
}

/// Buffers and targets of one viewport: of a planar mesh and, once it has shown one, of a surface.
#[derive(Debug)]
pub(super) struct Viewport {
    mesh: MeshBuffers,
    cells: CellBuffers,
    cell_style: Option<CellStyle>,
    stroke: StrokeBuffers,
    stroke_style: Option<StrokeStyle>,
    discs: DiscBuffers,
    targets: Option<Targets>,
    drawn: Drawn<PlanarFrame>,
    pub(super) surface: Option<SurfaceViewport>,
}

impl ViewportRenderer {
    /// Pipelines for a target of `target_format` and `viewports` empty viewports, drawn with `samples` samples a
    /// pixel: 1, or [`super::sample_count`].
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        target_format: wgpu::TextureFormat,
        viewports: usize,
        samples: u32,
    ) -> Self {
        let images = ImageTextures::new(device);
        let image = images.blank(device, queue);
        let mesh = MeshPass::new(device, &images.layout, samples);
        let cells = CellPass::new(device, queue, samples);
        let (stroke, disc, blit) =
            (StrokePass::new(device), DiscPass::new(device), BlitPass::new(device, target_format));
        let empty = |_| Viewport {
            mesh: mesh.buffers(device),
            cells: cells.buffers(device),
            cell_style: None,
            stroke: stroke.buffers(device),
            stroke_style: None,
            discs: disc.buffers(device),
            targets: None,
            drawn: Drawn::default(),
            surface: None,
        };
        let viewports = (0..viewports).map(empty).collect();
        let (surface_passes, staging) = (None, Vec::new());
        Self { samples, mesh, cells, stroke, disc, blit, images, image, viewports, surface_passes, staging }
    }

    /// Replaces a viewport's mesh; call it when the topology changes. Buffers
    /// are kept where they are large enough.
    ///
    /// False, and the old mesh stays, for an inconsistent mesh ([`MeshGeometry::check`]).
    pub fn set_mesh(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        viewport: usize,
        geometry: &MeshGeometry,
    ) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.mesh.set(device, queue, &mut self.staging, geometry)
    }

    /// Moves the vertices of the mesh, without reallocation.
    ///
    /// False, and nothing changes, when the count is not the mesh's.
    pub fn set_positions(&mut self, queue: &wgpu::Queue, viewport: usize, positions: &[DVec2]) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.mesh.set_positions(queue, &mut self.staging, positions)
    }

    /// New texture coordinates for the mesh, without reallocation.
    ///
    /// False, and nothing changes, when the count is not the mesh's.
    pub fn set_texture_coordinates(&mut self, queue: &wgpu::Queue, viewport: usize, coordinates: &[DVec2]) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.mesh.set_texture_coordinates(queue, &mut self.staging, coordinates)
    }

    /// Records [`Self::set_positions`] with images that are computed on the GPU.
    ///
    /// False, and nothing changes, when the count is not the mesh's.
    pub fn copy_positions(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        viewport: usize,
        images: &CauchyGreenBuffers,
    ) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.mesh.copy_positions(encoder, images.images(), images.origin())
    }

    /// Records [`Self::set_texture_coordinates`] with images that are computed on the GPU.
    ///
    /// False, and nothing changes, when the count is not the mesh's.
    pub fn copy_texture_coordinates(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        viewport: usize,
        images: &CauchyGreenBuffers,
    ) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.mesh.copy_texture_coordinates(encoder, images.images(), images.origin())
    }

    /// Replaces the triangles that a [`CellStyle`] shows: the mapped mesh, or its image.
    /// Their codes must be set again.
    ///
    /// False, with nothing changed, for an inconsistent mesh; false, with no triangles
    /// left, if they do not fit on the device.
    pub fn set_cells(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        viewport: usize,
        positions: &[DVec2],
        triangles: &[[u32; 3]],
    ) -> bool {
        let geometry = MeshGeometry { positions, texture_coordinates: positions, triangles };
        let Some(viewport) = outdated(&mut self.viewports, viewport).filter(|_| geometry.check().is_ok()) else {
            return false;
        };
        self.cells.set(device, queue, &mut viewport.cells, &mut self.staging, positions, triangles)
    }

    /// Moves the vertices of the triangles of [`Self::set_cells`].
    ///
    /// False, and nothing changes, when the count is not the mesh's.
    pub fn set_cell_positions(&mut self, queue: &wgpu::Queue, viewport: usize, positions: &[DVec2]) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.cells.set_positions(queue, &mut self.staging, positions)
    }

    /// Colors the triangles of [`Self::set_cells`]; `codes` is padded on the way.
    ///
    /// False, and nothing changes, when the count is not the mesh's.
    pub fn set_cell_codes(&mut self, queue: &wgpu::Queue, viewport: usize, codes: &mut Vec<CellCode>) -> bool {
        outdated(&mut self.viewports, viewport).is_some_and(|viewport| viewport.cells.set_codes(queue, codes))
    }

    /// The style of the triangles of [`Self::set_cells`]; `None` hides them.
    pub fn set_cell_style(&mut self, viewport: usize, style: Option<CellStyle>) {
        if let Some(viewport) = self.viewports.get_mut(viewport)
            && viewport.cell_style != style
        {
            viewport.cell_style = style;
            viewport.drawn.outdate();
        }
    }

    /// Replaces the closed outline stroke; fewer than two points remove it.
    pub fn set_boundary(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        viewport: usize,
        points: &[DVec2],
    ) -> bool {
        let Some(viewport) = outdated(&mut self.viewports, viewport) else { return false };
        viewport.stroke.set(device, queue, &mut self.staging, points)
    }

    /// Color and width of the outline stroke, to which pattern lines keep a
    /// fixed proportion; `None`: [`StrokeStyle::themed`] at one pixel per point.
    pub fn set_boundary_style(&mut self, viewport: usize, style: Option<StrokeStyle>) {
        if let Some(viewport) = self.viewports.get_mut(viewport)
            && viewport.stroke_style != style
        {
            viewport.stroke_style = style;
            viewport.drawn.outdate();
        }
    }

    /// Replaces the discs drawn over the outline.
    pub fn set_handles(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, viewport: usize, handles: &[Handle]) {
        if let Some(viewport) = outdated(&mut self.viewports, viewport) {
            viewport.discs.set(device, queue, handles);
        }
    }

    /// Replaces the image of `Pattern::Image`: `width × height` sRGB-encoded
    /// RGBA bytes, straight alpha, first row on top.
    ///
    /// The image covers the source's bounds with its aspect kept. One larger than
    /// the device's textures is scaled down; transparent parts show the paper color.
    pub fn set_image(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        rgba: &[u8],
        width: u32,
        height: u32,
    ) -> Result<(), ImageError> {
        self.image = self.images.load(device, queue, rgba, width, height)?;
        for viewport in &mut self.viewports {
            viewport.drawn.outdate();
            viewport.surface.iter_mut().for_each(SurfaceViewport::outdate);
        }
        Ok(())
    }

    /// Records the rendering of a viewport into its own target, if `frame` or the geometry has changed;
    /// returns the detail recorded, `None` if the picture is still valid.
    ///
    /// Call it once per viewport and submission: the uniform blocks hold one frame.
    /// A size beyond the device's textures is clamped, and `paint` scales the picture.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        viewport: usize,
        frame: &PlanarFrame,
        pace: Pace,
    ) -> Option<Detail> {
        let size_px = clamped_size(device, frame.size_px);
        let detail = self.viewports.get_mut(viewport)?.drawn.due(PlanarFrame { size_px, ..*frame }, pace)?;
        let size_px = detail.size(size_px);
        self.provide_targets(device, viewport, size_px);
        let viewport = &self.viewports[viewport];
        self.write_frame(queue, viewport, frame, size_px, detail);
        if let Some(targets) = &viewport.targets {
            self.record_mesh(encoder, viewport, targets, frame.style.pattern, frame.background);
            self.record_overlay(encoder, viewport, targets);
        }
        Some(detail)
    }

    fn write_frame(
        &self,
        queue: &wgpu::Queue,
        viewport: &Viewport,
        frame: &PlanarFrame,
        size_px: [u32; 2],
        detail: Detail,
    ) {
        let PlanarFrame { style, .. } = frame;
        let camera = &detail.camera(frame.camera);
        let stroke = viewport.stroke_style.unwrap_or_else(|| StrokeStyle::themed(style.dark, 1.0));
        let stroke = detail.stroke(stroke);
        let (image_aspect, line_px) = (self.image.aspect, LINE_TO_STROKE * stroke.width_px);
        viewport.mesh.write_frame(queue, &MeshFrame { camera, size_px, style, image_aspect, line_px });
        if let Some(cells) = viewport.cell_style {
            viewport.cells.write_frame(queue, camera, size_px, &detail.cells(cells));
        }
        viewport.stroke.write_frame(queue, camera, size_px, &stroke);
        viewport.discs.write_frame(queue, camera, size_px, detail.length(1.0));
    }

    /// Whether the picture of a viewport is coarse, to be recorded in full when it no longer changes.
    pub fn is_coarse(&self, viewport: usize) -> bool {
        self.viewports.get(viewport).is_some_and(|viewport| viewport.drawn.detail() == Detail::Coarse)
    }

    /// Creates the targets of this size unless they exist.
    fn provide_targets(&mut self, device: &wgpu::Device, viewport: usize, size_px: [u32; 2]) {
        if let Some(viewport) = self.viewports.get_mut(viewport)
            && viewport.targets.as_ref().is_none_or(|targets| targets.size_px != size_px)
        {
            viewport.targets = Some(Targets::new(device, &self.blit, &self.stroke, size_px, self.samples));
        }
    }

    /// Draws what `prepare` rendered over the whole viewport rectangle of
    /// `render_pass`; nothing when there was no `prepare`.
    pub fn paint(&self, render_pass: &mut wgpu::RenderPass<'static>, viewport: usize) {
        let Some(viewport) = self.viewports.get(viewport) else { return };
        if let Some(targets) = &viewport.targets {
            viewport.drawn.confirm();
            self.blit.draw(render_pass, &targets.picture_group);
        }
    }

    fn record_mesh(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        viewport: &Viewport,
        targets: &Targets,
        pattern: Pattern,
        background: [f32; 4],
    ) {
        let attachment = targets.mesh_attachment(clear_color(background));
        let mut pass = begin_pass(encoder, "mesh", attachment);
        let cells = viewport.cell_style.filter(|_| !viewport.cells.is_empty());
        match cells.and_then(|style| style.map) {
            Some(map) => self.cells.draw_colors(&mut pass, &viewport.cells, map),
            None => self.mesh.draw(&mut pass, &viewport.mesh, pattern, &self.image.group),
        }
        if cells.is_some_and(|style| style.marks || style.wire.is_some()) {
            self.cells.draw_overlay(&mut pass, &viewport.cells);
        }
    }

    fn record_overlay(&self, encoder: &mut wgpu::CommandEncoder, viewport: &Viewport, targets: &Targets) {
        let stroked = !viewport.stroke.is_empty();
        if stroked {
            let clear = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);
            let mut pass = begin_pass(encoder, "outline coverage", attachment(&targets.coverage, clear));
            self.stroke.cover(&mut pass, &viewport.stroke);
        }
        if stroked || !viewport.discs.is_empty() {
            let mut pass = begin_pass(encoder, "overlay", attachment(&targets.picture, wgpu::LoadOp::Load));
            if stroked {
                self.stroke.composite(&mut pass, &viewport.stroke, &targets.coverage_group);
            }
            self.disc.draw(&mut pass, &viewport.discs);
        }
    }
}

/// The viewport, with its picture marked as no longer valid.
fn outdated(viewports: &mut [Viewport], viewport: usize) -> Option<&mut Viewport> {
    let viewport = viewports.get_mut(viewport)?;
    viewport.drawn.outdate();
    Some(viewport)
}

pub(super) fn begin_pass<'encoder>(
    encoder: &'encoder mut wgpu::CommandEncoder,
    label: &str,
    attachment: wgpu::RenderPassColorAttachment,
) -> wgpu::RenderPass<'encoder> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[Some(attachment)],
        ..Default::default()
    })
}

/// The color as the picture holds it: premultiplied and linear.
pub(super) fn clear_color(background: [f32; 4]) -> wgpu::Color {
    let [r, g, b, a] = linear_color(background).map(f64::from);
    wgpu::Color { r: r * a, g: g * a, b: b * a, a }
}
