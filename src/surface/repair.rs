//! Repairs that are safe, in a fixed order, each reported in a [`RepairNote`].
//!
//! Corners of a triangle at one place are merged; triangles that name a vertex twice are dropped, and those with the corners
//! of an earlier one; parts are joined along lines on which their vertices differ; the component with the most triangles is
//! kept, so that faults of others do not matter; the rest is oriented consistently, as most of its triangles are; flat
//! triangles have their longest edge flipped; gaps without area that reach the boundary are joined; vertices that join fans of
//! triangles are split; vertices in no triangle are dropped; all boundary loops but one, unless asked otherwise the longest, are
//! filled, or joined if they have no area. Faults whose repair would need a guess (edges of three triangles) stay errors.

use super::duplicates::duplicates;
use super::edges::EdgeTable;
use super::fill::fill_holes;
use super::mend::{flip_flat, join_flat, join_open, merge_coincident, merge_places, split_pinched};
use super::orient::turned;
use super::survey::{check_edges, check_indices, check_places, components, connectivity, largest, repeats, report};
use super::{LoopReport, Surface, TopologyError};
use crate::counted::counted;
use crate::geometry::DVec3;
use crate::mesh::{TriangleId, VertexId};

/// The origin of a vertex or triangle that a repair has added.
pub(super) const ADDED: u32 = u32::MAX;

/// A repair that was made.
#[derive(Debug, Clone, PartialEq, thiserror::Error, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum RepairNote {
    /// Triangles that name a vertex twice were dropped.
    #[error("{}", counted!(
        *count,
        "1 triangle that names a vertex twice was dropped",
        "{count} triangles that name a vertex twice were dropped"
    ))]
    DroppedTriangles {
        /// Number of triangles dropped.
        count: usize,
    },
    /// Corners of a triangle, or of two parts that were joined, at one place were merged.
    #[error("{}", counted!(
        *count,
        "1 vertex was merged into its neighbor at the same place",
        "{count} vertices were merged into their neighbors at the same place"
    ))]
    MergedVertices {
        /// Number of vertices that are no longer used.
        count: usize,
    },
    /// Triangles without area had their longest edge flipped, or were dropped at the boundary.
    #[error("{}", counted!(
        *count,
        "1 triangle without area had its longest edge flipped",
        "{count} triangles without area had their longest edge flipped"
    ))]
    FlippedFlat {
        /// Number of triangles.
        count: usize,
    },
    /// Vertices that join fans of triangles were split.
    #[error("{}", counted!(
        *count,
        "1 vertex was added where parts of the surface met in one",
        "{count} vertices were added where parts of the surface met in one"
    ))]
    SplitVertices {
        /// Number of vertices added.
        count: usize,
    },
    /// Holes without area were joined: a triangle was divided at vertices on its edge.
    #[error("{}", counted!(*count, "1 gap without area was joined", "{count} gaps without area were joined"))]
    Joined {
        /// Number of holes.
        count: usize,
    },
    /// Triangles with the corners of an earlier one were dropped.
    #[error("{}", counted!(
        *count,
        "1 triangle with the same corners as another one was dropped",
        "{count} triangles with the same corners as another one were dropped"
    ))]
    DroppedDuplicates {
        /// Number of triangles dropped.
        count: usize,
    },
    /// The orientation of triangles was reversed.
    #[error("{}", counted!(
        *count,
        "1 triangle was turned round, so that all have the same orientation",
        "{count} triangles were turned round, so that all have the same orientation"
    ))]
    Oriented {
        /// Number of triangles reversed.
        count: usize,
    },
    /// Only one component was kept.
    #[error("{}", counted!(
        *dropped,
        "the largest of {components} components was kept; 1 triangle was dropped",
        "the largest of {components} components was kept; {dropped} triangles were dropped"
    ))]
    KeptLargest {
        /// Number of components before.
        components: usize,
        /// Number of triangles in the dropped components.
        dropped: usize,
    },
    /// Vertices in no triangle were dropped.
    #[error("{}", counted!(
        *count,
        "1 vertex in no triangle was dropped",
        "{count} vertices in no triangle were dropped"
    ))]
    DroppedVertices {
        /// Number of vertices dropped.
        count: usize,
    },
    /// Holes were filled.
    #[error("{}", filled(.holes.len(), *.triangles))]
    FilledHoles {
        /// Their boundary loops.
        holes: Vec<LoopReport>,
        /// Number of triangles added.
        triangles: usize,
    },
}

