//! The state behind the picture: session, the two preparations, the map.
//!
//! No egui and no wgpu in here. Commands come in through [`Model::dispatch`] (file `wishes`),
//! worker answers through [`Model::accept`]; [`Model::refresh`] (file `refresh`)
//! then brings the map up to date and says what has to be uploaded; an update that takes longer
//! than a frame goes on in the next one (file `update`). While a side is prepared,
//! the last good map stays and follows its handles.

mod refresh;
mod shown;
mod surface;
mod update;
mod wishes;

use super::draft::Draft;
use super::prepare_state::Preparation;
use super::surface::SurfaceSide;
use super::teaching::Teaching;
use super::teaching::disk_grid::DiskGrid;
use super::textured;
use crate::conformal::{ConformalMap, Direction, PreparedDomain, Quality, Side, SurfaceMap, TriangleDistortion};
use crate::geometry::{Bounds, DVec2};
use crate::session::{Session, SurfaceState};
use std::sync::Arc;

/// The distance that a handle keeps from the boundary, in sizes of the domain:
/// 0.004 is two pixels in a domain of 500, closer than a dot can be told from
/// the edge, and still several boundary edges away from it.
const INSET: f64 = 0.004;

/// What a frame spends on an update, in ms; one that takes longer goes on in the next frame, and does
/// not follow a drag: a coarse map stands in. With a step that is longer than the clock asks for
/// (10 ms in a browser), the coarse map and the drawing, a frame stays below the 50 ms
/// from which on a hand feels that something lags.
const UPDATE_MS: f64 = 20.0;

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
    /// The last full map, complete.
    map: Option<ConformalMap>,
    /// The full map of other domains, until its first update is complete.
    next: Option<ConformalMap>,
    /// While the full map is behind the session: how many frames have gone on with it.
    pending: Option<u32>,
    /// Counts what the map has been asked for.
    revision: u64,
    /// The revision of the full map, and of the one in the picture.
    map_revision: u64,
    shown_revision: u64,
    /// The revision that the draft has followed, or could not.
    draft_revision: u64,
    draft: Draft,
    /// How many times in a row a frame was too short for an update.
    unfinished: u32,
    pub(super) update_ms: f64,
    /// The direction of the full map in the picture.
    shown_direction: Direction,
    quality: Option<Quality>,
    triangles: Vec<TriangleDistortion>,
    /// Those of a measurement under way, of the map of this generation.
    measuring: Vec<TriangleDistortion>,
    measuring_generation: u64,
    measured: u64,
    quality_ms: f64,
    quality_stale: bool,
    points_changed: bool,
    domains_changed: bool,
    last_good_points: ([Option<DVec2>; 2], [f64; 2]),
    generation: u64,
    mesh_generation: u64,
    /// How many times the boundary map has changed.
    map_generation: u64,
    map_error: Option<(Side, String)>,
    refit: [bool; 2],
    /// The points of a session whose domains are being prepared.
    incoming_points: [Option<(Option<DVec2>, f64)>; 2],
    refines: Refines,
    /// Where the pattern in the picture lives.
    pattern_home: Option<Side>,
    teaching: Teaching,
    surface: SurfaceSide,
    /// The state of a session's surface that is being prepared.
    incoming_surface: Option<SurfaceState>,
    last_good_surface: Option<SurfaceState>,
}

impl Model {
    /// Wants both of the session's domains, and its surface.
    pub fn new(mut session: Session) -> Self {
        let sides = [Preparation::new(session.source.clone()), Preparation::new(session.target.clone())];
        let surface = session.surface.take();
        let mut model = Self {
            last_good_points: (session.interior, session.anchor),
            pattern_home: textured::home(&session),
            session,
            sides,
            map: None,
            next: None,
            pending: None,
            revision: 0,
            map_revision: 0,
            shown_revision: 0,
            draft_revision: 0,
            draft: Draft::default(),
            unfinished: 0,
            update_ms: UPDATE_MS,
            shown_direction: Direction::default(),
            quality: None,
            triangles: Vec::new(),
            measuring: Vec::new(),
            measuring_generation: 0,
            measured: 0,
            quality_ms: 0.0,
            quality_stale: false,
            points_changed: false,
            domains_changed: false,
            generation: 0,
            mesh_generation: 0,
            map_generation: 0,
            map_error: None,
            refit: [true; 2],
            incoming_points: [None; 2],
            refines: Refines::InRefresh,
            teaching: Teaching::default(),
            surface: SurfaceSide::default(),
            incoming_surface: None,
            last_good_surface: None,
        };
        if surface.is_some() {
            model.open_surface(surface);
        }
        model
    }

    /// Another model of the same session, on the same prepared domains, with a map of its own. It asks for nothing:
    /// what is being prepared for this one does not come to it.
    #[must_use]
    pub fn twin(&self) -> Self {
        let mut twin = Self::new(Session { surface: None, ..self.session.clone() });
        twin.sides = self.sides.each_ref().map(Preparation::twin);
        twin.surface = self.surface.twin();
        twin.session = self.session.clone();
        twin.domains_changed = true;
        twin
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

    /// The map that is shown, as soon as there is one: the full one, or a coarse one
    /// while the full one is computed or too slow for the drag that is under way.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.draft.map().or(self.map.as_ref())
    }

    /// Whether the map that is shown is the coarse one.
    pub fn is_draft(&self) -> bool {
        self.draft.map().is_some()
    }

    /// Whether the full map is not there yet: [`Self::refresh`] goes on with it, but not while dragging.
    pub fn is_pending(&self) -> bool {
        self.pending.is_some() || self.is_surface_pending()
    }

    /// The domain of a side that is shown: that of the map, before there is one the prepared one.
    pub fn shown_domain(&self, side: Side) -> Option<&Arc<PreparedDomain>> {
        let of_surface = self.surface_map().filter(|_| side == Side::Source).map(SurfaceMap::source);
        of_surface.or_else(|| self.map().map(|map| map.domain(side))).or_else(|| self.domain(side))
    }

    /// The disk coordinates of the map that is shown, where [`Self::pattern_home`] asks for them.
    pub fn shown_grid(&self) -> &DiskGrid {
        if self.is_draft() { self.draft.grid() } else { &self.teaching.grid }
    }

    /// The side where the pattern in the picture lives; `None`: in the disk. It follows the
    /// session as soon as there are disk coordinates.
    pub fn pattern_home(&self) -> Option<Side> {
        self.pattern_home
    }

    /// Angle distortion of the map; of the last one that was measured while a drag is under way;
    /// none before another large mesh has rested.
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

    /// How many times the images have changed: with the map, or because they were refined.
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

    /// Whether a side shows a new outline since the last call: its viewport fits it.
    pub fn take_refit(&mut self, side: Side) -> bool {
        let comes = self.pending.is_some() && self.next.is_some();
        let shows_the_old_one = comes && self.map.is_some() && !self.is_draft();
        !shows_the_old_one && std::mem::take(&mut self.refit[side as usize])
    }

    /// The full map of what is asked for is shown and nothing is being prepared.
    pub fn is_ready(&self) -> bool {
        let mapped = self.map.is_some() || self.surface_map().is_some();
        let is_busy = self.sides.iter().any(Preparation::is_busy) || self.surface.preparation.is_busy();
        mapped && !self.is_pending() && !is_busy
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
}

/// Lower left and upper right corner of the points.
pub fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let Bounds { min, max } = Bounds::of(points.iter().copied());
    (min, max)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod surface_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
