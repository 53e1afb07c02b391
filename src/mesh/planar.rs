//! The planar mesher: constrained Delaunay refinement inside a sampled boundary.
//!
//! Interior points are seeded first (a hexagonal lattice, or graded points), then
//! spade triangulates them with the boundary and refines to 20°. Guaranteed: the
//! mesh's boundary is the given one, bit for bit and in order, without added
//! vertices; triangles are counter-clockwise and Delaunay (constrained); the same
//! input gives the same mesh. Not guaranteed: the angle limit next to boundary
//! edges that are much longer than their neighbours or that meet at a sharp
//! angle, since no boundary edge is split.
//!
//! Coordinates are scaled by a power of two, which is exact, so the mesh does not depend
//! on the outline's scale.

use super::assemble::assemble;
use super::ears::split_ears;
use super::hex_lattice::{HexLattice, bounds};
use super::triangulate::{Input, Output, triangulate};
use super::{MeshError, TriMesh, graded};
use crate::geometry::{DVec2, sort_by_number};

/// The largest number of interior vertices that [`mesh_domain`] makes: such a mesh
/// takes about 0.5 GB with its factor, which a browser tab can still allocate.
pub const MAX_INTERIOR: usize = 3_000_000;

/// How the size of the triangles varies over the domain.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Sizing {
    /// Area at most h²/2, h the mean boundary edge length (the paper's); n = O(m²).
    Uniform,
    /// The size grows by this much per distance from the boundary (in `[0.01, 1]`); n ≈ m/g at most. A domain of
    /// many samples is meshed with a smaller growth: see [`Sizing::at`].
    Graded(f64),
}

/// Up to this many boundary samples a graded mesh has the growth that was asked for, the default one or a larger one;
/// with a smaller growth up to so many more that the default one would be as small.
const GROWTH_SAMPLES: f64 = 500.0;

/// The default growth.
const DEFAULT_GROWTH: f64 = 0.15;

/// The growth for many samples is not lowered beyond m/g = n of this size: the factor then still fits into a browser
/// tab, and takes half a second.
const GROWN_VERTICES: f64 = 3e5;

impl Sizing {
    /// The sizing for a boundary of `m` samples, such that maps converge with increasing `m`.
    ///
    /// Linear elements whose size is g times the distance from the boundary have a relative error of O(g²) at every
    /// distance, whatever `m`: V-shape → blob has a mean image error of 2e-3 to 3e-3 for g = 0.15 and m = 500 … 4000.
    /// So beyond m = 500 the default growth g = 0.15 becomes `g · 500/m`, as does a larger one, and n grows like m²: the
    /// observed order of the mean error is 1.5 between m = 250 and 4000. A smaller g stays until that is smaller still. It is not lowered below 0.01, nor so far that m/g exceeds 3·10⁵ (m > 4700).
    #[must_use]
    pub fn at(self, m: usize) -> Self {
        let m = m as f64;
        match self {
            Self::Graded(g) if g.is_finite() && m > GROWTH_SAMPLES => {
                let finer = (g.max(DEFAULT_GROWTH) * GROWTH_SAMPLES / m).max(*GROWTH.start()).max(m / GROWN_VERTICES);
                Self::Graded(finer.min(g))
            }
            sizing => sizing,
        }
    }
}

impl Default for Sizing {
    fn default() -> Self {
        Self::Graded(DEFAULT_GROWTH)
    }
}

/// The result of the refinement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct RefineReport {
    /// Whether every triangle meets the limits (otherwise the vertex budget ran out).
    pub complete: bool,
    /// The number of interior vertices that the refinement added to the seeds.
    pub added: usize,
}

/// The area of lattice triangles as a part of the limit h²/2: a little less than
/// 1, since rounding would otherwise make the refinement split every one of them.
const LATTICE_AREA: f64 = 0.97;

/// Accepted growths: from 1 on, neighboring layers differ by a factor of two;
/// at 0 the smallest edge would set the size everywhere.
const GROWTH: std::ops::RangeInclusive<f64> = 0.01..=1.0;

