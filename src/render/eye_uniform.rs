//! The uniform block of an eye for `shaders/space.wgsl`.

use super::OrbitCamera;
use super::space_vertices::LocalFrame;
use glam::{DMat3, DMat4};

/// `Eye` of `shaders/space.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct EyeUniform {
    clip: [[f32; 4]; 4],
    turn: [[f32; 4]; 3],
    depth: [f32; 4],
}

impl EyeUniform {
    /// For positions in `frame`, in a viewport of `size_px`. Lines on the surface are drawn nearer to the eye
    /// by the length of `lift_px` pixels; `light` is the light's part of colors, from 0 to 1.
    pub fn new(camera: &OrbitCamera, frame: LocalFrame, size_px: [u32; 2], lift_px: f64, light: f32) -> Self {
        let [width, height] = size_px.map(f64::from);
        // the large numbers cancel here, in f64
        let mut clip = camera.view_projection(width / height) * DMat4::from_translation(frame.origin);
        // clip coordinates in the frame's unit; so is w, the distance from the eye, by which they are divided
        clip.w_axis /= frame.unit;
        let turn = DMat3::from_quat(camera.rotation.inverse());
        let (near, far) = camera.depths();
        let lift = lift_px * camera.units_per_pixel_at_one(size_px);
        Self {
            clip: clip.to_cols_array_2d().map(|column| column.map(|x| x as f32)),
            turn: turn.to_cols_array_2d().map(|[x, y, z]| [x as f32, y as f32, z as f32, 0.0]),
            depth: [(far / (far - near)) as f32, (near / frame.unit * far / (near - far)) as f32, lift as f32, light],
        }
    }
}
