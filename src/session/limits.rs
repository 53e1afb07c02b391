//! The ranges of a session's numbers: those of its controls.
//!
//! A session from outside, from a link or a file, is checked against them before use: beyond them a
//! preparation would take all memory or not end.

use super::{DomainSpec, Session, SurfaceShape, SurfaceState};
use crate::geometry::{MAX_COORDINATE, PICTURE_MIDDLE, PICTURE_SIZE, PICTURE_TURN, PicturePlacement};
use crate::mesh::Sizing;
use crate::optimization::MOST_DABS;
use crate::outline::Sampling;
use std::ops::RangeInclusive;

/// Boundary samples: with fewer than 30 any outline becomes a polygon; 3200 is the largest number in the paper,
/// and with uniform triangles in a round outline it already means 800,000 vertices.
pub const SAMPLES: RangeInclusive<u32> = 30..=3200;
/// Growth of the triangle size per distance from the boundary.
pub const GROWTH: RangeInclusive<f64> = 0.05..=0.5;
/// Cells of the texture across its domain.
pub const CELLS: RangeInclusive<f64> = 2.0..=64.0;
/// Boundary vertices of a built-in surface; 4000 mean three million triangles.
pub const SURFACE_BOUNDARY: RangeInclusive<u32> = 12..=4000;

/// Largest deviation of the sum of barycentric weights from 1: room for many roundings, too small to see.
const WEIGHT_TOLERANCE: f64 = 1e-9;

/// The numbers of a session that are checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Quantity {
    /// The version of the format.
    #[error("the session's version")]
    Version,
    /// A coordinate of x₁ or x₂.
    #[error("a coordinate of an interior point")]
    Coordinate,
    /// y₁ or y₂, as a fraction of arc length.
    #[error("the place of a boundary point")]
    Anchor,
    /// A mark of a quadrilateral, as a fraction of arc length.
    #[error("the place of a mark")]
    Mark,
    /// The cells of the texture across its domain.
    #[error("the number of cells of the texture")]
    Cells,
    /// The placement of the image.
    #[error("the placement of the picture")]
    Picture,
    /// The dabs of the painted region.
    #[error("the number of dabs in the painted region")]
    Dabs,
    /// The radius of one.
    #[error("the radius of a dab in the painted region")]
    DabRadius,
    /// m.
    #[error("the number of boundary samples")]
    Samples,
    /// The growth of the triangle size per distance from the boundary.
    #[error("the growth of the triangles")]
    Growth,
    /// m of a built-in surface.
    #[error("the number of boundary vertices of the surface")]
    SurfaceBoundary,
    /// A barycentric weight of a surface's interior point.
    #[error("a weight of the surface's interior point")]
    Weight,
    /// The sum of these weights.
    #[error("the sum of the weights of the surface's interior point")]
    WeightSum,
    /// The boundary point of a surface, as a fraction of the length of its loop.
    #[error("the place of the surface's boundary point")]
    SurfaceAnchor,
}

/// A number outside its range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what} is {value}; it must be from {low} to {high}")]
#[non_exhaustive]
pub struct OutOfRange {
    /// The quantity.
    pub what: Quantity,
    /// Its value.
    pub value: f64,
    /// The smallest allowed value.
    pub low: f64,
    /// The largest allowed value.
    pub high: f64,
}

impl Session {
    /// Checks that all numbers are finite and in the ranges of their controls; returns the first that is not.
    pub fn check(&self) -> Result<(), OutOfRange> {
        // by quantity, so that which of several wrong numbers is reported does not depend on the kinds of sides
        let sides = || self.sides.iter().map(|(_, side)| side);
        sides().try_for_each(|side| check_domain(&side.domain))?;
        for value in sides().filter_map(|side| side.interior).flat_map(|point| point.to_array()) {
            within(Quantity::Coordinate, value, &(-MAX_COORDINATE..=MAX_COORDINATE))?;
        }
        sides().try_for_each(|side| within(Quantity::Anchor, side.anchor, &(0.0..=1.0)))?;
        for mark in self.marks.iter().filter_map(|(_, marks)| *marks).flatten() {
            within(Quantity::Mark, mark, &(0.0..=1.0))?;
        }
        within(Quantity::Cells, self.display.texture_scale, &CELLS)?;
        let PicturePlacement { middle, size, turn } = self.display.picture;
        within(Quantity::Picture, middle.x, &PICTURE_MIDDLE)?;
        within(Quantity::Picture, middle.y, &PICTURE_MIDDLE)?;
        within(Quantity::Picture, size, &PICTURE_SIZE)?;
        within(Quantity::Picture, turn, &PICTURE_TURN)?;
        within(Quantity::Dabs, self.region.len() as f64, &(0.0..=MOST_DABS as f64))?;
        for dab in &self.region {
            within(Quantity::DabRadius, dab.radius, &(f64::MIN_POSITIVE..=MAX_COORDINATE))?;
            for value in dab.middle.to_array() {
                within(Quantity::Coordinate, value, &(-MAX_COORDINATE..=MAX_COORDINATE))?;
            }
        }
        sides().filter_map(|side| side.surface.as_ref()).try_for_each(check_surface)
    }
}

