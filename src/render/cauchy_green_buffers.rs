//! The buffers that `shaders/cauchy_green.wgsl` reads and writes for one contour.
//!
//! Positions are integers, so that their differences are exact on any GPU. They are rounded
//! by up to 2⁻³¹ of the contour's extent, to even numbers, so that midpoints of edges are integers
//! too. The extension is that of the rounded polygon at the rounded points: where f̂ stretches the
//! extent of the contour to s times that of the images, they are off by 5e-10 s.

use super::RenderError;
use super::readback::failed;
use crate::geometry::Bounds;
use glam::DVec2;

/// Positions lie between −REACH and REACH: their differences are below 2³¹.
const REACH: f64 = ((1 << 30) - (1 << 10)) as f64;

/// `Sizes` of `shaders/cauchy_green.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Sizes {
    edges: u32,
    points: u32,
    scale: f32,
    unused: u32,
}

/// A contour and points inside it, with the values at its vertices and the points' images.
#[derive(Debug)]
pub struct CauchyGreenBuffers {
    sizes: wgpu::Buffer,
    values: wgpu::Buffer,
    images: wgpu::Buffer,
    group: wgpu::BindGroup,
    vertex_count: u32,
    point_count: u32,
    given: Vec<DVec2>,
    staging: Vec<[f32; 2]>,
    origin: DVec2,
}

impl CauchyGreenBuffers {
    /// `None` if a buffer is too large for the device, or would be empty.
    pub(super) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: &wgpu::BindGroupLayout,
        contour: &[DVec2],
        points: &[DVec2],
    ) -> Option<Self> {
        let limits = device.limits();
        let largest = (16 * points.len().max(contour.len())) as u64;
        if contour.is_empty()
            || points.is_empty()
            || largest > limits.max_buffer_size.min(limits.max_storage_buffer_binding_size)
        {
            return None;
        }
        let make = |label, size: usize, usage| {
            let (label, size) = (Some(label), size as u64);
            device.create_buffer(&wgpu::BufferDescriptor { label, size, usage, mapped_at_creation: false })
        };
        let (storage, writable) = (wgpu::BufferUsages::STORAGE, wgpu::BufferUsages::COPY_DST);
        let sizes = make("sizes", size_of::<Sizes>(), wgpu::BufferUsages::UNIFORM | writable);
        let edges = make("edges", 16 * contour.len(), storage | writable);
        let places = make("points", 16 * points.len(), storage | writable);
        let values = make("values", 8 * contour.len(), storage | writable);
        let images = make("images", 8 * points.len(), storage | wgpu::BufferUsages::COPY_SRC);
        let lattice = Lattice::around(contour);
        queue.write_buffer(&edges, 0, bytemuck::cast_slice(&lattice.edges(contour)));
        queue.write_buffer(&places, 0, bytemuck::cast_slice(&lattice.points(points)));
        let entries = [&sizes, &edges, &places, &values, &images].into_iter().zip(0..);
        let entries: Vec<_> = entries
            .map(|(buffer, binding)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
            .collect();
        let group =
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some("contour"), layout, entries: &entries });
        let (vertex_count, point_count) = (contour.len() as u32, points.len() as u32);
        let result = Self {
            sizes,
            values,
            images,
            group,
            vertex_count,
            point_count,
            given: Vec::new(),
            staging: Vec::new(),
            origin: DVec2::ZERO,
        };
        result.write_sizes(queue, 0.0);
        Some(result)
    }

    /// Uploads the values at the contour's vertices, centered and scaled; false if their number is not the contour's.
    pub(super) fn set_values(&mut self, queue: &wgpu::Queue, values: impl IntoIterator<Item = DVec2>) -> bool {
        self.given.clear();
        self.given.extend(values);
        if self.given.len() != self.vertex_count as usize {
            return false;
        }
        let (middle, extent) = middle_and_extent(&self.given);
        let inverse = if extent > 0.0 { extent.recip() } else { 0.0 };
        self.staging.clear();
        self.staging.extend(self.given.iter().map(|&w| ((w - middle) * inverse).as_vec2().to_array()));
        self.origin = middle;
        queue.write_buffer(&self.values, 0, bytemuck::cast_slice(&self.staging));
        self.write_sizes(queue, extent);
        true
    }

    fn write_sizes(&self, queue: &wgpu::Queue, extent: f64) {
        let sizes = Sizes { edges: self.vertex_count, points: self.point_count, scale: extent as f32, unused: 0 };
        queue.write_buffer(&self.sizes, 0, bytemuck::bytes_of(&sizes));
    }

    pub(super) fn group(&self) -> &wgpu::BindGroup {
        &self.group
    }

    /// The number of points.
    pub fn point_count(&self) -> u32 {
        self.point_count
    }

    /// The points' images, two f32 each, relative to [`Self::origin`].
    pub fn images(&self) -> &wgpu::Buffer {
        &self.images
    }

    /// The middle of the bounds of the last values.
    pub fn origin(&self) -> DVec2 {
        self.origin
    }

    /// Passes the images of the last submitted evaluation to `take` when they have been read back:
    /// natively during a later `Device::poll`, in a browser without one.
    pub fn read_back(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        take: impl FnOnce(Result<Vec<DVec2>, RenderError>) + wgpu::WasmNotSend + 'static,
    ) {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("images"),
            size: self.images.size(),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("images") });
        encoder.copy_buffer_to_buffer(&self.images, 0, &buffer, 0, self.images.size());
        queue.submit([encoder.finish()]);
        let (origin, mapped) = (self.origin, buffer.clone());
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            let view = result.map_err(|error| failed(&error));
            let view = view.and_then(|()| mapped.get_mapped_range(..).map_err(|error| failed(&error)));
            take(view.map(|bytes| absolute(&bytes, origin)));
        });
    }
}

