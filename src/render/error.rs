//! Errors of rendering: images, meshes, adapters and readback.
//!
//! Drawing on screen does not fail: wgpu reports a lost device to the shell.
//! Images come from users' files and adapters from their machines, so these
//! have typed errors.

/// Why an image cannot serve as a texture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
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

/// Why a mesh cannot be drawn: it is inconsistent or too large.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshFault {
    /// Positions and texture coordinates differ in number.
    #[error("{positions} positions have {coordinates} texture coordinates")]
    Coordinates {
        /// The number of positions.
        positions: usize,
        /// The number of texture coordinates.
        coordinates: usize,
    },
    /// Triangles and their codes differ in number.
    #[error("{triangles} triangles have {codes} codes")]
    Codes {
        /// The number of triangles.
        triangles: usize,
        /// The number of codes.
        codes: usize,
    },
    /// The boundary loop is longer than the list of vertices.
    #[error("a boundary of {boundary} vertices where there are {vertices}")]
    Boundary {
        /// The number of its vertices.
        boundary: u32,
        /// The number of all vertices.
        vertices: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} {corners:?} names a vertex beyond the {vertices} given")]
    Vertex {
        /// Index of the triangle, from 0.
        triangle: usize,
        /// Its corners.
        corners: [u32; 3],
        /// The number of vertices.
        vertices: usize,
    },
    /// The device has no buffer of this size.
    #[error("{triangles} triangles do not fit on the graphics device")]
    TooLarge {
        /// The number of triangles.
        triangles: usize,
    },
}

/// Why pixels could not be read back from the device.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadbackFault {
    /// The graphics library's message.
    #[error("{0}")]
    Library(String),
    /// The device was lost.
    #[error("the device has gone away")]
    DeviceGone,
    /// The buffer is too short.
    #[error("fewer bytes than {width} × {height} pixels")]
    TooShort {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
}

/// Why a scene could not be rendered without a window.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// No graphics adapter, not even a software one.
    #[error("no graphics adapter found; on Linux, mesa-vulkan-drivers brings a software one ({cause})")]
    NoAdapter {
        /// The graphics library's message.
        cause: String,
    },
    /// The adapter provides no device.
    #[error("the adapter {adapter} gives no device: {cause}")]
    NoDevice {
        /// The adapter's name.
        adapter: String,
        /// The graphics library's message.
        cause: String,
    },
    /// The image has no pixels, or is larger than the device can draw.
    #[error("cannot render an image of {width} × {height} pixels: this device draws from 1 to {limit} per side")]
    Size {
        /// Requested width.
        width: u32,
        /// Requested height.
        height: u32,
        /// The device's limit.
        limit: u32,
    },
    /// A scene without a viewport, or with more of them than pixel columns.
    #[error("a scene needs from 1 to {limit} viewports, this one has {count}")]
    ViewportCount {
        /// Number of viewports in the scene.
        count: usize,
        /// One per pixel column at most.
        limit: u32,
    },
    /// A viewport's mesh is inconsistent.
    #[error("viewport {viewport}: {fault}")]
    Geometry {
        /// Index of the viewport, from 0.
        viewport: usize,
        /// The fault of its mesh.
        fault: MeshFault,
    },
    /// A surface is inconsistent, or too large.
    #[error("surface: {fault}")]
    Surface {
        /// The fault of the surface.
        fault: MeshFault,
    },
    /// The texture image cannot be used.
    #[error("the texture image cannot be used: {0}")]
    Image(#[from] ImageError),
    /// The graphics library rejected a command.
    #[error("the graphics device reported an error: {0}")]
    Device(String),
    /// The pixels could not be read back.
    #[error("the rendered pixels could not be read back: {0}")]
    Readback(ReadbackFault),
}
