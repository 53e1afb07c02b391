//! Why a surface is not a disk, with the data needed to find the place.

use super::survey::{MAX_COORDINATE, MIN_EXTENT};
use crate::counted::counted;
use crate::mesh::{TriangleId, VertexId};
use std::fmt;

/// A boundary loop of a surface, as shown in messages.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct LoopReport {
    /// Number of its vertices, equal to that of its edges.
    pub vertices: usize,
    /// Length of the loop.
    pub length: f64,
    /// One of its vertices.
    pub first: VertexId,
}

/// Why a surface is not a disk. Triangles and vertices are counted from 0.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TopologyError {
    /// The surface has no triangles.
    #[error("the surface has no triangles")]
    Empty,
    /// A triangle names a vertex that does not exist.
    #[error("{}", counted!(
        *vertices,
        "triangle {triangle} names vertex {vertex}, but there is 1 vertex",
        "triangle {triangle} names vertex {vertex}, but there are {vertices} vertices"
    ))]
    IndexOutOfRange {
        /// Number of the triangle.
        triangle: TriangleId,
        /// The vertex that it names.
        vertex: VertexId,
        /// Number of vertices.
        vertices: usize,
    },
    /// Coordinates of triangles' vertices are NaN or infinite, or so large that areas overflow.
    #[error("{}", counted!(
        *count,
        "vertex {vertex} is at no finite place that can be dealt with (up to ±{MAX_COORDINATE:e})",
        "{count} vertices are at no finite place that can be dealt with (up to ±{MAX_COORDINATE:e}), the first is vertex \
         {vertex}"
    ))]
    NotFinite {
        /// The first such vertex.
        vertex: VertexId,
        /// Number of such vertices.
        count: usize,
    },
    /// The surface is so small that areas underflow.
    #[error("the surface is {extent:e} across: {MIN_EXTENT:e} at least can be dealt with")]
    TooSmall {
        /// The greatest distance of the vertices from the first one, along an axis.
        extent: f64,
    },
    /// Triangles that name a vertex twice.
    #[error("{}", counted!(
        *count,
        "triangle {triangle} {} names a vertex twice: drop it",
        "{count} triangles name a vertex twice, the first is triangle {triangle} {}: drop them",
        Bracketed(corners)
    ))]
    RepeatedCorner {
        /// The first such triangle.
        triangle: TriangleId,
        /// Its corners.
        corners: [VertexId; 3],
        /// Number of such triangles.
        count: usize,
    },
    /// Triangles without area.
    #[error("{}", counted!(
        *count,
        "triangle {triangle} {} has no area: merge its corners or drop it",
        "{count} triangles have no area, the first is triangle {triangle} {}: merge their corners or drop them",
        Bracketed(corners)
    ))]
    Degenerate {
        /// The first such triangle.
        triangle: TriangleId,
        /// Its corners.
        corners: [VertexId; 3],
        /// Number of such triangles.
        count: usize,
    },
    /// Triangles with the corners of an earlier one, of the same orientation or the other.
    #[error("{}", counted!(
        *count,
        "triangle {triangle} {} has the same corners as triangle {other}: drop it",
        "{count} triangles have the same corners as another one, the first is triangle {triangle} {}, as \
         triangle {other}: drop them",
        Bracketed(corners)
    ))]
    Duplicates {
        /// The first such triangle.
        triangle: TriangleId,
        /// Its corners.
        corners: [VertexId; 3],
        /// The earlier triangle with the same corners.
        other: TriangleId,
        /// Number of such triangles.
        count: usize,
    },
    /// Edges with three triangles or more.
    #[error("{}", counted!(
        *count,
        "the edge from vertex {} to {} has more than two triangles, {}: delete all but two",
        "{count} edges have more than two triangles, the first, from vertex {} to {}, the triangles {}: delete all but \
         two at each",
        edge[0],
        edge[1],
        Bracketed(triangles)
    ))]
    NonManifoldEdge {
        /// The ends of the first such edge.
        edge: [VertexId; 2],
        /// The triangles at that edge.
        triangles: Vec<TriangleId>,
        /// Number of such edges.
        count: usize,
    },
    /// Neighbors of different orientation, in a surface that can be oriented.
    #[error("{}", counted!(
        *count,
        "the edge from vertex {} to {} lies between triangles of different orientation, {} and {}: orient the surface \
         consistently",
        "{count} edges lie between triangles of different orientation, the first from vertex {} to {}, between the \
         triangles {} and {}: orient the surface consistently",
        edge[0],
        edge[1],
        triangles[0],
        triangles[1]
    ))]
    Orientation {
        /// The ends of the first such edge.
        edge: [VertexId; 2],
        /// The triangles at that edge.
        triangles: [TriangleId; 2],
        /// Number of such edges.
        count: usize,
    },
    /// The surface has one side only, like a Möbius strip.
    #[error(
        "the surface has one side only (as a Möbius strip): no orientation of triangle {triangle} fits, cut it \
             open"
    )]
    OneSided {
        /// A triangle at which two orientations meet.
        triangle: TriangleId,
    },
    /// Vertices at which several fans of triangles meet.
    #[error("{}", counted!(
        *count,
        "vertex {vertex} joins parts that share no edge, {fans} fans of triangles: give each its own vertex there",
        "{count} vertices join parts that share no edge, the first is vertex {vertex} with {fans} fans of triangles: give \
         each its own vertex there"
    ))]
    NonManifoldVertex {
        /// The first such vertex.
        vertex: VertexId,
        /// Number of fans at that vertex.
        fans: usize,
        /// Number of such vertices.
        count: usize,
    },
    /// More than one connected part.
    #[error(
        "the surface has {} components: keep the largest one (triangles: {}; the first outside of it is triangle {first})",
        .triangles.len(),
        Listed(.triangles)
    )]
    Components {
        /// Number of triangles in each part, largest first.
        triangles: Vec<usize>,
        /// The first triangle that is not in the largest part.
        first: TriangleId,
    },
    /// The surface has no boundary.
    #[error("the surface is closed (genus {genus}); it must have a boundary: cut it open")]
    Closed {
        /// Number of handles.
        genus: usize,
    },
    /// More than one boundary loop.
    #[error("the surface has {} boundary loops where a disk has one: fill all but the longest. These are the loops: {}", .loops.len(), Listed(.loops))]
    Loops {
        /// All loops, the longest first.
        loops: Vec<LoopReport>,
    },
    /// The surface has fewer boundary loops than asked for.
    #[error("the surface has {} boundary loops ({}), not {asked}", .loops.len(), Listed(.loops))]
    NoLoop {
        /// The number of the loop, counted from 1, the longest.
        asked: usize,
        /// All loops, the longest first.
        loops: Vec<LoopReport>,
    },
    /// A hole bounds no area, so that no triangles fill it.
    #[error("{}", counted!(
        *count,
        "a hole has no area, since its vertices lie in a line: join them ({hole})",
        "{count} holes have no area, since their vertices lie in a line: join them (the first: {hole})"
    ))]
    FlatHole {
        /// The boundary loop of the first such hole; its vertex is counted as in the surface.
        hole: LoopReport,
        /// Number of such holes.
        count: usize,
    },
    /// The surface has handles.
    #[error("{}", counted!(
        *genus,
        "the surface has 1 handle; a disk has none: cut it open",
        "the surface has {genus} handles; a disk has none: cut it open"
    ))]
    Genus {
        /// Number of handles.
        genus: usize,
    },
    /// Several kinds of faults, loops and handles being those of the largest part.
    #[error("the surface has {} kinds of faults: {}", .faults.len(), Numbered(.faults))]
    Several {
        /// One for each kind.
        faults: Vec<Self>,
    },
}

