//! The boundary of a planar side as a curve: the samples' points on it, and arc length.
//!
//! Two coordinates along the curve are used. The *fraction* of its length is what anchors and files hold. The
//! *station*, the length of the pieces before plus t times the length of the own piece, costs nothing, increases
//! strictly along the curve, and is the length itself on lines and circles; order and interpolation between samples use
//! it.

use super::arc_table::ArcTable;
use super::error::Unsharpened;
use crate::geometry::{Curve, CurvePoint, DVec2, Piece, SimplePolygon, nearest_of_polygon};
use crate::outline::{BoundaryPoint, BoundarySamples};
use std::sync::Arc;

/// A part of a piece, or of an edge, below which a point is its end: as for samples, whose rounding is below 1e-10 of
/// the shortest edges.
const SNAP: f64 = 1e-9;

/// Distances of a junction from a vertex of the polygon, in perimeters, up to which it is that vertex. Vertices are
/// evaluations of the curve, right to 1e-16.
const SAME_PLACE: f64 = 1e-12;

/// The boundary of a side as a curve, with the samples on it.
#[derive(Debug)]
pub struct CurveBoundary {
    curve: Curve,
    arcs: Arc<[ArcTable]>,
    /// The lengths up to the pieces, and the perimeter.
    starts: Vec<f64>,
    /// The samples' points.
    points: Vec<CurvePoint>,
    /// The samples' stations, and the perimeter.
    stations: Vec<f64>,
}

impl CurveBoundary {
    /// The curve, without samples.
    pub(super) fn new(curve: &Curve) -> Self {
        let arc = |(piece, &length): (&Piece, &f64)| ArcTable::new(piece.clone(), length);
        let arcs = curve.pieces().iter().zip(curve.lengths()).map(arc).collect();
        let mut starts = vec![0.0];
        starts.extend(curve.lengths().iter().scan(0.0, |sum, length| {
            *sum += length;
            Some(*sum)
        }));
        Self { curve: curve.clone(), arcs, starts, points: Vec::new(), stations: Vec::new() }
    }

    /// The curve with samples at these points of it; `None` unless they ascend from the curve's first point.
    #[cfg(feature = "io")]
    pub(super) fn with_points(curve: &Curve, points: Vec<CurvePoint>) -> Option<Self> {
        let mut boundary = Self::new(curve);
        let is_sound = points.iter().all(|point| point.piece() < curve.pieces().len());
        if !is_sound || points.is_empty() {
            return None;
        }
        boundary.set_points(points);
        let stations = &boundary.stations;
        (stations[0] == 0.0 && stations.windows(2).all(|pair| pair[0] < pair[1])).then_some(boundary)
    }

    fn set_points(&mut self, points: Vec<CurvePoint>) {
        self.stations = points.iter().map(|&point| self.station(point)).chain([self.perimeter()]).collect();
        self.points = points;
    }

    /// Moves samples of the polygon, whose vertices lie on the curve, onto the curve. Between two junctions lengths along
    /// polygon and curve are in proportion, so that corners stay corners.
    ///
    /// Errors: the junctions do not lie on the polygon in their order, beginning with its first vertex.
    pub(super) fn set_samples(
        &mut self,
        polygon: &SimplePolygon,
        samples: &BoundarySamples,
    ) -> Result<BoundarySamples, Unsharpened> {
        let junctions = self.junctions_on(polygon)?;
        let points: Vec<CurvePoint> = samples.fractions().iter().map(|&s| self.moved(&junctions, s)).collect();
        let fractions: Vec<f64> = points.iter().map(|&point| self.fraction(point)).collect();
        let places = points.iter().map(|&point| self.curve().position(point)).collect();
        let moved = BoundarySamples::on_curve(places, fractions).ok_or(Unsharpened::Apart)?;
        self.set_points(points);
        Ok(moved)
    }

    /// The same curve with other samples, at these places of the samples' boundary, the first of which is sample 0.
    pub(in crate::conformal) fn resampled(&self, places: &[BoundaryPoint]) -> Self {
        let points: Vec<CurvePoint> = places.iter().map(|&place| self.curved(place)).collect();
        let stations = points.iter().map(|&point| self.station(point)).chain([self.perimeter()]).collect();
        let (curve, arcs) = (self.curve.clone(), Arc::clone(&self.arcs));
        Self { curve, arcs, starts: self.starts.clone(), points, stations }
    }

    /// The fractions of the polygon's length at the junctions, and 1.
    fn junctions_on(&self, polygon: &SimplePolygon) -> Result<Vec<f64>, Unsharpened> {
        let vertices = polygon.vertices();
        let mut lengths = vec![0.0];
        for (k, (a, b)) in polygon.edges().enumerate() {
            lengths.push(lengths[k] + a.distance(b));
        }
        let perimeter = lengths[vertices.len()];
        let tolerance = SAME_PLACE * perimeter;
        let fraction = |place: DVec2| {
            let nearest = nearest_of_polygon(vertices, place)?;
            let [a, b] = [nearest.edge, nearest.edge + 1].map(|k| vertices[k % vertices.len()]);
            let length = if place.distance(a) <= tolerance {
                lengths[nearest.edge]
            } else if place.distance(b) <= tolerance {
                lengths[nearest.edge + 1]
            } else {
                lengths[nearest.edge] + nearest.along * a.distance(b)
            };
            Some(if length == perimeter { 0.0 } else { length / perimeter })
        };
        let places = self.curve().pieces().iter().map(|piece| fraction(piece.jet(0.0).position));
        let mut junctions = places.collect::<Option<Vec<f64>>>().ok_or(Unsharpened::Apart)?;
        junctions.push(1.0);
        let is_in_order = junctions[0] == 0.0 && junctions.windows(2).all(|pair| pair[0] < pair[1]);
        is_in_order.then_some(junctions).ok_or(Unsharpened::Apart)
    }

