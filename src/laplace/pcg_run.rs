//! The iteration of conjugate gradients as a state that can be left and gone on with.
//!
//! Lane after lane, one iteration between two looks at the clock; what is computed does not
//! depend on where it was interrupted. The vectors are reused from solve to solve.

use super::pcg::{NotConverged, Pcg};
use super::{Deadline, Lanes};

/// The residual, relative to the right-hand side, at which a solve ends: the rounding
/// of the recurrence reaches 1e-14 to 1e-13 on meshes of 10⁴ to 10⁶ unknowns.
const TOLERANCE: f64 = 1e-12;

/// Iterations per √n before a solve is given up; meshes of 10³ to 10⁵ unknowns take 1 to 2.
const PATIENCE: f64 = 20.0;

/// How far a solve has come.
#[derive(Debug, Clone, Default)]
pub(super) struct PcgRun {
    /// The lane that is solved, or begun next.
    lane: usize,
    is_begun: bool,
    iterations: usize,
    solution: Vec<f64>,
    residual: Vec<f64>,
    direction: Vec<f64>,
    product: Vec<f64>,
    /// The norm of the right-hand side.
    scale: f64,
    /// rᵀ M⁻¹ r.
    energy: f64,
    /// The norm of the residual, relative to `scale`.
    relative: f64,
}

impl PcgRun {
    /// The next step begins with the first lane.
    pub fn restart(&mut self) {
        (self.lane, self.is_begun) = (0, false);
    }

    /// Takes the right-hand side.
    fn begin(&mut self, pcg: &Pcg, right: impl Iterator<Item = f64>) {
        self.residual.clear();
        self.residual.extend(right);
        let n = self.residual.len();
        for zeros in [&mut self.solution, &mut self.product] {
            zeros.clear();
            zeros.resize(n, 0.0);
        }
        (self.iterations, self.is_begun) = (0, true);
        self.scale = dot(&self.residual, &self.residual).sqrt();
        self.relative = if self.scale == 0.0 { 0.0 } else { 1.0 };
        self.direction.clone_from(&self.residual);
        pcg.precondition(&mut self.direction);
        self.energy = dot(&self.residual, &self.direction);
    }

    /// Whether the lane has come to an end, good or bad.
    fn is_over(&self) -> bool {
        let patience = (PATIENCE * (self.residual.len() as f64).sqrt()) as usize + 50;
        self.relative <= TOLERANCE || self.relative.is_nan() || self.iterations >= patience
    }

    /// Renews the direction, but for the first time, and goes along it.
    fn iterate(&mut self, pcg: &Pcg) {
        if self.iterations > 0 {
            self.product.copy_from_slice(&self.residual);
            pcg.precondition(&mut self.product);
            let next = dot(&self.residual, &self.product);
            let share = next / std::mem::replace(&mut self.energy, next);
            for (d, z) in self.direction.iter_mut().zip(&self.product) {
                *d = z + share * *d;
            }
        }
        self.iterations += 1;
        pcg.multiply(&self.direction, &mut self.product);
        let step = self.energy / dot(&self.direction, &self.product);
        add_scaled(&mut self.solution, step, &self.direction);
        add_scaled(&mut self.residual, -step, &self.product);
        self.relative = dot(&self.residual, &self.residual).sqrt() / self.scale;
    }
}

impl Pcg {
    /// Goes on with [`Self::solve`] until it is done (true) or `deadline` is over; at least one step is done.
    pub(super) fn advance<const K: usize>(
        &self,
        run: &mut PcgRun,
        x: &mut [Lanes<K>],
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        while run.lane < K {
            let lane = run.lane;
            if run.is_begun {
                run.iterate(self);
            } else {
                run.begin(self, x.iter().map(|lanes| lanes[lane]));
            }
            if run.is_over() {
                for (lanes, value) in x.iter_mut().zip(&run.solution) {
                    lanes[lane] = *value;
                }
                (run.lane, run.is_begun) = (lane + 1, false);
                if run.relative.is_nan() || run.relative > TOLERANCE {
                    return Err(NotConverged { residual: run.relative });
                }
            }
            if run.lane < K && deadline.is_over() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `x += factor · y`.
fn add_scaled(x: &mut [f64], factor: f64, y: &[f64]) {
    for (x, y) in x.iter_mut().zip(y) {
        *x += factor * y;
    }
}