impl TopologyError {
    /// All these faults as one; `None` if there are none.
    pub(super) fn joined(mut faults: Vec<Self>) -> Option<Self> {
        if faults.len() > 1 { Some(Self::Several { faults }) } else { faults.pop() }
    }

    /// The same fault with other numbers of vertices and triangles.
    pub(super) fn renumbered(
        mut self,
        vertex: &dyn Fn(VertexId) -> VertexId,
        triangle: &dyn Fn(TriangleId) -> TriangleId,
    ) -> Self {
        self.vertices_mut().into_iter().for_each(|v| *v = vertex(*v));
        self.triangles_mut().into_iter().for_each(|t| *t = triangle(*t));
        self
    }

    /// The vertices that the message names.
    fn vertices_mut(&mut self) -> Vec<&mut VertexId> {
        match self {
            Self::NotFinite { vertex, .. } | Self::NonManifoldVertex { vertex, .. } => vec![vertex],
            Self::RepeatedCorner { corners, .. }
            | Self::Degenerate { corners, .. }
            | Self::Duplicates { corners, .. } => corners.iter_mut().collect(),
            Self::NonManifoldEdge { edge, .. } | Self::Orientation { edge, .. } => edge.iter_mut().collect(),
            Self::Loops { loops } | Self::NoLoop { loops, .. } => loops.iter_mut().map(|l| &mut l.first).collect(),
            Self::FlatHole { hole, .. } => vec![&mut hole.first],
            Self::Several { faults } => faults.iter_mut().flat_map(Self::vertices_mut).collect(),
            Self::Empty
            | Self::IndexOutOfRange { .. }
            | Self::TooSmall { .. }
            | Self::OneSided { .. }
            | Self::Components { .. }
            | Self::Closed { .. }
            | Self::Genus { .. } => Vec::new(),
        }
    }

