//! Compressed blocks of straight legs: the fixed point of the recursion, by halves and by doubling.
//!
//! Two straight legs with equal panels are mirror images, so K is k between the legs and 0 within them: densities that are
//! even or odd under the reflection do not mix, and each half solves the recursion on one leg with +k or −k.
//!
//! One step of the recursion (`corner`) is a linear fractional map of R,
//!
//! R ← H + U (I − R E)⁻¹ R V,  H = P_Wₒᵀ D⁻¹ Pₒ, U = P_Wᵢᵀ − P_Wₒᵀ D⁻¹ B, V = Pᵢ − A D⁻¹ Pₒ, E = A D⁻¹ B,
//!
//! and so are 2, 4, 8, … steps: with T = (I − H E)⁻¹, two such maps in a row are
//!
//! H + U T H V, U T U, V (I − E H)⁻¹ V, E + V E T U
//!
//! (structured doubling: Guo, Lin and Xu, Numer. Math. 103 (2006) 393). R is what H tends to.

use super::corner::{BlockMesh, Compressed, Interpolation, LegMesh, Level, Problem, Step, add_identity};
use super::leg::Leg;
use super::legendre::NODES;
use crate::geometry::DVec2;
use faer::Mat;
use faer::linalg::solvers::{PartialPivLu, Solve as _};

/// The most doublings: corners of 359 degrees take 7 (120 steps).
const MOST_DOUBLINGS: u32 = 16;
/// A change of R in the last doubling up to which it counts as reached.
const RESOLVED: f64 = 1e-12;
/// The change of R at which the fixed point is reached: a few units of rounding of its entries, which are of order 1.
const STANDING: f64 = 4e-15;

/// R of straight legs that meet in this interior angle, and its step; `None` if the recursion does not converge.
pub fn compress(angle: f64, mesh: BlockMesh, problem: Problem) -> Option<Compressed> {
    let legs = [Leg::straight(DVec2::from_angle(angle), true), Leg::straight(DVec2::X, false)];
    let (inner, outer): (Vec<_>, _) = (mesh.inner().collect(), mesh.outer());
    let [inner, outer] = [inner, outer].map(|panels| legs.each_ref().map(|leg| LegMesh::new(leg, 1.0, &panels)));
    let across = |target: &[LegMesh; 2], source: &[LegMesh; 2]| target[0].across(&source[1]);
    let kernels = [across(&inner, &outer), across(&outer, &inner), across(&outer, &outer)];
    let interpolation = Interpolation::new(mesh);
    let [even, odd] = [1.0, -1.0].map(|parity| {
        let [a, b, mut d] = kernels.each_ref().map(|kernel| parity * problem.sign() * kernel);
        add_identity(&mut d);
        let level = Level { a, b, d };
        // one more step takes the rounding of the doublings out
        let fixed = fixed_point(&interpolation, &level, mesh.panels * NODES)?;
        Some(interpolation.step(&level, &fixed))
    });
    let ((even_step, even), (odd_step, odd)) = (even?, odd?);
    let repeated =
        Step { outer: joined(&even_step.outer, &odd_step.outer), inner: joined(&even_step.inner, &odd_step.inner) };
    Some(Compressed { matrix: joined(&even, &odd), steps: Vec::new(), repeated, innermost: None })
}

/// The matrix on both legs, from what it does to even and to odd densities.
fn joined(even: &Mat<f64>, odd: &Mat<f64>) -> Mat<f64> {
    let (rows, columns) = (even.nrows(), even.ncols());
    Mat::from_fn(2 * rows, 2 * columns, |i, j| {
        let (e, o) = (even[(i % rows, j % columns)], odd[(i % rows, j % columns)]);
        0.5 * if i / rows == j / columns { e + o } else { e - o }
    })
}

/// The fixed point of the recursion, if it is reached.
fn fixed_point(interpolation: &Interpolation, level: &Level, size: usize) -> Option<Mat<f64>> {
    let Interpolation { inner: [p_inner, w_inner], outer: [p_outer, w_outer] } = interpolation;
    let lu = PartialPivLu::new(level.d.as_ref());
    let (dp, db) = (lu.solve(p_outer), lu.solve(&level.b));
    let mut h = w_outer.transpose() * &dp;
    let mut u = w_inner.transpose() - w_outer.transpose() * &db;
    let mut v = p_inner - &level.a * &dp;
    let mut e = &level.a * &db;
    let mut last = f64::INFINITY;
    for _ in 0..MOST_DOUBLINGS {
        let mut matrix = -(&h * &e);
        add_identity(&mut matrix);
        let lu = PartialPivLu::new(matrix.as_ref());
        let (th, tu) = (lu.solve(&h), lu.solve(&u));
        let change = &u * (&th * &v);
        let ve = &v * &e;
        v = &v * &v + &ve * (&th * &v);
        e += &ve * &tu;
        u = &u * &tu;
        h += &change;
        last = change.norm_max();
        if last <= STANDING {
            break;
        }
    }
    debug_assert_eq!(h.nrows(), size);
    (last <= RESOLVED).then_some(h)
}

impl Compressed {
    /// For densities by a parameter that runs with these speeds on the legs instead of arc length.
    #[must_use]
    pub(super) fn with_speeds(self, speeds: [f64; 2]) -> Self {
        let scaled = |matrix: &Mat<f64>| {
            let (rows, columns) = (matrix.nrows() / 2, matrix.ncols() / 2);
            Mat::from_fn(2 * rows, 2 * columns, |i, j| matrix[(i, j)] * speeds[i / rows] / speeds[j / columns])
        };
        let repeated = Step { outer: scaled(&self.repeated.outer), inner: scaled(&self.repeated.inner) };
        Self { matrix: scaled(&self.matrix), repeated, ..self }
    }
}
