//! Parameterized surfaces compared with closed forms and under symmetries; in `falling_together` those with coinciding
//! boundary images, in `shared_data` real and broken meshes.

#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod between;
mod falling_together;
mod holes;
mod shared_data;
#[path = "../support/mod.rs"]
mod support;

use riemap::conformal::{
    ConformalMap, Constraints, Direction, KernelMode, MapSettings, PrepareSettings, PreparedSide, Side,
    SurfaceSettings, poisson_kernel, prepare_surface,
};
use riemap::geometry::{DVec2, DVec3};
use riemap::laplace::SolverKind;
use riemap::mesh::{BarycentricPoint, Sizing, TriangleId, VertexId, locate, mesh_domain};
use riemap::outline::{BoundaryPoint, Preset, Sampling};
use riemap::surface::{Surface, SurfaceMesh, SurfacePreset, TopologyError, at_vertex};
use riemap::worker::Transfer;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;
use support::domains;

fn domain(preset: Preset, count: u32) -> Arc<PreparedSide> {
    let settings = PrepareSettings::new(Sampling::Uniform { count, keep_corners: true }, Sizing::Uniform);
    domains::domain(preset, settings)
}

fn disk() -> Arc<PreparedSide> {
    // the polygon's error relative to the circle is (2π/m)²/8 = 1e-6
    let sampling = Sampling::Uniform { count: 2000, keep_corners: false };
    let settings = PrepareSettings::default().with_sampling(sampling);
    domains::domain(Preset::Disk, settings)
}

fn prepared(surface: &Surface, settings: SurfaceSettings) -> Arc<PreparedSide> {
    let mesh = SurfaceMesh::new(surface).unwrap_or_else(|error| panic!("{error}"));
    Arc::new(prepare_surface(mesh, settings, &mut |_| ()).unwrap())
}

fn surface_of(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Surface {
    Surface::new(vertices, triangles)
}

fn largest_distance(a: &[DVec2], b: &[DVec2]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max)
}

#[test]
fn planar_mesh_as_a_surface_equals_the_planar_map() {
    let source = domain(Preset::Heart, 200);
    for preset in [Preset::LShape, Preset::Gingerbread, Preset::Disk] {
        let target = domain(preset, 240);
        let flat = target.domain().unwrap().mesh().vertices().iter().map(|p| p.extend(0.0)).collect();
        let surface = prepared(&surface_of(flat, target.triangles().to_vec()), SurfaceSettings::default());
        // next to the pole the kernel comes from a ring of vertices, near the boundary from a triangle
        for towards in [0.02, 0.97] {
            let target_point =
                target.domain().unwrap().default_point().lerp(target.domain().unwrap().mesh().vertices()[7], towards);
            let constraints = Constraints::new((source.default_point(), 0.3), (target_point, target.fractions()[70]));
            let planar =
                ConformalMap::new(source.clone(), target.clone(), &constraints, Direction::Backward.into()).unwrap();
            let on_surface = Constraints::new(
                (source.default_point(), 0.3),
                (
                    locate(target.domain().unwrap().mesh(), target_point, None).unwrap(),
                    surface.fraction_at(BoundaryPoint::new(70, 0.0)),
                ),
            );
            let map = ConformalMap::new(source.clone(), surface.clone(), &on_surface, MapSettings::default()).unwrap();
            let error = largest_distance(planar.images(), map.images());
            println!("{}, {towards}: {error:.1e}", preset.name());
            assert!(error <= 1e-10, "{}: {error:e}", preset.name());
            let (a, b) = (planar.quality(), map.quality());
            assert!((a.q_mean - b.q_mean).abs() <= 1e-9 && a.flipped == b.flipped, "{a:?} and {b:?}");
        }
    }
}

fn constraints(surface: &PreparedSide, source: &PreparedSide) -> Constraints {
    Constraints::new((source.default_point(), 0.0), (surface.default_point(), 0.0))
}

