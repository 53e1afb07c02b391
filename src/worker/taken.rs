//! What an outline's points were taken for: sent before the inside is prepared on its curve.

use crate::geometry::SimplePolygon;
use crate::language::Message;
use crate::outline::{CurveForm, CurveSource, Interpretation, Interpreted, OutlineCurve};

/// The most corners that are listed one by one: with more, neither marks nor a list help.
const MOST_CORNERS: usize = 64;

/// What an outline's points were taken for.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Taken {
    /// Polygon or smooth, and the number of corners.
    pub interpreted: Interpreted,
    /// Why it is a polygon although that was not asked for.
    pub stays: Option<Message>,
    /// The vertices that can be switched between corner and smooth, ascending: those detected as corners, and those
    /// switched before. None for curves from a file and where a polygon was asked for.
    pub corners: Vec<Corner>,
}

/// A vertex that can be switched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Corner {
    /// The index of the vertex.
    pub vertex: u32,
    /// Whether it is a corner now.
    pub is_corner: bool,
}

impl Taken {
    /// What `polygon` with this form is taken for, given its curve. O(n log n).
    pub fn new(polygon: &SimplePolygon, form: &CurveForm, curve: &OutlineCurve) -> Self {
        // without the corner that was made smooth there may be no smooth curve
        let has_corners = curve.is_smooth() || !form.switched.is_empty();
        let is_of_points = form.source == CurveSource::Points && form.interpretation != Interpretation::Polygon;
        let can_switch = is_of_points && has_corners;
        let corners = if can_switch { corners(polygon, form) } else { Vec::new() };
        Self {
            interpreted: curve.interpreted(),
            stays: curve.stays_polygon().map(Message::from),
            corners: if corners.len() <= MOST_CORNERS { corners } else { Vec::new() },
        }
    }
}

fn corners(polygon: &SimplePolygon, form: &CurveForm) -> Vec<Corner> {
    let present = form.corners(polygon);
    let switched = form.switched.iter().map(|&vertex| vertex as usize).filter(|k| *k < polygon.vertices().len());
    let mut all: Vec<usize> = present.iter().copied().chain(switched).collect();
    all.sort_unstable();
    all.dedup();
    let corner = |vertex: usize| Corner { vertex: vertex as u32, is_corner: present.binary_search(&vertex).is_ok() };
    all.into_iter().map(corner).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec2;

    /// A half disk: 100 points of the arc, and its two corners.
    fn half_disk() -> SimplePolygon {
        let point = |k: u32| DVec2::from_angle(std::f64::consts::PI * f64::from(k) / 99.0);
        SimplePolygon::try_from((0..100).map(point).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn detected_corners_can_be_switched_and_switched_back() {
        let polygon = half_disk();
        let taken = |form: &CurveForm| Taken::new(&polygon, form, &form.curve(&polygon).unwrap());
        let first = taken(&CurveForm::default());
        assert_eq!(first.interpreted.corners, 2);
        let corners = [0, 99].map(|vertex| Corner { vertex, is_corner: true });
        assert_eq!((first.corners.as_slice(), &first.stays), (corners.as_slice(), &None));
        let switched = CurveForm { switched: vec![99], ..CurveForm::default() };
        assert!(taken(&switched).corners.contains(&Corner { vertex: 99, is_corner: false }));
        assert!(taken(&CurveForm::polygon()).corners.is_empty());
    }
}
