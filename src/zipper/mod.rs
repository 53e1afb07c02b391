//! The map through the disk, an alternative to riemap's method, for comparison.
//!
//! Sections 1.2 and 5.2 of the paper discuss why one should not map both domains to
//! the unit disk, by g₁ and g₂, and compose with a Möbius map φ: f = g₂⁻¹ ∘ φ ∘ g₁. Here
//! g is computed by the geodesic algorithm, and the boundaries are matched by angle.
//!
//! | step | file | source |
//! |---|---|---|
//! | elementary maps of the half-plane | `geodesic` | Marshall & Rohde (2007), section 1 |
//! | g with g(x) = 0, g(v₀) = 1 | `disk_map` | the same |
//! | angles → harmonic measure → correspondence | `comparison` | sections 1.2, 5.2 of the paper |
//!
//! Two variants: *fresh*, one O(m²) run for each interior point, accurate everywhere;
//! *precomputed*, one run for a fixed point and then a Möbius map, which loses all accuracy under crowding.
//!
//! The room is independent of `conformal`: it uses geometry, outline and the complex numbers of `exact`,
//! and no mesh, so that its harmonic measure is an independent check.

mod comparison;
mod disk_map;
mod error;
mod geodesic;

pub use comparison::{DiskComparison, DiskMeasure};
pub use disk_map::DiskMap;
pub use error::ZipperError;
