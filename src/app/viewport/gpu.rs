//! Uploads from the model to the GPU after a change, and the callbacks that
//! draw the viewports inside egui's pass.
//!
//! Positions and texture coordinates of each side come from [`pattern`]. The images of the
//! mapped mesh are uploaded, or written by a compute shader ([`GpuExtension`]).

use crate::app::viewport::gpu_extension::GpuExtension;
use crate::app::viewport::picture::Picture;
use crate::app::viewport::surface;
use crate::conformal::{Extension, PerSide, Side};
use crate::export::hatched;
use crate::geometry::DVec2;
use crate::model::pattern::Moved;
use crate::model::{Changes, Model, pattern};
use crate::render::{
    CellCode, CellStyle, ImageError, Pace, PlanarFrame, REFINED_AFTER, SpaceFrame, StrokeStyle, ViewportRenderer,
    sample_count,
};
use egui_wgpu::{CallbackResources, CallbackTrait, RenderState, ScreenDescriptor};

/// The renderer's viewport of each side.
pub const VIEWPORTS: PerSide<usize> = PerSide::new(0, 1);

/// The renderer and its device.
pub struct Gpu {
    state: RenderState,
    extension: Option<GpuExtension>,
    in_software: bool,
    /// The revisions of the disk coordinates that were uploaded, between two surfaces.
    disks: PerSide<Option<u64>>,
}

/// Whether the adapter is a software renderer on the CPU.
pub fn draws_in_software(state: &RenderState) -> bool {
    state.adapter.get_info().device_type == wgpu::DeviceType::Cpu
}

impl Gpu {
    /// Adds a renderer for both viewports to egui's callback resources.
    pub fn new(state: RenderState) -> Self {
        let in_software = draws_in_software(&state);
        // in software, resolving multisampling takes two thirds of a frame
        let samples = if in_software { 1 } else { sample_count(&state.device) };
        let viewports = Side::BOTH.len();
        let renderer = ViewportRenderer::new(&state.device, &state.queue, state.target_format, viewports, samples);
        state.renderer.write().callback_resources.insert(renderer);
        let extension = GpuExtension::new(&state);
        Self { state, extension, in_software, disks: PerSide::default() }
    }

    /// The name of the graphics API, for the status line.
    pub fn backend(&self) -> String {
        crate::platform::backend_name(self.state.adapter.get_info().backend)
    }

    /// The name of the graphics adapter.
    pub fn adapter(&self) -> String {
        self.state.adapter.get_info().name
    }

    /// The device and its queue, for offscreen pictures.
    pub fn device(&self) -> (&wgpu::Device, &wgpu::Queue) {
        (&self.state.device, &self.state.queue)
    }

    /// Whether a picture that changes at time `now` is drawn coarsely first (in software) or at full resolution.
    pub fn pace(&self, now: f64) -> Pace {
        if self.in_software { Pace::CoarseFirst { now } } else { Pace::Full }
    }

    /// The largest width or height of a texture, in pixels.
    pub fn max_texture_side(&self) -> u32 {
        self.state.device.limits().max_texture_dimension_2d
    }

    /// Whether the picture shows the complete Cauchy–Green extension of the model's map, evaluated by a compute shader.
    pub fn extends(&self, model: &Model) -> bool {
        let in_the_plane = model.pattern_home().is_some();
        let map = model.map().filter(|map| in_the_plane && map.extension() == Extension::CauchyGreen);
        self.extension.as_ref().zip(map).is_some_and(|(extension, map)| extension.serves(map))
    }

    /// Uploads what has changed; returns whether a surface fits on the device.
    pub fn upload(&mut self, model: &Model, changes: Changes) -> bool {
        let of_surfaces = self.take_surface_changes(model, changes);
        let upload = |renderer: &mut ViewportRenderer| {
            Side::BOTH.map(|side| surface::gpu::upload(&self.state, renderer, model, side, of_surfaces[side]))
                == [true; 2]
        };
        let fits = self.with_renderer(upload) != Some(false);
        if changes.meshes {
            for side in Side::BOTH {
                if let Some(outline) = model.shown_outline(side) {
                    let unresolved = model.map().map_or(&[][..], |map| map.unresolved(side));
                    self.upload_boundary(side, &hatched(outline, unresolved));
                }
                self.upload_mesh(side, model);
            }
        } else if changes.images && !self.extends(model) {
            for side in Side::BOTH {
                self.upload_images(side, model);
            }
        }
        if changes.meshes || changes.map {
            self.extend(model);
        }
        fits
    }

    /// What of the changes concerns the surface on each side: between two, a drag changes the disk coordinates of its own
    /// side only.
    fn take_surface_changes(&mut self, model: &Model, changes: Changes) -> PerSide<Changes> {
        let map = model.map().filter(|map| map.is_through_disk());
        let disks = PerSide::from_fn(|side| map.map(|map| map.disk_revision(side)));
        let known = std::mem::replace(&mut self.disks, disks);
        PerSide::from_fn(|side| {
            let is_known = disks[side].is_some() && disks[side] == known[side];
            Changes { images: changes.images && !is_known, ..changes }
        })
    }

    /// Replaces the images in the picture by those of the compute shader, if it is available for this map.
    fn extend(&mut self, model: &Model) {
        let (Some(extension), Some(map)) = (&mut self.extension, model.map()) else { return };
        let Some(home) = model.pattern_home() else { return };
        let mut renderer = self.state.renderer.write();
        if let Some(renderer) = renderer.callback_resources.get_mut::<ViewportRenderer>() {
            extension.apply(&self.state, renderer, map, home.other());
        }
    }