fn filled(holes: usize, triangles: usize) -> String {
    if holes > 1 {
        return format!("{holes} holes were filled with {triangles} triangles");
    }
    counted!(triangles, "1 hole was filled with 1 triangle", "1 hole was filled with {triangles} triangles")
}

/// A repaired surface, with the origin of each vertex and triangle.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Repaired {
    /// The surface.
    pub(super) surface: Surface,
    /// For each vertex its index before, or [`ADDED`].
    pub(super) vertex_origins: Vec<u32>,
    /// For each triangle its index before, or [`ADDED`].
    pub(super) triangle_origins: Vec<u32>,
    /// The positions of vertices that were added to triangles of the surface; as origins they follow those before.
    pub(super) split: Vec<DVec3>,
    /// The repairs made; empty if none was needed.
    pub(super) notes: Vec<RepairNote>,
}

impl Repaired {
    /// The surface unchanged, every vertex and triangle its own origin.
    pub(super) fn untouched(surface: Surface) -> Self {
        let vertex_origins = (0..surface.vertices.len() as u32).collect();
        let triangle_origins = (0..surface.triangles.len() as u32).collect();
        Self { surface, vertex_origins, triangle_origins, split: Vec::new(), notes: Vec::new() }
    }

    /// A fault of the surface with the numbers that vertices and triangles had before; those that a repair has added keep theirs.
    pub(super) fn before(&self, fault: TopologyError) -> TopologyError {
        let origin = |origins: &[u32], k: usize| origins.get(k).copied().filter(|&origin| origin != ADDED);
        let vertex = |v: VertexId| origin(&self.vertex_origins, v.index()).map_or(v, VertexId::new);
        let triangle = |t: TriangleId| origin(&self.triangle_origins, t.index()).map_or(t, TriangleId::new);
        fault.renumbered(&vertex, &triangle)
    }

    /// Keeps the triangles for which `keep` holds, and returns how many were dropped.
    pub(super) fn retain(&mut self, keep: impl Fn(usize, &[u32; 3]) -> bool) -> usize {
        let before = self.surface.triangles.len();
        let kept: Vec<bool> = self.surface.triangles.iter().enumerate().map(|(t, corners)| keep(t, corners)).collect();
        let mut flags = kept.iter();
        self.surface.triangles.retain(|_| flags.next().copied().unwrap_or_default());
        let mut flags = kept.iter();
        self.triangle_origins.retain(|_| flags.next().copied().unwrap_or_default());
        before - self.surface.triangles.len()
    }
}

/// Makes the safe repairs; of the boundary loops, the longest first, number `outline` is not filled. An error, with the
/// surface's numbers, if a fault needs another. The result may still not be a disk (closed, with handles, with flat triangles):
/// [`super::SurfaceMesh::repaired`] reports that. Cost O(n log d).
pub(super) fn repair(surface: Surface, outline: usize) -> Result<Repaired, TopologyError> {
    check_indices(&surface)?;
    let mut repaired = Repaired::untouched(surface);
    match mend(&mut repaired, outline) {
        Ok(()) => Ok(repaired),
        Err(fault) => Err(repaired.before(fault)),
    }
}

/// All repairs in order. Errors have the numbers of the surface as it is repaired so far.
fn mend(repaired: &mut Repaired, outline: usize) -> Result<(), TopologyError> {
    merge_coincident(repaired);
    drop_repeating(repaired);
    drop_duplicates(repaired);
    join_parts(repaired);
    keep_largest(repaired);
    orient(repaired)?;
    check_places(&repaired.surface)?;
    flip_flat(repaired);
    join_open(repaired);
    split_pinched(repaired);
    drop_unreferenced(repaired);
    let mut loops = connectivity(&repaired.surface)?.loops;
    if outline > 0 && outline >= loops.len() {
        let loops = loops.iter().map(|l| report(&repaired.surface, l)).collect();
        return Err(TopologyError::NoLoop { asked: outline + 1, loops });
    }
    if outline > 0 {
        loops[..=outline].rotate_right(1);
    }
    join_flat(repaired, &mut loops);
    fill_holes(repaired, &loops)
}

