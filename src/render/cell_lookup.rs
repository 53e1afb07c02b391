//! Positions by vertex, codes by triangle and colors by code, as the textures that `shaders/cell_parts.wgsl` reads.
//!
//! Rows are [`ROW`] texels long: WebGL2 guarantees no more, which allows for 4 million triangles.

use super::{CellCode, ColourMap, gpu};

/// Texels per row; `ROW` of `shaders/cell_parts.wgsl`.
const ROW: u32 = 2048;

/// Positions by vertex and codes by triangle.
#[derive(Debug)]
pub struct Lookup {
    positions: wgpu::Texture,
    codes: wgpu::Texture,
    pub group: wgpu::BindGroup,
}

impl Lookup {
    /// Positions and codes, for the vertex stage.
    pub fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
        let entry = |binding, sample_type| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::VERTEX,
            ty: wgpu::BindingType::Texture {
                sample_type,
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        };
        device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("cells"),
            entries: &[
                entry(0, wgpu::TextureSampleType::Float { filterable: false }),
                entry(1, wgpu::TextureSampleType::Uint),
            ],
        })
    }

    /// Allocates textures for these numbers of vertices, of this format, and triangles, unless present. False,
    /// with nothing allocated, if the device has no textures of this size.
    pub fn provide(
        lookup: &mut Option<Self>,
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
        [vertices, triangles]: [usize; 2],
    ) -> bool {
        let [vertex_rows, triangle_rows] = [vertices, triangles].map(|count| count.div_ceil(ROW as usize).max(1));
        if vertex_rows.max(triangle_rows) > device.limits().max_texture_dimension_2d as usize {
            return false;
        }
        let [vertex_rows, triangle_rows] = [vertex_rows as u32, triangle_rows as u32];
        let large_enough =
            |lookup: &Self| lookup.positions.height() >= vertex_rows && lookup.codes.height() >= triangle_rows;
        if !lookup.as_ref().is_some_and(large_enough) {
            *lookup = Some(Self::new(device, layout, format, [vertex_rows, triangle_rows]));
        }
        true
    }

    fn new(
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
        [vertex_rows, triangle_rows]: [u32; 2],
    ) -> Self {
        let positions = texture(device, format, [ROW, vertex_rows]);
        let codes = texture(device, wgpu::TextureFormat::R8Uint, [ROW, triangle_rows]);
        let [a, b] = [&positions, &codes].map(|texture| texture.create_view(&wgpu::TextureViewDescriptor::default()));
        let entry =
            |binding, view| wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) };
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("cells"),
            layout,
            entries: &[entry(0, &a), entry(1, &b)],
        });
        Self { positions, codes, group }
    }

    /// Writes the positions from the first vertex on; `texels` is padded.
    pub fn write_positions<T: bytemuck::Pod>(&self, queue: &wgpu::Queue, texels: &mut Vec<T>) {
        texels.resize(texels.len().next_multiple_of(ROW as usize), T::zeroed());
        write_rows(queue, &self.positions, texels);
    }

    /// Writes the codes from the first triangle on; `codes` is padded on the way.
    pub fn write_codes(&self, queue: &wgpu::Queue, codes: &mut Vec<CellCode>) {
        let count = codes.len();
        codes.resize(count.next_multiple_of(ROW as usize), CellCode::COLLAPSED);
        write_rows(queue, &self.codes, codes);
        codes.truncate(count);
    }
}

/// Fills the first rows of `texture` with whole rows of `texels`.
fn write_rows<T: bytemuck::Pod>(queue: &wgpu::Queue, texture: &wgpu::Texture, texels: &[T]) {
    let bytes_per_row = Some(ROW * size_of::<T>() as u32);
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None };
    let size = wgpu::Extent3d { width: ROW, height: texels.len() as u32 / ROW, depth_or_array_layers: 1 };
    queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(texels), layout, size);
}

fn texture(device: &wgpu::Device, format: wgpu::TextureFormat, [width, height]: [u32; 2]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("cells"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

/// The palettes, in the order of [`ColourMap`], and their layout.
pub fn palette_groups(device: &wgpu::Device, queue: &wgpu::Queue) -> (wgpu::BindGroupLayout, [wgpu::BindGroup; 2]) {
    let layout = gpu::texture_layout(device, "palette", false);
    let groups = [ColourMap::Cividis, ColourMap::Diverging].map(|map| {
        let colours = map.palette();
        let texture = texture(device, wgpu::TextureFormat::Rgba8UnormSrgb, [colours.len() as u32, 1]);
        let row = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * 256), rows_per_image: None };
        queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(&colours), row, texture.size());
        gpu::texture_group(device, &layout, &texture.create_view(&wgpu::TextureViewDescriptor::default()), None)
    });
    (layout, groups)
}
