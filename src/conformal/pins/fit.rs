//! The map for which more than three pins are missed least: the sum of the squared misses is minimised over the three
//! degrees of freedom.
//!
//! Seen from a point of each side, boundary places are points z = e^{2πiω} of the unit circle, and the maps are the Möbius
//! maps M of the disk. A small one moves a point of the circle at angle θ by r + 2(q cos θ − p sin θ), where r turns the
//! disk and p + iq is the image of 0; the positions on the target follow by their derivatives with respect to ω. The three
//! unknowns of each step are those of the damped normal equations (Levenberg 1944, Marquardt 1963), from the map through
//! three of the pins; M itself is composed exactly.

use super::view::View;
use crate::conformal::{Moebius, PerSide};
use crate::geometry::DVec3;
use glam::DMat3;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Steps that are tried; ten suffice unless the pins contradict each other badly.
const STEPS: usize = 100;
/// The damping at the beginning, relative to the diagonal of the normal equations, and its changes.
const DAMPING: f64 = 1e-3;
const LESS: f64 = 0.1;
const MORE: f64 = 10.0;
/// The damping at which no step improves any more.
const MOST: f64 = 1e12;
/// Half of the step of central differences along the boundary, in measure.
const DIFFERENCE: f64 = 1e-6;

/// The pins as points of the circles seen from the two points, and the target's positions.
pub struct Fit<'a> {
    target: &'a View<'a>,
    sources: Vec<Complex64>,
    targets: Vec<Complex64>,
    wanted: Vec<DVec3>,
}

fn on_circle(omega: f64) -> Complex64 {
    Complex64::from_polar(1.0, TAU * omega)
}

fn omega(z: Complex64) -> f64 {
    z.arg() / TAU
}

impl<'a> Fit<'a> {
    pub fn new(pairs: &[PerSide<f64>], source: &View<'_>, target: &'a View<'a>) -> Self {
        Self {
            target,
            sources: pairs.iter().map(|pair| on_circle(source.omega(pair.source))).collect(),
            targets: pairs.iter().map(|pair| on_circle(target.omega(pair.target))).collect(),
            wanted: pairs.iter().map(|pair| target.position(pair.target)).collect(),
        }
    }

    /// The best Möbius map found from those through each of these three pins.
    pub fn best(&self, triples: &[[usize; 3]]) -> Option<Moebius> {
        let through =
            |triple: &[usize; 3]| Moebius::through(triple.map(|k| self.sources[k]), triple.map(|k| self.targets[k]));
        let found = triples.iter().filter_map(through).map(|first| self.improved(first));
        found.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(map, _)| map)
    }

    /// The misses of a map.
    fn misses(&self, map: &Moebius) -> Vec<DVec3> {
        let images = self.target.positions(self.sources.iter().map(|&z| omega(map.apply(z))));
        images.into_iter().zip(&self.wanted).map(|(image, wanted)| image - wanted).collect()
    }

    /// Where the sum of squares is least near a map, and that sum.
    fn improved(&self, first: Moebius) -> (Moebius, f64) {
        let (mut map, mut misses) = (first, self.misses(&first));
        let (mut damping, mut normal) = (DAMPING, self.normal_equations(&map, &misses));
        for _ in 0..STEPS {
            let (matrix, gradient) = normal;
            let diagonal =
                DMat3::from_diagonal(damping * DVec3::new(matrix.x_axis.x, matrix.y_axis.y, matrix.z_axis.z));
            let step = -(matrix + diagonal).inverse().mul_vec3(gradient);
            let next = Moebius::small(step.x, Complex64::new(step.y, step.z)).map(|small| small.after(&map));
            let next = next.map(|next| (next, self.misses(&next)));
            match next.filter(|(_, found)| squares(found) < squares(&misses)) {
                Some(better) => {
                    (map, misses) = better;
                    damping *= LESS;
                    normal = self.normal_equations(&map, &misses);
                }
                None if damping < MOST => damping *= MORE,
                None => break,
            }
        }
        (map, squares(&misses))
    }

    /// JᵀJ and Jᵀr of the misses r, by (turn, Re a, Im a) of [`Moebius::small`].
    fn normal_equations(&self, map: &Moebius, misses: &[DVec3]) -> (DMat3, DVec3) {
        let images: Vec<Complex64> = self.sources.iter().map(|&z| map.apply(z)).collect();
        let shifted = |by: f64| self.target.positions(images.iter().map(|&z| omega(z) + by));
        let (mut matrix, mut gradient) = (DMat3::ZERO, DVec3::ZERO);
        for (((after, before), z), miss) in
            shifted(DIFFERENCE).into_iter().zip(shifted(-DIFFERENCE)).zip(&images).zip(misses)
        {
            let by_angle = (after - before) / (2.0 * DIFFERENCE * TAU);
            let by_unknowns = DVec3::new(1.0, -2.0 * z.im, 2.0 * z.re);
            let [a, b, c] = by_unknowns.to_array();
            let scale = by_angle.length_squared();
            matrix += DMat3::from_cols(scale * a * by_unknowns, scale * b * by_unknowns, scale * c * by_unknowns);
            gradient += by_angle.dot(*miss) * by_unknowns;
        }
        (matrix, gradient)
    }
}

fn squares(misses: &[DVec3]) -> f64 {
    misses.iter().map(|miss| miss.length_squared()).sum()
}
