//! The Cauchy–Green extension of the shown map, evaluated on the GPU in every frame.
//!
//! Only the textured picture uses these images; numbers, wireframe and colors of triangles use those of the
//! map itself, which refines them on the CPU when the drag rests. Where the device has no compute
//! shaders (WebGL2), or the map has too many terms, the picture too uses the map's own images.

use crate::app::viewport::gpu::{VIEWPORTS, draws_in_software};
use crate::conformal::{ConformalMap, Extension, MeshedDomain, Side};
use crate::render::{CauchyGreenBuffers, CauchyGreenPass, ViewportRenderer};
use egui_wgpu::RenderState;
use std::sync::Arc;

/// The most terms (vertices × samples) per frame. 10⁸ should take a laptop's GPU one frame of 16 ms; with five times as
/// many a drag shows 12 frames per second, far from the 2 s after which an operating system resets the GPU.
const MOST_TERMS: usize = 500_000_000;

/// The same on a software adapter, where a term takes 27 ns (lavapipe, two busy cores).
const MOST_TERMS_IN_SOFTWARE: usize = 1 << 20;

/// The compute pass, and the buffers of the mapped domain.
#[derive(Debug)]
pub struct GpuExtension {
    pass: CauchyGreenPass,
    most_terms: usize,
    mapped: Option<(Arc<MeshedDomain>, CauchyGreenBuffers)>,
}

