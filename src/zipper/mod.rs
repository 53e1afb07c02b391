//! Through the disk: the way that riemap does not take, kept for comparison.
//!
//! Sections 1.2 and 5.2 of the paper ask why one should not map both domains to
//! the unit disk, g₁ and g₂, and put a Möbius map φ between: f = g₂⁻¹ ∘ φ ∘ g₁. Here
//! g comes from the geodesic algorithm, and the boundaries are matched by angle.
//!
//! | step | file | source |
//! |---|---|---|
//! | elementary maps of the half-plane | `geodesic` | Marshall & Rohde (2007), section 1 |
//! | g with g(x) = 0, g(v₀) = 1 | `disk_map` | the same |
//! | angles → harmonic measure → correspondence | `comparison` | sections 1.2, 5.2 of the paper |
//!
//! Two variants: *fresh*, one O(m²) run per interior point, accurate everywhere;
//! *precomputed*, one run for a fixed point, then Möbius, which crowding ruins.
//!
//! The room stands beside `conformal`: it uses geometry, outline and the complex numbers of `exact`,
//! and no mesh, so that it is a second opinion on harmonic measure.

mod comparison;
mod disk_map;
mod error;
mod geodesic;

pub use comparison::{DiskComparison, DiskMeasure};
pub use disk_map::DiskMap;
pub use error::ZipperError;
