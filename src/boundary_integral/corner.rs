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
//! density of the next smaller block. With straight legs every step is the same, and R is the recursion's fixed point;
//! curved legs use their true geometry, one step for each level.

use super::leg::{Leg, Node, kernel};
use super::legendre::{NODES, Rule};
use crate::geometry::Junction;
use faer::Mat;
use faer::linalg::solvers::{PartialPivLu, Solve as _};
use std::f64::consts::PI;

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
    /// R at all further levels.
    pub innermost: Mat<f64>,
}

impl Compressed {
    /// The step inwards at a level, counted from the whole block.
    pub fn step(&self, level: usize) -> &Step {
        self.steps.get(level).unwrap_or(&self.repeated)
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
    fn inner(self) -> impl Iterator<Item = (f64, f64)> {
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

    /// P and P_W from the block to these panels of each leg.
    fn interpolation(self, panels: &[(f64, f64)]) -> [Mat<f64>; 2] {
        let rule = Rule::get();
        let (rows, columns) = (panels.len() * NODES, self.panels * NODES);
        let mut matrices = [Mat::zeros(2 * rows, 2 * columns), Mat::zeros(2 * rows, 2 * columns)];
        for (k, &panel) in panels.iter().enumerate() {
            let (parent, half) = Self::parent(panel);
            for leg in 0..2 {
                for i in 0..NODES {
                    let row = leg * rows + k * NODES + i;
                    for j in 0..NODES {
                        let column = leg * columns + parent * NODES + j;
                        let value = half.map_or(f64::from(i == j), |side| rule.halves[side][i][j]);
                        matrices[0][(row, column)] = value;
                        matrices[1][(row, column)] = value * panel.1 * rule.weights[i] / rule.weights[j];
                    }
                }
            }
        }
        matrices
    }
}

/// The nodes of these panels on both legs, `scales` parameters per unit.
fn nodes(legs: &[Leg; 2], scales: [f64; 2], panels: &[(f64, f64)]) -> [Vec<Node>; 2] {
    let rule = Rule::get();
    [0, 1].map(|k| {
        let of_panel = |&(start, length): &(f64, f64)| {
            let places = rule.nodes.iter().zip(rule.weights);
            places.map(move |(x, w)| {
                let (t, weight) = (start + length * 0.5 * (1.0 + x), 0.5 * length * w);
                legs[k].node(scales[k] * t, scales[k] * weight)
            })
        };
        panels.iter().flat_map(of_panel).collect()
    })
}

/// ± K from sources to targets on both legs. Within one straight leg the kernel is 0.
fn kernels(legs: &[Leg; 2], targets: &[Vec<Node>; 2], sources: &[Vec<Node>; 2], sign: f64) -> Mat<f64> {
    let (rows, columns) = (targets[0].len(), sources[0].len());
    Mat::from_fn(2 * rows, 2 * columns, |i, j| {
        let (a, b) = (i / rows, j / columns);
        if a == b && legs[a].is_straight() {
            return 0.0;
        }
        let (y, s) = (&targets[a][i % rows], &sources[b][j % columns]);
        let difference = y.offset - s.offset;
        // equal nodes of one leg: the diagonal
        let value = if difference.length_squared() == 0.0 { y.diagonal } else { kernel(y.normal, difference) };
        sign * value * s.weight
    })
}

/// The parts of a step that do not depend on R, at one level.
struct Level {
    /// A: inner targets, outer sources.
    a: Mat<f64>,
    /// B: outer targets, inner sources.
    b: Mat<f64>,
    /// D = I + K on the outer panels.
    d: Mat<f64>,
}

/// What all levels share.
struct Recursion<'a> {
    legs: &'a [Leg; 2],
    inner_panels: Vec<(f64, f64)>,
    outer_panels: Vec<(f64, f64)>,
    inner: [Mat<f64>; 2],
    outer: [Mat<f64>; 2],
    sign: f64,
}

impl<'a> Recursion<'a> {
    fn new(legs: &'a [Leg; 2], mesh: BlockMesh, sign: f64) -> Self {
        let (inner_panels, outer_panels): (Vec<_>, _) = (mesh.inner().collect(), mesh.outer());
        let (inner, outer) = (mesh.interpolation(&inner_panels), mesh.interpolation(&outer_panels));
        Self { legs, inner_panels, outer_panels, inner, outer, sign }
    }

