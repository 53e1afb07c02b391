//! The connectivity of a surface: all faults of its topology, and its loops, components, genus.
//!
//! The order of the checks matters: each relies on what the earlier ones have established.
//! For example, loops are walked only where every edge has at most two triangles of equal orientation.

use super::duplicates::duplicates;
use super::edges::{EdgeTable, NO_TWIN, ends};
use super::orient::turned;
use super::{LoopReport, Surface, TopologyError};
use crate::geometry::{DVec3, sort_by_number};
use crate::mesh::{TriangleId, VertexId};

/// Areas are computed from fourth powers, which overflow beyond 1e77; no real object has such a size.
pub const MAX_COORDINATE: f64 = 1e75;

/// The least extent: fourth powers underflow below 1e-81, and triangles can be 1e-7 of a surface, or smaller.
pub const MIN_EXTENT: f64 = 1e-70;

/// A triangle whose height is less than this part of its longest edge is flat: its coordinates do not
/// determine its angles. Coordinates of f32 files err by 1e-7, and their thinnest triangles have 1e-6;
/// a collinear triple computed in f64 has 1e-16.
const FLAT: f64 = 1e-12;

/// The component of a triangle that has no number yet.
const UNNUMBERED: u32 = u32::MAX;

/// The connectivity of a manifold, consistently oriented surface.
#[derive(Debug)]
pub(super) struct Connectivity {
    /// For each half-edge `3t + i` the other one, or [`NO_TWIN`] at the boundary.
    pub twins: Vec<u32>,
    /// The boundary loops in the direction of their triangles, the longest first.
    pub loops: Vec<Vec<u32>>,
    /// The component of each triangle.
    pub component: Vec<u32>,
    /// The number of triangles of each component.
    pub sizes: Vec<usize>,
}

/// Checks the indices and positions alone.
pub(super) fn check_values(surface: &Surface) -> Result<(), TopologyError> {
    check_indices(surface)?;
    check_places(surface)
}

/// Checks the indices alone.
pub(super) fn check_indices(surface: &Surface) -> Result<(), TopologyError> {
    let vertices = surface.vertices.len();
    if surface.triangles.is_empty() {
        return Err(TopologyError::Empty);
    }
    let corners = surface.triangles.as_flattened();
    if let Some(k) = corners.iter().position(|&v| v as usize >= vertices) {
        return Err(TopologyError::IndexOutOfRange {
            triangle: TriangleId::new(k as u32 / 3),
            vertex: VertexId::new(corners[k]),
            vertices,
        });
    }
    Ok(())
}

/// Whether a place is finite and no area there overflows.
pub(crate) fn is_sound(place: DVec3) -> bool {
    place.abs().max_element() <= MAX_COORDINATE && place.is_finite()
}

/// Checks the positions of the vertices of triangles, whose indices are checked.
pub(super) fn check_places(surface: &Surface) -> Result<(), TopologyError> {
    let corners = surface.triangles.as_flattened();
    if corners.iter().any(|&v| !is_sound(surface.vertices[v as usize])) {
        let mut astray: Vec<u32> =
            corners.iter().copied().filter(|&v| !is_sound(surface.vertices[v as usize])).collect();
        astray.sort_unstable();
        astray.dedup();
        return Err(TopologyError::NotFinite { vertex: VertexId::new(astray[0]), count: astray.len() });
    }
    // if the extent is 0, the triangles are reported as flat later
    let first = surface.vertices[corners[0] as usize];
    let offsets = corners.iter().map(|&v| (surface.vertices[v as usize] - first).abs().max_element());
    match offsets.fold(0.0, f64::max) {
        extent if extent > 0.0 && extent < MIN_EXTENT => Err(TopologyError::TooSmall { extent }),
        _ => Ok(()),
    }
}

/// Whether a triangle names a vertex twice.
pub(crate) fn repeats(&[a, b, c]: &[u32; 3]) -> bool {
    a == b || b == c || c == a
}

/// The first triangle that is wrong, its corners, and the number of all that are.
fn first_of(triangles: &[[u32; 3]], wrong: impl Fn(&[u32; 3]) -> bool) -> Option<(TriangleId, [VertexId; 3], usize)> {
    let triangle = triangles.iter().position(&wrong)?;
    let count = triangles.iter().filter(|t| wrong(t)).count();
    Some((TriangleId::new(triangle as u32), triangles[triangle].map(VertexId::new), count))
}

