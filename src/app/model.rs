//! The state behind the picture: session, the two preparations, the map.
//!
//! No egui and no wgpu in here. Commands come in through [`Model::dispatch`],
//! worker answers through [`Model::accept`]; [`Model::refresh`] then brings the
//! map up to date and says what has to be uploaded. While a side is prepared,
//! the last good map stays and follows its handles.

use super::draft::Draft;
use super::prepare_state::{Preparation, Progress};
use super::teaching::walks::WalkAction;
use super::teaching::{Situation, Teaching};
use super::textured;
use super::trouble::Remedy;
use crate::conformal::{
    ConformalMap, Constraints, Direction, MapError, PreparedDomain, Quality, Side, TriangleDistortion,
    triangle_distortions,
};
use crate::geometry::DVec2;
use crate::laplace::SolverKind;
use crate::outline::{Outline, OutlineNote};
use crate::session::{Command, OutlineSpec, Session};
use crate::worker::{Request, Response};
use std::sync::Arc;
use web_time::Instant;

/// Both sides, in the order of the arrays.
pub const SIDES: [Side; 2] = [Side::Source, Side::Target];

/// The distance that a handle keeps from the boundary, in sizes of the domain:
/// 0.004 is two pixels in a domain of 500, closer than a dot can be told from
/// the edge, and still several boundary edges away from it.
const INSET: f64 = 0.004;

/// An update that takes longer, in ms, does not follow a drag: a coarse map stands in. With
/// the drawing it stays below the 50 ms from which on a hand feels that something lags.
const SLOW_UPDATE_MS: f64 = 30.0;

/// The quality is computed with every update when it takes less than this, else when the drag rests.
const CHEAP_QUALITY_MS: f64 = 1.0;

/// What a frame spends on an extension that is not complete: half of a frame at 60 Hz. The app
/// asks for another frame whenever images changed, and so goes on until it is.
const REFINE_MS: f64 = 8.0;

/// What a refresh changed, for the upload.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Changes {
    /// A domain, the direction or the pattern's home is another one: meshes and outlines.
    pub meshes: bool,
    /// The map is another one: the boundary moved.
    pub map: bool,
    /// Images of vertices moved: with the map, or because they were refined.
    pub images: bool,
}

impl std::ops::BitOrAssign for Changes {
    fn bitor_assign(&mut self, other: Self) {
        self.meshes |= other.meshes;
        self.map |= other.map;
        self.images |= other.images;
    }
}

/// When an extension that is not complete is gone on with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refines {
    /// In every [`Model::refresh`].
    InRefresh,
    /// When [`Model::refine_at_rest`] is called.
    AtRest,
}

/// Session, preparations and map.
#[derive(Debug)]
pub struct Model {
    session: Session,
    sides: [Preparation; 2],
    map: Option<ConformalMap>,
    draft: Draft,
    /// How many updates in a row were too slow for a drag.
    slow_updates: u32,
    pub(super) slow_update_ms: f64,
    quality: Option<Quality>,
    triangles: Vec<TriangleDistortion>,
    measured: u64,
    quality_ms: f64,
    quality_stale: bool,
    points_changed: bool,
    domains_changed: bool,
    last_good_points: ([Option<DVec2>; 2], [f64; 2]),
    generation: u64,
    mesh_generation: u64,
    map_error: Option<(Side, String)>,
    refit: [bool; 2],
    /// The points of a session whose domains are being prepared.
    incoming_points: [Option<(Option<DVec2>, f64)>; 2],
    refines: Refines,
    /// Where the pattern lived at the last refresh.
    pattern_home: Option<Side>,
    teaching: Teaching,
}

impl Model {
    /// Wants both of the session's domains.
    pub fn new(session: Session) -> Self {
        let sides = [Preparation::new(session.source.clone()), Preparation::new(session.target.clone())];
        Self {
            last_good_points: (session.interior, session.anchor),
            pattern_home: textured::home(&session),
            session,
            sides,
            map: None,
            draft: Draft::default(),
            slow_updates: 0,
            slow_update_ms: SLOW_UPDATE_MS,
            quality: None,
            triangles: Vec::new(),
            measured: 0,
            quality_ms: 0.0,
            quality_stale: false,
            points_changed: false,
            domains_changed: false,
            generation: 0,
            mesh_generation: 0,
            map_error: None,
            refit: [true; 2],
            incoming_points: [None; 2],
            refines: Refines::InRefresh,
            teaching: Teaching::default(),
        }
    }