fn check_domain(domain: &DomainSpec) -> Result<(), OutOfRange> {
    let samples = match domain.settings.sampling {
        Sampling::Uniform { count, .. } => Some(count),
        Sampling::Adaptive { target } => target,
    };
    if let Some(count) = samples {
        within_integers(Quantity::Samples, count, &SAMPLES)?;
    }
    match domain.settings.sizing {
        Sizing::Graded(growth) => within(Quantity::Growth, growth, &GROWTH),
        Sizing::Uniform => Ok(()),
    }
}

fn check_surface(state: &SurfaceState) -> Result<(), OutOfRange> {
    if let SurfaceShape::Preset { boundary, .. } = state.spec.shape {
        within_integers(Quantity::SurfaceBoundary, boundary, &SURFACE_BOUNDARY)?;
    }
    if let Some(weights) = state.point.map(|point| point.weights()) {
        for weight in weights {
            within(Quantity::Weight, weight, &(0.0..=1.0))?;
        }
        let sum = 1.0 - WEIGHT_TOLERANCE..=1.0 + WEIGHT_TOLERANCE;
        within(Quantity::WeightSum, weights.iter().sum(), &sum)?;
    }
    within(Quantity::SurfaceAnchor, state.anchor, &(0.0..=1.0))
}

/// NaN is in no range.
pub(super) fn within(what: Quantity, value: f64, range: &RangeInclusive<f64>) -> Result<(), OutOfRange> {
    let (low, high) = (*range.start(), *range.end());
    if range.contains(&value) { Ok(()) } else { Err(OutOfRange { what, value, low, high }) }
}

fn within_integers(what: Quantity, value: u32, range: &RangeInclusive<u32>) -> Result<(), OutOfRange> {
    within(what, f64::from(value), &(f64::from(*range.start())..=f64::from(*range.end())))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{PrepareSettings, Side};
    use crate::geometry::DVec2;
    use crate::mesh::{BarycentricPoint, TriangleId};
    use crate::session::{Command, SurfaceSpec};
    use crate::surface::SurfacePreset;

    fn refused(change: impl Fn(&mut Session, Side), word: &str) {
        for side in Side::BOTH {
            let mut session = Session::default();
            for side in Side::BOTH {
                session.apply(Command::SetSurface { side, surface: SurfaceSpec::default() });
            }
            assert_eq!(session.check(), Ok(()));
            change(&mut session, side);
            let message = session.check().unwrap_err().to_string();
            assert!(message.contains(word), "{side}: {message:?} says nothing of {word:?}");
        }
    }

    fn refused_settings(change: impl Fn(&mut PrepareSettings), word: &str) {
        refused(|session, side| change(&mut session.sides[side].domain.settings), word);
    }

    fn refused_surface(change: impl Fn(&mut SurfaceState), word: &str) {
        refused(|session, side| session.sides[side].surface.iter_mut().for_each(&change), word);
    }

    #[test]
    fn every_number_has_its_range_on_both_sides() {
        refused_settings(|settings| settings.sampling = Sampling::Adaptive { target: Some(3201) }, "3201");
        refused_settings(|settings| settings.sampling = Sampling::Uniform { count: 29, keep_corners: true }, "29");
        refused_settings(|settings| settings.sizing = Sizing::Graded(0.04), "growth");
        refused_settings(|settings| settings.sizing = Sizing::Graded(f64::NAN), "NaN");
        refused(|s, side| s.sides[side].interior = Some(DVec2::new(0.0, f64::INFINITY)), "inf");
        refused(|s, side| s.sides[side].anchor = -0.1, "boundary point");
        refused(|s, _| s.display.texture_scale = 1e9, "cells");
        refused(|s, _| s.display.picture.size = 0.0, "picture");
        refused(|s, _| s.display.picture.turn = f64::NAN, "picture");
        refused(|s, _| s.display.picture.middle.y = 11.0, "picture");
        refused_surface(|state| state.anchor = f64::NAN, "surface's boundary point");
        let point = |weights| Some(BarycentricPoint::new(TriangleId::new(0), weights));
        refused_surface(|state| state.point = point([0.5, 0.5, 0.5]), "sum");
        refused_surface(|state| state.point = point([1.5, -0.5, 0.0]), "weight");
        let preset = SurfacePreset::Hemisphere;
        refused_surface(|state| state.spec.shape = SurfaceShape::Preset { preset, boundary: 4001 }, "4001");
    }
}
