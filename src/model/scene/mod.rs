//! What both viewports show of a session, without a window: the model brought to rest, and what there is to draw.
//!
//! The model is the app's own, its workers run here and now; so a picture made from this shows what
//! the app shows at rest. It does not depend on how fast the machine is: no coarse map ever stands in.

mod shot;

pub use shot::Shot;

use crate::conformal::{MeshedSurface, PerSide, Side, Stage};
use crate::export::Panel;
use crate::family::{Loop, Path, Place};
use crate::geometry::{DVec2, DVec3};
use crate::language::{Message, key};
use crate::mesh::BarycentricPoint;
use crate::model::export::{FileRequest, ReadyFile};
use crate::model::motion::looping;
use crate::model::pattern::cells::{Cells, PlanarCells};
use crate::model::{Changes, Model, export, pattern};
use crate::render::{CellCode, CellStyle, MeshGeometry, OrbitCamera, TextureStyle};
use crate::session::{Command, Session, SurfaceShape, SurfaceSpec, SurfaceState};
use crate::worker::{self, Response};
use image::RgbaImage;

/// A session whose map is complete.
#[derive(Debug)]
pub struct Offscreen {
    model: Model,
    cells: Cells,
    pixels_per_point: f32,
}

/// The steps until the map is complete.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doing {
    /// The given stage of the preparation of a side's outline begins.
    PreparingOutline(Side, Stage),
    /// The given stage of the preparation of a side's surface begins.
    PreparingSurface(Side, Stage),
    /// The map and its measurement begin.
    Mapping,
}

/// The reason why a session has no picture.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}", .0.english())]
pub struct OffscreenError(Message);

impl From<&OffscreenError> for Message {
    fn from(OffscreenError(message): &OffscreenError) -> Self {
        message.clone()
    }
}

/// The mapped mesh on one side, to be drawn triangle by triangle.
#[derive(Debug, Clone, Copy)]
pub struct OffscreenCells<'a> {
    /// The positions of its vertices; `None` on a surface.
    pub positions: Option<&'a [DVec2]>,
    /// Its triangles.
    pub triangles: &'a [[u32; 3]],
    /// Their codes.
    pub codes: &'a [CellCode],
    /// How they are shown.
    pub style: CellStyle,
}

/// A surface in the place of a side's outline.
#[derive(Debug, Clone, Copy)]
pub struct OffscreenSurface<'a> {
    /// The surface.
    pub surface: &'a MeshedSurface,
    /// The triangles that are painted.
    pub triangles: &'a [[u32; 3]],
    /// The texture coordinates of its vertices.
    pub coordinates: &'a [DVec2],
    /// The interior and the boundary point.
    pub points: [DVec3; 2],
    /// The pins in their place; empty: there are none.
    pub pins: &'a [DVec3],
}

impl Offscreen {
    /// Prepares both sides and computes the map, which may take seconds. `surface_files` holds the files of the
    /// session's surfaces. `pixels_per_point` scales lines and dots.
    ///
    /// Errors: the user error that the app would show beside an outline or a surface.
    pub fn new(session: &Session, surface_files: SurfaceFiles, pixels_per_point: f32) -> Result<Self, OffscreenError> {
        Self::telling(session, surface_files, pixels_per_point, &mut |_| ())
    }

    /// As [`Self::new`]; calls `tell` at the beginning of each stage.
    pub fn telling(
        session: &Session,
        surface_files: SurfaceFiles,
        pixels_per_point: f32,
        tell: &mut dyn FnMut(Doing),
    ) -> Result<Self, OffscreenError> {
        let mut model = begin(session, surface_files)?;
        model.update_ms = f64::INFINITY; // no frame has to be shown in time
        settle(&mut model, tell)?;
        // along a loop the equations stay those of its beginning, as in the app's copy of a model
        model.end_sharpening();
        let mut offscreen = Self { model, cells: Cells::default(), pixels_per_point };
        offscreen.rest();
        Ok(offscreen)
    }

