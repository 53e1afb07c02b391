//! Loaded outlines with their curves: points in 24 bits per coordinate, or the pieces of a path in full precision.
//!
//! 16 bits, as `quantized` has them, would destroy the curvature of a smooth curve: on a circle of 1,440 points they
//! move the harmonic measure by 4e-5, 24 bits by 2e-7. An outline that stays a polygon although it was not read as one
//! keeps the 16 bits.
//!
//! Points are stored as the changes of the steps from point to point, modulo 2²⁴; rounding again changes nothing.

use super::envelope::MAX_BYTES;
use super::quantized::Quantized;
use super::{Choice, LinkError, NotCarried};
use crate::conformal::Side;
use crate::geometry::{Bounds, DVec2, SimplePolygon};
use crate::outline::{CurveForm, CurveSource, Interpretation, Segment, flattened};
use serde::{Deserialize, Serialize};

/// The largest coordinate of a point in the box around the outline.
const LAST: u32 = (1 << 24) - 1;

/// An outline as it is written. The order of the fields and of the variants is part of the format.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct WiredCurve {
    interpretation: u8,
    switched: Vec<u32>,
    shape: WiredShape,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum WiredShape {
    Coarse(Quantized),
    Fine(Fine),
    Path(Vec<WiredSegment>),
}

/// Points in 24 bits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Fine {
    low: [f64; 2],
    high: [f64; 2],
    changes: Vec<(i32, i32)>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum WiredSegment {
    Line([f64; 4]),
    Cubic([f64; 8]),
    Arc([f64; 8]),
}

impl WiredCurve {
    /// The form for a link. Errors: the outline is too long, or rounded to the bits of its kind it is no simple polygon
    /// or another one when rounded again.
    pub fn of(polygon: &SimplePolygon, form: &CurveForm) -> Result<Self, NotCarried> {
        // a list that is too long is refused without its curve
        let is_short = polygon.vertices().len() <= MAX_BYTES / 2;
        let is_smooth = || is_short && form.curve(polygon).is_ok_and(|curve| curve.is_smooth());
        let shape = match &form.source {
            CurveSource::Segments(segments) => WiredShape::Path(segments.iter().map(WiredSegment::of).collect()),
            _ if is_smooth() => WiredShape::Fine(Fine::of(polygon.vertices())?),
            _ => WiredShape::Coarse(Quantized::of(polygon.vertices())?),
        };
        Ok(Self { interpretation: code(form.interpretation), switched: form.switched.clone(), shape })
    }

    /// The number of points, or twice that of pieces, which take more bytes.
    pub fn len(&self) -> usize {
        match &self.shape {
            WiredShape::Coarse(points) => points.len(),
            WiredShape::Fine(points) => points.changes.len(),
            WiredShape::Path(segments) => 2 * segments.len(),
        }
    }

    /// The polygon and the form of its curve. Errors: it is no simple polygon, or the interpretation is not known.
    pub fn outline(self, side: Side) -> Result<(SimplePolygon, CurveForm), LinkError> {
        let interpretation = interpretation(self.interpretation)?;
        let (points, source) = match self.shape {
            WiredShape::Coarse(points) => (points.points(), CurveSource::Points),
            WiredShape::Fine(points) => (points.points(), CurveSource::Points),
            WiredShape::Path(segments) => {
                let segments: Vec<Segment> = segments.iter().map(WiredSegment::segment).collect();
                (flattened(&segments), CurveSource::Segments(segments))
            }
        };
        let polygon = SimplePolygon::try_from(points).map_err(|reason| LinkError::Outline { side, reason })?;
        if polygon.was_clockwise() {
            return Err(LinkError::Damaged);
        }
        let mut switched = self.switched;
        switched.sort_unstable();
        switched.dedup();
        let form = CurveForm { interpretation, switched, source };
        if form.fits(&polygon) { Ok((polygon, form)) } else { Err(LinkError::Damaged) }
    }
}

