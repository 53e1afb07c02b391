//! Positions in the plane or in space, for code that treats both alike.

use crate::geometry::{DVec2, DVec3};

/// Positions of vertices, all in the plane or all in space.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum Places<'a> {
    /// In the plane.
    Plane(&'a [DVec2]),
    /// In space.
    Space(&'a [DVec3]),
}

/// A point of the plane or of space; a triangle of such points can be unfolded into the plane.
pub trait Unfold: Copy {
    /// A congruent triangle in the plane: unchanged for the plane, counter-clockwise for space.
    fn unfold(corners: [Self; 3]) -> [DVec2; 3];

    /// The point in space; the plane lies at z = 0.
    fn in_space(self) -> DVec3;
}

impl Unfold for DVec2 {
    fn unfold(corners: [Self; 3]) -> [DVec2; 3] {
        corners
    }

    fn in_space(self) -> DVec3 {
        self.extend(0.0)
    }
}

impl Unfold for DVec3 {
    fn unfold([a, b, c]: [Self; 3]) -> [DVec2; 3] {
        let (u, v) = (b - a, c - a);
        let length = u.length();
        if length == 0.0 {
            return [DVec2::ZERO, DVec2::ZERO, DVec2::new(v.length(), 0.0)];
        }
        let third = DVec2::new(u.dot(v), u.cross(v).length()) / length;
        [DVec2::ZERO, DVec2::new(length, 0.0), third]
    }

    fn in_space(self) -> DVec3 {
        self
    }
}
