//! Whether a closed chain of distinct points crosses or touches itself.
//!
//! Shamos and Hoey's sweep, for a polygon: points are visited in
//! lexicographic order, and the edges over the sweep line are kept ordered from
//! bottom to top. At most vertices an edge is replaced by its neighbor in
//! place. Every decision is an exact sign, so the answer is exact for every
//! input in range, at cost O(n log n) for every shape.
//!
//! Completeness: let `p` be the lexicographically first point common to two
//! edges (other than the vertex that adjacent edges share). Before `p` the order
//! is correct, so the edges through `p` are neighbors in it and were compared
//! when they became so; or `p` is a vertex where two edges begin, and the search
//! for their place in the order finds the edge that contains `p`.

use glam::DVec2;

use super::PolygonError;
use super::predicates::{Side, in_box, orientation, side};
use super::status::{Place, Status};

/// The first contact found between two parts of the boundary as an error; `Ok` if there is none.
///
/// `order` holds all point indices sorted by (x, y); no two points are equal.
pub(super) fn check_simple(points: &[DVec2], order: &[u32]) -> Result<(), PolygonError> {
    let mut rank = vec![0; points.len()];
    for (r, &k) in order.iter().enumerate() {
        rank[k as usize] = r as u32;
    }
    let mut sweep = Sweep { points, rank, status: Status::default() };
    order.iter().try_for_each(|&k| sweep.visit(k))
}

struct Sweep<'a> {
    points: &'a [DVec2],
    /// Position of each point in the lexicographic order.
    rank: Vec<u32>,
    status: Status,
}

