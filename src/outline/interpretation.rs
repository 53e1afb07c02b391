//! How the curve of an outline is found from its polygon: straight edges, a smooth curve through the points, or the
//! curve that the file or the preset gives.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::corners::{corners, polygon_corners};
use super::crossing::first_crossing;
use super::smooth::{StaysPolygon, smooth_curve};
use super::{Preset, Segment, flattened};
use crate::geometry::{Curve, CurveError, CurvePoint, DVec2, Junction, MAX_POINTS, Piece, SimplePolygon};

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Interpretation {
    /// The given curve if there is one; otherwise a smooth curve through [`LEAST_SMOOTH`] points or more, unless many of
    /// them are corners; otherwise a polygon.
    #[default]
    Auto,
    /// Straight edges between the vertices.
    Polygon,
    /// The given curve, or a smooth curve through the points, however few.
    Smooth,
}

/// Where an outline's vertices come from.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CurveSource {
    /// A list of points, or a stroke.
    #[default]
    Points,
    /// A path of lines, arcs and Bézier curves, counter-clockwise from the first vertex, on which the vertices lie.
    Segments(Vec<Segment>),
    /// A built-in outline.
    Preset(Preset),
}

/// What determines an outline's curve besides its polygon.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub struct CurveForm {
    /// What is asked for.
    pub interpretation: Interpretation,
    /// Vertices of a list of points that are corners although none was detected, or the reverse; ascending.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub switched: Vec<u32>,
    /// Where the vertices come from.
    #[serde(default, skip_serializing_if = "CurveSource::is_points")]
    pub source: CurveSource,
}

impl CurveSource {
    fn is_points(&self) -> bool {
        *self == Self::Points
    }
}

impl CurveForm {
    /// Straight edges, whatever the number of vertices.
    pub fn polygon() -> Self {
        Self { interpretation: Interpretation::Polygon, ..Self::default() }
    }

    /// The form of an outline of which only the polygon is known: short lists of points are polygons anyway, longer ones
    /// stay what they were before there were curves.
    pub fn of_polygon(polygon: &SimplePolygon) -> Self {
        if polygon.vertices().len() < LEAST_SMOOTH { Self::default() } else { Self::polygon() }
    }

    /// The curve that the source gives, interpreted automatically.
    pub fn of_source(source: CurveSource) -> Self {
        Self { source, ..Self::default() }
    }

    /// Whether the polygon is one that samples this form's source: the points of the path, up to a billionth of the size.
    /// Other sources fit every polygon.
    pub fn fits(&self, polygon: &SimplePolygon) -> bool {
        let is_ascending = self.switched.is_sorted_by(|a, b| a < b);
        let CurveSource::Segments(segments) = &self.source else { return is_ascending };
        let vertices = polygon.vertices();
        if !is_ascending || segments.len() > MAX_POINTS || !segments.iter().all(Segment::is_single) {
            return false;
        }
        let points = flattened(segments);
        let tolerance = SAME_POLYGON * polygon.bounds().size().max_element();
        let is_near = |p: DVec2, q: DVec2| p.distance(q) <= tolerance;
        let ends = segments.iter().map(Segment::end);
        let starts = segments.iter().skip(1).chain(segments.first()).map(Segment::start);
        points.len() == vertices.len()
            && points.iter().zip(vertices).all(|(&p, &q)| is_near(p, q))
            && ends.zip(starts).all(|(end, start)| is_near(end, start))
    }

    /// The vertices at which a list of points has a corner: the detected ones, each of [`Self::switched`] reversed.
    /// Ascending.
    pub fn corners(&self, polygon: &SimplePolygon) -> Vec<usize> {
        let vertices = polygon.vertices();
        let mut is_corner = vec![false; vertices.len()];
        for k in corners(vertices) {
            is_corner[k] = true;
        }
        for &k in &self.switched {
            if let Some(is_corner) = is_corner.get_mut(k as usize) {
                *is_corner = !*is_corner;
            }
        }
        (0..vertices.len()).filter(|&k| is_corner[k]).collect()
    }

    /// The curve of the polygon. Errors: the polygon's edges themselves form no [`Curve`], as in a spike narrower than
    /// 1e-5. Cost O(n log n).
    pub fn curve(&self, polygon: &SimplePolygon) -> Result<OutlineCurve, CurveError> {
        let one_each = |curve: Curve| (vec![1; curve.pieces().len()], curve);
        let smooth = match (self.interpretation, &self.source) {
            (Interpretation::Polygon, _) => return OutlineCurve::straight(polygon, None),
            (_, CurveSource::Preset(preset)) => preset.curve().map(one_each).map_err(StaysPolygon::from),
            (_, CurveSource::Segments(segments)) => path_curve(segments),
            (_, CurveSource::Points) => self.through_points(polygon).map(one_each),
        };
        match smooth {
            Ok((sides, curve)) => Ok(OutlineCurve { curve, sides, is_smooth: true, stays: None }),
            Err(stays) => OutlineCurve::straight(polygon, Some(stays)),
        }
    }

