//! The presets agree with their formulas.

use super::*;
use crate::exact::{Complex, blob, vshape};
use crate::geometry::DVec2;
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
        let samples = uniform(&preset.outline().polygon, m);
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
    assert_eq!(Preset::VShape.outline().polygon.vertices()[0], DVec2::new(1.0, 1.0));
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
        let polygon = preset.outline().polygon;
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
        let polygon = preset.outline().polygon;
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