    /// The triangles that the message names.
    fn triangles_mut(&mut self) -> Vec<&mut TriangleId> {
        match self {
            Self::IndexOutOfRange { triangle, .. }
            | Self::RepeatedCorner { triangle, .. }
            | Self::Degenerate { triangle, .. }
            | Self::OneSided { triangle }
            | Self::Components { first: triangle, .. } => vec![triangle],
            Self::Duplicates { triangle, other, .. } => vec![triangle, other],
            Self::NonManifoldEdge { triangles, .. } => triangles.iter_mut().collect(),
            Self::Orientation { triangles, .. } => triangles.iter_mut().collect(),
            Self::Several { faults } => faults.iter_mut().flat_map(Self::triangles_mut).collect(),
            Self::Empty
            | Self::NotFinite { .. }
            | Self::TooSmall { .. }
            | Self::NonManifoldVertex { .. }
            | Self::Closed { .. }
            | Self::Loops { .. }
            | Self::NoLoop { .. }
            | Self::FlatHole { .. }
            | Self::Genus { .. } => Vec::new(),
        }
    }
}

impl fmt::Display for LoopReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "length {:.4} with {} vertices at vertex {}", self.length, self.vertices, self.first)
    }
}

/// The largest number of items of a list that a message shows.
pub const LISTED: usize = 12;

/// Indices as a list in brackets: `[4, 4, 7]`.
pub(crate) struct Bracketed<'a, T>(pub(crate) &'a [T]);

impl<T: fmt::Display> fmt::Display for Bracketed<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, index) in self.0.iter().enumerate() {
            write!(f, "{}{index}", if k > 0 { ", " } else { "[" })?;
        }
        f.write_str("]")
    }
}

/// Sentences that are numbered from 1 and separated by semicolons.
struct Numbered<'a, T>(&'a [T]);

impl<T: fmt::Display> fmt::Display for Numbered<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, item) in self.0.iter().enumerate() {
            write!(f, "{}({}) {item}", if k > 0 { "; " } else { "" }, k + 1)?;
        }
        Ok(())
    }
}

struct Listed<'a, T>(&'a [T]);

impl<T: fmt::Display> fmt::Display for Listed<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, item) in self.0.iter().take(LISTED).enumerate() {
            write!(f, "{}{item}", if k > 0 { ", " } else { "" })?;
        }
        if self.0.len() > LISTED { write!(f, ", …") } else { Ok(()) }
    }
}
