//! Where finite elements continue the boundary integral next to an anchor, and what they continue with.
//!
//! Both measures are counted from the anchor at the knots. Below the [`least`] measure, or up to where both
//! [agree](agreed), the one of finite elements is taken, times the ratio of both over the adjoining stretch where the
//! measure is 10 to 1000 times as large. No smaller total is divided by.

use super::super::HarmonicMeasure;
use super::CurveBoundary;
use super::sharp::Way;
use crate::boundary_integral::{self, AnchoredMeasure};

/// Measures from an anchor in a crowded part are those of finite elements below this one, where rounding leaves sums of
/// the boundary integral a relative error of 1e-3.
const LEAST: f64 = 1e-12;
/// The same, in floors of the measure, where these are larger than rounding. The residual of the identities is 100 times
/// the error found in the stem of a leaf of 601 points.
const LEAST_IN_FLOORS: f64 = 30.0;
/// The stretch over which the two measures are compared, in least measures.
const COMPARED: [f64; 2] = [10.0, 1000.0];

/// Finite elements continue up to where the two measures agree: from there on their ratio differs by less than this from
/// that of a ten times larger measure. Panels that are not resolved leave errors of up to 100 floors all along a channel:
/// in the spiral of 526 points both ratios differ by 1e5 there, and elsewhere by 1.03.
pub const AGREED: f64 = 1.25;
/// The largest measure up to which they continue for that reason, in error estimates.
const MOST_IN_ERRORS: f64 = 10.0;

/// The measure from an anchor in a crowded part of the boundary below which finite elements continue.
pub fn least(swept: &boundary_integral::HarmonicMeasure) -> f64 {
    LEAST.max(LEAST_IN_FLOORS * swept.floor())
}

/// The smallest measure from which on both measures agree, between `least` and a few `error`s; `least` if they do not
/// agree there either.
pub fn agreed(measure: &[f64], finite: &[f64], least: f64, error: f64) -> f64 {
    let most = least.max(MOST_IN_ERRORS * error);
    let mut outer = measure.partition_point(|&omega| omega < most).min(measure.len() - 1);
    let mut agreed = least;
    for k in (1..outer).rev() {
        while outer > k + 1 && finite[outer - 1] > 10.0 * finite[k] {
            outer -= 1;
        }
        let change = measure[k] * finite[outer] / (finite[k] * measure[outer]);
        if !(AGREED.recip()..=AGREED).contains(&change) || measure[k] < least {
            break;
        }
        agreed = measure[k];
    }
    agreed.max(least)
}

/// The ratio of the boundary integral's measure to the finite elements' over the stretch that both resolve.
pub fn ratio(
    boundary: &CurveBoundary,
    anchored: &AnchoredMeasure<'_>,
    (finite, sums): (&HarmonicMeasure, &[f64]),
    way: Way,
    least: f64,
) -> f64 {
    let point = |omega: f64| match way {
        Way::Forward => anchored.point_at(omega),
        Way::Backward => anchored.point_before(omega),
    };
    let at = |omega: f64| -> f64 {
        let (j, lambda) = finite.place_of(boundary.sampled(point(omega)));
        let share = finite.share(j, lambda);
        let (knot, share) = if way == Way::Forward { (j, share) } else { (sums.len() - 2 - j, 1.0 - share) };
        sums[knot] + (sums[knot + 1] - sums[knot]) * share
    };
    let [from, to] = COMPARED.map(|factor| (factor * least).min(0.5));
    (to - from) / (at(to) - at(from))
}

/// Replaces measures below `least` at the knots after the anchor by the finite elements', times the ratio; returns
/// how many. At most so much that the next knot's measure is not reached.
pub fn carry_on(measure: &mut [f64], finite: &[f64], least: f64, ratio: impl FnOnce() -> f64) -> usize {
    let small = measure[1..].partition_point(|&omega| omega < least);
    // without a knot of its own measure there is nothing to continue: a knot may be the anchor itself
    if small == 0 || finite[small] == 0.0 || small + 1 >= measure.len() {
        return 0;
    }
    let (ratio, most) = (ratio(), measure[small + 1] / finite[small + 1]);
    let ratio = if ratio > 0.0 && ratio < most { ratio } else { most };
    if !(ratio.is_finite() && ratio > 0.0) {
        return 0;
    }
    for (omega, finite) in measure[1..=small].iter_mut().zip(&finite[1..=small]) {
        *omega = ratio * finite;
    }
    small
}
