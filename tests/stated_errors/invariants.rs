//! `invariants`: lists of points, polygons, notches, needles, channels, circular arcs, and the same figure twice.

use super::closed::{Closed, measure};
use super::judge::{Case, Number, number, pair};
use riemap::boundary_integral::{Invariants, InvariantsRequest, invariants, modulus};
use riemap::exact::{Complex, point};
use riemap::geometry::{Curve, CurvePoint, DVec2, Piece, SimplePolygon};
use riemap::outline::{CurveForm, Interpretation};
use std::f64::consts::{PI, TAU};

/// Rounding of the truth.
const SLACK: f64 = 1e-15;

fn found(curve: &Curve, x: DVec2, marks: Option<[CurvePoint; 4]>) -> Result<Invariants, String> {
    invariants(curve, &InvariantsRequest::new(x).with_marks(marks)).map_err(|error| error.to_string())
}

/// The points of a smooth list with these indices, on its spline or splines.
fn at_points(polygon: &SimplePolygon, curve: &Curve, indices: [usize; 4]) -> [CurvePoint; 4] {
    let on_piece = |piece: &Piece, at: DVec2| match *piece {
        Piece::Spline { ref spline, from, to } => {
            let k = (from..to).find(|&k| spline.points()[k] == at)?;
            Some(spline.span([from, k]) / spline.span([from, to]))
        }
        _ => (piece.jet(0.0).position == at).then_some(0.0),
    };
    indices.map(|index| {
        let at = polygon.vertices()[index];
        let mut places = curve.pieces().iter().enumerate();
        places.find_map(|(k, piece)| on_piece(piece, at).map(|t| CurvePoint::new(k, t))).unwrap()
    })
}

fn closed_list(closed: Closed, n: usize, w: Complex) -> Case {
    let (polygon, curve) = closed.curve(n);
    let indices = [0, n / 4, n / 2, 2 * n / 3];
    let marks = at_points(&polygon, &curve, indices);
    let numbers = found(&curve, point(closed.place(w)), Some(marks)).map(|found| {
        let angle = |k: usize| TAU * k as f64 / n as f64;
        let truths: [f64; 4] = std::array::from_fn(|k| measure(w, angle(indices[k]), angle(indices[(k + 1) % 4])));
        let arcs = found.arcs.unwrap();
        let mut numbers: Vec<Number> = arcs.iter().zip(truths).map(|(arc, truth)| number(*arc, truth, SLACK)).collect();
        numbers.push(number(found.conformal_radius, closed.radius(w), SLACK));
        numbers.push(number(found.modulus.unwrap(), modulus(truths), SLACK));
        if let Closed::Power { a: 0.0, .. } = closed {
            numbers.push(number(found.capacity, 1.0, SLACK));
        }
        numbers
    });
    Case::new("smooth lists", format!("{closed:?} of {n} points from {w}"), numbers)
}

fn ellipse_list(a: f64, n: usize) -> Case {
    let at = |k: usize| TAU * k as f64 / n as f64;
    let points: Vec<DVec2> = (0..n).map(|k| DVec2::new(a * at(k).cos(), at(k).sin())).collect();
    let polygon = SimplePolygon::try_from(points).unwrap();
    let form = CurveForm { interpretation: Interpretation::Smooth, ..CurveForm::default() };
    let curve = form.curve(&polygon).unwrap().into_curve();
    let marks = at_points(&polygon, &curve, [0, n / 4, n / 2, 3 * n / 4]);
    let numbers = found(&curve, DVec2::ZERO, Some(marks)).map(|found| {
        let mut numbers: Vec<Number> = found.arcs.unwrap().iter().map(|arc| number(*arc, 0.25, SLACK)).collect();
        numbers.push(number(found.capacity, 0.5 * (a + 1.0), SLACK));
        numbers.push(number(found.modulus.unwrap(), 1.0, SLACK));
        numbers
    });
    Case::new("smooth lists", format!("ellipse {a}:1 of {n} points"), numbers)
}

pub fn lists() -> Vec<Case> {
    let (center, beside) = (Complex::new(0.0, 0.0), Complex::new(0.5, -0.3));
    let (circle, flower) = (Closed::Power { a: 0.0, k: 2 }, Closed::Power { a: 0.12, k: 5 });
    let (egg, bent) = (Closed::Power { a: 0.25, k: 2 }, Closed::Rational { a: 0.4, b: 0.1 });
    let mut cases: Vec<Case> = [24, 32, 64, 128, 512, 2048, 8192].map(|n| closed_list(circle, n, center)).into();
    for w in [center, beside] {
        cases.extend([48, 96, 192, 768].map(|n| closed_list(flower, n, w)));
        cases.extend([24, 64, 256, 1000].map(|n| closed_list(egg, n, w)));
        cases.extend([32, 64, 128, 512].map(|n| closed_list(bent, n, w)));
    }
    for a in [2.0, 5.0] {
        cases.extend([40, 64, 200, 1600].map(|n| ellipse_list(a, n)));
    }
    cases
}

