//! Conformal polar coordinates: the map g of a side to the unit disk, on the side's own mesh.
//!
//! g takes x to 0 and the anchor y to 1, and a boundary point of harmonic measure ω̃
//! to e^{2πi ω̃} (sections 1.2 and 3.1). The interior values are the harmonic extension of these
//! (equation (14)); g is holomorphic, so it is the harmonic extension of its values.
//! Its circles |g| = const are level sets of Green's function −ln |g| about x, its rays
//! those of the harmonic measure. Where a domain crowds, |g| rounds to 1: see `zipper`.

use super::{ExtensionScratch, HarmonicMeasure, PreparedSide, harmonic_extension};
use crate::geometry::DVec2;
use crate::laplace::NotConverged;
use std::f64::consts::TAU;

/// g at all vertices of the side's mesh (length m+n); `measure` is the harmonic measure of x from y. One solve, as for
/// a map. The values lie in the unit disk, up to rounding and except on meshes whose Laplacian has positive
/// off-diagonal entries.
///
/// Errors: [`NotConverged`], from the iterative solver only.
pub fn disk_coordinates(side: &PreparedSide, measure: &HarmonicMeasure) -> Result<Vec<DVec2>, NotConverged> {
    harmonic_extension(side, on_circle(measure, side.boundary_count()))
}

/// Starts computing [`disk_coordinates`]; [`PreparedSide::advance_extension`] continues.
pub(crate) fn begin_disk_coordinates(side: &PreparedSide, measure: &HarmonicMeasure, scratch: &mut ExtensionScratch) {
    side.begin_extension(on_circle(measure, side.boundary_count()), scratch);
}

