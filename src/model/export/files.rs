//! The map as a file of numbers or of vector graphics.

use crate::conformal::{ConformalMap, Side};
use crate::export::{
    self, Base, EncodedSurface, FileFormat, Flattened, Panel, Part, Ruling, boundary_csv, mapped_mesh, parts, svg,
};
use crate::language::{Message, key};
use crate::model::export::picture_base::PictureBase;
use crate::model::export::request::Layout;
use crate::model::{Model, pattern};
use crate::render::{Pattern, TextureStyle};
use crate::session::SurfaceShape;
use crate::surface::{SurfaceFormat, read_surface};
use crate::tiling::{TilingPattern, TilingStyle};
use crate::worker::SurfaceSource;
use image::RgbaImage;

/// A file that is ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadyFile {
    /// Its name.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
    /// What is to be said about it.
    pub note: Option<Message>,
}

impl ReadyFile {
    /// A file about which nothing is to be said.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), bytes: bytes.into(), note: None }
    }
}

/// What of a map goes into a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileRequest {
    /// Its format.
    pub format: FileFormat,
    /// The domain of a drawing; `None`: both, side by side.
    pub side: Option<Side>,
    /// Whether a surface's texture coordinates are moved and scaled into the unit box.
    pub unit: bool,
    /// Whether a surface is divided so that its layout reaches the outline's corners.
    pub corners: bool,
}

/// The map that is shown as a file; a GLB contains `picture` if that is the texture. `None` while there is no map. Errors: in words.
pub fn file(model: &Model, request: FileRequest, picture: Option<&RgbaImage>) -> Option<Result<ReadyFile, Message>> {
    let map = model.map()?;
    if model.abilities().has_layout() {
        return surface_file(model, map.mapped_side(), request, picture);
    }
    let name = format!("riemap.{}", request.format.extension());
    let bytes = match request.format {
        FileFormat::Svg if map.is_through_disk() => disks(model, map, request.side)?.into_bytes(),
        FileFormat::Svg => drawing(model, request.side)?.into_bytes(),
        FileFormat::Csv => boundary_csv(map).into_bytes(),
        FileFormat::Obj | FileFormat::Ply | FileFormat::Glb => {
            let source = model.surface(map.mapped_side()).and_then(|(surface, _)| surface.preparation.source());
            let Some(mesh) = with_source(source, |source| mapped_mesh(map, request.format, source)) else {
                return Some(Err(key::planar_map_format(request.format.extension())));
            };
            let note = mesh.is_bare.then(|| key::bare_triangles(&name));
            return Some(Ok(ReadyFile { name, bytes: mesh.bytes, note }));
        }
    };
    Some(Ok(ReadyFile::new(name, bytes)))
}

/// The surface as it was given, every vertex with its place in the outline.
fn surface_file(
    model: &Model,
    side: Side,
    request: FileRequest,
    picture: Option<&RgbaImage>,
) -> Option<Result<ReadyFile, Message>> {
    let (surface, state) = model.surface(side)?;
    let flattened = flattened(model, Layout { unit: request.unit, corners: request.corners })?;
    let picture = picture.filter(|_| request.format == FileFormat::Glb);
    let EncodedSurface { bytes, is_bare } = match picture.and_then(|picture| PictureBase::new(model, picture)) {
        Some(Ok(base)) => {
            let base = Base { png: base.png(), lookup: &|place| base.lookup(place) };
            EncodedSurface { bytes: flattened.glb(Some(&base)), is_bare: false }
        }
        Some(Err(error)) => return Some(Err(error)),
        None => with_source(surface.preparation.source(), |source| flattened.encode_as_read(request.format, source)),
    };
    let name = format!("{}-mapped.{}", stem(&state.spec.shape), request.format.extension());
    let note = is_bare.then(|| key::bare_triangles(&name));
    Some(Ok(ReadyFile { name, bytes, note }))
}

