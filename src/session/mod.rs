//! All settings of the app, and the commands that change them.
//!
//! A [`Session`] holds two sides and the settings of the map and its display. Its fields are read by
//! accessors; [`Session::apply`] is the only way to change it, and returns what was [`Touched`].
//! A session is plain data: links ([`link`]) and files ([`mod@file`]) store it, lessons ([`lesson`]) order several.

mod command;
#[cfg(feature = "io")]
pub mod file;
mod history;
#[cfg(feature = "io")]
pub mod lesson;
mod limits;
#[cfg(feature = "io")]
pub mod link;
mod outline;
mod side;
mod surface;
mod touched;
mod view;

pub use command::Command;
pub use history::History;
pub use limits::{CELLS, GROWTH, OutOfRange, Quantity, SAMPLES, SURFACE_BOUNDARY};
pub use outline::{DomainSpec, OutlineSpec};
pub use side::{SidePoints, SideState};
pub use surface::{Holes, SurfaceShape, SurfaceSpec, SurfaceState};
pub use touched::Touched;
use view::Display;
pub use view::{Colouring, Comparison, DiskWay, TextureKind};

use crate::conformal::{
    Constraints, Direction, Extension, KernelMode, MapSettings, PerSide, Pins, PrepareSettings, Side,
};
use crate::geometry::{DVec2, PicturePlacement};
use crate::mesh::Sizing;
use crate::optimization::Dab;
use crate::outline::{Preset, Sampling};
use crate::tiling::{TilingPattern, TilingStyle};

/// The settings stored in a link or a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Session {
    sides: PerSide<SideState>,
    display: Display,
    /// The boundary pairs that determine the map; the points of both sides then follow from them.
    pins: Option<Pins>,
    /// The region of the source that was painted: disks in the plane or balls in space, whose union it is.
    region: Vec<Dab>,
    /// The corners of the quadrilaterals, as fractions of the boundaries' lengths.
    marks: PerSide<Option<[f64; 4]>>,
}

/// Boundary samples of the default session: enough for the checkerboard's lines to look smooth on a screen.
const DEFAULT_SAMPLES: u32 = 700;
/// Growth of the triangle size per distance from the boundary in the default session, for the same reason.
const DEFAULT_GROWTH: f64 = 0.1;

impl Default for Session {
    fn default() -> Self {
        let settings = PrepareSettings {
            sampling: Sampling::Adaptive { target: Some(DEFAULT_SAMPLES) },
            sizing: Sizing::Graded(DEFAULT_GROWTH),
            kernel: KernelMode::Integral,
            ..PrepareSettings::default()
        };
        let side = |preset| SideState::new(OutlineSpec::Preset(preset), settings);
        let sides = PerSide::new(side(Preset::Gingerbread), side(Preset::Heart));
        Self { sides, display: Display::default(), pins: None, region: Vec::new(), marks: PerSide::default() }
    }
}

impl Session {
    /// The default session with `commands` applied in order.
    pub fn with(commands: impl IntoIterator<Item = Command>) -> Self {
        Self::default().and(commands)
    }

    /// This session with `commands` applied in order.
    #[must_use]
    pub fn and(mut self, commands: impl IntoIterator<Item = Command>) -> Self {
        for command in commands {
            self.apply(command);
        }
        self
    }

    /// The map and display settings of this session with the sides of `other`, without pins.
    #[must_use]
    pub fn over_sides_of(&self, other: &Self) -> Self {
        Self { sides: other.sides.clone(), pins: None, ..self.clone() }
    }

    /// Both sides.
    pub fn sides(&self) -> &PerSide<SideState> {
        &self.sides
    }

    /// One side: outline, surface, and the points of each.
    pub fn side(&self, side: Side) -> &SideState {
        &self.sides[side]
    }

    /// The outline of a side and how it is discretized, also while a surface hides it.
    pub fn domain(&self, side: Side) -> &DomainSpec {
        &self.sides[side].domain
    }

    /// The surface shown instead of a side's outline.
    pub fn surface(&self, side: Side) -> Option<&SurfaceState> {
        self.sides[side].surface.as_ref()
    }

    /// The boundary pairs that determine the map; `None`: the points do. With pins, the points are those that the map
    /// through them was last found with.
    pub fn pins(&self) -> Option<&Pins> {
        self.pins.as_ref()
    }

    /// Whether the two sessions differ at most in points that follow from the same pins.
    pub(crate) fn is_same_choice(&self, other: &Self) -> bool {
        let points = |side| Command::PlacePoints { side, points: self.side(side).points() };
        self == other || self.pins.is_some() && *self == other.clone().and(Side::BOTH.map(points))
    }

    /// Which side's mesh is mapped.
    pub fn direction(&self) -> Direction {
        self.display.direction
    }

    /// How the boundary map is extended into the interior.
    pub fn extension(&self) -> Extension {
        self.display.extension
    }

    /// The texture's pattern.
    pub fn texture(&self) -> TextureKind {
        self.display.texture
    }