fn on_circle(measure: &HarmonicMeasure, m: usize) -> impl Iterator<Item = DVec2> {
    (0..m).map(|k| DVec2::from_angle(TAU * measure.at_vertex(k)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{ConformalMap, Constraints, Direction, MapSettings, PrepareSettings, Side, prepare};
    use crate::exact::disk::moebius;
    use crate::exact::{complex, point};
    use crate::laplace::{Deadline, SolverKind};
    use crate::mesh::{Sizing, locate};
    use crate::outline::{Preset, Sampling};
    use std::sync::Arc;

    fn prepared(preset: Preset, count: u32) -> Arc<PreparedSide> {
        let sampling = Sampling::Uniform { count, keep_corners: true };
        let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.1), ..PrepareSettings::default() };
        Arc::new(prepare(preset.outline().polygon(), &settings, &mut |_| {}).unwrap())
    }

    fn coordinates(map: &ConformalMap, side: Side) -> Vec<DVec2> {
        disk_coordinates(map.side(side), map.measure(side)).unwrap()
    }

    /// On the disk g is a Möbius map. 400 samples inscribe a polygon whose map differs from it by
    /// 6e-5, and a mesh that grows by 0.1 adds as much as the kernel's own error of 1e-3.
    #[test]
    fn on_the_disk_they_are_the_moebius_map() {
        let disk = prepared(Preset::Disk, 400);
        let points = disk.domain().unwrap().samples().points();
        let center = points.iter().sum::<DVec2>() / points.len() as f64;
        let radius = points[0].distance(center);
        let x = DVec2::new(0.5, -0.3);
        let constraints = Constraints::new((center + radius * x, 0.3), (center, 0.0));
        let map = ConformalMap::new(Arc::clone(&disk), Arc::clone(&disk), &constraints, Direction::Forward.into());
        let anchor = disk.domain().unwrap().samples().position(disk.at_fraction(0.3));
        let unit = |z: DVec2| (z - center) / radius;
        let values = coordinates(&map.unwrap(), Side::Source);
        let worst = values.iter().zip(disk.domain().unwrap().mesh().vertices()).map(|(&g, &z)| {
            let exact = moebius(complex(x), complex(unit(anchor)), complex(unit(z)));
            g.distance(point(exact))
        });
        let worst = worst.fold(0.0, f64::max);
        println!("disk, m = 400: the largest error of g is {worst:.2e}");
        assert!(worst < 2e-3, "{worst:e}");
    }

    /// The mean of |g₂(f(z)) − g₁(z)| over the inner vertices.
    fn disagreement(samples: u32) -> f64 {
        let [source, target] = [Preset::Heart, Preset::Cinquefoil].map(|preset| prepared(preset, samples));
        let constraints = Constraints::new((source.default_point(), 0.1), (target.default_point(), 0.7));
        let map = ConformalMap::new(source, target, &constraints, Direction::Forward.into()).unwrap();
        let [here, there] = Side::BOTH.map(|side| coordinates(&map, side));
        let mesh = map.domain(Side::Target).unwrap().mesh();
        let (mut sum, mut count) = (0.0, 0.0);
        for (&g, &image) in here.iter().zip(map.images()).skip(map.side(Side::Source).boundary_count()) {
            let Some(found) = locate(mesh, image, None) else { continue };
            let corners = mesh.triangles()[found.triangle().index()];
            let partner: DVec2 = corners.iter().zip(found.weights()).map(|(&v, w)| w * there[v as usize]).sum();
            sum += g.distance(partner);
            count += 1.0;
        }
        println!("heart → cinquefoil, m = {samples}: g₂ ∘ f and g₁ differ by {:.2e} on average", sum / count);
        assert!(count > 100.0, "{count} vertices");
        sum / count
    }

    /// The map takes a point to the one with the same coordinates, f = g₂⁻¹ ∘ g₁, up to the error
    /// of discrete harmonic functions: piecewise linear maps do not compose.
    #[test]
    fn a_map_keeps_them() {
        let (coarse, fine) = (disagreement(400), disagreement(1600));
        assert!(coarse < 1e-2 && fine < 0.5 * coarse, "{coarse:e}, {fine:e}");
    }

    #[test]
    fn the_interior_point_is_the_centre() {
        let heart = prepared(Preset::Heart, 300);
        let constraints = Constraints::new((heart.default_point(), 0.0), (heart.default_point(), 0.0));
        let map = ConformalMap::new(Arc::clone(&heart), Arc::clone(&heart), &constraints, Direction::Forward.into());
        let values = coordinates(&map.unwrap(), Side::Source);
        let found = locate(heart.domain().unwrap().mesh(), heart.domain().unwrap().default_point(), None).unwrap();
        let corners = heart.triangles()[found.triangle().index()];
        let at: DVec2 = corners.iter().zip(found.weights()).map(|(&v, w)| w * values[v as usize]).sum();
        // Both are solves with the same Laplacian: the total of ω̃ is exact, its first moment up to the quadrature.
        assert!(at.length() < 1e-3, "g(x) = {at}");
    }

    /// Computed in the shortest pieces, the result is bit-identical, and no partial result is visible.
    #[test]
    fn in_pieces_they_are_those_at_once() {
        for solver in [SolverKind::Direct, SolverKind::Pcg] {
            let [source, target] = [Preset::Heart, Preset::Star].map(|preset| {
                let settings = PrepareSettings::default().with_sampling(Sampling::Adaptive { target: Some(300) });
                Arc::new(prepare(preset.outline().polygon(), &settings.with_solver(solver), &mut |_| {}).unwrap())
            });
            let at = Constraints::new((source.default_point(), 0.3), (target.default_point(), 0.9));
            let map = ConformalMap::new(source, target, &at, MapSettings::default()).unwrap();
            let (mut scratch, mut pieces) = (ExtensionScratch::default(), vec![DVec2::ONE]);
            for side in Side::BOTH {
                let (whole, before) = (coordinates(&map, side), pieces.clone());
                begin_disk_coordinates(map.side(side), map.measure(side), &mut scratch);
                let mut steps = 1;
                while !map.side(side).advance_extension(&mut scratch, &mut pieces, Deadline::in_ms(0.0)).unwrap() {
                    assert_eq!(pieces, before);
                    steps += 1;
                }
                assert!(steps > 1 && whole == pieces, "{solver:?}, {side}: {steps} steps");
            }
        }
    }
}
