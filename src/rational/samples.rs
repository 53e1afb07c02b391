//! Pairs (z, f(z)) on a boundary: dense where it or its image is long, and clustered exponentially at break points.
//!
//! The boundary is cut at its break points into arcs, and each arc in its middle into two rays. A point of a ray is
//! named by its offset from the break point, 0 there and 1 in the middle, so that offsets of 1e-15 are told apart.
//! Clustering by a constant ratio resolves singularities of type s^a and s^n log s (Gopal and Trefethen 2019).

use num_complex::Complex64;

/// A boundary with a map that is defined on it.
pub trait Boundary {
    /// The number of rays, even: ray 2k begins at break point k and ends in the middle of arc k, where ray 2k + 1 ends,
    /// which begins at the next break point.
    fn rays(&self) -> usize;

    /// Whether the map may be singular at the beginning of a ray.
    fn is_singular(&self, ray: usize) -> bool;

    /// z and f(z) at an offset in [0, 1] of a ray.
    fn pair(&self, ray: usize, offset: f64) -> [Complex64; 2];
}

/// What a point of the boundary is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A row of the least-squares problem.
    Test,
    /// A possible support point.
    Candidate,
}

/// A pair with its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    ray: usize,
    offset: f64,
    pub role: Role,
    pub z: Complex64,
    pub value: Complex64,
}

/// Points in the order of the boundary.
#[derive(Debug, Clone)]
pub struct Samples {
    pub points: Vec<Sample>,
    /// Half the larger side of the box around all z, and around all values.
    pub extents: [f64; 2],
    /// The relative rounding of z and of values.
    epsilon: f64,
}

/// Ratio of offsets from a singular break point: four points for each power of ten.
const RATIO: f64 = 0.562_341_325_190_349;
/// The largest step of z, and of f(z), in extents. At 0.02 a smooth outline has 150 test points, fewer than the
/// cinquefoil needs support points.
const LONGEST: f64 = 0.006;
/// Steps of z below this, in extents and relative roundings, cannot be told apart.
const ROUNDING: f64 = 2.0;
/// The share of the tolerance up to which values at the end of a ray count as the value at its break point.
const SAME_VALUE: f64 = 0.02;
/// The uncertainty of a value, in rounding errors of z times the slope plus those of the value.
const ROUNDINGS: f64 = 3.0;
/// The most points: enough for every built-in pair by more than twice.
const MOST_POINTS: usize = 20_000;

impl Samples {
    /// Points for a fit to this tolerance, relative to the extent of the values, of numbers with the relative rounding
    /// `epsilon`.
    pub fn new(boundary: &dyn Boundary, tolerance: f64, epsilon: f64) -> Self {
        let mut samples = Self { points: Vec::new(), extents: [0.0; 2], epsilon };
        for ray in 0..boundary.rays() {
            let offsets = [0.0, 0.25, 0.5, 0.75].into_iter().chain((ray % 2 == 0).then_some(1.0));
            samples.points.extend(offsets.map(|offset| sample(boundary, ray, offset)));
        }
        samples.extents = [extent(samples.points.iter().map(|p| p.z)), extent(samples.points.iter().map(|p| p.value))];
        let mut points = Vec::new();
        for arc in 0..boundary.rays() / 2 {
            points.extend(samples.ray(boundary, 2 * arc, tolerance));
            let mut back = samples.ray(boundary, 2 * arc + 1, tolerance);
            // its break point and the middle belong to other rays
            back.retain(|point| point.offset > 0.0 && point.offset < 1.0);
            points.extend(back.into_iter().rev());
        }
        samples.points = points;
        samples.remove_coinciding();
        samples.shorten(boundary);
        for (k, point) in samples.points.iter_mut().enumerate() {
            point.role = if k % 2 == 0 { Role::Candidate } else { Role::Test };
        }
        samples
    }

    /// The points of a ray from its break point on.
    fn ray(&self, boundary: &dyn Boundary, ray: usize, tolerance: f64) -> Vec<Sample> {
        if !boundary.is_singular(ray) {
            return [0.0, 0.25, 0.5, 0.75, 1.0].map(|offset| sample(boundary, ray, offset)).to_vec();
        }
        let first = sample(boundary, ray, 0.0);
        let mut points = Vec::new();
        let mut offset = 1.0;
        while offset > f64::MIN_POSITIVE {
            let point = sample(boundary, ray, offset);
            points.push(point);
            let is_same = (point.value - first.value).norm() < SAME_VALUE * tolerance * self.extents[1];
            if is_same || (point.z - first.z).norm() < self.least_step() {
                break;
            }
            offset *= RATIO;
        }
        points.push(first);
        points.reverse();
        points
    }

