//! What catches a dragged dot: corners of an outline and, where they are shown, its axes and centers of symmetry.
//!
//! A dot is caught within a few pixels of the pointer and free beyond, so that no drag is stopped; with Alt nothing catches
//! it. Where places lie closely, as the corners of a coast, at least half of the way from one to the next is free.

use crate::geometry::{DVec2, Rotations};
use crate::language::{Message, key, number, say, tr};
use crate::worker::FoundSymmetries;
use egui::Ui;

/// The distance on the screen within which a dot is caught, in points: with a pointer, and with a finger, which covers
/// the place and cannot hold Alt.
const REACH: f32 = 8.0;
const FINGER_REACH: f32 = 4.0;
/// Places nearer to each other on the screen are one, in points: the end of an axis in a corner.
const ONE_PLACE: f32 = 1.0;

/// The longest way along the boundary to a place that catches y, in straight distances: around a right angle it is 1.4, at
/// a corner of 30° up to 4; across a channel it is that to its end and back.
const MOST_DETOUR: f32 = 4.0;

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

/// What catches an interior point at `at`: the center before any axis. `distance` is that of two places on the screen.
pub fn of_interior(
    found: &FoundSymmetries,
    at: DVec2,
    reach: f32,
    distance: impl Fn(DVec2, DVec2) -> f32,
) -> impl Iterator<Item = Catch> {
    let symmetries = &found.symmetries;
    let has_center = symmetries.rotations != Rotations::Identity;
    let center = has_center.then_some(Catch { by: Catcher::Center, place: symmetries.center });
    let axes = symmetries.axes.iter().enumerate();
    let axes: Vec<Catch> = axes.map(|(axis, line)| Catch { by: Catcher::Axis(axis), place: line.foot(at) }).collect();
    let axis = nearest(&axes, at, reach, &distance);
    let center = center.filter(|center| distance(at, center.place) < reach);
    center.into_iter().chain(axis)
}

/// What catches a boundary point at `at`: the nearest end of an axis or corner. `distance` is that of two places on the
/// screen, `along` that of a place of the boundary from `at` along the boundary: what lies across a narrow channel, or
/// behind a thin wall, catches nothing.
pub fn of_boundary(
    found: Option<&FoundSymmetries>,
    corners: &[DVec2],
    at: DVec2,
    reach: f32,
    distance: impl Fn(DVec2, DVec2) -> f32,
    along: impl Fn(DVec2) -> f32,
) -> Option<Catch> {
    let ends = found.into_iter().flat_map(|found| found.ends.iter().enumerate());
    let ends = ends.flat_map(|(axis, ends)| ends.iter().map(move |&place| Catch { by: Catcher::End(axis), place }));
    let corners = corners.iter().map(|&place| Catch { by: Catcher::Corner, place });
    // places farther than these neither catch nor keep another one from catching
    let near = |catch: &Catch| distance(at, catch.place) < 4.0 * reach;
    let is_beside = |catch: &Catch| along(catch.place) <= MOST_DETOUR * distance(at, catch.place) + ONE_PLACE;
    nearest(&ends.chain(corners).filter(near).filter(is_beside).collect::<Vec<_>>(), at, reach, &distance)
}

/// The nearest place within reach, unless it is farther than a quarter of the way over it to the next one.
fn nearest(places: &[Catch], at: DVec2, reach: f32, distance: &impl Fn(DVec2, DVec2) -> f32) -> Option<Catch> {
    let from_here = |catch: &Catch| distance(at, catch.place);
    let best = places.iter().min_by(|a, b| from_here(a).total_cmp(&from_here(b)))?;
    let here = from_here(best);
    let others = places.iter().filter(|other| distance(best.place, other.place) > ONE_PLACE);
    let next = others.map(from_here).fold(f32::INFINITY, f32::min);
    (here < reach.min(0.25 * (here + next))).then_some(*best)
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

    /// The distance on a screen of 100 points to the unit.
    fn on_screen(a: DVec2, b: DVec2) -> f32 {
        100.0 * a.distance(b) as f32
    }

    /// What catches an interior point of the square.
    fn interior(x: f64, y: f64, reach: f32) -> Vec<(Catcher, DVec2)> {
        let at = DVec2::new(x, y);
        of_interior(&square(), at, reach, on_screen).map(|catch| (catch.by, catch.place)).collect()
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
            of_boundary(found, &corners, at, REACH, on_screen, |place| on_screen(at, place))
        };
        let corner = Catch { by: Catcher::Corner, place: DVec2::splat(0.9) };
        assert_eq!(caught(None, 0.85, 0.9), Some(corner));
        assert_eq!(caught(None, 0.05, 0.9), None);
        assert_eq!(caught(Some(&found), 0.05, 0.9).unwrap().by, Catcher::End(2));
        assert_eq!(caught(Some(&found), 0.85, 0.9).unwrap().by, Catcher::End(1), "the diagonal ends in the corner");
        assert_eq!(caught(Some(&found), 0.81, 0.9), None);
    }

    /// A channel five points wide, with a corner on its far wall and one on this one.
    #[test]
    fn a_corner_across_a_channel_catches_nothing() {
        let corners = [DVec2::new(1.0, 0.05), DVec2::new(1.4, 0.0)];
        let caught = |x: f64, across: f32| {
            let at = DVec2::new(x, 0.0);
            // along the boundary the far wall is behind the channel's end
            let along = |place: DVec2| if place.y > 0.0 { across } else { on_screen(at, place) };
            of_boundary(None, &corners, at, REACH, on_screen, along).map(|catch| catch.place.x)
        };
        assert_eq!(caught(1.0, 900.0), None);
        assert_eq!(caught(1.0, 7.0), Some(1.0), "two corners of a step");
        assert_eq!(caught(1.38, 900.0), Some(1.4), "nor does it keep another corner from catching");
    }

    /// A coast's corners are five points apart: y stops in each, and is free over half of the way to the next.
    #[test]
    fn between_close_corners_a_point_is_free() {
        let corners: Vec<DVec2> = (0..200).map(|k| DVec2::new(0.05 * f64::from(k), 0.0)).collect();
        let caught = |x: f64| {
            let at = DVec2::new(x, 0.0);
            let found = of_boundary(None, &corners, at, REACH, on_screen, |place| on_screen(at, place));
            found.map(|catch| catch.place.x)
        };
        assert_eq!(caught(5.01), Some(5.0));
        assert_eq!([5.013, 5.02, 5.03, 5.037].map(caught), [None; 4]);
        assert!(caught(5.04).is_some_and(|x| (x - 5.05).abs() < 1e-12));
        // among the five axes of the star, too: about half of the way from one to the next is free at any distance from their center
        let star = StudiedOutline::Preset(Preset::Star).symmetries().unwrap();
        let center = star.symmetries.center;
        let at = |angle: f64| center + 0.3 * DVec2::from_angle(angle.to_radians());
        let axes =
            |angle: f64| of_interior(&star, at(angle), 1e3, on_screen).filter(|catch| catch.by != Catcher::Center);
        assert_eq!(axes(92.0).map(|catch| catch.by).collect::<Vec<_>>(), [Catcher::Axis(2)]);
        assert_eq!(axes(99.0).count(), 0, "in the middle of two");
    }

    #[test]
    fn angles_are_whole_or_have_a_decimal() {
        crate::language::set(crate::language::Language::English);
        let spoken = |angle: f64| degrees(angle.to_radians());
        assert_eq!([90.0, 22.5, -0.01, 179.96].map(spoken), ["90", "22.5", "0", "180"]);
    }
}