/// Meshes the inside of the counter-clockwise polygon `boundary`.
///
/// The mesh's boundary vertices are exactly `boundary`, in order; the interior
/// ones are numbered along rows (uniform) or a Hilbert curve (graded), except the
/// few that give sharp corners an interior neighbor: these come last. There are
/// `m + 2n − 2` triangles. Cost O(m + n log n) for n interior vertices.
pub fn mesh_domain(boundary: &[DVec2], sizing: Sizing) -> Result<(TriMesh, RefineReport), MeshError> {
    let scale = normalising_scale(boundary)?;
    let scaled: Vec<DVec2> = boundary.iter().map(|&p| (p * scale).map(flush_tiny)).collect();
    let interior = match sizing {
        Sizing::Uniform => uniform(&scaled),
        Sizing::Graded(g) if GROWTH.contains(&g) => graded_interior(&scaled, g),
        Sizing::Graded(grading) => Err(MeshError::Grading { grading }),
    };
    let mut interior = interior.map_err(|error| error.unscaled(scale))?;
    interior.points.iter_mut().for_each(|p| *p /= scale);
    let report = interior.report;
    let mut mesh = assemble(boundary, interior)?;
    split_ears(&mut mesh);
    debug_assert_eq!(mesh.check_invariants(), Ok(()));
    Ok((mesh, report))
}

/// Interior vertices and triangles before their final numbering.
pub(super) struct Interior {
    pub points: Vec<DVec2>,
    /// `order[k]` is the index in `points` of the interior vertex `m + k`.
    pub order: Vec<u32>,
    /// Triples of `0 … m−1` (boundary) and `m + index in points`.
    pub triangles: Vec<[u32; 3]>,
    pub report: RefineReport,
}

/// The power of two that brings the largest coordinate into `[1/2, 1)`.
fn normalising_scale(boundary: &[DVec2]) -> Result<f64, MeshError> {
    if boundary.len() < 3 {
        return Err(MeshError::TooFewPoints { count: boundary.len() });
    }
    if let Some(index) = boundary.iter().position(|p| !p.is_finite()) {
        return Err(MeshError::NotFinite { index });
    }
    let largest = boundary.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let scale = (-largest.log2().floor() - 1.0).exp2();
    // beyond that, products of three coordinates overflow or underflow in the code that uses the mesh
    if (2f64.powi(-300)..2f64.powi(300)).contains(&largest) { Ok(scale) } else { Err(MeshError::OutOfRange) }
}

/// Coordinates below 2⁻¹²⁰ of the largest one become 0, since spade rejects values below 2⁻¹⁴².
fn flush_tiny(x: f64) -> f64 {
    if x.abs() < 2f64.powi(-120) { 0.0 } else { x }
}

/// Twice the signed area, relative to the first point.
fn doubled_area(polygon: &[DVec2]) -> f64 {
    let origin = polygon[0];
    polygon.windows(2).map(|w| (w[0] - origin).perp_dot(w[1] - origin)).sum()
}

/// Area and mean edge length; an error for polygons that cannot be meshed.
fn measure(polygon: &[DVec2]) -> Result<(f64, f64), MeshError> {
    let area = 0.5 * doubled_area(polygon);
    let m = polygon.len();
    if (0..m).any(|k| polygon[k] == polygon[(k + 1) % m]) {
        return Err(MeshError::of_repeated_point(polygon));
    }
    let perimeter: f64 = (0..m).map(|k| polygon[k].distance(polygon[(k + 1) % m])).sum();
    if area > 0.0 { Ok((area, perimeter / m as f64)) } else { Err(MeshError::NotCounterClockwise) }
}

/// Refuses to make more than [`MAX_INTERIOR`] vertices.
pub(super) fn check_count(estimate: f64) -> Result<(), MeshError> {
    if estimate > MAX_INTERIOR as f64 {
        return Err(MeshError::TooManyVertices { estimate, limit: MAX_INTERIOR });
    }
    Ok(())
}

/// The largest number of vertices that the refinement may add. The seeds already have the right
/// sizes: on sampled outlines it adds a tenth of them. Around an edge of 10⁻⁹ of
/// its neighbors it needs 40 vertices; between short edges and long ones that
/// may not be split it might not terminate.
fn refinement_budget(m: usize, seeds: usize) -> usize {
    (4 * m + seeds + 1000).min(MAX_INTERIOR)
}

