//! Rungs of the methods that sample the boundary: finite elements, and Zipper.

use super::measured::{Measured, exact_image, timed};
use super::truth::Truth;
use super::{Errors, FigureError, ImageOf, LadderMethod, LadderShape, Rung};
use crate::conformal::{
    ConformalMap, Constraints, Direction, HarmonicMeasure, PrepareSettings, PreparedSide, poisson_kernel, prepare,
};
use crate::figures::planar;
use crate::geometry::{CurvePoint, DVec2};
use crate::mesh::{Sizing, locate};
use crate::outline::{BoundaryPoint, BoundarySamples, Sampling, sample};
use crate::zipper::{DiskComparison, DiskMeasure};
use std::f64::consts::TAU;
use std::sync::Arc;

const START: BoundaryPoint = BoundaryPoint::new(0, 0.0);

fn uniform(shape: LadderShape, count: u32) -> Sampling {
    Sampling::Uniform { count, keep_corners: shape.is_polygon() }
}

fn settings(shape: LadderShape, rung: Rung) -> PrepareSettings {
    match rung.method {
        LadderMethod::AdjointUniform => PrepareSettings::new(uniform(shape, rung.resolution), Sizing::Uniform),
        _ => PrepareSettings::new(Sampling::Adaptive { target: Some(rung.resolution) }, Sizing::default()),
    }
}

/// The map whose images are compared: the side that is mapped, and the other one.
fn sides(shape: LadderShape) -> Option<[LadderShape; 2]> {
    match shape.image_of() {
        ImageOf::OntoDisk => Some([shape, LadderShape::Disk]),
        ImageOf::OntoBlob => Some([shape, LadderShape::Blob]),
        ImageOf::DiskOnto => Some([LadderShape::Disk, shape]),
        ImageOf::Unknown => None,
    }
}

/// The interior point of a side of a map of `shape`: the disk's is its center where it stands for the unit disk.
fn point(side: LadderShape, shape: LadderShape, is_mapped: bool) -> DVec2 {
    match shape.image_of() {
        ImageOf::OntoDisk if !is_mapped => DVec2::ZERO,
        ImageOf::DiskOnto if is_mapped => DVec2::ZERO,
        _ => side.point(),
    }
}

/// The exact measures at boundary points of the side that is mapped.
fn exact_measure(truth: &Truth, shape: LadderShape, place: DVec2, at: CurvePoint) -> Option<f64> {
    match shape.image_of() {
        ImageOf::DiskOnto => Some(place.to_angle().rem_euclid(TAU) / TAU),
        _ => truth.omega(at),
    }
}

/// Measures a rung by finite elements.
pub fn finite_elements(truth: &Truth, rung: Rung, runs: usize) -> Result<Measured, FigureError> {
    let (shape, x) = (rung.shape, rung.shape.point());
    let polygon = shape.polygon()?;
    let (side, prepare_ms) = timed(runs, || Ok(prepare(&polygon, &settings(shape, rung), &mut |_| ())?))?;
    let domain = planar(&side)?;
    let samples = domain.samples();
    let (measure, point_ms) = timed(runs, || {
        let located = locate(domain.mesh(), x, None).ok_or(FigureError::Outline)?;
        Ok(HarmonicMeasure::new(samples, &poisson_kernel(&side, located)?, START))
    })?;
    let error = |k: usize| Some(measure.at_vertex(k) - truth.omega(on_curve(truth, samples, k))?);
    let omega = Errors::of((0..side.boundary_count()).filter_map(error));
    let image = element_images(truth, rung)?;
    Ok(Measured { m: side.boundary_count(), unknowns: side.interior_count(), omega, image, prepare_ms, point_ms })
}

fn on_curve(truth: &Truth, samples: &BoundarySamples, k: usize) -> CurvePoint {
    truth.foot(samples.points()[k], samples.fractions()[k])
}

