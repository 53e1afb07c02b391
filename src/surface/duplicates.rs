//! Finds triangles that have the same three corners as another one, of either orientation.

use super::edges::{EdgeTable, ends};

/// Pairs of a duplicate and the first triangle with the same corners, ordered by the duplicates. No triangle may
/// name a vertex twice. Cost O(n log d) for n triangles, d at an edge.
pub(super) fn duplicates(triangles: &[[u32; 3]], edges: &EdgeTable) -> Vec<[u32; 2]> {
    let (mut found, mut over_edge) = (Vec::new(), Vec::new());
    for edge in edges.edges().filter(|edge| edge.len() > 1) {
        // every triangle is considered once, at the edge opposite to its least corner
        let least = ends(triangles, edge[0].1).into_iter().min().unwrap_or_default();
        let corner = |half: u32| triangles[half as usize / 3][half as usize % 3];
        over_edge.clear();
        over_edge.extend(edge.iter().map(|&(_, half)| (corner(half), half / 3)).filter(|(v, _)| *v < least));
        over_edge.sort_unstable();
        for same in over_edge.chunk_by(|a, b| a.0 == b.0) {
            found.extend(same[1..].iter().map(|&(_, triangle)| [triangle, same[0].1]));
        }
    }
    found.sort_unstable();
    found
}
