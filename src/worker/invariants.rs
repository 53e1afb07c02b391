//! Conformal invariants of one outline, as a study: the request and its result, which cross to the worker as bytes.

use super::packed::as_json;
use crate::boundary_integral::{self, Estimate, InvariantsRequest};
use crate::conformal::{Marks, Quadrilateral, Side};
use crate::geometry::{Curve, DVec2, SimplePolygon};
use crate::language::{Message, key};
use crate::outline::CurveForm;
use crate::session::OutlineSpec;
use serde::{Deserialize, Serialize};

/// An outline, and the points that its invariants depend on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InvariantsTask {
    /// The side that the outline belongs to.
    pub side: Side,
    /// The outline.
    pub outline: StudiedOutline,
    /// The interior point.
    pub point: DVec2,
    /// The point to which the hyperbolic distance is wanted.
    pub second_point: Option<DVec2>,
    /// Four marks, as fractions of the boundary's length from its first point.
    pub marks: Option<[f64; 4]>,
}

/// An outline as it travels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StudiedOutline {
    /// A built-in outline.
    Preset(crate::outline::Preset),
    /// A loaded one.
    Points {
        /// The vertices of its polygon.
        points: Vec<DVec2>,
        /// How its curve is found.
        #[serde(with = "as_json")]
        form: CurveForm,
    },
}

/// A number with an estimate of its error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the names say it")]
pub struct Number {
    pub value: f64,
    pub error: f64,
}

/// The invariants of an outline.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FoundInvariants {
    /// The measures of the arcs from mark to mark, or else of the pieces between corners.
    pub measures: Vec<Number>,
    /// The conformal radius at the point.
    pub conformal_radius: Number,
    /// The logarithmic capacity.
    pub capacity: Number,
    /// The modulus of the marked quadrilateral.
    pub modulus: Option<Number>,
    /// The hyperbolic distance of the two points.
    pub hyperbolic_distance: Option<Number>,
    /// The numbers of unknowns of both resolutions.
    pub unknowns: [usize; 2],
}

/// The number, or the largest one in place of an infinite one: text has no infinities.
pub(super) fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { f64::MAX }
}

impl From<Estimate> for Number {
    /// A bound that is not finite becomes the largest number.
    fn from(Estimate { value, error }: Estimate) -> Self {
        Self { value: finite(value), error: finite(error) }
    }
}

impl From<&OutlineSpec> for StudiedOutline {
    fn from(outline: &OutlineSpec) -> Self {
        match outline {
            OutlineSpec::Preset(preset) => Self::Preset(*preset),
            OutlineSpec::Points { polygon, form, .. } => {
                Self::Points { points: polygon.vertices().to_vec(), form: form.clone() }
            }
        }
    }
}

impl StudiedOutline {
    pub(super) fn spec(&self) -> Result<OutlineSpec, Message> {
        match self {
            Self::Preset(preset) => Ok(OutlineSpec::Preset(*preset)),
            Self::Points { points, form } => {
                let polygon = SimplePolygon::try_from(points.clone()).map_err(|error| Message::from(&error))?;
                Ok(OutlineSpec::Points { name: String::new(), polygon, form: form.clone() })
            }
        }
    }
}

/// Whether the marks are four points in counter-clockwise cyclic order.
pub fn are_in_order(marks: [f64; 4]) -> bool {
    let steps = [0, 1, 2, 3].map(|k| (marks[(k + 1) % 4] - marks[k]).rem_euclid(1.0));
    // one turn from the first mark to itself
    steps.iter().all(|&step| step > APART) && steps.iter().sum::<f64>() < 1.5
}

/// The modulus of a quadrilateral, from viewpoints of its own: it does not depend on the point.
fn modulus_of(outline: (&SimplePolygon, &Curve), marks: [f64; 4]) -> Result<Number, Message> {
    let marks = Marks::new(marks).map_err(|error| Message::from(&error))?;
    let found = Quadrilateral::of_outline(outline, marks).map_err(|error| Message::from(&error))?;
    Ok(found.modulus().into())
}

/// Marks nearer to each other than this fraction of the boundary are one point.
const APART: f64 = 1e-14;

