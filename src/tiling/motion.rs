//! Motions of the Poincaré disk: its Möbius maps onto itself, the orientation-preserving isometries.

use crate::geometry::DVec2;
use num_complex::Complex64;

/// z ↦ (a z + b)/(b̄ z + ā) with |a|² − |b|² = 1 up to rounding, which grows by 1e-16 a composition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    a: Complex64,
    b: Complex64,
}

impl Motion {
    /// The motion that moves nothing.
    pub const IDENTITY: Self = Self { a: Complex64::ONE, b: Complex64::ZERO };

    /// The half-turn about the middle of the edge that lies in the direction `u`, |u| = 1, on a circle with this center
    /// and radius ([`super::Tiling::edge_circle`]): z ↦ (u − cz)/(c − ūz).
    pub(super) fn half_turn(u: Complex64, [center, radius]: [f64; 2]) -> Self {
        Self { a: Complex64::new(0.0, -center / radius), b: Complex64::I * u / radius }
    }

    /// This motion after another one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self { a: self.a * first.a + self.b * first.b.conj(), b: self.a * first.b + self.b * first.a.conj() }
    }

    /// The motion back.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { a: self.a.conj(), b: -self.b }
    }

    /// The image of a point of the closed disk.
    pub fn apply(&self, p: DVec2) -> DVec2 {
        let image = self.image(Complex64::new(p.x, p.y));
        DVec2::new(image.re, image.im)
    }

    pub(super) fn image(&self, z: Complex64) -> Complex64 {
        (self.a * z + self.b) / (self.b.conj() * z + self.a.conj())
    }
}

/// The hyperbolic distance of two points of the open disk: 2 arsinh(|z − w| / √((1 − |z|²)(1 − |w|²))).
pub(super) fn distance(z: DVec2, w: DVec2) -> f64 {
    let gaps = (1.0 - z.length_squared()) * (1.0 - w.length_squared());
    2.0 * (z.distance(w) / gaps.sqrt()).asinh()
}
