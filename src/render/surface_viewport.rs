//! Viewports that show a surface in space instead of a planar mesh; any viewport of the renderer can do so.
//!
//! They are rendered in two passes (surface, edges and boundary loop, multisampled, with depth, and resolved; handles
//! over the picture), then painted into the caller's pass. The pipelines are made with the first surface, buffers and
//! targets with a viewport's first one. A viewport index out of range, inconsistent surfaces and arrays of the wrong
//! length are refused: the methods return `false` and change nothing.

use super::disc_pass::{DiscBuffers, DiscPass};
use super::drawn::Drawn;
use super::space_vertices::SpaceVertex;
use super::surface_pass::{SurfaceBuffers, SurfacePass, SurfaceView};
use super::surface_stroke::{SurfaceStrokeBuffers, SurfaceStrokePass};
use super::targets::{SurfaceTargets, attachment, clamped_size};
use super::viewport::{LINE_TO_STROKE, Viewport, begin_pass, clear_color};
use super::{Camera, CellCode, Detail, Handle, MeshFault, OrbitCamera, Pace, SpaceFrame, ViewportRenderer};
use glam::{DVec2, DVec3};

/// The opacity of a handle behind the surface, relative to a visible one.
const HIDDEN_STRENGTH: f32 = 0.35;

/// A surface in space.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceGeometry<'a> {
    /// The positions of the vertices, the boundary loop's first.
    pub positions: &'a [DVec3],
    /// Vertex indices; seen from their front side they are counter-clockwise.
    pub triangles: &'a [[u32; 3]],
    /// The number of vertices of the boundary loop.
    pub boundary_count: u32,
}

impl SurfaceGeometry<'_> {
    /// Ok if the loop and every triangle have existing vertices; otherwise the fault. `O(triangles)`.
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

/// A point of a surface that can be dragged, drawn like the planar [`Handle`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHandle {
    /// The position.
    pub position: DVec3,
    /// Whether the surface is in front of it (`SurfaceTree::hides`): it is then drawn fainter.
    pub hidden: bool,
    /// sRGB-encoded, straight alpha.
    pub colour: [f32; 4],
    /// Outer radius in physical pixels, ring included.
    pub radius_px: f32,
}

/// The pipelines of all surfaces.
#[derive(Debug)]
pub struct SurfacePasses {
    surface: SurfacePass,
    stroke: SurfaceStrokePass,
    staging: Vec<SpaceVertex>,
}

/// The buffers and targets of one viewport's surface.
#[derive(Debug)]
pub struct SurfaceViewport {
    surface: SurfaceBuffers,
    stroke: SurfaceStrokeBuffers,
    discs: DiscBuffers,
    targets: Option<SurfaceTargets>,
    drawn: Drawn<SpaceFrame>,
    handles: Vec<SurfaceHandle>,
}

impl ViewportRenderer {
    /// Replaces a viewport's surface; all texture coordinates are (0, 0), and the codes must be set again. Buffers are
    /// kept where they are large enough.
    ///
    /// False, with the old surface kept, for an inconsistent one ([`SurfaceGeometry::check`]); false, with none
    /// left, if it does not fit on the device.
    pub fn set_surface(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        viewport: usize,
        geometry: &SurfaceGeometry,
    ) -> bool {
        if let Err(reason) = geometry.check() {
            log::error!("a surface was not uploaded: {reason}");
            return false;
        }
        let (samples, images, disc) = (self.samples, &self.images, &self.disc);
        let Some(viewport) = self.viewports.get_mut(viewport) else { return false };
        let passes = self.surface_passes.get_or_insert_with(|| SurfacePasses {
            surface: SurfacePass::new(device, queue, &images.layout, samples),
            stroke: SurfaceStrokePass::new(device, samples),
            staging: Vec::new(),
        });
        let shown = viewport.surface.get_or_insert_with(|| SurfaceViewport::new(device, passes, disc));
        shown.outdate();
        let boundary = &geometry.positions[..geometry.boundary_count as usize];
        passes.surface.set(device, queue, &mut shown.surface, &mut passes.staging, geometry)
            && shown.stroke.set(device, queue, boundary, shown.surface.frame)
    }

    /// Whether a surface has been set.
    pub(super) fn has_surface(&self) -> bool {
        self.surface_passes.is_some()
    }

    /// New texture coordinates for a viewport's surface, without reallocation: the images of its vertices.
    ///
    /// False, and nothing changes, when the count is not the surface's.
    pub fn set_surface_coordinates(&mut self, queue: &wgpu::Queue, viewport: usize, coordinates: &[DVec2]) -> bool {
        let Some(shown) = outdated(&mut self.viewports, viewport) else { return false };
        shown.surface.set_coordinates(queue, &mut self.staging, coordinates)
    }