fn code(interpretation: Interpretation) -> u8 {
    match interpretation {
        Interpretation::Auto => 0,
        Interpretation::Polygon => 1,
        Interpretation::Smooth => 2,
    }
}

fn interpretation(code: u8) -> Result<Interpretation, LinkError> {
    match code {
        0 => Ok(Interpretation::Auto),
        1 => Ok(Interpretation::Polygon),
        2 => Ok(Interpretation::Smooth),
        _ => Err(LinkError::Unknown { what: Choice::Setting, name: format!("interpretation {code}") }),
    }
}

impl Fine {
    fn of(points: &[DVec2]) -> Result<Self, NotCarried> {
        if points.len() > MAX_BYTES / 2 {
            return Err(NotCarried::TooLong { points: points.len() });
        }
        let bounds = Bounds::of(points.iter().copied());
        let cell = |p: DVec2| {
            let q = (f64::from(LAST) * ((p - bounds.min()) / bounds.size())).round();
            [q.x as i32, q.y as i32]
        };
        let (mut step, mut at) = ([0; 2], [0; 2]);
        let change = |&p: &DVec2| {
            let here = cell(p);
            let next = [here[0] - at[0], here[1] - at[1]];
            let change = (next[0] - step[0], next[1] - step[1]);
            (step, at) = (next, here);
            change
        };
        let changes = points.iter().map(change).collect();
        let fine = Self { low: bounds.min().to_array(), high: bounds.max().to_array(), changes };
        let rounded = fine.points();
        let again = Bounds::of(rounded.iter().copied());
        if again != bounds || !rounded.iter().zip(points).all(|(&p, &q)| cell(p) == cell(q)) {
            return Err(NotCarried::Inexact);
        }
        let polygon = SimplePolygon::try_from(rounded).map_err(NotCarried::NotSimple)?;
        if polygon.was_clockwise() {
            return Err(NotCarried::Inexact);
        }
        Ok(fine)
    }

    /// The points, not checked in any way.
    fn points(&self) -> Vec<DVec2> {
        let bounds = Bounds::new(self.low.into(), self.high.into());
        let (mut step, mut at) = ([0u32; 2], [0u32; 2]);
        let place = |&(dx, dy): &(i32, i32)| {
            for (k, change) in [dx, dy].into_iter().enumerate() {
                step[k] = step[k].wrapping_add(change as u32);
                at[k] = at[k].wrapping_add(step[k]) & LAST;
            }
            let cell = DVec2::new(f64::from(at[0]), f64::from(at[1]));
            let inner = bounds.min() + bounds.size() * (cell / f64::from(LAST));
            DVec2::select(cell.cmpeq(DVec2::splat(f64::from(LAST))), bounds.max(), inner)
        };
        self.changes.iter().map(place).collect()
    }
}

impl WiredSegment {
    fn of(segment: &Segment) -> Self {
        match *segment {
            Segment::Line([a, b]) => Self::Line([a.x, a.y, b.x, b.y]),
            Segment::Cubic([a, b, c, d]) => Self::Cubic([a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y]),
            Segment::Arc { center: c, axes: [a, b], from, to } => Self::Arc([c.x, c.y, a.x, a.y, b.x, b.y, from, to]),
        }
    }

