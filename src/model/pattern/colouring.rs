//! What the colors of triangles mean: the quantity, its range, its distribution.
//!
//! Q has a fixed range, so that maps and resolutions can be compared (as in the
//! paper's Figure 9). The area distortion spans powers of ten in one map and a few
//! per cent in another, about a mean that depends on the units of length: its range is symmetric about the mean over the
//! mapped mesh's area and the smallest of a few that holds nearly the whole area, and it is changed only if it no longer
//! fits, so that colors do not flicker.

use crate::conformal::{Direction, Histogram, TriangleDistortion};
use crate::language::{Label, decimal, key, number};
use crate::mesh::TriangleId;
use crate::render::{CellCode, ColourMap};
use crate::session::Colouring;

/// Q from 1 to here: 1.5 is an angle of 90° seen as 67°, plainly wrong to the eye.
const ANGLE_TOP: f64 = 1.5;

/// Ranges of log₂ of the area's factor, either way from its mean. A quarter is a factor of 1.2.
const AREA_RANGES: [f64; 11] = [0.25, 0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0];
/// A range fits while no more than this share of the area lies beyond it, …
const AREA_BEYOND: f64 = 0.02;
/// … and is too wide when less than this share lies beyond a smaller one.
const AREA_SPARE: f64 = 0.005;

/// Bins of the histogram in the legend.
const BINS: usize = 48;

/// A quantity of triangles with its colors.
#[derive(Debug, Clone, PartialEq)]
pub struct ColourScale {
    /// The quantity; never [`Colouring::Texture`].
    colouring: Colouring,
    /// The direction of the map; the factor of the area is always that from source to target.
    direction: Direction,
    /// Its colors.
    pub map: ColourMap,
    /// The value of the first color.
    pub low: f64,
    /// The value of the last one.
    pub high: f64,
    /// The distribution of the values over the mapped mesh's area; `None` without triangles.
    pub histogram: Option<Histogram>,
}

impl ColourScale {
    /// The scale of `triangles`, after the one before; `None` when the texture is shown.
    pub fn new(
        colouring: Colouring,
        direction: Direction,
        triangles: &[TriangleDistortion],
        before: Option<&Self>,
    ) -> Option<Self> {
        let (map, low, high) = match colouring {
            Colouring::Texture => return None,
            Colouring::Angle => (ColourMap::Cividis, 1.0, ANGLE_TOP),
            Colouring::Area => {
                let before = before.filter(|scale| scale.colouring == colouring).map(Self::half_range);
                let mean = mean_area_log2(triangles);
                let range = area_range(triangles, mean, before);
                let mean = if direction == Direction::Forward { mean } else { -mean };
                (ColourMap::Diverging, mean - range, mean + range)
            }
        };
        let mut scale = Self { colouring, direction, map, low, high, histogram: None };
        let values = triangles.iter().filter(|t| !t.collapsed).map(|t| (scale.value(t), t.area));
        scale.histogram = Histogram::new(values, low, high, BINS);
        Some(scale)
    }

    fn half_range(&self) -> f64 {
        0.5 * (self.high - self.low)
    }

    /// The quantity that is shown.
    fn value(&self, triangle: &TriangleDistortion) -> f64 {
        match (self.colouring, self.direction) {
            (Colouring::Area, Direction::Forward) => triangle.area_log2,
            (Colouring::Area, Direction::Backward) => -triangle.area_log2,
            _ => triangle.q,
        }
    }

