//! Compression of the equation next to a junction: recursively compressed inverse preconditioning.
//!
//! Helsing, "Solving integral equations on piecewise smooth boundaries using the RCIP method: a tutorial",
//! arXiv 1207.6737. On both legs lie q panels of unit length (a *block*). On the finer mesh, whose inner half consists
//! of q panels of length ½ on each leg, one step of the recursion is
//!
//! R ← P_Wᵀ (F{R⁻¹} + I° + K°)⁻¹ P,
//!
//! with F putting R⁻¹ into the inner panels and ° leaving them out, P the interpolation from the block's panels and
//! P_W = W_b P W_c⁻¹. The inverse is written by its Schur complement S = D − B R A, so R is never inverted:
//!
//! u_o = S⁻¹ (P_o − B R P_i),  v = P_i − A u_o,  u_i = R v,  R ← P_Wᵀ (u_i, u_o).
//!
//! The same u_o and v take a density outwards in: u_o ρ̃ is the true density on the outer panels, v ρ̃ the transformed
//! density of the next smaller block. With straight legs every step is the same, and R is the recursion's fixed point
//! (`straight`); curved legs use their true geometry, one step for each level. Where one leg lies next to the other,
//! integrals over its panels are exact for polynomials (`panel`).

use super::leg::{Leg, Node, kernel};
use super::legendre::{NODES, Rule};
use super::panel::Slope;
use super::straight;
use crate::geometry::{DVec2, Junction};
use faer::Mat;
use faer::linalg::solvers::{PartialPivLu, Solve as _};
use std::f64::consts::PI;
use std::sync::Arc;

/// Which equation is solved: σ + K σ, of the interior, or σ − K σ, of the exterior.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Problem {
    /// Harmonic measure of interior points.
    Interior,
    /// The equilibrium measure.
    Exterior,
}

impl Problem {
    /// The sign of K.
    pub fn sign(self) -> f64 {
        match self {
            Self::Interior => 1.0,
            Self::Exterior => -1.0,
        }
    }

    /// π/α, for the angle α of the side in which the problem lives: densities next to the corner are of the order
    /// r^{π/α − 1}.
    pub fn exponent(self, junction: Junction) -> f64 {
        match (junction, self) {
            (Junction::Corner { angle }, Self::Interior) => PI / angle,
            (Junction::Corner { angle }, Self::Exterior) => PI / (2.0 * PI - angle),
            _ => 1.0,
        }
    }
}

/// One step from a block to the next smaller one.
#[derive(Debug, Clone)]
pub struct Step {
    /// u_o: the true density on the outer panels, those of the first leg first.
    pub outer: Mat<f64>,
    /// v: the transformed density of the inner block.
    pub inner: Mat<f64>,
}

/// A compressed block.
#[derive(Debug, Clone)]
pub struct Compressed {
    /// R of the whole block: rows and columns are the nodes of the first leg, then of the second, outwards.
    pub matrix: Mat<f64>,
    /// The steps of curved legs, from outside in; none for straight ones.
    pub(super) steps: Vec<Step>,
    /// The step of all further levels, with the tangents as legs.
    pub(super) repeated: Step,
    /// R at all further levels, if that is not `matrix`.
    pub(super) innermost: Option<Mat<f64>>,
}

impl Compressed {
    /// The step inwards at a level, counted from the whole block.
    pub fn step(&self, level: usize) -> &Step {
        self.steps.get(level).unwrap_or(&self.repeated)
    }

    /// R of a small block, after all steps of curved legs.
    pub fn innermost(&self) -> &Mat<f64> {
        self.innermost.as_ref().unwrap_or(&self.matrix)
    }
}

/// A compressed block and its place among the nodes.
#[derive(Debug, Clone)]
pub struct PlacedBlock {
    /// The first node of each panel, in the block's order.
    pub rows: Vec<usize>,
    /// Blocks of straight legs with one angle share it.
    pub compressed: Arc<Compressed>,
}

impl PlacedBlock {
    /// The nodes in the block's order.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        self.rows.iter().flat_map(|&row| row..row + NODES)
    }

    /// The values at the block's nodes.
    pub fn gather(&self, values: &[f64]) -> Mat<f64> {
        Mat::from_fn(self.rows.len() * NODES, 1, |k, _| values[self.rows[k / NODES] + k % NODES])
    }

    /// Multiplies the block's columns, which lie at `places`, by its matrix.
    pub fn multiply_columns(&self, matrix: &mut Mat<f64>, places: &[usize]) {
        let part = Mat::from_fn(matrix.nrows(), places.len(), |i, k| matrix[(i, places[k])]);
        let product = &part * &self.compressed.matrix;
        for (k, &column) in places.iter().enumerate() {
            matrix.col_as_slice_mut(column).copy_from_slice(product.col_as_slice(k));
        }
    }
}

