//! Maps between two surfaces, and between a surface and the plane in both directions: identities, closed forms,
//! inverses.

use super::{disk, domain, largest_distance, prepared, stereographic, surface_of};
use riemap::conformal::{
    ConformalMap, Constraints, Direction, Extension, InteriorPoint, MapSettings, PreparedSide, Side, SurfaceSettings,
};
use riemap::exact::{Complex, complex, point};
use riemap::geometry::{DVec2, DVec3};
use riemap::laplace::Deadline;
use riemap::mesh::{BarycentricPoint, TriangleId, VertexId, locate};
use riemap::outline::Preset;
use riemap::surface::{SurfacePreset, at_vertex, farthest_from_boundary};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

fn preset(preset: SurfacePreset, boundary: u32) -> Arc<PreparedSide> {
    prepared(&preset.surface(boundary).unwrap(), SurfaceSettings::default())
}

fn places(side: &PreparedSide) -> &[DVec3] {
    side.surface().unwrap().mesh().vertices()
}

fn size(side: &PreparedSide) -> f64 {
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (low, high) = places(side).iter().fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
    (high - low).max_element()
}

pub fn map(source: &Arc<PreparedSide>, target: &Arc<PreparedSide>, at: &Constraints, way: Direction) -> ConformalMap {
    ConformalMap::new(Arc::clone(source), Arc::clone(target), at, way.into()).unwrap()
}

fn images(map: &ConformalMap) -> &[DVec3] {
    map.surface_images().unwrap().places()
}

/// The interior vertex nearest to a position.
fn vertex_near(side: &PreparedSide, place: DVec3) -> u32 {
    let distance = |v: u32| places(side)[v as usize].distance(place);
    let inner = side.boundary_count() as u32..side.vertex_count() as u32;
    inner.min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap()
}

pub fn assert_identity(name: &str, side: &Arc<PreparedSide>) {
    let mesh = side.surface().unwrap().mesh();
    let points = [farthest_from_boundary(mesh), BarycentricPoint::new(TriangleId::new(0), [0.2, 0.3, 0.5])];
    for (point, anchor) in points.into_iter().zip([0.0, 0.3217]) {
        let at = Constraints::new((point, anchor), (point, anchor));
        for way in [Direction::Forward, Direction::Backward] {
            let map = map(side, side, &at, way);
            let off = |(p, q): (&DVec3, &DVec3)| p.distance(*q);
            let error = images(&map).iter().zip(places(side)).map(off).fold(0.0, f64::max) / size(side);
            let quality = map.quality();
            println!("{name}, {anchor}: {error:.1e}, {quality:?}");
            assert!(error <= 1e-9, "{name}, {anchor}: {error:e}");
            // a triangle of the input that is not Delaunay may be flipped in the disk
            assert!(quality.q_mean - 1.0 < 1e-6 && quality.collapsed == 0 && quality.flipped < 10, "{quality:?}");
        }
    }
}

#[test]
fn a_surface_goes_onto_itself_by_the_identity() {
    for shape in [
        SurfacePreset::Hemisphere,
        SurfacePreset::Paraboloid,
        SurfacePreset::Saddle,
        SurfacePreset::HeightField,
        SurfacePreset::AnimalHead,
    ] {
        assert_identity(shape.name(), &preset(shape, 120));
    }
}

/// g(z) = c (z − x)/(1 − x̄ z), which takes x to 0 and y to 1.
struct Moebius {
    x: Complex,
    turn: Complex,
}

impl Moebius {
    fn new(x: DVec2, y: DVec2) -> Self {
        let (x, y) = (complex(x), complex(y));
        Self { x, turn: (Complex::from(1.0) - x.conj() * y) / (y - x) }
    }

    fn at(&self, z: Complex) -> Complex {
        self.turn * (z - self.x) / (Complex::from(1.0) - self.x.conj() * z)
    }

    fn inverse(&self, w: Complex) -> Complex {
        let u = w / self.turn;
        (u + self.x) / (Complex::from(1.0) + self.x.conj() * u)
    }
}

