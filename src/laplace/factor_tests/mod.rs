//! The multifrontal factor compared with faer's own on random Laplacians, and matrices without a Cholesky factor.

#![allow(clippy::unwrap_used, reason = "tests")]

mod refusals;
mod solutions;

use super::*;
use crate::geometry::DVec2;
use crate::test_random::runner;
use faer::linalg::solvers::Solve as _;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use proptest::prelude::*;
use proptest::sample::Index;
use spade::{DelaunayTriangulation, Point2, Triangulation as _};
use sprs::TriMatI;

/// A symmetric matrix: its diagonal, and its off-diagonal entries, each given once for both places.
#[derive(Debug, Clone)]
struct Symmetric {
    diagonal: Vec<f64>,
    entries: Vec<(usize, usize, f64)>,
}

impl Symmetric {
    /// The Laplacian of a graph with weighted `edges`; `grounds` are the weights of the edges to the boundary.
    fn laplacian(grounds: Vec<f64>, edges: &[(usize, usize, f64)]) -> Self {
        let mut matrix = Self { diagonal: grounds, entries: Vec::new() };
        for &(a, b, weight) in edges {
            matrix.diagonal[a] += weight;
            matrix.diagonal[b] += weight;
            matrix.entries.push((a, b, -weight));
        }
        matrix
    }

    fn len(&self) -> usize {
        self.diagonal.len()
    }

    fn triplets(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        let diagonal = self.diagonal.iter().enumerate().map(|(k, &value)| (k, k, value));
        diagonal.chain(self.entries.iter().map(|&(a, b, value)| (a.min(b), a.max(b), value)))
    }

    fn factor(&self) -> (Ordering, Result<Factor, LaplaceError>) {
        let n = self.len();
        let mut interior = TriMatI::<f64, u32>::new((n, n));
        self.triplets().for_each(|(row, column, value)| interior.add_triplet(row, column, value));
        let laplacian = DirichletLaplacian { interior: interior.to_csc(), coupling: TriMatI::new((n, 1)).to_csc() };
        let ordering = Ordering::minimum_degree(&laplacian).unwrap();
        (ordering.clone(), Factor::new(&laplacian, ordering, u64::MAX))
    }

    /// The solution by faer, in its own ordering; `None` if faer finds no factor.
    fn solution_by_faer(&self, right: &[f64]) -> Option<Vec<f64>> {
        let triplets: Vec<_> = self.triplets().map(|(row, column, value)| Triplet::new(row, column, value)).collect();
        let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(self.len(), self.len(), &triplets).unwrap();
        let solution = matrix.sp_cholesky(Side::Upper).ok()?.solve(&Mat::from_fn(self.len(), 1, |k, _| right[k]));
        Some((0..self.len()).map(|k| solution[(k, 0)]).collect())
    }
}

/// Weights over twelve orders of magnitude; every vertex has an edge to a previous one, and some have one to the
/// boundary.
fn graphs(vertices: std::ops::Range<usize>) -> impl Strategy<Value = Symmetric> {
    let weight = || (-6.0..6.0_f64).prop_map(|exponent| 10_f64.powf(exponent));
    let vertex = (any::<Index>(), weight(), prop_oneof![3 => Just(0.0), 1 => weight()]);
    let more = move |n: usize| prop::collection::vec((any::<Index>(), any::<Index>(), weight()), 0..2 * n);
    vertices.prop_flat_map(move |n| (prop::collection::vec(vertex.clone(), n), more(n), weight())).prop_map(
        |(vertices, more, ground)| {
            let n = vertices.len();
            let tree =
                vertices.iter().enumerate().skip(1).map(|(k, (parent, weight, _))| (parent.index(k), k, *weight));
            let more = more.iter().map(|(a, b, weight)| (a.index(n), b.index(n), *weight)).filter(|(a, b, _)| a != b);
            let mut grounds: Vec<f64> = vertices.iter().map(|(_, _, ground)| *ground).collect();
            grounds[0] += ground;
            Symmetric::laplacian(grounds, &tree.chain(more).collect::<Vec<_>>())
        },
    )
}

/// The cotangent Laplacian of the Delaunay triangulation of `points`, with their hull as the boundary.
fn delaunay(points: &[DVec2]) -> Symmetric {
    let mut triangulation = DelaunayTriangulation::<Point2<f64>>::new();
    for point in points {
        triangulation.insert(Point2::new(point.x, point.y)).unwrap();
    }
    let mut numbers = vec![Some(0); triangulation.num_vertices()];
    triangulation.convex_hull().for_each(|edge| numbers[edge.from().fix().index()] = None);
    let inner = numbers.iter_mut().flatten().enumerate().map(|(k, number)| *number = k).count();
    let (mut grounds, mut edges) = (vec![0.0; inner], Vec::new());
    for face in triangulation.inner_faces() {
        let corners = face.vertices().map(|v| (numbers[v.fix().index()], DVec2::new(v.position().x, v.position().y)));
        for [(_, apex), (a, from), (b, to)] in [0, 1, 2].map(|k| [0, 1, 2].map(|i| corners[(k + i) % 3])) {
            let (u, v) = (from - apex, to - apex);
            let weight = 0.5 * u.dot(v) / u.perp_dot(v);
            match (a, b) {
                (Some(a), Some(b)) => edges.push((a, b, weight)),
                (Some(inner), None) | (None, Some(inner)) => grounds[inner] += weight,
                (None, None) => {}
            }
        }
    }
    Symmetric::laplacian(grounds, &edges)
}

/// Points in a square, and points of a lattice, which has many cocircular quadruples.
fn meshes() -> impl Strategy<Value = Symmetric> {
    let anywhere = prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64).prop_map(DVec2::from), 3..600);
    let lattice = prop::collection::vec((0..24_u8, 0..24_u8), 3..600);
    let lattice = lattice
        .prop_map(|points| points.into_iter().map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) / 7.0).collect());
    prop_oneof![anywhere, lattice].prop_map(|points: Vec<DVec2>| delaunay(&points))
}
