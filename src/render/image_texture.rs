//! The texture image: flattened, scaled to the device's limits, mip-mapped, anisotropic.
//!
//! An image larger than the device's textures is scaled down to fit, its aspect
//! kept to within a pixel. Transparent parts are laid over the palette's paper
//! color. Beyond its edges the image is mirrored.

use super::ImageError;
use super::gpu::{self, PipelineSpec};
use super::style::PAPER;
use image::RgbaImage;

/// Makes mip levels and owns the sampler.
#[derive(Debug)]
pub struct ImageTextures {
    /// The layout of texture and sampler, also used by the mesh pass.
    pub layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    mipmap: wgpu::RenderPipeline,
}

/// The image in use.
#[derive(Debug)]
pub struct ImageTexture {
    pub group: wgpu::BindGroup,
    /// Width over height.
    pub aspect: f64,
}

impl ImageTextures {
    /// Sampler and mip-map pipeline.
    pub fn new(device: &wgpu::Device) -> Self {
        let layout = gpu::texture_layout(device, "image", true);
        let shader = gpu::shader(device, "mipmap", include_str!("../../shaders/mipmap.wgsl"));
        let spec = PipelineSpec {
            label: "mipmap",
            shader: &shader,
            fragment: "fs_main",
            groups: &[&layout],
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            format: gpu::PICTURE_FORMAT,
            blend: None,
            samples: 1,
        };
        let mipmap = gpu::pipeline(device, &spec);
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("image"),
            address_mode_u: wgpu::AddressMode::MirrorRepeat,
            address_mode_v: wgpu::AddressMode::MirrorRepeat,
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            mipmap_filter: wgpu::MipmapFilterMode::Linear,
            anisotropy_clamp: 16,
            ..Default::default()
        });
        Self { layout, sampler, mipmap }
    }

    /// One pixel of the paper color, used until an image is loaded.
    pub fn blank(&self, device: &wgpu::Device, queue: &wgpu::Queue) -> ImageTexture {
        self.upload(device, queue, &RgbaImage::from_pixel(1, 1, image::Rgba(paper_bytes())))
    }

    /// A texture from `width × height` sRGB-encoded RGBA bytes, straight alpha.
    pub fn load(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        rgba: &[u8],
        width: u32,
        height: u32,
    ) -> Result<ImageTexture, ImageError> {
        let mut image = parse(rgba, width, height)?;
        let limit = device.limits().max_texture_dimension_2d;
        if width.max(height) > limit {
            let scale = f64::from(limit) / f64::from(width.max(height));
            let scaled = |side: u32| ((f64::from(side) * scale).round() as u32).clamp(1, limit);
            image = image::imageops::thumbnail(&image, scaled(width), scaled(height));
        }
        flatten(&mut image);
        Ok(self.upload(device, queue, &image))
    }

    fn upload(&self, device: &wgpu::Device, queue: &wgpu::Queue, image: &RgbaImage) -> ImageTexture {
        let (width, height) = image.dimensions();
        let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("image"),
            size,
            mip_level_count: width.max(height).ilog2() + 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: gpu::PICTURE_FORMAT,
            usage: wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_DST
                | wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * width), rows_per_image: None };
        queue.write_texture(texture.as_image_copy(), image.as_raw(), layout, size);
        self.fill_mip_levels(device, queue, &texture);
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let group = gpu::texture_group(device, &self.layout, &view, Some(&self.sampler));
        ImageTexture { group, aspect: f64::from(width) / f64::from(height) }
    }

    fn fill_mip_levels(&self, device: &wgpu::Device, queue: &wgpu::Queue, texture: &wgpu::Texture) {
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("mipmap") });
        let level = |base_mip_level| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                base_mip_level,
                mip_level_count: Some(1),
                ..Default::default()
            })
        };
        for below in 1..texture.mip_level_count() {
            let group = gpu::texture_group(device, &self.layout, &level(below - 1), Some(&self.sampler));
            let target = level(below);
            let attachment = super::targets::attachment(&target, wgpu::LoadOp::Clear(wgpu::Color::BLACK));
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("mipmap"),
                color_attachments: &[Some(attachment)],
                ..Default::default()
            });
            pass.set_pipeline(&self.mipmap);
            pass.set_bind_group(0, &group, &[]);
            pass.draw(0..3, 0..1);
        }
        queue.submit([encoder.finish()]);
    }
}

fn parse(rgba: &[u8], width: u32, height: u32) -> Result<RgbaImage, ImageError> {
    if width == 0 || height == 0 {
        return Err(ImageError::Empty { width, height });
    }
    let (expected, actual) = (4 * u64::from(width) * u64::from(height), rgba.len() as u64);
    let mismatch = ImageError::ByteCount { width, height, expected, actual };
    if actual != expected {
        return Err(mismatch);
    }
    RgbaImage::from_raw(width, height, rgba.to_vec()).ok_or(mismatch)
}

/// Lays transparent pixels over the paper, in encoded space as browsers do.
fn flatten(image: &mut RgbaImage) {
    let paper = paper_bytes().map(u32::from);
    for pixel in image.pixels_mut() {
        let alpha = u32::from(pixel.0[3]);
        for (channel, paper) in pixel.0.iter_mut().zip(paper).take(3) {
            *channel = ((u32::from(*channel) * alpha + paper * (255 - alpha) + 127) / 255) as u8;
        }
        pixel.0[3] = 255;
    }
}

/// The image over the palette's paper color, opaque, with `margin` pixels of paper around it.
pub fn on_paper(image: &RgbaImage, margin: u32) -> RgbaImage {
    let (width, height) = image.dimensions();
    let mut framed = RgbaImage::from_pixel(width + 2 * margin, height + 2 * margin, image::Rgba(paper_bytes()));
    image::imageops::replace(&mut framed, image, i64::from(margin), i64::from(margin));
    flatten(&mut framed);
    framed
}

fn paper_bytes() -> [u8; 4] {
    PAPER.map(|component| (255.0 * component).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_of_the_wrong_length_or_of_no_pixels_is_refused() {
        let short = parse(&[0; 15], 2, 2);
        assert_eq!(short, Err(ImageError::ByteCount { width: 2, height: 2, expected: 16, actual: 15 }));
        assert_eq!(parse(&[], 0, 3), Err(ImageError::Empty { width: 0, height: 3 }));
    }

    #[test]
    fn transparent_pixels_show_the_paper() {
        let mut image = RgbaImage::from_raw(2, 1, vec![10, 20, 30, 0, 10, 20, 30, 255]).unwrap_or_default();
        flatten(&mut image);
        assert_eq!(image.get_pixel(0, 0).0, paper_bytes());
        assert_eq!(image.get_pixel(1, 0).0, [10, 20, 30, 255]);
    }
}