    /// Where a value lies in the colors, 0 and 1 being the ends.
    pub fn place(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// The title above the colors, in English.
    pub fn title(&self) -> Label {
        match self.colouring {
            Colouring::Area => key::area_distortion(),
            _ => key::angle_distortion(),
        }
    }

    /// The values at the ticks, with their words.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        match self.colouring {
            Colouring::Area => [-1.0, -0.5, 0.0, 0.5, 1.0].map(|part| self.area_tick(part)).into(),
            _ => (0..=4)
                .map(|k| 1.0 + 0.25 * f64::from(k) * (self.high - 1.0))
                .map(|v| (v, tick(v, self.high)))
                .collect(),
        }
    }

    /// The value at a part of the range from the mean, in digits that tell ticks apart.
    fn area_tick(&self, part: f64) -> (f64, String) {
        let range = self.half_range();
        let value = 0.5 * (self.low + self.high) + part * range;
        let unit = if range < 4.0 { 100.0 } else { 10.0 };
        (value, signed((unit * value).round() / unit))
    }

    /// The mean, in the digits that it is shown with.
    pub fn mean(&self) -> Option<String> {
        let mean = self.histogram.as_ref()?.mean;
        let shown = match self.colouring {
            Colouring::Area => signed((100.0 * mean).round() / 100.0),
            _ => number(mean, 3),
        };
        Some(shown)
    }
}

/// The codes of `triangles` on a scale, or the marks alone where the texture is shown.
pub fn codes(scale: Option<&ColourScale>, triangles: &[TriangleDistortion], codes: &mut Vec<CellCode>) {
    codes.clear();
    codes.extend(triangles.iter().map(|triangle| match scale {
        _ if triangle.flipped => CellCode::FLIPPED,
        _ if triangle.collapsed => CellCode::COLLAPSED,
        Some(scale) => CellCode::at(scale.place(scale.value(triangle))),
        None => CellCode::at(0.0),
    }));
}

/// Grays the triangles that a repair has added: those without an origin in the surface as it was read.
pub fn grey_added(origins: impl Iterator<Item = Option<TriangleId>>, codes: &mut [CellCode]) {
    for (code, _) in codes.iter_mut().zip(origins).filter(|(_, origin)| origin.is_none()) {
        *code = CellCode::COLLAPSED;
    }
}

/// The mean of log₂ of the area's factor over the mapped mesh's area; 0 without area.
fn mean_area_log2(triangles: &[TriangleDistortion]) -> f64 {
    let there = triangles.iter().filter(|t| !t.collapsed && t.area_log2.is_finite());
    let [sum, total] = there.fold([0.0; 2], |[sum, total], t| [sum + t.area * t.area_log2, total + t.area]);
    if total > 0.0 { sum / total } else { 0.0 }
}

fn area_range(triangles: &[TriangleDistortion], mean: f64, before: Option<f64>) -> f64 {
    // the area beyond range k − 1 but not beyond range k; last, that beyond all
    let mut between = [0.0; AREA_RANGES.len() + 1];
    for triangle in triangles.iter().filter(|t| !t.collapsed) {
        let size = (triangle.area_log2 - mean).abs();
        between[AREA_RANGES.iter().position(|&range| size <= range).unwrap_or(AREA_RANGES.len())] += triangle.area;
    }
    let total: f64 = between.iter().sum();
    let serves = |k: usize, share: f64| between[k + 1..].iter().sum::<f64>() <= share * total;
    let last = AREA_RANGES.len() - 1;
    let smallest = |share| AREA_RANGES[(0..last).find(|&k| serves(k, share)).unwrap_or(last)];
    match before.and_then(|range| AREA_RANGES.iter().position(|&r| (r - range).abs() < 1e-6 * r)) {
        Some(k) if serves(k, AREA_BEYOND) => AREA_RANGES[k].min(smallest(AREA_SPARE)),
        _ => smallest(AREA_BEYOND),
    }
}

fn signed(value: f64) -> String {
    match value {
        0.0 => String::from("0"),
        v if v < 0.0 => format!("−{}", decimal(&(-v).to_string())),
        v => format!("+{}", decimal(&v.to_string())),
    }
}

