//! What each viewport draws: a mesh, where its vertices lie, and where they look the pattern up.
//!
//! The pattern lives on one side, its home, which shows its own mesh with its own
//! positions. The other side shows the mapped mesh. If that is the home's, its vertices
//! lie at their images and keep their own coordinates: pushed forward from the source,
//! pulled back from the target. If it is the other side's, the images are what it looks up.
//! The conformal pattern lives in the disk: both sides look up their own disk coordinates. With one surface the home
//! is the plane, whichever side that is; between two surfaces every pattern lives in the disk, through which they are
//! mapped, so that corresponding points have the same color.

pub mod cells;
pub mod colouring;
pub mod disk_grid;

use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::{Abilities, Model};
use crate::render::{MeshGeometry, Pattern, TextureStyle};
use crate::session::{Session, TextureKind};

/// What changes when the map's images do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Moved<'a> {
    /// Where the vertices lie.
    Positions(&'a [DVec2]),
    /// Where they look the pattern up.
    Coordinates(&'a [DVec2]),
}

/// The side where the pattern of a session lives; `None`: in the disk. The picture has it from [`Model::pattern_home`].
pub fn home(session: &Session) -> Option<Side> {
    let side = Abilities::of(session).pattern_home(session.texture_side());
    side.filter(|_| session.texture() != TextureKind::Conformal)
}

/// Whether the pattern of a session needs a [`disk_grid::DiskGrid`]; a map between two surfaces computes its disk
/// coordinates itself.
pub fn needs_grid(session: &Session) -> bool {
    home(session).is_none() && !Abilities::of(session).maps_through_disk()
}

/// The pattern as it is drawn on both sides, as soon as there is something; without an image a checkerboard in its place.
pub fn style(model: &Model, has_image: bool, dark: bool) -> Option<TextureStyle> {
    let session = model.session();
    let pattern = match session.texture() {
        TextureKind::Grid => Pattern::Grid,
        TextureKind::Conformal if model.pattern_home().is_none() => Pattern::Conformal,
        // the conformal one, until there are disk coordinates
        TextureKind::Polar | TextureKind::Conformal => Pattern::Polar,
        TextureKind::Image if has_image => Pattern::Image,
        TextureKind::Checker | TextureKind::Image => Pattern::Checker,
    };
    let (bounds, pole) = match model.pattern_home() {
        None if pattern == Pattern::Conformal || model.is_through_disk() => (TextureStyle::DISK, DVec2::ZERO),
        home => {
            let home = home.unwrap_or(session.texture_side());
            (model.extent(home)?, model.interior(home)?)
        }
    };
    Some(TextureStyle { pattern, cells: session.texture_scale(), bounds, pole, dark })
}

/// What a side shows, as soon as there is something.
pub fn geometry(model: &Model, side: Side) -> Option<MeshGeometry<'_>> {
    let Some(home) = model.pattern_home() else {
        let mesh = model.shown_domain(side)?.mesh();
        let texture_coordinates = disk_coordinates(model, side)?;
        return Some(MeshGeometry { positions: mesh.vertices(), texture_coordinates, triangles: mesh.triangles() });
    };
    if side == home {
        let mesh = model.shown_domain(side)?.mesh();
        let vertices = mesh.vertices();
        return Some(MeshGeometry { positions: vertices, texture_coordinates: vertices, triangles: mesh.triangles() });
    }
    let map = model.map()?;
    let mesh = map.mapped().domain()?.mesh();
    let (positions, texture_coordinates) = if side == map.direction().mapped_side() {
        (mesh.vertices(), map.images())
    } else {
        (map.images(), mesh.vertices())
    };
    Some(MeshGeometry { positions, texture_coordinates, triangles: mesh.triangles() })
}

/// What of it moves with the map's images.
pub fn moved(model: &Model, side: Side) -> Option<Moved<'_>> {
    let Some(home) = model.pattern_home() else { return disk_coordinates(model, side).map(Moved::Coordinates) };
    let map = model.map()?;
    map.domain(side)?; // a surface's are drawn elsewhere
    let is_mapped = side == map.direction().mapped_side();
    let moved = if is_mapped { Moved::Coordinates(map.images()) } else { Moved::Positions(map.images()) };
    (side != home).then_some(moved)
}

/// Those of the mesh that a side shows in the plane; a surface has its own.
fn disk_coordinates(model: &Model, side: Side) -> Option<&[DVec2]> {
    model.map()?.domain(side).map(|_| model.shown_grid().of(side))
}

/// Where the vertices of a side's surface look the pattern up.
pub fn surface_coordinates(model: &Model, side: Side) -> Option<&[DVec2]> {
    let map = model.map().filter(|map| map.side(side).is_surface())?;
    match (map.disk(side), model.pattern_home()) {
        (Some(disk), _) => Some(disk),
        (None, Some(_)) => Some(map.images()),
        (None, None) => Some(model.shown_grid().of(side)),
    }
}