/// The largest distance of the map between two hemispheres from the Möbius map of their stereographic disks, in radii,
/// and the number of vertices of the mapped one.
fn hemisphere_error(boundary: [u32; 2]) -> (f64, usize) {
    let [source, target] = boundary.map(|boundary| preset(SurfacePreset::Hemisphere, boundary));
    let x1 = vertex_near(&source, DVec3::new(0.4, 0.1, 0.9));
    let x2 = vertex_near(&target, DVec3::new(-0.2, 0.5, 0.8));
    let located = |side: &PreparedSide, v: u32| at_vertex(side.surface().unwrap().mesh(), VertexId::new(v)).unwrap();
    let at = Constraints::new((located(&source, x1), 0.0), (located(&target, x2), 0.25));
    let map = map(&source, &target, &at, Direction::Forward);
    let flat = |side: &PreparedSide, v: u32| stereographic(FRAC_PI_2, places(side)[v as usize]);
    let anchor = |side: Side| {
        let (surface, point) = (map.side(side).surface().unwrap(), map.measure(side).anchor());
        stereographic(FRAC_PI_2, surface.boundary_position(point).normalize())
    };
    let [first, second] =
        [Moebius::new(flat(&source, x1), anchor(Side::Source)), Moebius::new(flat(&target, x2), anchor(Side::Target))];
    let exact = |p: &DVec3| {
        let w = point(second.inverse(first.at(complex(stereographic(FRAC_PI_2, *p)))));
        (2.0 * w).extend(1.0 - w.length_squared()) / (1.0 + w.length_squared())
    };
    let errors = places(&source).iter().zip(images(&map)).map(|(p, q)| exact(p).distance(*q));
    let quality = map.quality();
    assert_eq!((quality.flipped, quality.collapsed), (0, 0));
    (errors.fold(0.0, f64::max), source.vertex_count())
}

#[test]
fn hemispheres_map_by_the_moebius_map_of_their_stereographic_disks() {
    let (coarse, vertices) = hemisphere_error([150, 160]);
    let (fine, _) = hemisphere_error([300, 320]);
    println!("{vertices} vertices: {coarse:.2e}; with twice the boundary {fine:.2e}");
    assert!((1500..2500).contains(&vertices), "{vertices}");
    assert!(coarse <= 1e-2 && fine < 0.6 * coarse, "{coarse:e}, {fine:e}");
}

/// The image of a point of the source, whose mesh is mapped: interpolated in its triangle.
fn image_of(map: &ConformalMap, point: BarycentricPoint) -> DVec3 {
    let corners = map.mapped().triangles()[point.triangle().index()];
    (0..3).map(|i| point.weights()[i] * images(map)[corners[i] as usize]).sum()
}

fn mean_edge(side: &PreparedSide) -> f64 {
    let edges = side.triangles().iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let lengths: Vec<f64> = edges.map(|(a, b)| places(side)[a as usize].distance(places(side)[b as usize])).collect();
    lengths.iter().sum::<f64>() / lengths.len() as f64
}

#[test]
fn there_and_back_again_is_within_an_edge() {
    let pairs = [
        (SurfacePreset::Hemisphere, SurfacePreset::HeightField),
        (SurfacePreset::Paraboloid, SurfacePreset::Hemisphere),
        (SurfacePreset::AnimalHead, SurfacePreset::HeightField),
    ];
    for (first, second) in pairs {
        let (source, target) = (preset(first, 120), preset(second, 150));
        let at = Constraints::new((source.default_point(), 0.1), (target.default_point(), 0.7));
        let back = Constraints::new((at.points.target, at.anchors.target), (at.points.source, at.anchors.source));
        let (there, back) =
            (map(&source, &target, &at, Direction::Forward), map(&target, &source, &back, Direction::Forward));
        let points = there.surface_images().unwrap().points();
        let off = |(point, place): (&BarycentricPoint, &DVec3)| image_of(&back, *point).distance(*place);
        let mean = points.iter().zip(places(&source)).map(off).sum::<f64>() / points.len() as f64;
        println!("{first} → {second} → {first}: {mean:.2e}, an edge is {:.2e}", mean_edge(&source));
        assert!(mean < mean_edge(&source), "{first}, {second}: {mean:e}");
    }
}

