//! What can go wrong between a mesh and its pixels.
//!
//! Drawing on screen does not fail: wgpu reports a lost device to the shell.
//! Images come from people's files and adapters from their machines, so these
//! have typed errors.

/// Why an image cannot serve as a texture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ImageError {
    /// Width or height is zero.
    #[error("the image has no pixels ({width} × {height})")]
    Empty {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The bytes are not `4 · width · height`.
    #[error("an RGBA image of {width} × {height} has {expected} bytes, these are {actual}")]
    ByteCount {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// `4 · width · height`.
        expected: u64,
        /// The number of bytes given.
        actual: u64,
    },
}

/// Why a scene could not be rendered without a window.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// No graphics adapter, not even a software one.
    #[error("no graphics adapter found; on Linux, mesa-vulkan-drivers brings a software one ({cause})")]
    NoAdapter {
        /// What the graphics library said.
        cause: String,
    },
    /// The adapter does not give a device.
    #[error("the adapter {adapter} gives no device: {cause}")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// What the graphics library said.
        cause: String,
    },
    /// An image of no pixels, or larger than the device can draw.
    #[error("cannot render an image of {width} × {height} pixels: this device draws from 1 to {limit} per side")]
    Size {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
        /// The device's limit.
        limit: u32,
    },
    /// A scene without a viewport, or with more of them than pixel columns.
    #[error("a scene needs from 1 to {limit} viewports, this one has {count}")]
    ViewportCount {
        /// Viewports in the scene.
        count: usize,
        /// One per pixel column at most.
        limit: u32,
    },
    /// A viewport's mesh is inconsistent.
    #[error("viewport {viewport}: {reason}")]
    Geometry {
        /// Which viewport, from 0.
        viewport: usize,
        /// What is wrong with its mesh.
        reason: String,
    },
    /// A surface is inconsistent, or too large.
    #[error("surface: {reason}")]
    Surface {
        /// What is wrong with it.
        reason: String,
    },
    /// The texture image cannot be used.
    #[error("the texture image cannot be used: {0}")]
    Image(#[from] ImageError),
    /// The graphics library rejected a command.
    #[error("the graphics device reported an error: {0}")]
    Device(String),
    /// The pixels did not come back.
    #[error("the rendered pixels could not be read back: {0}")]
    Readback(String),
}
