//! Export of maps to files, for the command line and the app. Pure: turns maps into bytes, without I/O.
//!
//! `flattened`: surfaces with texture coordinates; `as_read`: in their own files; `glb`: as a self-contained glTF file. `numbers`: tables of maps between any two sides, `mapped`: their meshes.
//! `formula`: maps as rational functions, in numbers and code. `drawing`: vector graphics of the planar parts of a map,
//! with the pattern lines of `ruling` and `tiles`; `grid`: orthogonal grids; `projection`: map projections, with the
//! numbers of `projected`; `hatching`: what a map does not cover.

mod as_read;
mod drawing;
mod flattened;
mod format;
mod formula;
mod glb;
mod grid;
mod hatching;
mod mapped;
mod numbers;
mod polylines;
mod projected;
mod projection;
mod ruling;
mod tiles;

pub use as_read::{EncodedSurface, SurfaceSource};
pub use drawing::{Panel, Part, Wire, panels, parts, svg};
pub use flattened::{Division, Flattened, Placement};
pub use format::FileFormat;
pub use formula::{FormulaFile, FormulaFormat};
pub use glb::Base;
pub use grid::GridFormat;
pub use hatching::{hatched, hatching};
pub use mapped::mapped_mesh;
pub use numbers::boundary_csv;
pub use polylines::Line;
pub use projected::ProjectionReport;
pub use projection::{ProjectionFormat, ScaleLines, scale_lines};
pub use ruling::Ruling;
