//! The downhill simplex (Nelder & Mead, Computer Journal 7 (1965)) in three unknowns, as questions and answers, so that a
//! caller may take its time between them.
//!
//! Coefficients are the usual ones: reflection 1, expansion 2, contraction and shrinking ½. It ends when the simplex is
//! small; a value that is not a number counts as infinite. Guaranteed: the best vertex is never worse than the first one.

use crate::geometry::DVec3;

/// A place and its value.
type Vertex = (DVec3, f64);

/// What the value that is asked for next is for.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Asked {
    /// Corner k of the first simplex, or of one that was shrunk.
    Corner(usize),
    Reflected,
    Expanded(Vertex),
    Contracted(Vertex),
}

/// A simplex of four places, sorted by their values from the second question on.
#[derive(Debug, Clone)]
pub struct Simplex {
    vertices: [Vertex; 4],
    asked: Asked,
    place: DVec3,
    smallest: f64,
}

impl Simplex {
    /// Begins at `first`, with three more corners at the distance `step`; ends at the size `smallest`. A value of `first` that
    /// is infinite is asked for.
    pub fn new((first, value): Vertex, step: f64, smallest: f64) -> Self {
        let corner = |axis: DVec3| (first + step * axis, f64::INFINITY);
        let vertices = [(first, value), corner(DVec3::X), corner(DVec3::Y), corner(DVec3::Z)];
        let asked = usize::from(value < f64::INFINITY);
        Self { vertices, asked: Asked::Corner(asked), place: vertices[asked].0, smallest }
    }

    /// The place whose value is wanted next; `None`: the simplex is small.
    pub fn question(&self) -> Option<DVec3> {
        let size = self.vertices[1..].iter().map(|vertex| vertex.0.distance(self.vertices[0].0)).fold(0.0, f64::max);
        (size > self.smallest).then_some(self.place)
    }

    /// The best place so far and its value.
    #[cfg(test)]
    fn best(&self) -> Vertex {
        self.vertices.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(self.vertices[0])
    }

    /// Takes the value at the place of the question.
    pub fn answer(&mut self, value: f64) {
        let value = if value.is_nan() { f64::INFINITY } else { value };
        let found = (self.place, value);
        let [best, _, second_worst, worst] = self.vertices.map(|vertex| vertex.1);
        match self.asked {
            Asked::Corner(k) => {
                self.vertices[k].1 = value;
                self.ask_corner_or_reflect(k + 1);
            }
            Asked::Reflected if value < best => self.ask(Asked::Expanded(found), self.along(2.0)),
            Asked::Reflected if value < second_worst => self.replace(found),
            Asked::Reflected if value < worst => self.ask(Asked::Contracted(found), self.along(0.5)),
            Asked::Reflected => self.ask(Asked::Contracted(self.vertices[3]), self.along(-0.5)),
            Asked::Expanded(reflected) => self.replace(if value < reflected.1 { found } else { reflected }),
            Asked::Contracted(other) if value < other.1 => self.replace(found),
            Asked::Contracted(_) => self.shrink(),
        }
    }

    fn ask(&mut self, asked: Asked, place: DVec3) {
        (self.asked, self.place) = (asked, place);
    }

    fn ask_corner_or_reflect(&mut self, k: usize) {
        if k < self.vertices.len() {
            return self.ask(Asked::Corner(k), self.vertices[k].0);
        }
        self.vertices.sort_by(|a, b| a.1.total_cmp(&b.1));
        self.ask(Asked::Reflected, self.along(1.0));
    }

    /// The place on the line from the worst vertex through the middle of the others, beyond that middle.
    fn along(&self, factor: f64) -> DVec3 {
        let middle = self.vertices[..3].iter().map(|vertex| vertex.0).sum::<DVec3>() / 3.0;
        middle + factor * (middle - self.vertices[3].0)
    }

    /// Puts a vertex in the place of the worst one.
    fn replace(&mut self, vertex: Vertex) {
        self.vertices[3] = vertex;
        self.ask_corner_or_reflect(self.vertices.len());
    }

    fn shrink(&mut self) {
        let best = self.vertices[0].0;
        self.vertices[1..].iter_mut().for_each(|vertex| vertex.0 = best + 0.5 * (vertex.0 - best));
        self.ask_corner_or_reflect(1);
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn minimized(f: impl Fn(DVec3) -> f64, first: DVec3, smallest: f64) -> (Vertex, usize) {
        let mut simplex = Simplex::new((first, f(first)), 0.3, smallest);
        let mut count = 0;
        while let Some(place) = simplex.question().filter(|_| count < 2000) {
            simplex.answer(f(place));
            count += 1;
        }
        (simplex.best(), count)
    }

    #[test]
    fn a_skew_valley_is_followed_to_its_bottom() {
        let bottom = DVec3::new(0.3, -1.0, 2.0);
        let f = |p: DVec3| {
            let d = p - bottom;
            d.x * d.x + 50.0 * (d.y - d.x).powi(2) + 3.0 * (d.z + d.y).powi(2)
        };
        let ((place, value), count) = minimized(f, DVec3::ZERO, 1e-7);
        println!("{count} values: {place}, {value:e}");
        assert!(place.distance(bottom) < 1e-5 && count < 400, "{place} after {count}");
    }

    /// The steps of Nelder and Mead (1965) from the corners 0, x, y, z with the values 0, 1, 2, 4: the worst one is z, and
    /// the middle of the others (⅓, ⅓, 0).
    #[test]
    fn each_answer_leads_to_the_step_of_the_method() {
        let begun = || {
            let mut simplex = Simplex::new((DVec3::ZERO, 0.0), 1.0, 1e-6);
            for value in [1.0, 2.0, 4.0] {
                simplex.answer(value);
            }
            simplex
        };
        let asked = |answers: &[f64]| {
            let mut simplex = begun();
            for &value in answers {
                simplex.answer(value);
            }
            simplex.question().unwrap()
        };
        let near = |place: DVec3, x: f64, y: f64, z: f64| {
            assert!(place.distance(DVec3::new(x, y, z)) < 1e-15, "{place}");
        };
        let third = 1.0 / 3.0;
        near(asked(&[]), 2.0 * third, 2.0 * third, -1.0);
        near(asked(&[-1.0]), 1.0, 1.0, -2.0); // better than the best one: expanded
        near(asked(&[3.0]), 0.5, 0.5, -0.5); // worse than all but the worst one: contracted outside
        near(asked(&[5.0]), third / 2.0, third / 2.0, 0.5); // worse than all: contracted inside
        near(asked(&[5.0, 6.0]), 0.5, 0.0, 0.0); // that is no better: shrunk to the best one
        // between the best one and the second worst one it replaces the worst one, y is then the worst one
        near(asked(&[0.5]), 10.0 / 9.0, -5.0 / 9.0, -2.0 * third);
    }

    #[test]
    fn places_without_a_value_are_avoided_and_the_first_is_never_given_up_for_worse() {
        let wall = |p: DVec3| if p.x < 0.1 { f64::NAN } else { (p - DVec3::new(0.2, 0.0, 0.0)).length() };
        let ((place, value), _) = minimized(wall, DVec3::new(0.15, 0.5, 0.5), 1e-6);
        assert!(value < 1e-4, "{place}: {value}");
        let (best, _) = minimized(|p| if p == DVec3::ZERO { 1.0 } else { f64::NAN }, DVec3::ZERO, 1e-3);
        assert_eq!(best, (DVec3::ZERO, 1.0));
    }
}
