//! The number of poles inside of a boundary, by the argument principle.
//!
//! The poles of r are the zeros of the polynomial d = D Π (z − z_k), where D = Σ w_k/(z − z_k) is its denominator, and as
//! many of them lie inside as d winds around 0 along the boundary. Each step of the boundary is bisected until it lies in
//! a disk in which d has no zero: there the Taylor polynomial of D, times (z − z_k) for each support point close to the
//! disk, has a first term that is larger than all others, their remainder and their rounding. The argument of d then
//! turns by less than π along the step, so no turn is missed.
//!
//! Guaranteed: the count is that of the closed curve through the samples, which is the boundary between points that f64
//! tells apart, and straight between those that it does not. Only that the boundary stays in the disk of a step is taken
//! from the middle of the step. A pole that is on that curve to rounding leaves the count unknown. O(n) for a disk; a
//! step of the samples needs a few.

use super::function::Rational;
use super::samples::{Boundary, Samples, Step};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Terms of a Taylor polynomial of D. The remainder is then below 1.5·3⁻⁸ = 2e-4 of Σ |w_k/(z − z_k)| in a disk that has
/// all support points three radii away.
const TERMS: usize = 8;
/// Support points within so many radii of a disk's center are factors of their own: d is finite there, D is not.
const CLOSE: f64 = 3.0;
/// The most such factors; a disk with more is divided.
const MOST_CLOSE: usize = 4;
/// Bisections of a step in the boundary's parameter, and then of a chord.
const MOST_BISECTIONS: u32 = 50;
/// Disks tried for a step of the samples; bisecting towards one pole takes two for each bisection.
const MOST_DISKS: u32 = 2000;
/// How far from a multiple of 2π the turn of d may come out by rounding, in turns.
const ROUNDING: f64 = 0.01;

/// The count is unknown: d may vanish here, on the boundary to rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unresolved(pub Complex64);

/// The number of poles inside of a counter-clockwise boundary, by multiplicity. `samples` are those of the boundary.
pub fn poles_inside(function: &Rational, boundary: &dyn Boundary, samples: &Samples) -> Result<u32, Unresolved> {
    if function.degree() == 0 {
        return Ok(0);
    }
    let mut turned = 0.0;
    for k in 0..samples.points.len() {
        turned += turn_along(function, boundary, samples.step(k))?;
    }
    let turns = turned / TAU;
    let is_whole = (turns - turns.round()).abs() < ROUNDING && turns.round() >= 0.0;
    let somewhere = samples.points.first().map_or(Complex64::ZERO, |point| point.z);
    if is_whole { Ok(turns.round() as u32) } else { Err(Unresolved(somewhere)) }
}

/// The angle by which d turns along a step of the boundary. The step is bisected in the boundary's parameter while that
/// makes it shorter, and below rounding as a chord.
fn turn_along(function: &Rational, boundary: &dyn Boundary, step: Step) -> Result<f64, Unresolved> {
    let mut turn = 0.0;
    let mut pending = vec![(step, 0)];
    let mut disks = 0;
    while let Some((step, bisections)) = pending.pop() {
        let middle = step.middle(boundary);
        let chord = Chord::whole(step.ends());
        // an arc is nowhere farther from the middle of its chord than this
        let bulge = 2.0 * chord.at(0.5).minus(middle.z).norm();
        disks += 1;
        if let Some(angle) = chord.turn(function, bulge) {
            turn += angle;
        } else if disks > MOST_DISKS {
            return Err(Unresolved(middle.z));
        } else if bisections < MOST_BISECTIONS && chord.is_longer_than_halves(middle.z) {
            pending.extend(step.halves(middle).map(|half| (half, bisections + 1)));
        } else {
            turn += turn_along_chord(function, chord)?;
        }
    }
    Ok(turn)
}

/// The angle by which d turns along a straight step.
fn turn_along_chord(function: &Rational, chord: Chord) -> Result<f64, Unresolved> {
    let mut turn = 0.0;
    let mut pending = vec![(chord, 0)];
    while let Some((chord, bisections)) = pending.pop() {
        if let Some(angle) = chord.turn(function, 0.0) {
            turn += angle;
        } else if bisections < MOST_BISECTIONS {
            pending.extend(chord.halves().map(|half| (half, bisections + 1)));
        } else {
            return Err(Unresolved(chord.at(0.5).rounded()));
        }
    }
    Ok(turn)
}

/// A point between two points in f64, by its distance from the nearer one: it has more digits than its coordinates.
#[derive(Debug, Clone, Copy)]
struct Place {
    near: Complex64,
    offset: Complex64,
}

impl Place {
    fn minus(self, z: Complex64) -> Complex64 {
        (self.near - z) + self.offset
    }

    fn rounded(self) -> Complex64 {
        self.near + self.offset
    }
}

/// A part of the straight line between two points.
#[derive(Debug, Clone, Copy)]
struct Chord {
    ends: [Complex64; 2],
    shares: [f64; 2],
}

impl Chord {
    fn whole(ends: [Complex64; 2]) -> Self {
        Self { ends, shares: [0.0, 1.0] }
    }

    /// Whether the ends are farther from each other than from a point between them: by rounding they may not be.
    fn is_longer_than_halves(self, middle: Complex64) -> bool {
        let length = (self.ends[1] - self.ends[0]).norm();
        self.ends.iter().all(|&end| end != middle && (end - middle).norm() < length)
    }

