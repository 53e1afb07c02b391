//! Colors with different meanings remain distinguishable with color vision deficiencies.
//!
//! The deficiencies are simulated by the matrices for linear sRGB of Machado, Oliveira and Fernandes: "A
//! physiologically-based model for simulation of color vision deficiency", IEEE TVCG 2009, severity 1.

use crate::app::plots::inks_of_plots;
use crate::app::theme::{BOUNDARY_COLOUR, INTERIOR_COLOUR};
use crate::render::ColourMap;
use egui::Color32;

const NORMAL: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const PROTANOPIA: [[f64; 3]; 3] =
    [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]];
const DEUTERANOPIA: [[f64; 3]; 3] =
    [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]];
const TRITANOPIA: [[f64; 3]; 3] =
    [[1.255_528, -0.076_749, -0.178_779], [-0.078_411, 0.930_809, 0.147_602], [0.004_733, 0.691_367, 0.303_900]];

const ALL_EYES: [(&str, [[f64; 3]; 3]); 4] =
    [("usual", NORMAL), ("protanopia", PROTANOPIA), ("deuteranopia", DEUTERANOPIA), ("tritanopia", TRITANOPIA)];

/// From linear sRGB to CIE XYZ (IEC 61966-2-1).
const XYZ: [[f64; 3]; 3] = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]];
/// The XYZ of white (D65).
const WHITE: [f64; 3] = [0.950_47, 1.0, 1.088_83];

/// The least difference required, six times the just noticeable one (2.3, Mahy et al. 1994): visible on lines two
/// pixels wide.
const DISTINCT: f64 = 14.0;

fn times(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum())
}

/// CIE L*a*b* of a color after the simulation by the matrix `seen`.
fn lab(colour: Color32, seen: &[[f64; 3]; 3]) -> [f64; 3] {
    let linear = |encoded: u8| {
        let encoded = f64::from(encoded) / 255.0;
        if encoded <= 0.040_45 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
    };
    let seen = times(seen, [colour.r(), colour.g(), colour.b()].map(linear)).map(|channel| channel.clamp(0.0, 1.0));
    let xyz = times(&XYZ, seen);
    let f = |k: usize| {
        let t = xyz[k] / WHITE[k];
        if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 }
    };
    [116.0 * f(1) - 16.0, 500.0 * (f(0) - f(1)), 200.0 * (f(1) - f(2))]
}

fn difference(a: Color32, b: Color32, seen: &[[f64; 3]; 3]) -> f64 {
    let [a, b] = [a, b].map(|colour| lab(colour, seen));
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn colors_remain_distinct_with_color_vision_deficiencies() {
    let dots = vec![INTERIOR_COLOUR, BOUNDARY_COLOUR];
    for group in inks_of_plots().into_iter().chain([dots]) {
        for (k, a) in group.iter().enumerate() {
            for b in &group[..k] {
                for (eyes, seen) in ALL_EYES {
                    let apart = difference(*a, *b, &seen);
                    assert!(apart > DISTINCT, "{eyes}: {a:?} and {b:?} differ by {apart:.1}");
                }
            }
        }
    }
}

#[test]
fn color_maps_keep_their_order_of_lightness() {
    let at = |map: ColourMap, t: f64| {
        let [r, g, b, _] = map.at(t).map(|component| (255.0 * component).round() as u8);
        Color32::from_rgb(r, g, b)
    };
    for (eyes, seen) in ALL_EYES {
        let lightness = |map, t| lab(at(map, t), &seen)[0];
        for k in 0..20 {
            let (t, u) = (f64::from(k) / 20.0, f64::from(k + 1) / 20.0);
            assert!(lightness(ColourMap::Cividis, u) > lightness(ColourMap::Cividis, t), "{eyes}: {t}");
            let outwards = |side: f64| {
                lightness(ColourMap::Diverging, 0.5 + side * 0.5 * u)
                    < lightness(ColourMap::Diverging, 0.5 + side * 0.5 * t)
            };
            assert!(outwards(-1.0) && outwards(1.0), "{eyes}: darker on both sides of the middle, {t}");
        }
        let ends = difference(at(ColourMap::Diverging, 0.2), at(ColourMap::Diverging, 0.8), &seen);
        assert!(ends > DISTINCT, "{eyes}: less and more differ by {ends:.1}");
    }
}

#[test]
fn the_simulation_confuses_red_and_green_and_keeps_white() {
    let (red, green) = (Color32::from_rgb(200, 60, 40), Color32::from_rgb(110, 110, 20));
    assert!(difference(red, green, &NORMAL) > 50.0);
    assert!(difference(red, green, &DEUTERANOPIA) < 20.0, "{}", difference(red, green, &DEUTERANOPIA));
    for seen in [NORMAL, PROTANOPIA, DEUTERANOPIA, TRITANOPIA] {
        assert!(difference(Color32::WHITE, Color32::BLACK, &seen) > 99.0, "white stays white");
    }
}