impl InvariantsTask {
    /// Computes the invariants. Errors: what the user can do nothing about or has to change, in words.
    pub fn run(&self) -> Result<FoundInvariants, Message> {
        if self.marks.is_some_and(|marks| !are_in_order(marks)) {
            return Err(key::marks_not_in_order().into());
        }
        let spec = self.outline.spec()?;
        let found = spec.curve().map_err(|_| key::outline_without_curve())?;
        let (sides, curve) = (found.sides().to_vec(), found.into_curve());
        let marks = self.marks.map(|marks| marks.map(|fraction| curve.point_at_fraction(fraction)));
        let request = InvariantsRequest::new(self.point).with_second_point(self.second_point).with_marks(marks);
        let found = boundary_integral::invariants(&curve, &request).map_err(|error| Message::from(&error))?;
        let modulus = match self.marks {
            Some(marks) => Some(modulus_of((&spec.polygon(), &curve), marks)?),
            None => None,
        };
        let measures = found.arcs.map_or_else(|| found.of_sides(&sides), |arcs| arcs.to_vec());
        Ok(FoundInvariants {
            measures: measures.into_iter().map(Number::from).collect(),
            conformal_radius: found.conformal_radius.into(),
            capacity: found.capacity.into(),
            modulus,
            hyperbolic_distance: found.hyperbolic_distance.map(Number::from),
            unknowns: found.unknowns,
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::{Interpretation, Preset};
    use crate::worker::{packed, unpacked};
    use std::f64::consts::TAU;

    fn task(outline: StudiedOutline) -> InvariantsTask {
        InvariantsTask { side: Side::Source, outline, point: DVec2::ZERO, second_point: None, marks: None }
    }

    #[test]
    fn the_disks_invariants_are_those_of_its_moebius_maps() {
        let marks = Some([0.0, 0.175, 0.35, 0.625]);
        let second_point = Some(DVec2::new(0.5, 0.0));
        let disk = InvariantsTask { second_point, marks, ..task(StudiedOutline::Preset(Preset::Disk)) };
        assert_eq!(unpacked::<InvariantsTask>(&packed(&disk)).unwrap(), disk);
        let found = disk.run().unwrap();
        let expected = [
            (found.conformal_radius, 1.0),
            (found.capacity, 1.0),
            (found.modulus.unwrap(), 1.045_465_950_033_828_5),
            (found.hyperbolic_distance.unwrap(), 3.0_f64.ln()),
            (found.measures[1], 0.175),
        ];
        for (number, value) in expected {
            let off = (number.value - value).abs();
            assert!(off <= number.error + 1e-15 && off < 1e-12, "{number:?} for {value}");
        }
        assert_eq!(found.measures.len(), 4);
    }

    #[test]
    fn a_loaded_square_has_four_sides_and_the_radius_of_the_table() {
        let points = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)].map(DVec2::from).to_vec();
        let switched = CurveForm { interpretation: Interpretation::Polygon, switched: vec![1], ..CurveForm::default() };
        for form in [CurveForm::default(), switched] {
            let square = task(StudiedOutline::Points { points: points.clone(), form });
            assert_eq!(unpacked::<InvariantsTask>(&packed(&square)).unwrap(), square);
        }
        let found = task(StudiedOutline::Points { points, form: CurveForm::default() }).run().unwrap();
        assert_eq!(found.measures.len(), 4);
        assert!((found.conformal_radius.value - 0.762_759_763_501_813_2).abs() < 1e-13, "{found:?}");
        assert!(found.modulus.is_none() && found.hyperbolic_distance.is_none());
    }

    #[test]
    fn what_does_not_fit_is_said() {
        let disk = task(StudiedOutline::Preset(Preset::Disk));
        let backwards = InvariantsTask { marks: Some([0.0, 0.5, 0.25, 0.75]), ..disk.clone() };
        assert_eq!(backwards.run().unwrap_err(), key::marks_not_in_order().into());
        let outside = InvariantsTask { second_point: Some(DVec2::new(2.0, 0.0)), ..disk };
        assert_eq!(outside.run().unwrap_err(), key::integral_not_inside(2.0, 0.0));
        let star =
            |k: u32| (if k.is_multiple_of(2) { 1.0 } else { 0.8 }) * DVec2::from_angle(f64::from(k) * (TAU / 6000.0));
        let points: Vec<DVec2> = (0..6000).map(star).collect();
        let many = task(StudiedOutline::Points { points, form: CurveForm::polygon() });
        let words = many.run().unwrap_err();
        assert_eq!(words.key(), key::integral_too_large(0_usize, 0_usize).key());
    }
}