#[test]
fn rigid_motions_and_scalings_change_nothing() {
    let source = domain(Preset::Gingerbread, 300);
    let turn = glam_rotation();
    for preset in SurfacePreset::ALL {
        let surface = preset.surface(120).unwrap();
        let moved = |p: &DVec3| 37.5 * turn(*p) + DVec3::new(3.0, -50.0, 0.7);
        let copy = surface_of(surface.vertices().iter().map(moved).collect(), surface.triangles().to_vec());
        let maps = [surface, copy].map(|surface| {
            let surface = prepared(&surface, SurfaceSettings::default());
            let constraints = constraints(&surface, &source)
                .with_point(
                    Side::Target,
                    at_vertex(
                        surface.surface().unwrap().mesh(),
                        VertexId::new(surface.surface().unwrap().mesh().boundary_count() + 40),
                    )
                    .unwrap(),
                )
                .with_anchor(Side::Target, surface.fraction_at(BoundaryPoint::new(11, 0.25)));
            ConformalMap::new(source.clone(), surface, &constraints, MapSettings::default()).unwrap()
        });
        let error = largest_distance(maps[0].images(), maps[1].images());
        println!("{preset}: {error:.1e}");
        // the moved coordinates are rounded at 1e-16 of 50/37.5 edge lengths of 0.05; crowding on the limbs amplifies
        // this
        assert!(error <= 1e-10, "{preset}: {error:e}");
    }
}

#[test]
fn surfaces_of_any_size_within_the_bounds_map_alike() {
    let source = domain(Preset::Heart, 200);
    let shape = SurfacePreset::HeightField.surface(80).unwrap();
    let scaled =
        |scale: f64| surface_of(shape.vertices().iter().map(|&p| scale * p).collect(), shape.triangles().to_vec());
    let images = |scale: f64| {
        let surface = prepared(&scaled(scale), SurfaceSettings::default());
        ConformalMap::new(source.clone(), surface.clone(), &constraints(&surface, &source), MapSettings::default())
            .unwrap()
            .images()
            .to_vec()
    };
    let plain = images(1.0);
    for scale in [1e-69, 1e-30, 1e30, 1e74] {
        let error = largest_distance(&plain, &images(scale));
        println!("{scale:e}: {error:.1e}");
        assert!(error <= 1e-10, "{scale:e}: {error:e}");
    }
    let error = |scale: f64| SurfaceMesh::new(&scaled(scale)).unwrap_err();
    assert!(matches!(error(1e76), TopologyError::NotFinite { .. }));
    assert!(matches!(error(1e-72), TopologyError::TooSmall { extent } if extent > 1e-73 && extent < 1e-70));
}

/// A rotation about an axis that is not a coordinate axis (Rodrigues).
fn glam_rotation() -> impl Fn(DVec3) -> DVec3 {
    let (axis, (sine, cosine)) = (DVec3::new(1.0, 2.0, -2.0) / 3.0, 1.1_f64.sin_cos());
    move |p| cosine * p + sine * axis.cross(p) + (1.0 - cosine) * axis.dot(p) * axis
}

/// A rectangle of squares with alternating diagonals, folded along its columns by the angles of `turn`.
fn folded(columns: u32, rows: u32, turn: impl Fn(u32) -> f64) -> Surface {
    let (mut place, mut direction, mut chain) = (DVec2::ZERO, 0.0, Vec::new());
    for i in 0..=columns {
        chain.push(place);
        direction += turn(i);
        place += DVec2::from_angle(direction) / f64::from(columns);
    }
    let width = columns + 1;
    let point = |v: u32| {
        let p = chain[(v % width) as usize];
        DVec3::new(p.x, f64::from(v / width) / f64::from(columns), p.y)
    };
    let square = |q: u32| {
        let a = q / columns * width + q % columns;
        let [a, b, c, d] = [a, a + 1, a + 1 + width, a + width];
        if q.is_multiple_of(2) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
    };
    surface_of((0..width * (rows + 1)).map(point).collect(), (0..columns * rows).flat_map(square).collect())
}

