//! The state of the app without its user interface: session, the two sides, the map.
//!
//! This module uses neither egui nor wgpu. Commands arrive through [`Model::dispatch`] (file `commands`),
//! worker responses through [`Model::accept`]; [`Model::refresh`] (file `refresh`)
//! then updates the map and returns what has to be uploaded; an update that takes longer
//! than a frame continues in the next one (file `update`). While a side is being prepared,
//! the last good map stays and follows its handles.

mod abilities;
mod attachments;
pub mod best;
pub mod boundary_loops;
pub mod coarse;
mod commands;
pub mod curves;
pub mod editing;
pub mod export;
pub mod files;
mod fine;
mod interpretation;
mod invariants;
mod measurement;
mod method;
pub mod motion;
pub mod names;
pub mod opening;
pub mod overlays;
pub mod pattern;
pub mod persistence;
mod pinned;
mod pins_seen;
mod pointer;
mod probe;
mod quadrilateral;
mod refresh;
mod requested;
pub mod scene;
pub mod shape;
mod sharpness;
mod shown;
pub mod side;
mod surface;
mod symmetry;
mod under_way;
mod update;

pub use abilities::{Abilities, Unavailable};
pub use interpretation::Interpreting;
pub use method::Method;
pub use pointer::{PointedErrors, PointedImage};
pub use probe::{Probe, ProbeImage};
pub use sharpness::{ErrorBounds, SideKernel};

use crate::conformal::{
    ConformalMap, InteriorPoint, MeshedDomain, PerSide, PreparedSide, Quality, Side, Stage, TriangleDistortion,
};
use crate::geometry::{Bounds, DVec2};
use crate::language::Message;
use crate::model::best::BestMap;
use crate::model::coarse::Draft;
use crate::model::fine::Fine;
use crate::model::measurement::Measurement;
use crate::model::opening::Opening;
use crate::model::overlays::OverlayState;
use crate::model::pattern::disk_grid::DiskGrid;
use crate::model::pinned::Pinned;
use crate::model::shown::ShownMap;
use crate::model::side::preparation::Preparation;
use crate::model::side::{ModelSide, OutlineRequest, SurfaceFiles};
use crate::model::under_way::MapUnderWay;
use crate::session::{Command, Session};
use std::sync::Arc;

/// The minimum distance of a handle from the boundary, in sizes of the domain:
/// 0.004 is two pixels in a domain of 500, too close to distinguish a dot from
/// the edge, and still several boundary edges away from it.
const INSET: f64 = 0.004;

/// The time per frame for an update, in ms; one that takes longer continues in the next frame, and cannot
/// follow a drag: a coarse map replaces the full one. With a step that overruns the deadline
/// (10 ms in a browser), the coarse map and the drawing, a frame stays below the 50 ms
/// above which a user perceives lag.
const UPDATE_MS: f64 = 20.0;

/// What a refresh changed, for the upload.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Changes {
    /// A domain, the direction or the pattern's home has changed: meshes and outlines.
    pub meshes: bool,
    /// The map has changed: the boundary moved.
    pub map: bool,
    /// Images of vertices have changed: with the map, or because they were refined.
    pub images: bool,
}

impl std::ops::BitOrAssign for Changes {
    fn bitor_assign(&mut self, other: Self) {
        self.meshes |= other.meshes;
        self.map |= other.map;
        self.images |= other.images;
    }
}

/// When an incomplete extension is refined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refines {
    /// In every [`Model::refresh`].
    InRefresh,
    /// When [`Model::refine_at_rest`] is called.
    AtRest,
}

/// The processor that evaluates an extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Processor {
    /// A compute shader, evaluating all of it in every frame.
    Gpu,
    /// The CPU, over several frames.
    Cpu,
}

/// What the map does not show yet.
#[derive(Debug, Default)]
struct Changed {
    /// Whether the session's points or settings have changed since the map was last requested.
    points: bool,
    /// Whether the geometry of a side has changed since the map was last started.
    sides: bool,
}

/// The session, its sides and the map.
///
/// Invariant: a side of the map that is shown is a surface only if the session shows that surface, perhaps at another
/// resolution, whose map is not complete.
#[derive(Debug)]
pub struct Model {
    session: Session,
    sides: PerSide<ModelSide>,
    surface_files: SurfaceFiles,
    shown: ShownMap,
    under_way: MapUnderWay,
    coarse: Draft,
    fine: Fine,
    measurement: Measurement,
    overlay_state: OverlayState,
    refines: Refines,
    pub(super) update_ms: f64,
    pinned: Pinned,
    best: BestMap,
    changed: Changed,
    opening: Opening,
}

impl Model {
    /// A model that requests both of the session's domains, and its surfaces.
    pub fn new(session: Session) -> Self {
        Self::with_files(session, SurfaceFiles::default())
    }