fn uniform(boundary: &[DVec2]) -> Result<Interior, MeshError> {
    let m = boundary.len() as u32;
    let (area, h) = measure(boundary)?;
    let max_area = 0.5 * h * h;
    check_count(area / (2.0 * LATTICE_AREA * max_area))?;
    let lattice = HexLattice::clip(boundary, (LATTICE_AREA * max_area * 4.0 / 3f64.sqrt()).sqrt());
    let mut points = lattice.positions();
    let band = lattice.band();
    let mut local = vec![u32::MAX; lattice.len()];
    band.iter().enumerate().for_each(|(k, &p)| local[p as usize] = m + k as u32);
    let seeds: Vec<DVec2> = band.iter().map(|&p| points[p as usize]).collect();
    let holes: Vec<[u32; 2]> = lattice.core_edges().iter().map(|e| e.map(|v| local[v as usize])).collect();
    let max_added = refinement_budget(boundary.len(), seeds.len());
    let Output { added, mut triangles, complete } =
        triangulate(&Input { boundary, seeds: &seeds, holes: &holes, max_area: Some(max_area), max_added })?;
    let global = |v: u32| match v.checked_sub(m).map(|k| band.get(k as usize).copied().ok_or(k)) {
        None => v,
        Some(Ok(lattice_point)) => m + lattice_point,
        Some(Err(k)) => m + lattice.len() as u32 + (k - band.len() as u32),
    };
    for t in &mut triangles {
        *t = t.map(global);
    }
    triangles.extend(lattice.core_triangles().into_iter().map(|t| t.map(|v| v + m)));
    let order = merge_rows(&lattice, &points, &added);
    points.extend(&added);
    Ok(Interior { points, order, triangles, report: RefineReport { complete, added: added.len() } })
}

/// Numbers the added vertices along the rows of the lattice.
fn merge_rows(lattice: &HexLattice, points: &[DVec2], added: &[DVec2]) -> Vec<u32> {
    let key = |p: DVec2| (lattice.row_of(p), p.x);
    let before = |a: DVec2, b: DVec2| key(a).0.cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)).is_lt();
    let mut late: Vec<u32> = (0..added.len() as u32).collect();
    sort_by_number(&mut late, |&j| added[j as usize].x);
    sort_by_number(&mut late, |&j| f64::from(lattice.row_of(added[j as usize])));
    let mut late = late.into_iter().peekable();
    let mut order = Vec::with_capacity(points.len() + added.len());
    for (k, &p) in points.iter().enumerate() {
        while let Some(j) = late.next_if(|&j| before(added[j as usize], p)) {
            order.push((points.len() + j as usize) as u32);
        }
        order.push(k as u32);
    }
    order.extend(late.map(|j| (points.len() + j as usize) as u32));
    order
}

fn graded_interior(boundary: &[DVec2], growth: f64) -> Result<Interior, MeshError> {
    measure(boundary)?;
    let seeds = graded::seeds(boundary, growth)?;
    let max_added = refinement_budget(boundary.len(), seeds.len());
    let Output { added, triangles, complete } =
        triangulate(&Input { boundary, seeds: &seeds, holes: &[], max_area: None, max_added })?;
    let report = RefineReport { complete, added: added.len() };
    let mut points = seeds;
    points.extend(added);
    let order = hilbert_order(&points, bounds(boundary));
    Ok(Interior { points, order, triangles, report })
}

/// The points' indices along a Hilbert curve of 2¹⁶ × 2¹⁶ cells.
fn hilbert_order(points: &[DVec2], (low, high): (DVec2, DVec2)) -> Vec<u32> {
    let scale = 65_535.0 / (high - low).max_element();
    let mut keyed: Vec<(u32, u32)> = points
        .iter()
        .enumerate()
        .map(|(k, &p)| {
            let cell = (p - low) * scale;
            (hilbert_index(cell.x as u32, cell.y as u32), k as u32)
        })
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|(_, k)| k).collect()
}

/// The position of cell `(x, y)` along the Hilbert curve of order 16.
fn hilbert_index(mut x: u32, mut y: u32) -> u32 {
    let mut index = 0;
    for bit in (0..16).rev() {
        let (right, upper) = ((x >> bit) & 1, (y >> bit) & 1);
        index = (index << 2) | ((3 * right) ^ upper);
        if upper == 0 {
            if right == 1 {
                (x, y) = (!x & 0xffff, !y & 0xffff);
            }
            (x, y) = (y, x);
        }
    }
    index
}