/// A polygon of the table `schwarz_christoffel.csv`, which `schwarz_christoffel.py` wrote: the image of the unit disk.
struct Tabled {
    kind: &'static str,
    name: String,
    angles: Vec<f64>,
    corners: Vec<DVec2>,
    /// Of points in the disk: w, its image, |f′(w)|.
    points: Vec<(Complex, DVec2, f64)>,
}

fn table() -> Vec<Tabled> {
    let mut all: Vec<Tabled> = Vec::new();
    for line in include_str!("schwarz_christoffel.csv").lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let numbers: Vec<f64> = words[1..].iter().filter_map(|word| word.parse().ok()).collect();
        let last = all.len().wrapping_sub(1);
        match words[0] {
            "corner" => {
                all[last].angles.push(numbers[0]);
                all[last].corners.push(DVec2::new(numbers[1], numbers[2]));
            }
            "point" => {
                let place = DVec2::new(numbers[2], numbers[3]);
                all[last].points.push((Complex::new(numbers[0], numbers[1]), place, numbers[4]));
            }
            kind => {
                let kind = ["notches", "needles", "polygons"].into_iter().find(|k| k.starts_with(&kind[..4])).unwrap();
                let name = words.join(" ");
                all.push(Tabled { kind, name, angles: Vec::new(), corners: Vec::new(), points: Vec::new() });
            }
        }
    }
    all
}

fn curve_of(corners: &[DVec2]) -> Curve {
    Curve::from_polygon(&SimplePolygon::try_from(corners.to_vec()).unwrap()).unwrap()
}

pub fn tabled() -> Vec<Case> {
    let case = |polygon: &Tabled, (w, x, slope): (Complex, DVec2, f64)| {
        let numbers = found(&curve_of(&polygon.corners), x, None).map(|found| {
            let count = polygon.angles.len();
            let side = |k: usize| {
                let next = polygon.angles[(k + 1) % count] + if k + 1 == count { TAU } else { 0.0 };
                number(found.pieces[k], measure(w, polygon.angles[k], next), SLACK)
            };
            let mut numbers: Vec<Number> = (0..count).map(side).collect();
            numbers.push(number(found.conformal_radius, slope * (1.0 - w.norm_sqr()), SLACK));
            numbers
        });
        Case::new(polygon.kind, format!("{} from {w}", polygon.name), numbers)
    };
    table().iter().flat_map(|polygon| polygon.points.iter().map(|&p| case(polygon, p)).collect::<Vec<_>>()).collect()
}

/// Rotated, enlarged and moved, a figure has the same measures, and radius and capacity in proportion.
pub fn pairs() -> Vec<Case> {
    let tables = table();
    let polygons = tables.iter().filter(|polygon| polygon.kind == "polygons");
    let mut figures: Vec<(String, Vec<DVec2>, DVec2)> =
        polygons.map(|p| (p.name.clone(), p.corners.clone(), p.points[1].1)).collect();
    for n in [40_u32, 100] {
        let star = |k: u32| {
            let radius = 1.0 + 0.2 * f64::from(k * 7 % 5) / 5.0;
            radius * DVec2::from_angle(TAU * f64::from(k) / f64::from(n))
        };
        figures.push((format!("star of {n}"), (0..n).map(star).collect(), DVec2::new(0.1, 0.2)));
    }
    let case = |(name, corners, x): (String, Vec<DVec2>, DVec2)| {
        let moved = |p: DVec2| 3.0 * DVec2::from_angle(1.1).rotate(p) + DVec2::new(5.0, -2.0);
        let moved_corners: Vec<DVec2> = corners.iter().map(|&p| moved(p)).collect();
        let both = found(&curve_of(&corners), x, None)
            .and_then(|first| found(&curve_of(&moved_corners), moved(x), None).map(|second| (first, second)));
        let numbers = both.map(|(a, b)| {
            let mut numbers: Vec<Number> = a.pieces.iter().zip(&b.pieces).map(|(a, b)| pair(*a, *b, SLACK)).collect();
            for (a, mut b) in [(a.conformal_radius, b.conformal_radius), (a.capacity, b.capacity)] {
                (b.value, b.error) = (b.value / 3.0, b.error / 3.0);
                numbers.push(pair(a, b, SLACK));
            }
            numbers
        });
        Case::new("similar figures", format!("{name}, moved"), numbers)
    };
    figures.into_iter().map(case).collect()
}

