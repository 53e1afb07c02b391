//! Animation: the points of a session move along a loop through the family of maps until they are paused.
//!
//! Nothing starts by itself, except in the guided tour. After a pause the points stay where they are, and playing again continues on
//! the same loop. The whole motion is one change of the session, which settles when it is paused.
//!
//! A loop starts at a complete map. If another path is chosen while the map lags behind the points, they wait
//! until it has caught up; if an outline or a surface is replaced meanwhile, the motion ends.

pub mod looping;

use crate::conformal::{PreparedSide, Side};
use crate::family::{Loop, Path, Place};
use crate::model::Model;
use crate::session::Command;
use std::sync::Arc;

/// The allowed durations of a turn, in seconds.
pub const PERIODS: std::ops::RangeInclusive<f64> = 2.0..=60.0;
/// The default duration of a turn: slow enough to follow a line by eye, fast enough not to wait for the end.
const PERIOD: f64 = 12.0;
/// Longer pauses between frames count as this many seconds.
const LONGEST_FRAME: f64 = 0.1;

/// A user's change of the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlayAction {
    /// Play, or pause.
    Toggle,
    /// Play once around, then pause where the loop began.
    Once,
    /// Choose which points move.
    Along(Path),
    /// Set the seconds per turn.
    Period(f64),
}

/// The state of the motion.
#[derive(Debug)]
pub struct Player {
    path: Path,
    period: f64,
    is_playing: bool,
    /// The last loop, kept while the points are where it left them.
    run: Option<Run>,
    /// The prepared sides of the map that the motion is waiting for.
    awaited: Option<Scene>,
}

/// A loop and the position on it.
#[derive(Debug)]
struct Run {
    way: Loop,
    t: f64,
    /// Whether the motion ends after one turn, and whether it has.
    once: bool,
    has_come_around: bool,
    /// The time of the last frame; `None` at the beginning and after a pause.
    at: Option<f64>,
    scene: Scene,
}

/// The prepared sides that a loop belongs to.
#[derive(Debug, Clone)]
struct Scene {
    sides: [Option<Arc<PreparedSide>>; 2],
}

impl Default for Player {
    fn default() -> Self {
        Self { path: Path::default(), period: PERIOD, is_playing: false, run: None, awaited: None }
    }
}

impl Player {
    /// The points that move.
    pub fn path(&self) -> Path {
        self.path
    }

    /// Seconds per turn.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Whether the points move, or will move once the map is complete.
    pub fn is_playing(&self) -> bool {
        self.is_playing
    }

    /// Whether the points are moving now.
    pub fn is_moving(&self) -> bool {
        self.is_playing && self.awaited.is_none()
    }

    /// Whether a motion of one turn has ended by itself.
    pub fn has_come_around(&self) -> bool {
        self.run.as_ref().is_some_and(|run| run.has_come_around)
    }

    /// Stops the points where they are.
    pub fn pause(&mut self) {
        (self.is_playing, self.awaited) = (false, None);
        if let Some(run) = &mut self.run {
            run.at = None;
        }
    }

    /// Applies an action. If no point can move, playing does not start.
    pub fn act(&mut self, action: PlayAction, model: &Model) {
        match action {
            PlayAction::Toggle if self.is_playing => self.pause(),
            PlayAction::Toggle => self.play(model),
            PlayAction::Once => {
                self.run = None;
                self.play(model);
                self.run.iter_mut().for_each(|run| run.once = true);
            }
            PlayAction::Along(path) => {
                (self.path, self.run) = (path, None);
                self.awaited = self.is_playing.then(|| Scene::of(model));
                self.go_on_when_ready(model);
            }
            PlayAction::Period(seconds) => self.period = seconds.clamp(*PERIODS.start(), *PERIODS.end()),
        }
    }

    fn play(&mut self, model: &Model) {
        self.run = self.run.take().filter(|run| run.scene.is_of(model) && run.is_at(model));
        if self.run.is_none() {
            self.run = looping::begin(model, self.path).map(|way| Run::new(way, model));
        }
        self.run.iter_mut().for_each(|run| (run.once, run.has_come_around) = (false, false));
        self.is_playing = self.run.is_some();
    }

    /// Continues once the awaited map is complete; pauses if a side has been replaced.
    fn go_on_when_ready(&mut self, model: &Model) {
        let Some(scene) = &self.awaited else { return };
        if !scene.is_of(model) {
            self.pause();
        } else if model.is_mapped() {
            self.awaited = None;
            self.play(model);
        }
    }

    /// The commands of the frame at the time `now`, in seconds. The motion ends if a side has been replaced.
    pub fn advance(&mut self, model: &Model, now: f64) -> Vec<Command> {
        self.go_on_when_ready(model);
        if self.run.as_ref().is_some_and(|run| !run.scene.is_of(model)) {
            // also drop a paused loop, so that it does not keep the old sides alive
            (self.is_playing, self.run) = (false, None);
        }
        let Some(run) = self.run.as_mut().filter(|_| self.is_playing) else { return Vec::new() };
        let step = run.at.map_or(0.0, |at| (now - at).clamp(0.0, LONGEST_FRAME));
        run.at = Some(now);
        let t = run.t + step / self.period;
        run.has_come_around = run.once && t >= 1.0;
        run.t = if run.has_come_around { 0.0 } else { t.rem_euclid(1.0) };
        self.is_playing = !run.has_come_around;
        if step == 0.0 { Vec::new() } else { looping::commands(run.way.at(run.t)).collect() }
    }
}

impl Run {
    fn new(way: Loop, model: &Model) -> Self {
        Self { way, t: 0.0, once: false, has_come_around: false, at: None, scene: Scene::of(model) }
    }

    /// Whether the model's points are where the loop has left them.
    fn is_at(&self, model: &Model) -> bool {
        let Place { interior, anchor } = self.way.at(self.t);
        let session = model.session();
        let is_there = |side: Side| {
            let place = interior[side];
            place.is_none() || place == session.side(side).interior
        };
        Side::BOTH.into_iter().all(is_there)
            && anchor.is_none_or(|fraction| fraction.rem_euclid(1.0) == session.side(Side::Source).points().anchor())
    }
}

impl Scene {
    fn of(model: &Model) -> Self {
        Self { sides: Side::BOTH.map(|side| model.prepared(side).cloned()) }
    }

    /// Whether the model still has the same prepared sides.
    fn is_of(&self, model: &Model) -> bool {
        let now = Self::of(model);
        self.sides.iter().zip(&now.sides).all(|(ours, there)| is_same(ours.as_ref(), there.as_ref()))
    }
}

fn is_same<T>(one: Option<&Arc<T>>, other: Option<&Arc<T>>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => Arc::ptr_eq(one, other),
        _ => one.is_none() && other.is_none(),
    }
}
