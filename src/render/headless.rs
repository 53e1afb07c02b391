//! Rendering scenes into images without a window, natively.
//!
//! The pixels are read back row by row. Works on any adapter, including software; the pixels of two
//! adapters may differ by rounding.

use super::{Readback, RenderError, SceneDescription, SceneRenderer, guarded};
use image::RgbaImage;

/// A device on any adapter, hardware preferred, software accepted.
///
/// The device is limited to what WebGL2 has, except for the adapter's largest
/// textures, so that scenes rendered here also render in a browser; compute
/// shaders with WebGPU's limits are requested if the adapter has them.
pub fn headless_device() -> Result<(wgpu::Device, wgpu::Queue, wgpu::AdapterInfo), RenderError> {
    // OpenGL only as the last choice: without a display, its libraries write to stderr
    let adapter = adapter_on(wgpu::Backends::PRIMARY)
        .or_else(|_| adapter_on(wgpu::Backends::all()))
        .map_err(|error| RenderError::NoAdapter { cause: error.to_string() })?;
    let info = adapter.get_info();
    let descriptor = wgpu::DeviceDescriptor {
        label: Some("headless"),
        required_limits: limits(&adapter),
        ..wgpu::DeviceDescriptor::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
        .map_err(|error| RenderError::NoDevice { adapter: info.name.clone(), cause: error.to_string() })?;
    Ok((device, queue, info))
}

fn limits(adapter: &wgpu::Adapter) -> wgpu::Limits {
    let webgl = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
    if !adapter.get_downlevel_capabilities().flags.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS) {
        return webgl;
    }
    let compute = wgpu::Limits::downlevel_defaults();
    wgpu::Limits {
        max_storage_buffers_per_shader_stage: compute.max_storage_buffers_per_shader_stage,
        max_storage_buffer_binding_size: compute.max_storage_buffer_binding_size,
        max_compute_workgroup_storage_size: compute.max_compute_workgroup_storage_size,
        max_compute_invocations_per_workgroup: compute.max_compute_invocations_per_workgroup,
        max_compute_workgroup_size_x: compute.max_compute_workgroup_size_x,
        max_compute_workgroup_size_y: compute.max_compute_workgroup_size_y,
        max_compute_workgroup_size_z: compute.max_compute_workgroup_size_z,
        max_compute_workgroups_per_dimension: compute.max_compute_workgroups_per_dimension,
        ..webgl
    }
}

/// An adapter on one of `backends`, or on those that `WGPU_BACKEND` names.
fn adapter_on(backends: wgpu::Backends) -> Result<wgpu::Adapter, wgpu::RequestAdapterError> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..wgpu::RequestAdapterOptions::default()
    };
    pollster::block_on(wgpu::Instance::new(descriptor.with_env()).request_adapter(&options))
}

/// [`render_scene_with`] on a new device.
pub fn render_scene(scene: &SceneDescription, size: [u32; 2]) -> Result<RgbaImage, RenderError> {
    let (device, queue, _) = headless_device()?;
    render_scene_with(&device, &queue, scene, size)
}

/// Renders `scene` into an sRGB image of `size` pixels with straight alpha.
///
/// Picture k of n takes the columns from ⌊k·w/n⌋ to ⌊(k+1)·w/n⌋.
pub fn render_scene_with(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    scene: &SceneDescription,
    size: [u32; 2],
) -> Result<RgbaImage, RenderError> {
    Studio::on(device, queue).shoot(|renderer, device, queue| renderer.draw(device, queue, scene, size))
}

/// A device and a renderer for making many pictures.
#[derive(Debug)]
pub struct Studio {
    device: wgpu::Device,
    queue: wgpu::Queue,
    renderer: SceneRenderer,
}

impl Studio {
    /// A studio on any adapter: [`headless_device`].
    pub fn new() -> Result<Self, RenderError> {
        let (device, queue, _) = headless_device()?;
        Ok(Self::on(&device, &queue))
    }

    fn on(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        Self { device: device.clone(), queue: queue.clone(), renderer: SceneRenderer::new(device, queue) }
    }

    /// Renders what `draw` draws into an sRGB image with straight alpha.
    pub fn shoot(
        &mut self,
        draw: impl FnOnce(&mut SceneRenderer, &wgpu::Device, &wgpu::Queue) -> Result<wgpu::Texture, RenderError>,
    ) -> Result<RgbaImage, RenderError> {
        let Self { device, queue, renderer } = self;
        guarded(device, || {
            draw(renderer, device, queue).and_then(|target| Readback::begin(device, queue, &target).wait(device))
        })
    }
}