    fn halves(self) -> [Self; 2] {
        let [from, to] = self.shares;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|shares| Self { shares, ..self })
    }

    /// The point at a share of this part.
    fn at(self, share: f64) -> Place {
        let [from, to] = self.shares;
        let share = from + share * (to - from);
        let whole = self.ends[1] - self.ends[0];
        // a support point is at an end, if it is on the line: differences from it have no rounding but their own
        let (near, offset) = if share <= 0.5 { (self.ends[0], share) } else { (self.ends[1], share - 1.0) };
        Place { near, offset: offset * whole }
    }

    /// The angle by which d turns along this part; `None` where it may have a zero in a disk around it that is larger
    /// by `bulge`.
    fn turn(self, function: &Rational, bulge: f64) -> Option<f64> {
        let length = (self.shares[1] - self.shares[0]) * (self.ends[1] - self.ends[0]).norm();
        let radius = 0.5 * length + bulge;
        if radius == 0.0 {
            return Some(0.0);
        }
        let close = close_without_zero(function, self.at(0.5), radius)?;
        let angle = turn_between(function, [self.at(0.0), self.at(1.0)], radius, &close);
        angle.is_finite().then_some(angle)
    }
}

/// The support points close to a disk, if d is shown to have no zero in the disk.
fn close_without_zero(function: &Rational, center: Place, radius: f64) -> Option<Vec<usize>> {
    let mut expansion = Expansion::default();
    let mut close = Vec::new();
    for (k, (&point, &weight)) in function.support().iter().zip(function.weights()).enumerate() {
        let difference = center.minus(point) / radius;
        if difference.norm() > CLOSE {
            expansion.add(weight, difference.inv());
        } else if close.len() < MOST_CLOSE {
            close.push(k);
        } else {
            return None;
        }
    }
    let rounding = f64::EPSILON * (function.support().len() + 4 * TERMS) as f64;
    expansion.remainder += rounding * expansion.size;
    for &k in &close {
        expansion.multiply(function.weights()[k], center.minus(function.support()[k]) / radius);
    }
    expansion.has_no_zero().then_some(close)
}

/// The Taylor polynomial of D Π (z − z_k) over the close support points, in radii from the center of a disk.
#[derive(Debug, Default)]
struct Expansion {
    terms: [Complex64; TERMS + MOST_CLOSE],
    /// The polynomial Π (z − z_k).
    factors: Vec<Complex64>,
    /// A bound of what is not in the terms, anywhere in the disk.
    remainder: f64,
    /// A bound of the sum of the sizes of all terms.
    size: f64,
}

impl Expansion {
    /// Adds w/(z − z_k), with q = 1/(c − z_k): Σ_j w q (−q)^j t^j.
    fn add(&mut self, weight: Complex64, q: Complex64) {
        let mut term = weight * q;
        let size = term.norm();
        for sum in &mut self.terms[..TERMS] {
            *sum += term;
            term *= -q;
        }
        let beyond = 1.0 / (1.0 - q.norm());
        self.remainder += term.norm() * beyond;
        self.size += size * beyond;
    }

    /// Adds w/(z − z_k) for a close support point, and multiplies by z − z_k: E (z − z_k) + w Π with the factors so far.
    fn multiply(&mut self, weight: Complex64, difference: Complex64) {
        if self.factors.is_empty() {
            self.factors.push(Complex64::ONE);
        }
        let times = |terms: &mut [Complex64]| {
            for j in (0..terms.len()).rev() {
                let below = if j > 0 { terms[j - 1] } else { Complex64::ZERO };
                terms[j] = terms[j] * difference + below;
            }
        };
        times(&mut self.terms);
        self.terms.iter_mut().zip(&self.factors).for_each(|(term, factor)| *term += weight * factor);
        let most: f64 = self.factors.iter().map(|factor| factor.norm()).sum();
        self.factors.push(Complex64::ZERO);
        times(&mut self.factors);
        let largest = difference.norm() + 1.0;
        let rounding = f64::EPSILON * (4 * TERMS) as f64;
        self.size = self.size * largest + weight.norm() * most;
        self.remainder = self.remainder * largest + rounding * self.size;
    }

    /// Whether the first term is larger than all that may be added to it in the disk.
    fn has_no_zero(&self) -> bool {
        let others: f64 = self.terms[1..].iter().map(|term| term.norm()).sum();
        self.terms[0].norm() > others + self.remainder
    }
}

/// The angle by which d turns between the ends of a step inside of a disk without zeros, whose close support points are
/// given. Each of the others is seen under less than a right angle.
fn turn_between(function: &Rational, ends: [Place; 2], radius: f64, close: &[usize]) -> f64 {
    let mut values = [Complex64::ZERO; 2];
    let mut angle = 0.0;
    for (k, (&point, &weight)) in function.support().iter().zip(function.weights()).enumerate() {
        if close.contains(&k) {
            continue;
        }
        let [a, b] = ends.map(|end| end.minus(point) / radius);
        values[0] += weight / a;
        values[1] += weight / b;
        angle += (b / a).arg();
    }
    let mut factors = [Complex64::ONE; 2];
    for &k in close {
        for (end, (value, factor)) in ends.iter().zip(values.iter_mut().zip(&mut factors)) {
            let difference = end.minus(function.support()[k]) / radius;
            *value = *value * difference + function.weights()[k] * *factor;
            *factor *= difference;
        }
    }
    angle + (values[1] / values[0]).arg()
}
