//! Conformal polar coordinates: the map g of a domain to the unit disk, on the domain's own mesh.
//!
//! g takes x to 0 and the anchor y to 1, and a boundary point of harmonic measure ω̃
//! to e^{2πi ω̃} (sections 1.2 and 3.1). The inside is the harmonic extension of that
//! (equation (14)); g is holomorphic, so it is the harmonic extension of its values.
//! Its circles |g| = const are level sets of Green's function −ln |g| about x, its rays
//! those of the harmonic measure. Where a domain crowds, |g| rounds to 1: see `zipper`.

use super::{ExtensionScratch, HarmonicMeasure, PreparedDomain, PreparedSurface, advance_extension};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};
use std::f64::consts::TAU;

/// g at all vertices of the domain's mesh (length m+n), into `values`; `measure` is that of x from
/// y. One solve, as for a map; `scratch` is reused. In the unit disk but for rounding, and for
/// meshes whose Laplacian has positive off-diagonal entries.
///
/// Errors: [`NotConverged`], of an iterative solver only; the values are then unchanged.
pub fn disk_coordinates(
    domain: &PreparedDomain,
    measure: &HarmonicMeasure,
    values: &mut Vec<DVec2>,
    scratch: &mut ExtensionScratch,
) -> Result<(), NotConverged> {
    begin_disk_coordinates(domain, measure, scratch);
    advance_extension(domain, scratch, values, Deadline::NEVER).map(|_| ())
}

/// Begins with [`disk_coordinates`], for [`advance_extension`] to go on with.
pub fn begin_disk_coordinates(domain: &PreparedDomain, measure: &HarmonicMeasure, scratch: &mut ExtensionScratch) {
    domain.system().begin_extension(on_circle(measure, domain.samples.len()), scratch);
}

/// The same for a surface, for [`super::advance_surface_extension`] to go on with.
pub fn begin_surface_disk_coordinates(
    surface: &PreparedSurface,
    measure: &HarmonicMeasure,
    scratch: &mut ExtensionScratch,
) {
    surface.system().begin_extension(on_circle(measure, surface.edge_lengths.len()), scratch);
}

fn on_circle(measure: &HarmonicMeasure, m: usize) -> impl Iterator<Item = DVec2> {
    (0..m).map(|k| DVec2::from_angle(TAU * measure.at_vertex(k)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{ConformalMap, Constraints, Direction, PrepareSettings, Side, prepare};
    use crate::exact::disk::moebius;
    use crate::mesh::{Sizing, locate};
    use crate::outline::{Preset, Sampling};
    use std::sync::Arc;

    fn prepared(preset: Preset, count: u32) -> Arc<PreparedDomain> {
        let sampling = Sampling::Uniform { count, keep_corners: true };
        let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.1), ..PrepareSettings::default() };
        Arc::new(prepare(&preset.outline().polygon, &settings, &mut |_| {}).unwrap())
    }

    fn coordinates(map: &ConformalMap, side: Side) -> Vec<DVec2> {
        let mut values = Vec::new();
        disk_coordinates(map.domain(side), map.measure(side), &mut values, &mut ExtensionScratch::default()).unwrap();
        values
    }

    /// On the disk g is a Möbius map. 400 samples inscribe a polygon whose map differs from it by
    /// 6e-5, and a mesh that grows by 0.1 adds as much as the kernel's own error of 1e-3.
    #[test]
    fn on_the_disk_they_are_the_moebius_map() {
        let disk = prepared(Preset::Disk, 400);
        let points = &disk.samples.points;
        let center = points.iter().sum::<DVec2>() / points.len() as f64;
        let radius = points[0].distance(center);
        let x = DVec2::new(0.5, -0.3);
        let constraints = Constraints {
            source_point: center + radius * x,
            target_point: center,
            source_anchor: 0.3,
            target_anchor: 0.0,
        };
        let map = ConformalMap::new(Arc::clone(&disk), Arc::clone(&disk), &constraints, Direction::Forward.into());
        let anchor = disk.samples.position(disk.samples.at_fraction(0.3));
        let unit = |z: DVec2| (z - center) / radius;
        let values = coordinates(&map.unwrap(), Side::Source);
        let worst = values.iter().zip(&disk.mesh.vertices).map(|(&g, &z)| {
            let exact = moebius(x.into(), unit(anchor).into(), unit(z).into());
            g.distance(DVec2::new(exact.re, exact.im))
        });
        let worst = worst.fold(0.0, f64::max);
        println!("disk, m = 400: the largest error of g is {worst:.2e}");
        assert!(worst < 2e-3, "{worst:e}");
    }

    /// The mean of |g₂(f(z)) − g₁(z)| over the inner vertices.
    fn disagreement(samples: u32) -> f64 {
        let [source, target] = [Preset::Heart, Preset::Cinquefoil].map(|preset| prepared(preset, samples));
        let constraints = Constraints {
            source_point: source.pole,
            target_point: target.pole,
            source_anchor: 0.1,
            target_anchor: 0.7,
        };
        let map = ConformalMap::new(source, target, &constraints, Direction::Forward.into()).unwrap();
        let [here, there] = Side::BOTH.map(|side| coordinates(&map, side));
        let mesh = &map.domain(Side::Target).mesh;
        let (mut sum, mut count) = (0.0, 0.0);
        for (&g, &image) in here.iter().zip(map.images()).skip(map.domain(Side::Source).samples.len()) {
            let Some(found) = locate(mesh, image, 0) else { continue };
            let corners = mesh.triangles[found.triangle as usize];
            let partner: DVec2 = corners.iter().zip(found.weights).map(|(&v, w)| w * there[v as usize]).sum();
            sum += g.distance(partner);
            count += 1.0;
        }
        println!("heart → cinquefoil, m = {samples}: g₂ ∘ f and g₁ differ by {:.2e} on average", sum / count);
        assert!(count > 100.0, "{count} vertices");
        sum / count
    }

    /// The map takes a point to the one with the same coordinates, f = g₂⁻¹ ∘ g₁, but for the error
    /// of discrete harmonic functions: piecewise linear maps do not compose.
    #[test]
    fn a_map_keeps_them() {
        let (coarse, fine) = (disagreement(400), disagreement(1600));
        assert!(coarse < 1e-2 && fine < 0.5 * coarse, "{coarse:e}, {fine:e}");
    }

    #[test]
    fn the_interior_point_is_the_centre() {
        let heart = prepared(Preset::Heart, 300);
        let constraints =
            Constraints { source_point: heart.pole, target_point: heart.pole, source_anchor: 0.0, target_anchor: 0.0 };
        let map = ConformalMap::new(Arc::clone(&heart), Arc::clone(&heart), &constraints, Direction::Forward.into());
        let values = coordinates(&map.unwrap(), Side::Source);
        let found = locate(&heart.mesh, heart.pole, 0).unwrap();
        let corners = heart.mesh.triangles[found.triangle as usize];
        let at: DVec2 = corners.iter().zip(found.weights).map(|(&v, w)| w * values[v as usize]).sum();
        // Both are solves with the same Laplacian: ω̃'s total is exact, its first moment up to the quadrature.
        assert!(at.length() < 1e-3, "g(x) = {at}");
    }
}