fn tick(value: f64, top: f64) -> String {
    if value == top {
        format!("≥ {}", number(value, 1))
    } else {
        decimal(format!("{value:.2}").trim_end_matches('0').trim_end_matches('.'))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn triangle(q: f64, area_log2: f64, area: f64) -> TriangleDistortion {
        TriangleDistortion { q, area_log2, area, flipped: false, collapsed: false }
    }

    #[test]
    fn the_area_is_that_of_the_target_over_that_of_the_source_either_way() {
        let triangles = [triangle(1.0, 0.8, 1.0)];
        for (direction, expected) in [(Direction::Forward, 0.8), (Direction::Backward, -0.8)] {
            let scale = ColourScale::new(Colouring::Area, direction, &triangles, None).unwrap();
            assert_eq!(scale.histogram.as_ref().unwrap().mean, expected);
            assert_eq!((scale.low, scale.high), (expected - 0.25, expected + 0.25), "about the mean");
        }
    }

    #[test]
    fn the_area_range_holds_nearly_everything_and_is_kept_while_it_serves() {
        let with_outliers = |share: f64| [triangle(1.0, 3.0, share), triangle(1.0, 0.2, 1.0 - share)];
        let range = |share: f64, before| area_range(&with_outliers(share), 0.2, before);
        assert_eq!(range(0.03, None), 4.0);
        assert_eq!(range(0.01, None), 0.25);
        assert_eq!(range(0.01, Some(4.0)), 4.0, "between the limits the old one stays");
        assert_eq!(range(0.001, Some(4.0)), 0.25);
        assert_eq!(range(0.03, Some(0.25)), 4.0);
    }

    #[test]
    fn another_unit_of_length_changes_no_color_of_the_area() {
        let of = |shift: f64| {
            let triangles = [triangle(1.0, shift + 0.3, 1.0), triangle(1.0, shift - 0.7, 2.0)];
            let scale = ColourScale::new(Colouring::Area, Direction::Forward, &triangles, None).unwrap();
            let mut found = Vec::new();
            codes(Some(&scale), &triangles, &mut found);
            let ticks: Vec<String> = scale.ticks().into_iter().map(|(_, text)| text).collect();
            (found, ticks)
        };
        assert_eq!(of(0.0).0, of(8.0).0);
        assert_eq!(of(8.0).1, ["+6.63", "+7.13", "+7.63", "+8.13", "+8.63"], "about 8 − 0.37, one either way");
    }

    #[test]
    fn flipped_and_collapsed_triangles_have_codes_of_their_own_in_any_mode() {
        let mut triangles = vec![triangle(1.25, 0.0, 1.0); 3];
        triangles[1].flipped = true;
        triangles[2].collapsed = true;
        let mut found = Vec::new();
        let scale = ColourScale::new(Colouring::Angle, Direction::Forward, &triangles, None);
        codes(scale.as_ref(), &triangles, &mut found);
        assert_eq!(found, [CellCode::at(0.5), CellCode::FLIPPED, CellCode::COLLAPSED]);
        codes(None, &triangles, &mut found);
        assert_eq!(found[1..], [CellCode::FLIPPED, CellCode::COLLAPSED]);
    }

    #[test]
    fn what_a_repair_has_added_is_grey() {
        let mut codes = [CellCode::at(0.5), CellCode::FLIPPED, CellCode::at(0.25)];
        grey_added([Some(TriangleId::new(0)), None, Some(TriangleId::new(1))].into_iter(), &mut codes);
        assert_eq!(codes, [CellCode::at(0.5), CellCode::COLLAPSED, CellCode::at(0.25)]);
    }

    #[test]
    fn the_ticks_run_from_end_to_end() {
        let triangles = [triangle(1.1, 0.1, 1.0)];
        for colouring in [Colouring::Angle, Colouring::Area] {
            let scale = ColourScale::new(colouring, Direction::Forward, &triangles, None).unwrap();
            let ticks = scale.ticks();
            assert_eq!((scale.place(ticks[0].0), scale.place(ticks[4].0)), (0.0, 1.0), "{ticks:?}");
        }
    }
}
