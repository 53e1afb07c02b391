//! The presets agree with their formulas.

use super::*;
use crate::exact::{Complex, blob, vshape};
use crate::geometry::{CurvePoint, DVec2};
use crate::test_data::exact_values;

/// `count` points equally spaced in arc length from the first vertex.
fn uniform(polygon: &SimplePolygon, count: usize) -> Vec<DVec2> {
    let step = polygon.perimeter() / count as f64;
    let mut samples = Vec::new();
    let mut travelled = 0.0;
    for (a, b) in polygon.edges() {
        let length = a.distance(b);
        while samples.len() < count && samples.len() as f64 * step < travelled + length {
            samples.push(a.lerp(b, (samples.len() as f64 * step - travelled) / length));
        }
        travelled += length;
    }
    samples
}

fn assert_resampled_outline_is_truth(preset: Preset, table: &str) {
    for m in [500, 1000, 2000] {
        let rows = exact_values(&format!("{table}_m{m}.txt"));
        let samples = uniform(preset.outline().polygon(), m);
        assert_eq!(samples.len(), rows.len());
        let error = samples.iter().zip(&rows).map(|(p, r)| p.distance(DVec2::new(r[0], r[1]))).fold(0.0, f64::max);
        println!("{preset}, m = {m}: {error:.2e}");
        // The chords are shorter than their arcs by less than 1e-5 in total.
        assert!(error <= 1e-5, "{preset}, m = {m}: {error:e}");
    }
}

#[test]
fn the_v_and_the_blob_are_the_papers() {
    assert_resampled_outline_is_truth(Preset::VShape, "vshape_to_blob");
    assert_resampled_outline_is_truth(Preset::Blob, "blob");
    assert_eq!(Preset::VShape.outline().polygon().vertices()[0], DVec2::new(1.0, 1.0));
}

#[test]
fn exact_measure_and_exact_map_of_the_v_agree_with_the_60_digit_table() {
    let rows = exact_values("vshape_to_blob_m2000.txt");
    let x = DVec2::new(0.96, 0.8432);
    let (mut measure_error, mut image_error) = (0f64, 0f64);
    for row in &rows {
        let omega = vshape::harmonic_measure(x, DVec2::new(row[0], row[1]));
        let image = blob::from_disk(Complex::cis(std::f64::consts::TAU * row[2])) - Complex::new(row[3], row[4]);
        // A full turn and none are the same place.
        measure_error = measure_error.max(((omega - row[2] + 0.5).rem_euclid(1.0) - 0.5).abs());
        image_error = image_error.max(image.norm());
    }
    println!("measure {measure_error:.1e}, image {image_error:.1e}");
    assert!(measure_error < 1e-13 && image_error < 1e-13, "{measure_error:e}, {image_error:e}");
}

#[test]
fn every_preset_s_curve_is_followed_by_its_polygon() {
    for preset in Preset::ALL {
        let (curve, polygon) = (preset.curve().unwrap(), preset.outline().polygon);
        let first = curve.position(curve.point_at_fraction(0.0)).distance(polygon.vertices()[0]);
        assert!(first < 1e-14, "{preset} begins {first:e} away");
        let shorter = curve.perimeter() - polygon.perimeter();
        // chords are shorter than their arcs
        assert!((-1e-12..1e-4).contains(&shorter), "{preset}: {shorter:e}");
        let tree = crate::geometry::EdgeTree::new(polygon.vertices().to_vec());
        for (piece, k) in curve.pieces().iter().flat_map(|piece| (0..100).map(move |k| (piece, k))) {
            let place = piece.jet(f64::from(k) / 100.0).position;
            let distance = tree.nearest_point(place).distance;
            // chords of the blob, whose extent is 8, and of the maple leaf's flat arcs
            assert!(distance < 3e-4, "{preset}: {place} is {distance:e} away from the polygon");
        }
        for piece in curve.pieces() {
            let (step, t) = (1e-6, 0.37);
            let [a, here, b] = [t - step, t, t + step].map(|t| piece.jet(t));
            let slope = (b.position - a.position) / (2.0 * step);
            let scale = here.first.length() + here.second.length();
            assert!(slope.distance(here.first) < 1e-6 * scale, "{preset}: {slope} for {}", here.first);
            let bend = (b.first - a.first) / (2.0 * step);
            assert!(bend.distance(here.second) < 1e-5 * scale, "{preset}: {bend} for {}", here.second);
        }
    }
}

