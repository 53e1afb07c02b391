//! A hierarchical factor of I + K° R for many unknowns: recursive skeletonization.
//!
//! Nodes are gathered in clusters. What a cluster does to the others, and they to it, passes
//! through a few of its nodes, its skeleton: the rows and columns of K between the cluster and everything outside of a
//! circle around it are those of sources on this circle, so that the skeleton is chosen from the interactions with the
//! circle and with the nodes inside of it. The equation then holds on the skeletons alone, whose clusters are merged in
//! pairs, and so on until one cluster is left. Martinsson and Rokhlin, J. Comput. Phys. 205 (2005) 1; Gillman, Young and
//! Martinsson, Front. Math. China 7 (2012) 217 (the matrices G, E and F); Ho and Greengard, SIAM J. Sci. Comput. 34
//! (2012) A2507 (the circle).
//!
//! Time and memory grow in proportion to the unknowns on curves that fill no area.

use super::corner::{PlacedBlock, add_identity};
use super::entries::Entries;
use super::factor::DenseFactor;
#[cfg(feature = "io")]
use super::factor::{FlatFactor, is_permutation};
use super::legendre::NODES;
use super::skeleton::skeleton;

use crate::geometry::DVec2;
use faer::Mat;
use faer::linalg::solvers::{DenseSolveCore as _, PartialPivLu};
use std::f64::consts::{FRAC_1_PI, TAU};
use std::ops::Range;

/// The nodes of a cluster on the curve, up to which blocks and panels are gathered.
const LEAF: usize = 64;
/// The radius of the circle that stands for everything outside of it, in radii of the cluster.
const GROW: f64 = 1.75;
/// The points of the circle.
const PROXIES: usize = 96;
/// What a skeleton leaves of its cluster's interactions, in shares of the largest one.
const TOLERANCE: f64 = 1e-13;

/// The largest growth of a factor along the curve that is trusted: 1 for coasts, maple leaves and hands, 1300 for the spiral.
const MOST_GROWTH: f64 = 30.0;
/// The largest rank of a cluster along the curve: 250 to 320 for coasts and maple leaves, 560 and 1050 for combs of 50 and 100
/// teeth, with the back across a channel from all of them; by place, both combs have 420 to 460.
const MOST_RANK: usize = 600;

/// x = G b + E y for a cluster, y the solution on its skeleton, whose right side is F b.
#[derive(Debug, Clone)]
struct Eliminated {
    /// G beside E: a row for each node of the cluster.
    inner: Mat<f64>,
    /// F.
    restrict: Mat<f64>,
}

impl Eliminated {
    /// The stored numbers.
    fn len(&self) -> usize {
        self.inner.nrows() * self.inner.ncols() + self.restrict.nrows() * self.restrict.ncols()
    }
}

/// Why there is no factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// Clusters that are gathered like this are nearly singular, or have too many interactions.
    Unsuited,
    /// The factor takes too much memory.
    TooLarge,
}

/// What a factor may take.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    /// The largest number above the curve, in those on the curve.
    growth: f64,
    /// The largest rank of a cluster.
    rank: usize,
    megabytes: usize,
}

const NUMBERS_PER_MB: usize = 1_000_000 / size_of::<f64>();

/// A factored matrix.
#[derive(Debug, Clone)]
pub struct HierarchicalFactor {
    /// The nodes in the order of the clusters.
    order: Vec<u32>,
    /// The clusters of each level, from the curve upwards.
    levels: Vec<Vec<Eliminated>>,
    top: DenseFactor,
}

/// A cluster that is still to be eliminated.
struct Cluster {
    nodes: Vec<usize>,
    /// The diagonal block of the matrix.
    diagonal: Mat<f64>,
    /// The weights times R on the curve; `None` above, where the columns are those of skeletons.
    outgoing: Option<Mat<f64>>,
}

impl HierarchicalFactor {
    /// Compresses and factors the matrix in at most `limit_mb` megabytes, with clusters along the curve.
    ///
    /// The matrix of a wall that nearly surrounds a place, without the rest of the curve, is that of the place's exterior,
    /// which is singular, and a cluster that lies across a channel from many others has too many interactions with them:
    /// both are refused as unsuited.
    pub fn along(entries: &Entries<'_>, blocks: &[PlacedBlock], limit_mb: usize) -> Result<Self, Refusal> {
        let bounds = Bounds { growth: MOST_GROWTH, rank: MOST_RANK, megabytes: limit_mb };
        Self::gathered(entries, leaves(entries, blocks, Gathering::Along), bounds)
    }