    /// What the map on the screen is made from.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// One side's preparation.
    pub fn side(&self, side: Side) -> &Preparation {
        &self.sides[side as usize]
    }

    /// One side's preparation.
    pub fn side_mut(&mut self, side: Side) -> &mut Preparation {
        &mut self.sides[side as usize]
    }

    /// One side's domain, the last good one.
    pub fn domain(&self, side: Side) -> Option<&Arc<PreparedDomain>> {
        self.side(side).domain()
    }

    /// The map that is shown, as soon as both domains are there: the full one, or a coarse
    /// one while a drag is under way that the full one is too slow for.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.draft.map().or(self.map.as_ref())
    }

    /// The domain of a side that is shown.
    pub fn shown_domain(&self, side: Side) -> Option<&Arc<PreparedDomain>> {
        self.draft.map().map_or_else(|| self.domain(side), |map| Some(map.domain(side)))
    }

    /// Angle distortion of the map; of the last one that was measured while a drag is under way.
    pub fn quality(&self) -> Option<Quality> {
        self.quality
    }

    /// The distortion of every triangle of the mapped mesh, when [`Self::quality`] was measured.
    pub fn triangles(&self) -> &[TriangleDistortion] {
        &self.triangles
    }

    /// The [`Self::generation`] of the map whose [`Self::triangles`] these are.
    pub fn measured_generation(&self) -> u64 {
        self.measured
    }

    /// How many times the map has changed.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// How many times another mesh was mapped.
    pub fn mesh_generation(&self) -> u64 {
        self.mesh_generation
    }

    /// What the map said about a constraint that it could not take.
    pub fn map_error(&self) -> Option<(Side, &str)> {
        self.map_error.as_ref().map(|(side, message)| (*side, message.as_str()))
    }

    /// Whether a side has a new outline since the last call: its viewport fits it.
    pub fn take_refit(&mut self, side: Side) -> bool {
        std::mem::take(&mut self.refit[side as usize])
    }

    /// A first map is shown and nothing is being prepared.
    pub fn is_ready(&self) -> bool {
        self.map.is_some() && !self.sides.iter().any(Preparation::is_busy)
    }

    /// Lower left and upper right corner of a side's domain.
    pub fn extent(&self, side: Side) -> Option<(DVec2, DVec2)> {
        self.domain(side).map(|domain| bounds(&domain.samples.points))
    }

    /// The interior point of a side, where its handle is.
    pub fn interior(&self, side: Side) -> Option<DVec2> {
        let domain = self.domain(side)?;
        Some(self.session.interior[side as usize].unwrap_or(domain.pole))
    }

    /// The boundary point of a side, where its handle is.
    pub fn anchor(&self, side: Side) -> Option<DVec2> {
        let samples = &self.domain(side)?.samples;
        Some(samples.position(samples.at_fraction(self.session.anchor[side as usize])))
    }

    /// Where the interior handle goes when the pointer is at `x`: there, or along the boundary.
    pub fn interior_near(&self, side: Side, x: DVec2) -> Option<DVec2> {
        let domain = self.domain(side)?;
        let (low, high) = self.extent(side)?;
        Some(domain.nearest_inside(x, INSET * (high - low).max_element()))
    }

    /// The boundary point nearest to `x`, as a fraction of arc length.
    pub fn anchor_near(&self, side: Side, x: DVec2) -> Option<f64> {
        let samples = &self.domain(side)?.samples;
        Some(samples.fraction_at(samples.nearest(x)))
    }

    /// Carries out a command, or begins to: what needs a preparation takes effect when it is done.
    pub fn dispatch(&mut self, command: Command, now: f64) {
        match command {
            Command::SetOutline { side, outline } => self.want_outline(side, outline, Vec::new()),
            Command::SetSettings { side, settings } => self.side_mut(side).want_settings(settings, now),
            Command::Swap => self.swap(),
            Command::Open(session) => self.open(&session),
            Command::MoveInterior { .. }
            | Command::MoveAnchor { .. }
            | Command::SetDirection(_)
            | Command::SetExtension(_) => {
                self.session.apply(command);
                self.points_changed = true;
            }
            Command::SetTexture(_)
            | Command::SetTextureSide(_)
            | Command::SetTextureScale(_)
            | Command::SetColouring(_)
            | Command::SetWireframe(_)
            | Command::SetPlots(_)
            | Command::SetComparison(_) => self.session.apply(command),
        }
    }

    /// Shows another session: at once but for its domains, which come with their points when they are prepared.
    fn open(&mut self, session: &Session) {
        let shown = self.session.clone();
        for side in SIDES {
            let k = side as usize;
            self.incoming_points[k] = None;
            let points = (session.interior[k], session.anchor[k]);
            if self.side_mut(side).want_spec(session.domain(side)) {
                self.incoming_points[k] = Some(points);
            } else {
                (self.session.interior[k], self.session.anchor[k]) = points;
            }
        }
        let Session { interior, anchor, .. } = self.session;
        self.session = Session { source: shown.source, target: shown.target, interior, anchor, ..session.clone() };
        self.map_error = None;
        self.points_changed = true;
    }

    fn want_outline(&mut self, side: Side, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        self.incoming_points[side as usize] = None;
        self.side_mut(side).error = None;
        self.side_mut(side).want_outline(outline, notes);
    }

    /// Begins to prepare an outline that was read from a file.
    pub fn want_loaded(&mut self, side: Side, outline: Outline) {
        let Outline { name, polygon, notes } = outline;
        let points = polygon.vertices().to_vec();
        self.want_outline(side, OutlineSpec::Points { name, points }, notes);
    }

    /// Does what a side's message offers.
    pub fn remedy(&mut self, side: Side) {
        match self.side_mut(side).error.take().and_then(|trouble| trouble.remedy) {
            Some(Remedy::Retry) => self.side_mut(side).retry(),
            Some(Remedy::Repaired(outline)) => self.want_loaded(side, *outline),
            None => {}
        }
    }

    /// Closes a side's messages.
    pub fn dismiss(&mut self, side: Side) {
        self.side_mut(side).error = None;
        self.map_error = self.map_error.take().filter(|(at, _)| *at != side);
    }

    /// The requests that are due.
    pub fn take_requests(&mut self, now: f64) -> Vec<(Side, Request)> {
        SIDES.into_iter().filter_map(|side| Some((side, self.side_mut(side).take_request(now)?))).collect()
    }

    /// When the next request will be due.
    pub fn next_due(&self) -> Option<f64> {
        self.sides.iter().filter_map(Preparation::due).reduce(f64::min)
    }

    /// Takes in an answer of a worker.
    pub fn accept(&mut self, side: Side, generation: u64, response: Response) {
        let progress = self.side_mut(side).accept(generation, response);
        if matches!(progress, Progress::Failed) {
            self.incoming_points[side as usize] = None;
        }
        if let Progress::Ready { spec, new_outline } = progress {
            if new_outline && spec.outline != self.session.domain(side).outline {
                self.session.apply(Command::SetOutline { side, outline: spec.outline });
            }
            self.session.apply(Command::SetSettings { side, settings: spec.settings });
            if let Some((interior, anchor)) = self.incoming_points[side as usize].take() {
                (self.session.interior[side as usize], self.session.anchor[side as usize]) = (interior, anchor);
            }
            self.refit[side as usize] |= new_outline;
            self.domains_changed = true;
        }
    }

    /// Brings the map up to date with session and domains; `dragging`: a dot is held.
    pub fn refresh(&mut self, dragging: bool) -> Changes {
        let mut changes = Changes::default();
        if std::mem::take(&mut self.domains_changed) {
            changes.meshes = true;
            self.draft.forget();
            self.keep_points_inside();
            changes.map |= self.rebuild();
            self.points_changed = false;
        }
        if std::mem::take(&mut self.points_changed) {
            let full = self.draft.map().is_none();
            if dragging && self.is_slow() && self.follow_coarsely() {
                (changes.meshes, changes.map) = (full, true);
            } else {
                changes |= self.update();
            }
        }
        if !dragging && self.draft.map().is_some() {
            changes |= self.update();
        }
        let refined = self.refines == Refines::InRefresh && self.refine();
        changes.images = changes.map || refined;
        if changes.images {
            self.mesh_generation += u64::from(changes.meshes);
            self.count_images(changes.meshes);
        }
        let home = textured::home(&self.session);
        changes.meshes |= std::mem::replace(&mut self.pattern_home, home) != home;
        let shown = self.draft.map().or(self.map.as_ref());
        if let (None, Some(map)) = (home, shown) {
            self.teaching.grid.update(&situation(map, &self.session, self.generation));
        }
        changes
    }

    /// When to refine an extension: at rest, where the picture has it from elsewhere.
    pub fn set_refines(&mut self, refines: Refines) {
        self.refines = refines;
    }

    /// Goes on with an extension that [`Self::refresh`] leaves alone.
    pub fn refine_at_rest(&mut self) -> Changes {
        let images = self.refines == Refines::AtRest && self.refine();
        if images {
            self.count_images(false);
        }
        Changes { images, ..Changes::default() }
    }

    /// How far the images are those of the extension that was asked for, from 0 to 1.
    pub fn extension_progress(&self) -> f64 {
        self.map.as_ref().map_or(1.0, ConformalMap::extension_progress)
    }

    /// Notes that images moved.
    fn count_images(&mut self, another_mesh: bool) {
        self.generation += 1;
        self.quality_stale = true;
        // what the picture does not show is not worth a number
        let shown = self.refines == Refines::InRefresh || self.extension_progress() == 1.0;
        // Another mesh has other triangles: the old ones' distortions fit nothing any more.
        if another_mesh || (shown && self.quality_ms < CHEAP_QUALITY_MS) {
            self.measure();
        }
    }

    /// What teaches.
    pub fn teaching(&self) -> &Teaching {
        &self.teaching
    }

    /// Does something with the random walks.
    pub fn act_on_walks(&mut self, action: WalkAction) {
        self.teaching.walks.act(action);
    }

    /// Brings what teaches up to date at the time `now` (seconds); in how many seconds to come back, if at all.
    pub fn teach(&mut self, now: f64) -> Option<f64> {
        // A coarse map has boundaries of its own: what is shown waits for the full one.
        let map = self.map.as_ref().filter(|_| self.draft.map().is_none())?;
        let situation = situation(map, &self.session, self.generation);
        self.teaching.advance(&situation, self.session.comparison, now)
    }

    /// Whether [`Self::measure`] would tell something new.
    pub fn is_quality_stale(&self) -> bool {
        self.quality_stale
    }

    /// Measures the map's distortion.
    pub fn measure(&mut self) {
        let start = Instant::now();
        self.triangles.clear();
        let shown = self.draft.map().or(self.map.as_ref());
        self.quality = shown.map(|map| {
            triangle_distortions(map.mapped_mesh(), map.images(), &mut self.triangles);
            Quality::summary(&self.triangles)
        });
        self.measured = self.generation;
        self.quality_ms = start.elapsed().as_secs_f64() * 1e3;
        self.quality_stale = false;
    }

    fn swap(&mut self) {
        if self.sides.iter().any(Preparation::is_busy) {
            return;
        }
        self.session.apply(Command::Swap);
        self.sides.swap(0, 1);
        let generation = self.sides.iter().map(Preparation::generation).max().unwrap_or(0);
        self.sides.iter_mut().for_each(|side| side.skip_to(generation));
        self.refit = [true; 2];
        self.domains_changed = true;
    }

    fn constraints(&self) -> Option<Constraints> {
        let poles = [self.domain(Side::Source)?.pole, self.domain(Side::Target)?.pole];
        Some(self.session.constraints(poles))
    }

    /// A point that was set may lie outside a coarser polygon of the same outline.
    fn keep_points_inside(&mut self) {
        for side in SIDES {
            if let Some(point) = self.session.interior[side as usize]
                && let Some(inside) = self.interior_near(side, point)
            {
                self.session.interior[side as usize] = Some(inside);
            }
        }
    }

    fn note_duration(&mut self, start: Instant) {
        let slow = start.elapsed().as_secs_f64() * 1e3 > self.slow_update_ms;
        self.slow_updates = if slow { self.slow_updates + 1 } else { 0 };
    }

    /// Whether the full map is too slow for a drag. One slow update says so of the iterative
    /// solver only: a browser compiles what it runs for the first time.
    fn is_slow(&self) -> bool {
        let is_iterative = |side| self.domain(side).is_some_and(|domain| domain.solver.kind() == SolverKind::Pcg);
        self.slow_updates > u32::from(!SIDES.into_iter().any(is_iterative))
    }

    /// Lets the coarse map follow the points; whether it could.
    fn follow_coarsely(&mut self) -> bool {
        let Some(constraints) = self.constraints() else { return false };
        let outlines = SIDES.map(|side| &self.session.domain(side).outline);
        self.draft.follow(outlines, &constraints, self.session.map_settings())
    }

    fn rebuild(&mut self) -> bool {
        let (Some(source), Some(target)) = (self.domain(Side::Source), self.domain(Side::Target)) else { return false };
        let Some(constraints) = self.constraints() else { return false };
        let (source, target) = (Arc::clone(source), Arc::clone(target));
        let start = Instant::now();
        let map = ConformalMap::new(source, target, &constraints, self.session.map_settings());
        self.note_duration(start);
        match map {
            Ok(mut map) => {
                if let Some(old) = self.map.take() {
                    map.adopt(old);
                }
                self.map = Some(map);
                self.settle(None);
                true
            }
            Err(error) => {
                self.settle(Some(error));
                false
            }
        }
    }

    /// Brings the full map up to date and shows it.
    fn update(&mut self) -> Changes {
        let (Some(constraints), Some(map)) = (self.constraints(), &mut self.map) else { return Changes::default() };
        let meshes = self.draft.retire() || map.direction() != self.session.direction;
        let start = Instant::now();
        let result = map.update(&constraints, self.session.map_settings());
        self.note_duration(start);
        let images = result.is_ok();
        if !images {
            (self.session.interior, self.session.anchor) = self.last_good_points;
        }
        self.settle(result.err());
        Changes { meshes, map: images, images }
    }

    /// Goes on with an extension that is not complete; whether images changed.
    fn refine(&mut self) -> bool {
        let Some(map) = &mut self.map else { return false };
        let incomplete = map.extension_progress() < 1.0;
        if incomplete {
            map.refine(REFINE_MS);
        }
        incomplete
    }

    fn settle(&mut self, error: Option<MapError>) {
        if error.is_none() {
            self.last_good_points = (self.session.interior, self.session.anchor);
        }
        self.map_error = error.map(|error| (side_of(&error), error.to_string()));
    }
}

fn situation<'a>(map: &'a ConformalMap, session: &Session, generation: u64) -> Situation<'a> {
    let constraints = session.constraints(SIDES.map(|side| map.domain(side).pole));
    let points = SIDES.map(|side| constraints.point(side));
    Situation { map, generation, points, anchors: session.anchor }
}

/// Lower left and upper right corner of the points.
pub fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    points.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &point| (low.min(point), high.max(point)))
}

/// The side whose vertices the map moves.
pub fn mapped_side(direction: Direction) -> Side {
    match direction {
        Direction::Forward => Side::Source,
        Direction::Backward => Side::Target,
    }
}

fn side_of(error: &MapError) -> Side {
    match error {
        MapError::PointOutside { side, .. }
        | MapError::AnchorNotFinite { side }
        | MapError::NotConverged { side, .. } => *side,
    }
}

/// The other side.
pub fn other(side: Side) -> Side {
    match side {
        Side::Source => Side::Target,
        Side::Target => Side::Source,
    }
}