/// The panels of a block and of its finer mesh on one leg, in units of the block's panels.
#[derive(Debug, Clone, Copy, serde::Serialize, serde::Deserialize)]
pub struct BlockMesh {
    /// Panels of the block on each leg: 1, 2 or 4.
    pub panels: usize,
}

impl BlockMesh {
    /// The inner panels of the finer mesh, as (start, length).
    pub fn inner(self) -> impl Iterator<Item = (f64, f64)> {
        (0..self.panels).map(|k| (0.5 * k as f64, 0.5))
    }

    /// The outer panels of the finer mesh, as (start, length).
    pub fn outer(self) -> Vec<(f64, f64)> {
        match self.panels {
            1 => vec![(0.5, 0.5)],
            q => (q / 2..q).map(|k| (k as f64, 1.0)).collect(),
        }
    }

    /// The panel of the block that contains a panel of the finer mesh, and which half of it that is, if not all.
    fn parent((start, length): (f64, f64)) -> (usize, Option<usize>) {
        let half = if length < 1.0 { Some(usize::from(start.fract() >= 0.5)) } else { None };
        (start as usize, half)
    }

    /// P and P_W from the block to these panels of one leg.
    pub fn interpolation(self, panels: &[(f64, f64)]) -> [Mat<f64>; 2] {
        let rule = Rule::get();
        let (rows, columns) = (panels.len() * NODES, self.panels * NODES);
        let mut matrices = [Mat::zeros(rows, columns), Mat::zeros(rows, columns)];
        for (k, &panel) in panels.iter().enumerate() {
            let (parent, half) = Self::parent(panel);
            for i in 0..NODES {
                for j in 0..NODES {
                    let (row, column) = (k * NODES + i, parent * NODES + j);
                    let value = half.map_or(f64::from(i == j), |side| rule.halves[side][i][j]);
                    matrices[0][(row, column)] = value;
                    matrices[1][(row, column)] = value * panel.1 * rule.weights[i] / rule.weights[j];
                }
            }
        }
        matrices
    }
}

/// The matrix on both legs that acts on each as this one does.
fn on_both(matrix: &Mat<f64>) -> Mat<f64> {
    let (rows, columns) = (matrix.nrows(), matrix.ncols());
    Mat::from_fn(
        2 * rows,
        2 * columns,
        |i, j| {
            if i / rows == j / columns { matrix[(i % rows, j % columns)] } else { 0.0 }
        },
    )
}

/// Panels on one leg with their nodes.
pub struct LegMesh {
    nodes: Vec<Node>,
    slopes: Vec<(Slope, DVec2)>,
    is_straight: bool,
}

impl LegMesh {
    /// The nodes of these panels, `scale` parameters per unit.
    pub fn new(leg: &Leg, scale: f64, panels: &[(f64, f64)]) -> Self {
        let rule = Rule::get();
        let of_panel = |&(start, length): &(f64, f64)| {
            let places = rule.nodes.iter().zip(rule.weights);
            places.map(move |(x, w)| {
                let (t, weight) = (start + length * 0.5 * (1.0 + x), 0.5 * length * w);
                leg.node(scale * t, scale * weight)
            })
        };
        let slope = |&(start, length): &(f64, f64)| {
            let middle = leg.node(scale * (start + 0.5 * length), 0.0).offset;
            (Slope::new(leg, [scale * start, scale * (start + length)]), middle)
        };
        Self {
            nodes: panels.iter().flat_map(of_panel).collect(),
            slopes: panels.iter().map(slope).collect(),
            is_straight: leg.is_straight(),
        }
    }

    /// K from the panels of `source`, on the other leg, to the nodes of this mesh.
    pub fn across(&self, source: &Self) -> Mat<f64> {
        let mut matrix = Mat::zeros(self.nodes.len(), source.nodes.len());
        for (b, (panel, (slope, middle))) in source.nodes.as_chunks::<NODES>().0.iter().zip(&source.slopes).enumerate()
        {
            let rate = panel[0].weight / Rule::get().weights[0];
            for (i, y) in self.nodes.iter().enumerate() {
                let differences = panel.each_ref().map(|s| y.offset - s.offset);
                let is_near = slope.may_be_near(y.offset - *middle);
                let close = if is_near { slope.close_weights(y.normal, &differences, rate) } else { None };
                let plain = || std::array::from_fn(|j| kernel(y.normal, differences[j]) * panel[j].weight);
                for (j, weight) in close.unwrap_or_else(plain).into_iter().enumerate() {
                    matrix[(i, b * NODES + j)] = weight;
                }
            }
        }
        matrix
    }

    /// K from the panels of `source`, on the same leg. Within a straight one it is 0.
    fn along(&self, source: &Self) -> Mat<f64> {
        let (rows, columns) = (self.nodes.len(), source.nodes.len());
        if self.is_straight {
            return Mat::zeros(rows, columns);
        }
        Mat::from_fn(rows, columns, |i, j| {
            let (y, s) = (&self.nodes[i], &source.nodes[j]);
            let difference = y.offset - s.offset;
            // equal nodes: the diagonal
            s.weight * if difference.length_squared() == 0.0 { y.diagonal } else { kernel(y.normal, difference) }
        })
    }
}

