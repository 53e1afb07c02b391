//! Interpolation of the kernel at x with a smaller error than that of linear interpolation in the triangle of x.
//!
//! As a function of x every harmonic coordinate φ_k is harmonic and positive. On a
//! graded mesh the triangles far from the boundary are large, and the linear
//! interpolation of φ_k inside one is the largest error of the whole method. Here φ_x is a sum
//! over the vertices around x instead, with the smallest weights that reproduce all
//! harmonic polynomials Re, Im (z − x)^k, k ≤ 4. By Harnack's inequality a positive
//! harmonic function has Taylor coefficients ≤ 2 h(x)/R^k in a disk of radius R,
//! so the *relative* error is O((r/R)⁵) however small φ_k is.
//!
//! It is used only if the whole ring around x is interior; next to the boundary the
//! triangles are small and the linear interpolation of the paper is kept.

use crate::geometry::DVec2;
use crate::mesh::{BarycentricPoint, TriMesh, TriangleId};

/// The number of conditions: the constant, and real and imaginary part of degrees 1 … 4.
const CONDITIONS: usize = 9;

/// If a pivot is below this fraction of the largest, the ring does not determine the
/// weights. Rings of refined meshes give ≥ 1e-4, a symmetric hexagon of 7 vertices 1e-16.
const SMALLEST_PIVOT: f64 = 1e-9;

/// Rings have about 12 vertices; none with more than this was observed with angles of at least 20°.
const USUAL_RING: usize = 64;

/// Vertices and weights: φ_x = Σ weight · φ_vertex.
pub(super) type Stencil = Vec<(u32, f64)>;

/// Writes the weights of the vertices around `x` into `stencil`: those of the ring if it can be
/// used, else those of the three corners.
pub(super) fn around(mesh: &TriMesh, x: BarycentricPoint, stencil: &mut Stencil) {
    stencil.clear();
    stencil.reserve(USUAL_RING);
    let corners = mesh.triangles()[x.triangle().index()];
    let point: DVec2 = corners.iter().zip(x.weights()).map(|(&v, w)| w * mesh.vertices()[v as usize]).sum();
    let ringed = corners.iter().all(|&corner| collect_ring(mesh, x.triangle(), corner, stencil));
    if !ringed || set_weights(point, |v| mesh.vertices()[v as usize], stencil).is_none() {
        stencil.clear();
        stencil.extend(corners.into_iter().zip(x.weights()));
    }
}

/// Adds the vertices of all triangles at `corner`; returns false if one of them is on the boundary.
fn collect_ring(mesh: &TriMesh, start: TriangleId, corner: u32, stencil: &mut Stencil) -> bool {
    let mut triangle = start;
    loop {
        let corners = mesh.triangles()[triangle.index()];
        for v in corners {
            if v < mesh.boundary_count() {
                return false;
            }
            if stencil.iter().all(|&(known, _)| known != v) {
                stencil.push((v, 0.0));
            }
        }
        let Some(i) = corners.iter().position(|&v| v == corner) else { return false };
        let Some(next) = mesh.neighbour(triangle, (i + 1) % 3) else { return false };
        triangle = next;
        if triangle == start {
            return true;
        }
    }
}

/// The smallest weights, in a norm that favors near vertices, that meet the conditions at `x`, for the vertices of
/// `stencil` at their positions; `None` if the conditions cannot be met.
pub(super) fn set_weights(x: DVec2, place: impl Fn(u32) -> DVec2, stencil: &mut Stencil) -> Option<()> {
    let offset = |v: u32| place(v) - x;
    let radius = stencil.iter().map(|&(v, _)| offset(v).length()).fold(0.0, f64::max);
    let row = |offset: DVec2| monomials(offset / radius);
    let preference = |offset: DVec2| (0.1 + offset.length_squared() / (radius * radius)).powi(-2);
    let mut gram = [[0.0; CONDITIONS]; CONDITIONS];
    for offset in stencil.iter().map(|&(v, _)| offset(v)) {
        let (row, w) = (row(offset), preference(offset));
        for i in 0..CONDITIONS {
            for j in 0..CONDITIONS {
                gram[i][j] += w * row[i] * row[j];
            }
        }
    }
    let multipliers = solve_for_constant(gram)?;
    for (v, weight) in stencil.iter_mut() {
        let offset = offset(*v);
        let product: f64 = row(offset).iter().zip(multipliers).map(|(a, b)| a * b).sum();
        *weight = preference(offset) * product;
    }
    Some(())
}

/// 1, Re z, Im z, Re z², … Im z⁴.
fn monomials(z: DVec2) -> [f64; CONDITIONS] {
    let mut values = [1.0; CONDITIONS];
    let mut power = DVec2::X;
    for k in 0..CONDITIONS / 2 {
        power = DVec2::new(power.x * z.x - power.y * z.y, power.x * z.y + power.y * z.x);
        [values[2 * k + 1], values[2 * k + 2]] = [power.x, power.y];
    }
    values
}

/// Solves `gram · y = (1, 0, …, 0)` by Cholesky; `None` if it is near singular.
fn solve_for_constant(mut gram: [[f64; CONDITIONS]; CONDITIONS]) -> Option<[f64; CONDITIONS]> {
    let largest = gram[0][0];
    let mut y = [0.0; CONDITIONS];
    for j in 0..CONDITIONS {
        let pivot = gram[j][j] - (0..j).map(|k| gram[j][k] * gram[j][k]).sum::<f64>();
        if pivot.is_nan() || pivot <= SMALLEST_PIVOT * largest {
            return None;
        }
        gram[j][j] = pivot.sqrt();
        for i in j + 1..CONDITIONS {
            let product: f64 = (0..j).map(|k| gram[i][k] * gram[j][k]).sum();
            gram[i][j] = (gram[i][j] - product) / gram[j][j];
        }
        let right = if j == 0 { 1.0 } else { 0.0 };
        y[j] = (right - (0..j).map(|k| gram[j][k] * y[k]).sum::<f64>()) / gram[j][j];
    }
    for j in (0..CONDITIONS).rev() {
        y[j] = (y[j] - (j + 1..CONDITIONS).map(|k| gram[k][j] * y[k]).sum::<f64>()) / gram[j][j];
    }
    Some(y)
}