impl Sweep<'_> {
    fn visit(&mut self, k: u32) -> Result<(), PolygonError> {
        let (arriving, leaving) = (self.before(k), k);
        let (previous, next) = (self.before(k), self.after(k));
        let rank = |i: u32| self.rank[i as usize];
        match (rank(previous) < rank(k), rank(next) < rank(k)) {
            (true, false) => self.continue_edge(k, arriving, leaving),
            (false, true) => self.continue_edge(k, leaving, arriving),
            (false, false) => self.open(k, [(arriving, previous), (leaving, next)]),
            (true, true) => self.close(k, previous, next),
        }
    }

    /// `ended` ends at point `k`, where `begun` begins and takes its place.
    fn continue_edge(&mut self, k: u32, ended: u32, begun: u32) -> Result<(), PolygonError> {
        let place = self.place_of(k);
        self.expect_edge(k, place, &[ended])?;
        self.status.replace(place, begun);
        self.compare(self.status.before(place), Some(begun))?;
        self.compare(Some(begun), self.status.get(self.status.next(place)))
    }

    /// Two edges, each with its far end, begin at point `k`.
    fn open(&mut self, k: u32, [(e, e_end), (f, f_end)]: [(u32, u32); 2]) -> Result<(), PolygonError> {
        let place = self.place_of(k);
        if let Some(edge) = self.status.get(place) {
            let (l, r) = self.ends(edge);
            if side(l, r, self.at(k)) == Side::On {
                return Err(touch(k, edge, self.at(k)));
            }
        }
        let (lower, upper) = match side(self.at(k), self.at(e_end), self.at(f_end)) {
            Side::Left => (e, f),
            Side::Right => (f, e),
            Side::On => return Err(PolygonError::FoldsBack { index: k as usize, at: self.at(k) }),
        };
        self.compare(self.status.before(place), Some(lower))?;
        self.compare(Some(upper), self.status.get(place))?;
        self.status.insert_pair(place, lower, upper);
        Ok(())
    }

    /// Both edges at point `k` end there.
    fn close(&mut self, k: u32, previous: u32, next: u32) -> Result<(), PolygonError> {
        if side(self.at(previous), self.at(k), self.at(next)) == Side::On {
            return Err(PolygonError::FoldsBack { index: k as usize, at: self.at(k) });
        }
        let mut place = self.place_of(k);
        for _ in 0..2 {
            self.expect_edge(k, place, &[k, self.before(k)])?;
            place = self.status.remove(place);
        }
        self.compare(self.status.before(place), self.status.get(place))
    }

    /// Checks that the edges at `k`'s place in the order are those that end there: any other
    /// edge found at that place passes through the same point.
    fn expect_edge(&self, k: u32, place: Place, expected: &[u32]) -> Result<(), PolygonError> {
        match self.status.get(place) {
            Some(found) if expected.contains(&found) => Ok(()),
            Some(found) => Err(touch(k, found, self.at(k))),
            None => Err(touch(k, self.before(k), self.at(k))),
        }
    }

    /// The first place in the status whose edge is not below point `k`.
    fn place_of(&self, k: u32) -> Place {
        let p = self.at(k);
        self.status.search(|edge| {
            let (l, r) = self.ends(edge);
            side(l, r, p) == Side::Left
        })
    }

    /// An error if two edges, now neighbours in the status, meet anywhere.
    fn compare(&self, lower: Option<u32>, upper: Option<u32>) -> Result<(), PolygonError> {
        let (Some(e), Some(f)) = (lower, upper) else { return Ok(()) };
        if self.after(e) == f || self.after(f) == e {
            // They share a vertex; folding back there is found at that vertex.
            return Ok(());
        }
        let (a, b) = (self.at(e), self.at(self.after(e)));
        let (c, d) = (self.at(f), self.at(self.after(f)));
        match contact(a, b, c, d) {
            None => Ok(()),
            Some(Contact::Touch(at)) => Err(touch(e, f, at)),
            Some(Contact::Cross(at)) => {
                Err(PolygonError::EdgesCross { first: e.min(f) as usize, second: e.max(f) as usize, at })
            }
        }
    }

    fn at(&self, k: u32) -> DVec2 {
        self.points[k as usize]
    }

    fn after(&self, k: u32) -> u32 {
        if k as usize + 1 == self.points.len() { 0 } else { k + 1 }
    }

    fn before(&self, k: u32) -> u32 {
        if k == 0 { self.points.len() as u32 - 1 } else { k - 1 }
    }

    /// The ends of an edge, lexicographically smaller first.
    fn ends(&self, edge: u32) -> (DVec2, DVec2) {
        let (a, b) = (edge, self.after(edge));
        if self.rank[a as usize] < self.rank[b as usize] { (self.at(a), self.at(b)) } else { (self.at(b), self.at(a)) }
    }
}

fn touch(e: u32, f: u32, at: DVec2) -> PolygonError {
    PolygonError::EdgesTouch { first: e.min(f) as usize, second: e.max(f) as usize, at }
}

enum Contact {
    Cross(DVec2),
    Touch(DVec2),
}

/// How the closed segments `ab` and `cd` meet, if they do; no ends are equal.
fn contact(a: DVec2, b: DVec2, c: DVec2, d: DVec2) -> Option<Contact> {
    if a.max(b).cmplt(c.min(d)).any() || c.max(d).cmplt(a.min(b)).any() {
        return None;
    }
    let (c_side, d_side) = (orientation(a, b, c), orientation(a, b, d));
    let (a_side, b_side) = (orientation(c, d, a), orientation(c, d, b));
    let opposite = |s: f64, t: f64| (s < 0.0 && t > 0.0) || (s > 0.0 && t < 0.0);
    if opposite(c_side, d_side) && opposite(a_side, b_side) {
        return Some(Contact::Cross(a.lerp(b, a_side / (a_side - b_side))));
    }
    let ends = [(c_side, a, b, c), (d_side, a, b, d), (a_side, c, d, a), (b_side, c, d, b)];
    ends.into_iter().find(|&(s, p, q, x)| s == 0.0 && in_box(p, q, x)).map(|(.., x)| Contact::Touch(x))
}