/// ± K from sources to targets on both legs.
fn kernels(targets: &[LegMesh; 2], sources: &[LegMesh; 2], sign: f64) -> Mat<f64> {
    let part = |a: usize, b: usize| if a == b { targets[a].along(&sources[a]) } else { targets[a].across(&sources[b]) };
    let parts = [[part(0, 0), part(0, 1)], [part(1, 0), part(1, 1)]];
    let (rows, columns) = (parts[0][0].nrows(), parts[0][0].ncols());
    Mat::from_fn(2 * rows, 2 * columns, |i, j| sign * parts[i / rows][j / columns][(i % rows, j % columns)])
}

/// The parts of a step that do not depend on R, at one level.
pub struct Level {
    /// A: inner targets, outer sources.
    pub a: Mat<f64>,
    /// B: outer targets, inner sources.
    pub b: Mat<f64>,
    /// D = I + K on the outer panels.
    pub d: Mat<f64>,
}

/// P and P_W to the inner and to the outer panels.
pub struct Interpolation {
    pub inner: [Mat<f64>; 2],
    pub outer: [Mat<f64>; 2],
}

impl Interpolation {
    /// On one leg.
    pub fn new(mesh: BlockMesh) -> Self {
        let inner: Vec<_> = mesh.inner().collect();
        Self { inner: mesh.interpolation(&inner), outer: mesh.interpolation(&mesh.outer()) }
    }

    /// The step at this level and the R that it leads to.
    pub fn step(&self, level: &Level, r: &Mat<f64>) -> (Step, Mat<f64>) {
        let br = &level.b * r;
        let schur = &level.d - &br * &level.a;
        let mut outer = &self.outer[0] - &br * &self.inner[0];
        PartialPivLu::new(schur.as_ref()).solve_in_place(outer.as_mut());
        let inner = &self.inner[0] - &level.a * &outer;
        let next = self.inner[1].transpose() * (r * &inner) + self.outer[1].transpose() * &outer;
        (Step { outer, inner }, next)
    }
}

/// A block's level with its true geometry.
fn level(legs: &[Leg; 2], mesh: BlockMesh, scales: [f64; 2], sign: f64) -> Level {
    let (inner, outer): (Vec<_>, _) = (mesh.inner().collect(), mesh.outer());
    let [inner, outer] = [inner, outer].map(|panels| [0, 1].map(|k| LegMesh::new(&legs[k], scales[k], &panels)));
    let mut d = kernels(&outer, &outer, sign);
    add_identity(&mut d);
    Level { a: kernels(&inner, &outer, sign), b: kernels(&outer, &inner, sign), d }
}

/// Adds 1 to the diagonal.
pub fn add_identity(matrix: &mut Mat<f64>) {
    for k in 0..matrix.nrows() {
        matrix[(k, k)] += 1.0;
    }
}

/// The levels of a curved corner end where curvature changes the measure by less than this; the presets' measures do not
/// change with 1e-15.
const LEVEL_TOLERANCE: f64 = 1e-14;

/// Compresses the block of `mesh` at a junction; its panels have `scales` of the parameters of the legs. `None` if the
/// recursion does not converge.
pub fn compress(
    legs: &[Leg; 2],
    junction: Junction,
    mesh: BlockMesh,
    scales: [f64; 2],
    problem: Problem,
) -> Option<Compressed> {
    let angle = if let Junction::Corner { angle } = junction { angle } else { PI };
    let tangents = straight::compress(angle, mesh, problem)?;
    if legs.iter().all(Leg::is_straight) {
        return Some(tangents);
    }
    let tangents = tangents.with_speeds([legs[0].speed, legs[1].speed]);
    let one = Interpolation::new(mesh);
    let both = Interpolation { inner: one.inner.each_ref().map(on_both), outer: one.outer.each_ref().map(on_both) };
    // a level's error, of the order of its size, counts in proportion to its measure
    let order = 1.0 + problem.exponent(junction).min(1.0);
    let levels = (-LEVEL_TOLERANCE.log2() / order).ceil() as i32;
    let Compressed { matrix: innermost, repeated, .. } = tangents;
    let mut matrix = innermost.clone();
    let mut steps = Vec::new();
    for k in (0..levels).rev() {
        let shrink = 0.5_f64.powi(k);
        let level = level(legs, mesh, scales.map(|scale| scale * shrink), problem.sign());
        let (step, next) = both.step(&level, &matrix);
        steps.push(step);
        matrix = next;
    }
    steps.reverse();
    matrix.is_all_finite().then_some(Compressed { matrix, steps, repeated, innermost: Some(innermost) })
}
