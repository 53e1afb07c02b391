//! Shared parts of all passes: shaders, pipelines, buffers that
//! grow, bind-group entries.
//!
//! Everything but compute shaders stays within WebGL2: vertex and uniform
//! buffers only, uniform blocks made of `vec4`s. Buffers are filled with `write_buffer`, never mapped
//! at creation, which crashes some browsers' software adapters.

use glam::DVec2;

/// The device for drawing and its queue.
pub type Graphics<'a> = (&'a wgpu::Device, &'a wgpu::Queue);

/// A picture on the device.
pub type Target = wgpu::Texture;

/// Format of the off-screen pictures: linear when blended, resolved and
/// sampled, encoded where it is stored.
pub const PICTURE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

/// Format of the depth of surfaces in space: cleared to 1, the far plane.
pub const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

/// 4 where the device can multisample and resolve `PICTURE_FORMAT`, else 1.
pub fn sample_count(device: &wgpu::Device) -> u32 {
    let flags = PICTURE_FORMAT.guaranteed_format_features(device.features()).flags;
    let needed = wgpu::TextureFormatFeatureFlags::MULTISAMPLE_X4 | wgpu::TextureFormatFeatureFlags::MULTISAMPLE_RESOLVE;
    if flags.contains(needed) { 4 } else { 1 }
}

/// The properties in which the pipelines differ.
pub struct PipelineSpec<'a> {
    pub label: &'a str,
    pub shader: &'a wgpu::ShaderModule,
    pub fragment: &'a str,
    pub groups: &'a [&'a wgpu::BindGroupLayout],
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub topology: wgpu::PrimitiveTopology,
    pub format: wgpu::TextureFormat,
    pub blend: Option<wgpu::BlendState>,
    pub samples: u32,
}

/// Depth settings of a pipeline: drawn where nothing nearer has been drawn.
pub struct Depth<'a> {
    /// The vertex entry point.
    pub vertex: &'a str,
    /// Whether the depth is written, so that later geometry behind it is hidden.
    pub written: bool,
    /// Whether alpha decides how many samples are covered; only with several samples per pixel.
    pub alpha_to_coverage: bool,
}

/// A pipeline with the vertex entry point `vs_main`, no culling, no depth.
pub fn pipeline(device: &wgpu::Device, spec: &PipelineSpec) -> wgpu::RenderPipeline {
    build(device, spec, "vs_main", None, false)
}

/// The same with a depth buffer of [`DEPTH_FORMAT`].
pub fn pipeline_with_depth(device: &wgpu::Device, spec: &PipelineSpec, depth: &Depth) -> wgpu::RenderPipeline {
    let state = wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(depth.written),
        depth_compare: Some(wgpu::CompareFunction::LessEqual),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    };
    build(device, spec, depth.vertex, Some(state), depth.alpha_to_coverage)
}

fn build(
    device: &wgpu::Device,
    spec: &PipelineSpec,
    vertex: &str,
    depth_stencil: Option<wgpu::DepthStencilState>,
    alpha_to_coverage_enabled: bool,
) -> wgpu::RenderPipeline {
    let groups: Vec<_> = spec.groups.iter().map(|group| Some(*group)).collect();
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(spec.label),
        bind_group_layouts: &groups,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(spec.label),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: spec.shader,
            entry_point: Some(vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: spec.buffers,
        },
        primitive: wgpu::PrimitiveState { topology: spec.topology, ..Default::default() },
        depth_stencil,
        multisample: wgpu::MultisampleState { count: spec.samples, alpha_to_coverage_enabled, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module: spec.shader,
            entry_point: Some(spec.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: spec.format,
                blend: spec.blend,
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// A WGSL module.
pub fn shader(device: &wgpu::Device, label: &str, source: &'static str) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    })
}

/// A layout of one uniform block for both stages.
pub fn uniform_layout(device: &wgpu::Device, label: &str) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        }],
    })
}

/// A layout of one filterable texture, with a sampler at binding 1 if asked.
pub fn texture_layout(device: &wgpu::Device, label: &str, sampled: bool) -> wgpu::BindGroupLayout {
    let texture = wgpu::BindGroupLayoutEntry {
        binding: 0,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    };
    let sampler = wgpu::BindGroupLayoutEntry {
        binding: 1,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        count: None,
    };
    let both = [texture, sampler];
    let entries = if sampled { &both[..] } else { &both[..1] };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
}

/// The group of a [`texture_layout`].
pub fn texture_group(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    view: &wgpu::TextureView,
    sampler: Option<&wgpu::Sampler>,
) -> wgpu::BindGroup {
    let mut entries = vec![wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(view) }];
    if let Some(sampler) = sampler {
        entries.push(wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(sampler) });
    }
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}

/// A uniform block with its group.
#[derive(Debug)]
pub struct Uniform {
    buffer: wgpu::Buffer,
    pub group: wgpu::BindGroup,
}

impl Uniform {
    /// A block of `size` bytes for a [`uniform_layout`].
    pub fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, size: usize) -> Self {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("uniform block"),
            size: size as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
        });
        Self { buffer, group }
    }

    /// Replaces the block's value.
    pub fn write<T: bytemuck::Pod>(&self, queue: &wgpu::Queue, value: &T) {
        queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(value));
    }
}

/// A vertex or index buffer that is replaced by a larger one when needed.
#[derive(Debug)]
pub struct GrowingBuffer {
    usage: wgpu::BufferUsages,
    buffer: Option<wgpu::Buffer>,
}

impl GrowingBuffer {
    /// Without a buffer yet; `usage` is given without `COPY_DST`.
    pub fn new(usage: wgpu::BufferUsages) -> Self {
        Self { usage: usage | wgpu::BufferUsages::COPY_DST, buffer: None }
    }

    /// Writes `contents` from the start, into a larger buffer if needed. False,
    /// with nothing written, if the device has no buffers of this size.
    pub fn write<T: bytemuck::Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, contents: &[T]) -> bool {
        let bytes: &[u8] = bytemuck::cast_slice(contents);
        let needed = bytes.len() as u64;
        if needed > device.limits().max_buffer_size {
            log::error!("the graphics device has no buffer of {needed} bytes");
            return false;
        }
        if self.buffer.as_ref().is_none_or(|buffer| buffer.size() < needed) {
            self.buffer = Some(device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("geometry"),
                size: needed,
                usage: self.usage,
                mapped_at_creation: false,
            }));
        }
        self.overwrite(queue, contents);
        true
    }

    /// Writes `contents`, which must fit, from the start.
    pub fn overwrite<T: bytemuck::Pod>(&self, queue: &wgpu::Queue, contents: &[T]) {
        if let Some(buffer) = &self.buffer
            && !contents.is_empty()
        {
            queue.write_buffer(buffer, 0, bytemuck::cast_slice(contents));
        }
    }

    /// The buffer; `None` before the first write.
    pub fn get(&self) -> Option<&wgpu::Buffer> {
        self.buffer.as_ref()
    }
}

/// Fills `staging` with `points` relative to the middle of their bounding box,
/// and returns that middle. Planar coordinates become f32 only here (spatial ones in `LocalFrame`).
pub fn stage_points(staging: &mut Vec<[f32; 2]>, points: &[DVec2]) -> DVec2 {
    let low = points.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = points.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let middle = 0.5 * (low + high);
    let origin = if middle.is_finite() { middle } else { DVec2::ZERO };
    staging.clear();
    staging.extend(points.iter().map(|&p| (p - origin).as_vec2().to_array()));
    origin
}
