//! The result of a comparison: measures, reparameterizations and images of both methods, and their difference.

use crate::conformal::{PerSide, Side};
use crate::language::{Message, key};
use crate::model::curves::{Curve, Curves};
use crate::model::overlays::Situation;
use crate::outline::BoundarySamples;
use crate::zipper::{DiskComparison, DiskMeasure, ZipperError};

/// The number of points shown on both maps, at equal steps of harmonic measure.
pub const MARKS: u32 = 60;

/// A point of the mapped boundary and its images under the two methods, as fractions of arc length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// On the mapped side.
    pub from: f64,
    /// Its image by riemap's map.
    pub direct: f64,
    /// Its image through the disk.
    pub through_disk: f64,
}

/// The result of one comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// ω̃ of source and target by the disk maps, over the arc length from the anchor.
    pub measures: PerSide<Curve>,
    /// r̃ through the disk.
    pub reparameterisation: Curve,
    /// [`MARKS`] points at equal steps of riemap's harmonic measure.
    pub marks: Vec<Mark>,
    /// The image of each vertex through the disk, as fractions of the other side's arc length.
    pub images: Vec<f64>,
    /// Boundary samples of source and target.
    pub samples: PerSide<usize>,
    /// How many of them coincide with the previous one in f64.
    pub collapsed: PerSide<usize>,
    /// How many of them lie before the previous one.
    pub disordered: PerSide<usize>,
    /// How many of riemap's own samples have the same harmonic measure in f64 as the previous one.
    pub directly_collapsed: PerSide<usize>,
    /// The largest distance between the two images of a mark, as a part of the other boundary's length; at most ½.
    pub difference: f64,
}

/// A side's measure by the disk map, or the error.
#[derive(Debug)]
pub(super) struct Measured {
    pub samples: BoundarySamples,
    pub measure: Result<DiskMeasure, ZipperError>,
}

/// Compares the map with the one through the disk, given the disk's measures of source and target.
pub(super) fn compare(situation: &Situation, sides: PerSide<&Measured>) -> Result<Found, Message> {
    let measure = |side: Side| {
        let failed = |error: &ZipperError| key::through_disk_fails(side, Message::from(error));
        sides[side].measure.as_ref().map_err(failed)
    };
    let measures = PerSide::new(measure(Side::Source)?, measure(Side::Target)?);
    let (mapped, other) = (situation.mapped(), situation.mapped().other());
    let matched = DiskComparison::new(measures[mapped].clone(), measures[other].clone());
    let cut = PerSide::from_fn(|side| (&sides[side].samples, situation.anchors[side]));
    let reparameterisation = Curve::reparameterisation(cut[mapped], cut[other], matched.points());
    let marks = marks(situation, &reparameterisation);
    let difference = marks.iter().map(|mark| around(mark.direct, mark.through_disk)).fold(0.0, f64::max);
    Ok(Found {
        measures: PerSide::from_fn(|side| Curve::measure(cut[side], measures[side].from_anchor())),
        reparameterisation,
        marks,
        images: matched.points().iter().map(|&point| sides[other].samples.fraction_at(point)).collect(),
        samples: sides.map(|side| side.samples.len()),
        collapsed: measures.map(DiskMeasure::collapsed),
        disordered: measures.map(DiskMeasure::disordered),
        directly_collapsed: PerSide::from_fn(|side| directly_collapsed(situation, side)),
        difference,
    })
}

fn directly_collapsed(situation: &Situation, side: Side) -> usize {
    let measure = situation.map.measure(side);
    // if the anchor is a vertex, the last two knots are the same point
    let doubled = usize::from(measure.anchor().fraction() == 0.0);
    measure.at_knots().windows(2).filter(|pair| pair[0] == pair[1]).count() - doubled
}

fn marks(situation: &Situation, through_disk: &Curve) -> Vec<Mark> {
    let (mapped, other) = (situation.mapped(), situation.mapped().other());
    let curves = Curves::new(situation.map, situation.anchors);
    let mark = |k: u32| {
        let omega = (f64::from(k) + 0.5) / f64::from(MARKS);
        let [from, direct] = [mapped, other].map(|side| curves.measure[side].inverse_at(omega));
        Mark {
            from: curves.fraction(mapped, from),
            direct: curves.fraction(other, direct),
            through_disk: curves.fraction(other, through_disk.at(from)),
        }
    };
    (0..MARKS).map(mark).collect()
}

/// The distance along the boundary in the shorter direction.
fn around(a: f64, b: f64) -> f64 {
    let d = (a - b).abs();
    d.min(1.0 - d)
}
