//! The parts of a session that a command touches. Locks, undo, the tour and announcements all depend on this set.

use std::ops::BitOr;

/// A set of parts of the session.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Touched(u16);

impl Touched {
    /// No part.
    pub const NOTHING: Self = Self(0);
    /// Interior points.
    pub const INTERIOR: Self = Self(1);
    /// Boundary points.
    pub const BOUNDARY: Self = Self(1 << 1);
    /// Both kinds of points.
    pub const POINTS: Self = Self(Self::INTERIOR.0 | Self::BOUNDARY.0);
    /// The outlines and surfaces, and on which side they are.
    pub const SHAPES: Self = Self(1 << 2);
    /// A shape that neither side had before. Only together with [`Self::SHAPES`].
    pub const NEW_SHAPE: Self = Self(1 << 3);
    /// Another outline or surface on a side, with its own points.
    pub const ANOTHER_SHAPE: Self = Self(Self::SHAPES.0 | Self::NEW_SHAPE.0 | Self::POINTS.0);
    /// How the sides are discretized and how the map is computed.
    pub const SETTINGS: Self = Self(1 << 4);
    /// The pattern, its scale and its side.
    pub const PATTERN: Self = Self(1 << 5);
    /// What the triangles are colored by, and whether edges are drawn.
    pub const COLOURS: Self = Self(1 << 6);
    /// Whether the plots are open.
    pub const PLOTS: Self = Self(1 << 7);
    /// The methods that the map is compared with, whether symmetries are shown, the painted region and the marks.
    pub const COMPARISON: Self = Self(1 << 8);
    /// Everything that affects only the display of a map.
    pub const VIEW: Self = Self(Self::PATTERN.0 | Self::COLOURS.0 | Self::PLOTS.0 | Self::COMPARISON.0);
    /// Every part: the whole session is replaced.
    pub const EVERYTHING: Self = Self(Self::ANOTHER_SHAPE.0 | Self::SETTINGS.0 | Self::VIEW.0);

    /// Whether the set contains any of `parts`.
    pub fn touches(self, parts: Self) -> bool {
        self.0 & parts.0 != 0
    }

    /// Whether the set is not empty and contains only `parts`.
    pub fn is_only(self, parts: Self) -> bool {
        self != Self::NOTHING && self.0 & !parts.0 == 0
    }
}

impl BitOr for Touched {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}
