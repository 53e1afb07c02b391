//! [`Command`], the only way to change a [`Session`]: what each command touches and how it is applied.

use super::{
    Colouring, Comparison, Holes, OutlineSpec, Session, SidePoints, SideState, SurfaceSpec, TextureKind, Touched,
};
use crate::conformal::{Direction, Extension, InteriorPoint, Marks, Pins, PrepareSettings, Side};
use crate::geometry::{DVec2, PicturePlacement};
use crate::optimization::Dab;
use crate::tiling::TilingPattern;

/// A change of the session.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "each variant without a comment sets what its name says")]
pub enum Command {
    /// Replaces the outline of a side. Its two points return to their defaults, and a surface there is removed.
    SetOutline {
        side: Side,
        outline: OutlineSpec,
    },
    /// Replaces the outline of a side, as [`Self::SetOutline`], and lets pins on it determine the map, in one step.
    PinOutline {
        side: Side,
        outline: OutlineSpec,
        pins: Pins,
    },
    /// Replaces the outline by an edited form of it, with the points carried along. A surface stays.
    ReshapeOutline {
        side: Side,
        outline: OutlineSpec,
        interior: Option<DVec2>,
        anchor: f64,
    },
    SetSettings {
        side: Side,
        settings: PrepareSettings,
    },
    /// Moves the interior point of the outline or of the surface; without a surface the latter changes nothing.
    MoveInterior {
        side: Side,
        point: InteriorPoint,
    },
    /// Moves the boundary point of the side's surface, or else of its outline, to a fraction of the boundary's length.
    MoveAnchor {
        side: Side,
        fraction: f64,
    },
    /// Sets both points. Those of the outline can be set while a surface hides it.
    PlacePoints {
        side: Side,
        points: SidePoints,
    },
    /// Lets boundary pairs determine the map, or the points again. Pins are dropped with the shapes on which they are.
    SetPins(Option<Pins>),
    /// Moves one of the pins, counted from 0, on a side; out of order, or without pins, changes nothing.
    MovePin {
        pin: usize,
        side: Side,
        fraction: f64,
    },
    /// Replaces the painted region of the source. Numbers are rounded to those that a link holds; an exchange of the sides
    /// drops it, while another shape leaves it as it is.
    SetRegion(Vec<Dab>),
    /// Sets the four marks of a side's outline, as fractions of the boundary's length, or removes them. Another shape leaves
    /// them where they are.
    SetMarks {
        side: Side,
        marks: Option<[f64; 4]>,
    },
    /// Moves one of the marks, counted from 0; without marks, or out of a good order, changes nothing.
    MoveMark {
        mark: usize,
        side: Side,
        fraction: f64,
    },
    /// Shows a surface instead of the outline. If the side has the same surface at another resolution or with other
    /// settings, the points stay; the interior point is reset if the triangles change.
    SetSurface {
        side: Side,
        surface: SurfaceSpec,
    },
    /// Rediscretizes the side's surface: other settings or, for a built-in surface, another number of boundary
    /// vertices. A different surface changes nothing.
    RefineSurface {
        side: Side,
        surface: SurfaceSpec,
    },
    /// Sets what is painted of the filled holes of the side's surface; without one, changes nothing.
    SetHoles {
        side: Side,
        holes: Holes,
    },
    /// Removes the surface; the outline is shown again.
    CloseSurface(Side),
    SetDirection(Direction),
    SetExtension(Extension),
    SetTexture(TextureKind),
    SetTextureScale(f64),
    SetTextureSide(Side),
    /// Moves, scales and turns the image, within the limits.
    PlacePicture(PicturePlacement),
    /// Sets the tiling of [`TextureKind::Tiling`].
    SetTiling(TilingPattern),
    SetColouring(Colouring),
    SetWireframe(bool),
    SetPlots(bool),
    SetComparison(Comparison),
    /// Shows the symmetries of the outlines, which then catch dragged points.
    SetSymmetries(bool),
    /// Exchanges source and target.
    Swap,
    /// Makes the target the source too, with its points: a chain of maps goes on from there once another target is chosen.
    Continue,
    /// Replaces the whole session.
    Open(Box<Session>),
}

