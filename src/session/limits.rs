//! What the numbers of a session may be: what its controls allow.
//!
//! A session that comes from outside, by a link or a file, is checked against these before it is
//! used: beyond them a preparation would take all the memory or for ever.

use super::{DomainSpec, Session, SurfaceShape, SurfaceState};
use crate::geometry::MAX_COORDINATE;
use crate::mesh::{BarycentricPoint, Sizing};
use crate::outline::Sampling;
use std::ops::RangeInclusive;

/// Boundary samples that can be asked for: fewer than 30 make a polygon of any
/// outline; 3200 are the most in the paper, and with uniform triangles in a
/// round outline they already mean 800,000 vertices.
pub const SAMPLES: RangeInclusive<u32> = 30..=3200;
/// Growth of the triangles per distance from the boundary.
pub const GROWTH: RangeInclusive<f64> = 0.05..=0.5;
/// Cells of the texture across its domain.
pub const CELLS: RangeInclusive<f64> = 2.0..=64.0;
/// Boundary vertices of a built-in surface; 4000 mean three million triangles.
pub const SURFACE_BOUNDARY: RangeInclusive<u32> = 12..=4000;

/// How far the weights of a point may be from the sum 1: many roundings, and no more than can be seen.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// A number that a session may not have.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what} is {value}; it must be from {low} to {high}")]
pub struct OutOfRange {
    /// Which number.
    pub what: &'static str,
    /// What it is.
    pub value: f64,
    /// The least that it may be.
    pub low: f64,
    /// The largest that it may be.
    pub high: f64,
}

impl Session {
    /// Whether all numbers are finite and in the ranges of their controls. Outlines are not looked at.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("the session's version", f64::from(self.version), &(1.0..=1.0))?;
        for domain in [&self.source, &self.target] {
            check_domain(domain)?;
        }
        for point in self.interior.iter().flatten() {
            for value in point.to_array() {
                within("a coordinate of an interior point", value, &(-MAX_COORDINATE..=MAX_COORDINATE))?;
            }
        }
        for anchor in self.anchor {
            within("the place of a boundary point", anchor, &(0.0..=1.0))?;
        }
        within("the number of cells of the texture", self.texture_scale, &CELLS)?;
        self.surface.as_ref().map_or(Ok(()), check_surface)
    }
}

fn check_domain(domain: &DomainSpec) -> Result<(), OutOfRange> {
    let samples = match domain.settings.sampling {
        Sampling::Uniform { count, .. } => Some(count),
        Sampling::Adaptive { target } => target,
    };
    if let Some(count) = samples {
        within_integers("the number of boundary samples", count, &SAMPLES)?;
    }
    match domain.settings.sizing {
        Sizing::Graded(growth) => within("the growth of the triangles", growth, &GROWTH),
        Sizing::Uniform => Ok(()),
    }
}

fn check_surface(state: &SurfaceState) -> Result<(), OutOfRange> {
    if let SurfaceShape::Preset { boundary, .. } = state.spec.shape {
        within_integers("the number of boundary vertices of the surface", boundary, &SURFACE_BOUNDARY)?;
    }
    if let Some(BarycentricPoint { weights, .. }) = state.point {
        for weight in weights {
            within("a weight of the surface's interior point", weight, &(0.0..=1.0))?;
        }
        let sum = 1.0 - WEIGHT_TOLERANCE..=1.0 + WEIGHT_TOLERANCE;
        within("the sum of the weights of the surface's interior point", weights.iter().sum(), &sum)?;
    }
    within("the place of the surface's boundary point", state.anchor, &(0.0..=1.0))
}

/// Not-a-number is in no range.
fn within(what: &'static str, value: f64, range: &RangeInclusive<f64>) -> Result<(), OutOfRange> {
    let (low, high) = (*range.start(), *range.end());
    if range.contains(&value) { Ok(()) } else { Err(OutOfRange { what, value, low, high }) }
}

fn within_integers(what: &'static str, value: u32, range: &RangeInclusive<u32>) -> Result<(), OutOfRange> {
    within(what, f64::from(value), &(f64::from(*range.start())..=f64::from(*range.end())))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec2;
    use crate::session::{Command, SurfaceSpec};

    fn refused(change: impl FnOnce(&mut Session), word: &str) {
        let mut session = Session::default();
        session.apply(Command::SetSurface(SurfaceSpec::default()));
        assert_eq!(session.check(), Ok(()));
        change(&mut session);
        let message = session.check().unwrap_err().to_string();
        assert!(message.contains(word), "{message:?} says nothing of {word:?}");
    }

    #[test]
    fn every_number_has_its_range() {
        refused(|s| s.version = 2, "version");
        refused(|s| s.source.settings.sampling = Sampling::Adaptive { target: Some(3201) }, "3201");
        refused(|s| s.target.settings.sampling = Sampling::Uniform { count: 29, keep_corners: true }, "29");
        refused(|s| s.target.settings.sizing = Sizing::Graded(0.04), "growth");
        refused(|s| s.source.settings.sizing = Sizing::Graded(f64::NAN), "NaN");
        refused(|s| s.interior[1] = Some(DVec2::new(0.0, f64::INFINITY)), "inf");
        refused(|s| s.anchor[0] = -0.1, "boundary point");
        refused(|s| s.texture_scale = 1e9, "cells");
        let surface = |s: &mut Session, change: fn(&mut SurfaceState)| s.surface.as_mut().map(change);
        refused(|s| _ = surface(s, |state| state.anchor = f64::NAN), "surface's boundary point");
        let point = |weights| Some(BarycentricPoint { triangle: 0, weights });
        refused(|s| s.surface.as_mut().unwrap().point = point([0.5, 0.5, 0.5]), "sum");
        refused(|s| s.surface.as_mut().unwrap().point = point([1.5, -0.5, 0.0]), "weight");
        let spec = |s: &mut Session| s.surface.as_mut().unwrap().spec.clone();
        refused(
            |s| {
                let shape = match spec(s).shape {
                    SurfaceShape::Preset { preset, .. } => SurfaceShape::Preset { preset, boundary: 4001 },
                    file @ SurfaceShape::File { .. } => file,
                };
                s.surface.as_mut().unwrap().spec.shape = shape;
            },
            "4001",
        );
    }
}
