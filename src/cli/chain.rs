//! `riemap map A B C …`: a composition of maps, with the quality of each link.
//!
//! The targets' points are images of each other, so that each x and y of a link is that of the link before. The
//! composition is conformal and maps the first x and y to the last ones; there is one such map, and it is computed at
//! once, since errors of links would add up. What that differs by from going link by link is measured.

use super::CliError;
use super::accuracy::Accuracy;
use super::map::{Computed, Finished, Making, say_map_notes, titles};
use super::map_arguments::MapArguments;
use super::output::mean_in_words;
use super::progress::Progress;
use super::side::{self, Asked, NamedSide, Place};
use super::tables::Summary;
use crate::conformal::{ConformalMap, Constraints, CurveMap, InteriorImage, InteriorMap, InteriorPoint, Quality, Side};
use crate::geometry::{DVec2, DVec3};
use crate::outline::BoundaryPoint;
use std::fmt::Write as _;

/// The links of a composition, and how far it is from going link by link.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Chain {
    links: Vec<Link>,
    /// The largest distances between images computed link by link and at once, in units of the last side.
    link_by_link: Difference,
}

/// A map of the chain.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
struct Link {
    source: String,
    target: String,
    source_point: Place,
    target_point: Place,
    source_anchor: f64,
    target_anchor: f64,
    #[serde(flatten)]
    quality: Quality,
    unresolved_area: Option<f64>,
    #[serde(flatten)]
    accuracy: Accuracy,
}

#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
struct Difference {
    /// At the boundary samples of the first side.
    boundary: f64,
    /// At vertices inside; none with a surface.
    interior: Option<f64>,
}

/// Computes the composition and its links.
pub fn compute(arguments: &MapArguments, progress: &Progress) -> Result<Computed, CliError> {
    if !arguments.instead.is_empty() {
        let text = "--pin and --optimise are for one source and one target; give the points of a chain with \
                    --target-point and --target-anchor, once for each target";
        return Err(CliError::Usage(text.to_owned()));
    }
    let making = Making::new(arguments, progress)?;
    let titles = titles(&arguments.sides.names());
    let asked = making.asked(&titles)?;
    let readings = arguments.reading.each(&arguments.sides.names())?;
    let given = asked.iter().zip(&readings).map(|(side, how)| side::read(side.name, how));
    let given = given.collect::<Result<Vec<_>, _>>()?;
    let prepare = |(asked, given)| making.prepared(asked, given);
    let sides = asked.iter().zip(given).map(prepare).collect::<Result<Vec<_>, _>>()?;
    let points = sides.iter().zip(&asked).map(|(side, asked)| side.constraint(asked)).collect::<Result<Vec<_>, _>>()?;
    progress.enter("the links");
    let map = |k: usize, l: usize| {
        let constraints = Constraints::new(points[k], points[l]);
        let map = making.map([&sides[k], &sides[l]], &constraints, &[asked[k], asked[l]])?;
        Ok::<_, CliError>((map, constraints))
    };
    let last = sides.len() - 1;
    let links = (0..last).map(|k| Ok(map(k, k + 1)?.0)).collect::<Result<Vec<_>, CliError>>()?;
    let (whole, constraints) = map(0, last)?;
    let link_by_link = Difference::of(&links, &whole);
    let mut linked = Vec::new();
    for (k, link) in links.into_iter().enumerate() {
        let pair = [&sides[k], &sides[k + 1]];
        let Finished { map, summary, .. } = making.finished(link, pair, None)?;
        say_map_notes(&map, &[asked[k], asked[k + 1]]);
        linked.push(Link::new([&asked[k], &asked[k + 1]], pair, [points[k], points[k + 1]], summary)?);
    }
    progress.enter("the composition");
    let Finished { map, summary, table } = making.finished(whole, [&sides[0], &sides[last]], making.points.as_ref())?;
    making.say_notes(&sides.iter().collect::<Vec<_>>());
    let mut sides = sides;
    let mapped = if map.mapped_side() == Side::Source { 0 } else { last };
    let surface = sides.swap_remove(mapped).into_surface();
    let chain = Some(Chain { links: linked, link_by_link });
    Ok(Computed { map, constraints, pins: None, summary: Summary { chain, ..summary }, table, surface })
}

impl Link {
    fn new(
        asked: [&Asked<'_>; 2],
        sides: [&NamedSide; 2],
        points: [(InteriorPoint, f64); 2],
        Summary { quality, unresolved_area, accuracy, .. }: Summary,
    ) -> Result<Self, CliError> {
        let [source, target] = asked.map(|asked| asked.name.to_owned());
        let [(source_point, source_anchor), (target_point, target_anchor)] = points;
        Ok(Self {
            source,
            target,
            source_point: sides[0].place(source_point)?,
            target_point: sides[1].place(target_point)?,
            source_anchor,
            target_anchor,
            quality,
            unresolved_area,
            accuracy,
        })
    }
}

impl Chain {
    /// The links as lines after line breaks.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for Link { source, target, quality, accuracy, .. } in &self.links {
            let mean = mean_in_words(quality);
            let error = accuracy.image_error().map(|error| format!(", error {error:.1e}")).unwrap_or_default();
            let _ = write!(text, "\n{source} → {target}: {mean}, {} flipped{error}", quality.flipped);
        }
        let Difference { boundary, interior } = self.link_by_link;
        let interior = interior.map(|interior| format!(", {interior:.1e} inside")).unwrap_or_default();
        text + &format!("\nlink by link, images differ by {boundary:.1e} on the boundary{interior}")
    }
}

