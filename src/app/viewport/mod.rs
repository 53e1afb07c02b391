//! The viewports: what each shows of the plane or of a surface, and the gestures over it.
//!
//! | what | file |
//! |---|---|
//! | which part of the plane is shown | `view` |
//! | gestures and dots over a planar domain | `planar` |
//! | a surface in space | `surface` |
//! | the dots | `dots` |
//! | uploads and drawing | `gpu`, `gpu_extension`, `cells` |
//! | the legend of triangle colours | `legend` |

pub mod cells;
pub mod dots;
pub mod gpu;
mod gpu_extension;
pub mod legend;
pub mod planar;
pub mod surface;
pub mod view;
