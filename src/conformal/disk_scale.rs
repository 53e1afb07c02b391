//! The local scale |g′| of the map g of a side to the unit disk, without the disk.
//!
//! g takes x to 0 and a boundary point of harmonic measure ω̃ to e^{2πi ω̃}, so that |g′| = 2πψ on the boundary with the
//! Poisson kernel ψ. Inside, u = ln |g′| solves Δu = K with the Gauss curvature K (the scaled metric e^{2u} is flat;
//! Cherrier's formula, as in Sawhney & Crane, Boundary First Flattening, ACM TOG 37 (2018), section 4): in the plane u is
//! harmonic, and on a surface the integrated curvature of a vertex is its angle defect.
//!
//! ψ has all its digits where the disk has none: u is right in limbs that crowd into 1e-100 of the circle.

use super::{ExtensionScratch, PreparedSide, SideGeometry};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};
use crate::mesh::TriMesh;
use std::f64::consts::TAU;

/// ln |g′| at all vertices of the side's mesh (length m+n), per unit of its length; `kernel` is the Poisson kernel of x at
/// the boundary vertices. A vertex without kernel (next to a convex corner all of whose neighbors are on the boundary)
/// has that of the vertex before it. One solve.
///
/// Errors: [`NotConverged`], from the iterative solver only.
pub fn log_disk_scale(side: &PreparedSide, kernel: &[f64]) -> Result<Vec<f64>, NotConverged> {
    let mut before = kernel.iter().rev().copied().find(|psi| *psi > 0.0).unwrap_or(1.0);
    let boundary = kernel.iter().map(|&psi| {
        before = if psi > 0.0 { psi } else { before };
        DVec2::new((TAU * before).ln(), 0.0)
    });
    let (mut scratch, mut values) = (ExtensionScratch::default(), Vec::new());
    side.begin_extension(boundary, &mut scratch);
    if let SideGeometry::Space(surface) = side.geometry() {
        let defects = angle_defects(surface.mesh());
        side.add_sources(defects.into_iter().skip(side.boundary_count()).map(|defect| -defect), &mut scratch);
    }
    side.advance_extension(&mut scratch, &mut values, Deadline::NEVER)?;
    Ok(values.into_iter().map(|value| value.x).collect())
}

/// 2π minus the sum of the angles at each vertex; at boundary vertices without meaning.
fn angle_defects(mesh: &TriMesh<crate::geometry::DVec3>) -> Vec<f64> {
    let mut defects = vec![TAU; mesh.vertices().len()];
    for &triangle in mesh.triangles() {
        let corners = triangle.map(|v| mesh.vertices()[v as usize]);
        for (i, v) in triangle.into_iter().enumerate() {
            let [a, b] = [1, 2].map(|k| corners[(i + k) % 3] - corners[i]);
            defects[v as usize] -= a.cross(b).length().atan2(a.dot(b));
        }
    }
    defects
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{PrepareSettings, SurfaceSettings, poisson_kernel, prepare, prepare_surface};
    use crate::geometry::DVec3;
    use crate::mesh::locate;
    use crate::outline::Preset;
    use crate::surface::{SurfaceMesh, SurfacePreset};

    /// From x the unit disk is mapped by (z − x)/(1 − x̄ z) with |g′| = (1 − |x|²)/|1 − x̄ z|².
    #[test]
    fn of_the_disk_it_is_that_of_the_moebius_map() {
        let disk = prepare(Preset::Disk.outline().polygon(), &PrepareSettings::default(), &mut |_| {}).unwrap();
        let mesh = disk.domain().unwrap().mesh();
        let middle = mesh.boundary().iter().sum::<DVec2>() / f64::from(mesh.boundary_count());
        let radius = mesh.boundary()[0].distance(middle);
        let x = DVec2::new(0.5, -0.3);
        let located = locate(mesh, middle + radius * x, None).unwrap();
        let scale = log_disk_scale(&disk, &poisson_kernel(&disk, located).unwrap()).unwrap();
        let exact = |z: DVec2| {
            let z = (z - middle) / radius;
            let distance = (DVec2::X - DVec2::new(x.dot(z), x.perp_dot(z))).length_squared();
            ((1.0 - x.length_squared()) / distance / radius).ln()
        };
        let worst = mesh.vertices().iter().zip(&scale).map(|(&z, u)| (u - exact(z)).abs()).fold(0.0, f64::max);
        println!("the largest error of ln |g′| is {worst:.2e}");
        assert!(worst < 5e-3, "{worst:e}");
    }

    /// A hemisphere of radius 1 is mapped by tan(θ/2) with the angle θ from its pole: the scale is 1/(1 + cos θ). The default
    /// point is 0.03 from the pole, and next to single vertices of the boundary the kernel of such a mesh is off by a half.
    #[test]
    fn of_a_hemisphere_it_is_that_of_the_stereographic_projection() {
        let surface = SurfaceMesh::new(&SurfacePreset::Hemisphere.surface(200).unwrap()).unwrap();
        let side = prepare_surface(surface, SurfaceSettings::default(), &mut |_| {}).unwrap();
        let meshed = side.surface().unwrap();
        let scale = log_disk_scale(&side, &poisson_kernel(&side, meshed.centre()).unwrap()).unwrap();
        let vertices = meshed.mesh().vertices();
        let rim = vertices[0].length();
        let exact = |p: DVec3| (1.0 / (1.0 + (p.z / rim).abs()) / rim).ln();
        let off = vertices.iter().zip(&scale).map(|(&p, u)| (u - exact(p)).abs()).sum::<f64>() / vertices.len() as f64;
        println!("the mean error of ln |g′| is {off:.2e}");
        assert!(off < 5e-2, "{off:e}");
    }
}
