//! Plots: a frame with ticks and labels, curves, a legend; linear or logarithmic axes.
//!
//! Why not `plotters`: its axes, series and legend would replace this file, but not `svg`, since the figures
//! put embedded pictures and domains of equal scales beside their plots. It measures text with the system's fonts
//! (which needs fontconfig and freetype to build) or with a bundled font, and its output would depend on the choice.
//! The app's plots are `egui_plot`'s.

use super::svg::{Anchor, LABEL, Page, SMALL, Stroke, colour};
use crate::geometry::{Bounds, DVec2};

/// An axis.
#[derive(Clone)]
pub struct Axis {
    pub label: String,
    low: f64,
    high: f64,
    logarithmic: bool,
    ticks: Vec<(f64, String)>,
}

/// The approximate number of ticks on an axis.
const TICKS: f64 = 5.0;

impl Axis {
    /// An axis from `low` to `high`, with ticks at multiples of 1, 2 or 5 times a power of ten.
    pub fn linear(label: &str, low: f64, high: f64) -> Self {
        let rough = (high - low) / TICKS;
        let power = 10_f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|f| f * power).into_iter().find(|s| *s >= rough).unwrap_or(rough);
        let digits = (-step.log10().floor()).max(0.0) as usize;
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        let ticks = (first..=last).map(|k| (k as f64 * step, format!("{:.digits$}", k as f64 * step))).collect();
        Self { label: label.to_owned(), low, high, logarithmic: false, ticks }
    }

    /// An axis from 0 to 2π with ticks at multiples of π/2.
    pub fn turn(label: &str) -> Self {
        let names = ["0", "π/2", "π", "3π/2", "2π"];
        let ticks = names.iter().zip(0..).map(|(n, k)| (std::f64::consts::FRAC_PI_2 * f64::from(k), (*n).to_owned()));
        let high = std::f64::consts::TAU;
        Self { label: label.to_owned(), low: 0.0, high, logarithmic: false, ticks: ticks.collect() }
    }

    /// A logarithmic axis around positive `values`, with ticks at every power of ten, or at every second to fourth.
    pub fn logarithmic(label: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = values
            .into_iter()
            .filter(|v| *v > 0.0 && v.is_finite())
            .fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), v| (low.min(v), high.max(v)));
        let (low, high) = if low <= high { (low, high) } else { (0.1, 1.0) };
        let (first, last) = ((low.log10() + 1e-9).floor() as i32, (high.log10() - 1e-9).ceil() as i32);
        let stride = usize::try_from((last - first) / 6).unwrap_or(0) + 1;
        let ticks = (first..=last).step_by(stride).map(|k| (10_f64.powi(k), power_of_ten(k))).collect();
        let (low, high) = (10_f64.powi(first), 10_f64.powi(last.max(first + 1)));
        Self { label: label.to_owned(), low, high, logarithmic: true, ticks }
    }

    /// A logarithmic axis with ticks at `values`, from the smallest to the largest of them.
    pub fn logarithmic_at(label: &str, values: &[u32]) -> Self {
        let (low, high) = (values.iter().min().copied().unwrap_or(1), values.iter().max().copied().unwrap_or(10));
        let ticks = values.iter().map(|&v| (f64::from(v), v.to_string())).collect();
        let (low, high) = (f64::from(low) / 1.15, f64::from(high) * 1.15);
        Self { label: label.to_owned(), low, high, logarithmic: true, ticks }
    }

    /// The position of a value along the axis, from 0 to 1.
    fn place(&self, value: f64) -> f64 {
        if self.logarithmic {
            (value / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }
}

fn power_of_ten(k: i32) -> String {
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => c.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(c),
    };
    match k {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10{}", k.to_string().chars().map(superscript).collect::<String>()),
    }
}

/// A curve.
pub struct Curve {
    /// The name in the legend; a curve with an empty name is not listed.
    pub name: String,
    pub points: Vec<DVec2>,
    pub stroke: Stroke,
    /// Whether the points are marked by dots.
    pub dots: bool,
}

/// The corner where the legend is drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Legend {
    None,
    TopLeft,
    TopRight,
    BottomLeft,
    BottomRight,
}

/// A plot; `corner` and `size` are those of its frame, without ticks and labels.
pub struct Plot {
    pub corner: DVec2,
    pub size: DVec2,
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    pub curves: Vec<Curve>,
    pub legend: Legend,
}

impl Plot {
    /// Draws the plot.
    pub fn draw(&self, page: &mut Page) {
        self.draw_axes(page);
        page.clipped(self.corner - DVec2::splat(3.0), self.size + DVec2::splat(6.0), |page| {
            for curve in &self.curves {
                self.draw_curve(page, curve);
            }
        });
        if self.legend != Legend::None {
            self.draw_legend(page);
        }
    }

    /// The point of the page that represents `p`.
    fn place(&self, p: DVec2) -> DVec2 {
        self.corner + self.size * DVec2::new(self.x.place(p.x), 1.0 - self.y.place(p.y))
    }