    /// Colors the triangles of a viewport's surface; `codes` is padded on the way.
    ///
    /// False, and nothing changes, when the count is not the surface's.
    pub fn set_surface_codes(&mut self, queue: &wgpu::Queue, viewport: usize, codes: &mut Vec<CellCode>) -> bool {
        outdated(&mut self.viewports, viewport).is_some_and(|shown| shown.surface.set_codes(queue, codes))
    }

    /// Replaces the discs drawn over a viewport's surface; those at or behind the eye are left out.
    pub fn set_surface_handles(&mut self, viewport: usize, handles: &[SurfaceHandle]) {
        if let Some(shown) = outdated(&mut self.viewports, viewport) {
            shown.handles = handles.to_vec();
        }
    }

    /// Records the rendering of a viewport's surface into its own target, if `frame` or the geometry has changed;
    /// returns the detail recorded, `None` if the picture is still valid or there was no [`Self::set_surface`].
    ///
    /// Call it once per viewport and submission: the uniform blocks hold one frame.
    /// A size beyond the device's textures is clamped, and `paint_surface` scales the picture.
    pub fn prepare_surface(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        viewport: usize,
        frame: &SpaceFrame,
        pace: Pace,
    ) -> Option<Detail> {
        let passes = self.surface_passes.as_ref()?;
        let shown = self.viewports.get_mut(viewport)?.surface.as_mut()?;
        let size_px = clamped_size(device, frame.size_px);
        let detail = shown.drawn.due(SpaceFrame { size_px, ..*frame }, pace)?;
        let size_px = detail.size(size_px);
        if shown.targets.as_ref().is_none_or(|targets| targets.size_px != size_px) {
            shown.targets = Some(SurfaceTargets::new(device, &self.blit, size_px, self.samples));
        }
        shown.write_frame(device, queue, frame, size_px, detail, self.image.aspect);
        let targets = shown.targets.as_ref()?;
        let mut pass = targets.begin(encoder, clear_color(frame.background));
        shown.draw(&mut pass, passes, frame, &self.image.group);
        drop(pass);
        if !shown.discs.is_empty() {
            let mut pass = begin_pass(encoder, "handles", attachment(&targets.picture, wgpu::LoadOp::Load));
            self.disc.draw(&mut pass, &shown.discs);
        }
        Some(detail)
    }

    /// Whether the picture of a viewport's surface is coarse, to be recorded in full when it no longer changes.
    pub fn draws_surface_coarsely(&self, viewport: usize) -> bool {
        self.surface(viewport).is_some_and(|shown| shown.drawn.detail() == Detail::Coarse)
    }

    /// Draws what [`Self::prepare_surface`] rendered over the whole viewport rectangle of
    /// `render_pass`; nothing when there was none.
    pub fn paint_surface(&self, render_pass: &mut wgpu::RenderPass<'static>, viewport: usize) {
        let Some(shown) = self.surface(viewport) else { return };
        if let Some(targets) = &shown.targets {
            shown.drawn.confirm();
            self.blit.draw(render_pass, &targets.picture_group);
        }
    }

    fn surface(&self, viewport: usize) -> Option<&SurfaceViewport> {
        self.viewports.get(viewport)?.surface.as_ref()
    }
}

/// The surface of a viewport, with its picture marked as no longer valid.
fn outdated(viewports: &mut [Viewport], viewport: usize) -> Option<&mut SurfaceViewport> {
    let shown = viewports.get_mut(viewport)?.surface.as_mut()?;
    shown.outdate();
    Some(shown)
}

impl SurfaceViewport {
    fn new(device: &wgpu::Device, passes: &SurfacePasses, disc: &DiscPass) -> Self {
        Self {
            surface: passes.surface.buffers(device),
            stroke: passes.stroke.buffers(device),
            discs: disc.buffers(device),
            targets: None,
            drawn: Drawn::default(),
            handles: Vec::new(),
        }
    }

    /// Marks the picture as no longer valid.
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

    /// The discs at the screen positions of the handles, in a plane whose unit is the pixel.
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

    fn draw(&self, pass: &mut wgpu::RenderPass, passes: &SurfacePasses, frame: &SpaceFrame, image: &wgpu::BindGroup) {
        if self.surface.is_empty() {
            return;
        }
        match frame.cells.and_then(|style| style.map) {
            Some(map) => passes.surface.draw_colors(pass, &self.surface, map),
            None => passes.surface.draw_texture(pass, &self.surface, frame.style.pattern, image),
        }
        if frame.cells.is_some_and(|style| style.marks || style.wire.is_some()) {
            passes.surface.draw_overlay(pass, &self.surface);
        }
        passes.stroke.draw(pass, &self.stroke);
    }
}
