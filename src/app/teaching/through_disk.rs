//! The map through the disk beside riemap's own, on the same boundaries (sections 1.2 and 5.2).
//!
//! *Fresh* maps cost O(m²) each: while something moves they are made of few samples,
//! and when it rests, one side per call, of the domain's own samples as far as the cap
//! allows. *Precomputed* ones are made once per domain, for its pole. Never more than one
//! large disk map per call. What fails is said; riemap's map does not care.

use super::super::plots::{Curve, Curves};
use super::Situation;
use crate::conformal::{PreparedDomain, Side};
use crate::geometry::DVec2;
use crate::outline::BoundarySamples;
use crate::session::Comparison;
use crate::zipper::{DiskComparison, DiskMap, DiskMeasure, ZipperError};
use std::sync::Arc;

/// Samples of a fresh map while something moves: 2 to 3 ms for each side, natively.
pub const MOVING_SAMPLES: usize = 300;
/// And at rest, and of a precomputed map: 15 to 20 ms for each side.
pub const RESTING_SAMPLES: usize = 800;

/// How long nothing must have moved before the large maps are made, in seconds.
const REST_SECONDS: f64 = 0.15;

/// How many points are shown on both maps, at equal steps of harmonic measure.
pub const MARKS: u32 = 60;

/// A point of the mapped boundary and where the two ways take it: fractions of arc length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// On the mapped side.
    pub from: f64,
    /// On the other side, by riemap's map.
    pub direct: f64,
    /// On the other side, through the disk.
    pub through_disk: f64,
}

/// One comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// ω̃ of source and target as the disk has it, over the arc length from the anchor.
    pub measures: [Curve; 2],
    /// r̃ through the disk.
    pub reparameterisation: Curve,
    /// [`MARKS`] points at equal steps of riemap's harmonic measure.
    pub marks: Vec<Mark>,
    /// Where each vertex goes through the disk: fractions of the other side's arc length.
    pub images: Vec<f64>,
    /// Boundary samples of source and target.
    pub samples: [usize; 2],
    /// How many of them can't be told from the one before.
    pub collapsed: [usize; 2],
    /// How many came out before the one before.
    pub disordered: [usize; 2],
    /// How many of riemap's own samples have no harmonic measure in f64 between them and the one before.
    pub directly_collapsed: [usize; 2],
    /// The largest distance between the two images of a mark, as a part of the other boundary's length: at most ½.
    pub difference: f64,
}

/// A side's measure, with what it was made from.
#[derive(Debug)]
struct Measured {
    domain: Arc<PreparedDomain>,
    point: DVec2,
    anchor: f64,
    fresh: bool,
    samples: BoundarySamples,
    measure: Result<DiskMeasure, ZipperError>,
}

/// The disk map of a domain's pole.
#[derive(Debug)]
struct Precomputed {
    domain: Arc<PreparedDomain>,
    samples: BoundarySamples,
    map: Result<DiskMap, ZipperError>,
}

/// The comparison's state.
#[derive(Debug, Default)]
pub struct ThroughDisk {
    /// The comparison and the map's generation that were last looked at.
    seen: Option<(Comparison, u64)>,
    changed_at: f64,
    measured: [Option<Measured>; 2],
    precomputed: [Option<Precomputed>; 2],
    found: Option<Result<Found, String>>,
    version: u64,
}

impl ThroughDisk {
    /// What was found; `None` while there is nothing to show.
    pub fn found(&self) -> Option<&Found> {
        self.found.as_ref()?.as_ref().ok()
    }

    /// Why nothing was found.
    pub fn error(&self) -> Option<&str> {
        self.found.as_ref()?.as_ref().err().map(String::as_str)
    }

    /// Counts up with every change of what is shown.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// Brings the comparison up to date; in how many seconds to come back, if at all.
    pub fn advance(&mut self, situation: &Situation, comparison: Comparison, now: f64) -> Option<f64> {
        let wanted = (comparison, situation.generation);
        let changed = self.seen != Some(wanted);
        if changed {
            self.changed_at = now;
        }
        let before = self.seen.replace(wanted);
        match comparison {
            Comparison::Off => {
                self.clear();
                None
            }
            Comparison::Fresh => {
                if changed {
                    for side in Side::BOTH {
                        self.measure_fresh(situation, side, MOVING_SAMPLES);
                    }
                    self.compare(situation);
                }
                self.refine(situation, now)
            }
            Comparison::Precomputed => self.move_precomputed(situation, changed, before),
        }
    }

    fn clear(&mut self) {
        self.version += u64::from(self.found.is_some());
        self.found = None;
        self.measured = [None, None];
    }

    /// After a rest, one side of as many samples as are allowed.
    fn refine(&mut self, situation: &Situation, now: f64) -> Option<f64> {
        let coarse = |side: &Side| !self.is_measured(situation, *side, RESTING_SAMPLES);
        let side = Side::BOTH.into_iter().find(coarse)?;
        let rest = self.changed_at + REST_SECONDS - now;
        if rest > 0.0 {
            return Some(rest);
        }
        self.measure_fresh(situation, side, RESTING_SAMPLES);
        self.compare(situation);
        Some(0.0)
    }

    /// Whether there is a fresh measure of the present points of at least `most` samples, or of all there are.
    fn is_measured(&self, situation: &Situation, side: Side, most: usize) -> bool {
        let domain = situation.map.domain(side);
        self.measured[side as usize].as_ref().is_some_and(|old| {
            old.fresh
                && Arc::ptr_eq(&old.domain, domain)
                && (old.point, old.anchor) == (situation.points[side as usize], situation.anchors[side as usize])
                && old.samples.len() >= most.min(domain.samples.len())
        })
    }

