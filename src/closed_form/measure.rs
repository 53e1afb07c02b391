//! The exact harmonic measure of a preset as a function of arc length from its outline's first point, and its inverse.
//!
//! Both map `[0, 1]` onto itself and, up to rounding, do not decrease. The inverse is computed by
//! false position between tabulated values. Where measures differ by less than 1e-16, as in the far arm of the V, f64
//! cannot separate them: there the measure is a step function, and the inverse returns one of the points on the step.

use super::ArcLength;
use super::crossing::crossing;
use crate::exact::{Complex, blob, complex, disk, square, vshape};
use crate::geometry::DVec2;
use crate::outline::Preset;
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// The number of tabulated intervals of arc length.
const INTERVALS: usize = 1024;
/// The accuracy of the inverse, as a part of the length.
const TOLERANCE: f64 = 1e-12;
/// A point within this fraction of arc length counts as the first point: the V's measure
/// cannot distinguish the two sides of its tip within a parameter of 1e-13.
const FIRST_POINT: f64 = 1e-12;

/// The preset's square is [−0.9, 0.9]².
const HALF_SIDE: f64 = 0.9;

/// How the measure seen from x is computed.
#[derive(Debug, Clone, Copy)]
enum Form {
    /// From the image g(x) in the disk and the argument of g on the boundary; g is 1 at the first point.
    ThroughDisk { image: Complex, argument: fn(f64) -> f64 },
    /// In the V's strip coordinate.
    Strip { x: DVec2 },
}

/// The harmonic measure of a preset's exact curve from a point x inside it.
#[derive(Debug, Clone)]
pub struct ExactMeasure {
    form: Form,
    /// The measure at arc length k/[`INTERVALS`] of the whole.
    knots: Vec<f64>,
}

impl ExactMeasure {
    /// `None` for a preset without a closed form, and if `x` is not inside its curve.
    pub fn new(preset: Preset, x: DVec2) -> Option<Self> {
        let form = form(preset, x)?;
        let mut highest = 0.0_f64;
        let mut knot = |k: usize| {
            highest = highest.max(form.measure(k as f64 / INTERVALS as f64));
            highest
        };
        let knots = (0..=INTERVALS).map(&mut knot).collect();
        Some(Self { form, knots })
    }

    /// ω from the outline's first point counter-clockwise to the fraction `s` of its arc length. Absolute error
    /// about 1e-15, plus the effect of the arc length's error.
    pub fn at(&self, s: f64) -> f64 {
        let k = ((s * INTERVALS as f64) as usize).min(INTERVALS - 1);
        self.form.measure(s).clamp(self.knots[k], self.knots[k + 1])
    }

    /// The fraction of arc length at which ω is `omega`, up to 1e-12. Takes five to ten evaluations of the measure.
    pub fn inverse_at(&self, omega: f64) -> f64 {
        let k = self.knots.partition_point(|&knot| knot <= omega).clamp(1, INTERVALS) - 1;
        let end = |k: usize| (k as f64 / INTERVALS as f64, self.knots[k] - omega);
        crossing(|s| self.at(s) - omega, [end(k), end(k + 1)], TOLERANCE)
    }
}

fn form(preset: Preset, x: DVec2) -> Option<Form> {
    let z = complex(x);
    let (image, argument): (Complex, fn(f64) -> f64) = match preset {
        Preset::Disk => (z, |s| TAU * s),
        Preset::Square if x.abs().max_element() < HALF_SIDE => {
            // the preset's first point is the middle of its top, a quarter turn from that of the closed form
            (square::to_disk((1.0 / HALF_SIDE) * (-Complex::I * z)), square::boundary_angle)
        }
        Preset::Blob => (blob::to_disk(z)?, |s| TAU * blob_arc().parameter(s * blob_arc().total())),
        Preset::VShape => return vshape::contains(x).then_some(Form::Strip { x }),
        _ => return None,
    };
    (image.norm() < 1.0).then_some(Form::ThroughDisk { image, argument })
}

impl Form {
    fn measure(&self, s: f64) -> f64 {
        if s < FIRST_POINT {
            return 0.0;
        }
        if s > 1.0 - FIRST_POINT {
            return 1.0;
        }
        let omega = match self {
            Self::ThroughDisk { image, argument } => disk::harmonic_measure(*image, argument(s)),
            Self::Strip { x } => {
                let arc = v_arc();
                vshape::harmonic_measure(*x, vshape::boundary(arc.parameter(s * arc.total())))
            }
        };
        omega.clamp(0.0, 1.0)
    }
}

fn blob_arc() -> &'static ArcLength {
    static ARC: OnceLock<ArcLength> = OnceLock::new();
    ARC.get_or_init(|| ArcLength::coarse(blob::boundary, 1.0))
}

fn v_arc() -> &'static ArcLength {
    static ARC: OnceLock<ArcLength> = OnceLock::new();
    ARC.get_or_init(|| ArcLength::coarse(vshape::boundary, 4.0))
}