impl GpuExtension {
    /// Creates the compute pass; `None` where the device has no compute shaders.
    pub fn new(state: &RenderState) -> Option<Self> {
        let flags = state.adapter.get_downlevel_capabilities().flags;
        let pass =
            flags.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS).then(|| CauchyGreenPass::new(&state.device))??;
        let most_terms = if draws_in_software(state) { MOST_TERMS_IN_SOFTWARE } else { MOST_TERMS };
        Some(Self { pass, most_terms, mapped: None })
    }

    /// Whether the images in the picture of `map` come from this pass.
    pub fn serves(&self, map: &ConformalMap) -> bool {
        let known = self
            .mapped
            .as_ref()
            .zip(map.mapped().domain())
            .is_some_and(|((domain, _), mapped)| Arc::ptr_eq(domain, mapped));
        known && map.extension() == Extension::CauchyGreen
    }

    /// Writes the extension into the mapped mesh in the viewport of `side`: as texture coordinates if
    /// `side` is the mapped side, else as positions. Returns false, with the picture unchanged, if the map's
    /// extension is harmonic, the map is too large, or the mesh in the viewport is another one.
    pub fn apply(
        &mut self,
        state: &RenderState,
        renderer: &mut ViewportRenderer,
        map: &ConformalMap,
        side: Side,
    ) -> bool {
        if map.extension() != Extension::CauchyGreen || !self.provide(state, map) {
            return false;
        }
        let Some((_, buffers)) = &mut self.mapped else { return false };
        let RenderState { device, queue, .. } = state;
        let Some(other) = map.domain(map.mapped_side().other()) else { return false };
        // the pattern's octaves follow the map's own images
        let uploaded = if side == map.mapped_side() {
            renderer.set_texture_coordinates(queue, VIEWPORTS[side], map.images())
        } else {
            renderer.set_positions(queue, VIEWPORTS[side], map.images())
        };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("extension") });
        let recorded = uploaded
            && self.pass.evaluate(queue, &mut encoder, buffers, map.correspondence().images(other.samples()))
            && if side == map.mapped_side() {
                renderer.copy_texture_coordinates(&mut encoder, VIEWPORTS[side], buffers)
            } else {
                renderer.copy_positions(&mut encoder, VIEWPORTS[side], buffers)
            };
        if recorded {
            queue.submit([encoder.finish()]);
        } else {
            self.mapped = None;
        }
        recorded
    }

    /// Creates the buffers of the mapped domain unless they exist; false if it has too many terms for the device.
    fn provide(&mut self, state: &RenderState, map: &ConformalMap) -> bool {
        let Some(domain) = map.mapped().domain() else { return false };
        if !self.mapped.as_ref().is_some_and(|(known, _)| Arc::ptr_eq(known, domain)) {
            let (contour, points) = (domain.samples().points(), domain.mesh().vertices());
            let fits = contour.len().saturating_mul(points.len()) <= self.most_terms;
            let buffers = if fits { self.pass.buffers(&state.device, &state.queue, contour, points) } else { None };
            self.mapped = buffers.map(|buffers| (Arc::clone(domain), buffers));
        }
        self.mapped.is_some()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{Constraints, Direction, MapSettings, PrepareSettings, PreparedSide, prepare};
    use crate::geometry::DVec2;
    use crate::mesh::Sizing;
    use crate::outline::{Preset, Sampling};
    use crate::render::MeshGeometry;
    use egui_kittest::wgpu::{create_render_state, default_wgpu_setup};
    use std::sync::mpsc;

    fn domain(preset: Preset, count: u32) -> Arc<PreparedSide> {
        let sampling = Sampling::Uniform { count, keep_corners: false };
        let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.3), ..PrepareSettings::default() };
        Arc::new(prepare(preset.outline().polygon(), &settings, &mut |_| ()).unwrap())
    }

    /// The images that were written last, read back from the GPU.
    fn images(state: &RenderState, extension: &GpuExtension) -> Vec<DVec2> {
        let (sender, receiver) = mpsc::channel();
        let take = move |images: Result<_, _>| sender.send(images.unwrap()).unwrap();
        extension.mapped.as_ref().unwrap().1.read_back(&state.device, &state.queue, take);
        state.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
        receiver.recv().unwrap()
    }

    #[test]
    fn the_gpu_evaluates_the_images_that_the_map_refines_to() {
        crate::app::tests::need_adapter();
        let state = create_render_state(default_wgpu_setup(), egui_wgpu::RendererOptions::PREDICTABLE);
        let mut renderer = ViewportRenderer::new(&state.device, &state.queue, state.target_format, 2, 1);
        let mut extension = GpuExtension::new(&state).unwrap();
        let (source, target) = (domain(Preset::Gingerbread, 200), domain(Preset::Heart, 150));
        let at = |x: f64| {
            Constraints::new(
                (source.domain().unwrap().default_point() + DVec2::new(x, 0.0), 0.1),
                (target.default_point(), 0.0),
            )
        };
        let mut map = ConformalMap::new(source.clone(), target.clone(), &at(0.0), MapSettings::default()).unwrap();
        assert!(!extension.apply(&state, &mut renderer, &map, Side::Target) && !extension.serves(&map), "harmonic");
        for direction in [Direction::Forward, Direction::Backward] {
            let mapped = MapSettings { direction, extension: Extension::CauchyGreen };
            map.update(&at(0.0), mapped).unwrap();
            let mesh = map.mapped().domain().unwrap().mesh();
            let geometry = MeshGeometry {
                positions: mesh.vertices(),
                texture_coordinates: mesh.vertices(),
                triangles: mesh.triangles(),
            };
            assert!(renderer.set_mesh(&state.device, &state.queue, VIEWPORTS.target, &geometry));
            for x in [0.0, 0.01] {
                map.update(&at(x), mapped).unwrap();
                // a refinement in progress must not change the input of the shader
                map.refine(0.0);
                assert!(extension.apply(&state, &mut renderer, &map, Side::Target) && extension.serves(&map));
                let computed = images(&state, &extension);
                assert!(map.refine(f64::INFINITY));
                let (low, high) = crate::model::bounds(map.images());
                let error = computed.iter().zip(map.images()).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
                // the map's own images use rows of Γ in f32, within 1e-6 of those in f64
                let tolerance = (CauchyGreenPass::ERROR + 1e-6) * (high - low).max_element();
                assert!(error < tolerance, "{direction:?}, x = {x}: {error:e}, tolerance {tolerance:e}");
                assert_eq!(computed.len(), map.images().len());
            }
        }
        extension.most_terms = 1000;
        map.update(&at(0.0), MapSettings { direction: Direction::Forward, extension: Extension::CauchyGreen }).unwrap();
        assert!(!extension.apply(&state, &mut renderer, &map, Side::Target) && !extension.serves(&map), "too large");
    }
}