#[test]
fn every_preset_is_a_counter_clockwise_simple_polygon_of_bounded_size() {
    for preset in Preset::ALL {
        let outline = preset.outline();
        let vertices = outline.polygon.vertices().to_vec();
        assert!(vertices.len() <= 6500, "{preset} has {} vertices", vertices.len());
        let checked = SimplePolygon::try_from(vertices).unwrap_or_else(|e| panic!("{preset}: {e}"));
        assert!(!checked.was_clockwise(), "{preset} runs clockwise");
        assert!(outline.notes.is_empty() && outline.name == preset.name());
        let [min, max] = checked.bounds().corners();
        let drawn_here = !matches!(preset, Preset::Blob | Preset::VShape);
        assert!(!drawn_here || (min.min_element() >= -1.0 && max.max_element() <= 1.0), "{preset}: {min} to {max}");
    }
}

/// Turning angles are those of a smooth piece (below 2°) or of a corner (above
/// 10°), so that a corner can be told from a curve.
#[test]
fn smooth_pieces_turn_slowly_and_corners_clearly() {
    let corners = [
        (Preset::Disk, 0),
        (Preset::Square, 4),
        (Preset::Gingerbread, 0),
        (Preset::Heart, 2),
        (Preset::Blob, 0),
        (Preset::VShape, 0),
        (Preset::Cinquefoil, 5),
        (Preset::Hand, 0),
        (Preset::LShape, 6),
        (Preset::Star, 10),
        (Preset::Spiral, 0),
    ];
    for (preset, expected) in corners {
        let polygon = preset.outline().into_polygon();
        let v = polygon.vertices();
        let n = v.len();
        let turn = |k: usize| (v[k] - v[(k + n - 1) % n]).angle_to(v[(k + 1) % n] - v[k]).abs().to_degrees();
        let sharp = (0..n).filter(|&k| turn(k) > 10.0).count();
        let between = (0..n).map(turn).filter(|&t| (2.0..10.0).contains(&t)).count();
        assert_eq!((sharp, between), (expected, 0), "{preset}");
    }
}

#[test]
fn a_pole_is_inside_every_preset() {
    for preset in Preset::ALL {
        let polygon = preset.outline().into_polygon();
        let extent = polygon.bounds().size().max_element();
        let start = web_time::Instant::now();
        let pole = polygon.pole_of_inaccessibility(1e-3 * extent);
        println!("{preset}: {pole} in {:.2} ms", start.elapsed().as_secs_f64() * 1e3);
        assert!(polygon.contains(pole), "{preset}: {pole}");
    }
}

#[test]
fn names_are_read_back_and_an_unknown_one_lists_them() {
    for preset in Preset::ALL {
        assert_eq!(preset.name().parse(), Ok(preset));
        assert_eq!(serde_json::to_string(&preset).unwrap(), format!("\"{preset}\""));
        assert!(!preset.title().is_empty());
    }
    let error = "pentagon".parse::<Preset>().unwrap_err().to_string();
    assert!(error.contains("\"pentagon\"") && error.contains("gingerbread") && error.contains("v-shape"), "{error}");
}

