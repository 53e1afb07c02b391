//! The viewports: cameras, gestures, dots, uploads and drawing, for planar domains and surfaces.
//!
//! | content | file |
//! |---|---|
//! | the camera of a planar viewport | `view` |
//! | gestures and dots over a planar domain | `planar` |
//! | the viewport of a surface | `surface` |
//! | the state of both pictures | `pictures` |
//! | a side's picture: of a plane or of a surface | `picture` |
//! | dragging and painting the dots | `dots` |
//! | which dots there are, and what moves them | `moves` |
//! | adding pins, and their misses | `pins` |
//! | the marks of a quadrilateral | `marks` |
//! | the brush of a region and the landscape of the best map | `best` |
//! | the marks at an outline's corners | `corners` |
//! | axes and centers of symmetry | `symmetry` |
//! | moving the texture's picture | `picture_gestures` |
//! | a small circle with a cross, and its image | `probe` |
//! | uploads to the GPU and drawing | `gpu`, `gpu_extension`, `cells` |
//! | the texture coordinates of a layout | `uv` |
//! | the legend of triangle colors | `legend` |

pub mod best;
pub mod cells;
mod corners;
pub mod dots;
pub mod gpu;
mod gpu_extension;
pub mod legend;
pub mod marks;
mod moves;
pub mod picture;
mod picture_gestures;
pub mod pictures;
mod pins;
pub mod planar;
pub mod probe;
pub mod surface;
mod symmetry;
pub mod uv;
pub mod view;