    /// Sets the texture of [`crate::render::Pattern::Image`].
    pub fn set_image(&self, rgba: &[u8], width: u32, height: u32) -> Result<(), ImageError> {
        let RenderState { device, queue, .. } = &self.state;
        self.with_renderer(|renderer| renderer.set_image(device, queue, rgba, width, height)).unwrap_or(Ok(()))
    }

    /// Draws a surface once while there is time, so that its pipelines exist when the first one is opened.
    pub fn warm(&self) {
        self.with_renderer(|renderer| renderer.rehearse_surface(&self.state.device, &self.state.queue));
    }

    /// Sets the stroke of the outlines, of constant width on the screen.
    pub fn set_stroke(&self, dark: bool, pixels_per_point: f32) {
        self.with_renderer(|renderer| {
            for side in Side::BOTH {
                renderer.set_boundary_style(VIEWPORTS[side], Some(StrokeStyle::themed(dark, pixels_per_point)));
            }
        });
    }

    /// Replaces the triangles of one side that [`Self::set_cell_style`] shows.
    pub fn upload_cells(&self, side: Side, positions: &[DVec2], triangles: &[[u32; 3]]) {
        let RenderState { device, queue, .. } = &self.state;
        self.with_renderer(|renderer| renderer.set_cells(device, queue, VIEWPORTS[side], positions, triangles));
    }

    /// Moves the vertices of one side's triangles.
    pub fn move_cells(&self, side: Side, positions: &[DVec2]) {
        self.with_renderer(|renderer| renderer.set_cell_positions(&self.state.queue, VIEWPORTS[side], positions));
    }

    /// Uploads the colors of a side's triangles in the plane.
    pub fn colour_cells(&self, side: Side, codes: &mut Vec<CellCode>) {
        self.with_renderer(|renderer| renderer.set_cell_codes(&self.state.queue, VIEWPORTS[side], codes));
    }

    /// Uploads the colors of a side's triangles in space.
    pub fn colour_surface(&self, side: Side, codes: &mut Vec<CellCode>) {
        self.with_renderer(|renderer| renderer.set_surface_codes(&self.state.queue, VIEWPORTS[side], codes));
    }

    /// Sets how the triangles are shown on both sides; `None` hides them.
    pub fn set_cell_style(&self, style: Option<CellStyle>) {
        self.with_renderer(|renderer| Side::BOTH.map(|side| renderer.set_cell_style(VIEWPORTS[side], style)));
    }

    fn upload_boundary(&self, side: Side, line: &[DVec2]) {
        let RenderState { device, queue, .. } = &self.state;
        self.with_renderer(|renderer| renderer.set_boundary(device, queue, VIEWPORTS[side], line));
    }

    fn upload_mesh(&self, side: Side, model: &Model) {
        let RenderState { device, queue, .. } = &self.state;
        if let Some(geometry) = pattern::geometry(model, side) {
            self.with_renderer(|renderer| renderer.set_mesh(device, queue, VIEWPORTS[side], &geometry));
        }
    }

    fn upload_images(&self, side: Side, model: &Model) {
        let (queue, viewport) = (&self.state.queue, VIEWPORTS[side]);
        let fits = pattern::moved(model, side).and_then(|moved| {
            self.with_renderer(|renderer| match moved {
                Moved::Positions(positions) => renderer.set_positions(queue, viewport, positions),
                Moved::Coordinates(coordinates) => renderer.set_texture_coordinates(queue, viewport, coordinates),
            })
        });
        if fits == Some(false) {
            self.upload_mesh(side, model);
        }
    }

    fn with_renderer<R>(&self, use_it: impl FnOnce(&mut ViewportRenderer) -> R) -> Option<R> {
        self.state.renderer.write().callback_resources.get_mut::<ViewportRenderer>().map(use_it)
    }
}

/// Draws one viewport inside egui's pass.
pub struct ViewportCallback {
    /// The side of the viewport.
    pub side: Side,
    /// Camera, size, texture style and background.
    pub frame: Picture<PlanarFrame, SpaceFrame>,
    /// Whether it may be drawn coarsely first.
    pub pace: Pace,
    /// The context whose repaint is requested while the picture is coarse.
    pub context: egui::Context,
}

impl CallbackTrait for ViewportCallback {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(renderer) = resources.get_mut::<ViewportRenderer>() {
            let viewport = VIEWPORTS[self.side];
            let is_coarse = match &self.frame {
                Picture::Plane(frame) => {
                    renderer.prepare(device, queue, encoder, viewport, frame, self.pace);
                    renderer.is_coarse(viewport)
                }
                Picture::Space(frame) => {
                    renderer.prepare_surface(device, queue, encoder, viewport, frame, self.pace);
                    renderer.draws_surface_coarsely(viewport)
                }
            };
            if is_coarse {
                self.context.request_repaint_after_secs(REFINED_AFTER as f32);
            }
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: egui::PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(renderer) = resources.get::<ViewportRenderer>() {
            match self.frame {
                Picture::Plane(_) => renderer.paint(pass, VIEWPORTS[self.side]),
                Picture::Space(_) => renderer.paint_surface(pass, VIEWPORTS[self.side]),
            }
        }
    }
}