/// The bits of all coordinates, folded by FNV-1a (64 bits).
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn fingerprint(points: &[DVec2]) -> u64 {
    let bytes = points.iter().flat_map(DVec2::to_array).flat_map(|x| x.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// Links, files and the paper's figures hold fractions of these polygons; the elementary functions of other systems
/// may round differently.
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
#[test]
fn the_polygons_of_the_presets_never_change() {
    let expected = [
        (Preset::Disk, 1440, 0x0946_d800_2b7e_64c6),
        (Preset::Square, 5, 0xc8a9_6819_8aad_c1ed),
        (Preset::Gingerbread, 2394, 0x6871_56e0_3629_98f1),
        (Preset::Heart, 996, 0xff11_a84d_d0b1_9b86),
        (Preset::Blob, 5988, 0x70de_2a30_20b1_2cf1),
        (Preset::VShape, 3052, 0x7ac1_172c_f866_856d),
        (Preset::Cinquefoil, 1660, 0xf033_9d74_e7ad_3ed3),
        (Preset::MapleLeaf, 665, 0x2335_9c7c_9f52_601d),
        (Preset::Hand, 2643, 0x8679_bf9f_5ec6_e4c3),
        (Preset::Turkey, 3300, 0x505d_07a3_27e8_f327),
        (Preset::LShape, 7, 0x9d1b_5ac1_3826_0d25),
        (Preset::Star, 10, 0x3017_e9ae_4431_0b8c),
        (Preset::Spiral, 6156, 0x4670_4c33_aca1_83b7),
    ];
    assert_eq!(expected.map(|row| row.0), Preset::ALL);
    for (preset, count, bits) in expected {
        let outline = preset.outline();
        let found = (outline.polygon().vertices().len(), fingerprint(outline.polygon().vertices()));
        assert_eq!(found, (count, bits), "{preset}");
    }
}

/// The number of junctions of each kind: corners, smooth, analytic. Corners turn by more than a millionth.
fn kinds(curve: &Curve) -> [usize; 3] {
    let mut kinds = [0; 3];
    for junction in curve.junctions() {
        match junction {
            Junction::Corner { angle } if (angle - std::f64::consts::PI).abs() > 1e-6 => kinds[0] += 1,
            Junction::Analytic => kinds[2] += 1,
            _ => kinds[1] += 1,
        }
    }
    kinds
}

#[test]
fn the_curves_of_the_presets_have_the_pieces_that_were_drawn() {
    let expected = [
        (Preset::Disk, [0, 0, 1]),
        (Preset::Square, [4, 0, 1]),
        (Preset::Gingerbread, [0, 34, 1]),
        (Preset::Heart, [2, 4, 0]),
        (Preset::Blob, [0, 0, 1]),
        (Preset::VShape, [0, 0, 3]),
        (Preset::Cinquefoil, [5, 0, 1]),
        (Preset::MapleLeaf, [29, 0, 0]),
        (Preset::Hand, [0, 42, 0]),
        (Preset::Turkey, [30, 1, 0]),
        (Preset::LShape, [6, 0, 1]),
        (Preset::Star, [10, 0, 0]),
        (Preset::Spiral, [0, 4, 1]),
    ];
    assert_eq!(expected.map(|row| row.0), Preset::ALL);
    for (preset, found) in expected {
        assert_eq!(kinds(&preset.curve().unwrap()), found, "{preset}");
    }
}

#[test]
fn the_polygons_of_the_presets_lie_on_their_curves() {
    for preset in Preset::ALL {
        let (curve, outline) = (preset.curve().unwrap(), preset.outline());
        let vertices = outline.polygon().vertices();
        assert!(curve.position(CurvePoint::new(0, 0.0)).distance(vertices[0]) < 1e-15, "{preset} begins elsewhere");
        let mut from = 0;
        let mut worst = 0f64;
        // the pieces in order, each with the vertices up to its end
        for piece in curve.pieces() {
            let end = piece.jet(1.0).position;
            let to = (from + 1..=vertices.len()).find(|&k| vertices[k % vertices.len()].distance(end) < 1e-13).unwrap();
            for k in from..=to {
                worst = worst.max(distance(piece, vertices[k % vertices.len()]));
            }
            from = to;
        }
        println!("{preset}: {worst:.1e}");
        assert_eq!(from, vertices.len(), "{preset}");
        assert!(worst < 1e-14, "{preset}: {worst:e}");
        let shorter = 1.0 + 1e-14 - outline.polygon().perimeter() / curve.perimeter();
        assert!((0.0..1e-4).contains(&shorter), "{preset}: chords are shorter by {shorter:e}");
    }
}

/// The distance of a point from a piece, by Gauss and Newton's method from the nearest of 1,000 points.
fn distance(piece: &Piece, p: DVec2) -> f64 {
    let mut t = (0..=1000)
        .map(|k| f64::from(k) / 1000.0)
        .min_by(|a, b| piece.jet(*a).position.distance(p).total_cmp(&piece.jet(*b).position.distance(p)))
        .unwrap();
    for _ in 0..8 {
        let jet = piece.jet(t);
        let offset = jet.position - p;
        t = (t - offset.dot(jet.first) / jet.first.length_squared()).clamp(0.0, 1.0);
    }
    piece.jet(t).position.distance(p)
}

#[test]
fn the_disk_is_the_unit_circle() {
    let curve = Preset::Disk.curve().unwrap();
    assert!((curve.perimeter() - std::f64::consts::TAU).abs() < 1e-14);
    for k in 0..=1000 {
        let t = f64::from(k) / 1000.0;
        let error = curve.pieces()[0].jet(t).position.distance(DVec2::from_angle(std::f64::consts::TAU * t));
        assert!(error < 1e-15, "{t}: {error:e}");
    }
    let jet = curve.pieces()[0].jet(0.3);
    assert!((jet.curvature() - 1.0).abs() < 1e-15);
}

/// The derivatives of the formulas and the joints between arcs and lines.
#[test]
fn tangents_and_curvatures_are_those_of_the_positions() {
    let step = 1e-4;
    for preset in Preset::ALL {
        let curve = preset.curve().unwrap();
        for piece in curve.pieces() {
            for k in 1..50 {
                let t = f64::from(k) / 50.0;
                let [a, here, b] = [t - step, t, t + step].map(|t| piece.jet(t));
                let scale = here.second.length().max(here.first.length());
                let first = (b.position - a.position) / (2.0 * step);
                let second = (b.first - a.first) / (2.0 * step);
                assert!(first.distance(here.first) < 1e-4 * scale, "{preset} {piece:?} at {t}");
                assert!(second.distance(here.second) < 1e-2 * scale, "{preset} {piece:?} at {t}");
            }
        }
    }
}