    fn segment(&self) -> Segment {
        let p = DVec2::new;
        match *self {
            Self::Line([a, b, c, d]) => Segment::Line([p(a, b), p(c, d)]),
            Self::Cubic([a, b, c, d, e, f, g, h]) => Segment::Cubic([p(a, b), p(c, d), p(e, f), p(g, h)]),
            Self::Arc([a, b, c, d, e, f, from, to]) => {
                Segment::Arc { center: p(a, b), axes: [p(c, d), p(e, f)], from, to }
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::super::{decode, encode};
    use super::*;
    use crate::outline::{Preset, parse};
    use crate::session::{Command, OutlineSpec, Session};
    use std::f64::consts::TAU;

    fn with(outline: OutlineSpec) -> Session {
        Session::with([
            Command::SetOutline { side: Side::Target, outline },
            Command::MoveAnchor { side: Side::Target, fraction: 0.3 },
        ])
    }

    fn round_trip(outline: OutlineSpec) -> (String, OutlineSpec) {
        let encoded = encode(&with(outline)).unwrap();
        assert_eq!(encoded.left_out, []);
        let decoded = decode(&encoded.fragment).unwrap();
        assert_eq!(decoded.missing, []);
        assert_eq!(decoded.session.side(Side::Target).anchor, 0.3);
        let outline = decoded.session.domain(Side::Target).outline.clone();
        assert_eq!(
            encode(&with(outline.clone())).unwrap().fragment,
            encoded.fragment,
            "the second time changes nothing"
        );
        (encoded.fragment, outline)
    }

    #[test]
    fn points_of_a_smooth_curve_keep_24_bits() {
        let points: Vec<DVec2> = Preset::Disk.outline().polygon().vertices().to_vec();
        let thin: Vec<DVec2> = points.iter().step_by(4).map(|p| 3.0 * *p + 0.1).collect();
        let polygon = SimplePolygon::try_from(thin.clone()).unwrap();
        let given = OutlineSpec::points("round".into(), polygon)
            .with_form(CurveForm { switched: vec![3, 70], ..CurveForm::default() });
        let (fragment, found) = round_trip(given.clone());
        assert!(fragment.starts_with("s=2."), "{fragment}");
        let OutlineSpec::Points { name, polygon, form } = &found else { unreachable!() };
        assert_eq!(name, "round");
        assert_eq!(*form, CurveForm { switched: vec![3, 70], ..CurveForm::default() });
        let worst = polygon.vertices().iter().zip(&thin).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
        println!("{} characters, moved by up to {worst:.1e}", fragment.len());
        assert!(worst < 0.75 * 6.0 / f64::from(LAST), "{worst:e}");
        let corners = |outline: &OutlineSpec| outline.curve().unwrap().corner_count();
        assert_eq!([corners(&given), corners(&found)], [2, 2]);
    }

    #[test]
    fn the_path_of_an_svg_is_kept_exactly() {
        let text = b"M 10.1 10 H 20.3 A 5 5 0 0 1 20.3 20 C 15 22 12 17 10.1 20 A 5 5 0 0 1 10.1 10 Z";
        let given: OutlineSpec = parse("stadium", text).unwrap().into();
        let (fragment, found) = round_trip(given.clone());
        println!("{} characters", fragment.len());
        assert_eq!(found, given);
    }

    /// Its polygon is that of a simple circle, but a curve of it has thousands of parts.
    #[test]
    fn an_arc_of_many_turns_is_refused() {
        let circle = |turns: f64| {
            let path = vec![WiredSegment::Arc([0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, turns * TAU])];
            let wired = WiredCurve { interpretation: 0, switched: vec![2, 1, 2], shape: WiredShape::Path(path) };
            wired.outline(Side::Source)
        };
        assert_eq!(circle(1.0).unwrap().1.switched, [1, 2]);
        assert!(matches!(circle(512_001.0), Err(LinkError::Damaged)));
    }

    #[test]
    fn a_forced_interpretation_is_kept() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from).to_vec();
        let square = OutlineSpec::points("square".into(), SimplePolygon::try_from(square).unwrap());
        assert!(round_trip(square.clone()).0.starts_with("s=1."), "short lists are polygons anyway");
        for interpretation in [Interpretation::Polygon, Interpretation::Smooth] {
            let form = CurveForm { interpretation, ..CurveForm::default() };
            let (_, found) = round_trip(square.clone().with_form(form.clone()));
            assert!(matches!(found, OutlineSpec::Points { form: found, .. } if found == form));
        }
    }

    #[test]
    fn a_long_list_from_an_old_link_is_a_polygon() {
        let polygon = Preset::Heart.outline().into_polygon();
        let old = OutlineSpec::points("heart".into(), polygon).with_form(CurveForm::polygon());
        let (fragment, found) = round_trip(old);
        assert!(fragment.starts_with("s=1."));
        assert!(!found.curve().unwrap().is_smooth());
    }
}
