//! `map` and `--points`: between the unit disk and domains whose map is known; `grid` and `project`.

use super::closed::Closed;
use super::judge::{Case, Number};
use riemap::conformal::{ConformalMap, Constraints, Direction, InteriorImage, Marks, Quadrilateral, Side};
use riemap::conformal::{GridCells, KernelMode, PrepareSettings, PreparedSide, prepare_curve};
use riemap::exact::{Complex, complex, point};
use riemap::geometry::{Curve, CurvePoint, DVec2, Piece, SimplePolygon};
use riemap::outline::{Preset, Reading, parse_geo_rings};
use riemap::projection::{Projection, Region};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

fn disk() -> Arc<PreparedSide> {
    let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
    let (outline, curve) = (Preset::Disk.outline(), Preset::Disk.curve().unwrap());
    Arc::new(prepare_curve((outline.polygon(), &curve), &[], &settings, &mut |_| ()).unwrap())
}

/// An image with its truth, the exact image of `z`, which is known as well as rounding of z lets it.
fn image(found: DVec2, stated: f64, truth: impl Fn(DVec2) -> Complex, z: DVec2) -> Number {
    let exact = truth(z);
    let step = 2e-16 * (1.0 + z.length());
    let rounded = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y].map(|way| (truth(z + step * way) - exact).norm());
    let slack = rounded.into_iter().filter(|slack| slack.is_finite()).fold(1e-15, f64::max);
    Number::new(stated, (complex(found) - exact).norm(), 2.0 * slack)
}

/// The boundary images and those of interior points, there and back, with the domain's first point at w = 1 or −1.
fn both_ways(closed: Closed, n: usize, unit: &Arc<PreparedSide>) -> Vec<Case> {
    let center = closed.place(Complex::new(0.0, 0.0));
    let side = closed.prepared(n, center);
    // the curve's start is g(1), a digon's g(−1)
    let turn = if matches!(closed, Closed::Digon { .. }) { -1.0 } else { 1.0 };
    let constraints = Constraints::new((point(center), 0.0), (DVec2::ZERO, 0.0));
    let map = |direction: Direction| {
        assert_eq!(side.unsharpened(), None, "{closed:?}");
        ConformalMap::new(side.clone(), unit.clone(), &constraints, direction.into()).unwrap()
    };
    let mut cases = Vec::new();
    for direction in [Direction::Forward, Direction::Backward] {
        let map = map(direction);
        let points = map.error_estimate().unwrap().points;
        let own = map.mapped().domain().unwrap().samples().points();
        let truth = |z: DVec2| match direction {
            Direction::Forward => turn * closed.inverse(z),
            Direction::Backward => closed.place(turn * complex(z) / z.length()),
        };
        let at = |k: usize| image(map.images()[k], points[k], truth, own[k]);
        let name = format!("{closed:?} of {n}, {direction:?}");
        // where the boundary is a list's spline, its samples lie beside the closed form's boundary
        let numbers = (0..points.len()).filter(|&k| (closed.inverse(own[k]).norm() - 1.0).abs() < 1e-9).map(at);
        cases.push(Case::new("boundary images", name.clone(), Ok(numbers.collect())));
        let from = if direction == Direction::Forward { Side::Source } else { Side::Target };
        let interior = map.interior_map(from).unwrap();
        let radii = [0.0, 0.3, 0.6, 0.9, 0.99];
        let inside = (0..25).map(|k| Complex::from_polar(radii[k % 5], 2.4 * k as f64));
        let number = |w: Complex| {
            let z = point(if direction == Direction::Forward { closed.place(turn * w) } else { w });
            let exact = |z: DVec2| match direction {
                Direction::Forward => turn * closed.inverse(z),
                Direction::Backward => closed.place(turn * complex(z)),
            };
            match interior.image(z) {
                InteriorImage::Inside(found) => image(found.value, found.error, exact, z),
                other => unreachable!("{closed:?}, {z}: {other:?}"),
            }
        };
        cases.push(Case::new("points", format!("points, {name}"), Ok(inside.map(number).collect())));
    }
    cases
}

pub fn maps() -> Vec<Case> {
    let unit = disk();
    let digon = |alpha: f64, from: f64| (Closed::Digon { alpha, from: from * PI }, 0);
    let domains = [
        digon(0.5, 0.0),
        digon(0.5, -0.25),
        digon(0.8, -0.3),
        digon(1.0, -0.4),
        digon(1.3, -0.7),
        digon(1.5, -0.8),
        (Closed::Power { a: 0.0, k: 2 }, 64),
        (Closed::Power { a: 0.12, k: 5 }, 400),
        (Closed::Power { a: 0.25, k: 2 }, 200),
        (Closed::Rational { a: 0.4, b: 0.1 }, 128),
    ];
    domains.into_iter().flat_map(|(closed, n)| both_ways(closed, n, &unit)).collect()
}