    fn level(&self, scales: [f64; 2]) -> Level {
        let inner = nodes(self.legs, scales, &self.inner_panels);
        let outer = nodes(self.legs, scales, &self.outer_panels);
        let mut d = kernels(self.legs, &outer, &outer, self.sign);
        for k in 0..d.nrows() {
            d[(k, k)] += 1.0;
        }
        Level { a: kernels(self.legs, &inner, &outer, self.sign), b: kernels(self.legs, &outer, &inner, self.sign), d }
    }

    /// The step at this level and the R that it leads to.
    fn step(&self, level: &Level, r: &Mat<f64>) -> (Step, Mat<f64>) {
        let br = &level.b * r;
        let schur = &level.d - &br * &level.a;
        let mut outer = &self.outer[0] - &br * &self.inner[0];
        PartialPivLu::new(schur.as_ref()).solve_in_place(outer.as_mut());
        let inner = &self.inner[0] - &level.a * &outer;
        let next = self.inner[1].transpose() * (r * &inner) + self.outer[1].transpose() * &outer;
        (Step { outer, inner }, next)
    }
}

/// The largest number of rounds to the fixed point; corners of 359 degrees take about 120.
const MOST_ROUNDS: usize = 400;
/// The change of R at which the fixed point is reached: a few units of rounding of its entries, which are of order 1.
const STANDING: f64 = 4e-15;
/// The levels of a curved corner end where curvature changes the measure by less than this; the presets' measures do not
/// change with 1e-15.
const LEVEL_TOLERANCE: f64 = 1e-14;
/// The change of R at which the fixed point inside of these levels is reached: the measure there is below 1e-7.
const LEVEL_STANDING: f64 = 1e-11;

/// R of straight legs of equal length that meet as the tangents of these legs do, and its step.
fn fixed_point(recursion: &Recursion<'_>, scales: [f64; 2], size: usize, standing: f64) -> (Step, Mat<f64>) {
    let level = recursion.level(scales);
    let mut r = Mat::identity(size, size);
    let (mut step, mut next) = recursion.step(&level, &r);
    let mut best = f64::INFINITY;
    for _ in 0..MOST_ROUNDS {
        let change = (&next - &r).norm_max();
        r = next;
        // rounding may keep R from standing still altogether
        if change <= standing || (change < 1e-13 && change >= best) {
            break;
        }
        best = best.min(change);
        (step, next) = recursion.step(&level, &r);
    }
    (step, r)
}

/// Compresses the block of `mesh` at a junction; its panels have `scales` of the parameters of the legs.
pub fn compress(
    legs: &[Leg; 2],
    junction: Junction,
    mesh: BlockMesh,
    scales: [f64; 2],
    problem: Problem,
) -> Compressed {
    let size = 2 * mesh.panels * NODES;
    let recursion = Recursion::new(legs, mesh, problem.sign());
    if legs.iter().all(Leg::is_straight) {
        let (repeated, matrix) = fixed_point(&recursion, scales, size, STANDING);
        return Compressed { innermost: matrix.clone(), matrix, steps: Vec::new(), repeated };
    }
    let tangents = [0, 1].map(|k| legs[k].tangent_line());
    let (repeated, innermost) =
        fixed_point(&Recursion::new(&tangents, mesh, problem.sign()), scales, size, LEVEL_STANDING);
    // a level's error, of the order of its size, counts in proportion to its measure
    let order = 1.0 + problem.exponent(junction).min(1.0);
    let levels = (-LEVEL_TOLERANCE.log2() / order).ceil() as i32;
    let mut matrix = innermost.clone();
    let mut steps = Vec::new();
    for k in (0..levels).rev() {
        let shrink = 0.5_f64.powi(k);
        let level = recursion.level(scales.map(|scale| scale * shrink));
        let (step, next) = recursion.step(&level, &matrix);
        steps.push(step);
        matrix = next;
    }
    steps.reverse();
    Compressed { matrix, steps, repeated, innermost }
}
