//! Random walks from x₁, counted where they hit the boundary: harmonic measure after Kakutani (1944).
//!
//! A walk takes 1/speed seconds: it is computed when it starts and drawn step by step until it is counted.
//! Fast walks are computed in batches, for at most a part of a frame; the rest is skipped, so that the
//! page stays responsive and the speed is an upper bound. The seed is fixed: the same start gives the
//! same walks.

use crate::conformal::{HitCounts, MeshedDomain, Side, WalkCircle, WalkStep, Walker};
use crate::geometry::DVec2;
use crate::language::{Message, key};
use crate::model::curves::Curve;
use crate::model::overlays::Situation;
use crate::outline::{BoundaryPoint, BoundarySamples};
use std::collections::VecDeque;
use std::sync::Arc;
use web_time::Instant;

/// The allowed numbers of walks per second.
pub const SPEEDS: std::ops::RangeInclusive<f64> = 1.0..=10_000.0;
/// The largest speed at which single walks are drawn.
const SEEN_SPEED: f64 = 30.0;

/// The number of parts of equal length into which the boundary is divided for counting hits.
pub const BINS: usize = 120;

/// The time for walks in a frame, in milliseconds.
const FRAME_MS: f64 = 8.0;
/// The number of walks between two checks of the clock: 0.3 ms at 5 to 10 µs per walk.
const BATCH: u32 = 32;
/// Longer pauses between frames count as this many seconds.
const LONGEST_FRAME: f64 = 0.1;

/// The number of latest hits marked on the boundary.
const MARKED_HITS: usize = 250;

const SEED: u64 = 1944;

/// A user's change of the walks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WalkAction {
    /// Start or pause.
    Toggle,
    /// Set the number of walks per second.
    Speed(f64),
    /// Discard all hits.
    Clear,
}

/// A walk that is being drawn.
#[derive(Debug)]
struct Walk {
    circles: Vec<WalkCircle>,
    hit: BoundaryPoint,
    place: DVec2,
}

/// The walks from one point of one domain.
#[derive(Debug)]
struct Start {
    domain: Arc<MeshedDomain>,
    point: DVec2,
    anchor: f64,
    walker: Walker,
    counts: HitCounts,
    walk: Option<Walk>,
}

impl Start {
    /// The share of hits between the anchor and the start of each bin, and the end of the last one.
    fn shares(&self) -> impl Iterator<Item = f64> + '_ {
        let total = self.counts.total() as f64;
        // sums of integers are exact
        running_sum(self.counts.counts().iter().map(|&count| count as f64)).map(move |sum| sum / total)
    }
}

/// The state of the walks.
#[derive(Debug)]
pub struct Walks {
    running: bool,
    per_second: f64,
    start: Option<Start>,
    recent: VecDeque<DVec2>,
    /// The number of walks that are due; its fractional part is the progress of the current walk.
    due: f64,
    last_time: Option<f64>,
    error: Option<Message>,
    version: u64,
}

impl Default for Walks {
    fn default() -> Self {
        Self {
            running: false,
            per_second: 5.0,
            start: None,
            recent: VecDeque::new(),
            due: 0.0,
            last_time: None,
            error: None,
            version: 0,
        }
    }
}

/// The counts of one bin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// The middle of the bin as a fraction of arc length.
    pub at: f64,
    /// The share of hits, relative to the largest harmonic measure of a bin.
    pub hits: f64,
    /// The harmonic measure, relative to the largest one of a bin.
    pub expected: f64,
}

impl Walks {
    /// Applies an action.
    pub fn act(&mut self, action: WalkAction) {
        match action {
            WalkAction::Toggle => self.running = !self.running,
            WalkAction::Speed(speed) => self.per_second = speed.clamp(*SPEEDS.start(), *SPEEDS.end()),
            WalkAction::Clear => self.clear(),
        }
    }

    fn clear(&mut self) {
        self.start = None;
        self.recent.clear();
        self.due = 0.0;
        self.error = None;
        self.version += 1;
    }

    /// Advances the walks; returns the seconds until the next call is needed, if any.
    pub fn advance(&mut self, situation: &Situation, now: f64) -> Option<f64> {
        let (point, anchor) = (situation.points.source, situation.anchors.source);
        let domain = situation.domains.source;
        let is_here = |old: &Start| Arc::ptr_eq(&old.domain, domain) && (old.point, old.anchor) == (point, anchor);
        if self.start.as_ref().is_some_and(|old| !is_here(old)) {
            self.clear();
        }
        if !self.running {
            self.last_time = None;
            return None;
        }
        if self.start.is_none() && !self.begin(situation) {
            return None;
        }
        let since = self.last_time.replace(now).map_or(0.0, |last| (now - last).clamp(0.0, LONGEST_FRAME));
        self.due += since * self.per_second;
        self.walk();
        Some(0.0)
    }