/// Checks that no triangle names a vertex twice.
pub(super) fn check_repeats(surface: &Surface) -> Result<(), TopologyError> {
    match first_of(&surface.triangles, repeats) {
        Some((triangle, corners, count)) => Err(TopologyError::RepeatedCorner { triangle, corners, count }),
        None => Ok(()),
    }
}

/// Checks that triangles have an area.
pub(super) fn check_areas(surface: &Surface) -> Result<(), TopologyError> {
    match first_of(&surface.triangles, |corners| has_no_area(surface, corners)) {
        Some((triangle, corners, count)) => Err(TopologyError::Degenerate { triangle, corners, count }),
        None => Ok(()),
    }
}

/// Whether a triangle has no area, for no other reason than that its three corners lie in a line.
pub(super) fn has_no_area(surface: &Surface, corners: &[u32; 3]) -> bool {
    let places = corners.map(|v| surface.vertices[v as usize]);
    !repeats(corners) && is_flat(places) && places.into_iter().all(is_sound)
}

/// Whether the corners of a triangle lie in a line, or so nearly that its angles are not determined.
pub(super) fn is_flat([a, b, c]: [DVec3; 3]) -> bool {
    let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    let double_area = (b - a).cross(c - a).length();
    double_area.is_nan() || double_area <= FLAT * longest
}

/// Checks that no two triangles have the same corners.
pub(super) fn check_duplicates(triangles: &[[u32; 3]], edges: &EdgeTable) -> Result<(), TopologyError> {
    let found = duplicates(triangles, edges);
    let Some([triangle, other]) = found.first().map(|pair| pair.map(TriangleId::new)) else { return Ok(()) };
    let corners = triangles[triangle.index()].map(VertexId::new);
    Err(TopologyError::Duplicates { triangle, corners, other, count: found.len() })
}

/// Checks that every edge has at most two triangles.
pub(super) fn check_edges(triangles: &[[u32; 3]], edges: &EdgeTable) -> Result<(), TopologyError> {
    let mut crowded = edges.edges().filter(|edge| edge.len() > 2);
    let Some(first) = crowded.next() else { return Ok(()) };
    let mut at: Vec<TriangleId> = first.iter().map(|&(_, half)| TriangleId::new(half / 3)).collect();
    at.sort_unstable();
    let mut edge = ends(triangles, first[0].1).map(VertexId::new);
    edge.sort_unstable();
    Err(TopologyError::NonManifoldEdge { edge, triangles: at, count: 1 + crowded.count() })
}

/// The half-edges, each with its other one, that neighboring triangles traverse in the same direction.
pub(super) fn disoriented(triangles: &[[u32; 3]], twins: &[u32]) -> impl Iterator<Item = (u32, u32)> {
    let halves = (0..twins.len() as u32).zip(twins.iter().copied());
    let inner = halves.filter(|&(half, twin)| twin != NO_TWIN && half < twin);
    inner.filter(|&(half, twin)| ends(triangles, half) == ends(triangles, twin))
}

/// Checks that neighboring triangles traverse their common edge in opposite directions.
pub(super) fn check_orientation(triangles: &[[u32; 3]], twins: &[u32]) -> Result<(), TopologyError> {
    let mut wrong = disoriented(triangles, twins);
    let Some((half, twin)) = wrong.next() else { return Ok(()) };
    turned(triangles, twins)?; // the error of a one-sided surface, which has no orientation
    let edge = ends(triangles, half).map(VertexId::new);
    let triangles = [half / 3, twin / 3].map(TriangleId::new);
    Err(TopologyError::Orientation { edge, triangles, count: 1 + wrong.count() })
}

/// Checks that the triangles at each vertex form one fan, open or closed.
pub(super) fn check_vertices(fans: &[u32]) -> Result<(), TopologyError> {
    let Some(vertex) = fans.iter().position(|&count| count > 1) else { return Ok(()) };
    let count = fans.iter().filter(|&&count| count > 1).count();
    Err(TopologyError::NonManifoldVertex { vertex: VertexId::new(vertex as u32), fans: fans[vertex] as usize, count })
}

