//! Rungs of the boundary integral.
//!
//! Nothing is sampled: ω is compared along the curve, also next to its junctions, and the images of points with equally
//! spaced measures, which are continuous too.

use super::measured::{Measured, exact_image, timed};
use super::truth::{Truth, start};
use super::{Errors, FigureError, ImageOf, LadderShape, Reference, Rung};
use crate::boundary_integral::{AnchoredMeasure, BoundaryIntegral, Settings};
use crate::geometry::{Curve, CurvePoint, DVec2};

/// Images are compared at this number of points of the boundary that is mapped.
const IMAGES: u32 = 1000;
/// Points of all pieces together at which ω is compared, besides those next to junctions.
const PLACES: usize = 1200;
/// Next to both ends of a piece ω is compared at the parameters 2⁻¹ … 2⁻ᵏ.
const HALVINGS: i32 = 40;

/// The step of the default settings, and that of the finer ones.
const DEFAULT_STEP: u32 = 3;

fn settings(step: u32, x: DVec2) -> Settings {
    let settings = Settings::default().with_points(&[x]);
    if step > DEFAULT_STEP {
        return settings.finer();
    }
    settings.coarser(f64::from(1_u32 << (DEFAULT_STEP - step)))
}

/// Measures a rung.
pub fn measure(truth: &Truth, rung: Rung, runs: usize) -> Result<Measured, FigureError> {
    let x = rung.shape.point();
    let settings = settings(rung.resolution, x);
    let (integral, prepare_ms) = timed(runs, || Ok(BoundaryIntegral::prepare(truth.curve(), &settings)?))?;
    let (measure, point_ms) = timed(runs, || Ok(integral.harmonic_measure(x)?))?;
    let anchored = measure.from_anchor(start());
    let error = |at: CurvePoint| {
        // both ways, as matching uses it: the nearer one to the anchor
        let exact = truth.omega(at)?;
        let [forward, backward] = [anchored.forward(at), anchored.backward(at)];
        Some(if forward <= 0.5 { forward - exact } else { (1.0 - exact) - backward })
    };
    let omega = Errors::of(places(truth.curve(), rung.shape.reference()).filter_map(error));
    let image = images(truth, rung, &anchored)?;
    let unknowns = integral.unknowns();
    Ok(Measured { m: unknowns, unknowns, omega, image, prepare_ms, point_ms })
}

/// Where ω is compared.
fn places(curve: &Curve, reference: Reference) -> Box<dyn Iterator<Item = CurvePoint>> {
    let pieces = curve.pieces().len();
    if reference == Reference::Corners {
        return Box::new((0..pieces).map(|piece| CurvePoint::new(piece, 0.0)));
    }
    let parts = PLACES / pieces;
    let of_piece = move |piece: usize| {
        let even = (0..parts).map(move |k| CurvePoint::new(piece, k as f64 / parts as f64));
        let graded = (1..=HALVINGS).flat_map(move |k| {
            let t = 0.5_f64.powi(k);
            [CurvePoint::new(piece, t), CurvePoint::before_end(piece, t)]
        });
        even.chain(graded)
    };
    Box::new((0..pieces).flat_map(of_piece))
}

/// The errors of the images of equally spaced measures, or of equally spaced points of the V.
fn images(truth: &Truth, rung: Rung, anchored: &AnchoredMeasure<'_>) -> Result<Option<Errors>, FigureError> {
    let image_of = rung.shape.image_of();
    let partner = match image_of {
        ImageOf::Unknown => return Ok(None),
        ImageOf::OntoBlob => LadderShape::Blob,
        ImageOf::OntoDisk | ImageOf::DiskOnto => LadderShape::Disk,
    };
    let center = if partner == LadderShape::Disk { DVec2::ZERO } else { partner.point() };
    let integral = BoundaryIntegral::prepare(&partner.curve()?, &settings(rung.resolution, center))?;
    let measure = integral.harmonic_measure(center)?;
    let other = measure.from_anchor(start());
    let [mapped, onto] = if image_of == ImageOf::DiskOnto { [&other, anchored] } else { [anchored, &other] };
    let target = if image_of == ImageOf::DiskOnto { truth.curve() } else { integral.curve() };
    let error = |k: u32| {
        let share = f64::from(k) / f64::from(IMAGES);
        let (at, exact) = if image_of == ImageOf::DiskOnto {
            (CurvePoint::new(0, share), Some(share))
        } else {
            let at = truth.at_fraction(share);
            (at, truth.omega(at))
        };
        let [forward, backward] = [mapped.forward(at), mapped.backward(at)];
        let image = if forward <= 0.5 { onto.point_at(forward) } else { onto.point_before(backward) };
        Some(target.position(image).distance(exact_image(truth, image_of, exact?)?))
    };
    Ok(Some(Errors::of((0..IMAGES).filter_map(error))))
}
