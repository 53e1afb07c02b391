//! Figure 7: a Möbius map of the disk by both extensions, compared with its closed form.
//!
//! The polar grid G about 0 is mapped to G₁ = g₁(G) about x₁ and G₂ = g₂(G) about x₂; the exact
//! map takes G₁ to G₂ (section 3.2). f̃ is piecewise linear on the mesh, equation (14); f̂ is
//! Cauchy's integral over the polygon, equation (15), and can be evaluated at any point.

use super::{Cell, FigureError, Scene, Table, planar, prepare_spec};
use crate::conformal::{BoundaryValues, ConformalMap, Contour, Direction, MeshedDomain, PerSide, Side};
use crate::exact::{Complex, complex, disk, point};
use crate::geometry::DVec2;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Circles of the grid, with radii j/10; j = 0 is the center.
pub const GRID_CIRCLES: u32 = 10;
/// Rays of the grid.
pub const GRID_RAYS: u32 = 24;

/// The map in one row of the figure.
#[derive(Debug)]
#[non_exhaustive]
pub struct MoebiusStudy {
    /// riemap's map, forward and harmonic.
    pub map: ConformalMap,
    domains: PerSide<Arc<MeshedDomain>>,
    contour: Contour,
    images: BoundaryValues,
}

/// g₁(z) = (3 + i + (3 − 4i) z) / (5 + (1 − 3i) z): 0 → x₁, 1 → 1.
fn source_grid(z: Complex) -> Complex {
    (Complex::new(3.0, 1.0) + Complex::new(3.0, -4.0) * z) / (Complex::new(5.0, 0.0) + Complex::new(1.0, -3.0) * z)
}

/// The point of G₁ on circle `j` (radius j/10) and ray `k` of 24; both can be fractional.
pub fn grid_point(j: f64, k: f64) -> DVec2 {
    point(source_grid((j / f64::from(GRID_CIRCLES)) * Complex::cis(TAU * k / f64::from(GRID_RAYS))))
}

impl MoebiusStudy {
    /// The study of a scene from the disk to itself with the constraints of the figure's caption.
    pub fn new(scene: &Scene) -> Result<Self, FigureError> {
        let [source, target] = Side::BOTH.map(|side| prepare_spec(scene.session.domain(side)));
        let domains = [source?, target?];
        let [source, target] = domains;
        let domains = PerSide::new(planar(&source)?, planar(&target)?);
        let constraints = scene.session.constraints(domains.as_ref().map(|domain| domain.default_point()));
        let contour = Contour::new(domains.source.samples().points());
        let map = ConformalMap::new(source, target, &constraints, Direction::Forward.into())?;
        let images = BoundaryValues::new(map.correspondence().images(domains.target.samples()));
        Ok(Self { map, domains, contour, images })
    }

    /// The boundary samples v_k.
    pub fn samples(&self) -> &[DVec2] {
        self.domains.source.samples().points()
    }

    /// Their images w_k.
    pub fn boundary_images(&self) -> impl Iterator<Item = DVec2> {
        self.map.correspondence().images(self.domains.target.samples())
    }

    /// f(x).
    pub fn exact(x: DVec2) -> DVec2 {
        point(disk::figure_7(complex(x)))
    }

    /// f̃(x); `None` outside the polygon.
    pub fn harmonic(&self, x: DVec2) -> Option<DVec2> {
        self.map.image_of(x)
    }

    /// f̂(x); on the boundary its limit from inside.
    pub fn cauchy_green(&self, x: DVec2) -> DVec2 {
        self.contour.evaluate(x, &self.images)
    }

    /// t_k, scaled to the circle.
    pub fn parameter(&self, k: usize) -> f64 {
        TAU * k as f64 / self.samples().len() as f64
    }

    /// r̃(t_k).
    pub fn reparameterisation(&self, k: usize) -> f64 {
        TAU * self.map.side(Side::Target).fraction_at(self.map.correspondence().points()[k])
    }

    /// r(t), t in `[0, 2π]`.
    pub fn exact_reparameterization(t: f64) -> f64 {
        if t >= TAU {
            return TAU;
        }
        let angle = disk::figure_7(Complex::cis(t)).arg().rem_euclid(TAU);
        // a rounding error below the anchor counts as the anchor
        if TAU - angle < 1e-12 { 0.0 } else { angle }
    }