    /// The point of the curve for the fraction `s` of the polygon's length.
    fn moved(&self, junctions: &[f64], s: f64) -> CurvePoint {
        let count = self.arcs.len();
        let piece = (junctions.partition_point(|&junction| junction <= s).max(1) - 1).min(count - 1);
        let share = (s - junctions[piece]) / (junctions[piece + 1] - junctions[piece]);
        let is_spline = matches!(self.curve().pieces()[piece], Piece::Spline { .. });
        if is_spline && (SNAP..=1.0 - SNAP).contains(&share) {
            // the parameter of a spline through the vertices is the length along the polygon
            return CurvePoint::new(piece, share);
        }
        self.on_piece(piece, share)
    }

    /// The point at a share of a piece's length; one within rounding of an end is the end.
    fn on_piece(&self, piece: usize, share: f64) -> CurvePoint {
        if share < SNAP {
            CurvePoint::new(piece, 0.0)
        } else if share > 1.0 - SNAP {
            CurvePoint::new((piece + 1) % self.arcs.len(), 0.0)
        } else {
            CurvePoint::new(piece, self.arcs[piece].parameter_at(share * self.curve().lengths()[piece]))
        }
    }

    /// The curve.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The samples' points on the curve, `m` of them.
    pub fn points(&self) -> &[CurvePoint] {
        &self.points
    }

    /// The length of the curve.
    pub fn perimeter(&self) -> f64 {
        self.starts[self.arcs.len()]
    }

    /// The point at the fraction `s` of the length (taken modulo 1) from the first sample.
    pub fn at_fraction(&self, s: f64) -> CurvePoint {
        let length = s.rem_euclid(1.0) * self.perimeter();
        let piece = (self.starts.partition_point(|&start| start <= length).max(1) - 1).min(self.arcs.len() - 1);
        self.on_piece(piece, (length - self.starts[piece]) / self.curve().lengths()[piece])
    }

    /// The fraction of the length at a point, in [0, 1].
    pub fn fraction(&self, point: CurvePoint) -> f64 {
        (self.starts[point.piece()] + self.arcs[point.piece()].length_to(point.from_start())) / self.perimeter()
    }

    /// The fraction of the length at the point of the curve nearest to `x`, found from one near to it.
    pub fn nearest_fraction(&self, x: DVec2, near: f64) -> f64 {
        let mut best = self.at_fraction(near);
        let distance = |point: CurvePoint| self.curve().position(point).distance(x);
        let (mut step, least) = (self.perimeter() / self.points.len().max(1) as f64, 1e-17 * self.perimeter());
        let mut station = self.station(best);
        while step > least {
            let other = [station + step, station - step].map(|s| self.at_station(s));
            match other.into_iter().find(|&point| distance(point) < distance(best)) {
                Some(better) => (best, station) = (better, self.station(better)),
                None => step *= 0.5,
            }
        }
        self.fraction(best)
    }

    /// The station of a point.
    pub(in crate::conformal) fn station(&self, point: CurvePoint) -> f64 {
        self.starts[point.piece()] + point.from_start() * self.curve().lengths()[point.piece()]
    }

    /// The point at a station, taken modulo the perimeter.
    pub(in crate::conformal) fn at_station(&self, station: f64) -> CurvePoint {
        let station = station.rem_euclid(self.perimeter());
        let piece = (self.starts.partition_point(|&start| start <= station).max(1) - 1).min(self.arcs.len() - 1);
        CurvePoint::new(piece, (station - self.starts[piece]) / self.curve().lengths()[piece])
    }

    /// The point of the sampled boundary that belongs to a point of the curve.
    pub(in crate::conformal) fn sampled(&self, point: CurvePoint) -> BoundaryPoint {
        let station = self.station(point);
        let edge = (self.stations.partition_point(|&s| s <= station).max(1) - 1).min(self.points.len() - 1);
        let share = (station - self.stations[edge]) / (self.stations[edge + 1] - self.stations[edge]);
        BoundaryPoint::new(edge as u32, share.clamp(0.0, 1.0 - f64::EPSILON))
    }

    /// The point of the curve that belongs to a point of the sampled boundary.
    pub(in crate::conformal) fn curved(&self, point: BoundaryPoint) -> CurvePoint {
        let edge = point.edge() as usize;
        if point.fraction() == 0.0 {
            return self.points[edge];
        }
        let (from, to) = (self.stations[edge], self.stations[edge + 1]);
        self.at_station(from + point.fraction() * (to - from))
    }
}