    /// The model at rest.
    #[cfg(test)]
    pub fn into_model(self) -> Model {
        self.model
    }

    /// The session; its points may have been moved into the domains.
    pub fn session(&self) -> &Session {
        self.model.session()
    }

    /// The style of the texture, the same on both sides; a checkerboard if the image is missing.
    pub fn style(&self, has_image: bool, dark: bool) -> Option<TextureStyle> {
        pattern::style(&self.model, has_image, dark)
    }

    /// Mesh, outline and points of a side in the plane.
    pub fn panel(&self, side: Side) -> Option<Panel<'_>> {
        export::panel(&self.model, side)
    }

    /// The textured mesh of a side in the plane.
    pub fn geometry(&self, side: Side) -> Option<MeshGeometry<'_>> {
        pattern::geometry(&self.model, side)
    }

    /// A copy of a model on the same prepared sides; [`Self::advance`] completes its map, on the mesh that the app shows.
    pub fn of(model: &Model, pixels_per_point: f32) -> Self {
        Self { model: model.twin(), cells: Cells::default(), pixels_per_point }
    }

    /// As [`Self::of`], for maps along a loop: on the mesh that the app shows while points move, the first one too.
    pub fn moving(model: &Model, pixels_per_point: f32) -> Self {
        let mut copy = Self::of(model, pixels_per_point);
        copy.model.fine.forget_copy();
        copy
    }

    /// Computes the map for at most the time of a frame; returns whether it is complete.
    pub fn advance(&mut self) -> Result<bool, OffscreenError> {
        self.model.refresh(false);
        if let Some(error) = user_error(&self.model) {
            return Err(OffscreenError(error));
        }
        let is_complete = is_complete(&self.model);
        if is_complete {
            self.rest();
        }
        Ok(is_complete)
    }

    /// The loop along `path` that begins at the present points; `None` if no point would move.
    pub fn way(&self, path: Path) -> Option<Loop> {
        looping::begin(&self.model, path)
    }

    /// Goes to another place in the family of maps, and waits for the map there.
    pub fn go(&mut self, place: Place) -> Result<(), OffscreenError> {
        self.head_for(place);
        settle(&mut self.model, &mut |_| ())?;
        self.rest();
        Ok(())
    }

    /// Wants another place: [`Self::advance`] goes there.
    pub fn head_for(&mut self, place: Place) {
        for command in looping::commands(place) {
            self.model.dispatch(command, 0.0);
        }
    }

    /// The map is complete: its colors follow.
    fn rest(&mut self) {
        self.model.measure();
        self.cells.update(&self.model, self.pixels_per_point);
    }

    /// The map as a file, as [`export::file`] has it. Errors: in words.
    pub fn file(&self, request: FileRequest, picture: Option<&RgbaImage>) -> Result<ReadyFile, OffscreenError> {
        let nothing = || Err(key::no_map().into());
        export::file(&self.model, request, picture).unwrap_or_else(nothing).map_err(OffscreenError)
    }

    /// The mapped mesh on a side, where the session shows more of it than the texture; between two surfaces it is shown
    /// on its own side alone.
    pub fn cells(&self, side: Side) -> Option<OffscreenCells<'_>> {
        let (style, map) = (self.cells.style()?, self.model.shown()?);
        if let Some(PlanarCells { positions, triangles, codes }) = self.cells.in_plane(&map, side) {
            return Some(OffscreenCells { positions: Some(positions), triangles, codes, style });
        }
        let (triangles, codes) = (map.triangles, self.cells.codes());
        (side == map.mapped_side()).then_some(OffscreenCells { positions: None, triangles, codes, style })
    }

    /// The surface of a side, if one stands there.
    pub fn surface(&self, side: Side) -> Option<OffscreenSurface<'_>> {
        let surface = self.model.shown_surface(side)?;
        Some(OffscreenSurface {
            surface,
            triangles: self.model.painted(side, surface),
            coordinates: pattern::surface_coordinates(&self.model, side)?,
            points: [self.model.surface_point(side)?, self.model.surface_anchor(side)?],
            pins: self.model.pin_places(side),
        })
    }

    /// The interior point of a side's surface as it is mapped, and how many triangles the surface has.
    pub fn surface_point(&self, side: Side) -> Option<(BarycentricPoint, usize)> {
        let (surface, state) = self.model.surface(side)?;
        Some((surface.point(state)?, surface.surface()?.mesh().triangles().len()))
    }

    /// From where the surface of a side is seen at first, in a viewport of this width over height.
    pub fn camera(&self, side: Side, aspect: f64) -> Option<OrbitCamera> {
        let (surface, state) = self.model.surface(side)?;
        surface.first_view(state, aspect)
    }
}

