//! The picture set in motion: its points go along a loop through the family of maps until they are paused.
//!
//! Nothing plays by itself. A pause leaves the points where they are, and playing on from there goes on along
//! the same loop. All of it is one change of the session: it comes to rest when it is paused.
//!
//! A way begins at a complete map. Where another motion is chosen while the map is behind the points, they stand
//! still until it is there; where outlines or the surface become others meanwhile, the motion ends.

pub mod looping;

use crate::conformal::{PreparedSide, Side};
use crate::family::{Loop, Path, Place};
use crate::model::Model;
use crate::session::Command;
use std::sync::Arc;

/// How long a turn takes, in seconds.
pub const PERIODS: std::ops::RangeInclusive<f64> = 2.0..=60.0;
/// Slow enough for the eye to follow a line, fast enough not to wait for the end.
const PERIOD: f64 = 12.0;
/// A pause between frames is taken for at most this long, in seconds.
const LONGEST_FRAME: f64 = 0.1;

/// What a person does to the motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlayAction {
    /// Play, or pause.
    Toggle,
    /// Move other points.
    Along(Path),
    /// Seconds for a turn.
    Period(f64),
}

/// The motion.
#[derive(Debug)]
pub struct Player {
    path: Path,
    period: f64,
    is_playing: bool,
    /// The way that was gone last, as long as the points are where it left them.
    run: Option<Run>,
    /// What the map that is waited for is made from.
    awaited: Option<Scene>,
}

/// A way, and where on it.
#[derive(Debug)]
struct Run {
    way: Loop,
    t: f64,
    /// The time of the last frame; `None` at the beginning and after a pause.
    at: Option<f64>,
    scene: Scene,
}

/// The prepared sides that a way leads through.
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
    /// Which points move.
    pub fn path(&self) -> Path {
        self.path
    }

    /// Seconds for a turn.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Whether they do, or will as soon as the map is there.
    pub fn is_playing(&self) -> bool {
        self.is_playing
    }

    /// Whether they do now.
    pub fn is_moving(&self) -> bool {
        self.is_playing && self.awaited.is_none()
    }

    /// Lets the points stay where they are.
    pub fn pause(&mut self) {
        (self.is_playing, self.awaited) = (false, None);
        if let Some(run) = &mut self.run {
            run.at = None;
        }
    }

    /// Does what is asked for. Where nothing can move, nothing plays.
    pub fn act(&mut self, action: PlayAction, model: &Model) {
        match action {
            PlayAction::Toggle if self.is_playing => self.pause(),
            PlayAction::Toggle => self.play(model),
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
        self.is_playing = self.run.is_some();
    }

    /// Plays on as soon as the awaited map is there; no more where it will be that of another scene.
    fn go_on_when_ready(&mut self, model: &Model) {
        let Some(scene) = &self.awaited else { return };
        if !scene.is_of(model) {
            self.pause();
        } else if model.is_ready() {
            self.awaited = None;
            self.play(model);
        }
    }

    /// The moves of a frame at the time `now`, in seconds. Where the scene is another one by now, it ends.
    pub fn advance(&mut self, model: &Model, now: f64) -> Vec<Command> {
        self.go_on_when_ready(model);
        if self.run.as_ref().is_some_and(|run| !run.scene.is_of(model)) {
            // nor is what was prepared for a scene that is gone kept for a way that is paused
            (self.is_playing, self.run) = (false, None);
        }
        let Some(run) = self.run.as_mut().filter(|_| self.is_playing) else { return Vec::new() };
        let step = run.at.map_or(0.0, |at| (now - at).clamp(0.0, LONGEST_FRAME));
        run.at = Some(now);
        run.t = (run.t + step / self.period).rem_euclid(1.0);
        if step == 0.0 { Vec::new() } else { looping::commands(run.way.at(run.t)).collect() }
    }
}

impl Run {
    fn new(way: Loop, model: &Model) -> Self {
        Self { way, t: 0.0, at: None, scene: Scene::of(model) }
    }

    /// Whether the model's points are where the way has left them.
    fn is_at(&self, model: &Model) -> bool {
        let Place { interior, anchor } = self.way.at(self.t);
        let session = model.session();
        let is_there = |side: Side| {
            let place = interior[side as usize];
            place.is_none() || place == session.side(side).interior
        };
        Side::BOTH.into_iter().all(is_there)
            && anchor.is_none_or(|fraction| fraction.rem_euclid(1.0) == session.side(Side::Source).anchor)
    }
}

impl Scene {
    fn of(model: &Model) -> Self {
        Self { sides: Side::BOTH.map(|side| model.prepared(side).cloned()) }
    }

    /// Whether the same still stands on the model's sides.
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