/// The number of vertices inside at which the composition is evaluated.
const INSIDE: usize = 64;

impl Difference {
    /// Between the links one after another and the map at once.
    fn of(links: &[ConformalMap], whole: &ConformalMap) -> Self {
        let curved = on_curves(links, whole);
        Self { boundary: curved.unwrap_or_else(|| by_fractions(links, whole)), interior: inside(links, whole) }
    }
}

/// The fractions of the length of the first boundary at its vertices.
fn fractions(whole: &ConformalMap) -> impl Iterator<Item = f64> {
    let side = whole.side(Side::Source);
    (0..side.boundary_count()).map(|k| side.fraction_at(BoundaryPoint::new(k as u32, 0.0)))
}

/// The largest difference on the boundary, by exact points of the curves; `None` with finite elements.
fn on_curves(links: &[ConformalMap], whole: &ConformalMap) -> Option<f64> {
    let at_once = whole.curve_map(Side::Source)?;
    let links: Vec<CurveMap<'_>> = links.iter().map(|link| link.curve_map(Side::Source)).collect::<Option<_>>()?;
    let boundary = whole.side(Side::Source).curve_boundary()?;
    let onto = at_once.onto_curve();
    let off = |fraction: f64| {
        let point = boundary.at_fraction(fraction);
        let linked = links.iter().fold(point, |point, link| link.image(point));
        onto.position(linked).distance(onto.position(at_once.image(point)))
    };
    Some(fractions(whole).map(off).fold(0.0, f64::max))
}

/// The largest difference on the boundary, by fractions of lengths.
fn by_fractions(links: &[ConformalMap], whole: &ConformalMap) -> f64 {
    let side = whole.side(Side::Target);
    let place = |fraction: f64| -> DVec3 { side.boundary_place(side.at_fraction(fraction)) };
    let off = |fraction: f64| {
        let linked = links.iter().fold(fraction, |at, link| link.boundary_image(Side::Source, at));
        place(linked).distance(place(whole.boundary_image(Side::Source, fraction)))
    };
    fractions(whole).map(off).fold(0.0, f64::max)
}

/// The largest difference inside; `None` with a surface, or if no point has an image.
fn inside(links: &[ConformalMap], whole: &ConformalMap) -> Option<f64> {
    let (vertices, boundary) = {
        let domain = whole.domain(Side::Source)?;
        (domain.mesh().vertices(), domain.samples().len())
    };
    let at_once = whole.interior_map(Side::Source).ok()?;
    let links: Vec<InteriorMap<'_>> =
        links.iter().map(|link| link.interior_map(Side::Source).ok()).collect::<Option<_>>()?;
    let inner = &vertices[boundary..];
    let off = |&point: &DVec2| {
        let linked = links.iter().try_fold(point, |point, link| image(link, point))?;
        Some(linked.distance(image(&at_once, point)?))
    };
    inner.iter().step_by(inner.len() / INSIDE + 1).filter_map(off).reduce(f64::max)
}

fn image(map: &InteriorMap<'_>, point: DVec2) -> Option<DVec2> {
    match map.image(point) {
        InteriorImage::Inside(found) => Some(found.value),
        InteriorImage::Boundary { value, .. } => Some(value),
        InteriorImage::Outside => None,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{Direction, PrepareSettings, PreparedSide, prepare};
    use crate::outline::Preset;
    use std::sync::Arc;

    #[test]
    fn a_link_with_another_boundary_point_is_noticed() {
        let side = |preset: Preset| -> Arc<PreparedSide> {
            Arc::new(prepare(preset.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap())
        };
        let [disk, square] = [Preset::Disk, Preset::Square].map(side);
        let map = |from: &Arc<PreparedSide>, onto: &Arc<PreparedSide>, anchor: f64| {
            let constraints = Constraints::new((DVec2::ZERO, 0.0), (DVec2::ZERO, anchor));
            ConformalMap::new(from.clone(), onto.clone(), &constraints, Direction::Forward.into()).unwrap()
        };
        let whole = map(&disk, &disk, 0.0);
        let off = |anchor| Difference::of(&[map(&disk, &square, 0.0), map(&square, &disk, anchor)], &whole);
        let (right, wrong) = (off(0.0), off(0.01));
        assert!(right.boundary < 0.01 && right.interior.unwrap() < 0.01, "{right:?}");
        // turned by 3.6°: 0.063 on the circle
        assert!(wrong.boundary > 0.05 && wrong.interior.unwrap() > 0.02, "{wrong:?}");
    }
}