/// R of ρ×1 at its center, 2/(1 + k) over K(1 + k) in widths, by theta functions of the nome.
fn rectangle_radius(rho: f64) -> f64 {
    let nome = (-2.0 * PI / rho).exp();
    let theta_2: f64 = 2.0 * (0..60).map(|n| nome.powf((f64::from(n) + 0.5).powi(2))).sum::<f64>();
    let theta_3: f64 = 1.0 + 2.0 * (1..60).map(|n| nome.powf(f64::from(n * n))).sum::<f64>();
    rho * 2.0 / (PI * (theta_2 * theta_2 + theta_3 * theta_3))
}

fn rectangle_ends(rho: f64) -> f64 {
    let term = |k: i32| {
        let odd = f64::from(2 * k + 1);
        f64::from(1 - 2 * (k % 2)) / ((0.5 * PI * rho * odd).cosh() * odd)
    };
    2.0 / PI * (0..60).map(term).sum::<f64>()
}

pub fn channels() -> Vec<Case> {
    let corners = [1, 2, 3, 0].map(|k| CurvePoint::new(k, 0.0));
    let mut cases = Vec::new();
    for rho in [1.5, 3.0, 6.0, 10.0, 15.0, 20.0] {
        let curve = curve_of(&[(0.0, 0.0), (rho, 0.0), (rho, 1.0), (0.0, 1.0)].map(DVec2::from));
        for (share, name) in [(0.5, "center"), (0.3, "side")] {
            let numbers = found(&curve, DVec2::new(share * rho, 0.5), Some(corners)).map(|found| {
                let mut numbers = vec![number(found.modulus.unwrap(), rho, SLACK * rho)];
                if share == 0.5 {
                    numbers.push(number(found.conformal_radius, rectangle_radius(rho), 4.0 * SLACK));
                    numbers.extend([1, 3].map(|k| number(found.pieces[k], rectangle_ends(rho), 1e-18)));
                }
                numbers
            });
            cases.push(Case::new("channels", format!("rectangle {rho}:1 from its {name}"), numbers));
        }
    }
    let l = curve_of(&[(0., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)].map(DVec2::from));
    for (marks, truth) in [([1, 2, 4, 5], 2.558_523_142_342_013), ([0, 1, 4, 5], 3.0_f64.sqrt())] {
        let marks_on = marks.map(|k| CurvePoint::new(k, 0.0));
        let numbers = found(&l, DVec2::new(0.5, 0.5), Some(marks_on));
        let numbers = numbers.map(|found| vec![number(found.modulus.unwrap(), truth, SLACK)]);
        cases.push(Case::new("channels", format!("L-shape between {marks:?}"), numbers));
    }
    cases
}

/// Digons between two circular arcs; outside of one is a digon too.
pub fn digons() -> Vec<Case> {
    let shapes = [
        (0.03, -0.015),
        (0.1, -0.05),
        (0.3, 0.2),
        (0.5, 0.0),
        (0.8, -0.4),
        (1.0, -0.4),
        (1.3, -0.8),
        (1.6, -0.8),
        (1.9, -0.95),
        (1.97, -0.985),
    ];
    let mut cases = Vec::new();
    for (alpha, from) in shapes {
        let digon = Closed::Digon { alpha, from: from * PI };
        let (_, curve) = digon.curve(0);
        for w in [Complex::new(0.0, 0.0), Complex::new(-0.2, 0.4)] {
            let numbers = found(&curve, point(digon.place(w)), None).map(|found| {
                // −1 seen in the wedge outside, as a share of its angle
                let share = (1.0 - from - alpha) / (2.0 - alpha);
                let capacity = 1.0 / ((2.0 - alpha) * (PI * share).sin());
                vec![
                    number(found.conformal_radius, digon.radius(w), 2.0 * SLACK),
                    number(found.capacity, capacity, 2.0 * SLACK),
                    number(found.pieces[0], measure(w, PI, TAU), SLACK),
                    number(found.pieces[1], measure(w, 0.0, PI), SLACK),
                ]
            });
            cases.push(Case::new("circular arcs", format!("digon {alpha} π from {w}"), numbers));
        }
    }
    cases
}
