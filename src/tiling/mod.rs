//! Regular tilings {p, q} of the hyperbolic plane, in the Poincaré disk: p-gons, q of them around every corner.
//!
//! The plane is the unit disk with the metric 2|dz|/(1 − |z|²) (curvature −1). One tile lies around 0, the middle of
//! one of its edges on the positive real axis; the others are its images under the group that the half-turns about the
//! middles of its edges generate, which consists of motions z ↦ (az + b)/(b̄z + ā).
//!
//! | file | what it does |
//! |---|---|
//! | `motion` | motions of the disk |
//! | `fold` | a point of the disk, brought into the central tile: its distances from the mirrors, the tile that it is in |
//! | `tiles` | the tiles one by one, their corners and edges |
//!
//! Lengths and angles: H. S. M. Coxeter, *Regular Polytopes*, section 4.5 and *Non-Euclidean Geometry*, section 12.5, by
//! hyperbolic trigonometry in the triangle with the angles π/p at the tile's center, π/q at a corner and π/2 at the
//! middle of an edge, which the reflections in its sides repeat over the whole plane.

mod fold;
mod motion;
mod tiles;

pub use fold::Folded;
pub use motion::Motion;
pub use tiles::Tile;

use crate::geometry::DVec2;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// p and q. Tiles with more sides, or more of them around a corner, reach almost to the circle: beyond 20 the central one
/// has corners at 0.99 of it, and the tiles behind them are not seen.
pub const TILING_NUMBERS: RangeInclusive<u8> = 3..=20;

/// A regular tiling of the hyperbolic plane: (p − 2)(q − 2) > 4.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(into = "(u8, u8)", try_from = "(u8, u8)")]
pub struct Tiling {
    p: u8,
    q: u8,
}

/// Why there is no hyperbolic tiling {p, q}.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TilingError {
    /// p or q is not in [`TILING_NUMBERS`].
    #[error("{{{p}, {q}}}: both numbers must be from {} to {}", TILING_NUMBERS.start(), TILING_NUMBERS.end())]
    OutOfRange {
        /// The sides of a tile.
        p: u8,
        /// The tiles around a corner.
        q: u8,
    },
    /// The angles around a corner would be less than a full turn: (p − 2)(q − 2) < 4, a Platonic solid.
    #[error("{{{p}, {q}}} lives on the sphere: it is the {solid}. Choose larger numbers")]
    Spherical {
        /// The sides of a tile.
        p: u8,
        /// The tiles around a corner.
        q: u8,
        /// The solid whose faces they are.
        solid: Solid,
    },
    /// The angles around a corner are a full turn as they are: (p − 2)(q − 2) = 4.
    #[error("{{{p}, {q}}} lives in the plane, like squares, triangles and honeycombs. Choose larger numbers")]
    Euclidean {
        /// The sides of a tile.
        p: u8,
        /// The tiles around a corner.
        q: u8,
    },
}

/// The Platonic solids.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "their names say it")]
pub enum Solid {
    Tetrahedron,
    Octahedron,
    Cube,
    Icosahedron,
    Dodecahedron,
}

impl std::fmt::Display for Solid {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Tetrahedron => "tetrahedron",
            Self::Octahedron => "octahedron",
            Self::Cube => "cube",
            Self::Icosahedron => "icosahedron",
            Self::Dodecahedron => "dodecahedron",
        })
    }
}

impl Default for Tiling {
    /// Heptagons, three around a corner.
    fn default() -> Self {
        Self { p: 7, q: 3 }
    }
}

impl Tiling {
    /// The tiling by p-gons, q of them around a corner. Errors: there is none in the hyperbolic plane, or it is too large.
    pub fn new(p: u8, q: u8) -> Result<Self, TilingError> {
        if !(TILING_NUMBERS.contains(&p) && TILING_NUMBERS.contains(&q)) {
            return Err(TilingError::OutOfRange { p, q });
        }
        let solid = match (p, q) {
            (3, 3) => Solid::Tetrahedron,
            (3, 4) => Solid::Octahedron,
            (4, 3) => Solid::Cube,
            (3, 5) => Solid::Icosahedron,
            (5, 3) => Solid::Dodecahedron,
            (4, 4) | (3, 6) | (6, 3) => return Err(TilingError::Euclidean { p, q }),
            _ => return Ok(Self { p, q }),
        };
        Err(TilingError::Spherical { p, q, solid })
    }

    /// The sides of a tile.
    pub fn p(self) -> u8 {
        self.p
    }

    /// The tiles around a corner.
    pub fn q(self) -> u8 {
        self.q
    }

    /// Whether two colors suffice for tiles with a common edge to differ: an even number of tiles around a corner.
    pub fn is_two_colorable(self) -> bool {
        self.q.is_multiple_of(2)
    }

    /// π/p and π/q.
    fn angles(self) -> [f64; 2] {
        [PI / f64::from(self.p), PI / f64::from(self.q)]
    }

    /// The hyperbolic distance from a tile's center to the middle of an edge, cosh r = cos(π/q) / sin(π/p).
    pub fn inradius(self) -> f64 {
        let [p, q] = self.angles();
        (q.cos() / p.sin()).acosh()
    }

    /// The hyperbolic distance from a tile's center to a corner, cosh R = cot(π/p) cot(π/q).
    pub fn circumradius(self) -> f64 {
        let [p, q] = self.angles();
        (p.tan() * q.tan()).recip().acosh()
    }

    /// The hyperbolic length of an edge, cosh(e/2) = cos(π/p) / sin(π/q).
    pub fn edge(self) -> f64 {
        let [p, q] = self.angles();
        2.0 * (p.cos() / q.sin()).acosh()
    }

    /// The hyperbolic area of a tile by Gauss and Bonnet: (p − 2)π − 2πp/q.
    pub fn area(self) -> f64 {
        let [p, q] = [self.p, self.q].map(f64::from);
        (p - 2.0) * PI - 2.0 * PI * p / q
    }

    /// The Euclidean center, on the real axis, and the radius of the circle in which the edge on the positive real axis
    /// lies: coth r and 1/sinh r, so that the circle meets the unit circle at right angles.
    pub fn edge_circle(self) -> [f64; 2] {
        let r = self.inradius();
        [r.tanh().recip(), r.sinh().recip()]
    }
}

/// How deep a point of the closed disk lies in the plane: tanh d/4, d being its hyperbolic distance from 0. Tiles are shaded
/// by it.
pub fn depth(point: DVec2) -> f64 {
    let r = point.length().min(1.0);
    r / (1.0 + (1.0 - r * r).sqrt())
}

impl From<Tiling> for (u8, u8) {
    fn from(tiling: Tiling) -> Self {
        (tiling.p, tiling.q)
    }
}

impl TryFrom<(u8, u8)> for Tiling {
    type Error = TilingError;

    fn try_from((p, q): (u8, u8)) -> Result<Self, TilingError> {
        Self::new(p, q)
    }
}

impl std::fmt::Display for Tiling {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{{{}, {}}}", self.p, self.q)
    }
}

/// How the tiles are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TilingStyle {
    /// In two colors that alternate; where that is impossible, in a shade by the distance from the central tile, with
    /// edges.
    #[default]
    Tiles,
    /// By their edges alone.
    Edges,
    /// Each divided into the 2p triangles of the reflections, in two colors that alternate.
    Triangles,
    /// By a picture in each of them, its lower side towards the center of the disk.
    Picture,
}

/// A tiling as a pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub struct TilingPattern {
    /// The tiling.
    pub tiling: Tiling,
    /// How its tiles are told apart.
    pub style: TilingStyle,
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
