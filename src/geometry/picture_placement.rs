//! Where a picture lies in the plane: a similarity transformation relative to the box of a domain.
//!
//! A picture of 1 × 1/aspect that just fits into the box, and has its middle there, is moved, scaled and turned. Lengths
//! are in the box's larger side, so that the same placement suits a domain of another size.

use glam::DVec2;
use std::f64::consts::PI;
use std::ops::RangeInclusive;

/// The placement of a picture.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct PicturePlacement {
    /// The picture's middle, from the middle of the box, in its larger sides.
    pub middle: DVec2,
    /// The scale; 1: the whole picture just fits into the box.
    pub size: f64,
    /// The angle by which the picture is turned counter-clockwise, in radians, in [−π, π].
    pub turn: f64,
}

/// Each coordinate of [`PicturePlacement::middle`]: further away nothing of the picture would be seen.
pub const PICTURE_MIDDLE: RangeInclusive<f64> = -10.0..=10.0;
/// [`PicturePlacement::size`]: from a stamp of a few pixels to a picture of which one sees a few pixels.
pub const PICTURE_SIZE: RangeInclusive<f64> = 0.01..=100.0;
/// [`PicturePlacement::turn`].
pub const PICTURE_TURN: RangeInclusive<f64> = -PI..=PI;

impl Default for PicturePlacement {
    /// The whole picture, upright in the middle.
    fn default() -> Self {
        Self { middle: DVec2::ZERO, size: 1.0, turn: 0.0 }
    }
}

impl PicturePlacement {
    /// Whether the whole picture lies upright in the middle.
    pub fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// The nearest placement within the limits; the angle is taken modulo 2π. What is not finite becomes its default.
    #[must_use]
    pub fn within_limits(self) -> Self {
        let known = |value: f64, otherwise: f64| if value.is_finite() { value } else { otherwise };
        let coordinate = |value: f64| known(value, 0.0).clamp(*PICTURE_MIDDLE.start(), *PICTURE_MIDDLE.end());
        let turn = known(self.turn, 0.0);
        let turn = if PICTURE_TURN.contains(&turn) { turn } else { (turn + PI).rem_euclid(2.0 * PI) - PI };
        Self {
            middle: DVec2::new(coordinate(self.middle.x), coordinate(self.middle.y)),
            size: known(self.size, 1.0).clamp(*PICTURE_SIZE.start(), *PICTURE_SIZE.end()),
            turn,
        }
    }

    /// Moved by `delta` in the plane of the box (lower left and upper right corner).
    #[must_use]
    pub fn moved(self, delta: DVec2, bounds: (DVec2, DVec2)) -> Self {
        Self { middle: self.middle + delta / unit(bounds), ..self }.within_limits()
    }

    /// Scaled by `factor` and turned by `angle` about the point `fixed` of the plane, as far as the limits allow.
    #[must_use]
    pub fn turned_about(self, fixed: DVec2, factor: f64, angle: f64, bounds: (DVec2, DVec2)) -> Self {
        let fixed = (fixed - 0.5 * (bounds.0 + bounds.1)) / unit(bounds);
        let size = (self.size * factor).clamp(*PICTURE_SIZE.start(), *PICTURE_SIZE.end());
        let arm = DVec2::from_angle(angle).rotate(self.middle - fixed) * (size / self.size);
        Self { middle: fixed + arm, size, turn: self.turn + angle }.within_limits()
    }

    /// The picture of this ratio of width to height in the plane of the box.
    pub fn frame(self, bounds: (DVec2, DVec2), aspect: f64) -> PictureFrame {
        let extent = (bounds.1 - bounds.0).max(DVec2::splat(f64::MIN_POSITIVE));
        let width = self.size * extent.x.min(extent.y * aspect);
        let middle = 0.5 * (bounds.0 + bounds.1) + self.middle * unit(bounds);
        PictureFrame { middle, size: DVec2::new(width, width / aspect), turn: self.turn }
    }
}

fn unit((low, high): (DVec2, DVec2)) -> f64 {
    (high - low).max_element().max(f64::MIN_POSITIVE)
}

/// A picture in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureFrame {
    /// Its middle.
    pub middle: DVec2,
    /// Its width and height.
    pub size: DVec2,
    /// The angle by which it is turned counter-clockwise, in radians.
    pub turn: f64,
}

impl PictureFrame {
    /// The place in the picture of a point of the plane, as parts of its width and height from its upper left corner.
    pub fn lookup(&self, point: DVec2) -> DVec2 {
        let along = DVec2::from_angle(-self.turn).rotate(point - self.middle) / self.size;
        DVec2::new(0.5 + along.x, 0.5 - along.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    const BOX: (DVec2, DVec2) = (DVec2::new(1.0, 2.0), DVec2::new(5.0, 4.0));

    #[test]
    fn the_whole_picture_fits_into_the_box_at_first() {
        for aspect in [0.3, 1.0, 2.0, 7.0] {
            let frame = PicturePlacement::default().frame(BOX, aspect);
            assert!(frame.size.x <= 4.0 && frame.size.y <= 2.0 && frame.middle == DVec2::new(3.0, 3.0), "{frame:?}");
            assert!(frame.size.x == 4.0 || frame.size.y == 2.0, "{frame:?}");
        }
        let frame = PicturePlacement::default().frame(BOX, 2.0);
        assert_eq!(frame.lookup(DVec2::new(1.0, 4.0)), DVec2::ZERO, "the upper left corner");
        assert_eq!(frame.lookup(BOX.0), DVec2::Y);
    }

    #[test]
    fn what_lies_under_a_fixed_point_stays_there() {
        let placement = PicturePlacement { middle: DVec2::new(0.1, -0.2), size: 0.7, turn: 0.4 };
        let fixed = DVec2::new(2.5, 3.9);
        let before = placement.frame(BOX, 1.5).lookup(fixed);
        let after = placement.turned_about(fixed, 1.7, 2.9, BOX).frame(BOX, 1.5).lookup(fixed);
        assert!(before.distance(after) < 1e-12, "{before} became {after}");
        let moved = placement.moved(DVec2::new(0.3, 0.4), BOX).frame(BOX, 1.5).lookup(fixed + DVec2::new(0.3, 0.4));
        assert!(before.distance(moved) < 1e-12, "{before} became {moved}");
    }

    #[test]
    fn a_quarter_turn_brings_the_left_edge_down() {
        let frame = PicturePlacement { turn: FRAC_PI_2, ..PicturePlacement::default() }.frame(BOX, 1.0);
        let left = frame.lookup(frame.middle - DVec2::new(0.0, 0.5 * frame.size.x));
        assert!(left.distance(DVec2::new(0.0, 0.5)) < 1e-12, "{left}");
    }

    #[test]
    fn limits_hold_whatever_comes() {
        let wild = PicturePlacement { middle: DVec2::new(f64::NAN, 1e9), size: f64::INFINITY, turn: 7.0 };
        let kept = wild.within_limits();
        assert_eq!((kept.middle, kept.size), (DVec2::new(0.0, 10.0), 1.0));
        assert!((kept.turn - (7.0 - 2.0 * PI)).abs() < 1e-12 && kept.within_limits() == kept);
        let tiny = PicturePlacement::default().turned_about(DVec2::ZERO, 1e-9, 0.0, BOX);
        assert_eq!(tiny.size, 0.01);
    }
}