/// Forward from the flat mesh and backward onto it, the maps are the planar ones; the requested direction has no
/// effect.
#[test]
fn a_flat_mesh_is_its_domain_on_either_side() {
    let other = domain(Preset::Heart, 200);
    for shape in [Preset::LShape, Preset::Gingerbread] {
        let flat = domain(shape, 240);
        let mesh = flat.domain().unwrap().mesh();
        let vertices = mesh.vertices().iter().map(|p| p.extend(0.0)).collect();
        let surface = prepared(&surface_of(vertices, mesh.triangles().to_vec()), SurfaceSettings::default());
        let point = flat.domain().unwrap().default_point();
        let on_surface = locate(mesh, point, None).unwrap();
        let anchors = (flat.fractions()[70], surface.fractions()[70]);
        let heart: (InteriorPoint, f64) = (other.default_point(), 0.3);
        let same = |planar: &ConformalMap, map: &ConformalMap| {
            let error = largest_distance(planar.images(), map.images());
            println!("{shape}: {error:.1e}");
            assert!(error <= 1e-10, "{shape}: {error:e}");
            assert_eq!(planar.mapped_side(), map.mapped_side());
        };
        for asked in [Direction::Forward, Direction::Backward] {
            let at = Constraints::new((point, anchors.0), heart);
            let planar = map(&flat, &other, &at, Direction::Forward);
            let at = Constraints::new((on_surface, anchors.1), heart);
            same(&planar, &map(&surface, &other, &at, asked));
            let at = Constraints::new(heart, (point, anchors.0));
            let planar = map(&other, &flat, &at, Direction::Backward);
            let at = Constraints::new(heart, (on_surface, anchors.1));
            let settings = MapSettings::new(asked, Extension::CauchyGreen);
            let mapped = ConformalMap::new(other.clone(), surface.clone(), &at, settings).unwrap();
            assert_eq!(mapped.extension(), Extension::Harmonic);
            same(&planar, &mapped);
        }
    }
}

#[test]
fn points_of_the_other_kind_are_refused_by_side() {
    let (plane, surface) = (disk(), preset(SurfacePreset::Saddle, 60));
    let (inside, on_surface) = (plane.default_point(), surface.default_point());
    let mut map = map(&surface, &plane, &Constraints::new((on_surface, 0.0), (inside, 0.0)), Direction::Forward);
    let before = map.images().to_vec();
    for (points, side) in [((inside, inside), Side::Source), ((on_surface, on_surface), Side::Target)] {
        let at = Constraints::new((points.0, 0.0), (points.1, 0.0));
        let error = map.update(&at, MapSettings::default()).unwrap_err();
        assert_eq!(error, riemap::conformal::MapError::OtherKind { side });
        assert_eq!(map.images(), before);
    }
}

#[test]
fn in_pieces_and_after_other_points_the_map_is_the_same() {
    let (source, target) = (preset(SurfacePreset::HeightField, 100), preset(SurfacePreset::Hemisphere, 80));
    let at = |x: f64| {
        let point = BarycentricPoint::new(TriangleId::new(900), [0.5 * x, 0.5 - 0.5 * x, 0.5]);
        Constraints::new((point, 0.2 + x), (target.default_point(), 0.9))
    };
    for way in [Direction::Forward, Direction::Backward] {
        let mut moved = map(&source, &target, &at(0.1), way);
        let before = (moved.surface_images().cloned(), moved.images().to_vec());
        let mut steps = 1;
        while !moved.advance(&at(0.6), way.into(), Deadline::in_ms(0.0)).unwrap() {
            assert_eq!((moved.surface_images().cloned(), moved.images().to_vec()), before, "step {steps}");
            steps += 1;
        }
        let fresh = map(&source, &target, &at(0.6), way);
        assert!(steps > 4, "{steps}");
        assert_eq!(moved.surface_images(), fresh.surface_images());
        assert_eq!(moved.images(), fresh.images());
        assert_eq!(moved.quality(), fresh.quality());
        // in the opposite direction only point location changes
        moved.update(&at(0.6), Direction::mapping(moved.mapped_side().other()).into()).unwrap();
        let turned = map(&source, &target, &at(0.6), moved.direction());
        assert_eq!(moved.surface_images(), turned.surface_images());
    }
}