fn element_images(truth: &Truth, rung: Rung) -> Result<Option<Errors>, FigureError> {
    let shape = rung.shape;
    let Some(both) = sides(shape) else { return Ok(None) };
    let prepared = |side: LadderShape| -> Result<Arc<PreparedSide>, FigureError> {
        Ok(Arc::new(prepare(&side.polygon()?, &settings(side, rung), &mut |_| ())?))
    };
    let [source, target] = [prepared(both[0])?, prepared(both[1])?];
    let points = [point(both[0], shape, true), point(both[1], shape, false)];
    let constraints = Constraints::new((points[0], 0.0), (points[1], 0.0));
    let map = ConformalMap::new(source.clone(), target, &constraints, Direction::Forward.into())?;
    let domain = planar(&source)?;
    let samples = domain.samples();
    let error = |k: usize| {
        let exact = exact_measure(truth, shape, samples.points()[k], on_curve(truth, samples, k))?;
        Some(map.images()[k].distance(exact_image(truth, shape.image_of(), exact)?))
    };
    Ok(Some(Errors::of((0..source.boundary_count()).filter_map(error))))
}

/// The points of a curve that Zipper joins, at equal distances; of a polygon with its corners.
struct Knots {
    places: Vec<DVec2>,
    on_curve: Vec<CurvePoint>,
}

impl Knots {
    fn new(truth: &Truth, shape: LadderShape, count: u32) -> Result<Self, FigureError> {
        let curve = truth.curve();
        let fractions = if shape.is_polygon() {
            sample(&shape.polygon()?, uniform(shape, count))
                .map_err(crate::conformal::PrepareError::from)?
                .fractions()
                .to_vec()
        } else {
            (0..count).map(|k| f64::from(k) / f64::from(count)).collect()
        };
        let on_curve: Vec<CurvePoint> = fractions.iter().map(|&s| truth.at_fraction(s)).collect();
        Ok(Self { places: on_curve.iter().map(|&at| curve.position(at)).collect(), on_curve })
    }
}

/// Measures a rung by Zipper.
pub fn zipper(truth: &Truth, rung: Rung, runs: usize) -> Result<Measured, FigureError> {
    let shape = rung.shape;
    let knots = Knots::new(truth, shape, rung.resolution)?;
    let (measure, point_ms) = timed(runs, || Ok(DiskMeasure::fresh(&knots.places, shape.point(), START)?))?;
    let m = knots.places.len();
    let error = |k: usize| Some(measure.at_vertex(k) - truth.omega(knots.on_curve[k])?);
    let omega = Errors::of((0..m).filter_map(error));
    let image = zipper_images(truth, rung, &measure, &knots)?;
    Ok(Measured { m, unknowns: m, omega, image, prepare_ms: 0.0, point_ms })
}

fn zipper_images(
    truth: &Truth,
    rung: Rung,
    measure: &DiskMeasure,
    knots: &Knots,
) -> Result<Option<Errors>, FigureError> {
    let shape = rung.shape;
    let Some(both) = sides(shape) else { return Ok(None) };
    let image_of = shape.image_of();
    let is_source = image_of != ImageOf::DiskOnto;
    let partner = both[usize::from(is_source)];
    let other = Knots::new(&Truth::new(partner)?, partner, rung.resolution)?;
    let other_measure = DiskMeasure::fresh(&other.places, point(partner, shape, !is_source), START)?;
    let [from, onto] = if is_source { [knots, &other] } else { [&other, knots] };
    let [mapped, target] = if is_source { [measure.clone(), other_measure] } else { [other_measure, measure.clone()] };
    let matched = DiskComparison::new(mapped, target);
    let error = |k: usize| {
        let image = position(&onto.places, matched.points()[k]);
        let exact = exact_measure(truth, shape, from.places[k], from.on_curve[k])?;
        Some(image.distance(exact_image(truth, image_of, exact)?))
    };
    Ok(Some(Errors::of((0..from.places.len()).filter_map(error))))
}

/// A point of a closed polygon.
fn position(places: &[DVec2], at: BoundaryPoint) -> DVec2 {
    let edge = at.edge() as usize;
    places[edge].lerp(places[(edge + 1) % places.len()], at.fraction())
}