    /// Compresses and factors the matrix, with both walls of a channel in one cluster.
    pub fn by_place(entries: &Entries<'_>, blocks: &[PlacedBlock], limit_mb: usize) -> Result<Self, Refusal> {
        let bounds = Bounds { growth: f64::INFINITY, rank: usize::MAX, megabytes: limit_mb };
        Self::gathered(entries, leaves(entries, blocks, Gathering::ByPlace), bounds)
    }

    fn gathered(entries: &Entries<'_>, mut clusters: Vec<Cluster>, bounds: Bounds) -> Result<Self, Refusal> {
        let order = clusters.iter().flat_map(|cluster| &cluster.nodes).map(|&node| node as u32).collect();
        let (mut levels, mut on_curve, mut numbers) = (Vec::new(), None, 0);
        while clusters.len() > 1 {
            let neighborhood = Neighborhood::new(entries, &clusters);
            let (mut level, mut rest) = (Vec::with_capacity(clusters.len()), Vec::with_capacity(clusters.len()));
            for (k, cluster) in clusters.iter().enumerate() {
                let (inner, outer) = eliminated(entries, &neighborhood, k, cluster);
                numbers += inner.len();
                if numbers > bounds.megabytes * NUMBERS_PER_MB {
                    return Err(Refusal::TooLarge);
                }
                if inner.restrict.nrows() > bounds.rank {
                    return Err(Refusal::Unsuited);
                }
                level.push(inner);
                rest.push(outer);
            }
            let largest = level.iter().map(|cluster| cluster.inner.norm_max()).fold(0.0, f64::max);
            levels.push(level);
            if largest > bounds.growth * *on_curve.get_or_insert(largest) {
                return Err(Refusal::Unsuited);
            }
            clusters = merged(entries, rest);
        }
        let top = DenseFactor::new(&clusters.pop().map_or_else(Mat::new, |cluster| cluster.diagonal));
        Ok(Self { order, levels, top })
    }

    /// A⁻¹ times `right`. Two multiply-adds for each stored number.
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut sides: Vec<Vec<f64>> = vec![self.order.iter().map(|&node| right[node as usize]).collect()];
        for level in &self.levels {
            let mut next = vec![0.0; level.iter().map(|cluster| cluster.restrict.nrows()).sum()];
            let (mut b, mut y) = (&sides[sides.len() - 1][..], &mut next[..]);
            for Eliminated { restrict, .. } in level {
                let (own, outgoing);
                (own, b) = b.split_at(restrict.ncols());
                (outgoing, y) = y.split_at_mut(restrict.nrows());
                add_product(outgoing, restrict, 0, own);
            }
            sides.push(next);
        }
        let mut y = self.top.solve(&sides.pop().unwrap_or_default());
        for level in self.levels.iter().rev() {
            let right = sides.pop().unwrap_or_default();
            let mut next = vec![0.0; right.len()];
            let (mut b, mut skeletons, mut x) = (&right[..], &y[..], &mut next[..]);
            for Eliminated { inner, restrict } in level {
                let (own, skeleton, solved);
                (own, b) = b.split_at(restrict.ncols());
                (skeleton, skeletons) = skeletons.split_at(restrict.nrows());
                (solved, x) = x.split_at_mut(inner.nrows());
                add_product(solved, inner, 0, own);
                add_product(solved, inner, own.len(), skeleton);
            }
            y = next;
        }
        let mut solution = vec![0.0; y.len()];
        self.order.iter().zip(y).for_each(|(&node, value)| solution[node as usize] = value);
        solution
    }
}

#[cfg(feature = "io")]
impl HierarchicalFactor {
    /// The number of unknowns.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// The factor as flat arrays: the number of levels, that of nodes, their order, for each level the number of its
    /// clusters and the sizes and ranks of these, then the order of the top; the matrices of each level in one array.
    pub fn to_flat(&self) -> FlatFactor {
        let mut integers = vec![self.levels.len() as u32, self.order.len() as u32];
        integers.extend(&self.order);
        let mut floats = Vec::new();
        for level in &self.levels {
            integers.push(level.len() as u32);
            let matrices = || level.iter().flat_map(|cluster| [&cluster.inner, &cluster.restrict]);
            integers.extend(level.iter().flat_map(|c| [c.restrict.ncols() as u32, c.restrict.nrows() as u32]));
            floats.push(matrices().flat_map(|m| (0..m.ncols()).flat_map(|j| m.col_as_slice(j))).copied().collect());
        }
        let (values, rows) = self.top.arrays();
        floats.push(values.to_vec());
        integers.extend(rows);
        FlatFactor { floats, integers }
    }

