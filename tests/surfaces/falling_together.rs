//! Boundary vertices with the same image: they are reported, and counted consistently with the images.

use super::{constraints, default_map, disk, folded, prepared, surface_of};
use riemap::conformal::{
    ConformalMap, Constraints, Direction, MapNote, MapSettings, PrepareSettings, PreparedSide, Side, SurfaceSettings,
    prepare, prepare_surface,
};
use riemap::geometry::{Bounds, DVec2, DVec3, SimplePolygon};
use riemap::laplace::SolverKind;
use riemap::mesh::{Sizing, VertexId};
use riemap::outline::Sampling;
use riemap::surface::{Surface, SurfaceMesh, SurfacePreset, at_vertex};
use std::sync::Arc;

/// The number of boundary edges in the note, and of collapsed triangles in the quality; both are checked
/// against the images, with a bound of 1e-13 of their extent.
fn told(map: &ConformalMap) -> [usize; 2] {
    let (images, mesh) = (map.images(), map.mapped().surface().unwrap().mesh());
    let [low, high] = Bounds::of(images.iter().copied()).corners();
    let extent = (high - low).max_element();
    let boundary = &images[..mesh.boundary_count() as usize];
    let gaps: Vec<f64> = boundary.iter().zip(boundary.iter().cycle().skip(1)).map(|(p, q)| p.distance(*q)).collect();
    let height = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| images[v as usize]);
        let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let height = if longest > 0.0 { (b - a).perp_dot(c - a).abs() / longest } else { 0.0 };
        // an image that is not a thousand times as long as its error is a point
        height.min(1e-3 * longest)
    };
    let heights: Vec<f64> = mesh.triangles().iter().map(height).collect();
    let edges = match map.note(map.mapped_side()) {
        Some(MapNote::NoMeasure { edges } | MapNote::NegativeKernel { edges }) => edges,
        Some(note) => panic!("{note}"),
        None => 0,
    };
    let told = [edges, map.quality().collapsed as usize];
    for (told, found) in told.iter().zip([gaps, heights]) {
        let within = |bound: f64| found.iter().filter(|&&distance| distance <= bound * extent).count();
        let (least, most) = (within(0.9e-13), within(1.1e-13));
        assert!((least..=most).contains(told), "{told} of {least} to {most}");
    }
    told
}

fn with_solver(mesh: &SurfaceMesh, solver: SolverKind) -> Arc<PreparedSide> {
    let settings = SurfaceSettings::default().with_solver(solver);
    Arc::new(prepare_surface(mesh.clone(), settings, &mut |_| ()).unwrap())
}

/// Two patches of 4 × 4 squares, joined by a bridge of two squares.
fn two_patches() -> SurfaceMesh {
    let whole = folded(10, 4, |_| 0.0);
    let is_kept = |q: usize| !matches!((q % 10, q / 10), (4 | 5, 0 | 2 | 3));
    let kept = whole.triangles().iter().enumerate().filter(|(t, _)| is_kept(t / 2)).map(|(_, corners)| *corners);
    SurfaceMesh::repaired(&surface_of(whole.vertices().to_vec(), kept.collect())).unwrap()
}

/// Whichever of two surfaces is mapped, the note is about the one with the bridge; its triangles beyond the bridge are
/// collapsed, as they are in the disk.
#[test]
fn between_two_surfaces_the_note_is_about_the_side_with_coinciding_images() {
    let (patches, hemisphere) = (with_solver(&two_patches(), SolverKind::Direct), hemisphere());
    let at = Constraints::new((patches.default_point(), 0.1), (hemisphere.default_point(), 0.4));
    for way in [Direction::Forward, Direction::Backward] {
        let map = ConformalMap::new(patches.clone(), hemisphere.clone(), &at, way.into()).unwrap();
        let Some(MapNote::NoMeasure { edges }) = map.note(Side::Source) else { panic!("{way:?}: no note") };
        assert!((10..20).contains(&edges), "{way:?}: {edges}");
        assert_eq!(map.note(Side::Target), None, "{way:?}");
        let collapsed = map.quality().collapsed;
        let expected = if way == Direction::Forward { 32..=36 } else { 0..=0 };
        assert!(expected.contains(&collapsed), "{way:?}: {collapsed}");
    }
}

fn hemisphere() -> Arc<PreparedSide> {
    prepared(&SurfacePreset::Hemisphere.surface(60).unwrap(), SurfaceSettings::default())
}

#[test]
fn parts_without_inner_vertices_to_the_point_coincide_and_are_reported() {
    let source = disk();
    let whole = folded(10, 4, |_| 0.0);
    assert_eq!(told(&default_map(prepared(&whole, SurfaceSettings::default()))), [0, 0]);
    let patches = two_patches();
    for solver in [SolverKind::Direct, SolverKind::Pcg] {
        let surface = with_solver(&patches, solver);
        for surface_anchor in [0.0, 0.1, 0.3, 0.5, 0.7, 0.9] {
            let constraints = constraints(&surface, &source).with_anchor(Side::Target, surface_anchor);
            let map = ConformalMap::new(source.clone(), surface.clone(), &constraints, MapSettings::default()).unwrap();
            // of the other patch all edges but the one at the bridge's end, and two edges of the bridge; its 32
            // triangles and two of the bridge are mapped to one point, and two corners of one more triangle of the
            // bridge
            assert_eq!(told(&map), [15 + 2, 32 + 2 + 1], "{solver:?}, {surface_anchor}");
            assert!(matches!(map.note(map.mapped_side()), Some(MapNote::NoMeasure { .. })));
            assert!(map.quality().q_max < 1e3, "{:?}", map.quality());
        }
    }
}

