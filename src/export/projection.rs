//! Map projections as files: a drawing and a table of points.

use super::drawing::{LINE_COLORS, OUTLINE_COLOR, Placement, opening};
use super::polylines::{Line, Polylines};
use crate::geometry::{Bounds, DVec2};
use crate::projection::Projection;
use std::fmt::Write as _;

/// The file format of a projection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProjectionFormat {
    /// A table: rows `lon,lat,x,y` under a line with these names: first the boundary in order, then the lattice of
    /// [`Projection::lattice`].
    Csv,
    /// Vector graphics: outline, graticule, lines of equal scale with their values.
    Svg,
}

/// About so many lines of equal scale are drawn.
const LEVELS: f64 = 6.0;

/// The fill of the region, the color of the graticule, the size of labels in units of the drawing.
const LAND: &str = "#f6f3ea";
const GRATICULE: &str = "#8fa3b3";
const LABEL: f64 = 11.0;

/// Lines of equal scale shorter than this many labels have none.
const LABELED: f64 = 6.0;

impl ProjectionFormat {
    /// All formats.
    pub const ALL: [Self; 2] = [Self::Svg, Self::Csv];

    /// The file extension.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Svg => "svg",
        }
    }

    /// The format with this file extension, in upper or lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| extension.eq_ignore_ascii_case(format.extension()))
    }

    /// The file of a projection.
    pub fn text(self, projection: &Projection) -> String {
        match self {
            Self::Csv => csv(projection),
            Self::Svg => svg(projection),
        }
    }
}

fn csv(projection: &Projection) -> String {
    let mut text = "lon,lat,x,y\n".to_owned();
    let boundary = projection.region().lon_lat().iter().copied().zip(projection.boundary().iter().copied());
    let inside = projection.lattice().into_iter().map(|point| (point.lon_lat, point.image));
    for (place, image) in boundary.chain(inside) {
        let _ = writeln!(text, "{},{},{},{}", place.x, place.y, image.x, image.y);
    }
    text
}

fn svg(projection: &Projection) -> String {
    let [low, high] = Bounds::of(projection.boundary().iter().copied()).corners();
    let placement = Placement::in_panel(0, (low, high));
    let mut text = opening(1);
    let outline = placement.distinct(projection.boundary());
    path(&mut text, &format!("class=\"region\" fill=\"{LAND}\""), placement, &outline, true);
    let graticule = projection.graticule();
    let _ = writeln!(text, "<g class=\"graticule\" stroke=\"{GRATICULE}\" stroke-width=\"0.7\">");
    for (class, lines) in [("meridian", &graticule.meridians), ("parallel", &graticule.parallels)] {
        for line in lines {
            path(&mut text, &format!("class=\"{class}\""), placement, &placement.distinct(line), false);
        }
    }
    text.push_str("</g>\n");
    let labels = contours(&mut text, projection, placement);
    let style = format!("class=\"outline\" stroke=\"{OUTLINE_COLOR}\" stroke-width=\"1.5\"");
    path(&mut text, &style, placement, &outline, true);
    write_labels(&mut text, &labels);
    text.push_str("</svg>\n");
    text
}

fn path(text: &mut String, attributes: &str, placement: Placement, points: &[DVec2], is_closed: bool) {
    let _ = write!(text, "<path {attributes} d=\"");
    placement.path(text, points.iter().copied(), is_closed);
    text.push_str("\"/>\n");
}

/// A value and where it stands in the drawing.
type Label = (String, DVec2);

/// The lines on which the scale has a value.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ScaleLines {
    /// The value, as it is written.
    pub label: String,
    /// The lines.
    pub lines: Vec<Line>,
}

/// The lines of equal scale of a projection, at about six round values, from the largest on.
pub fn scale_lines(projection: &Projection) -> Vec<ScaleLines> {
    let scales = projection.scales();
    let (levels, decimals) = levels(projection.scale_ratio());
    let of_level = |level: f64| ScaleLines {
        label: format!("{level:.decimals$}"),
        lines: level_lines(projection, &scales, level),
    };
    levels.into_iter().map(of_level).collect()
}

