//! The display settings of a map: pattern, colors, comparisons.

use crate::conformal::{Direction, Extension, Side};
use crate::geometry::PicturePlacement;
use crate::tiling::TilingPattern;
#[cfg(feature = "io")]
use crate::tiling::{Tiling, TilingStyle};
#[cfg(feature = "io")]
use serde::{Deserialize, Serialize};

/// The settings of the map and of its display, the same for both sides.
///
/// The file formats 1 and 2 write these fields as they are: a new setting needs a new format or a default there.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub(super) struct Display {
    pub(super) direction: Direction,
    pub(super) extension: Extension,
    pub(super) texture: TextureKind,
    /// Cells of the pattern across its domain.
    pub(super) texture_scale: f64,
    /// The side on which the pattern is defined.
    pub(super) texture_side: Side,
    pub(super) colouring: Colouring,
    pub(super) wireframe: bool,
    pub(super) plots: bool,
    pub(super) comparison: Comparison,
    /// Whether the symmetries of the outlines are drawn, and catch dragged points; left out where they do not.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub(super) symmetries: bool,
    /// Where the image lies; left out where it is the default, as sessions had none before.
    #[serde(skip_serializing_if = "PicturePlacement::is_default")]
    pub(super) picture: PicturePlacement,
    /// The tiling, also while another pattern is shown; see [`KeptTiling`].
    #[serde(skip)]
    pub(super) tiling: TilingPattern,
}

/// Squares across a domain at the start: about 25 points wide in a window of 1280×720, so that their shape is seen in the
/// gingerbread man's arms.
const DEFAULT_CELLS: f64 = 20.0;

impl Default for Display {
    fn default() -> Self {
        Self {
            direction: Direction::default(),
            extension: Extension::default(),
            texture: TextureKind::default(),
            texture_scale: DEFAULT_CELLS,
            texture_side: Side::Source,
            colouring: Colouring::default(),
            wireframe: false,
            plots: false,
            comparison: Comparison::default(),
            symmetries: false,
            picture: PicturePlacement::default(),
            tiling: TilingPattern::default(),
        }
    }
}

/// The tiling as links and files keep it, beside settings that programs older than tilings understand: to these a tiling
/// is the conformal grid, which lies in the same coordinates.
#[cfg(feature = "io")]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptTiling {
    #[serde(rename = "numbers")]
    tiling: Tiling,
    style: TilingStyle,
    #[serde(rename = "shown")]
    is_shown: bool,
}

#[cfg(feature = "io")]
impl Display {
    /// The settings without tilings, and the tiling unless it is the default and not shown.
    pub(super) fn without_tiling(self) -> (Self, Option<KeptTiling>) {
        let TilingPattern { tiling, style } = self.tiling;
        let is_shown = self.texture == TextureKind::Tiling;
        let texture = if is_shown { TextureKind::Conformal } else { self.texture };
        let is_needed = is_shown || self.tiling != TilingPattern::default();
        let kept = is_needed.then_some(KeptTiling { tiling, style, is_shown });
        (Self { texture, tiling: TilingPattern::default(), ..self }, kept)
    }

    /// Puts a tiling back.
    pub(super) fn put_tiling(&mut self, kept: KeptTiling) {
        self.tiling = TilingPattern { tiling: kept.tiling, style: kept.style };
        if kept.is_shown {
            self.texture = TextureKind::Tiling;
        }
    }
}

/// The pattern drawn on one side and carried to the other by the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TextureKind {
    /// A checkerboard whose hue changes vertically.
    #[default]
    Checker,
    /// A square grid of lines.
    Grid,
    /// Circles and rays about the interior point.
    Polar,
    /// Circles and rays of the disk, carried by the disk map: level sets of Green's function and of harmonic measure.
    Conformal,
    /// A loaded image.
    Image,
    /// A hyperbolic tiling of the disk, carried by the disk map.
    Tiling,
}

impl TextureKind {
    /// Whether the pattern is defined in the unit disk, whatever the sides are.
    pub fn is_in_disk(self) -> bool {
        matches!(self, Self::Conformal | Self::Tiling)
    }
}

/// What the triangles are colored by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Colouring {
    /// The pattern that the map carries.
    #[default]
    Texture,
    /// The angle distortion Q = σ₁/σ₂ of every triangle.
    Angle,
    /// The area distortion log₂(σ₁σ₂) of every triangle.
    Area,
}

/// The methods compared with the map: those through the disk (sections 1.2 and 5.2 of the paper).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Comparison {
    /// No comparison.
    #[default]
    Off,
    /// Disk maps computed for the current interior points.
    Fresh,
    /// Disk maps computed once for the poles of inaccessibility, then composed with Möbius transformations.
    Precomputed,
    /// Both methods.
    Both,
}

/// A method that maps through the disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiskWay {
    /// See [`Comparison::Fresh`].
    Fresh,
    /// See [`Comparison::Precomputed`].
    Precomputed,
}

impl DiskWay {
    /// Both methods, in the order of the list in the app.
    pub const ALL: [Self; 2] = [Self::Fresh, Self::Precomputed];
}

impl Comparison {
    /// Whether the comparison includes this method.
    pub fn shows(self, way: DiskWay) -> bool {
        match self {
            Self::Off => false,
            Self::Fresh => way == DiskWay::Fresh,
            Self::Precomputed => way == DiskWay::Precomputed,
            Self::Both => true,
        }
    }
}