#[test]
fn bent_patch_maps_as_its_flat_original() {
    let source = domain(Preset::LShape, 300);
    let map = |surface: Surface, weights: [f64; 3]| {
        let surface = prepared(&surface, SurfaceSettings::default());
        let surface_point = BarycentricPoint::new(TriangleId::new(367), weights);
        let constraints = constraints(&surface, &source).with_point(Side::Target, surface_point);
        ConformalMap::new(source.clone(), surface, &constraints, MapSettings::default()).unwrap()
    };
    for weights in [[1.0, 0.0, 0.0], [0.2, 0.5, 0.3]] {
        let flat = map(folded(30, 21, |_| 0.0), weights);
        for bent in [folded(30, 21, |_| 0.15), folded(30, 21, |i| if i % 3 == 0 { 1.4 } else { -0.7 })] {
            let bent = map(bent, weights);
            let error = largest_distance(flat.images(), bent.images());
            println!("{error:.1e}");
            assert!(error <= 1e-11, "{error:e}");
            assert!((flat.quality().q_mean - bent.quality().q_mean).abs() <= 1e-11);
        }
    }
}

/// A spherical cap of the given angle; its triangles are not conformal to those of the planar disk they are made from.
fn cap(angle: f64, boundary: u32) -> Surface {
    let rim: Vec<DVec2> = (0..boundary).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(boundary))).collect();
    let mesh = mesh_domain(&rim, Sizing::Uniform).unwrap().0;
    let lifted = |p: &DVec2| {
        let (sine, cosine) = (p.length() * angle).sin_cos();
        (p.normalize_or_zero() * sine).extend(cosine)
    };
    surface_of(mesh.vertices().iter().map(lifted).collect(), mesh.triangles().to_vec())
}

/// The stereographic projection of the cap onto the unit disk.
fn stereographic(angle: f64, p: DVec3) -> DVec2 {
    p.truncate() / (1.0 + p.z) / (0.5 * angle).tan()
}

/// The largest and mean distance of the map of a cap from the stereographic projection with its constraints.
fn cap_error(angle: f64, boundary: u32, source: &Arc<PreparedSide>) -> [f64; 2] {
    let surface = prepared(&cap(angle, boundary), SurfaceSettings::default());
    let mesh = surface.surface().unwrap().mesh();
    let wanted = DVec3::new((0.35 * angle).sin(), 0.0, (0.35 * angle).cos());
    let interior = (mesh.boundary_count()..mesh.vertices().len() as u32)
        .min_by(|&a, &b| {
            let distance = |v: u32| mesh.vertices()[v as usize].distance(wanted);
            distance(a).total_cmp(&distance(b))
        })
        .unwrap();
    let constraints = Constraints::new(
        (stereographic(angle, mesh.vertices()[interior as usize]), 0.0),
        (at_vertex(mesh, VertexId::new(interior)).unwrap(), 0.0),
    );
    let map = ConformalMap::new(source.clone(), surface.clone(), &constraints, MapSettings::default()).unwrap();
    let errors = mesh.vertices().iter().zip(map.images()).map(|(&p, &w)| w.distance(stereographic(angle, p)));
    let quality = map.quality();
    let [max, sum] = errors.fold([0.0, 0.0], |[max, sum]: [f64; 2], e| [max.max(e), sum + e]);
    println!(
        "cap {:.0}°, m = {boundary}: max {max:.2e}, {:?}, {quality:?}",
        angle.to_degrees(),
        surface.surface().unwrap().flips()
    );
    assert_eq!(quality.flipped, 0);
    [max, sum / mesh.vertices().len() as f64]
}

#[test]
fn spherical_caps_map_by_the_stereographic_projection() {
    // as uniform as the caps and finer, so that the caps' errors dominate
    let source = domain(Preset::Disk, 1200);
    // the largest and the mean error at 400 boundary vertices; twice as many vertices give a quarter of it
    for (angle, max, mean) in [(0.3 * PI, 5e-5, 1e-5), (FRAC_PI_2, 6e-5, 1.5e-5), (0.75 * PI, 4e-4, 1e-4)] {
        let errors = [50, 100, 200, 400].map(|boundary| cap_error(angle, boundary, &source));
        println!("{:.0}°: {errors:?}", angle.to_degrees());
        let [_, _, _, finest] = errors;
        assert!(finest[0] <= max && finest[1] <= mean, "{finest:?}");
        let order = (errors[0][1] / finest[1]).log2() / 3.0;
        println!("order {order:.2}");
        assert!(order > 1.8, "{order}");
    }
}

