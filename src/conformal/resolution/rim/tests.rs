//! The measure along a rim: places and measures belong together, also where steps are tiny.

use super::*;

fn square() -> BoundarySamples {
    let points: Vec<DVec2> =
        [(0., 0.), (1., 0.), (2., 0.), (2., 1.), (2., 2.), (1., 2.), (0., 2.), (0., 1.)].map(DVec2::from).into();
    let fractions = (0..8).map(|k| f64::from(k) / 8.0).collect();
    BoundarySamples::checked(points, vec![1.0; 8], fractions).unwrap()
}

#[test]
fn a_place_has_the_measure_that_led_to_it_on_both_halves() {
    let samples = square();
    let psi = [1e-12, 0.3, 1e-3, 0.2, 1e-9, 0.25, 1e-5, 0.1];
    for anchor in [BoundaryPoint::new(0, 0.0), BoundaryPoint::new(3, 0.25)] {
        let measure = HarmonicMeasure::new(&samples, &psi, anchor);
        let rim = Rim::new(&samples, &measure, std::iter::empty()).unwrap();
        for k in 0..=800 {
            let s = f64::from(k) / 100.0;
            let again = rim.length_of(rim.at(s));
            // measures are told apart to 1e-16, places where the density is 1e-9 to 1e-7
            assert!((again - s).abs() < 1e-7, "{anchor:?}: {s} → {again}");
            let whole = samples.fraction_at(rim.point(s)) * 8.0;
            let off = (whole - s - samples.fraction_at(anchor) * 8.0).rem_euclid(8.0);
            assert!(off.min(8.0 - off) < 1e-12, "{anchor:?}: {s} is at {whole}");
        }
        assert_eq!(rim.vertices().count(), 8);
        assert!((rim.length() - 8.0).abs() < 1e-15);
    }
}

#[test]
fn measures_of_1e_30_before_the_end_are_told_apart() {
    let samples = square();
    let psi = [1e-30, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 2e-30];
    let measure = HarmonicMeasure::new(&samples, &psi, BoundaryPoint::new(0, 0.0));
    let rim = Rim::new(&samples, &measure, std::iter::empty()).unwrap();
    let places = [7.5, 7.9].map(|s| rim.length_of(rim.at(s)));
    assert!((places[0] - 7.5).abs() < 1e-12 && (places[1] - 7.9).abs() < 1e-12, "{places:?}");
}
