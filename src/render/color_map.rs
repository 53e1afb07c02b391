//! Color maps for numbers that remain readable with color vision deficiency.
//!
//! [`ColourMap::Cividis`] runs from dark blue to yellow in even steps of lightness
//! and looks nearly the same with red–green blindness (Nuñez, Anderton, Renslow:
//! "Optimizing colormaps with consideration for color vision deficiency", PLoS ONE
//! 2018); ten of its colors are stored and interpolated linearly, in encoded
//! sRGB. [`ColourMap::Diverging`] is our own: purple below, white in the middle,
//! green above, of equal lightness at equal distance from the middle.

/// A map from [0, 1] to a color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourMap {
    /// For quantities with a natural zero: dark is little, light is much.
    Cividis,
    /// For quantities with a natural middle: purple is less, green is more.
    Diverging,
}

/// sRGB bytes at 0, 1/9, …, 1.
const CIVIDIS: [[u8; 3]; 10] = [
    [0, 34, 78],
    [18, 53, 112],
    [59, 73, 108],
    [87, 93, 109],
    [112, 113, 115],
    [138, 134, 120],
    [165, 156, 116],
    [195, 179, 105],
    [225, 204, 85],
    [254, 232, 56],
];

/// sRGB bytes at 0, 1/6, …, 1.
const DIVERGING: [[u8; 3]; 7] =
    [[82, 25, 108], [139, 95, 165], [201, 179, 213], [245, 244, 242], [168, 202, 170], [66, 130, 82], [2, 68, 30]];

/// The colors of triangles that have no number: Okabe–Ito's vermillion for
/// flipped ones, a dark gray for those whose image is a point.
const FLIPPED_COLOR: [u8; 3] = [213, 94, 0];
const COLLAPSED_COLOR: [u8; 3] = [64, 64, 64];

/// The color of a triangle: an index into a palette of 256.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub struct CellCode(u8);

impl CellCode {
    /// The image is a point up to rounding.
    pub const COLLAPSED: Self = Self(254);
    /// The orientation is reversed.
    pub const FLIPPED: Self = Self(255);

    /// The code of the color at `t` of a map, rounded to one of 254; clamped to [0, 1], NaN is 0.
    pub fn at(t: f64) -> Self {
        Self((253.0 * t.clamp(0.0, 1.0)).round() as u8)
    }
}

impl ColourMap {
    /// The color at `t`, clamped to [0, 1]; sRGB-encoded, opaque.
    pub fn at(self, t: f64) -> [f32; 4] {
        let points: &[[u8; 3]] = match self {
            Self::Cividis => &CIVIDIS,
            Self::Diverging => &DIVERGING,
        };
        let place = t.clamp(0.0, 1.0) as f32 * (points.len() - 1) as f32;
        let below = (place as usize).min(points.len() - 2);
        let (low, high) = (points[below], points[below + 1]);
        let mix =
            |i: usize| (f32::from(low[i]) + (place - below as f32) * (f32::from(high[i]) - f32::from(low[i]))) / 255.0;
        [mix(0), mix(1), mix(2), 1.0]
    }

    /// The colors of all codes.
    pub(super) fn palette(self) -> [[u8; 4]; 256] {
        std::array::from_fn(|code| match code {
            0..=253 => self.at(code as f64 / 253.0).map(|component| (255.0 * component).round() as u8),
            254 => opaque(COLLAPSED_COLOR),
            _ => opaque(FLIPPED_COLOR),
        })
    }
}

/// The color of flipped triangles, sRGB-encoded.
pub fn flipped_colour() -> [f32; 4] {
    opaque(FLIPPED_COLOR).map(|component| f32::from(component) / 255.0)
}

fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use super::super::style::linear_color;
    use super::*;

    /// CIE lightness L* from the relative luminance of sRGB (IEC 61966-2-1).
    fn lightness(colour: [f32; 4]) -> f32 {
        let [r, g, b, _] = linear_color(colour);
        let y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        if y > 0.008_856 { 116.0 * y.cbrt() - 16.0 } else { 903.3 * y }
    }

    #[test]
    fn cividis_gets_lighter_in_even_steps() {
        let l: Vec<f32> = (0..=20).map(|k| lightness(ColourMap::Cividis.at(f64::from(k) / 20.0))).collect();
        let mean = (l[20] - l[0]) / 20.0;
        for pair in l.windows(2) {
            let step = pair[1] - pair[0];
            assert!((step / mean - 1.0).abs() < 0.25, "a step of {step}, where {mean} is the mean: {l:?}");
        }
        assert!(l[0] < 15.0 && l[20] > 90.0, "{l:?}");
    }

    #[test]
    fn the_diverging_map_is_as_light_on_either_side_and_lightest_in_the_middle() {
        let l = |t: f64| lightness(ColourMap::Diverging.at(t));
        assert!(l(0.5) > 95.0);
        for k in 0..10 {
            let (t, next) = (f64::from(k) / 20.0, f64::from(k + 1) / 20.0);
            assert!((l(t) - l(1.0 - t)).abs() < 3.0, "at {t}: {} and {}", l(t), l(1.0 - t));
            assert!(l(t) < l(next) && l(1.0 - t) < l(1.0 - next), "not monotone at {t}");
        }
    }

    #[test]
    fn values_beyond_the_range_have_the_colors_of_its_ends() {
        for map in [ColourMap::Cividis, ColourMap::Diverging] {
            assert_eq!(map.at(-3.0), map.at(0.0));
            assert_eq!(map.at(1.5), map.at(1.0));
        }
        assert_eq!(ColourMap::Cividis.at(1.0), [254.0 / 255.0, 232.0 / 255.0, 56.0 / 255.0, 1.0]);
        assert_eq!(
            (CellCode::at(-1.0), CellCode::at(f64::NAN), CellCode::at(2.0)),
            (CellCode(0), CellCode(0), CellCode(253))
        );
    }

    #[test]
    fn the_marks_are_no_colors_of_numbers() {
        for map in [ColourMap::Cividis, ColourMap::Diverging] {
            let palette = map.palette();
            for mark in [FLIPPED_COLOR, COLLAPSED_COLOR] {
                let nearest = palette[..254].iter().map(|c| (0..3).map(|i| c[i].abs_diff(mark[i])).max());
                assert!(nearest.min() > Some(Some(8)), "{map:?} has the colour {mark:?}");
            }
        }
    }
}
