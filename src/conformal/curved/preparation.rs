//! Sampling and meshing of an outline whose measure is to come from the boundary integral.

use super::super::PrepareSettings;
use super::super::domain::{MeshedDomain, pole};
use super::super::prepare::timed;
use super::super::{PrepareError, PrepareTimings, Stage};
use super::{CurveBoundary, Unsharpened};
use crate::boundary_integral::{BoundaryIntegral, Settings};
use crate::geometry::{Curve, DVec2, SimplePolygon};
use crate::mesh::MeshError;
use crate::outline::{BoundarySamples, sample};

/// An outline with its curve, if that is not the polygon itself.
#[derive(Debug, Clone, Copy)]
pub struct Outlined<'a> {
    pub polygon: &'a SimplePolygon,
    pub curve: Option<&'a Curve>,
}

/// A meshed domain, and its samples on the curve, or why they are not there.
pub type OnCurve = (MeshedDomain, Result<CurveBoundary, Unsharpened>);

impl Outlined<'_> {
    /// Samples and meshes. The samples lie on the curve, or, where its integral equation is not available, on the
    /// polygon.
    pub fn domain(
        &self,
        settings: &PrepareSettings,
        timings: &mut PrepareTimings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<OnCurve, PrepareError> {
        progress(Stage::Sample);
        let samples = timed(&mut timings.sample, || sample(self.polygon, settings.sampling))?;
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

    /// The samples on the curve, if its equation fits.
    fn placed(&self, samples: &BoundarySamples) -> Result<(CurveBoundary, BoundarySamples), Unsharpened> {
        let of_polygon = || Curve::from_polygon(self.polygon);
        let curve = self.curve.map_or_else(of_polygon, |curve| Ok(curve.clone()))?;
        // whether samples lie on the curve must not depend on where the interior point is
        BoundaryIntegral::check(&curve, &equation_settings(&curve, &[pole(self.polygon)]))?;
        let mut boundary = CurveBoundary::new(&curve);
        let moved = boundary.set_samples(self.polygon, samples)?;
        Ok((boundary, moved))
    }

    /// The samples of the polygon on the curve, as [`Self::domain`] places them.
    pub fn boundary(&self, settings: &PrepareSettings) -> Result<CurveBoundary, Unsharpened> {
        let samples = sample(self.polygon, settings.sampling).map_err(|_| Unsharpened::Apart)?;
        self.placed(&samples).map(|(boundary, _)| boundary)
    }

    /// The points to resolve: where there are none, the default interior point.
    pub fn near(&self, points: &[DVec2]) -> Vec<DVec2> {
        if points.is_empty() { vec![pole(self.polygon)] } else { points.to_vec() }
    }
}

/// How the equation is divided, to resolve interior points even next to the boundary.
pub(super) fn equation_settings(curve: &Curve, near: &[DVec2]) -> Settings {
    let inside: Vec<DVec2> = near.iter().copied().filter(|&x| curve.contains(x)).collect();
    Settings::default().with_points(&inside).with_max_unknowns(super::MAX_UNKNOWNS)
}