    /// The factor from flat arrays; `None` unless their sizes fit each other and their numbers are finite.
    pub fn from_flat(FlatFactor { floats, integers }: FlatFactor) -> Option<Self> {
        let mut integers = integers.into_iter();
        let (levels, count) = (integers.next()? as usize, integers.next()? as usize);
        let order: Vec<u32> = integers.by_ref().take(count).collect();
        if order.len() != count || !is_permutation(&order) || floats.len() != levels.checked_add(1)? {
            return None;
        }
        let mut floats = floats.into_iter();
        let mut unknowns = count;
        let mut read = Vec::new();
        for values in floats.by_ref().take(levels) {
            let clusters = integers.next()? as usize;
            let sizes: Vec<u32> = integers.by_ref().take(clusters.checked_mul(2)?).collect();
            let (level, skeletons) = level_of(&values, &sizes, clusters, unknowns)?;
            read.push(level);
            unknowns = skeletons;
        }
        let top = DenseFactor::from_arrays(floats.next()?, integers.collect())?;
        (top.len() == unknowns).then_some(Self { order, levels: read, top })
    }
}

/// The clusters of a level with these sizes and ranks, and how many unknowns they leave of `unknowns`.
#[cfg(feature = "io")]
fn level_of(values: &[f64], sizes: &[u32], clusters: usize, unknowns: usize) -> Option<(Vec<Eliminated>, usize)> {
    let (sizes, []) = sizes.as_chunks::<2>() else { return None };
    let sum = |k: usize| sizes.iter().try_fold(0_usize, |sum, size| sum.checked_add(size[k] as usize));
    if sizes.len() != clusters || sum(0)? != unknowns || !values.iter().all(|value| value.is_finite()) {
        return None;
    }
    let mut rest = values;
    let mut matrix = |rows: usize, columns: usize| {
        let own = rest.split_off(..rows.checked_mul(columns)?)?;
        Some(Mat::from_fn(rows, columns, |i, j| own[j * rows + i]))
    };
    let read = |&[n, rank]: &[u32; 2]| {
        let [n, rank] = [n as usize, rank as usize];
        Some(Eliminated { inner: matrix(n, n.checked_add(rank)?)?, restrict: matrix(rank, n)? })
    };
    let level = sizes.iter().map(read).collect::<Option<Vec<_>>>()?;
    Some((level, sum(1)?)).filter(|_| rest.is_empty())
}

/// y ← y + A x, with the columns of A from `first` on.
fn add_product(y: &mut [f64], matrix: &Mat<f64>, first: usize, x: &[f64]) {
    for (j, x) in x.iter().enumerate() {
        y.iter_mut().zip(matrix.col_as_slice(first + j)).for_each(|(y, a)| *y += a * x);
    }
}

/// How blocks and panels are gathered in clusters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Gathering {
    /// In the order of the curve: few nodes of a cluster see anything outside of it.
    Along,
    /// By their places: both walls of a channel, which are far from each other along the curve, are in one cluster.
    ByPlace,
}

/// Clusters of whole blocks and panels, in an order in which neighboring pairs, pairs of pairs and so on lie together.
fn leaves(entries: &Entries<'_>, blocks: &[PlacedBlock], gathering: Gathering) -> Vec<Cluster> {
    let count = entries.len() / NODES;
    let place = |atom: &Range<usize>| {
        let nodes = atom.clone().map(|panel| entries.place(panel % count * NODES + NODES / 2));
        nodes.sum::<DVec2>() / atom.len() as f64
    };
    let mut atoms: Vec<(DVec2, Range<usize>)> = entries.atoms().into_iter().map(|atom| (place(&atom), atom)).collect();
    let depth = (entries.len() as f64 / LEAF as f64).log2().ceil().max(0.0) as u32;
    let mut groups = Vec::new();
    bisect(&mut atoms, gathering, depth, &mut groups);
    groups.iter().map(|atoms| leaf(entries, blocks, atoms)).collect()
}