/// Points from the f32 pairs in `bytes`.
fn absolute(bytes: &[u8], origin: DVec2) -> Vec<DVec2> {
    let coordinate = |bytes: &[u8]| f64::from(bytemuck::pod_read_unaligned::<f32>(bytes));
    bytes.chunks_exact(8).map(|pair| origin + DVec2::new(coordinate(&pair[..4]), coordinate(&pair[4..]))).collect()
}

/// The middle of the bounding box and the longer of its sides.
fn middle_and_extent(points: &[DVec2]) -> (DVec2, f64) {
    let [low, high] = Bounds::of(points.iter().copied()).corners();
    (low.midpoint(high), (high - low).max_element())
}

/// The map from the plane to integer coordinates.
struct Lattice {
    middle: DVec2,
    scale: f64,
}

impl Lattice {
    fn around(contour: &[DVec2]) -> Self {
        let (middle, extent) = middle_and_extent(contour);
        Self { middle, scale: REACH / extent }
    }

    /// Half of the even coordinates; points outside the bounds are clamped to them.
    fn round(&self, p: DVec2) -> [i32; 2] {
        let reach = DVec2::splat(0.5 * REACH);
        ((p - self.middle) * self.scale).clamp(-reach, reach).round().to_array().map(|coordinate| coordinate as i32)
    }

    /// Midpoint and half step of every edge.
    fn edges(&self, contour: &[DVec2]) -> Vec<[i32; 4]> {
        let next = contour.iter().skip(1).chain(contour.first());
        let edge = |(&v, &w): (&DVec2, &DVec2)| {
            let ([x, y], [u, v]) = (self.round(v), self.round(w));
            [x + u, y + v, u - x, v - y]
        };
        contour.iter().zip(next).map(edge).collect()
    }

    /// The position of every point, and two zeros into which the shader writes.
    fn points(&self, points: &[DVec2]) -> Vec<[i32; 4]> {
        points.iter().map(|&p| self.round(p)).map(|[x, y]| [2 * x, 2 * y, 0, 0]).collect()
    }
}
