//! Figure 6: Poisson kernel and harmonic measure of the disk, compared with their closed forms.

use super::{FigureError, Scene, Table, planar, prepare_spec};
use crate::conformal::{HarmonicMeasure, MapError, MeshedDomain, Side, poisson_kernel};
use crate::exact::{complex, disk};
use crate::geometry::DVec2;
use crate::mesh::locate;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Kernel and measure at a point of the disk, sampled uniformly from the anchor y = (1, 0).
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct DiskKernelStudy {
    /// The disk.
    pub domain: Arc<MeshedDomain>,
    /// x.
    pub point: DVec2,
    /// ψ_k, k = 0 … m−1.
    pub kernel: Vec<f64>,
    /// ω̃, measured from y.
    pub measure: HarmonicMeasure,
}

impl DiskKernelStudy {
    /// The study of a scene's source.
    pub fn new(scene: &Scene) -> Result<Self, FigureError> {
        let side = prepare_spec(scene.session.domain(Side::Source))?;
        let domain = planar(&side)?;
        let point = scene.session.side(Side::Source).interior.unwrap_or(domain.default_point());
        let outside = MapError::PointOutside { side: Side::Source, x: point.x, y: point.y };
        let located = locate(domain.mesh(), point, None).ok_or(outside)?;
        let kernel = poisson_kernel(&side, located)?;
        let anchor = side.at_fraction(scene.session.side(Side::Source).anchor());
        let measure = HarmonicMeasure::new(domain.samples(), &kernel, anchor);
        Ok(Self { domain, point, kernel, measure })
    }

    /// The angle of vertex `k`: its arc length on the inscribed polygon, scaled to the circle.
    pub fn angle(&self, k: usize) -> f64 {
        TAU * k as f64 / self.kernel.len() as f64
    }

    /// P_x(t).
    pub fn exact_kernel(&self, t: f64) -> f64 {
        disk::poisson_kernel(complex(self.point), t)
    }

    /// ω_x(t).
    pub fn exact_measure(&self, t: f64) -> f64 {
        disk::harmonic_measure(complex(self.point), t)
    }

    /// A table with a row for each boundary vertex of each study.
    pub fn table(studies: &[Self]) -> Table {
        let mut table =
            Table::new(&["m", "n", "k", "t", "kernel", "kernel_exact", "measure", "measure_exact", "measure_error"]);
        for study in studies {
            let m = study.kernel.len();
            for (k, &kernel) in study.kernel.iter().enumerate() {
                let t = study.angle(k);
                let (measure, exact) = (study.measure.at_vertex(k), study.exact_measure(t));
                table.rows.push(vec![
                    m.into(),
                    study.domain.mesh().interior_count().into(),
                    k.into(),
                    t.into(),
                    kernel.into(),
                    study.exact_kernel(t).into(),
                    measure.into(),
                    exact.into(),
                    (measure - exact).abs().into(),
                ]);
            }
        }
        table
    }
}
