//! The panels: controls beside the pictures, titles, buttons and messages over them.
//!
//! | content | file |
//! |---|---|
//! | the column of controls | `side_panel`, `surface_panel`, `play_panel` |
//! | which map: by points or by pins | `pins_panel` |
//! | the best map of the family; the course of its search | `best_panel` |
//! | the boundary loops of a surface | `loops_panel` |
//! | its folded part, whatever names a method | `advanced`, `method`, `interpretation`, `symmetry_panel`, `invariants_panel`, `quadrilateral_panel` |
//! | the welcome of the first visit | `welcome` |
//! | the hyperbolic tiling; the placement of the texture's picture | `tiling_panel`, `picture_panel` |
//! | title, buttons and messages of a picture; the legend of its signs | `header`, `sign_legend` |
//! | the menu of outlines and surfaces; the shapes of a file; their cells | `shapes` |
//! | the offers to trace a picture, to take another shape, and to map a region | `offer` |

mod advanced;
pub mod best_panel;
pub mod header;
mod interpretation;
pub mod invariants_panel;
mod loops_panel;
pub mod method;
pub mod offer;
mod picture_panel;
pub mod pins_panel;
pub mod play_panel;
pub mod quadrilateral_panel;
pub mod shapes;
pub mod side_panel;
pub mod sign_legend;
mod sketch;
pub mod surface_panel;
pub mod symmetry_panel;
mod tiling_panel;
pub mod welcome;