    /// Inserts points until no step is longer than [`LONGEST`].
    fn shorten(&mut self, boundary: &dyn Boundary) {
        loop {
            let before = self.points.len();
            let [of_z, of_values] = self.extents.map(|extent| LONGEST * extent);
            let is_long = |a: &Sample, b: &Sample| (a.z - b.z).norm() > of_z || (a.value - b.value).norm() > of_values;
            self.insert(boundary, 1, |_, a, b| is_long(a, b));
            if self.points.len() == before {
                return;
            }
        }
    }

    /// Inserts `count` points into each step that is chosen by its index and ends, except where z cannot be told apart;
    /// none beyond [`MOST_POINTS`].
    pub fn insert(&mut self, boundary: &dyn Boundary, count: usize, chosen: impl Fn(usize, &Sample, &Sample) -> bool) {
        let mut points = Vec::with_capacity(self.points.len());
        let mut total = self.points.len();
        for (k, point) in self.points.iter().enumerate() {
            points.push(*point);
            let next = &self.points[(k + 1) % self.points.len()];
            if total + count <= MOST_POINTS && chosen(k, point, next) {
                let mut role = point.role;
                for sample in self.between(boundary, k, count) {
                    let before = points.last().unwrap_or(point);
                    if [before.z, next.z].iter().all(|z| (z - sample.z).norm() >= self.least_step()) {
                        role = if role == Role::Test { Role::Candidate } else { Role::Test };
                        points.push(Sample { role, ..sample });
                        total += 1;
                    }
                }
            }
        }
        self.points = points;
    }

    /// `count` points between point `k` and the next one.
    pub fn between(&self, boundary: &dyn Boundary, k: usize, count: usize) -> Vec<Sample> {
        let (a, b) = (&self.points[k], &self.points[(k + 1) % self.points.len()]);
        let (ray, from, to) = if a.ray == b.ray {
            (a.ray, a.offset, b.offset)
        } else if a.ray % 2 == 0 {
            // over the middle of an arc
            (b.ray, 1.0, b.offset)
        } else {
            (a.ray, a.offset, 0.0)
        };
        let at = |part: usize| {
            let share = part as f64 / (count + 1) as f64;
            sample(boundary, ray, offset_between(from, to, share))
        };
        (1..=count).map(at).collect()
    }

    /// How far values between point `k` and the next one may be from those at the rounded z, by the slope.
    pub fn uncertainty(&self, k: usize) -> f64 {
        let (a, b) = (&self.points[k], &self.points[(k + 1) % self.points.len()]);
        let slope = (a.value - b.value).norm() / (a.z - b.z).norm();
        ROUNDINGS * self.epsilon * (slope * a.z.norm() + a.value.norm())
    }

    /// The factor of the error at point `k` in a fit to this absolute tolerance: less than 1 where its value is known less
    /// well.
    pub fn factor(&self, k: usize, tolerance: f64) -> f64 {
        let before = (k + self.points.len() - 1) % self.points.len();
        tolerance / tolerance.max(self.uncertainty(k)).max(self.uncertainty(before))
    }

    /// The longest step of values where points can be told apart.
    pub fn longest_step(&self) -> f64 {
        LONGEST * self.extents[1]
    }

    /// The largest distance between the values of neighbors: more than [`Self::longest_step`] only where there is no point
    /// between them whose z could be told apart from theirs.
    pub fn largest_jump(&self) -> f64 {
        let neighbors = self.points.iter().zip(self.points.iter().cycle().skip(1));
        neighbors.map(|(a, b)| (a.value - b.value).norm()).fold(0.0, f64::max)
    }

    /// Steps of z below this length cannot be told apart.
    fn least_step(&self) -> f64 {
        ROUNDING * self.epsilon * self.extents[0]
    }

    /// Removes points whose z is that of the point before.
    fn remove_coinciding(&mut self) {
        let least = self.least_step();
        self.points.dedup_by(|b, a| (b.z - a.z).norm() < least);
        while let [first, .., last] = self.points.as_slice()
            && (first.z - last.z).norm() < least
        {
            self.points.pop();
        }
    }
}

/// The offset at a share of the way between two: in proportion where one is many times the other, else in equal steps.
fn offset_between(from: f64, to: f64, share: f64) -> f64 {
    const MANY: f64 = 3.0;
    if from.min(to) > 0.0 && from.max(to) > MANY * from.min(to) {
        return from.powf(1.0 - share) * to.powf(share);
    }
    from + share * (to - from)
}

fn sample(boundary: &dyn Boundary, ray: usize, offset: f64) -> Sample {
    let [z, value] = boundary.pair(ray, offset);
    Sample { ray, offset, role: Role::Test, z, value }
}

/// Half the larger side of the box around points.
fn extent(points: impl Iterator<Item = Complex64>) -> f64 {
    let mut bounds = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    for z in points {
        bounds = [bounds[0].min(z.re), bounds[1].max(z.re), bounds[2].min(z.im), bounds[3].max(z.im)];
    }
    0.5 * (bounds[1] - bounds[0]).max(bounds[3] - bounds[2])
}
