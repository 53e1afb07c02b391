//! A viewport that shows a surface in space: the counterpart of the planar ones, in the same renderer.
//!
//! It is rendered in two passes (surface, edges and boundary loop, multisampled, with depth, and resolved; handles
//! over the picture), then painted into the caller's pass. Pipelines and targets are made with the first surface.
//! Inconsistent surfaces and counts that do not fit are refused: the methods answer `false`, nothing changes.

use super::disc_pass::DiscBuffers;
use super::drawn::Drawn;
use super::space_vertices::SpaceVertex;
use super::surface_pass::{SurfaceBuffers, SurfacePass, SurfaceView};
use super::surface_stroke::{SurfaceStrokeBuffers, SurfaceStrokePass};
use super::targets::{SurfaceTargets, attachment, clamped_size};
use super::viewport::{LINE_TO_STROKE, begin_pass, clear_colour};
use super::{Camera, CellCode, Detail, Handle, MeshFault, OrbitCamera, Pace, SpaceFrame, ViewportRenderer};
use glam::{DVec2, DVec3};

/// A handle behind the surface has this part of its strength.
const HIDDEN_STRENGTH: f32 = 0.35;

/// A surface in space.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceGeometry<'a> {
    /// Where the vertices are, the boundary loop's first.
    pub positions: &'a [DVec3],
    /// Vertex indices; seen from their front side they are counter-clockwise.
    pub triangles: &'a [[u32; 3]],
    /// The number of vertices of the boundary loop.
    pub boundary_count: u32,
}

impl SurfaceGeometry<'_> {
    /// Ok when the loop and every triangle have existing vertices; otherwise what is wrong. `O(triangles)`.
    pub fn check(&self) -> Result<(), MeshFault> {
        let count = self.positions.len();
        if self.boundary_count as usize > count {
            return Err(MeshFault::Boundary { boundary: self.boundary_count, vertices: count });
        }
        match self.triangles.iter().position(|corners| corners.iter().any(|&v| v as usize >= count)) {
            Some(t) => Err(MeshFault::Vertex { triangle: t, corners: self.triangles[t], vertices: count }),
            None => Ok(()),
        }
    }
}

/// A point of a surface that can be dragged, drawn as the planar [`Handle`]s are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHandle {
    /// Where.
    pub position: DVec3,
    /// Whether the surface is before it (`SurfaceTree::hides`): it is drawn fainter.
    pub hidden: bool,
    /// sRGB-encoded, straight alpha.
    pub colour: [f32; 4],
    /// Outer radius in physical pixels, ring included.
    pub radius_px: f32,
}

/// Pipelines, buffers and targets.
#[derive(Debug)]
pub struct SurfaceViewport {
    pass: SurfacePass,
    stroke_pass: SurfaceStrokePass,
    surface: SurfaceBuffers,
    stroke: SurfaceStrokeBuffers,
    discs: DiscBuffers,
    targets: Option<SurfaceTargets>,
    drawn: Drawn<SpaceFrame>,
    handles: Vec<SurfaceHandle>,
    staging: Vec<SpaceVertex>,
}

impl ViewportRenderer {
    /// Replaces the surface; all texture coordinates are (0, 0), and the codes have to be set anew. Buffers are kept where they
    /// are large enough.
    ///
    /// False, and the old surface stays, for an inconsistent one ([`SurfaceGeometry::check`]); false, and none is
    /// left, where it does not fit on the device.
    pub fn set_surface(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, geometry: &SurfaceGeometry) -> bool {
        if let Err(reason) = geometry.check() {
            log::error!("a surface was not uploaded: {reason}");
            return false;
        }
        let viewport = self.provide_surface(device, queue);
        viewport.outdate();
        let SurfaceViewport { pass, surface, stroke, staging, .. } = viewport;
        let boundary = &geometry.positions[..geometry.boundary_count as usize];
        pass.set(device, queue, surface, staging, geometry) && stroke.set(device, queue, boundary, surface.frame)
    }

    fn provide_surface(&mut self, device: &wgpu::Device, queue: &wgpu::Queue) -> &mut SurfaceViewport {
        let (samples, images, disc) = (self.samples, &self.images, &self.disc);
        self.surface.get_or_insert_with(|| {
            let pass = SurfacePass::new(device, queue, &images.layout, samples);
            let stroke_pass = SurfaceStrokePass::new(device, samples);
            let (surface, stroke) = (pass.buffers(device), stroke_pass.buffers(device));
            let discs = disc.buffers(device);
            let drawn = Drawn::default();
            let (handles, staging) = (Vec::new(), Vec::new());
            SurfaceViewport { pass, stroke_pass, surface, stroke, discs, targets: None, drawn, handles, staging }
        })
    }

    /// Whether there has been a surface.
    pub(super) fn has_surface(&self) -> bool {
        self.surface.is_some()
    }

    /// New texture coordinates for the surface, without reallocation: the images of its vertices.
    ///
    /// False, and nothing changes, when the count is not the surface's.
    pub fn set_surface_coordinates(&mut self, queue: &wgpu::Queue, coordinates: &[DVec2]) -> bool {
        let Some(viewport) = &mut self.surface else { return false };
        viewport.outdate();
        viewport.surface.set_coordinates(queue, &mut self.staging, coordinates)
    }