/// What `write` makes of a surface's file and the surface as it was read from it, or of none.
fn with_source<R>(source: Option<&SurfaceSource>, write: impl FnOnce(Option<export::SurfaceSource>) -> R) -> R {
    let file = source.and_then(|source| if let SurfaceSource::File(file) = source { Some(file) } else { None });
    let read = file.and_then(|file| {
        let format = SurfaceFormat::of(&file.name, &file.bytes).ok()?;
        Some((format, &file.bytes, read_surface(&file.name, &file.bytes).ok()?))
    });
    write(read.as_ref().map(|(format, bytes, surface)| export::SurfaceSource { format: *format, bytes, surface }))
}

/// The surface over an outline with its texture coordinates, as it is saved: divided at the outline's corners if the
/// layout hits them, unless it has none. `None` without such a map.
pub fn flattened(model: &Model, layout: Layout) -> Option<Flattened> {
    let map = model.map()?;
    let outline = &model.session().domain(map.mapped_side().other()).outline;
    let corners = if layout.corners { outline.corner_places() } else { Vec::new() };
    let cuts = map.cut_corners(&corners).filter(|cuts| !cuts.at_corners().is_empty());
    match cuts {
        Some(cuts) => Flattened::cut(map, &cuts, layout.unit),
        None => Flattened::new(map, layout.unit),
    }
}

fn stem(shape: &SurfaceShape) -> &str {
    match shape {
        SurfaceShape::Preset { preset, .. } => preset.name(),
        SurfaceShape::File { name } => name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem),
    }
}

/// Outlines, the pattern's lines, the points, and the mesh's edges where they are shown.
fn drawing(model: &Model, side: Option<Side>) -> Option<String> {
    let style = pattern::style(model, true, false)?;
    let sides = Side::BOTH.into_iter().filter(|at| side.is_none_or(|only| only == *at));
    let parts = sides.map(|side| Some(Part { side, panel: panel(model, side)?, wire: wire(model, side) }));
    Some(svg(&parts.collect::<Option<Vec<_>>>()?, Some(ruling(&style))))
}

/// Both surfaces as they lie in the unit disk.
fn disks(model: &Model, map: &ConformalMap, side: Option<Side>) -> Option<String> {
    let style = pattern::style(model, true, false)?;
    let mut shown = parts(map, &model.constraints()?);
    shown.retain(|part| side.is_none_or(|only| only == part.side));
    for part in &mut shown {
        let surface = map.side(part.side).surface()?;
        part.wire = Some((part.panel.positions, model.painted(part.side, surface)));
    }
    if !model.session().wireframe() {
        for part in &mut shown {
            part.wire = None;
        }
    }
    Some(svg(&shown, Some(ruling(&style))))
}

/// A side in the plane as it is drawn.
pub fn panel(model: &Model, side: Side) -> Option<Panel<'_>> {
    let geometry = pattern::geometry(model, side)?;
    Some(Panel {
        positions: geometry.positions,
        coordinates: geometry.texture_coordinates,
        triangles: geometry.triangles,
        boundary: model.shown_outline(side)?,
        unresolved: model.map().map_or(&[], |map| map.unresolved(side)),
        handles: [model.interior(side)?, model.anchor(side)?],
        pins: model.pin_places(side),
    })
}

fn wire(model: &Model, side: Side) -> Option<crate::export::Wire<'_>> {
    let map = model.shown().filter(|_| model.session().wireframe())?;
    Some((map.places(side)?, map.triangles))
}

/// The lines of a pattern: between the squares of a checkerboard, and over an image as on the grid.
fn ruling(style: &TextureStyle) -> Ruling {
    let (low, high) = style.bounds;
    let spacing = (high - low).max_element() / style.cells;
    match style.pattern {
        Pattern::Checker | Pattern::Grid | Pattern::Image | Pattern::Placed(_) => {
            Ruling::Squares { origin: 0.5 * (low + high), spacing }
        }
        Pattern::Polar => Ruling::Polar { pole: style.pole, spacing },
        Pattern::Conformal => Ruling::Conformal { rays: style.conformal_rays() },
        Pattern::Tiling { pattern: TilingPattern { tiling, style }, .. } => {
            Ruling::Tiling { tiling, mirrors: style == TilingStyle::Triangles }
        }
    }
}