impl Command {
    /// The parts that the command is meant to change in any session; locks ask this. Points carried along by a
    /// reshaped outline or a refined surface do not count as touched: the model keeps a point at its place in space.
    /// [`Session::touched_by`] says where the session alone cannot.
    pub fn touches(&self) -> Touched {
        match self {
            Self::SetOutline { .. } | Self::PinOutline { .. } | Self::SetSurface { .. } | Self::Continue => {
                Touched::ANOTHER_SHAPE
            }
            Self::CloseSurface(_) => Touched::SHAPES | Touched::POINTS,
            Self::ReshapeOutline { .. } => Touched::SHAPES, // its points are carried along
            Self::Swap => Touched::SHAPES | Touched::POINTS | Touched::SETTINGS,
            Self::MoveInterior { .. } => Touched::INTERIOR,
            Self::MoveAnchor { .. } => Touched::BOUNDARY,
            Self::PlacePoints { .. } | Self::SetPins(_) | Self::MovePin { .. } => Touched::POINTS,
            Self::SetSettings { .. } | Self::RefineSurface { .. } | Self::SetDirection(_) | Self::SetExtension(_) => {
                Touched::SETTINGS
            }
            Self::SetTexture(_)
            | Self::SetTextureScale(_)
            | Self::SetTextureSide(_)
            | Self::PlacePicture(_)
            | Self::SetTiling(_) => Touched::PATTERN,
            Self::SetColouring(_) | Self::SetWireframe(_) | Self::SetHoles { .. } => Touched::COLOURS,
            Self::SetPlots(_) => Touched::PLOTS,
            Self::SetComparison(_)
            | Self::SetRegion(_)
            | Self::SetMarks { .. }
            | Self::MoveMark { .. }
            | Self::SetSymmetries(_) => Touched::COMPARISON,
            Self::Open(_) => Touched::EVERYTHING,
        }
    }
}

impl Session {
    /// The parts that a command would touch in this session: [`Command::touches`]; [`Touched::NOTHING`] if it needs a
    /// surface that the side does not have; the interior point too if it refines a surface with a point set, whose
    /// triangle is replaced; the comparison too if it drops the region painted on the source.
    pub fn touched_by(&self, command: &Command) -> Touched {
        if !self.has_object_of(command) {
            return Touched::NOTHING;
        }
        let drops_point = matches!(command, Command::RefineSurface { side, surface }
            if self.surface(*side).is_some_and(|there| there.point.is_some() && there.spec.shape != surface.shape));
        let drops_region = !self.region.is_empty()
            && matches!(command, Command::Swap | Command::Continue | Command::PinOutline { side: Side::Source, .. });
        let dropped = [(drops_point, Touched::INTERIOR), (drops_region, Touched::COMPARISON)];
        dropped.into_iter().filter(|(drops, _)| *drops).fold(command.touches(), |all, (_, part)| all | part)
    }

    /// Applies a command and returns what it touched: [`Self::touched_by`] of the session before.
    pub fn apply(&mut self, command: Command) -> Touched {
        let touched = self.touched_by(&command);
        if touched != Touched::NOTHING {
            self.carry_out(command);
        }
        touched
    }

