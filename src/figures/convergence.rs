//! Figure 15: the error of the V-shape's boundary map for increasing m.
//!
//! E_max and E_mean of section 5.2, for riemap and for the geodesic algorithm, each with two
//! second maps: the exact one, so that only the V's measure has an error, and the blob sampled
//! at m₂ points, whose polygon and measure add an error that does not decrease with m.

use super::crowding::{V_PERIOD, exact_measures, on_exact_v};
use super::scenes::{crowding_constraints, crowding_points, uniform};
use super::{ArcLength, Detail, FigureError, Method, Table, planar};
use crate::conformal::{ConformalMap, Direction, MeshedDomain, PreparedSide, Side, prepare};
use crate::exact::{blob, vshape};
use crate::geometry::DVec2;
use crate::outline::{BoundaryPoint, Preset};
use crate::zipper::{DiskComparison, DiskMeasure};
use std::sync::Arc;

/// The map from the disk to the blob with which the V's harmonic measure is composed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SecondMap {
    /// The blob's exact map.
    Exact,
    /// The blob, sampled and mapped by the same method.
    Sampled,
}

impl SecondMap {
    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Sampled => "sampled",
        }
    }
}

/// The errors of one method at one resolution.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct ConvergenceRow {
    /// Boundary samples of the V.
    pub m: u32,
    /// [`Method::HarmonicMeasure`] or [`Method::FreshZipper`].
    pub method: Method,
    /// The map from the disk to the blob.
    pub second: SecondMap,
    /// E_max.
    pub max: f64,
    /// E_mean.
    pub mean: f64,
}

/// The data shared by all resolutions.
#[derive(Debug)]
#[non_exhaustive]
pub struct ConvergenceStudy {
    /// The numbers of samples, increasing.
    pub resolutions: Vec<u32>,
    blob: Arc<PreparedSide>,
    blob_domain: Arc<MeshedDomain>,
    blob_measure: DiskMeasure,
    v_arc: ArcLength,
}

const START: BoundaryPoint = BoundaryPoint::new(0, 0.0);

impl ConvergenceStudy {
    /// The study with m = 250 … 4000 and m₂ = 1000, or a quarter of these numbers.
    pub fn new(detail: Detail) -> Result<Self, FigureError> {
        let polygon = Preset::Blob.outline().into_polygon();
        let blob = Arc::new(prepare(&polygon, &uniform(detail.samples(1000)), &mut |_| ())?);
        let blob_domain = planar(&blob)?;
        let blob_measure = DiskMeasure::fresh(blob_domain.samples().points(), crowding_points().target, START)?;
        Ok(Self {
            resolutions: [250, 500, 1000, 2000, 4000].map(|m| detail.samples(m)).to_vec(),
            blob,
            blob_domain,
            blob_measure,
            v_arc: ArcLength::new(vshape::boundary, V_PERIOD),
        })
    }

    /// m₂.
    pub fn target_samples(&self) -> u32 {
        self.blob.boundary_count() as u32
    }

    /// The four rows of one resolution.
    pub fn rows(&self, m: u32) -> Result<[ConvergenceRow; 4], FigureError> {
        let [a, b] = self.by_harmonic_measure(m)?;
        let [c, d] = self.by_zipper(m)?;
        Ok([a, b, c, d])
    }

    fn by_harmonic_measure(&self, m: u32) -> Result<[ConvergenceRow; 2], FigureError> {
        let source = Arc::new(prepare(Preset::VShape.outline().polygon(), &uniform(m), &mut |_| ())?);
        let constraints = crowding_constraints();
        let domain = planar(&source)?;
        let map = ConformalMap::new(source, self.blob.clone(), &constraints, Direction::Forward.into())?;
        let (points, measure) = (on_exact_v(domain.samples()), map.measure(Side::Source));
        let measures: Vec<f64> = (0..points.len()).map(|k| measure.at_vertex(k)).collect();
        Ok(self.compare(Method::HarmonicMeasure, &points, &measures, map.correspondence().points()))
    }

    fn by_zipper(&self, m: u32) -> Result<[ConvergenceRow; 2], FigureError> {
        let points: Vec<DVec2> = self.v_arc.uniform_parameters(m).into_iter().map(vshape::boundary).collect();
        let measure = DiskMeasure::fresh(&points, crowding_points().source, START)?;
        let measures: Vec<f64> = (0..points.len()).map(|k| measure.at_vertex(k)).collect();
        let matched = DiskComparison::new(measure, self.blob_measure.clone());
        Ok(self.compare(Method::FreshZipper, &points, &measures, matched.points()))
    }

    /// The errors at `points` of the exact V with the two second maps: the exact one after `measures`, and `matched`.
    fn compare(
        &self,
        method: Method,
        points: &[DVec2],
        measures: &[f64],
        matched: &[BoundaryPoint],
    ) -> [ConvergenceRow; 2] {
        let truth = exact_measures(points, crowding_points().source);
        let row = |second: SecondMap, image: &dyn Fn(usize) -> DVec2| {
            let errors = truth.iter().enumerate().map(|(k, &omega)| image(k).distance(blob::boundary(omega)));
            let (max, sum) = errors.fold((0.0, 0.0), |(max, sum): (f64, f64), e| (max.max(e), sum + e));
            ConvergenceRow { m: points.len() as u32, method, second, max, mean: sum / points.len() as f64 }
        };
        [
            row(SecondMap::Exact, &|k| blob::boundary(measures[k])),
            row(SecondMap::Sampled, &|k| self.blob_domain.samples().position(matched[k])),
        ]
    }

    /// A table with a line for each of `rows`.
    pub fn table(rows: &[ConvergenceRow]) -> Table {
        let mut table = Table::new(&["m", "method", "second_map", "max_error", "mean_error"]);
        for row in rows {
            let words = [row.method.name(), row.second.name()];
            table.rows.push(vec![row.m.into(), words[0].into(), words[1].into(), row.max.into(), row.mean.into()]);
        }
        table
    }
}

/// The order p in `error ≈ C m^−p`, by least squares in the logarithms; `None` for fewer than two
/// resolutions, or if an error is 0.
pub fn fitted_order(points: &[(u32, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points.iter().map(|&(m, error)| (f64::from(m).ln(), error.ln())).collect();
    let count = logs.len() as f64;
    let mean = |value: fn(&(f64, f64)) -> f64| logs.iter().map(value).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let spread: f64 = logs.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    let product: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let order = -product / spread;
    order.is_finite().then_some(order)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_law_has_its_exponent_as_order() {
        let points = [250, 500, 1000, 2000].map(|m| (m, 3.0 * f64::from(m).powf(-1.5)));
        assert!(fitted_order(&points).is_some_and(|p| (p - 1.5).abs() < 1e-12), "{:?}", fitted_order(&points));
        assert_eq!(fitted_order(&points[..1]), None);
        assert_eq!(fitted_order(&[(10, 0.0), (20, 0.0)]), None);
    }
}
