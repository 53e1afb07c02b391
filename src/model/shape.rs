//! The outline or surface of a side, for titles and descriptions; the built-in outlines and surfaces for the menus.

use crate::conformal::Side;
use crate::language::Message;
use crate::model::Model;
use crate::outline::Preset;
use crate::session::{Command, DomainSpec, OutlineSpec, Session, SurfaceShape, SurfaceSpec, SurfaceState};
use crate::surface::SurfacePreset;

/// The outline or the surface of a side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape<'a> {
    /// An outline.
    Outline(&'a DomainSpec),
    /// A surface, which hides the outline.
    Surface(&'a SurfaceState),
}

impl<'a> Shape<'a> {
    /// The shape of this side.
    pub fn of(session: &'a Session, side: Side) -> Self {
        session.surface(side).map_or(Self::Outline(session.domain(side)), Self::Surface)
    }
}

/// A built-in outline or surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PresetShape {
    /// An outline.
    Outline(Preset),
    /// A surface.
    Surface(SurfacePreset),
}

impl PresetShape {
    /// The command that sets it as the shape of a side.
    pub fn command(self, side: Side) -> Command {
        match self {
            Self::Outline(preset) => Command::SetOutline { side, outline: OutlineSpec::Preset(preset) },
            Self::Surface(preset) => Command::SetSurface {
                side,
                surface: SurfaceSpec { shape: SurfaceShape::preset(preset), ..SurfaceSpec::default() },
            },
        }
    }
}

impl Model {
    /// The shape of a side in the session.
    pub fn shape(&self, side: Side) -> Shape<'_> {
        Shape::of(&self.session, side)
    }

    /// The requested shape of a side, which may still be prepared; `None` if it is not a preset.
    pub fn requested_preset(&self, side: Side) -> Option<PresetShape> {
        let preparation = &self.sides[side].surface.preparation;
        let has_surface = self.session.surface(side).is_some() || preparation.is_busy();
        match (preparation.wanted().filter(|_| has_surface), &self.side(side).wanted().outline) {
            (Some(SurfaceSpec { shape: SurfaceShape::Preset { preset, .. }, .. }), _) => {
                Some(PresetShape::Surface(*preset))
            }
            (Some(SurfaceSpec { shape: SurfaceShape::File { .. }, .. }), _) | (None, OutlineSpec::Points { .. }) => {
                None
            }
            (None, OutlineSpec::Preset(preset)) => Some(PresetShape::Outline(*preset)),
        }
    }

    /// The coordinates of a side's interior point, two of an outline and three of a surface, once it is drawn.
    pub fn coordinates(&self, side: Side) -> Option<Vec<f64>> {
        match self.shape(side) {
            Shape::Outline(_) => Some(self.interior(side)?.to_array().to_vec()),
            Shape::Surface(_) => Some(self.surface_point(side)?.to_array().to_vec()),
        }
    }

    /// The reader's notes on the file or text that a side's shape was read from.
    pub fn notes_on_shape(&self, side: Side) -> Vec<Message> {
        match self.shape(side) {
            Shape::Outline(_) => self.side(side).notes.clone(),
            Shape::Surface(_) => self.surface_notes(side),
        }
    }
}
