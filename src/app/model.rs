//! The state behind the picture: session, the two preparations, the map.
//!
//! No egui and no wgpu in here. Commands come in through [`Model::dispatch`],
//! worker answers through [`Model::accept`]; [`Model::refresh`] then brings the
//! map up to date and says what has to be uploaded. While a side is prepared,
//! the last good map stays and follows its handles.

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
    /// The mapped vertices moved.
    pub images: bool,
}

/// Session, preparations and map.
#[derive(Debug)]
pub struct Model {
    session: Session,
    sides: [Preparation; 2],
    map: Option<ConformalMap>,
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

    /// The map, as soon as both domains are there.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.map.as_ref()
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

    fn want_outline(&mut self, side: Side, outline: OutlineSpec, notes: Vec<OutlineNote>) {
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
        if let Progress::Ready { spec, new_outline } = self.side_mut(side).accept(generation, response) {
            if new_outline && spec.outline != self.session.domain(side).outline {
                self.session.apply(Command::SetOutline { side, outline: spec.outline });
            }
            self.session.apply(Command::SetSettings { side, settings: spec.settings });
            self.refit[side as usize] |= new_outline;
            self.domains_changed = true;
        }
    }

    /// Brings the map up to date with session and domains.
    pub fn refresh(&mut self) -> Changes {
        let mut changes = Changes::default();
        if std::mem::take(&mut self.domains_changed) {
            changes.meshes = true;
            self.keep_points_inside();
            changes.images |= self.rebuild();
            self.points_changed = false;
        }
        if std::mem::take(&mut self.points_changed) {
            changes.meshes |= self.map.as_ref().is_some_and(|map| map.direction() != self.session.direction);
            changes.images |= self.update();
        }
        changes.images |= self.refine();
        if changes.images {
            self.generation += 1;
            self.mesh_generation += u64::from(changes.meshes);
            self.quality_stale = true;
            // Another mesh has other triangles: the old ones' distortions fit nothing any more.
            if changes.meshes || self.quality_ms < CHEAP_QUALITY_MS {
                self.measure();
            }
        }
        let home = textured::home(&self.session);
        changes.meshes |= std::mem::replace(&mut self.pattern_home, home) != home;
        if let (None, Some(map)) = (home, &self.map) {
            self.teaching.grid.update(&situation(map, &self.session, self.generation));
        }
        changes
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
        let situation = situation(self.map.as_ref()?, &self.session, self.generation);
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
        self.quality = self.map.as_ref().map(|map| {
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

    fn rebuild(&mut self) -> bool {
        let (Some(source), Some(target)) = (self.domain(Side::Source), self.domain(Side::Target)) else { return false };
        let Some(constraints) = self.constraints() else { return false };
        match ConformalMap::new(Arc::clone(source), Arc::clone(target), &constraints, self.session.map_settings()) {
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

    fn update(&mut self) -> bool {
        let Some(constraints) = self.constraints() else { return false };
        let Some(map) = &mut self.map else { return false };
        match map.update(&constraints, self.session.map_settings()) {
            Ok(()) => {
                self.settle(None);
                true
            }
            Err(error) => {
                (self.session.interior, self.session.anchor) = self.last_good_points;
                self.settle(Some(error));
                false
            }
        }
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
