//! Which triangles share an edge, for any set of triangles, manifold or not.
//!
//! Half-edge `3t + i` is the edge of triangle t opposite to its corner i, from corner i+1 to corner i+2.

/// The other half-edge of one at the boundary, or at an edge of more than two triangles.
pub(super) const NO_TWIN: u32 = u32::MAX;

/// The edges between the same two vertices, as half-edges.
#[derive(Debug)]
pub(super) struct EdgeTable {
    /// (larger vertex, half-edge), grouped by the smaller vertex and sorted.
    grouped: Vec<(u32, u32)>,
    /// Where the group of each smaller vertex begins in `grouped`.
    starts: Vec<u32>,
}

/// The ends of a half-edge, in its direction.
pub(super) fn ends(triangles: &[[u32; 3]], half: u32) -> [u32; 2] {
    let (corners, i) = (triangles[half as usize / 3], half as usize % 3);
    [corners[(i + 1) % 3], corners[(i + 2) % 3]]
}

impl EdgeTable {
    /// Builds the table; all indices must be below `vertices`. Cost O(n log d) for n triangles, d at a vertex.
    pub(super) fn new(triangles: &[[u32; 3]], vertices: usize) -> Self {
        let halves = 0..3 * triangles.len() as u32;
        let mut starts = vec![0_u32; vertices + 1];
        for half in halves.clone() {
            let [u, v] = ends(triangles, half);
            starts[u.min(v) as usize + 1] += 1;
        }
        for k in 0..vertices {
            starts[k + 1] += starts[k];
        }
        let mut places = starts.clone();
        let mut grouped = vec![(0, 0); halves.len()];
        for half in halves {
            let [u, v] = ends(triangles, half);
            let place = &mut places[u.min(v) as usize];
            grouped[*place as usize] = (u.max(v), half);
            *place += 1;
        }
        for pair in starts.windows(2) {
            grouped[pair[0] as usize..pair[1] as usize].sort_unstable();
        }
        Self { grouped, starts }
    }

    /// For each edge its half-edges as `(larger vertex, half-edge)`, in a fixed order.
    pub(super) fn edges(&self) -> impl Iterator<Item = &[(u32, u32)]> {
        let groups = self.starts.windows(2).map(|pair| &self.grouped[pair[0] as usize..pair[1] as usize]);
        groups.flat_map(|group| group.chunk_by(|a, b| a.0 == b.0))
    }

    /// For each half-edge the other one of its edge if there are exactly two, else [`NO_TWIN`].
    pub(super) fn twins(&self) -> Vec<u32> {
        let mut twins = vec![NO_TWIN; self.grouped.len()];
        for edge in self.edges() {
            if let &[(_, a), (_, b)] = edge {
                (twins[a as usize], twins[b as usize]) = (b, a);
            }
        }
        twins
    }
}