    /// The places of the outline's corners, in its order: of the curve, or of the polygon where the outline is one.
    pub fn corner_places(&self, polygon: &SimplePolygon) -> Vec<DVec2> {
        match self.curve(polygon) {
            Ok(found) if found.is_smooth => found.corner_places().collect(),
            Ok(_) | Err(_) => polygon_corners(polygon.vertices()).collect(),
        }
    }

    fn through_points(&self, polygon: &SimplePolygon) -> Result<Curve, StaysPolygon> {
        let count = polygon.vertices().len();
        if self.interpretation == Interpretation::Auto && count < LEAST_SMOOTH {
            return Err(StaysPolygon::FewPoints { count });
        }
        let corners = self.corners(polygon);
        let most = if self.interpretation == Interpretation::Auto { count / POINTS_PER_CORNER } else { count - 1 };
        if corners.len() > most {
            return Err(StaysPolygon::ManyCorners { corners: corners.len(), count });
        }
        smooth_curve(polygon.vertices(), &corners)
    }
}

/// The curve of a path and how many of its pieces each segment has, unless it crosses itself.
fn path_curve(segments: &[Segment]) -> Result<(Vec<usize>, Curve), StaysPolygon> {
    let pieces: Vec<Vec<Piece>> = segments.iter().map(Segment::pieces).collect();
    let mut curve = Curve::new(pieces.concat())?;
    let mut start = 0;
    for count in pieces.iter().map(Vec::len) {
        for k in start + 1..start + count {
            // parts of one Bézier curve
            if curve.junctions()[k] == Junction::Smooth {
                curve = curve.analytic_at(k)?;
            }
        }
        start += count;
    }
    let parts: Vec<[DVec2; 4]> = segments.iter().flat_map(Segment::cubics).collect();
    match first_crossing(&parts) {
        Some((_, j)) => Err(StaysPolygon::PathCrossesItself { at: parts[j][0] }),
        None => Ok((pieces.iter().map(Vec::len).collect(), curve)),
    }
}

/// Lists of fewer points are polygons, unless asked otherwise: a smooth outline drawn with 64 points turns by 6° from
/// edge to edge.
pub const LEAST_SMOOTH: usize = 64;
/// Points of a path nearer to each other, in sizes of the outline, are the same: elementary functions round differently.
const SAME_POLYGON: f64 = 1e-9;
/// With more corners than one in this many points, an outline is a polygon: the maple leaf's 29 corners among 665 points
/// are drawn, the hundreds of a coast's 2,000 points are not.
const POINTS_PER_CORNER: usize = 8;

/// What an outline was taken for, for summaries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Interpreted {
    /// [`Interpretation::Polygon`] or [`Interpretation::Smooth`].
    pub interpretation: Interpretation,
    /// The number of corners.
    pub corners: usize,
}

/// An outline's curve, and what its vertices were taken for.
#[derive(Debug, Clone)]
pub struct OutlineCurve {
    curve: Curve,
    sides: Vec<usize>,
    is_smooth: bool,
    stays: Option<StaysPolygon>,
}

impl OutlineCurve {
    fn straight(polygon: &SimplePolygon, stays: Option<StaysPolygon>) -> Result<Self, CurveError> {
        let curve = Curve::from_polygon(polygon)?;
        Ok(Self { sides: vec![1; curve.pieces().len()], curve, is_smooth: false, stays })
    }

    /// The curve.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The curve.
    pub fn into_curve(self) -> Curve {
        self.curve
    }

    /// The number of pieces of each side: of each segment of a path; otherwise a piece is a side.
    pub fn sides(&self) -> &[usize] {
        &self.sides
    }

    /// Whether it is more than the polygon.
    pub fn is_smooth(&self) -> bool {
        self.is_smooth
    }

    /// What the outline was taken for.
    pub fn interpreted(&self) -> Interpreted {
        let interpretation = if self.is_smooth { Interpretation::Smooth } else { Interpretation::Polygon };
        Interpreted { interpretation, corners: self.corner_count() }
    }

    /// Why it is the polygon although that was not asked for.
    pub fn stays_polygon(&self) -> Option<&StaysPolygon> {
        self.stays.as_ref()
    }

    fn corner_places(&self) -> impl Iterator<Item = DVec2> + '_ {
        let junctions = self.curve.junctions().iter().enumerate().filter(|(_, junction)| is_corner(junction));
        junctions.map(|(k, _)| self.curve.position(CurvePoint::new(k, 0.0)))
    }

    /// The number of its corners; junctions that turn by less than 1e-6 are none.
    pub fn corner_count(&self) -> usize {
        self.curve.junctions().iter().filter(|junction| is_corner(junction)).count()
    }
}

/// Tangents that differ by less are one to the eye and to coordinates of single precision.
const UNNOTICED: f64 = 1e-6;

fn is_corner(junction: &Junction) -> bool {
    matches!(junction, Junction::Corner { angle } if (angle - PI).abs() > UNNOTICED)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
#[path = "interpretation_tests.rs"]
mod tests;
