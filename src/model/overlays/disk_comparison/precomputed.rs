//! Disk maps of the domains' poles, computed once per domain; moving a point then needs only a Möbius map.

use crate::conformal::{MeshedDomain, PerSide, Side};
use crate::model::overlays::Situation;
use crate::model::overlays::disk_comparison::found::{Measured, compare};
use crate::model::overlays::disk_comparison::{RESTING_SAMPLES, Shown, is_refused};
use crate::outline::BoundarySamples;
use crate::zipper::{DiskMap, DiskMeasure, ZipperError};
use std::sync::Arc;

/// The disk map of a domain's pole.
#[derive(Debug)]
struct Known {
    domain: Arc<MeshedDomain>,
    samples: BoundarySamples,
    map: Result<DiskMap, ZipperError>,
}

/// The state of this method.
#[derive(Debug, Default)]
pub(super) struct Precomputed {
    /// The generation of the last map that was compared.
    seen: Option<u64>,
    known: PerSide<Option<Known>>,
    pub(super) shown: Shown,
}

impl Precomputed {
    /// Removes the result; the disk maps are kept.
    pub(super) fn clear(&mut self) {
        self.shown.clear();
        self.seen = None;
    }

    /// Compares if both disk maps exist; otherwise computes one of them and asks to be called again.
    pub(super) fn advance(&mut self, situation: &Situation) -> Option<f64> {
        let missing = Side::BOTH.into_iter().find_map(|side| Some((side, self.lacks(situation, side)?)));
        if let Some((side, most)) = missing {
            let domain = Arc::clone(situation.domains[side]);
            let samples = domain.samples().thinned(most);
            let map = DiskMap::new(samples.points(), domain.default_point());
            self.known[side] = Some(Known { domain, samples, map });
            return Some(0.0);
        }
        if self.seen.replace(situation.generation) != Some(situation.generation)
            && let Some(measured) = PerSide::from_fn(|side| self.measured(situation, side)).both()
        {
            self.shown.set(compare(situation, measured.as_ref()));
        }
        None
    }

    /// The number of samples for a side's disk map if there is none or it excludes the pole; `None` if it is usable.
    fn lacks(&self, situation: &Situation, side: Side) -> Option<usize> {
        let domain = situation.domains[side];
        match self.known[side].as_ref().filter(|known| Arc::ptr_eq(&known.domain, domain)) {
            None => Some(RESTING_SAMPLES),
            Some(known) if is_refused(&known.map) && known.samples.len() < domain.samples().len() => {
                Some(2 * known.samples.len())
            }
            Some(_) => None,
        }
    }

    fn measured(&self, situation: &Situation, side: Side) -> Option<Measured> {
        let known = self.known[side].as_ref()?;
        let start = known.samples.at_fraction(situation.anchors[side]);
        let by = |map| DiskMeasure::precomputed(map, situation.points[side], start);
        let measure = known.map.as_ref().map_err(|error| *error).and_then(by);
        Some(Measured { samples: known.samples.clone(), measure })
    }
}
