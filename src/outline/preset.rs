//! Built-in outlines: their names, captions and polygons.

use std::fmt;
use std::str::FromStr;

use super::pen::{Drawn, fitted, is_one_circle};
use super::{CurveForm, CurveSource, Outline, shapes};
use crate::geometry::{Curve, CurveError, Junction, Piece, SimplePolygon};

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
        let polygon = SimplePolygon::known_simple(self.drawn().points);
        Outline::new(self.name(), polygon).with_form(CurveForm::of_source(CurveSource::Preset(self)))
    }

    /// The curve on which the vertices of [`Self::outline`] lie: lines, arcs, cubic Bézier curves and formulas, exact
    /// to rounding. Piece 0 begins at the first vertex. Errors: none for the built-in outlines, which the tests check.
    pub fn curve(self) -> Result<Curve, CurveError> {
        let pieces = self.drawn().pieces;
        let n = pieces.len();
        let is_one = |k: &usize| continues(self, &pieces[(k + n - 1) % n], &pieces[*k]);
        let analytic: Vec<usize> = (0..n).filter(is_one).collect();
        let mut curve = Curve::new(pieces)?;
        for k in analytic {
            if !matches!(curve.junctions()[k], Junction::Corner { .. }) {
                curve = curve.analytic_at(k)?;
            }
        }
        Ok(curve)
    }

    fn drawn(self) -> Drawn {
        match self {
            Self::Disk => shapes::disk(),
            Self::Square => shapes::square(),
            Self::Gingerbread => fitted(shapes::gingerbread()),
            Self::Heart => shapes::heart(),
            Self::Blob => shapes::blob(),
            Self::VShape => shapes::v_shape(),
            Self::Cinquefoil => shapes::cinquefoil(),
            Self::MapleLeaf => fitted(shapes::maple_leaf()),
            Self::Hand => fitted(shapes::hand()),
            Self::Turkey => fitted(shapes::turkey()),
            Self::LShape => shapes::l_shape(),
            Self::Star => shapes::star(),
            Self::Spiral => shapes::spiral(),
        }
    }
}

/// Whether a smooth junction is a point of one analytic curve: two arcs of one circle, or parts of the blob's or the
/// V's boundary, which are the preimages of circles under functions analytic there.
fn continues(preset: Preset, before: &Piece, after: &Piece) -> bool {
    match (before, after) {
        (Piece::Formula { .. }, Piece::Formula { .. }) => matches!(preset, Preset::Blob | Preset::VShape),
        (Piece::Arc { center: c, axes: a, .. }, Piece::Arc { center: d, axes: b, .. }) => {
            is_one_circle((*c, a[0].length()), (*d, b[0].length()))
        }
        _ => false,
    }
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