#[test]
fn flipped_surfaces_have_positive_kernels_and_ordered_boundaries() {
    let source = disk();
    let needles = folded(12, 40, |i| f64::from(i % 2) - 0.5);
    let sheared = |p: &DVec3| DVec3::new(p.x + 1.7 * p.y, p.y, p.z);
    let needles = surface_of(needles.vertices().iter().map(sheared).collect(), needles.triangles().to_vec());
    let flipped = prepared(&needles, SurfaceSettings::default());
    let given = prepared(&needles, SurfaceSettings::default().with_intrinsic_delaunay(false));
    println!("{:?}", flipped.surface().unwrap().flips());
    assert!(
        flipped.surface().unwrap().flips().negative_before > 0
            && flipped.surface().unwrap().flips().negative_after == 0
    );
    assert_eq!(given.surface().unwrap().flips().negative_after, flipped.surface().unwrap().flips().negative_before);
    let mut negative = [0, 0];
    let mesh = flipped.surface().unwrap().mesh();
    for v in (mesh.boundary_count()..mesh.vertices().len() as u32).step_by(7) {
        for (surface, count) in [&flipped, &given].into_iter().zip(&mut negative) {
            let psi = poisson_kernel(surface, at_vertex(mesh, VertexId::new(v)).unwrap()).unwrap();
            *count += psi.iter().filter(|&&value| value < 0.0).count();
        }
    }
    println!("negative values of ψ: {negative:?}");
    assert_eq!(negative[0], 0);
    let map =
        ConformalMap::new(source.clone(), flipped.clone(), &constraints(&flipped, &source), MapSettings::default())
            .unwrap();
    let along: Vec<f64> = map.correspondence().points().iter().map(|p| f64::from(p.edge()) + p.fraction()).collect();
    let descents = (0..along.len()).filter(|&k| along[k] > along[(k + 1) % along.len()]).count();
    assert_eq!(descents, 1, "the boundary goes round once");
    // without flips the map may be inaccurate, but it exists and has finite points
    let map = ConformalMap::new(source.clone(), given.clone(), &constraints(&given, &source), MapSettings::default())
        .unwrap();
    assert!(map.images().iter().all(|p| p.is_finite()));
}

#[test]
fn modes_and_repeated_updates_agree() {
    let source = domain(Preset::Star, 300);
    let surface = SurfacePreset::HeightField.surface(100).unwrap();
    let direct = prepared(&surface, SurfaceSettings::default());
    let table = prepared(&surface, SurfaceSettings::default().with_kernel(KernelMode::Table));
    let pcg = prepared(&surface, SurfaceSettings::default().with_solver(SolverKind::Pcg));
    let first = constraints(&direct, &source);
    let second = first
        .with_point(Side::Target, BarycentricPoint::new(TriangleId::new(1000), [0.5, 0.0, 0.5]))
        .with_anchor(Side::Target, 0.4);
    let fresh = ConformalMap::new(source.clone(), direct.clone(), &second, MapSettings::default()).unwrap();
    let mut moved = ConformalMap::new(source.clone(), direct, &first, MapSettings::default()).unwrap();
    moved.update(&second, MapSettings::default()).unwrap();
    assert_eq!(moved.images(), fresh.images());
    for (other, tolerance) in [(table, 1e-12), (pcg, 1e-8)] {
        let other = ConformalMap::new(source.clone(), other, &second, MapSettings::default()).unwrap();
        let error = largest_distance(other.images(), fresh.images());
        assert!(error <= tolerance, "{error:e}");
    }
}

