//! The conjugate gradient iteration as a resumable state machine.
//!
//! Lanes are solved one after another, each by the stages of its iterations, with a block of rows between two checks of
//! the deadline; every sum is taken over the rows in order, so the result does not depend
//! on where the solve was interrupted. The vectors are reused from solve to solve.

use super::pcg::{NotConverged, Pcg};
use super::{Deadline, Lanes};
use std::ops::Range;

/// The residual, relative to the right-hand side, at which a solve ends: the rounding
/// of the recurrence reaches 1e-14 to 1e-13 on meshes of 10⁴ to 10⁶ unknowns.
const TOLERANCE: f64 = 1e-12;

/// The iteration limit per √n; meshes of 10³ to 10⁵ unknowns take 1 to 2.
const PATIENCE: f64 = 20.0;

/// Rows of a stage between two checks of the deadline: 0.1 to 0.5 ms natively, three times that in
/// wasm. An iteration of 10⁶ rows takes 20 to 30 ms. With fewer rows than this the deadline is checked once per
/// iteration.
const BLOCK_ROWS: usize = 1 << 15;

/// The stages of an iteration, each one pass over the rows. z = M⁻¹ r is stored in `product`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum Stage {
    /// Takes the right-hand side; once per lane.
    #[default]
    Begin,
    /// The two sweeps of M⁻¹.
    Forward,
    Backward,
    /// rᵀ z.
    Energy,
    /// d = z + β d, then L̂ d in place of z.
    Multiply,
    /// dᵀ L̂ d.
    Length,
    /// The step along d, and |r|².
    Step,
}

/// The progress of a solve.
#[derive(Debug, Clone, Default)]
pub(super) struct PcgRun {
    /// The lane being solved.
    lane: usize,
    stage: Stage,
    /// The number of rows that the stage has processed, and its sum over them.
    done: usize,
    sum: f64,
    iterations: usize,
    solution: Vec<f64>,
    residual: Vec<f64>,
    direction: Vec<f64>,
    product: Vec<f64>,
    /// The norm of the right-hand side.
    scale: f64,
    /// rᵀ M⁻¹ r, and β, its ratio to the value of the previous iteration.
    energy: f64,
    share: f64,
    /// The step length along the direction.
    step: f64,
    /// The norm of the residual, relative to `scale`.
    relative: f64,
}

impl PcgRun {
    /// Makes the next call start with the first lane.
    pub fn restart(&mut self) {
        (self.lane, self.stage) = (0, Stage::Begin);
    }

    /// Initializes a lane with its right-hand side.
    fn begin(&mut self, right: impl Iterator<Item = f64>) {
        self.residual.clear();
        self.residual.extend(right);
        self.product.clone_from(&self.residual);
        // β = 0: the first direction is z + 0·d = z
        for zeros in [&mut self.solution, &mut self.direction] {
            zeros.clear();
            zeros.resize(self.residual.len(), 0.0);
        }
        (self.iterations, self.share) = (0, 0.0);
        self.scale = self.residual.iter().map(|r| r * r).sum::<f64>().sqrt();
        self.relative = if self.scale == 0.0 { 0.0 } else { 1.0 };
        self.enter(Stage::Forward);
    }

    fn enter(&mut self, stage: Stage) {
        (self.stage, self.done, self.sum) = (stage, 0, 0.0);
    }

    /// Whether an iteration is complete and the next has not started.
    fn is_between(&self) -> bool {
        self.stage == Stage::Forward && self.done == 0
    }

    /// Whether the lane is finished: converged or given up.
    fn is_over(&self) -> bool {
        let patience = (PATIENCE * (self.residual.len() as f64).sqrt()) as usize + 50;
        self.relative <= TOLERANCE || self.relative.is_nan() || self.iterations >= patience
    }

    /// Processes the next block of rows; after the last block, changes to the next stage.
    fn go_on(&mut self, pcg: &Pcg) {
        let n = self.residual.len();
        let rows = self.done..n.min(self.done + BLOCK_ROWS);
        self.done = rows.end;
        match self.stage {
            Stage::Begin => {}
            Stage::Forward => pcg.sweep_forward(rows, &mut self.product),
            Stage::Backward => pcg.sweep_backward(n - rows.end..n - rows.start, &mut self.product),
            Stage::Energy => self.sum = add_products(self.sum, &self.residual[rows.clone()], &self.product[rows]),
            Stage::Multiply => {
                for (d, z) in self.direction[rows.clone()].iter_mut().zip(&self.product[rows.clone()]) {
                    *d = z + self.share * *d;
                }
                pcg.multiply(rows, &self.direction, &mut self.product);
            }
            Stage::Length => self.sum = add_products(self.sum, &self.direction[rows.clone()], &self.product[rows]),
            Stage::Step => self.go_along(rows),
        }
        if self.done == n {
            self.leave();
        }
    }

    fn go_along(&mut self, rows: Range<usize>) {
        add_scaled(&mut self.solution[rows.clone()], self.step, &self.direction[rows.clone()]);
        let residual = &mut self.residual[rows.clone()];
        add_scaled(residual, -self.step, &self.product[rows.clone()]);
        self.sum = add_products(self.sum, residual, residual);
        self.product[rows].copy_from_slice(residual);
    }

    /// Computes the scalars that follow from a complete stage, and enters the next one.
    fn leave(&mut self) {
        let next = match self.stage {
            Stage::Begin | Stage::Forward => Stage::Backward,
            Stage::Backward => Stage::Energy,
            Stage::Energy => {
                let before = std::mem::replace(&mut self.energy, self.sum);
                self.share = if self.iterations == 0 { 0.0 } else { self.energy / before };
                Stage::Multiply
            }
            Stage::Multiply => Stage::Length,
            Stage::Length => {
                self.step = self.energy / self.sum;
                Stage::Step
            }
            Stage::Step => {
                self.relative = self.sum.sqrt() / self.scale;
                self.iterations += 1;
                Stage::Forward
            }
        };
        self.enter(next);
    }
}

impl Pcg {
    /// Continues [`Self::solve`] until it is complete (true) or `deadline` has passed; at least one block of rows is
    /// done.
    pub(super) fn advance<const K: usize>(
        &self,
        run: &mut PcgRun,
        x: &mut [Lanes<K>],
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        while run.lane < K {
            let lane = run.lane;
            if run.stage == Stage::Begin {
                run.begin(x.iter().map(|lanes| lanes[lane]));
            } else {
                run.go_on(self);
            }
            if run.is_between() && run.is_over() {
                for (lanes, value) in x.iter_mut().zip(&run.solution) {
                    lanes[lane] = *value;
                }
                (run.lane, run.stage) = (lane + 1, Stage::Begin);
                if run.relative.is_nan() || run.relative > TOLERANCE {
                    return Err(NotConverged { residual: run.relative });
                }
            }
            let is_time_to_look = run.is_between() || run.stage == Stage::Begin || x.len() >= BLOCK_ROWS;
            if run.lane < K && is_time_to_look && deadline.is_over() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

/// `sum + aᵀ b`, added in the order of the rows.
fn add_products(sum: f64, a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(sum, |sum, (a, b)| sum + a * b)
}

/// `x += factor · y`.
fn add_scaled(x: &mut [f64], factor: f64, y: &[f64]) {
    for (x, y) in x.iter_mut().zip(y) {
        *x += factor * y;
    }
}
