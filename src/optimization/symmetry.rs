//! How far a map is from keeping the symmetries of an outline.
//!
//! For each reflection R of one outline, and for its smallest rotation, the mismatch is the root mean square of
//! |f(R z) − R′ f(z)| over the outline, by area, in sizes of the other one, with the best R′ of the same kind there: a
//! reflection, or the rotation by the same angle. The criterion is the mean over all R for which there is an R′: 0 if and
//! only if f carries these symmetries over. A circle has all reflections through its center: then the best one is taken,
//! R′ w = e^{2iθ} w̄ with e^{2iθ} = Σ f(Rz) f(z) of unit length, by least squares.

use super::OptimizeError;
use crate::conformal::{PerSide, Side};
use crate::geometry::{Axis, DVec2, Rotations, Symmetries};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The turn of two circles that is compared: a map that keeps one of order 3 takes center to center.
const OF_CIRCLES: u32 = 3;

/// The most reflections that are compared.
const MOST_AXES: usize = 6;

/// A reflection or a rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Motion {
    Mirror(Axis),
    Turn {
        center: DVec2,
        angle: f64,
    },
    /// The best of all reflections at lines through a circle's center.
    AnyMirror {
        center: DVec2,
    },
}

impl Motion {
    /// The image of a point; itself under [`Self::AnyMirror`].
    pub fn moved(&self, p: DVec2) -> DVec2 {
        match self {
            Self::Mirror(axis) => axis.reflected(p),
            Self::Turn { center, angle } => center + DVec2::from_angle(*angle).rotate(p - center),
            Self::AnyMirror { .. } => p,
        }
    }

    /// The weighted sum of |f(Rz) − R′ f(z)|² with this R′.
    fn off(&self, images: &[Images]) -> f64 {
        let Self::AnyMirror { center } = *self else {
            return images.iter().map(|at| at.weight * at.moved.distance_squared(self.moved(at.place))).sum();
        };
        let complex = |p: DVec2| Complex64::new(p.x - center.x, p.y - center.y);
        let sum: Complex64 = images.iter().map(|at| at.weight * complex(at.moved) * complex(at.place)).sum();
        let squares: f64 = images
            .iter()
            .map(|at| at.weight * (at.moved.distance_squared(center) + at.place.distance_squared(center)))
            .sum();
        (squares - 2.0 * sum.norm()).max(0.0)
    }
}

/// The images of a place and of the moved place, and the place's weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Images {
    pub place: DVec2,
    pub moved: DVec2,
    pub weight: f64,
}

/// The symmetries of one outline, each with those that it may become on the other one.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedSymmetries {
    side: Side,
    pairs: Vec<(Motion, Vec<Motion>)>,
    /// The size of the other outline.
    size: f64,
}

impl SharedSymmetries {
    /// Those of two outlines. Errors: they have no kind of symmetry in common.
    pub fn new(symmetries: &PerSide<Symmetries>) -> Result<Self, OptimizeError> {
        // the motions of a circle are found on the other side
        let is_circle = |side: Side| matches!(symmetries[side].rotations, Rotations::Circle { .. });
        let side = if is_circle(Side::Source) { Side::Target } else { Side::Source };
        let (here, there) = (&symmetries[side], &symmetries[side.other()]);
        let mirrors = if is_circle(side.other()) {
            vec![Motion::AnyMirror { center: there.center }]
        } else {
            there.axes.iter().copied().map(Motion::Mirror).collect()
        };
        let axes = here.axes.iter().take(MOST_AXES).filter(|_| !mirrors.is_empty());
        let mut pairs: Vec<_> = axes.map(|axis| (Motion::Mirror(*axis), mirrors.clone())).collect();
        let angle = common_order(here.rotations, there.rotations).map(|order| TAU / f64::from(order));
        let turn = |of: &Symmetries, angle: f64| Motion::Turn { center: of.center, angle };
        pairs.extend(angle.map(|angle| (turn(here, angle), vec![turn(there, angle)])));
        if pairs.is_empty() { Err(OptimizeError::NoSharedSymmetry) } else { Ok(Self { side, pairs, size: there.size }) }
    }

    /// The outline whose motions are compared; its mesh is to be mapped.
    pub(super) fn side(&self) -> Side {
        self.side
    }

    /// The motions of that outline.
    pub(super) fn motions(&self) -> impl Iterator<Item = &Motion> {
        self.pairs.iter().map(|(motion, _)| motion)
    }

    /// The criterion; `images` gives those for the motion of this number. `None` without images.
    pub(super) fn mismatch(&self, mut images: impl FnMut(usize) -> Vec<Images>) -> Option<f64> {
        let of_pair = |(k, (_, options)): (usize, &(Motion, Vec<Motion>))| {
            let images = images(k);
            let total: f64 = images.iter().map(|at| at.weight).sum();
            let least = options.iter().map(|option| option.off(&images)).reduce(f64::min)?;
            Some((least / total).sqrt() / self.size).filter(|off| off.is_finite())
        };
        let offs = self.pairs.iter().enumerate().map(of_pair).collect::<Option<Vec<_>>>()?;
        Some(offs.iter().sum::<f64>() / offs.len() as f64)
    }
}

/// The largest order of a rotation that both have, from 2.
fn common_order(a: Rotations, b: Rotations) -> Option<u32> {
    let order = |rotations: Rotations| match rotations {
        Rotations::Identity => Some(1),
        Rotations::Order { order, .. } => Some(order),
        Rotations::Circle { .. } => None,
    };
    let common = match (order(a), order(b)) {
        (Some(a), Some(b)) => greatest_divisor(a, b),
        (Some(order), None) | (None, Some(order)) => order,
        (None, None) => OF_CIRCLES,
    };
    (common > 1).then_some(common)
}

fn greatest_divisor(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { greatest_divisor(b, a % b) }
}
