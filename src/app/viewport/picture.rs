//! The picture of a side, of a plane or of a surface in space: gestures, drawing, dots.
//!
//! Drawing and gestures distinguish the two kinds of viewport here only.

use super::surface::OrbitView;
use super::view::{Margins, View};
use super::{best, pictures::Pictures, planar, surface};
use crate::app::input::action::Actions;
use crate::app::input::handles::{HandleState, Places};
use crate::conformal::Side;
use crate::model::Model;
use crate::render::{CellStyle, OrbitCamera, Pace, TextureStyle};
use egui::{Pos2, Rect, Ui};

/// What differs between the two kinds of viewport: their cameras, by reference to draw and by mutable reference to
/// handle gestures, or what the renderer needs of them.
pub enum Picture<P, S> {
    /// A plane.
    Plane(P),
    /// A surface in space.
    Space(S),
}

impl Pictures {
    /// The picture of a side: planar for an outline, in space for a surface.
    pub fn of(&self, model: &Model, side: Side) -> Picture<&View, &OrbitView> {
        match model.surface(side) {
            Some(_) => Picture::Space(&self.orbits[side]),
            None => Picture::Plane(&self.views[side]),
        }
    }

    /// As [`Self::of`], to be moved.
    pub fn of_mut(&mut self, model: &Model, side: Side) -> Picture<&mut View, &mut OrbitView> {
        match model.surface(side) {
            Some(_) => Picture::Space(&mut self.orbits[side]),
            None => Picture::Plane(&mut self.views[side]),
        }
    }
}

/// When a camera shows a new shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Seen {
    /// In this frame: the view is already placed.
    Now,
    /// In the next frame, when the view is placed.
    InNextFrame,
}

impl Pictures {
    /// Places the viewport of a side; a camera that is fitted shows the whole outline or surface.
    pub fn place(&mut self, model: &Model, side: Side, rect: Rect, pixels_per_point: f32, margins: Margins) {
        let seen = self.uv.seen(model, side, model.extent(side));
        let view = &mut self.views[side];
        view.place(rect, pixels_per_point, self.uv.margins(model, side, margins), seen);
        if let Some(scene) = model.surface(side).and_then(|(surface, _)| surface.scene()) {
            self.orbits[side].place(view.rect, pixels_per_point, margins, scene);
        }
    }

    /// Chooses the camera for a new shape on a side: an outline is fitted, a surface is seen so that most of it is
    /// visible.
    pub fn look_at_new(&mut self, model: &Model, side: Side) -> Seen {
        self.views[side].fit();
        let Some((surface, state)) = model.surface(side) else { return Seen::InNextFrame };
        let orbit = &mut self.orbits[side];
        if let Some(camera) = surface.first_view(state, orbit.aspect()) {
            orbit.look(camera);
        }
        Seen::Now
    }

    /// The camera of a side's surface on the screen, in a viewport with this ratio of width to height.
    pub fn camera(&self, model: &Model, side: Side, aspect: f64) -> Option<OrbitCamera> {
        let scene = model.surface(side)?.0.scene()?;
        let orbit = &self.orbits[side];
        let mut camera = *orbit.camera()?;
        if orbit.is_fitted() {
            camera.fit(scene, aspect);
        }
        Some(camera)
    }
}

impl Picture<&mut View, &mut OrbitView> {
    /// Fits the view to the whole domain or surface.
    pub fn fit(self) {
        match self {
            Self::Plane(view) => view.fit(),
            Self::Space(orbit) => orbit.fit(),
        }
    }

    /// Turns gestures into actions and moves of the camera. Returns the boundary point under the pointer, as a fraction
    /// of the boundary's length.
    pub fn interact(
        self,
        ui: &mut Ui,
        side: Side,
        model: &Model,
        handles: &mut HandleState,
        actions: &mut Actions,
    ) -> Option<f64> {
        match self {
            Self::Plane(view) => planar::interact(ui, side, model, view, handles, actions),
            Self::Space(orbit) => surface::viewport::interact(ui, side, model, orbit, handles, actions),
        }
    }
}

impl Picture<&View, &OrbitView> {
    /// Whether the view is fitted to the whole domain or surface.
    pub fn is_fitted(&self) -> bool {
        match self {
            Self::Plane(view) => view.is_fitted(),
            Self::Space(orbit) => orbit.is_fitted(),
        }
    }

    /// The positions of the interior point and the boundary point on the screen.
    pub fn places_of_dots(&self, model: &Model, side: Side) -> [Option<Pos2>; 2] {
        match self {
            Self::Plane(view) => [model.interior(side), model.anchor(side)].map(|point| Some(view.to_screen(point?))),
            Self::Space(orbit) => {
                [model.surface_point(side), model.surface_anchor(side)].map(|point| orbit.to_screen(point?))
            }
        }
    }

    /// Where the dots that can be dragged are on the screen: the two points, or the pins.
    pub fn places(&self, model: &Model, side: Side) -> Places {
        match self {
            Self::Plane(view) => planar::places(side, model, view),
            Self::Space(orbit) => surface::viewport::places(side, model, orbit),
        }
    }

    /// Draws the textured mesh. `cells` is the style of a surface's triangles; planar ones have it from the upload.
    pub fn paint(
        &self,
        ui: &Ui,
        (model, side): (&Model, Side),
        style: Option<&TextureStyle>,
        cells: Option<CellStyle>,
        pace: Pace,
    ) {
        let mapped = model.shown().map(|map| map.mapped_side());
        // before the map, the GPU may still hold another surface, or another outline beside a surface
        let style = style.filter(|_| model.has_picture());
        match self {
            Self::Plane(view) => planar::paint_mesh(ui, side, view, style, pace),
            Self::Space(orbit) => {
                let cells = cells.filter(|_| mapped == Some(side));
                surface::viewport::paint_surface(ui, side, orbit, style, cells, pace);
            }
        }
    }

    /// Draws the boundary loops of a surface with several.
    pub fn paint_loops(&self, ui: &Ui, side: Side, model: &Model) {
        if let Self::Space(orbit) = self {
            surface::loops::paint(ui, side, model, orbit);
        }
    }

    /// Draws the landscape over x₁ and the region that was painted.
    pub fn paint_best(&self, ui: &Ui, side: Side, model: &Model) {
        match self {
            Self::Plane(view) => best::paint(ui, side, model, view),
            Self::Space(orbit) => surface::viewport::paint_region(ui, side, model, orbit),
        }
    }

    /// The places of the numbers of a surface's boundary loops on the screen.
    pub fn places_of_loops(&self, model: &Model, side: Side) -> Vec<Pos2> {
        match self {
            Self::Plane(_) => Vec::new(),
            Self::Space(orbit) => surface::loops::places_of_numbers(side, model, orbit),
        }
    }

    /// Draws the mark at a fraction of the boundary's length.
    pub fn paint_boundary_mark(&self, ui: &Ui, side: Side, model: &Model, fraction: f64) {
        match self {
            Self::Plane(view) => planar::paint_boundary_mark(ui, side, model, view, fraction),
            Self::Space(orbit) => surface::viewport::paint_boundary_mark(ui, side, model, orbit, fraction),
        }
    }

    /// Draws the dots, over everything else in the picture.
    pub fn paint_dots(&self, ui: &Ui, side: Side, model: &Model, handles: &HandleState) {
        match self {
            Self::Plane(view) => planar::paint_dots(ui, side, model, view, handles),
            Self::Space(orbit) => surface::viewport::paint_dots(ui, side, model, orbit, handles),
        }
    }
}
