//! The mapped mesh refined where images are long: folds and coverage on all pairs of presets at the default points.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{ConformalMap, Constraints, Direction, PrepareSettings, PreparedSide, Side};
use riemap::geometry::DVec2;
use riemap::outline::Preset;
use std::sync::Arc;
use support::domains::domain;

/// The numbers of one map.
#[derive(Debug, Clone, Copy)]
struct Numbers {
    triangles: usize,
    flipped: u32,
    /// The area inside the images of the boundary over that of the other domain.
    covered: f64,
    /// The area painted with the wrong orientation over that of the other domain.
    folded: f64,
    /// The longest image of a boundary edge over the length of the other boundary.
    longest: f64,
}

fn area(points: &[DVec2]) -> f64 {
    0.5 * points.windows(2).map(|w| (w[0] - points[0]).perp_dot(w[1] - points[0])).sum::<f64>()
}

impl Numbers {
    fn of(map: &ConformalMap) -> Self {
        let (mapped, images) = (map.mapped(), map.images());
        let other = map.domain(map.mapped_side().other()).unwrap().samples();
        let m = mapped.boundary_count();
        let quality = map.quality();
        let whole = area(other.points());
        let turned = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| images[v as usize]);
            (-0.5 * (b - a).perp_dot(c - a)).max(0.0)
        };
        let longest = (0..m).map(|k| images[k].distance(images[(k + 1) % m])).fold(0.0, f64::max);
        Self {
            triangles: mapped.triangles().len(),
            flipped: quality.flipped,
            covered: area(&images[..m]) / whole,
            folded: mapped.triangles().iter().map(turned).sum::<f64>() / whole,
            longest: longest / other.edge_lengths().iter().sum::<f64>(),
        }
    }

    fn flips(&self) -> f64 {
        f64::from(self.flipped) / self.triangles as f64
    }
}

fn refined(map: &ConformalMap) -> ConformalMap {
    map.refined(&PrepareSettings::default(), &mut |_| ()).unwrap().unwrap()
}

fn map_between(source: &Arc<PreparedSide>, target: &Arc<PreparedSide>, direction: Direction) -> ConformalMap {
    let constraints = Constraints::new((source.default_point(), 0.0), (target.default_point(), 0.0));
    ConformalMap::new(source.clone(), target.clone(), &constraints, direction.into()).unwrap()
}

/// Each preset onto each; a table with `--nocapture`.
#[test]
fn refined_maps_between_presets_fill_the_other_outline_without_folds() {
    let sides = Preset::ALL.map(|preset| (preset.name(), domain(preset, PrepareSettings::default())));
    for (a, source) in &sides {
        for (b, target) in &sides {
            // forward from a to b is backward from b to a
            let map = map_between(source, target, Direction::Forward);
            let fine = refined(&map);
            let (before, after) = (Numbers::of(&map), Numbers::of(&fine));
            let unresolved = fine.resolution().unwrap().unresolved_area();
            println!("{a} → {b}: {before:?}\n    refined: {after:?}, unresolved {unresolved:.2e}");
            assert!(after.flips() <= 1e-3, "{a} → {b}: {} of {} flipped", after.flipped, after.triangles);
            let covered = after.covered / (1.0 - unresolved);
            assert!((covered - 1.0).abs() < 1e-3, "{a} → {b}: {covered} of what is resolved is covered");
            assert!(after.folded < 1e-6, "{a} → {b}: {:e} is painted in folds", after.folded);
        }
    }
}

/// What the maps were like before: without the refinement these statements fail.
#[test]
fn a_coarse_map_into_the_v_folds_and_leaves_it() {
    let [disk, v] = [Preset::Disk, Preset::VShape].map(|preset| domain(preset, PrepareSettings::default()));
    let map = map_between(&disk, &v, Direction::Forward);
    let (coarse, fine) = (Numbers::of(&map), Numbers::of(&refined(&map)));
    assert!(coarse.flipped > 10 && coarse.longest > 0.1, "{coarse:?}");
    assert!(fine.flipped == 0 && fine.longest < 0.03, "{fine:?}");
}

/// The images of the boundary are those of the unrefined map where both have a vertex, up to the tenth of an edge by
/// which a vertex may be moved to a vertex of the other boundary.
#[test]
fn refinement_keeps_the_boundary_map() {
    let [heart, blob] = [Preset::Heart, Preset::Blob].map(|preset| domain(preset, PrepareSettings::default()));
    let map = map_between(&heart, &blob, Direction::Forward);
    let fine = refined(&map);
    let longest = blob.edge_lengths().iter().copied().fold(0.0, f64::max);
    let samples = fine.domain(Side::Source).unwrap().samples();
    for (k, point) in heart.domain().unwrap().samples().points().iter().enumerate() {
        let again = samples.points().iter().position(|p| p == point).unwrap();
        let moved = fine.images()[again].distance(map.images()[k]);
        assert!(moved <= 0.5 * longest, "vertex {k}: the image moved by {moved:e}, the edges have {longest:e}");
    }
    assert_eq!(fine.direction(), Direction::Forward);
    assert!(fine.measure(Side::Source).at_knots().windows(2).all(|w| w[0] <= w[1]));
}

/// A map that is refined can be dragged on: it becomes an ordinary map on the finer mesh.
#[test]
fn a_refined_map_follows_other_constraints() {
    let [square, star] = [Preset::Square, Preset::Star].map(|preset| domain(preset, PrepareSettings::default()));
    let mut fine = refined(&map_between(&square, &star, Direction::Backward));
    assert!(fine.resolution().is_some());
    let moved = Constraints::new((DVec2::new(0.1, 0.05), 0.3), (DVec2::new(-0.05, 0.1), 0.1));
    fine.update(&moved, Direction::Backward.into()).unwrap();
    assert!(fine.resolution().is_none());
    let direct = ConformalMap::new(square, fine.mapped().clone(), &moved, Direction::Backward.into()).unwrap();
    assert!(fine.images() == direct.images(), "the images differ from those of a new map on the same mesh");
}
