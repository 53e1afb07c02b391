//! The conformal map: a prepared domain, Poisson kernels, harmonic measures, their matching, its extension.
//!
//! [`prepare`] does once per outline what takes milliseconds to seconds;
//! [`ConformalMap::update`] does what a drag needs, in a fraction of that, and
//! [`ConformalMap::advance`] the same until a deadline:
//!
//! | step | file | paper |
//! |---|---|---|
//! | Poisson kernel ψ at x | `kernel` | (9), (10), (B.2), by the adjoint solve |
//! | harmonic measure ω̃ from y | `measure` | (11), (12) |
//! | boundary correspondence | `matching` | section 3.2, C.4, in a form that does not cancel |
//! | images of the vertices | `extension` | (14) |
//! | the same by Cauchy's integral | `cauchy_green`, `refinement` | (7), (15) |
//! | conformal polar coordinates | `disk_coordinates` | sections 1.2, 3.1 |
//! | angle and area distortion | `distortion`, `histogram` | section 5.1 |
//!
//! Surfaces go the same way: [`prepare_surface`] and [`SurfaceMap`] (section 4.3) differ in geometry
//! alone; what both need of a domain is file `system`.
//!
//! [`Walker`] and [`HitCounts`] show what harmonic measure is: where random walks hit the boundary.

mod buffers;
mod cauchy_green;
mod constraints;
mod disk_coordinates;
mod distortion;
mod domain;
mod extension;
mod flat;
mod half;
mod histogram;
mod hit_counts;
mod kernel;
mod map;
mod matching;
mod measure;
mod measured;
mod random_walk;
mod refinement;
mod stage;
mod stencil;
mod surface;
mod surface_buffers;
mod surface_map;
mod system;
mod table;
mod unfold;

pub use cauchy_green::{BoundaryValues, CauchyGreen, CauchyGreenMode, Contour, STORED_BYTES};
pub use constraints::{Constraints, Direction, MapSettings, Side};
pub use disk_coordinates::{begin_disk_coordinates, begin_surface_disk_coordinates, disk_coordinates};
pub use distortion::{
    Quality, TriangleDistortion, advance_distortions, advance_surface_distortions, surface_distortions,
    triangle_distortions,
};
pub use domain::{
    KernelMode, Memory, PrepareError, PrepareSettings, PrepareTimings, PreparedDomain, Stage, prepare, prepare_within,
};
pub use extension::{Extension, ExtensionScratch, advance_extension, harmonic_extension};
pub use flat::FlatBuffers;
pub use histogram::Histogram;
pub use hit_counts::HitCounts;
pub use kernel::{KernelScratch, harmonic_coordinates, poisson_kernel};
pub use map::{ConformalMap, FrameTimings, MapError};
pub use matching::{BoundaryCorrespondence, match_measures};
pub use measure::HarmonicMeasure;
pub use random_walk::{MAX_JUMPS, WALK_STOP, WalkCircle, WalkError, WalkStep, Walker};
pub use surface::{PreparedSurface, SurfaceSettings, advance_surface_extension, prepare_surface, surface_kernel};
pub use surface_map::{SurfaceConstraints, SurfaceMap, SurfaceMapError, SurfaceMapNote};
pub use table::{HarmonicTable, TableError};