/// Draws the lines of equal scale; returns their labels.
fn contours(text: &mut String, projection: &Projection, placement: Placement) -> Vec<Label> {
    let mut labels: Vec<Label> = Vec::new();
    let _ = writeln!(text, "<g class=\"scale\" stroke=\"{}\" stroke-width=\"1\">", LINE_COLORS[0]);
    for ScaleLines { label, lines } in scale_lines(projection) {
        for line in &lines {
            let points = placement.distinct(&line.points);
            path(text, &format!("data-scale=\"{label}\""), placement, &points, line.is_closed);
        }
        let drawn = lines.iter().map(|line| line.points.iter().map(|&p| placement.of(p)).collect::<Vec<_>>());
        let longest = drawn.max_by(|a, b| length(a).total_cmp(&length(b)));
        let Some(points) = longest.filter(|points| length(points) > LABELED * LABEL) else { continue };
        let top = points.iter().copied().min_by(|a, b| a.y.total_cmp(&b.y)).unwrap_or_default();
        if labels.iter().all(|(_, at)| (*at - top).abs().cmpgt(DVec2::new(3.0, 1.1) * LABEL).any()) {
            labels.push((label, top));
        }
    }
    text.push_str("</g>\n");
    labels
}

fn length(points: &[DVec2]) -> f64 {
    points.windows(2).map(|ends| ends[0].distance(ends[1])).sum()
}

fn write_labels(text: &mut String, labels: &[Label]) {
    let _ = writeln!(
        text,
        "<g class=\"label\" font-family=\"sans-serif\" font-size=\"{LABEL}\" text-anchor=\"middle\" fill=\"{}\" \
         stroke=\"{LAND}\" stroke-width=\"4\" paint-order=\"stroke\">",
        LINE_COLORS[0]
    );
    for (label, at) in labels {
        let _ = writeln!(text, "<text x=\"{:.2}\" y=\"{:.2}\">{label}</text>", at.x, at.y + 0.35 * LABEL);
    }
    text.push_str("</g>\n");
}

/// Round values of the scale between its least value and 1, and the decimals that they need.
fn levels(ratio: f64) -> (Vec<f64>, usize) {
    let range = 1.0 - ratio.recip();
    let wanted = range / LEVELS;
    if wanted <= 1e-12 {
        return (Vec::new(), 0);
    }
    let power = wanted.log10().floor();
    let unit = 10f64.powf(power);
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * unit >= wanted);
    let step = factor.map_or(10.0 * unit, |factor| factor * unit);
    let decimals = if factor.is_some() { -power } else { -power - 1.0 }.max(0.0) as usize;
    let count = (range / step).ceil() as u32;
    ((1..count.max(1)).map(|k| 1.0 - f64::from(k) * step).collect(), decimals)
}

/// The lines on which the scale, linear on the mesh's triangles, has a value.
fn level_lines(projection: &Projection, scales: &[f64], level: f64) -> Vec<Line> {
    let mut segments = Polylines::default();
    let images = projection.images();
    for triangle in projection.mesh().triangles() {
        let mut ends = Vec::with_capacity(2);
        for k in 0..3 {
            let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
            let (a, b) = (a.min(b), a.max(b));
            let (from, to) = (scales[a as usize], scales[b as usize]);
            if (from < level) != (to < level) {
                let place = images[a as usize].lerp(images[b as usize], (level - from) / (to - from));
                ends.push(((0, [u64::from(a), u64::from(b), 0, 0]), place));
            }
        }
        if let Ok(ends) = <[_; 2]>::try_from(ends) {
            segments.add(ends);
        }
    }
    segments.lines()
}

#[cfg(test)]
mod tests {
    use super::levels;

    #[test]
    fn levels_are_round_values_between_the_least_scale_and_one() {
        let (of_cap, decimals) = levels(1.0718);
        let shown: Vec<String> = of_cap.iter().map(|level| format!("{level:.decimals$}")).collect();
        assert_eq!(shown, ["0.98", "0.96", "0.94"]);
        assert_eq!(levels(1.0).0, [0.0; 0]);
        let (large, decimals) = levels(20.0);
        assert_eq!((large.len(), decimals), (4, 1));
    }
}
