//! Layouts that reach the corners of their outline: areas, exact places, numbers and shapes of the parts.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use riemap::conformal::{
    ConformalMap, Constraints, CornerCuts, Divided, MapSettings, PrepareSettings, PreparedSide, SurfaceSettings,
    prepare, prepare_surface,
};
use riemap::geometry::{DVec2, DVec3, SimplePolygon};
use riemap::mesh::locate;
use riemap::outline::{Outline, Preset, Sampling};
use riemap::surface::{Surface, SurfaceMesh, SurfacePreset};
use std::f64::consts::TAU;
use std::sync::Arc;

fn outline(vertices: &[[f64; 2]]) -> Outline {
    let vertices: Vec<DVec2> = vertices.iter().copied().map(DVec2::from_array).collect();
    Outline::new("", SimplePolygon::try_from(vertices).unwrap())
}

fn prepared(surface: &Surface) -> Arc<PreparedSide> {
    let mesh = SurfaceMesh::new(surface).unwrap();
    Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap())
}

/// The surface over the outline with 300 samples, its corners among them, from the default points and these anchors.
fn map(surface: &Surface, outline: &Outline, anchors: [f64; 2]) -> ConformalMap {
    let settings = PrepareSettings::default().with_sampling(Sampling::Uniform { count: 300, keep_corners: true });
    let source = Arc::new(prepare(outline.polygon(), &settings, &mut |_| ()).unwrap());
    let target = prepared(surface);
    let points = [source.default_point(), target.default_point()];
    let constraints = Constraints::new((points[0], anchors[0]), (points[1], anchors[1]));
    ConformalMap::new(source, target, &constraints, MapSettings::default()).unwrap()
}

fn mesh(map: &ConformalMap) -> &SurfaceMesh {
    map.mapped().surface().unwrap().surface()
}

fn places(map: &ConformalMap, cuts: &CornerCuts) -> Vec<DVec3> {
    let own = mesh(map).mesh().vertices().iter().copied();
    own.chain(cuts.added().iter().map(|added| added.place)).collect()
}

/// Twice the area vector of a triangle in space.
fn normal(places: &[DVec3], triangle: [u32; 3]) -> DVec3 {
    let [a, b, c] = triangle.map(|v| places[v as usize]);
    (b - a).cross(c - a)
}

fn layout_area(cuts: &CornerCuts) -> f64 {
    let area = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| cuts.images()[v as usize]);
        0.5 * (b - a).perp_dot(c - a)
    };
    cuts.triangles().iter().map(area).sum()
}

/// Checks what every cut guarantees; returns it.
fn checked(map: &ConformalMap, outline: &Outline) -> CornerCuts {
    let corners = outline.corner_places();
    let cuts = map.cut_corners(&corners).unwrap();
    for (corner, vertex) in corners.iter().zip(cuts.at_corners()) {
        assert_eq!(cuts.images()[vertex.index()], *corner, "to the bit");
    }
    let mut hit: Vec<u32> = cuts.at_corners().iter().map(|vertex| vertex.number()).collect();
    hit.sort_unstable();
    hit.dedup();
    assert_eq!(hit.len(), corners.len(), "each corner has a vertex of its own");
    let (own, places) = (mesh(map).mesh(), places(map, &cuts));
    assert_eq!(cuts.images().len(), places.len());
    let mut sums = vec![DVec3::ZERO; own.triangles().len()];
    for (k, &triangle) in cuts.triangles().iter().enumerate() {
        let (part, parent) = (normal(&places, triangle), cuts.parent(k));
        let whole = normal(&places, own.triangles()[parent.index()]);
        let share = part.dot(whole) / whole.length_squared();
        assert!(share > 1e-5, "triangle {k} has the share {share:e} of its parent");
        sums[parent.index()] += part;
    }
    for (sum, &triangle) in sums.iter().zip(own.triangles()) {
        let whole = normal(&places, triangle);
        assert!((*sum - whole).length() < 1e-12 * whole.length(), "the parts are the triangle");
    }
    for added in cuts.added() {
        if let Divided::Edge { ends, fraction } = added.divides {
            let [a, b] = ends.map(|v| own.vertices()[v.index()]);
            assert_eq!(added.place, a.lerp(b, fraction));
            let has_both = |t: &&[u32; 3]| ends.iter().all(|end| t.contains(&end.number()));
            assert!((1..=2).contains(&own.triangles().iter().filter(has_both).count()), "{ends:?} is an edge");
        }
    }
    cuts
}

