//! Reads the pixels of a texture back from the graphics device.
//!
//! A browser does not allow waiting for the device: [`Readback::poll`] asks whether they have arrived.

use super::{ReadbackFault, RenderError};
use image::RgbaImage;
use std::pin::pin;
use std::sync::mpsc;
use std::task::{Context, Poll, Waker};

/// A pending readback of pixels.
#[derive(Debug)]
pub struct Readback {
    buffer: wgpu::Buffer,
    mapped: mpsc::Receiver<Result<(), wgpu::BufferAsyncError>>,
    size: [u32; 2],
}

impl Readback {
    /// Requests the pixels of an 8-bit RGBA `texture`, as they are after all submitted commands.
    pub fn begin(device: &wgpu::Device, queue: &wgpu::Queue, texture: &wgpu::Texture) -> Self {
        let size = [texture.width(), texture.height()];
        let row = padded_row(size[0]);
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("readback"),
            size: u64::from(row) * u64::from(size[1]),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("readback") });
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row), rows_per_image: None };
        let destination = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
        encoder.copy_texture_to_buffer(texture.as_image_copy(), destination, texture.size());
        queue.submit([encoder.finish()]);
        let (sender, mapped) = mpsc::channel();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            // The send fails if the readback was dropped; then the result is not needed.
            let _ = sender.send(result);
        });
        Self { buffer, mapped, size }
    }

    /// The picture with straight alpha once it has arrived. Does not block.
    pub fn poll(&self, device: &wgpu::Device) -> Option<Result<RgbaImage, RenderError>> {
        if let Err(error) = device.poll(wgpu::PollType::Poll) {
            return Some(Err(failed(&error)));
        }
        match self.mapped.try_recv() {
            Ok(Ok(())) => Some(self.picture()),
            Ok(Err(error)) => Some(Err(failed(&error))),
            Err(mpsc::TryRecvError::Empty) => None,
            Err(mpsc::TryRecvError::Disconnected) => Some(Err(RenderError::Readback(ReadbackFault::DeviceGone))),
        }
    }

    /// Blocks until the picture has arrived; native only.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn wait(&self, device: &wgpu::Device) -> Result<RgbaImage, RenderError> {
        device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| failed(&error))?;
        let mapped = self.mapped.recv().map_err(|error| failed(&error))?;
        mapped.map_err(|error| failed(&error))?;
        self.picture()
    }

    fn picture(&self) -> Result<RgbaImage, RenderError> {
        let [width, height] = self.size;
        let padded = self.buffer.get_mapped_range(..).map_err(|error| failed(&error))?;
        let mut pixels = Vec::with_capacity(4 * width as usize * height as usize);
        for line in padded.chunks_exact(padded_row(width) as usize) {
            pixels.extend(line[..4 * width as usize].chunks_exact(4).flat_map(straight));
        }
        let missing = || RenderError::Readback(ReadbackFault::TooShort { width, height });
        RgbaImage::from_raw(width, height, pixels).ok_or_else(missing)
    }
}

/// The graphics library's message as an error.
pub(super) fn failed(error: &impl ToString) -> RenderError {
    RenderError::Readback(ReadbackFault::Library(error.to_string()))
}

/// Carries out `work` and reports the device's validation errors: immediately with native backends and WebGL. WebGPU
/// reports them later, by failing the readback.
pub fn guarded<R>(device: &wgpu::Device, work: impl FnOnce() -> Result<R, RenderError>) -> Result<R, RenderError> {
    let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
    let validation = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let result = work();
    match [now(validation.pop()), now(memory.pop())].into_iter().flatten().next() {
        Some(error) => Err(RenderError::Device(error.to_string())),
        None => result,
    }
}

/// The value of the future, if it is ready.
fn now(answer: impl Future<Output = Option<wgpu::Error>>) -> Option<wgpu::Error> {
    match pin!(answer).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(error) => error,
        Poll::Pending => None,
    }
}

/// The bytes of a row in the copy buffer, padded to the copy alignment.
fn padded_row(width: u32) -> u32 {
    (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}

/// Undoes the premultiplication of an encoded pixel.
fn straight(pixel: &[u8]) -> [u8; 4] {
    if pixel[3] == 255 {
        return [pixel[0], pixel[1], pixel[2], 255];
    }
    let alpha = u32::from(pixel[3]);
    let channel = |value: u8| (u32::from(value) * 255 + alpha / 2).checked_div(alpha).unwrap_or(0).min(255) as u8;
    [channel(pixel[0]), channel(pixel[1]), channel(pixel[2]), pixel[3]]
}

#[cfg(test)]
mod tests {
    use super::straight;

    #[test]
    fn a_half_covered_pixel_gets_its_straight_color_back() {
        assert_eq!(straight(&[100, 50, 25, 128]), [199, 100, 50, 128]);
        assert_eq!(straight(&[7, 200, 0, 255]), [7, 200, 0, 255]);
        assert_eq!(straight(&[0, 0, 0, 0]), [0; 4], "nothing has no colour");
        assert_eq!(straight(&[9, 8, 7, 8]), [255, 255, 223, 8], "never more than there is");
    }
}