#[test]
fn prepared_surfaces_survive_the_trip_through_flat_arrays() {
    let hemisphere = SurfacePreset::Hemisphere.surface(40).unwrap();
    let vertices = hemisphere.vertices().iter().copied().chain([DVec3::ZERO]).collect();
    let surface = surface_of(vertices, hemisphere.triangles().to_vec());
    let repaired = SurfaceMesh::repaired(&surface).unwrap();
    for (kernel, solver) in [
        (KernelMode::Adjoint, SolverKind::Direct),
        (KernelMode::Table, SolverKind::Direct),
        (KernelMode::Adjoint, SolverKind::Pcg),
    ] {
        let settings = SurfaceSettings::default().with_kernel(kernel).with_solver(solver);
        let whole = prepare_surface(repaired.clone(), settings, &mut |_| ()).unwrap();
        let back = Transfer::try_from(&whole).unwrap().into_side().unwrap();
        let [there, here] = [&back, &whole].map(|side| side.surface().unwrap());
        assert_eq!(there.surface(), here.surface(), "with its repairs");
        assert_eq!(
            (back.solver_kind(), back.table(), there.flips()),
            (whole.solver_kind(), whole.table(), here.flips())
        );
        assert_eq!(
            Transfer::try_from(&back).unwrap(),
            Transfer::try_from(&whole).unwrap(),
            "to the bit, with its factor"
        );
        assert_eq!((back.default_point(), back.fractions()), (whole.default_point(), whole.fractions()));
        let broken = |damage: fn(&mut Transfer)| {
            let mut buffers = Transfer::try_from(&whole).unwrap();
            damage(&mut buffers);
            buffers.into_side().is_none()
        };
        assert!(broken(|b| b.record.clear()), "no repairs");
        assert!(broken(|b| b.indices.truncate(3)), "arrays missing");
        assert!(broken(|b| b.indices[0][0] = 2), "no geometry");
        assert!(broken(|b| b.indices[1][3] = u32::MAX), "a point in no triangle");
        assert!(broken(|b| b.indices[3][0] = u32::MAX), "a triangle without a corner");
        assert!(broken(|b| b.indices[5][0] = 1 << 30), "a vertex from nowhere");
    }
}

#[test]
fn points_that_are_not_inside_the_surface_are_refused() {
    let source = domain(Preset::Disk, 100);
    let surface = prepared(&SurfacePreset::Saddle.surface(40).unwrap(), SurfaceSettings::default());
    let good = constraints(&surface, &source);
    let mut map = ConformalMap::new(source, surface.clone(), &good, MapSettings::default()).unwrap();
    let before = map.images().to_vec();
    let at =
        |triangle, weights| good.with_point(Side::Target, BarycentricPoint::new(TriangleId::new(triangle), weights));
    for (bad, word) in [
        (at(1_000_000, [1.0, 0.0, 0.0]), "triangle 1000000"),
        (at(3, [0.7, 0.7, -0.4]), "no point"),
        (at(3, [0.3, 0.3, 0.3]), "no point"),
        (at(3, [f64::NAN, 0.5, 0.5]), "no point"),
        (
            good.with_point(Side::Target, at_vertex(surface.surface().unwrap().mesh(), VertexId::new(0)).unwrap()),
            "boundary",
        ),
        (good.with_anchor(Side::Target, f64::INFINITY), "anchor"),
        (good.with_point(Side::Source, DVec2::new(7.0, 0.0)), "not inside the source"),
    ] {
        let message = map.update(&bad, MapSettings::default()).unwrap_err().to_string();
        assert!(message.contains(word), "{message}");
        assert_eq!(map.images(), before);
    }
    assert!(matches!(map.update(&good, MapSettings::default()), Ok(())));
}

#[test]
fn a_single_triangle_is_a_disk_too() {
    let source = domain(Preset::Disk, 60);
    let surface = surface_of(vec![DVec3::ZERO, DVec3::X, DVec3::new(0.3, 0.8, 0.1)], vec![[0, 1, 2]]);
    let surface = prepared(&surface, SurfaceSettings::default());
    let map =
        ConformalMap::new(source.clone(), surface.clone(), &constraints(&surface, &source), MapSettings::default())
            .unwrap();
    assert!(map.images().iter().all(|p| (p.length() - 1.0).abs() < 1e-2), "{:?}", map.images());
}

/// The map to the disk with the default point at the center.
fn default_map(surface: Arc<PreparedSide>) -> ConformalMap {
    let source = disk();
    let constraints = constraints(&surface, &source);
    ConformalMap::new(source, surface, &constraints, MapSettings::default()).unwrap()
}