#[test]
fn the_layout_of_a_square_is_the_whole_square() {
    let square = Preset::Square.outline();
    let area = square.polygon().area();
    for preset in SurfacePreset::ALL {
        for anchor in [0.0, 0.123, 0.5] {
            let map = map(&preset.surface(60).unwrap(), &square, [anchor, 0.3]);
            let cuts = checked(&map, &square);
            let found = layout_area(&cuts);
            println!("{}: {found} of {area}, {} new, {} folded", preset.name(), cuts.added().len(), cuts.folded());
            assert!((found - area).abs() < 1e-13 * area, "{}: {found} and not {area}", preset.name());
            assert_eq!(cuts.folded(), 0, "{}", preset.name());
            let inside = |p: &DVec2| p.abs().max_element() <= square.polygon().bounds().max().max_element();
            assert!(cuts.images().iter().all(inside));
        }
    }
}

#[test]
fn reentrant_corners_are_hit_too_and_the_boundary_is_the_outline() {
    let surface = SurfacePreset::Saddle.surface(50).unwrap();
    // the notches of the leaf are narrower than the edges of this surface: next to some no quadrangle has a kernel
    for (preset, most) in [(Preset::LShape, 0), (Preset::MapleLeaf, 3)] {
        let outline = preset.outline();
        let cuts = checked(&map(&surface, &outline, [0.1, 0.0]), &outline);
        println!("{}: {} corners, {} folded", preset.name(), cuts.at_corners().len(), cuts.folded());
        assert!(cuts.at_corners().len() >= 6);
        assert!(cuts.folded() <= most, "{}", preset.name());
    }
    let l_shape = Preset::LShape.outline();
    let area = layout_area(&checked(&map(&surface, &l_shape, [0.1, 0.0]), &l_shape));
    assert!((area - l_shape.polygon().area()).abs() < 1e-12, "{area}");
}

#[test]
fn what_the_boundary_edges_cut_off_fills_the_outline() {
    let surface = SurfacePreset::Saddle.surface(50).unwrap();
    for preset in [Preset::Square, Preset::LShape, Preset::Star] {
        let outline = preset.outline();
        let map = map(&surface, &outline, [0.1, 0.0]);
        let cut_off = map.cut_off(&outline.corner_places()).unwrap();
        assert_eq!(cut_off.len(), outline.corner_places().len());
        let area = |[a, b, c]: [DVec2; 3]| 0.5 * (b - a).perp_dot(c - a);
        let own = mesh(&map).mesh();
        let covered: f64 = own.triangles().iter().map(|t| area(t.map(|v| map.images()[v as usize]))).sum();
        let filled: f64 = cut_off.iter().map(|(triangle, _)| area(*triangle)).sum();
        let whole = outline.polygon().area();
        assert!((covered - whole).abs() > 1e-4, "{}: something is cut off", preset.name());
        // at reentrant corners what lies beyond the outline is taken away
        assert!((covered + filled - whole).abs() < 1e-12 * whole, "{}: {covered} + {filled}", preset.name());
        for (triangle, beside) in &cut_off {
            let images = own.triangles()[*beside as usize].map(|v| map.images()[v as usize]);
            assert!(triangle.iter().any(|corner| images.contains(corner)), "the triangle beside it");
        }
    }
}

#[test]
fn an_outline_without_corners_changes_nothing() {
    let disk = Preset::Disk.outline();
    assert!(disk.corner_places().is_empty());
    let map = map(&SurfacePreset::Saddle.surface(50).unwrap(), &disk, [0.0, 0.0]);
    let cuts = map.cut_corners(&[]).unwrap();
    assert_eq!((cuts.images(), cuts.triangles()), (map.images(), mesh(&map).mesh().triangles()));
    assert!(cuts.added().is_empty() && cuts.at_corners().is_empty());
}

#[test]
fn vertices_at_the_corners_are_used_again() {
    let square = Preset::Square.outline();
    let settings = PrepareSettings::default().with_sampling(Sampling::Uniform { count: 200, keep_corners: true });
    let source = Arc::new(prepare(square.polygon(), &settings, &mut |_| ()).unwrap());
    let domain = source.domain().unwrap();
    let flat = domain.mesh().vertices().iter().map(|p| p.extend(0.0)).collect();
    let target = prepared(&Surface::new(flat, source.triangles().to_vec()));
    // the identity
    let middle = DVec2::new(0.21, -0.13);
    let there = locate(domain.mesh(), middle, None).unwrap();
    let constraints = Constraints::new((middle, 0.3), (there, 0.3));
    let map = ConformalMap::new(Arc::clone(&source), target, &constraints, MapSettings::default()).unwrap();
    let cuts = checked(&map, &square);
    assert_eq!((cuts.reused(), cuts.added().len()), (4, 0), "{:?}", cuts.added());
    assert_eq!(cuts.triangles(), mesh(&map).mesh().triangles());
    for vertex in cuts.at_corners() {
        assert_eq!(cuts.images()[vertex.index()], mesh(&map).mesh().vertices()[vertex.index()].truncate());
    }
}