    /// Applies a command whose object exists.
    fn carry_out(&mut self, command: Command) {
        match command {
            Command::SetOutline { side, outline } => self.set_outline(side, outline),
            Command::PinOutline { side, outline, pins } => self.pin_outline(side, outline, pins),
            Command::ReshapeOutline { side, outline, interior, anchor } => {
                self.sides[side].domain.outline = outline;
                self.sides[side].place(SidePoints::Outline { interior, anchor });
            }
            Command::SetSettings { side, settings } => self.sides[side].domain.settings = settings,
            Command::MoveInterior { side, point } => self.sides[side].move_interior(point),
            Command::MoveAnchor { side, fraction } => self.sides[side].move_anchor(fraction),
            Command::PlacePoints { side, points } => self.sides[side].place(points),
            Command::SetPins(pins) => self.pins = pins,
            Command::MovePin { pin, side, fraction } => self.move_pin(pin, side, fraction),
            Command::SetSurface { side, surface } | Command::RefineSurface { side, surface } => {
                self.set_surface(side, surface);
            }
            Command::SetHoles { side, holes } => self.set_holes(side, holes),
            Command::CloseSurface(side) => (self.pins, self.sides[side].surface) = (None, None),
            Command::SetDirection(direction) => self.display.direction = direction,
            Command::SetExtension(extension) => self.display.extension = extension,
            Command::SetTexture(texture) => self.display.texture = texture,
            Command::SetTextureScale(scale) => self.display.texture_scale = scale,
            Command::SetTextureSide(side) => self.display.texture_side = side,
            Command::PlacePicture(placement) => self.display.picture = placement.within_limits(),
            Command::SetTiling(tiling) => self.display.tiling = tiling,
            Command::SetColouring(colouring) => self.display.colouring = colouring,
            Command::SetWireframe(shown) => self.display.wireframe = shown,
            Command::SetPlots(open) => self.display.plots = open,
            Command::SetComparison(comparison) => self.display.comparison = comparison,
            Command::SetRegion(region) => self.region = region.into_iter().map(Dab::rounded).collect(),
            Command::SetMarks { side, marks } => self.marks[side] = marks,
            Command::MoveMark { mark, side, fraction } => self.marks[side] = self.with_mark_at(mark, side, fraction),
            Command::SetSymmetries(shown) => self.display.symmetries = shown,
            Command::Swap => self.swap(),
            Command::Continue => self.go_on_from_target(),
            Command::Open(session) => *self = *session,
        }
    }

    fn set_outline(&mut self, side: Side, outline: OutlineSpec) {
        let settings = self.sides[side].domain.settings;
        let anchor = outline.first_anchor();
        self.pins = None;
        self.sides[side] = SideState::new(outline, settings);
        self.sides[side].place(SidePoints::Outline { interior: None, anchor });
    }

    fn pin_outline(&mut self, side: Side, outline: OutlineSpec, pins: Pins) {
        self.set_outline(side, outline);
        self.pins = Some(pins);
        if side == Side::Source {
            self.region.clear();
        }
    }

    fn move_pin(&mut self, pin: usize, side: Side, fraction: f64) {
        self.pins = self.pins.take().map(|pins| pins.moved(pin, side, fraction).unwrap_or(pins));
    }

    fn set_surface(&mut self, side: Side, surface: SurfaceSpec) {
        let is_like = self.surface(side).is_some_and(|old| old.spec.is_like(&surface));
        self.pins = self.pins.take().filter(|_| is_like);
        self.sides[side].set_surface(surface);
    }

    fn set_holes(&mut self, side: Side, holes: Holes) {
        self.sides[side].surface.iter_mut().for_each(|surface| surface.holes = holes);
    }

    fn swap(&mut self) {
        self.sides.swap();
        self.marks.swap();
        self.region.clear();
        self.pins = self.pins.as_ref().map(Pins::exchanged);
    }

    fn go_on_from_target(&mut self) {
        self.sides.source = self.sides.target.clone();
        self.marks.source = self.marks.target;
        self.pins = None;
        self.region.clear();
    }

    /// A side's marks with one of them at another place; `None` without it, or where their order was good and is not then.
    fn with_mark_at(&self, mark: usize, side: Side, fraction: f64) -> Option<[f64; 4]> {
        let old = self.marks[side]?;
        let mut new = old;
        *new.get_mut(mark)? = fraction.rem_euclid(1.0);
        (Marks::new(new).is_ok() || Marks::new(old).is_err()).then_some(new)
    }

    /// Whether the object that the command needs exists: a surface, pins, marks; true for commands that need none.
    fn has_object_of(&self, command: &Command) -> bool {
        match command {
            Command::MoveInterior { side, point: InteriorPoint::Surface(_) }
            | Command::PlacePoints { side, points: SidePoints::Surface { .. } }
            | Command::SetHoles { side, .. }
            | Command::CloseSurface(side) => self.surface(*side).is_some(),
            Command::MovePin { pin, side, fraction } => {
                self.pins.as_ref().is_some_and(|pins| pins.moved(*pin, *side, *fraction).is_ok())
            }
            Command::MoveMark { mark, side, fraction } => self.with_mark_at(*mark, *side, *fraction).is_some(),
            Command::RefineSurface { side, surface } => {
                self.surface(*side).is_some_and(|there| there.spec.is_like(surface))
            }
            _ => true,
        }
    }
}
