//! What the model is asked for: commands, files, remedies; requests to the workers and their answers.

use super::Model;
use crate::app::editing::Reshaped;
use crate::app::prepare_state::{Preparation, Progress};
use crate::app::trouble::Remedy;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::outline::{Outline, OutlineNote};
use crate::session::{Command, DomainSpec, OutlineSpec, Session};
use crate::worker::{Request, Response, Subject};

/// The distance from the boundary that a point is pushed to, in sizes of the domain: nearer, the map
/// squeezes nearly everything into a place too small to be seen.
const PUSH: f64 = 0.05;

impl Model {
    /// Carries out a command, or begins to: what needs a preparation takes effect when it is done.
    pub fn dispatch(&mut self, command: Command, now: f64) {
        match command {
            Command::SetOutline { side, outline } => {
                self.want_outline(side, outline, Vec::new());
            }
            Command::ReshapeOutline { side, outline, interior, anchor } => {
                self.reshape(side, outline, Reshaped { interior, anchor, in_hand: false });
            }
            Command::SetSurface(_)
            | Command::RefineSurface(_)
            | Command::MoveSurfacePoint(_)
            | Command::MoveSurfaceAnchor(_)
            | Command::CloseSurface => self.dispatch_surface(command, now),
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
        self.surface.gives_way = false;
        for side in Side::BOTH {
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
        self.session = Session {
            source: shown.source,
            target: shown.target,
            interior,
            anchor,
            surface: shown.surface,
            ..session.clone()
        };
        self.open_surface(session.surface.clone());
        self.map_error = None;
        self.points_changed = true;
    }

    fn want_outline(&mut self, side: Side, outline: OutlineSpec, notes: Vec<OutlineNote>) {
        if side == Side::Target {
            self.incoming_surface = None;
            self.surface.preparation.give_up();
            if self.session.surface.is_some() && self.side(side).wanted().outline == outline {
                return self.close_surface();
            }
            self.surface.gives_way = true;
        }
        self.incoming_points[side as usize] = None;
        self.side_mut(side).error = None;
        self.side_mut(side).want_outline(outline, notes);
    }

    /// Begins to prepare another form of an outline; while that is in someone's hand, coarsely.
    pub fn reshape(&mut self, side: Side, outline: OutlineSpec, reshaped: Reshaped) {
        self.incoming_points[side as usize] = None;
        self.side_mut(side).want_reshaped(outline, reshaped);
    }

    /// Begins to prepare an outline that was read from a file.
    pub fn want_loaded(&mut self, side: Side, outline: Outline) {
        let Outline { name, polygon, notes } = outline;
        let points = polygon.vertices().to_vec();
        self.want_outline(side, OutlineSpec::Points { name, points }, notes);
    }

    /// Does what the message about a subject offers.
    pub fn remedy(&mut self, subject: Subject) {
        let Subject::Domain(side) = subject else { return self.surface.preparation.remedy() };
        match self.side_mut(side).error.take().and_then(|trouble| trouble.remedy) {
            Some(Remedy::Retry) => self.side_mut(side).retry(),
            Some(Remedy::Repaired(outline)) => self.want_loaded(side, *outline),
            Some(Remedy::RepairSurface) | None => {}
        }
    }

    /// Closes the messages about a subject.
    pub fn dismiss(&mut self, subject: Subject) {
        let Subject::Domain(side) = subject else {
            return self.surface.preparation.dismiss();
        };
        self.side_mut(side).error = None;
        self.map_error = self.map_error.take().filter(|(at, _)| *at != side);
    }

    /// The requests that are due.
    pub fn take_requests(&mut self, now: f64) -> Vec<(Subject, Request)> {
        // what is in a hand is prepared anew when the picture shows it, or none of it would be seen
        let shows = self.pending.is_none() && !self.domains_changed;
        let of_side = |side| {
            let preparation = Some(self.side_mut(side)).filter(|preparation| shows || !preparation.is_in_hand())?;
            Some((Subject::Domain(side), preparation.take_request(now)?))
        };
        let mut requests: Vec<_> = Side::BOTH.into_iter().filter_map(of_side).collect();
        requests.extend(self.take_surface_request(now).map(|request| (Subject::Surface, request)));
        for side in Side::BOTH {
            if !self.side(side).is_busy() {
                self.incoming_points[side as usize] = None; // their domain was refused
            }
        }
        requests
    }

    /// When the next request will be due.
    pub fn next_due(&self) -> Option<f64> {
        let surface = self.surface.preparation.due();
        self.sides.iter().filter_map(Preparation::due).chain(surface).reduce(f64::min)
    }

    /// Takes in an answer of a worker.
    pub fn accept(&mut self, subject: Subject, generation: u64, response: Response) {
        let Subject::Domain(side) = subject else { return self.accept_surface(generation, response) };
        let progress = self.side_mut(side).accept(generation, response);
        if matches!(progress, Progress::Failed) {
            self.incoming_points[side as usize] = None;
            self.surface.gives_way &= side == Side::Source;
        }
        if let Progress::Ready { spec, reshaped: Some(reshaped), .. } = progress {
            self.take_reshaped(side, spec, reshaped);
        } else if let Progress::Ready { spec, new_outline, .. } = progress {
            if new_outline && spec.outline != self.session.domain(side).outline {
                let surface = self.session.surface.take();
                self.session.apply(Command::SetOutline { side, outline: spec.outline });
                self.session.surface = surface;
            }
            if side == Side::Target && std::mem::take(&mut self.surface.gives_way) {
                self.session.surface = None;
            }
            self.session.apply(Command::SetSettings { side, settings: spec.settings });
            if let Some((interior, anchor)) = self.incoming_points[side as usize].take() {
                (self.session.interior[side as usize], self.session.anchor[side as usize]) = (interior, anchor);
            }
            let is_hidden = side == Side::Target && self.session.surface.is_some();
            self.refit[side as usize] |= new_outline && !is_hidden;
            self.domains_changed |= !is_hidden;
        }
    }

    /// A reshaped outline is prepared. The view stays as it is, and the settings while the outline is in a hand.
    fn take_reshaped(&mut self, side: Side, spec: DomainSpec, reshaped: Reshaped) {
        let Reshaped { interior, anchor, in_hand } = reshaped;
        let interior = interior.and_then(|point| self.pushed_inside(side, point));
        self.session.apply(Command::ReshapeOutline { side, outline: spec.outline, interior, anchor });
        if !in_hand {
            self.session.apply(Command::SetSettings { side, settings: spec.settings });
        }
        self.domains_changed = true;
    }

    /// The interior point of a side that was reshaped: where the outline has run over it, well inside,
    /// for a map that has anything to see.
    fn pushed_inside(&self, side: Side, point: DVec2) -> Option<DVec2> {
        if self.interior_near(side, point)?.distance(point) == 0.0 {
            return Some(point);
        }
        let (low, high) = self.extent(side)?;
        Some(self.domain(side)?.nearest_inside(point, PUSH * (high - low).max_element()))
    }

    /// The worker of a subject stopped.
    pub fn worker_died(&mut self, subject: Subject, reason: &str) {
        match subject {
            Subject::Domain(side) => self.side_mut(side).worker_died(reason),
            Subject::Surface => self.surface.preparation.worker_died(reason),
        }
    }

    fn swap(&mut self) {
        if self.session.surface.is_some() || self.sides.iter().any(Preparation::is_busy) {
            return;
        }
        self.session.apply(Command::Swap);
        self.sides.swap(0, 1);
        let generation = self.sides.iter().map(|side| side.errand().generation()).max().unwrap_or(0);
        self.sides.iter_mut().for_each(|side| side.skip_to(generation));
        self.refit = [true; 2];
        self.domains_changed = true;
    }
}