/// Rectangles, and sectors of annuli, whose grids are known.
pub fn grids() -> Vec<Case> {
    let case =
        |name: String, curve: &Curve, polygon: &SimplePolygon, marks: [f64; 4], truth: &dyn Fn(DVec2) -> DVec2| {
            let made = Quadrilateral::of_outline((polygon, curve), Marks::new(marks).unwrap());
            let made = made.map_err(|error| error.to_string());
            let numbers = made.and_then(|made| {
                let rectangle = made.map().map_err(|error| error.to_string())?;
                let cells = GridCells::new([8, 12]).unwrap();
                let grid = rectangle.grid(cells, &mut |_| true).unwrap();
                let node = |k: usize| truth(DVec2::new((k % 9) as f64 / 8.0, (k / 9) as f64 / 12.0));
                let off = grid.nodes().iter().enumerate().map(|(k, at)| at.distance(node(k))).fold(0.0, f64::max);
                Ok(vec![Number::new(grid.image_error(), off, 2e-15)])
            });
            Case::new("grids", name, numbers)
        };
    let mut cases = Vec::new();
    for rho in [1.0, 1.5, 3.0, 6.0, 10.0, 16.0, 20.0] {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, rho), (0.0, rho)].map(DVec2::from).to_vec();
        let polygon = SimplePolygon::try_from(corners).unwrap();
        let curve = Curve::from_polygon(&polygon).unwrap();
        let whole = 2.0 * (1.0 + rho);
        let marks = [0.0, 1.0 / whole, (1.0 + rho) / whole, (2.0 + rho) / whole];
        cases.push(case(format!("rectangle {rho}:1"), &curve, &polygon, marks, &|p| DVec2::new(p.x, rho * p.y)));
    }
    for (radius, angle) in [(2.0, 1.0), (1.5, 2.5), (3.0, 4.0)] {
        let (inner, outer) = (DVec2::from_angle(0.0), radius * DVec2::from_angle(0.0));
        let turned = |p: DVec2| DVec2::from_angle(angle).rotate(p);
        let pieces = vec![
            Piece::Line([inner, outer]),
            Piece::circular(DVec2::ZERO, radius, 0.0, angle),
            Piece::Line([turned(outer), turned(inner)]),
            Piece::circular(DVec2::ZERO, 1.0, angle, 0.0),
        ];
        let curve = Curve::new(pieces).unwrap();
        let place = |k: usize| curve.position(CurvePoint::new(k / 50, (k % 50) as f64 / 50.0));
        let polygon = SimplePolygon::try_from((0..200).map(place).collect::<Vec<_>>()).unwrap();
        let lengths = curve.lengths();
        let whole = curve.perimeter();
        let ends = [0.0, lengths[0], lengths[0] + lengths[1], lengths[0] + lengths[1] + lengths[2]];
        let truth = |p: DVec2| radius.powf(p.x) * DVec2::from_angle(angle * p.y);
        cases.push(case(format!("sector {radius}, {angle}"), &curve, &polygon, ends.map(|end| end / whole), &truth));
    }
    cases
}

/// Caps, whose ratio of scales is sec²(r/2), and two inlets by two independent methods.
pub fn projections() -> Vec<Case> {
    let made = |name: String, rings: &[Vec<DVec2>], truth: f64, slack: f64| {
        let found = Region::new(rings).and_then(Projection::new).map_err(|error| error.to_string());
        let numbers = found.map(|found| {
            let stated = found.scale_ratio() * found.residual().exp_m1();
            vec![Number::new(stated, (found.scale_ratio() - truth).abs(), slack)]
        });
        Case::new("projections", name, numbers)
    };
    let cap = |radius: f64| {
        let (sine, cosine) = radius.to_radians().sin_cos();
        let point = |k: u32| {
            let (up, east) = (TAU * f64::from(k) / 720.0).sin_cos();
            DVec2::new((sine * east).atan2(cosine).to_degrees(), (sine * up).asin().to_degrees())
        };
        let truth = 2.0 / (1.0 + cosine);
        // the edges between 720 points lie inside by up to r²/2 (π/720)²
        made(format!("cap of {radius}°"), &[(0..720).map(point).collect()], truth, 2e-5 * (truth - 1.0))
    };
    let mut cases = vec![cap(5.0), cap(30.0)];
    let inlets = [
        ("0.2-3", &include_bytes!("coast-v-0.2-3.geojson")[..], 1.001_400_4),
        ("1-3", &include_bytes!("coast-v-1-3.geojson")[..], 1.001_387_4),
    ];
    for (name, bytes, truth) in inlets {
        let rings: Vec<Vec<DVec2>> =
            parse_geo_rings(bytes, &Reading::default()).unwrap().iter().map(|ring| ring.points.clone()).collect();
        cases.push(made(format!("coast with an inlet, {name}"), &rings, truth, 1e-7));
    }
    cases
}