/// The number of fans of triangles of any orientation, open or closed, at each vertex; 0 at the ends of edges of more than two
/// triangles, where fans are not determined.
pub(super) fn fans(triangles: &[[u32; 3]], edges: &EdgeTable, twins: &[u32], vertices: usize) -> Vec<u32> {
    let mut fans = vec![0_u32; vertices];
    let mut visited = vec![false; twins.len()];
    for corner in 0..twins.len() {
        if !visited[corner] {
            fans[triangles[corner / 3][corner % 3] as usize] += 1;
            visit_fan(triangles, twins, corner, &mut visited, &mut |_| {});
        }
    }
    for edge in edges.edges().filter(|edge| edge.len() > 2) {
        for v in ends(triangles, edge[0].1) {
            fans[v as usize] = 0;
        }
    }
    fans
}

/// Visits the corners around the vertex of `corner` that are reached across edges, this one first. Triangles may have any
/// orientation.
pub(super) fn visit_fan(
    triangles: &[[u32; 3]],
    twins: &[u32],
    corner: usize,
    visited: &mut [bool],
    visit: &mut dyn FnMut(usize),
) {
    visited[corner] = true;
    visit(corner);
    let (first, i) = (corner / 3, corner % 3);
    let vertex = triangles[first][i];
    // corner i lies between the half-edges i+1 (behind it) and i+2 (before it)
    for mut half in [1, 2].map(|turn| 3 * first + (i + turn) % 3) {
        while twins[half] != NO_TWIN {
            let (other, from) = (twins[half] as usize / 3, twins[half] as usize % 3);
            let mut ends = [1, 2].into_iter().map(|turn| (from + turn) % 3);
            let Some(at) = ends.find(|&k| triangles[other][k] == vertex) else { break };
            if std::mem::replace(&mut visited[3 * other + at], true) {
                break;
            }
            visit(3 * other + at);
            // the third half-edge of a triangle, neither the one that was crossed nor the one opposite to the vertex
            half = 3 * other + (3 - at - from);
        }
    }
}

/// The component of each triangle, and their sizes. Triangles with a common edge belong together, however many they are;
/// those that share only a vertex are in different components.
pub(super) fn components(edges: &EdgeTable, triangles: usize) -> (Vec<u32>, Vec<usize>) {
    let mut into: Vec<u32> = (0..triangles as u32).collect();
    for edge in edges.edges() {
        for pair in edge.windows(2) {
            let [a, b] = [pair[0].1 / 3, pair[1].1 / 3].map(|t| root(&mut into, t));
            into[a.max(b) as usize] = a.min(b);
        }
    }
    let mut number = vec![UNNUMBERED; triangles];
    let mut sizes = Vec::new();
    let mut component = Vec::with_capacity(triangles);
    for t in 0..triangles as u32 {
        let root = root(&mut into, t) as usize;
        if number[root] == UNNUMBERED {
            number[root] = sizes.len() as u32;
            sizes.push(0);
        }
        component.push(number[root]);
        sizes[number[root] as usize] += 1;
    }
    (component, sizes)
}

/// The number of the largest component, the first of equally large ones.
pub(super) fn largest(sizes: &[usize]) -> usize {
    (0..sizes.len()).max_by_key(|&k| (sizes[k], std::cmp::Reverse(k))).unwrap_or(0)
}

/// Checks that there is one component; each triangle is in that with the number in `component`.
pub(super) fn check_components(component: &[u32], sizes: &[usize]) -> Result<(), TopologyError> {
    let largest = largest(sizes);
    let Some(first) = component.iter().position(|&number| number as usize != largest) else { return Ok(()) };
    let mut triangles = sizes.to_vec();
    sort_by_number(&mut triangles, |&count| -(count as f64));
    Err(TopologyError::Components { triangles, first: TriangleId::new(first as u32) })
}

/// The first of the ones with which `v` is merged, with shorter ways to it for the next time.
pub(super) fn root(into: &mut [u32], mut v: u32) -> u32 {
    while into[v as usize] != v {
        into[v as usize] = into[into[v as usize] as usize];
        v = into[v as usize];
    }
    v
}