/// Divides atoms into 2^depth groups of about as many nodes; by place, across the longer extent of each part.
fn bisect(atoms: &mut [(DVec2, Range<usize>)], gathering: Gathering, depth: u32, groups: &mut Vec<Vec<Range<usize>>>) {
    if depth == 0 || atoms.len() < 2 {
        groups.push(atoms.iter().map(|(_, atom)| atom.clone()).collect());
        return;
    }
    if gathering == Gathering::ByPlace {
        let bounds = |(a, b): (DVec2, DVec2), (p, _): &(DVec2, _)| (a.min(*p), b.max(*p));
        let (low, high) = atoms.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), bounds);
        let axis = usize::from(high.y - low.y > high.x - low.x);
        atoms.sort_by(|(p, a), (q, b)| p[axis].total_cmp(&q[axis]).then(a.start.cmp(&b.start)));
    }
    let size = |atoms: &[(DVec2, Range<usize>)]| atoms.iter().map(|(_, atom)| atom.len()).sum::<usize>();
    let half = size(atoms) / 2;
    let middle = (1..atoms.len() - 1).find(|&k| size(&atoms[..k]) >= half).unwrap_or(atoms.len() - 1);
    let (first, second) = atoms.split_at_mut(middle);
    bisect(first, gathering, depth - 1, groups);
    bisect(second, gathering, depth - 1, groups);
}

/// A cluster of whole blocks and panels.
fn leaf(entries: &Entries<'_>, blocks: &[PlacedBlock], atoms: &[Range<usize>]) -> Cluster {
    let count = entries.len() / NODES;
    let panels = atoms.iter().flat_map(|atom| atom.clone().map(|panel| panel % count));
    let nodes: Vec<usize> = panels.flat_map(|panel| panel * NODES..(panel + 1) * NODES).collect();
    let mut diagonal = Mat::zeros(nodes.len(), nodes.len());
    entries.for_each(&nodes, &nodes, |i, j, value| diagonal[(i, j)] = value);
    let mut outgoing =
        Mat::from_fn(nodes.len(), nodes.len(), |i, j| if i == j { entries.weight(nodes[i]) } else { 0.0 });
    let mut own: Vec<usize> = nodes.iter().filter_map(|&node| entries.block(node)).collect();
    own.dedup();
    for block in own.into_iter().map(|block| &blocks[block]) {
        let place = |node: usize| nodes.iter().position(|&own| own == node).unwrap_or(0);
        let places: Vec<usize> = block.nodes().map(place).collect();
        block.multiply_columns(&mut diagonal, &places);
        block.multiply_columns(&mut outgoing, &places);
    }
    add_identity(&mut diagonal);
    Cluster { nodes, diagonal, outgoing: Some(outgoing) }
}

/// Which nodes are left, and where.
struct Neighborhood {
    /// The cluster of each node that is left.
    owner: Vec<Option<u32>>,
    /// The circles around the clusters.
    circles: Vec<(DVec2, f64)>,
    nodes: Vec<Vec<usize>>,
}

impl Neighborhood {
    fn new(entries: &Entries<'_>, clusters: &[Cluster]) -> Self {
        let mut owner = vec![None; entries.len()];
        for (k, cluster) in clusters.iter().enumerate() {
            cluster.nodes.iter().for_each(|&node| owner[node] = Some(k as u32));
        }
        let circle = |cluster: &Cluster| {
            let places = || cluster.nodes.iter().map(|&node| entries.place(node));
            let (low, high) = places().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(a, b), p| (a.min(p), b.max(p)));
            let center = low.midpoint(high);
            (center, places().map(|place| place.distance(center)).fold(0.0, f64::max))
        };
        let nodes = clusters.iter().map(|cluster| cluster.nodes.clone()).collect();
        Self { owner, circles: clusters.iter().map(circle).collect(), nodes }
    }

    /// The nodes of other clusters inside of the circle around cluster `k`, and those that are integrated exactly from or
    /// onto one of its panels; in ascending order.
    fn near(&self, entries: &Entries<'_>, k: usize) -> Vec<usize> {
        let (center, radius) = self.circles[k];
        let reach = GROW * radius;
        let mut near = Vec::new();
        for (other, (place, own)) in self.circles.iter().enumerate() {
            if other != k && place.distance(center) <= reach + own {
                near.extend(self.nodes[other].iter().filter(|&&node| entries.place(node).distance(center) <= reach));
            }
        }
        for &node in &self.nodes[k] {
            let sources = entries.close_panels(node).flat_map(|panel| panel * NODES..(panel + 1) * NODES);
            let targets = entries.close_nodes(node / NODES).iter().map(|&node| node as usize);
            near.extend(
                sources.chain(targets).filter(|&node| self.owner[node].is_some_and(|owner| owner as usize != k)),
            );
        }
        near.sort_unstable();
        near.dedup();
        near
    }
}