    /// Cells of the pattern across its domain; a third of the rays of [`TextureKind::Conformal`].
    pub fn texture_scale(&self) -> f64 {
        self.display.texture_scale
    }

    /// The side on which the pattern is defined: it is pushed forward from the source or pulled back from the target.
    pub fn texture_side(&self) -> Side {
        self.display.texture_side
    }

    /// The region of the source that was painted, as dabs of a brush; empty unless there is one.
    pub fn region(&self) -> &[Dab] {
        &self.region
    }

    /// The four marks that make a quadrilateral of a side's outline, as fractions of the boundary's length.
    pub fn marks(&self, side: Side) -> Option<[f64; 4]> {
        self.marks[side]
    }

    /// Whether a side has marks.
    pub fn has_marks(&self) -> bool {
        self.marks.iter().any(|(_, marks)| marks.is_some())
    }

    /// Where the image lies, relative to the domain of its side.
    pub fn picture(&self) -> PicturePlacement {
        self.display.picture
    }

    /// The tiling of [`TextureKind::Tiling`].
    pub fn tiling(&self) -> TilingPattern {
        self.display.tiling
    }

    /// Whether the texture consists of the own picture: as it is, or in the tiles of a tiling.
    pub fn shows_picture(&self) -> bool {
        match self.texture() {
            TextureKind::Image => true,
            TextureKind::Tiling => self.tiling().style == TilingStyle::Picture,
            _ => false,
        }
    }

    /// The command that makes the own picture the texture, or puts it into the tiles where a tiling is shown.
    pub fn to_show_picture(&self) -> Command {
        match self.texture() {
            TextureKind::Tiling => Command::SetTiling(TilingPattern { style: TilingStyle::Picture, ..self.tiling() }),
            _ => Command::SetTexture(TextureKind::Image),
        }
    }

    /// What the triangles are colored by.
    pub fn colouring(&self) -> Colouring {
        self.display.colouring
    }

    /// Whether the edges of the mapped mesh are drawn, on both sides.
    pub fn wireframe(&self) -> bool {
        self.display.wireframe
    }

    /// Whether the plots are open.
    pub fn plots(&self) -> bool {
        self.display.plots
    }

    /// The methods that the map is compared with.
    pub fn comparison(&self) -> Comparison {
        self.display.comparison
    }

    /// Whether the symmetries of the outlines are drawn, and catch dragged points.
    pub fn symmetries(&self) -> bool {
        self.display.symmetries
    }

    /// The number of points of its loaded outlines.
    pub fn loaded_points(&self) -> usize {
        self.sides.iter().map(|(_, side)| side.domain.outline.loaded_points()).sum()
    }

    /// This session with another outline on a side; its points and its surface stay.
    #[cfg(feature = "io")]
    #[must_use]
    pub(crate) fn with_outline(mut self, side: Side, outline: OutlineSpec) -> Self {
        self.sides[side].domain.outline = outline;
        self
    }

    /// Gives the files that its surfaces come from other names.
    pub(crate) fn rename_surface_files(&mut self, name: &dyn Fn(&str) -> String) {
        for side in Side::BOTH {
            if let Some(SurfaceState { spec: SurfaceSpec { shape: SurfaceShape::File { name: old }, .. }, .. }) =
                &mut self.sides[side].surface
            {
                *old = name(old);
            }
        }
    }

    /// The names of the files that its surfaces come from.
    pub fn surface_files(&self) -> impl Iterator<Item = &str> {
        self.sides.iter().filter_map(|(_, side)| match &side.surface.as_ref()?.spec.shape {
            SurfaceShape::File { name } => Some(name.as_str()),
            SurfaceShape::Preset { .. } => None,
        })
    }

    /// The constraints between the two outlines. `poles` replace interior points that are not set.
    pub fn constraints(&self, poles: PerSide<DVec2>) -> Constraints {
        let at = |side: Side| {
            let SideState { interior, anchor, .. } = &self.sides[side];
            (interior.unwrap_or(poles[side]), *anchor)
        };
        Constraints::new(at(Side::Source), at(Side::Target))
    }

    /// The settings from which the map is computed.
    pub fn map_settings(&self) -> MapSettings {
        MapSettings { direction: self.display.direction, extension: self.display.extension }
    }
}

/// The same session with finite elements in place of the boundary integral, as sessions were before there was one.
#[cfg(test)]
pub(crate) fn by_finite_elements(session: Session) -> Session {
    let of_integral = Side::BOTH.map(|side| (side, session.domain(side).settings));
    let of_integral = of_integral.into_iter().filter(|(_, settings)| settings.kernel == KernelMode::Integral);
    session.and(
        of_integral
            .map(|(side, settings)| Command::SetSettings { side, settings: settings.with_kernel(KernelMode::Adjoint) }),
    )
}

/// The default session with another texture scale, by which tests tell sessions apart.
#[cfg(test)]
pub(crate) fn scaled(scale: f64) -> Session {
    Session::with([Command::SetTextureScale(scale)])
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