/// The boundary loops in the direction of their triangles, the longest first; at every vertex
/// there must be at most one boundary edge that begins there.
fn loops(surface: &Surface, twins: &[u32]) -> Vec<Vec<u32>> {
    let mut next = vec![None; surface.vertices.len()];
    for (half, _) in twins.iter().enumerate().filter(|(_, twin)| **twin == NO_TWIN) {
        let [u, v] = ends(&surface.triangles, half as u32);
        next[u as usize] = Some(v);
    }
    let mut loops = chains(next);
    sort_by_number(&mut loops, |vertices| -loop_length(&surface.vertices, vertices));
    loops
}

/// The closed chains of vertices in which each is followed by its `next`, each from its least vertex on.
pub(super) fn chains(mut next: Vec<Option<u32>>) -> Vec<Vec<u32>> {
    let count = next.len() as u32;
    let follow = |start: u32| {
        let mut chain = Vec::new();
        let mut at = start;
        while let Some(after) = next[at as usize].take() {
            chain.push(at);
            at = after;
        }
        chain
    };
    (0..count).map(follow).filter(|chain| !chain.is_empty()).collect()
}

/// The length of a closed chain of vertices at these positions.
pub(super) fn loop_length(positions: &[DVec3], vertices: &[u32]) -> f64 {
    let at = |v: u32| positions[v as usize];
    let next = vertices.iter().cycle().skip(1);
    vertices.iter().zip(next).map(|(&u, &v)| at(u).distance(at(v))).sum()
}

/// Checks every local property, then computes the connectivity.
pub(super) fn connectivity(surface: &Surface) -> Result<Connectivity, TopologyError> {
    check_values(surface)?;
    check_repeats(surface)?;
    check_areas(surface)?;
    connected(surface)
}

/// As [`connectivity`], whatever the shape of the triangles, which name three vertices each.
pub(super) fn connected(surface: &Surface) -> Result<Connectivity, TopologyError> {
    let Surface { vertices, triangles, .. } = surface;
    let edges = EdgeTable::new(triangles, vertices.len());
    check_duplicates(triangles, &edges)?;
    check_edges(triangles, &edges)?;
    let twins = edges.twins();
    check_orientation(triangles, &twins)?;
    check_vertices(&fans(triangles, &edges, &twins, vertices.len()))?;
    let loops = loops(surface, &twins);
    let (component, sizes) = components(&edges, triangles.len());
    Ok(Connectivity { twins, loops, component, sizes })
}

impl Connectivity {
    /// Checks for one component, one loop, no handle. Vertices in no triangle do not matter.
    pub(super) fn check_disk(&self, surface: &Surface) -> Result<(), TopologyError> {
        check_components(&self.component, &self.sizes)?;
        self.faults_of_whole(surface).into_iter().next().map_or(Ok(()), Err)
    }

    /// Why a surface of one component is no disk: it is closed, or has handles or several loops.
    pub(super) fn faults_of_whole(&self, surface: &Surface) -> Vec<TopologyError> {
        let genus = self.genus(used(surface).into_iter().filter(|used| *used).count());
        if self.loops.is_empty() {
            return vec![TopologyError::Closed { genus }];
        }
        let handles = (genus > 0).then_some(TopologyError::Genus { genus });
        let loops = || TopologyError::Loops { loops: self.loops.iter().map(|l| report(surface, l)).collect() };
        handles.into_iter().chain((self.loops.len() > 1).then(loops)).collect()
    }

    /// The genus g of a connected surface with b loops, from V − E + F = 2 − 2g − b.
    fn genus(&self, vertices: usize) -> usize {
        let halves = self.twins.len();
        let boundary = self.twins.iter().filter(|&&twin| twin == NO_TWIN).count();
        let (faces, edges) = (halves / 3, halves.midpoint(boundary));
        (2 + edges).saturating_sub(vertices + faces + self.loops.len()) / 2
    }
}

/// Whether each vertex is in a triangle.
pub(super) fn used(surface: &Surface) -> Vec<bool> {
    let mut used = vec![false; surface.vertices.len()];
    surface.triangles.iter().flatten().for_each(|&v| used[v as usize] = true);
    used
}

pub(super) fn report(surface: &Surface, vertices: &[u32]) -> LoopReport {
    LoopReport {
        vertices: vertices.len(),
        length: loop_length(&surface.vertices, vertices),
        first: VertexId::new(vertices[0]),
    }
}
