//! What catches a dragged dot: corners of an outline and, where they are shown, its axes and centers of symmetry.
//!
//! A dot is caught within a few pixels of the pointer and free beyond, so that no drag is stopped; with Alt nothing catches
//! it.

use crate::geometry::{DVec2, Rotations};
use crate::language::{Message, key, number, say, tr};
use crate::worker::FoundSymmetries;
use egui::Ui;

/// The distance on the screen within which a dot is caught, in points: with a pointer, and with a finger, which covers
/// the place and cannot hold Alt.
const REACH: f32 = 8.0;
const FINGER_REACH: f32 = 4.0;

/// What catches dots; axes are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Catcher {
    /// The center of rotations, or of a circle.
    Center,
    /// An axis.
    Axis(usize),
    /// A point in which an axis meets the outline.
    End(usize),
    /// A corner of the outline.
    Corner,
}

/// A place that catches a dot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Catch {
    /// What it belongs to.
    pub by: Catcher,
    /// The place.
    pub place: DVec2,
}

/// The distance on the screen within which dots are caught now, in points.
pub fn reach(ui: &Ui) -> f32 {
    let (has_touch, is_free) = ui.input(|input| (input.any_touches(), input.modifiers.alt));
    match (is_free, has_touch) {
        (true, _) => 0.0,
        (false, true) => FINGER_REACH,
        (false, false) => REACH,
    }
}

/// What catches an interior point at `at`: the center before any axis. `distance` is that on the screen.
pub fn of_interior(
    found: &FoundSymmetries,
    at: DVec2,
    reach: f32,
    distance: impl Fn(DVec2) -> f32,
) -> impl Iterator<Item = Catch> {
    let symmetries = &found.symmetries;
    let has_center = symmetries.rotations != Rotations::Identity;
    let center = has_center.then_some(Catch { by: Catcher::Center, place: symmetries.center });
    let axes = symmetries.axes.iter().enumerate();
    let axes = axes.map(|(axis, line)| Catch { by: Catcher::Axis(axis), place: line.foot(at) });
    let axis = nearest(axes, &distance);
    [center, axis].into_iter().flatten().filter(move |catch| distance(catch.place) < reach)
}

/// What catches a boundary point: the nearest end of an axis or corner. `distance` is that on the screen.
pub fn of_boundary(
    found: Option<&FoundSymmetries>,
    corners: &[DVec2],
    reach: f32,
    distance: impl Fn(DVec2) -> f32,
) -> Option<Catch> {
    let ends = found.into_iter().flat_map(|found| found.ends.iter().enumerate());
    let ends = ends.flat_map(|(axis, ends)| ends.iter().map(move |&place| Catch { by: Catcher::End(axis), place }));
    let corners = corners.iter().map(|&place| Catch { by: Catcher::Corner, place });
    nearest(ends.chain(corners), &distance).filter(|catch| distance(catch.place) < reach)
}

fn nearest(places: impl Iterator<Item = Catch>, distance: &impl Fn(DVec2) -> f32) -> Option<Catch> {
    places.min_by(|a, b| distance(a.place).total_cmp(&distance(b.place)))
}

impl Catcher {
    /// The axis, if it is one or an end of one.
    pub fn axis(self) -> Option<usize> {
        match self {
            Self::Axis(axis) | Self::End(axis) => Some(axis),
            Self::Center | Self::Corner => None,
        }
    }

    /// Where a caught dot is, in words; `None` if the axis is no longer there.
    pub fn words(self, found: Option<&FoundSymmetries>) -> Option<String> {
        let of_axis = |words: fn(String) -> Message| {
            let axis = found?.symmetries.axes.get(self.axis()?)?;
            Some(say(&words(degrees(axis.direction.to_angle()))))
        };
        match self {
            Self::Center => Some(tr(key::in_center()).to_owned()),
            Self::Axis(_) => of_axis(key::on_axis),
            Self::End(_) => of_axis(key::at_axis_end),
            Self::Corner => Some(tr(key::in_corner()).to_owned()),
        }
    }
}

/// An angle in degrees, in words: with a decimal unless it is whole.
pub fn degrees(angle: f64) -> String {
    let tenths = (10.0 * angle.to_degrees()).round() / 10.0 + 0.0; // no −0
    number(tenths, usize::from(tenths.fract() != 0.0))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;
    use crate::worker::StudiedOutline;

    fn square() -> FoundSymmetries {
        StudiedOutline::Preset(Preset::Square).symmetries().unwrap()
    }

    /// What catches an interior point of the square, on a screen of 100 points to the unit.
    fn interior(x: f64, y: f64, reach: f32) -> Vec<(Catcher, DVec2)> {
        let at = DVec2::new(x, y);
        let distance = |place: DVec2| 100.0 * place.distance(at) as f32;
        of_interior(&square(), at, reach, distance).map(|catch| (catch.by, catch.place)).collect()
    }

    #[test]
    fn an_interior_point_slides_along_an_axis_and_stops_in_the_center() {
        assert_eq!(interior(0.5, 0.07, REACH), [(Catcher::Axis(0), DVec2::new(0.5, 0.0))]);
        assert_eq!(interior(0.5, 0.09, REACH), []);
        assert_eq!(interior(0.03, 0.05, REACH)[0], (Catcher::Center, square().symmetries.center));
        assert_eq!(interior(0.5, 0.0, 0.0), [], "with Alt");
    }

    #[test]
    fn a_boundary_point_is_caught_by_corners_and_with_symmetries_by_the_ends_of_axes() {
        let found = square();
        let corners = Preset::Square.outline().corner_places();
        let caught = |found: Option<&FoundSymmetries>, x: f64, y: f64| {
            let at = DVec2::new(x, y);
            of_boundary(found, &corners, REACH, |place| 100.0 * place.distance(at) as f32)
        };
        let corner = Catch { by: Catcher::Corner, place: DVec2::splat(0.9) };
        assert_eq!(caught(None, 0.85, 0.9), Some(corner));
        assert_eq!(caught(None, 0.05, 0.9), None);
        assert_eq!(caught(Some(&found), 0.05, 0.9).unwrap().by, Catcher::End(2));
        assert_eq!(caught(Some(&found), 0.85, 0.9).unwrap().by, Catcher::End(1), "the diagonal ends in the corner");
        assert_eq!(caught(Some(&found), 0.81, 0.9), None);
    }

    #[test]
    fn angles_are_whole_or_have_a_decimal() {
        crate::language::set(crate::language::Language::English);
        let spoken = |angle: f64| degrees(angle.to_radians());
        assert_eq!([90.0, 22.5, -0.01, 179.96].map(spoken), ["90", "22.5", "0", "180"]);
    }
}
