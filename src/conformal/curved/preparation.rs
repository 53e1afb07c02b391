//! Sampling and meshing of an outline whose measure is to come from the boundary integral.

use super::super::domain::{MeshedDomain, pole};
use super::super::prepare::timed;
use super::super::{PrepareError, PrepareSettings, PrepareTimings, Stage};
use super::{CurveBoundary, Unsharpened};
use crate::geometry::{Curve, DVec2, SimplePolygon};
use crate::mesh::MeshError;
use crate::outline::{BoundarySamples, sample};

/// An outline with its curve, if that is not the polygon itself, and points to resolve: where there are none, the default
/// interior point.
#[derive(Debug, Clone, Copy)]
pub struct Outlined<'a> {
    pub polygon: &'a SimplePolygon,
    pub curve: Option<&'a Curve>,
    pub near: &'a [DVec2],
}

/// A meshed domain, and its boundary's integral equation or why there is none.
pub type Sharpened = (MeshedDomain, Result<CurveBoundary, Unsharpened>);

impl Outlined<'_> {
    /// Samples, factors the integral equation, and meshes. The samples lie on the curve, or, where the equation is not
    /// available, on the polygon.
    pub fn domain(
        &self,
        settings: &PrepareSettings,
        timings: &mut PrepareTimings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Sharpened, PrepareError> {
        progress(Stage::Sample);
        let samples = timed(&mut timings.sample, || sample(self.polygon, settings.sampling))?;
        progress(Stage::Factor);
        let placed = timed(&mut timings.integral, || self.placed(&samples));
        progress(Stage::Mesh);
        let mut mesh = |samples| MeshedDomain::of_samples(self.polygon, samples, settings.sizing, timings);
        let reason = match placed {
            Ok((boundary, moved)) => match mesh(moved) {
                Ok(domain) => return Ok((domain, Ok(boundary))),
                Err(error) => error.into(),
            },
            Err(reason) => reason,
        };
        let domain: Result<_, MeshError> = mesh(samples);
        Ok((domain?, Err(reason)))
    }

    /// The equation of the curve, and the samples on it.
    fn placed(&self, samples: &BoundarySamples) -> Result<(CurveBoundary, BoundarySamples), Unsharpened> {
        let default_point = [pole(self.polygon)];
        let near = if self.near.is_empty() { &default_point } else { self.near };
        let mut boundary = match self.curve {
            Some(curve) => CurveBoundary::prepare(curve, near)?,
            None => CurveBoundary::prepare(&Curve::from_polygon(self.polygon)?, near)?,
        };
        let moved = boundary.set_samples(self.polygon, samples)?;
        Ok((boundary, moved))
    }
}