/// Drops triangles that name a vertex twice.
pub(super) fn drop_repeating(repaired: &mut Repaired) {
    let count = repaired.retain(|_, corners| !repeats(corners));
    if count > 0 {
        repaired.notes.push(RepairNote::DroppedTriangles { count });
    }
}

pub(super) fn edges_of(surface: &Surface) -> EdgeTable {
    EdgeTable::new(&surface.triangles, surface.vertices.len())
}

/// Of several triangles with the same corners keeps the first.
pub(super) fn drop_duplicates(repaired: &mut Repaired) {
    let found = duplicates(&repaired.surface.triangles, &edges_of(&repaired.surface));
    if found.is_empty() {
        return;
    }
    // `found` is sorted by its first column, the duplicates
    let is_found = |t: usize| found.binary_search_by_key(&(t as u32), |&[triangle, _]| triangle).is_ok();
    let count = repaired.retain(|t, _| !is_found(t));
    repaired.notes.push(RepairNote::DroppedDuplicates { count });
}

fn twins_of(surface: &Surface) -> Result<Vec<u32>, TopologyError> {
    if surface.triangles.is_empty() {
        return Err(TopologyError::Empty);
    }
    let edges = edges_of(surface);
    check_edges(&surface.triangles, &edges)?;
    Ok(edges.twins())
}

/// Reverses triangles until neighbors agree; in each component, the minority.
pub(super) fn orient(repaired: &mut Repaired) -> Result<(), TopologyError> {
    let twins = twins_of(&repaired.surface)?;
    let triangles = &mut repaired.surface.triangles;
    let turned = turned(triangles, &twins)?;
    for (corners, _) in triangles.iter_mut().zip(&turned).filter(|(_, turned)| **turned) {
        corners.swap(1, 2);
    }
    let count = turned.iter().filter(|turned| **turned).count();
    if count > 0 {
        repaired.notes.push(RepairNote::Oriented { count });
    }
    Ok(())
}

/// Joins parts that meet in a line on which they do not have the same vertices, if the largest part grows. Where the parts
/// cannot be oriented, they stay.
fn join_parts(repaired: &mut Repaired) {
    let most = |surface: &Surface| {
        let (_, sizes) = components(&edges_of(surface), surface.triangles.len());
        sizes.iter().copied().max().unwrap_or(0)
    };
    let before = most(&repaired.surface);
    if before == repaired.surface.triangles.len() {
        return;
    }
    let mut joined = repaired.clone();
    merge_places(&mut joined);
    if orient(&mut joined).is_ok() {
        join_open(&mut joined);
        if most(&joined.surface) > before + joined.surface.triangles.len() - repaired.surface.triangles.len() {
            *repaired = joined;
        }
    }
}

/// Keeps the component with the most triangles, the first of equally large ones.
pub(super) fn keep_largest(repaired: &mut Repaired) {
    let surface = &repaired.surface;
    let (component, sizes) = components(&edges_of(surface), surface.triangles.len());
    let largest = largest(&sizes);
    let dropped = repaired.retain(|t, _| component[t] as usize == largest);
    if dropped > 0 {
        repaired.notes.push(RepairNote::KeptLargest { components: sizes.len(), dropped });
    }
}

/// Drops vertices in no triangle; indices must be in range.
pub(super) fn drop_unreferenced(repaired: &mut Repaired) {
    let Repaired { surface, vertex_origins, notes, .. } = repaired;
    let mut number = vec![ADDED; surface.vertices.len()];
    surface.triangles.iter().flatten().for_each(|&v| number[v as usize] = 0);
    let used: Vec<u32> = (0..number.len() as u32).filter(|&v| number[v as usize] == 0).collect();
    let count = number.len() - used.len();
    if count == 0 {
        return;
    }
    for (new, &old) in used.iter().enumerate() {
        number[old as usize] = new as u32;
    }
    surface.vertices = used.iter().map(|&v| surface.vertices[v as usize]).collect();
    surface.triangles.as_flattened_mut().iter_mut().for_each(|v| *v = number[*v as usize]);
    *vertex_origins = used.iter().map(|&v| vertex_origins[v as usize]).collect();
    notes.push(RepairNote::DroppedVertices { count });
}