    fn begin(&mut self, situation: &Situation) -> bool {
        let domain = Arc::clone(situation.domains.source);
        let (point, anchor) = (situation.points.source, situation.anchors.source);
        match Walker::new(domain.samples().points(), point, SEED) {
            Ok(walker) => {
                let counts = HitCounts::by_arc_length(domain.samples(), situation.map.measure(Side::Source), BINS);
                self.start = Some(Start { domain, point, anchor, walker, counts, walk: None });
                true
            }
            Err(error) => {
                self.error = Some(key::sentence(Message::from(&error)));
                self.running = false;
                false
            }
        }
    }

    /// Ends the walks that are due and starts the next one.
    fn walk(&mut self) {
        let Some(start) = &mut self.start else { return };
        let clock = Instant::now();
        let mut ended = 0_u32;
        while self.due >= 1.0 {
            let hit = start.walk.take().map_or_else(|| start.walker.walk(), |walk| walk.hit);
            start.counts.record(hit);
            if self.recent.len() == MARKED_HITS {
                self.recent.pop_front();
            }
            self.recent.push_back(start.domain.samples().position(hit));
            self.due -= 1.0;
            ended += 1;
            if ended.is_multiple_of(BATCH) && clock.elapsed().as_secs_f64() * 1e3 > FRAME_MS {
                self.due = self.due.fract();
            }
        }
        self.version += u64::from(ended > 0);
        let samples = start.domain.samples();
        start.walk.get_or_insert_with(|| unfolded(&mut start.walker, samples));
    }

    /// Whether walks are running.
    pub fn is_running(&self) -> bool {
        self.running
    }

    /// Walks per second.
    pub fn speed(&self) -> f64 {
        self.per_second
    }

    /// The reason why there are no walks.
    pub fn error(&self) -> Option<&Message> {
        self.error.as_ref()
    }

    /// Increases with every hit.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// The number of completed walks.
    pub fn count(&self) -> u64 {
        self.start.as_ref().map_or(0, |start| start.counts.total())
    }

    /// The circles of the current walk so far, and its hit once reached; empty if walks are too fast to be drawn.
    pub fn path(&self) -> (&[WalkCircle], Option<DVec2>) {
        let seen = self.start.as_ref().and_then(|start| start.walk.as_ref());
        let Some(walk) = seen.filter(|_| self.per_second <= SEEN_SPEED) else { return (&[], None) };
        // during the last quarter of its time the whole walk is shown
        let shown = (self.due / 0.75 * walk.circles.len() as f64) as usize + 1;
        (&walk.circles[..shown.min(walk.circles.len())], (shown > walk.circles.len()).then_some(walk.place))
    }

    /// The latest hits, oldest first.
    pub fn recent(&self) -> impl ExactSizeIterator<Item = DVec2> + '_ {
        self.recent.iter().copied()
    }

    /// The bins with their counts; empty before the first hit.
    pub fn bars(&self) -> Vec<Bar> {
        let Some(start) = self.start.as_ref().filter(|start| start.counts.total() > 0) else { return Vec::new() };
        let (counts, expected) = (start.counts.counts(), start.counts.expected());
        let largest = expected.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let total = start.counts.total() as f64;
        let bar = |k: usize| Bar {
            at: (start.anchor + (k as f64 + 0.5) / BINS as f64).rem_euclid(1.0),
            hits: counts[k] as f64 / total / largest,
            expected: expected[k] / largest,
        };
        (0..BINS).map(bar).collect()
    }

    /// The share of hits from y₁ to each bin's end, over the arc length.
    pub fn cumulative(&self) -> Option<Curve> {
        let start = self.start.as_ref().filter(|start| start.counts.total() > 0)?;
        let shares = start.shares().enumerate();
        let points = shares.map(|(k, share)| [k as f64 / BINS as f64, share]).collect();
        Some(Curve { name: String::from("random walks"), points })
    }

    /// The largest difference between the shares of hits and the harmonic measure at the ends of the bins.
    pub fn deviation(&self) -> Option<f64> {
        let start = self.start.as_ref().filter(|start| start.counts.total() > 0)?;
        let expected = running_sum(start.counts.expected().iter().copied());
        Some(start.shares().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max))
    }
}

/// 0 and the partial sums of the values.
fn running_sum(values: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
    let sums = values.scan(0.0, |sum, value| {
        *sum += value;
        Some(*sum)
    });
    std::iter::once(0.0).chain(sums)
}

/// Computes a whole walk from its start.
fn unfolded(walker: &mut Walker, samples: &BoundarySamples) -> Walk {
    let mut circles = vec![walker.circle()];
    loop {
        match walker.step() {
            WalkStep::Jump(circle) => circles.push(circle),
            WalkStep::Hit(hit) => return Walk { circles, hit, place: samples.position(hit) },
        }
    }
}
