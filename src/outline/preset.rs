//! Built-in outlines: their names, captions and polygons.

use std::f64::consts::TAU;
use std::fmt;
use std::str::FromStr;

use super::pen::fitted;
use super::{Outline, shapes};
use crate::exact;
use crate::geometry::{Curve, CurveError, DVec2, Piece, SimplePolygon};

/// A built-in outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Preset {
    /// The unit disk.
    Disk,
    /// A square.
    Square,
    /// A gingerbread man.
    Gingerbread,
    /// A heart.
    Heart,
    /// The blob of the paper's section 5.2.
    Blob,
    /// The V of the paper's section 1.2.
    VShape,
    /// A flower of five petals.
    Cinquefoil,
    /// A maple leaf.
    MapleLeaf,
    /// A hand.
    Hand,
    /// A turkey.
    Turkey,
    /// The L of finite element textbooks.
    LShape,
    /// A five-pointed star.
    Star,
    /// A spiral corridor.
    Spiral,
}

impl Preset {
    /// All presets, in the order of the menus.
    pub const ALL: [Self; 13] = [
        Self::Disk,
        Self::Square,
        Self::Gingerbread,
        Self::Heart,
        Self::Blob,
        Self::VShape,
        Self::Cinquefoil,
        Self::MapleLeaf,
        Self::Hand,
        Self::Turkey,
        Self::LShape,
        Self::Star,
        Self::Spiral,
    ];

    /// The name in `preset:NAME`, links and session files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Disk => "disk",
            Self::Square => "square",
            Self::Gingerbread => "gingerbread",
            Self::Heart => "heart",
            Self::Blob => "blob",
            Self::VShape => "v-shape",
            Self::Cinquefoil => "cinquefoil",
            Self::MapleLeaf => "maple-leaf",
            Self::Hand => "hand",
            Self::Turkey => "turkey",
            Self::LShape => "l-shape",
            Self::Star => "star",
            Self::Spiral => "spiral",
        }
    }

    /// The number of boundary samples that the paper uses for this outline.
    pub fn paper_samples(self) -> Option<u32> {
        match self {
            Self::Gingerbread => Some(500),
            Self::Heart | Self::Blob | Self::Cinquefoil => Some(1000),
            Self::VShape => Some(2000),
            Self::MapleLeaf => Some(3200),
            Self::Hand => Some(1800),
            _ => None,
        }
    }

    /// The name shown to users.
    pub fn title(self) -> &'static str {
        match self {
            Self::Disk => "Disk",
            Self::Square => "Square",
            Self::Gingerbread => "Gingerbread man",
            Self::Heart => "Heart",
            Self::Blob => "Blob",
            Self::VShape => "V-shape",
            Self::Cinquefoil => "Cinquefoil",
            Self::MapleLeaf => "Maple leaf",
            Self::Hand => "Hand",
            Self::Turkey => "Turkey",
            Self::LShape => "L-shape",
            Self::Star => "Star",
            Self::Spiral => "Spiral",
        }
    }

    /// The outline itself: a dense polygon, with edges short against the radius
    /// of curvature. The first vertex is a sensible boundary anchor.
    ///
    /// The V and the blob follow the paper's formulas; the others are drawn for
    /// riemap, within `[−1, 1]²`.
    pub fn outline(self) -> Outline {
        let points = match self {
            Self::Disk => shapes::disk(),
            Self::Square => shapes::square(),
            Self::Gingerbread => fitted(shapes::gingerbread()).close(),
            Self::Heart => shapes::heart().close(),
            Self::Blob => shapes::blob(),
            Self::VShape => shapes::v_shape(),
            Self::Cinquefoil => shapes::cinquefoil().close(),
            Self::MapleLeaf => fitted(shapes::maple_leaf()).close(),
            Self::Hand => fitted(shapes::hand()).close(),
            Self::Turkey => fitted(shapes::turkey()).close(),
            Self::LShape => shapes::l_shape(),
            Self::Star => shapes::star(),
            Self::Spiral => shapes::spiral().close(),
        };
        let polygon = SimplePolygon::known_simple(points);
        Outline { name: self.name().to_owned(), polygon, notes: Vec::new() }
    }
}

impl Preset {
    /// The outline as a curve: by its formula, or of its lines, arcs and Bézier curves; it begins where
    /// [`Self::outline`] does. No preset is refused.
    pub fn curve(self) -> Result<Curve, CurveError> {
        let drawn = match self {
            Self::Disk => return Curve::new(vec![Piece::circular(DVec2::ZERO, 1.0, 0.0, TAU)]),
            Self::Blob => {
                let piece = Piece::Formula { function: exact::blob::boundary_jet, from: 0.0, to: 1.0 };
                return Curve::new(vec![piece])?.analytic_at(0);
            }
            Self::VShape => return v_shape_curve(),
            Self::Square | Self::LShape | Self::Star => return Curve::from_polygon(&self.outline().polygon),
            Self::Gingerbread => fitted(shapes::gingerbread()),
            Self::Heart => shapes::heart(),
            Self::Cinquefoil => shapes::cinquefoil(),
            Self::MapleLeaf => fitted(shapes::maple_leaf()),
            Self::Hand => fitted(shapes::hand()),
            Self::Turkey => fitted(shapes::turkey()),
            Self::Spiral => shapes::spiral(),
        };
        Curve::new(drawn.pieces())
    }
}

/// The V: analytic, but its formula changes between its arms, at t = 1 and 3.
fn v_shape_curve() -> Result<Curve, CurveError> {
    let [right, left] = [exact::vshape::right_arm, exact::vshape::left_arm];
    let piece = |function, from, to| Piece::Formula { function, from, to };
    let pieces = vec![piece(right, 0.0, 1.0), piece(left, -1.0, 1.0), piece(right, -1.0, 0.0)];
    Curve::new(pieces)?.analytic_at(0)?.analytic_at(1)?.analytic_at(2)
}

/// No preset has this name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no preset \"{name}\"; the presets are {}", Preset::ALL.map(Preset::name).join(", "))]
#[non_exhaustive]
pub struct UnknownPreset {
    /// The requested name.
    pub name: String,
}

impl FromStr for Preset {
    type Err = UnknownPreset;

    /// Reads [`Preset::name`].
    fn from_str(name: &str) -> Result<Self, UnknownPreset> {
        Self::ALL.into_iter().find(|p| p.name() == name).ok_or_else(|| UnknownPreset { name: name.to_owned() })
    }
}

impl fmt::Display for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
#[path = "preset_tests.rs"]
mod tests;
