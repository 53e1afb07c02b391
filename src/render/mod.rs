//! Drawing the textured meshes with wgpu, in the plane and in space: on screen and into images.
//!
//! [`ViewportRenderer`] owns the pipelines and, for every viewport, its buffers
//! and off-screen targets: `prepare` renders a viewport, if anything in it has changed, into its own
//! target, multisampled if requested, `paint` copies the result into the caller's pass.
//! `scene` does the same into a texture of any size, `readback` reads its pixels back, and
//! `headless` does both without a window.
//!
//! Guarantees: every color in this API is sRGB-encoded with straight alpha, and
//! a flat color appears on the screen as requested to within 1/255. Positions are
//! f64 here and become f32 once, at upload, relative to the middle of the uploaded
//! points. Not guaranteed: sharpness beyond a magnification of about 10⁵ of a
//! mesh's extent, where the f32 steps become visible.

mod blit_pass;
mod camera;
mod cauchy_green_buffers;
mod cauchy_green_pass;
mod cell_lookup;
mod cell_pass;
mod color_map;
mod disc_pass;
mod drawn;
mod error;
mod eye_uniform;
mod film;
mod gpu;
mod image_texture;
mod local_scale;
mod mesh_pass;
mod messages;
mod orbit_camera;
mod palette;
mod pattern_uniform;
mod placement;
mod png_file;
mod readback;
mod rehearsal;
mod scene;
mod scene_surface;
mod space_vertices;
mod stroke_pass;
mod style;
mod surface_pass;
mod surface_stroke;
mod surface_viewport;
mod targets;
mod viewport;

#[cfg(not(target_arch = "wasm32"))]
mod headless;

pub use camera::Camera;
pub use cauchy_green_buffers::CauchyGreenBuffers;
pub use cauchy_green_pass::CauchyGreenPass;
pub use color_map::{CellCode, ColourMap, flipped_colour};
pub use drawn::{Detail, Pace, PlanarFrame, REFINED_AFTER, SpaceFrame};
pub use error::{ImageError, MeshFault, ReadbackFault, RenderError};
pub use film::{Film, FilmError, FilmFormat, FilmSettings, MOST_FRAMES, SECONDS};
pub use gpu::{Graphics, Target, sample_count};
#[cfg(not(target_arch = "wasm32"))]
pub use headless::{Studio, headless_device, render_scene, render_scene_with};
pub use image_texture::on_paper;
pub use local_scale::{LocalScale, double_area};
pub use orbit_camera::{BoundingSphere, OrbitCamera};
pub use png_file::PngFile;
pub use readback::{Readback, guarded};
pub use scene::{SceneCells, SceneDescription, ScenePicture, SceneRenderer, SceneViewport};
pub use scene_surface::SceneSurface;
pub use style::{CellStyle, Handle, Pattern, StrokeStyle, TextureStyle};
pub use surface_viewport::{SurfaceGeometry, SurfaceHandle};
pub use viewport::{MeshGeometry, ViewportRenderer};
