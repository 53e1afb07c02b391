//! Exact curves for maps known in closed form, drawn under the map's own curves.

use crate::closed_form::ExactMap;
use crate::conformal::{Constraints, PerSide};
use crate::geometry::sort_by_number;
use crate::model::curves::{Curve, Curves};
use crate::outline::Preset;

/// The number of points on each boundary at which exact curves are computed. With 160, the presets' polylines are
/// nowhere off by a pixel of the plot.
const PLACES: usize = 160;

/// Exact measures and reparameterization of the map that some [`Curves`] belong to.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactCurves {
    /// ω of source and target.
    pub measure: PerSide<Curve>,
    /// r, starting from the mapped side.
    pub reparameterisation: Curve,
    /// The largest distance of r̃ from r at these points, as a part of the other boundary's length.
    pub difference: f64,
}

impl ExactCurves {
    /// The exact curves of the same map as `curves`.
    ///
    /// They are evaluated at samples of both sides, which are dense where their side is curved, so that r is
    /// resolved well both where it is steep and where it is flat.
    pub fn new(exact: &ExactMap, curves: &Curves) -> Self {
        let places = PerSide::from_fn(|side| thinned(&curves.measure[side]));
        let measure = PerSide::from_fn(|side| {
            let points = places[side].iter().map(|&x| [x, exact.measure(side, x)]).collect();
            curve(points)
        });
        let (mapped, other) = (curves.mapped, curves.mapped.other());
        let forward = places[mapped].iter().map(|&x| [x, exact.reparameterisation(mapped, x)]);
        let forward: Vec<[f64; 2]> = forward.collect();
        let difference = |&[x, r]: &[f64; 2]| (curves.reparameterisation.at(x) - r).abs();
        let difference = forward.iter().map(difference).fold(0.0, f64::max);
        let backward = places[other].iter().map(|&r| [exact.reparameterisation(other, r), r]);
        let reparameterisation = curve(forward.into_iter().chain(backward).collect());
        Self { measure, reparameterisation, difference }
    }
}

/// The inputs of exact curves: the preset outlines, the constraints, and the map's own curves.
#[derive(Debug, PartialEq)]
struct Parts {
    presets: Option<PerSide<Preset>>,
    constraints: Constraints,
    curves: Curves,
}

/// The exact curves of the last map, recomputed only if their inputs change: refining a map's extension does not
/// change them, and maps of surfaces have none.
#[derive(Debug, Default)]
pub struct KeptExact {
    parts: Option<Parts>,
    exact: Option<ExactCurves>,
}

impl KeptExact {
    /// Updates the curves; returns whether anything was computed. Without presets the map is not known in closed form.
    pub fn update(&mut self, presets: Option<PerSide<Preset>>, constraints: Constraints, curves: &Curves) -> bool {
        let is_same =
            |parts: &Parts| parts.presets == presets && parts.constraints == constraints && parts.curves == *curves;
        if self.parts.as_ref().is_some_and(is_same) {
            return false;
        }
        let exact = presets.and_then(|presets| ExactMap::between(presets, &constraints));
        self.exact = exact.map(|exact| ExactCurves::new(&exact, curves));
        self.parts = Some(Parts { presets, constraints, curves: curves.clone() });
        true
    }

    /// The curves; `None` if the map is not known in closed form.
    pub fn curves(&self) -> Option<&ExactCurves> {
        self.exact.as_ref()
    }
}

/// A curve through points of a non-decreasing function with rounding errors.
fn curve(mut points: Vec<[f64; 2]>) -> Curve {
    sort_by_number(&mut points, |point| point[1]);
    sort_by_number(&mut points, |point| point[0]);
    let mut highest = 0.0_f64;
    for [_, y] in &mut points {
        highest = highest.max(*y);
        *y = highest;
    }
    Curve { name: String::from("exact"), points }
}

/// The arc lengths of some of a curve's points, including its ends.
fn thinned(curve: &Curve) -> Vec<f64> {
    let last = curve.points.len() - 1;
    let count = last.min(PLACES);
    (0..=count).map(|k| curve.points[k * last / count][0]).collect()
}