    fn with_files(session: Session, surface_files: SurfaceFiles) -> Self {
        let surfaces = PerSide::from_fn(|side| session.surface(side).cloned());
        let pinned = Pinned::coming(session.pins().cloned());
        let session = session.and(Side::BOTH.map(Command::CloseSurface));
        let mut model = Self {
            sides: PerSide::from_fn(|side| ModelSide::new(session.side(side))),
            surface_files,
            shown: ShownMap::new(pattern::home(&session)),
            session,
            under_way: MapUnderWay::default(),
            coarse: Draft::default(),
            fine: Fine::default(),
            measurement: Measurement::default(),
            overlay_state: OverlayState::default(),
            refines: Refines::InRefresh,
            update_ms: UPDATE_MS,
            pinned,
            best: BestMap::default(),
            changed: Changed::default(),
            opening: Opening::default(),
        };
        for (side, surface) in surfaces.iter() {
            if surface.is_some() {
                model.open_surface(side, surface.clone());
            }
        }
        model
    }

    /// Another model of the same session, on the same prepared sides, with a map of its own. It makes no requests:
    /// preparations in progress for this model do not reach it. The refined map that is shown is copied; other maps are not
    /// refined.
    #[must_use]
    pub fn twin(&self) -> Self {
        let mut twin = Self::new(self.session.clone().and(Side::BOTH.map(Command::CloseSurface)));
        twin.sides = self.sides.as_ref().map(ModelSide::twin);
        twin.session.apply(Command::Open(Box::new(self.session.clone())));
        twin.pinned = self.pinned.twin();
        twin.changed.sides = true;
        twin.fine = self.fine.twin();
        twin
    }

    /// The session that the map on the screen is computed from.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The preparation of a side's outline.
    pub fn side(&self, side: Side) -> &Preparation<OutlineRequest> {
        &self.sides[side].outline
    }

    /// The preparation of a side's outline.
    pub fn side_mut(&mut self, side: Side) -> &mut Preparation<OutlineRequest> {
        &mut self.sides[side].outline
    }

    /// The stage of a side's request in flight and the seconds since it was sent, for the progress line.
    pub fn worker_stage(&self, side: Side) -> Option<(Option<Stage>, f64)> {
        self.sides[side].under_way()
    }

    /// The meshed domain of a side's last good outline, also while a surface replaces the outline.
    pub fn domain(&self, side: Side) -> Option<&Arc<MeshedDomain>> {
        self.side(side).domain()
    }

    /// The prepared geometry of a side: the surface if there is one, else the last good outline.
    pub fn prepared(&self, side: Side) -> Option<&Arc<PreparedSide>> {
        match self.session.surface(side) {
            Some(_) => self.sides[side].surface.prepared(),
            None => self.side(side).prepared(),
        }
    }

    /// Whether two outlines are mapped: there is no surface on either side.
    #[cfg(test)]
    pub fn is_planar(&self) -> bool {
        self.abilities().compares_outlines()
    }

    /// Whether the map that is shown is one between two surfaces.
    pub fn is_through_disk(&self) -> bool {
        self.map().is_some_and(ConformalMap::is_through_disk)
    }

    /// The map that is shown; `None` before the first. It is the full map, or a coarse one
    /// while the full one is being computed or is too slow for the current drag, or the refined one at rest.
    pub fn map(&self) -> Option<&ConformalMap> {
        self.coarse.map().or(self.fine.map()).or(self.shown.map.as_ref())
    }

    /// Whether the map that is shown is the coarse one.
    pub fn is_draft(&self) -> bool {
        self.coarse.map().is_some()
    }

    /// Whether the full map is incomplete, or its points are searched for: [`Self::refresh`] continues both.
    pub fn is_pending(&self) -> bool {
        self.under_way.is_pending() || self.pinned.is_behind()
    }

    /// The domain of a side that is shown: that of the map, or the prepared one before there is a map.
    pub fn shown_domain(&self, side: Side) -> Option<&Arc<MeshedDomain>> {
        self.map().and_then(|map| map.domain(side)).or_else(|| self.domain(side))
    }

    /// The outline of a side's domain as it is drawn, through the images of the other side's vertices.
    pub fn shown_outline(&self, side: Side) -> Option<&[DVec2]> {
        match self.map() {
            Some(map) if map.domain(side).is_some() => Some(map.drawn_outline(side)),
            _ => self.domain(side).map(|domain| domain.samples().points()),
        }
    }

    /// The disk coordinates of the map that is shown, if [`Self::pattern_home`] requires them.
    pub fn shown_grid(&self) -> &DiskGrid {
        match (self.is_draft(), self.fine.map()) {
            (true, _) => self.coarse.grid(),
            (false, Some(_)) => self.fine.grid(),
            (false, None) => &self.overlay_state.grid,
        }
    }

