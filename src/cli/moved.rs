//! Notes about points of a session that lie outside of their domains: the picture uses other points, as the app does.

use super::output::triangles;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::mesh::BarycentricPoint;
use crate::model::scene::Offscreen;
use crate::session::Session;

/// Relative shift below which a point counts as not moved. The app keeps points at a distance from the outline; a point
/// at exactly that distance is moved by rounding, 1e-16. A visible step is 1e-3.
const ROUNDING: f64 = 1e-9;

/// Reports on stderr which points of `wanted` the picture replaces.
pub fn say_moved(wanted: &Session, offscreen: &Offscreen) {
    for side in Side::BOTH {
        let note = if let Some(surface) = wanted.surface(side) {
            surface.point.and_then(|wanted| on_surface(wanted, offscreen.surface_point(side)?))
        } else {
            let [wanted, used] = [wanted, offscreen.session()].map(|session| session.side(side).interior);
            wanted.and_then(|wanted| planar(side, wanted, used))
        };
        if let Some(note) = note {
            eprintln!("riemap: {note}");
        }
    }
}

fn planar(side: Side, wanted: DVec2, used: Option<DVec2>) -> Option<String> {
    let place = match used {
        Some(used) if used.distance(wanted) <= ROUNDING * wanted.length().max(used.length()) => return None,
        Some(used) => format!("({}, {})", used.x, used.y),
        None => String::from("the middle"),
    };
    let DVec2 { x, y } = wanted;
    Some(format!("the {side} point ({x}, {y}) is outside of the {side} outline, or next to it: {place} stands in"))
}

/// What stands in is the point that is `used`, of a surface with so many triangles.
fn on_surface(wanted: BarycentricPoint, (used, count): (BarycentricPoint, usize)) -> Option<String> {
    if wanted == used {
        return None;
    }
    let (triangle, [a, b, c]) = (wanted.triangle(), wanted.weights());
    let triangles = triangles(count);
    Some(format!(
        "({a}, {b}, {c}) in triangle {triangle} is no inner point of the surface, which has {triangles}: the \
         vertex farthest from its boundary stands in"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_has_not_moved_gives_no_note() {
        let point = DVec2::new(0.3, -0.4);
        assert_eq!(planar(Side::Source, point, Some(point)), None);
        assert_eq!(planar(Side::Source, point, Some(point + DVec2::splat(1e-16))), None);
        let moved = planar(Side::Target, point, Some(DVec2::new(0.3, -0.39)));
        let expected =
            "the target point (0.3, -0.4) is outside of the target outline, or next to it: (0.3, -0.39) stands in";
        assert_eq!(moved.as_deref(), Some(expected));
        assert!(planar(Side::Source, point, None).is_some_and(|note| note.contains("the middle")));
    }
}