/// A rectangle of the folded strip's size.
fn rectangle(width: f64, height: f64, count: u32) -> Arc<PreparedSide> {
    let corners = [[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]].map(DVec2::from_array);
    let sampling = Sampling::Uniform { count, keep_corners: true };
    let settings = PrepareSettings::new(sampling, Sizing::Uniform);
    Arc::new(prepare(&SimplePolygon::try_from(corners.to_vec()).unwrap(), &settings, &mut |_| ()).unwrap())
}

#[test]
fn parts_beyond_a_long_strip_coincide_and_are_reported() {
    // 100 × 4 squares, the point 5 columns from the left: the measure decays as e^(−π x/0.04), to 1e-13 at column 43
    let strip = SurfaceMesh::new(&folded(100, 4, |_| 0.0)).unwrap();
    let (disk, same) = (disk(), rectangle(1.0, 0.04, 208));
    let place = DVec3::new(0.05, 0.02, 0.0);
    for solver in [SolverKind::Direct, SolverKind::Pcg] {
        let surface = with_solver(&strip, solver);
        let surface_point = surface.surface().unwrap().tree().nearest(place).unwrap().0;
        for surface_anchor in [0.0, 0.25, 0.48, 0.5, 0.75] {
            let in_disk = constraints(&surface, &disk)
                .with_point(Side::Target, surface_point)
                .with_anchor(Side::Target, surface_anchor);
            let [edges, _] =
                told(&ConformalMap::new(disk.clone(), surface.clone(), &in_disk, MapSettings::default()).unwrap());
            assert!(edges.abs_diff(2 * (100 - 43) + 4) < 10, "{solver:?}, {surface_anchor}: {edges}");
            // over the same rectangle, equally small measures on both sides are distinguished when counted from the
            // anchor
            let anchor = surface.surface().unwrap().boundary_position(surface.at_fraction(surface_anchor)).truncate();
            let source_anchor = same.fraction_at(same.domain().unwrap().samples().nearest(anchor));
            let in_same = in_disk.with_point(Side::Source, place.truncate()).with_anchor(Side::Source, source_anchor);
            let [apart, _] =
                told(&ConformalMap::new(same.clone(), surface.clone(), &in_same, MapSettings::default()).unwrap());
            println!("{solver:?}, {surface_anchor}: {edges} over the disk, {apart} over the same");
            assert!(apart < if (0.48..=0.5).contains(&surface_anchor) { 60 } else { edges }, "{apart} of {edges}");
        }
    }
}

#[test]
fn where_the_kernel_is_negative_the_note_says_so() {
    let needles = folded(12, 40, |i| f64::from(i % 2) - 0.5);
    let sheared = |p: &DVec3| DVec3::new(p.x + 1.7 * p.y, p.y, p.z);
    let needles = surface_of(needles.vertices().iter().map(sheared).collect(), needles.triangles().to_vec());
    let given = prepared(&needles, SurfaceSettings::default().with_intrinsic_delaunay(false));
    let mesh = given.surface().unwrap().mesh();
    let source = disk();
    let mut map = default_map(given.clone());
    for v in (mesh.boundary_count()..mesh.vertices().len() as u32).step_by(7) {
        let at = constraints(&given, &source).with_point(Side::Target, at_vertex(mesh, VertexId::new(v)).unwrap());
        map.update(&at, MapSettings::default()).unwrap();
        let [edges, _] = told(&map);
        assert_eq!(map.note(map.mapped_side()), Some(MapNote::NegativeKernel { edges }), "{v}");
    }
}

#[test]
fn a_surface_without_inner_vertices_is_mapped_and_coinciding_edges_are_reported() {
    let map = |surface: &Surface| default_map(prepared(surface, SurfaceSettings::default()));
    // a triangle with three ears and its point in the middle: six corners at six positions
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.9], [0.5, -0.4], [1.1, 0.7], [-0.1, 0.7]];
    let vertices = corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
    let ears = surface_of(vertices, vec![[0, 1, 2], [1, 0, 3], [2, 1, 4], [0, 2, 5]]);
    assert_eq!(told(&map(&ears)), [0, 0]);
    // of the 2·columns + 2 edges of a strip, those that begin or end at a corner of the point's triangle are kept apart
    for (columns, edges) in [(1, 0), (2, 1), (3, 3), (40, 77)] {
        let strip = map(&folded(columns, 1, |_| 0.1));
        assert_eq!(told(&strip)[0], edges, "{columns}");
        assert!(strip.images().iter().all(|p| p.is_finite()) && strip.quality().q_mean.is_finite());
    }
}