    fn draw_axes(&self, page: &mut Page) {
        let (low, high) = (self.corner, self.corner + self.size);
        for (value, name) in &self.x.ticks {
            let x = low.x + self.size.x * self.x.place(*value);
            page.line([DVec2::new(x, low.y), DVec2::new(x, high.y)], Stroke::solid(colour::FAINT, 1.0));
            page.text(DVec2::new(x, high.y + 16.0), Anchor::Middle, SMALL, colour::INK, name);
        }
        for (value, name) in &self.y.ticks {
            let y = high.y - self.size.y * self.y.place(*value);
            page.line([DVec2::new(low.x, y), DVec2::new(high.x, y)], Stroke::solid(colour::FAINT, 1.0));
            page.text(DVec2::new(low.x - 7.0, y + 4.0), Anchor::End, SMALL, colour::INK, name);
        }
        let frame = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y), low];
        page.line(frame, Stroke::solid(colour::GREY, 1.0));
        let middle = 0.5 * (low + high);
        page.text(DVec2::new(middle.x, high.y + 34.0), Anchor::Middle, LABEL, colour::INK, &self.x.label);
        let longest = self.y.ticks.iter().map(|(_, name)| name.chars().count()).max().unwrap_or(0);
        let left = low.x - 20.0 - 6.2 * longest as f64;
        page.vertical_text(DVec2::new(left, middle.y), LABEL, colour::INK, &self.y.label);
        page.text(DVec2::new(low.x, low.y - 9.0), Anchor::Start, LABEL, colour::INK, &self.title);
    }

    fn draw_curve(&self, page: &mut Page, curve: &Curve) {
        page.line(curve.points.iter().map(|&p| self.place(p)), curve.stroke);
        for &p in curve.points.iter().filter(|_| curve.dots) {
            page.dot(self.place(p), 3.5, curve.stroke.colour);
        }
    }

    fn draw_legend(&self, page: &mut Page) {
        const LINE: f64 = 18.0;
        let named: Vec<&Curve> = self.curves.iter().filter(|curve| !curve.name.is_empty()).collect();
        let longest = named.iter().map(|curve| curve.name.chars().count()).max().unwrap_or(0);
        let size = DVec2::new(46.0 + 6.3 * longest as f64, LINE * named.len() as f64 + 8.0);
        let inset = DVec2::splat(8.0);
        let corner = match self.legend {
            Legend::None | Legend::TopLeft => self.corner + inset,
            Legend::TopRight => self.corner + DVec2::new(self.size.x - size.x - inset.x, inset.y),
            Legend::BottomRight => self.corner + self.size - size - inset,
            Legend::BottomLeft => self.corner + DVec2::new(inset.x, self.size.y - size.y - inset.y),
        };
        page.fill(corner, size, "rgba(255,255,255,0.88)");
        for (k, curve) in named.iter().enumerate() {
            let y = corner.y + 4.0 + LINE * (k as f64 + 0.5);
            page.line([DVec2::new(corner.x + 6.0, y), DVec2::new(corner.x + 32.0, y)], curve.stroke);
            if curve.dots {
                page.dot(DVec2::new(corner.x + 19.0, y), 3.5, curve.stroke.colour);
            }
            page.text(DVec2::new(corner.x + 40.0, y + 4.0), Anchor::Start, SMALL, colour::INK, &curve.name);
        }
    }
}

/// A rectangle of the page that shows a part of the plane at equal scales, y up.
#[derive(Clone, Copy)]
pub struct Window {
    middle: DVec2,
    page_middle: DVec2,
    scale: f64,
}

impl Window {
    /// A window that fits the bounding box of `points` into the rectangle.
    pub fn fitting(points: &[DVec2], corner: DVec2, size: DVec2) -> Self {
        let [low, high] = Bounds::of(points.iter().copied()).corners();
        let extent = (high - low).max(DVec2::splat(f64::MIN_POSITIVE));
        Self { middle: 0.5 * (low + high), page_middle: corner + 0.5 * size, scale: (size / extent).min_element() }
    }

    /// The point of the page that represents `p`.
    pub fn place(&self, p: DVec2) -> DVec2 {
        self.page_middle + self.scale * (p - self.middle) * DVec2::new(1.0, -1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, name)| name.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(names(&Axis::linear("", 0.0, 1.0)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(names(&Axis::linear("", -0.3, 7.9)), ["0", "2", "4", "6"]);
        assert_eq!(names(&Axis::logarithmic("", [2e-5, 3e-3])), ["10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²"]);
        assert_eq!(names(&Axis::logarithmic_at("", &[250, 500])), ["250", "500"]);
    }

    #[test]
    fn logarithmic_axis_places_the_geometric_mean_in_the_middle() {
        let axis = Axis::logarithmic("", [1e-6, 1e-2]);
        assert!((axis.place(1e-4) - 0.5).abs() < 1e-12, "{}", axis.place(1e-4));
    }
}