    /// The side on which the pattern in the picture is defined; `None`: in the disk. It follows the
    /// session when disk coordinates are available.
    pub fn pattern_home(&self) -> Option<Side> {
        self.shown.pattern_home
    }

    /// Angle distortion of the map; during a drag, that of the last measurement;
    /// none for a new large mesh until the map rests.
    pub fn quality(&self) -> Option<Quality> {
        self.measurement.quality()
    }

    /// The distortion of every triangle of the mapped mesh, at the time of [`Self::quality`].
    pub fn triangles(&self) -> &[TriangleDistortion] {
        self.measurement.triangles()
    }

    /// The [`Self::generation`] of the map that [`Self::triangles`] belongs to.
    pub fn measured_generation(&self) -> u64 {
        self.measurement.generation()
    }

    /// Incremented when the images change: with the map, or because they were refined.
    pub fn generation(&self) -> u64 {
        self.shown.generation
    }

    /// Whether points that follow from pins are searched for.
    pub fn is_searching_points(&self) -> bool {
        self.pinned.is_behind()
    }

    /// Incremented when another mesh is mapped.
    pub fn mesh_generation(&self) -> u64 {
        self.shown.mesh_generation
    }

    /// The error about a constraint that the map rejected, or about the pins.
    pub fn map_error(&self) -> Option<(Side, &Message)> {
        self.under_way.error.as_ref().or(self.pinned.error()).map(|(side, message)| (*side, message))
    }

    /// Whether a side shows a new outline since the last call, so that its viewport has to fit it.
    pub fn take_refit(&mut self, side: Side) -> bool {
        let comes = self.is_pending() && self.under_way.next.is_some();
        let shows_the_old_one = comes && self.shown.map.is_some() && !self.is_draft();
        !shows_the_old_one && std::mem::take(&mut self.sides[side].refit)
    }

    /// Whether the final map for the session is shown: [`Self::is_mapped`], no side awaits its integral equation, and the
    /// map is refined or cannot be. What is written and measured then does not depend on the moment.
    pub fn is_ready(&self) -> bool {
        self.is_sharp() && !self.is_refining()
    }

    /// Whether the full map is shown and no side awaits its integral equation; it may still be refined.
    pub fn is_sharp(&self) -> bool {
        self.is_mapped() && !Side::BOTH.into_iter().any(|side| self.is_sharpening(side))
    }

    /// Whether the full map for the session is shown and no preparation is in progress; it may still be sharpened and refined.
    pub fn is_mapped(&self) -> bool {
        let is_busy = Side::BOTH.into_iter().any(|side| self.is_preparing(side));
        self.shown.map.is_some() && self.shows_present_surfaces() && !self.is_pending() && !is_busy
    }

    /// Lower left and upper right corner of a side's domain.
    pub fn extent(&self, side: Side) -> Option<(DVec2, DVec2)> {
        self.domain(side).map(|domain| bounds(domain.samples().points()))
    }

    /// The interior point of a side: of the surface if there is one, else of the outline.
    pub fn point(&self, side: Side) -> Option<InteriorPoint> {
        match self.surface(side) {
            Some((surface, state)) => surface.point(state).map(InteriorPoint::from),
            None => self.interior(side).map(InteriorPoint::from),
        }
    }

    /// The interior point of a side's outline: the position of its handle.
    pub fn interior(&self, side: Side) -> Option<DVec2> {
        let domain = self.domain(side)?;
        Some(self.session.side(side).interior.unwrap_or(domain.default_point()))
    }

    /// The boundary point of a side's outline: the position of its handle.
    pub fn anchor(&self, side: Side) -> Option<DVec2> {
        let samples = self.domain(side)?.samples();
        Some(samples.position(samples.at_fraction(self.session.side(side).anchor())))
    }

    /// The position of the interior handle for a pointer at `x`: there, or the nearest one inside the boundary.
    pub fn interior_near(&self, side: Side, x: DVec2) -> Option<DVec2> {
        let domain = self.domain(side)?;
        let (low, high) = self.extent(side)?;
        Some(domain.nearest_inside(x, INSET * (high - low).max_element()))
    }

    /// The boundary point nearest to `x`, as a fraction of arc length.
    pub fn anchor_near(&self, side: Side, x: DVec2) -> Option<f64> {
        let samples = self.domain(side)?.samples();
        Some(samples.fraction_at(samples.nearest(x)))
    }
}

/// Lower left and upper right corner of the points.
pub fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let [min, max] = Bounds::of(points.iter().copied()).corners();
    (min, max)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod either_side_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod pinned_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod quadrilateral_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod refining_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod sharpening_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod surface_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