    /// Colours the triangles of the surface; `codes` is padded on the way.
    ///
    /// False, and nothing changes, when the count is not the surface's.
    pub fn set_surface_codes(&mut self, queue: &wgpu::Queue, codes: &mut Vec<CellCode>) -> bool {
        let Some(viewport) = &mut self.surface else { return false };
        viewport.outdate();
        viewport.surface.set_codes(queue, codes)
    }

    /// Replaces the discs drawn over the surface; those at or behind the eye are left out.
    pub fn set_surface_handles(&mut self, handles: &[SurfaceHandle]) {
        if let Some(viewport) = &mut self.surface {
            viewport.outdate();
            viewport.handles = handles.to_vec();
        }
    }

    /// Records the rendering of the surface into its own target, where `frame` or the geometry is not what it shows;
    /// returns how it was recorded, `None` where it stands or there was no [`Self::set_surface`].
    ///
    /// Once per submission: the uniform blocks hold one frame.
    /// A size beyond the device's textures is clamped, and `paint_surface` stretches.
    pub fn prepare_surface(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        frame: &SpaceFrame,
        pace: Pace,
    ) -> Option<Detail> {
        let viewport = self.surface.as_mut()?;
        let size_px = clamped_size(device, frame.size_px);
        let detail = viewport.drawn.due(SpaceFrame { size_px, ..*frame }, pace)?;
        let size_px = detail.size(size_px);
        if viewport.targets.as_ref().is_none_or(|targets| targets.size_px != size_px) {
            viewport.targets = Some(SurfaceTargets::new(device, &self.blit, size_px, self.samples));
        }
        viewport.write_frame(device, queue, frame, size_px, detail, self.image.aspect);
        let targets = viewport.targets.as_ref()?;
        let mut pass = targets.begin(encoder, clear_colour(frame.background));
        viewport.draw(&mut pass, frame, &self.image.group);
        drop(pass);
        if !viewport.discs.is_empty() {
            let mut pass = begin_pass(encoder, "handles", attachment(&targets.picture, wgpu::LoadOp::Load));
            self.disc.draw(&mut pass, &viewport.discs);
        }
        Some(detail)
    }

    /// Whether the picture of the surface is coarse, and is to be recorded in full when it rests.
    pub fn is_surface_coarse(&self) -> bool {
        self.surface.as_ref().is_some_and(|viewport| viewport.drawn.detail() == Detail::Coarse)
    }

    /// Draws what [`Self::prepare_surface`] rendered over the whole viewport rectangle of
    /// `render_pass`; nothing when there was none.
    pub fn paint_surface(&self, render_pass: &mut wgpu::RenderPass<'static>) {
        let Some(viewport) = &self.surface else { return };
        if let Some(targets) = &viewport.targets {
            viewport.drawn.confirm();
            self.blit.draw(render_pass, &targets.picture_group);
        }
    }
}

impl SurfaceViewport {
    /// The picture does not stand any more.
    pub(super) fn outdate(&mut self) {
        self.drawn.outdate();
    }

    fn write_frame(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        frame: &SpaceFrame,
        size_px: [u32; 2],
        detail: Detail,
        image_aspect: f64,
    ) {
        let SpaceFrame { camera, style, .. } = frame;
        let (stroke, cells) = (detail.stroke(frame.stroke), frame.cells.map(|cells| detail.cells(cells)));
        let line_px = LINE_TO_STROKE * stroke.width_px;
        let view = SurfaceView { camera, size_px, style, image_aspect, line_px, cells: cells.as_ref() };
        self.surface.write_frame(queue, &view);
        self.stroke.write_frame(queue, camera, self.surface.frame, size_px, &stroke);
        self.place_handles(device, queue, camera, size_px, detail);
    }

    /// Discs where the handles are seen, in a plane whose unit is the pixel.
    fn place_handles(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        camera: &OrbitCamera,
        size_px: [u32; 2],
        detail: Detail,
    ) {
        let size = DVec2::new(f64::from(size_px[0]), f64::from(size_px[1]));
        let upwards = DVec2::new(1.0, -1.0);
        let disc = |handle: &SurfaceHandle| {
            let position = camera.to_screen(handle.position, size)? * upwards;
            let [r, g, b, a] = handle.colour;
            let strength = if handle.hidden { HIDDEN_STRENGTH } else { 1.0 };
            Some(Handle { position, colour: [r, g, b, a * strength], radius_px: handle.radius_px })
        };
        let discs: Vec<Handle> = self.handles.iter().filter_map(disc).collect();
        self.discs.set(device, queue, &discs);
        let middle = Camera { center: 0.5 * size * upwards, units_per_pixel: 1.0 };
        self.discs.write_frame(queue, &middle, size_px, detail.length(1.0));
    }

    fn draw(&self, pass: &mut wgpu::RenderPass, frame: &SpaceFrame, image: &wgpu::BindGroup) {
        if self.surface.is_empty() {
            return;
        }
        match frame.cells.and_then(|style| style.map) {
            Some(map) => self.pass.draw_colours(pass, &self.surface, map),
            None => self.pass.draw_texture(pass, &self.surface, frame.style.pattern, image),
        }
        if frame.cells.is_some_and(|style| style.marks || style.wire.is_some()) {
            self.pass.draw_overlay(pass, &self.surface);
        }
        self.stroke_pass.draw(pass, &self.stroke);
    }
}