/// Eliminates all nodes of a cluster but its skeleton.
fn eliminated(
    entries: &Entries<'_>,
    neighborhood: &Neighborhood,
    k: usize,
    cluster: &Cluster,
) -> (Eliminated, Cluster) {
    let chosen = skeleton(&interactions(entries, neighborhood, k), TOLERANCE);
    let t = &chosen.combination;
    let (n, rank) = (t.ncols(), t.nrows());
    let inverse = PartialPivLu::new(cluster.diagonal.as_ref()).inverse();
    let x = &inverse * t.transpose();
    let weighted = cluster.outgoing.as_ref().map_or_else(|| t.clone(), |outgoing| t * outgoing);
    let y = &weighted * &inverse;
    let diagonal = PartialPivLu::new((&weighted * &x).as_ref()).inverse();
    let restrict = &diagonal * &y;
    let prolong = &x * &diagonal;
    let rest = &inverse - &x * &restrict;
    let inner = Mat::from_fn(n, n + rank, |i, j| if j < n { rest[(i, j)] } else { prolong[(i, j - n)] });
    let nodes = chosen.columns.iter().map(|&column| cluster.nodes[column]).collect();
    (Eliminated { inner, restrict }, Cluster { nodes, diagonal, outgoing: None })
}

/// A row for each node of a cluster: its interactions, both ways, with everything outside.
fn interactions(entries: &Entries<'_>, neighborhood: &Neighborhood, k: usize) -> Mat<f64> {
    let (nodes, near) = (&neighborhood.nodes[k], neighborhood.near(entries, k));
    let (center, radius) = neighborhood.circles[k];
    let first = 2 * near.len();
    let mut matrix = Mat::zeros(nodes.len(), first + 2 * PROXIES + 2);
    entries.for_each(nodes, &near, |i, j, value| matrix[(i, j)] = radius * value / entries.weight(near[j]));
    entries
        .for_each(&near, nodes, |i, j, value| matrix[(j, near.len() + i)] = radius * value / entries.weight(nodes[j]));
    let directions: Vec<DVec2> = (0..PROXIES).map(|k| DVec2::from_angle(TAU * k as f64 / PROXIES as f64)).collect();
    for (j, &node) in nodes.iter().enumerate() {
        let (place, normal) = (entries.place(node) - center, entries.normal(node));
        for (i, direction) in directions.iter().enumerate() {
            let difference = place - GROW * radius * direction;
            matrix[(j, first + i)] = radius * FRAC_1_PI * normal.dot(difference) / difference.length_squared();
            matrix[(j, first + PROXIES + i)] = 1.0 + (difference.length() / (GROW * radius)).ln();
        }
        // the total charge of the exterior problem
        matrix[(j, first + 2 * PROXIES)] = entries.completion(node);
        matrix[(j, first + 2 * PROXIES + 1)] = 1.0;
    }
    matrix
}

/// The clusters in pairs.
fn merged(entries: &Entries<'_>, clusters: Vec<Cluster>) -> Vec<Cluster> {
    let mut clusters = clusters.into_iter();
    let mut pairs = Vec::with_capacity(clusters.len().div_ceil(2));
    while let Some(first) = clusters.next() {
        let Some(second) = clusters.next() else {
            pairs.push(first);
            break;
        };
        let (n, m) = (first.nodes.len(), second.nodes.len());
        let mut diagonal = Mat::zeros(n + m, n + m);
        diagonal.as_mut().submatrix_mut(0, 0, n, n).copy_from(&first.diagonal);
        diagonal.as_mut().submatrix_mut(n, n, m, m).copy_from(&second.diagonal);
        let weight = |node: usize| entries.weight(node);
        entries.for_each(&first.nodes, &second.nodes, |i, j, value| {
            diagonal[(i, n + j)] = value / weight(second.nodes[j]);
        });
        entries.for_each(&second.nodes, &first.nodes, |i, j, value| {
            diagonal[(n + i, j)] = value / weight(first.nodes[j]);
        });
        let nodes = [first.nodes, second.nodes].concat();
        pairs.push(Cluster { nodes, diagonal, outgoing: None });
    }
    pairs
}