    /// The nodes of G₁ with their circle and ray; the center occurs once.
    pub fn nodes() -> impl Iterator<Item = (u32, u32, DVec2)> {
        let rays = |j: u32| (0..if j == 0 { 1 } else { GRID_RAYS }).map(move |k| (j, k));
        (0..GRID_CIRCLES).flat_map(rays).map(|(j, k)| (j, k, grid_point(f64::from(j), f64::from(k))))
    }

    /// The mean distances of f̃(G₁) and f̂(G₁) from G₂, over the nodes.
    pub fn mean_grid_errors(&self) -> [f64; 2] {
        let mut sums = [0.0; 2];
        let mut count = 0.0;
        for (_, _, x) in Self::nodes() {
            let exact = Self::exact(x);
            sums[0] += self.harmonic(x).map_or(f64::NAN, |w| w.distance(exact));
            sums[1] += self.cauchy_green(x).distance(exact);
            count += 1.0;
        }
        sums.map(|sum| sum / count)
    }

    /// The boundary samples (`kind` boundary: with t, r and the exact r) and the nodes of G₁
    /// (`kind` grid: circle j, ray k) of every study, with their images.
    pub fn table(studies: &[Self]) -> Table {
        let mut table = Table::new(&[
            "m",
            "kind",
            "j",
            "k",
            "x",
            "y",
            "u_exact",
            "v_exact",
            "u_harmonic",
            "v_harmonic",
            "u_cauchy_green",
            "v_cauchy_green",
            "t",
            "r",
            "r_exact",
        ]);
        for study in studies {
            table.rows.extend((0..study.samples().len()).map(|k| study.boundary_row(k)));
            table.rows.extend(Self::nodes().map(|(j, k, x)| study.grid_row(j, k, x)));
        }
        table
    }

    fn boundary_row(&self, k: usize) -> Vec<Cell> {
        let (x, t) = (self.samples()[k], self.parameter(k));
        let mut row = vec![self.samples().len().into(), "boundary".into(), Cell::Empty, k.into()];
        row.extend(self.images_of(x, Some(self.map.images()[k])));
        row.extend([t.into(), self.reparameterisation(k).into(), Self::exact_reparameterization(t).into()]);
        row
    }

    fn grid_row(&self, j: u32, k: u32, x: DVec2) -> Vec<Cell> {
        let mut row = vec![self.samples().len().into(), "grid".into(), j.into(), k.into()];
        row.extend(self.images_of(x, self.harmonic(x)));
        row.extend([Cell::Empty, Cell::Empty, Cell::Empty]);
        row
    }

    fn images_of(&self, x: DVec2, harmonic: Option<DVec2>) -> Vec<Cell> {
        let points = [Some(x), Some(Self::exact(x)), harmonic, Some(self.cauchy_green(x))];
        points.into_iter().flat_map(|p| p.map_or([Cell::Empty, Cell::Empty], |p| [p.x.into(), p.y.into()])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_centered_at_the_constraints() {
        let (x1, x2) = (grid_point(0.0, 0.0), MoebiusStudy::exact(grid_point(0.0, 0.0)));
        assert!(x1.distance(DVec2::new(0.6, 0.2)) < 1e-15, "{x1}");
        assert!(x2.distance(DVec2::new(0.0, -0.5)) < 1e-15, "{x2}");
        assert!(grid_point(10.0, 0.0).distance(DVec2::X) < 1e-15, "1 is kept");
        // the exact map takes G₁ to g₂(G), g₂(z) = (−5i + (6 + 8i) z) / (10 − (4 − 3i) z)
        for (j, k) in [(3.0, 5.0), (9.0, 17.0)] {
            let z = (j / 10.0) * Complex::cis(TAU * k / 24.0);
            let g2 = (Complex::new(0.0, -5.0) + Complex::new(6.0, 8.0) * z)
                / (Complex::from(10.0) - Complex::new(4.0, -3.0) * z);
            assert!(MoebiusStudy::exact(grid_point(j, k)).distance(point(g2)) < 1e-14, "{j}, {k}");
        }
    }
}
