//! The conformal map: a prepared side, Poisson kernels, harmonic measures, their matching, its extension.
//!
//! [`prepare`] does the work of milliseconds to seconds that is needed once per side;
//! [`ConformalMap::update`] does what a drag needs, in a fraction of that time, and
//! [`ConformalMap::advance`] does the same in pieces, each until a deadline:
//!
//! | step | file | paper |
//! |---|---|---|
//! | Poisson kernel ψ at x | `kernel` | (9), (10), (B.2), by the adjoint solve |
//! | harmonic measure ω̃ from y | `measure` | (11), (12) |
//! | boundary correspondence | `matching` | section 3.2, C.4, in a form that does not cancel |
//! | measure and correspondence by the integral equation on the boundary | `curved` | |
//! | correspondence of parts with less than 1e-16 of both measures | `far_anchors` | |
//! | errors of finite elements by comparison with finer meshes | `comparison` | |
//! | images of the vertices | `extension` | (14) |
//! | the same by Cauchy's integral | `cauchy_green`, `refinement`, `exact_images` | (7), (15) |
//! | f and f′ at any point by Cauchy's integral over the boundary map | `anywhere` | |
//! | conformal polar coordinates | `disk_coordinates` | sections 1.2, 3.1 |
//! | the scale of the map to the disk, without crowding | `disk_scale` | |
//! | images on another surface, through the disk | `through_disk` | |
//! | the mapped mesh refined where images are long | `resolution` | |
//! | surfaces computed on finer meshes than their own | `subdivision` | |
//! | the constraints of the map through three boundary pairs, or nearest to more | `pins` | |
//! | the map of four marked boundary points onto the corners of a rectangle, orthogonal grids | `quadrilateral` | |
//! | angle and area distortion | `distortion`, `histogram` | section 5.1 |
//!
//! A [`PreparedSide`] is a planar domain or a surface (section 4.3); the two differ only in
//! geometry, and what both need is in file `system`. A map is between any two of them.
//!
//! [`Walker`] and [`HitCounts`] demonstrate harmonic measure: the distribution of the points where random walks hit the
//! boundary.

mod anywhere;
#[cfg(feature = "io")]
mod buffers;
mod cauchy_green;
mod comparison;
mod constraints;
mod corner_cuts;
mod curved;
mod disk_coordinates;
mod disk_scale;
mod distortion;
mod domain;
mod exact_images;
mod extension;
mod far_anchors;
#[cfg(feature = "io")]
mod flat;
mod histogram;
mod hit_counts;
mod kernel;
mod map;
mod map_error;
mod map_result;
mod map_run;
mod map_side;
mod matching;
mod measure;
mod measured;
mod moebius;
mod pins;
mod places;
mod prepare;
mod prepared_side;
mod quadrilateral;
mod random_walk;
mod refinement;
mod resolution;
mod stage;
mod stencil;
mod subdivision;
mod surface;
mod system;
mod table;
mod through_disk;
mod unfold;

pub use anywhere::{InteriorImage, InteriorMap, NoInteriorMap, SlicedInterior};
#[cfg(feature = "io")]
pub use buffers::NotFlat;
pub use cauchy_green::{BoundaryValues, CauchyGreen, CauchyGreenMode, Contour, STORED_BYTES};
use comparison::Differences;
pub use comparison::{QuarteredError, prepare_quartered};
pub use constraints::{Constraints, Direction, InteriorPoint, MapSettings, PerSide, Side};
pub use corner_cuts::{AddedVertex, CornerCuts, Divided};
#[cfg(feature = "io")]
pub(crate) use curved::FlatEquation;
pub use curved::{BoundaryEquation, CurveBoundary, CurveMap, ErrorEstimate, MAX_UNKNOWNS, Unsharpened};
pub(crate) use disk_coordinates::begin_disk_coordinates;
pub use disk_coordinates::disk_coordinates;
pub use disk_scale::log_disk_scale;
pub use distortion::{Quality, TriangleDistortion, triangle_distortions};
pub use domain::MeshedDomain;
pub(crate) use extension::ExtensionScratch;
pub use extension::{Extension, harmonic_extension};
#[cfg(feature = "io")]
pub(crate) use flat::FlatBuffers;
pub use histogram::Histogram;
pub use hit_counts::HitCounts;
pub use kernel::{harmonic_coordinates, poisson_kernel};
pub use map::{ConformalMap, FrameTimings};
pub use map_error::{MapError, MapNote};
pub use matching::{BoundaryCorrespondence, match_measures};
pub use measure::HarmonicMeasure;
pub use moebius::Moebius;
pub use pins::{MOST_PINS, PinError, PinSearch, Pins};
pub use places::{Places, Unfold};
pub use prepare::{
    KernelMode, Memory, PrepareError, PrepareSettings, PrepareTimings, Stage, SurfaceSettings, Unprepared, prepare,
    prepare_curve, prepare_on_curve, prepare_surface, prepare_within,
};
pub use prepared_side::{PreparedSide, SideGeometry};
pub use quadrilateral::{
    GridCells, MOST_CELLS, MOST_LENGTH, Marks, OrthogonalGrid, Quadrilateral, QuadrilateralError, RectangleMap,
    rectangle_corners,
};
pub use random_walk::{MAX_JUMPS, WALK_STOP, WalkCircle, WalkError, WalkStep, Walker};
pub use resolution::{Refining, Resampled, ResolveError, ResolvedBoundary};
pub use subdivision::{MOST_TRIANGLES, Subdivided, SubdivisionError};
pub use surface::MeshedSurface;
pub use table::{HarmonicTable, TableError};
pub use through_disk::SurfaceImages;
