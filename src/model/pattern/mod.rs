//! What each viewport draws: a mesh, the positions of its vertices, and their texture coordinates.
//!
//! | pattern | defined in the coordinates of | texture coordinates on this side | on the other side |
//! |---|---|---|---|
//! | not in the disk, between two outlines | the chosen side | the positions | see below |
//! | not in the disk, between an outline and a surface | the outline | the positions | see below |
//! | any between two surfaces; the conformal one and tilings between any sides | the unit disk | the disk coordinates | the disk coordinates |
//!
//! The side in whose coordinates the pattern is defined shows its own mesh; the other side shows the mapped mesh. If
//! that is the first side's mesh, its vertices are drawn at their images with their own positions as texture
//! coordinates; otherwise they are drawn at their own positions with the images as texture coordinates. In all cases
//! corresponding points have the same color.

pub mod cells;
pub mod colouring;
pub mod corner_fill;
pub mod disk_grid;

use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::{Abilities, Model};
use crate::render::{MeshGeometry, Pattern, TextureStyle};
use crate::session::{Session, TextureKind};
use crate::tiling::{TilingPattern, TilingStyle};

/// The attribute of the vertices that consists of the map's images.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Moved<'a> {
    /// The positions.
    Positions(&'a [DVec2]),
    /// The texture coordinates.
    Coordinates(&'a [DVec2]),
}

/// The side in whose coordinates the pattern of a session is defined; `None` for the unit disk. While disk coordinates
/// are being computed the picture uses another side, [`Model::pattern_home`].
pub fn home(session: &Session) -> Option<Side> {
    let side = Abilities::of(session).pattern_home(session.texture_side());
    side.filter(|_| !session.texture().is_in_disk())
}

/// Whether the pattern of a session needs a [`disk_grid::DiskGrid`]; a map between two surfaces computes its disk
/// coordinates itself.
pub fn needs_grid(session: &Session) -> bool {
    home(session).is_none() && !Abilities::of(session).maps_through_disk()
}

/// The style of the pattern on both sides; a checkerboard, or tiles without pictures, if the image is missing. `None` until a side is prepared.
pub fn style(model: &Model, has_image: bool, dark: bool) -> Option<TextureStyle> {
    let session = model.session();
    let pattern = match session.texture() {
        TextureKind::Grid => Pattern::Grid,
        TextureKind::Conformal if model.pattern_home().is_none() => Pattern::Conformal,
        TextureKind::Tiling if model.pattern_home().is_none() => {
            Pattern::Tiling { pattern: drawn(session.tiling(), has_image), picture: session.picture() }
        }
        // those in the disk, until there are disk coordinates
        TextureKind::Polar | TextureKind::Conformal | TextureKind::Tiling => Pattern::Polar,
        TextureKind::Image if has_image => Pattern::Placed(session.picture()),
        TextureKind::Checker | TextureKind::Image => Pattern::Checker,
    };
    let (bounds, pole) = match model.pattern_home() {
        None if session.texture().is_in_disk() || model.is_through_disk() => (TextureStyle::DISK, DVec2::ZERO),
        home => {
            let home = home.unwrap_or(session.texture_side());
            (model.extent(home)?, model.interior(home)?)
        }
    };
    Some(TextureStyle { pattern, cells: session.texture_scale(), octaves: true, bounds, pole, dark })
}

/// The tiling as it is drawn: without a picture, its tiles.
fn drawn(pattern: TilingPattern, has_image: bool) -> TilingPattern {
    let style = match pattern.style {
        TilingStyle::Picture if !has_image => TilingStyle::Tiles,
        style => style,
    };
    TilingPattern { style, ..pattern }
}

/// The planar mesh that a side shows, with texture coordinates; `None` until it is prepared.
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

/// The attribute of [`geometry`] that consists of the map's images; `None` if neither does.
pub fn moved(model: &Model, side: Side) -> Option<Moved<'_>> {
    let Some(home) = model.pattern_home() else { return disk_coordinates(model, side).map(Moved::Coordinates) };
    let map = model.map()?;
    map.domain(side)?; // a surface's are drawn elsewhere
    let is_mapped = side == map.direction().mapped_side();
    let moved = if is_mapped { Moved::Coordinates(map.images()) } else { Moved::Positions(map.images()) };
    (side != home).then_some(moved)
}

/// The disk coordinates of the mesh of an outline; `None` for a surface.
fn disk_coordinates(model: &Model, side: Side) -> Option<&[DVec2]> {
    model.map()?.domain(side).map(|_| model.shown_grid().of(side))
}

/// The texture coordinates of the vertices of a side's surface.
pub fn surface_coordinates(model: &Model, side: Side) -> Option<&[DVec2]> {
    let map = model.map().filter(|map| map.side(side).is_surface())?;
    match (map.disk(side), model.pattern_home()) {
        (Some(disk), _) => Some(disk),
        (None, Some(_)) => Some(map.images()),
        (None, None) => Some(model.shown_grid().of(side)),
    }
}