/// The bytes of the files that a session's surfaces come from.
pub type SurfaceFiles = PerSide<Option<Vec<u8>>>;

/// A model that prepares all of the session.
fn begin(session: &Session, surface_files: SurfaceFiles) -> Result<Model, OffscreenError> {
    let from_file = |side| match session.surface(side) {
        Some(state @ SurfaceState { spec: SurfaceSpec { shape: SurfaceShape::File { name }, .. }, .. }) => {
            Some((state, name))
        }
        _ => None,
    };
    let files = PerSide::from_fn(from_file);
    let on_files = Side::BOTH.into_iter().filter(|side| files[*side].is_some()).map(Command::CloseSurface);
    let mut model = Model::new(session.clone().and(on_files));
    for (side, bytes) in Side::BOTH.into_iter().zip(surface_files.into_array()) {
        match (files[side], bytes) {
            (None, None) => {}
            (Some((state, _)), Some(bytes)) => model.open_surface_file(side, state.clone(), bytes),
            (Some((_, name)), None) => return Err(OffscreenError(key::surface_travels_as_file(name))),
            (None, Some(_)) => return Err(OffscreenError(key::no_surface_from_file().into())),
        }
    }
    Ok(model)
}

/// Prepares and maps until there is nothing left to do.
fn settle(model: &mut Model, tell: &mut dyn FnMut(Doing)) -> Result<(), OffscreenError> {
    loop {
        let requests = model.take_requests(f64::INFINITY);
        let is_waiting = requests.is_empty();
        for (side, request) in requests {
            let doing = if request.is_of_surface() { Doing::PreparingSurface } else { Doing::PreparingOutline };
            worker::run(&request, &mut |generation, response| {
                if let Response::Progress(stage) = response {
                    tell(doing(side, stage));
                }
                model.accept(side, generation, response);
            });
        }
        if let Some(error) = user_error(model) {
            return Err(OffscreenError(error));
        }
        tell(Doing::Mapping);
        let changes = model.refresh(false);
        if let Some(error) = user_error(model) {
            return Err(OffscreenError(error));
        }
        if is_complete(model) {
            return Ok(());
        }
        if is_waiting && changes == Changes::default() && !model.is_pending() {
            return Err(OffscreenError(key::no_map().into()));
        }
    }
}

/// Whether the map is the full one, with its whole extension, and the pattern is where it is wanted.
pub fn is_complete(model: &Model) -> bool {
    let is_home = model.pattern_home() == pattern::home(model.session());
    model.is_ready() && is_home && model.extension_progress() == 1.0
}

fn user_error(model: &Model) -> Option<Message> {
    let surface = |side: Side| &model.surface_side(side).preparation;
    // of a single surface it is clear which one is meant
    let are_two = Side::BOTH.into_iter().all(|side| surface(side).wanted().is_some() || surface(side).error.is_some());
    let of_side = |side| {
        let outline = model.side(side).error.as_ref().map(|user_error| key::about(side, user_error.text.clone()));
        let of_surface = || {
            let text = surface(side).error.as_ref()?.text.clone();
            Some(if are_two { key::about(side, text) } else { text })
        };
        outline.or_else(of_surface)
    };
    let map = model.map_error().map(|(_, text)| text.clone());
    Side::BOTH.into_iter().find_map(of_side).or(map)
}
