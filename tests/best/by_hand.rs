//! The least value of a criterion over a family by brute force: maps on a grid, then steps in each unknown, ever shorter.

use super::{defaults, measured};
use riemap::conformal::{Constraints, Direction, PerSide, PreparedSide, Side};
use riemap::geometry::DVec2;
use riemap::optimization::Criterion;
use std::sync::Arc;

/// Places of x₁ and boundary points of the target on the grid.
const PLACES: usize = 12;
const TURNS: u32 = 8;

/// Maps of the grid from which steps begin.
const STARTS: usize = 3;

/// The first and last step, in units of the source's plane and fractions of the target's boundary.
const STEP: f64 = 0.1;
const LAST_STEP: f64 = 1e-3;

/// Where steps from the best maps of a grid end, the values there.
pub fn ends(sides: &PerSide<Arc<PreparedSide>>, criterion: &Criterion, direction: Direction) -> Vec<f64> {
    let value = |at: &Constraints| measured(sides, criterion, at, direction);
    let mesh = sides.source.domain().unwrap().mesh();
    let inner = &mesh.vertices()[sides.source.boundary_count()..];
    let places = inner.iter().step_by(inner.len() / PLACES);
    let mut grid: Vec<(f64, Constraints)> = places
        .flat_map(|&x| (0..TURNS).map(move |k| (x, f64::from(k) / f64::from(TURNS))))
        .map(|(x, anchor)| defaults(sides).with_point(Side::Source, x).with_anchor(Side::Target, anchor))
        .map(|at| (value(&at), at))
        .collect();
    grid.sort_by(|a, b| a.0.total_cmp(&b.0));
    grid.into_iter().take(STARTS).map(|start| descended(start, value)).collect()
}

fn descended((mut least, mut at): (f64, Constraints), value: impl Fn(&Constraints) -> f64) -> f64 {
    let mut step = STEP;
    while step > LAST_STEP {
        let x = at.points.source.in_plane().unwrap();
        let moved = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].map(|d| at.with_point(Side::Source, x + step * d));
        let turned =
            [1.0, -1.0].map(|sign| at.with_anchor(Side::Target, (at.anchors.target + sign * step).rem_euclid(1.0)));
        let values = moved.into_iter().chain(turned).map(|near| (value(&near), near));
        let lower = values.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|near| near.0 < least);
        match lower {
            Some(near) => (least, at) = near,
            None => step *= 0.5,
        }
    }
    least
}
