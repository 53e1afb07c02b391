//! Drawing the textured meshes with wgpu: on screen and into images.
