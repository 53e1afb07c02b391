//! Conformal maps as formulas: rational functions in barycentric form, for the map and for its inverse.
//!
//! `aaa` is the AAA algorithm (Nakatsukasa, Sète and Trefethen 2018), on boundary pairs (z, f(z)) that `samples` clusters
//! at the break points of both sides (Gopal and Trefethen, Numer. Math. 142 (2019)): corners of the source, and preimages of
//! the target's. `fitting` adds pairs where the fit is wrong between them, `bad_poles` removes poles inside. `matched` makes
//! the pairs of a [`crate::conformal::ConformalMap`]. The error is measured on ten times as many pairs; by the maximum
//! principle it holds inside too, since no pole lies there.

mod aaa;
mod bad_poles;
mod fit;
mod fitting;
mod fixed_poles;
mod formula;
mod function;
mod least_squares;
mod matched;
mod poles;
mod samples;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

pub use fit::{Cancelled, Fit, Goal, Precision};
pub use formula::{DIGITS, Formula, FormulaError, MAX_DEGREE, Reached, SINGLE_DIGITS};
pub use function::Rational;
pub use samples::Boundary;