#[test]
fn corners_lie_where_symmetry_puts_them() {
    let count = 90_u32;
    let rim = (0..count).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(count)).extend(0.0));
    let inner = (0..count).map(|k| (0.5 * DVec2::from_angle(TAU * f64::from(k) / f64::from(count))).extend(0.0));
    let vertices: Vec<DVec3> = rim.chain(inner).chain([DVec3::ZERO]).collect();
    let triangles = (0..count).flat_map(|k| {
        let next = (k + 1) % count;
        [[k, next, count + k], [next, count + next, count + k], [count + k, count + next, 2 * count]]
    });
    let disk = Surface::new(vertices, triangles.collect());
    let square = Preset::Square.outline();
    let settings = PrepareSettings::default().with_sampling(Sampling::Uniform { count: 800, keep_corners: true });
    let source = Arc::new(prepare(square.polygon(), &settings, &mut |_| ()).unwrap());
    let target = prepared(&disk);
    let center = target.default_point();
    let constraints = Constraints::new((DVec2::ZERO, 0.0), (center, 0.0));
    let map = ConformalMap::new(source, target, &constraints, MapSettings::default()).unwrap();
    let cuts = checked(&map, &square);
    let places = places(&map, &cuts);
    // the square's first point, in the middle of a side, to the point at angle 0: the corners to the diagonals
    for vertex in cuts.at_corners() {
        let place = places[vertex.index()];
        let off = place.x.abs() - place.y.abs();
        println!("{place}");
        assert!(off.abs() < 2e-3 && place.length() > 0.99, "{place} is off by {off:e}");
    }
}

#[test]
fn several_corners_on_one_edge_keep_their_order() {
    let fan = |count: u32| {
        let rim = (0..count).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(count)).extend(0.0));
        let triangles = (0..count).map(|k| [k, (k + 1) % count, count]);
        Surface::new(rim.chain([DVec3::new(0.0, 0.0, 0.4)]).collect(), triangles.collect())
    };
    for (sides, anchor) in [(12, 0.0), (12, 0.03), (17, 0.5), (40, 0.9)] {
        let polygon: Vec<[f64; 2]> =
            (0..sides).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(sides)).to_array()).collect();
        let polygon = outline(&polygon);
        for rim in [3, 5] {
            let cuts = checked(&map(&fan(rim), &polygon, [0.2, anchor]), &polygon);
            let area = layout_area(&cuts);
            assert!((area - polygon.polygon().area()).abs() < 1e-12, "{sides} sides, {rim} edges: {area}");
            assert_eq!(cuts.folded(), 0, "{sides} sides, {rim} edges");
        }
    }
}

#[test]
fn triangles_with_all_corners_on_the_boundary_get_a_middle() {
    let vertices = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.1 * x * y));
    let strip = Surface::new(vertices.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
    let square = Preset::Square.outline();
    let map = map(&strip, &square, [0.05, 0.4]);
    let cuts = checked(&map, &square);
    assert!(cuts.added().iter().any(|added| matches!(added.divides, Divided::Triangle(_))));
    let area = layout_area(&cuts);
    assert!((area - square.polygon().area()).abs() < 1e-13, "{area}");
    let flat = cuts.triangles().iter().filter(|t| {
        let [a, b, c] = t.map(|v| cuts.images()[v as usize]);
        (b - a).perp_dot(c - a) <= 0.0
    });
    assert_eq!(flat.count(), 0);
}

#[test]
fn crowded_corners_are_hit_without_degenerate_triangles() {
    let surface = SurfacePreset::Hemisphere.surface(40).unwrap();
    let tail =
        outline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.45], [9.0, 0.45], [9.0, 0.55], [1.0, 0.55], [1.0, 1.0], [0.0, 1.0]]);
    for anchor in [0.0, 0.4, 0.5] {
        // the tail's end has a measure below 1e-16
        checked(&map(&surface, &tail, [anchor, 0.77]), &tail);
    }
}