    fn measure_fresh(&mut self, situation: &Situation, side: Side, most: usize) {
        if self.is_measured(situation, side, most) {
            return;
        }
        let domain = situation.map.domain(side);
        let (point, anchor) = (situation.points[side as usize], situation.anchors[side as usize]);
        let samples = thinned(&domain.samples, most);
        let measure = DiskMeasure::fresh(&samples.points, point, samples.at_fraction(anchor));
        let domain = Arc::clone(domain);
        self.measured[side as usize] = Some(Measured { domain, point, anchor, fresh: true, samples, measure });
    }

    /// With both disk maps there, Möbius; else makes one of them.
    fn move_precomputed(
        &mut self,
        situation: &Situation,
        changed: bool,
        before: Option<(Comparison, u64)>,
    ) -> Option<f64> {
        let missing = |side: &Side| {
            let old = self.precomputed[*side as usize].as_ref();
            old.is_none_or(|old| !Arc::ptr_eq(&old.domain, situation.map.domain(*side)))
        };
        if let Some(side) = Side::BOTH.into_iter().find(missing) {
            let domain = situation.map.domain(side);
            let samples = thinned(&domain.samples, RESTING_SAMPLES);
            let map = DiskMap::new(&samples.points, domain.pole);
            self.precomputed[side as usize] = Some(Precomputed { domain: Arc::clone(domain), samples, map });
            self.seen = before; // not compared yet
            return Some(0.0);
        }
        if changed {
            for side in Side::BOTH {
                self.measure_precomputed(situation, side);
            }
            self.compare(situation);
        }
        None
    }

    fn measure_precomputed(&mut self, situation: &Situation, side: Side) {
        let Some(old) = &self.precomputed[side as usize] else { return };
        let (point, anchor) = (situation.points[side as usize], situation.anchors[side as usize]);
        let start = old.samples.at_fraction(anchor);
        let measure = match &old.map {
            Ok(map) => DiskMeasure::precomputed(map, point, start),
            Err(error) => Err(*error),
        };
        let (domain, samples) = (Arc::clone(&old.domain), old.samples.clone());
        self.measured[side as usize] = Some(Measured { domain, point, anchor, fresh: false, samples, measure });
    }

    fn compare(&mut self, situation: &Situation) {
        let [Some(source), Some(target)] = &self.measured else { return };
        self.found = Some(compare(situation, [source, target]));
        self.version += 1;
    }
}

/// At most `most` of the samples, evenly chosen: denser where they were.
fn thinned(samples: &BoundarySamples, most: usize) -> BoundarySamples {
    let m = samples.len();
    if m <= most {
        return samples.clone();
    }
    let kept: Vec<usize> = (0..most).map(|k| k * m / most).collect();
    let points: Vec<DVec2> = kept.iter().map(|&k| samples.points[k]).collect();
    let edge_lengths = (0..most).map(|k| points[k].distance(points[(k + 1) % most])).collect();
    BoundarySamples { points, edge_lengths, fractions: kept.iter().map(|&k| samples.fractions[k]).collect() }
}

fn compare(situation: &Situation, sides: [&Measured; 2]) -> Result<Found, String> {
    let measure = |side: Side| {
        let failed = |error: &ZipperError| format!("The way through the disk fails on the {side}: {error}.");
        sides[side as usize].measure.as_ref().map_err(failed)
    };
    let [source, target] = Side::BOTH.map(measure);
    let measures = [source?, target?];
    let (mapped, other) = (situation.mapped(), situation.mapped().other());
    let matched = DiskComparison::new(measures[mapped as usize].clone(), measures[other as usize].clone());
    let cut = Side::BOTH.map(|side| (&sides[side as usize].samples, situation.anchors[side as usize]));
    let reparameterisation = Curve::reparameterisation(cut[mapped as usize], cut[other as usize], &matched.points);
    let marks = marks(situation, &reparameterisation);
    let difference = marks.iter().map(|mark| around(mark.direct, mark.through_disk)).fold(0.0, f64::max);
    Ok(Found {
        measures: Side::BOTH.map(|side| Curve::measure(cut[side as usize], measures[side as usize].from_anchor())),
        reparameterisation,
        marks,
        images: matched.points.iter().map(|&point| sides[other as usize].samples.fraction_at(point)).collect(),
        samples: sides.map(|side| side.samples.len()),
        collapsed: measures.map(DiskMeasure::collapsed),
        disordered: measures.map(DiskMeasure::disordered),
        directly_collapsed: Side::BOTH.map(|side| directly_collapsed(situation, side)),
        difference,
    })
}

fn directly_collapsed(situation: &Situation, side: Side) -> usize {
    let measure = situation.map.measure(side);
    // where the anchor is a vertex, the last two knots are the same point
    let doubled = usize::from(measure.anchor().fraction == 0.0);
    measure.at_knots().windows(2).filter(|pair| pair[0] == pair[1]).count() - doubled
}

fn marks(situation: &Situation, through_disk: &Curve) -> Vec<Mark> {
    let (mapped, other) = (situation.mapped(), situation.mapped().other());
    let curves = Curves::new(situation.map, situation.anchors);
    let mark = |k: u32| {
        let omega = (f64::from(k) + 0.5) / f64::from(MARKS);
        let [from, direct] = [mapped, other].map(|side| curves.measure[side as usize].inverse_at(omega));
        Mark {
            from: curves.fraction(mapped, from),
            direct: curves.fraction(other, direct),
            through_disk: curves.fraction(other, through_disk.at(from)),
        }
    };
    (0..MARKS).map(mark).collect()
}

/// The distance along the boundary, the shorter way.
fn around(a: f64, b: f64) -> f64 {
    let d = (a - b).abs();
    d.min(1.0 - d)
}
