//! Everything that a person can set, and the commands that set it.
//!
//! The UI emits [`Command`]s; [`Session::apply`] is the only door to a change.
//! A session is small and plain: it is what links ([`link`]) and files ([`mod@file`]) carry.

pub mod file;
mod history;
mod limits;
pub mod link;
mod surface;

pub use history::History;
pub use limits::{CELLS, GROWTH, OutOfRange, SAMPLES, SURFACE_BOUNDARY};
pub use surface::{SurfaceShape, SurfaceSpec, SurfaceState};

use crate::conformal::{Constraints, Direction, Extension, MapSettings, PrepareSettings, Side};
use crate::geometry::{DVec2, PolygonError, SimplePolygon};
use crate::mesh::{BarycentricPoint, Sizing};
use crate::outline::{Preset, Sampling};

/// Where a domain's outline comes from.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum OutlineSpec {
    /// A built-in outline.
    Preset(Preset),
    /// A loaded one.
    Points {
        /// Its name.
        name: String,
        /// Its vertices, a valid simple polygon.
        points: Vec<DVec2>,
    },
}

impl OutlineSpec {
    /// The outline as a polygon. Errors: loaded points that are not a simple polygon.
    pub fn polygon(&self) -> Result<SimplePolygon, PolygonError> {
        match self {
            Self::Preset(preset) => Ok(preset.outline().polygon),
            Self::Points { points, .. } => SimplePolygon::try_from(points.clone()),
        }
    }
}

/// One side of the session.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct DomainSpec {
    /// The outline.
    pub outline: OutlineSpec,
    /// How it is discretised.
    pub settings: PrepareSettings,
}

/// The pattern drawn on one side and carried by the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TextureKind {
    /// A checkerboard with a vertical change of hue.
    #[default]
    Checker,
    /// Lines.
    Grid,
    /// Circles and rays about the interior point.
    Polar,
    /// The same in the disk: level sets of Green's function and of harmonic measure.
    Conformal,
    /// The user's own image.
    Image,
}

/// What the meshes are painted with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Colouring {
    /// The pattern that the map carries.
    #[default]
    Texture,
    /// The angle distortion Q = σ₁/σ₂ of every triangle.
    Angle,
    /// The area distortion log₂(σ₁σ₂) of every triangle.
    Area,
}

/// The ways that are shown beside the map: through the disk (sections 1.2 and 5.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Comparison {
    /// None.
    #[default]
    Off,
    /// Disk maps made for the present interior points.
    Fresh,
    /// Disk maps made for the poles of inaccessibility, then Möbius.
    Precomputed,
    /// Both of these.
    Both,
}

/// A way through the disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiskWay {
    /// As [`Comparison::Fresh`].
    Fresh,
    /// As [`Comparison::Precomputed`].
    Precomputed,
}

impl DiskWay {
    /// Both, in the order in which they are listed.
    pub const ALL: [Self; 2] = [Self::Fresh, Self::Precomputed];
}

impl Comparison {
    /// Whether it shows this way.
    pub fn shows(self, way: DiskWay) -> bool {
        match self {
            Self::Off => false,
            Self::Fresh => way == DiskWay::Fresh,
            Self::Precomputed => way == DiskWay::Precomputed,
            Self::Both => true,
        }
    }
}

/// The state of the app that a link or a file carries.
///
/// `interior` and `anchor` are `None` until they are set: the pole of
/// inaccessibility and the outline's first point.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Session {
    /// Format version, 1.
    pub version: u32,
    /// Ω₁.
    pub source: DomainSpec,
    /// Ω₂.
    pub target: DomainSpec,
    /// `x₁, x₂`.
    pub interior: [Option<DVec2>; 2],
    /// `y₁, y₂`, as fractions of arc length.
    pub anchor: [f64; 2],
    /// Which mesh is mapped.
    pub direction: Direction,
    /// How the boundary map is extended into it.
    pub extension: Extension,
    /// The pattern.
    pub texture: TextureKind,
    /// Cells of the pattern across its domain; a third of the rays of [`TextureKind::Conformal`].
    pub texture_scale: f64,
    /// Where the pattern lives: it is pushed forward from the source or pulled back from the target.
    #[serde(default = "source")]
    pub texture_side: Side,
    /// What the meshes are painted with.
    #[serde(default)]
    pub colouring: Colouring,
    /// Whether the mapped mesh's edges are drawn, on both sides.
    #[serde(default)]
    pub wireframe: bool,
    /// Whether the plots are open.
    #[serde(default)]
    pub plots: bool,
    /// What the map is compared with.
    #[serde(default)]
    pub comparison: Comparison,
    /// The surface in the target's place; the target's outline waits behind it.
    #[serde(default)]
    pub surface: Option<SurfaceState>,
}

fn source() -> Side {
    Side::Source
}

/// A change that a person makes.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "each variant sets the session's field of that name")]
pub enum Command {
    SetOutline {
        side: Side,
        outline: OutlineSpec,
    },
    /// Puts another form of the outline in its place; the side's two points go along.
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
    MoveInterior {
        side: Side,
        point: DVec2,
    },
    MoveAnchor {
        side: Side,
        fraction: f64,
    },
    SetDirection(Direction),
    SetExtension(Extension),
    SetTexture(TextureKind),
    SetTextureScale(f64),
    SetTextureSide(Side),
    SetColouring(Colouring),
    SetWireframe(bool),
    SetPlots(bool),
    SetComparison(Comparison),
    /// Puts a surface in the target's place.
    SetSurface(SurfaceSpec),
    /// Discretises the surface that is there in another way: other settings, or another number of boundary vertices of
    /// one by formula. Another surface changes nothing.
    RefineSurface(SurfaceSpec),
    /// Moves the surface's interior point.
    MoveSurfacePoint(BarycentricPoint),
    /// Moves the point of the surface's boundary loop, to a fraction of its length.
    MoveSurfaceAnchor(f64),
    /// Takes the surface away: the target's outline is there again.
    CloseSurface,
    /// Exchanges source and target.
    Swap,
    /// Takes another session in place of this one.
    Open(Box<Session>),
}

impl Command {
    /// Whether another outline, surface or session takes the place of what is shown.
    pub fn replaces_shapes(&self) -> bool {
        matches!(self, Self::SetOutline { .. } | Self::SetSurface(_) | Self::Open(_))
    }

    /// Whether a point is put elsewhere, and nothing else changes.
    pub fn moves_points(&self) -> bool {
        matches!(
            self,
            Self::MoveInterior { .. }
                | Self::MoveAnchor { .. }
                | Self::MoveSurfacePoint(_)
                | Self::MoveSurfaceAnchor(_)
        )
    }
}

/// Boundary samples of the first map: enough for the checkerboard's lines to look smooth on a screen.
const DEFAULT_SAMPLES: u32 = 700;
/// Growth of its triangles per distance from the boundary, for the same reason.
const DEFAULT_GROWTH: f64 = 0.1;

impl Default for Session {
    fn default() -> Self {
        let settings = PrepareSettings {
            sampling: Sampling::Adaptive { target: Some(DEFAULT_SAMPLES) },
            sizing: Sizing::Graded(DEFAULT_GROWTH),
            ..PrepareSettings::default()
        };
        let domain = |preset| DomainSpec { outline: OutlineSpec::Preset(preset), settings };
        Self {
            version: 1,
            source: domain(Preset::Gingerbread),
            target: domain(Preset::Heart),
            interior: [None, None],
            anchor: [0.0, 0.0],
            direction: Direction::default(),
            extension: Extension::default(),
            texture: TextureKind::default(),
            texture_scale: 8.0,
            texture_side: source(),
            colouring: Colouring::default(),
            wireframe: false,
            plots: false,
            comparison: Comparison::default(),
            surface: None,
        }
    }
}

impl Session {
    /// One side.
    pub fn domain(&self, side: Side) -> &DomainSpec {
        match side {
            Side::Source => &self.source,
            Side::Target => &self.target,
        }
    }

    /// How many points of loaded outlines it holds.
    pub fn loaded_points(&self) -> usize {
        let of_domain = |domain: &DomainSpec| match &domain.outline {
            OutlineSpec::Preset(_) => 0,
            OutlineSpec::Points { points, .. } => points.len(),
        };
        of_domain(&self.source) + of_domain(&self.target)
    }

    /// Carries out a command. A new outline resets that side's two points, and one for the target
    /// takes a surface's place; a new surface has points of its own.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::SetOutline { side, outline } => {
                self.domain_mut(side).outline = outline;
                self.interior[side as usize] = None;
                self.anchor[side as usize] = 0.0;
                self.surface = self.surface.take().filter(|_| side == Side::Source);
            }
            Command::ReshapeOutline { side, outline, interior, anchor } => {
                self.domain_mut(side).outline = outline;
                self.interior[side as usize] = interior;
                self.apply(Command::MoveAnchor { side, fraction: anchor });
            }
            Command::SetSurface(spec) => {
                let mut old = self.surface.take().filter(|old| old.spec.shape.is_like(&spec.shape)).unwrap_or_default();
                if old.spec.shape != spec.shape {
                    old.point = None; // its triangles are others
                }
                self.surface = Some(SurfaceState { spec, ..old });
            }
            Command::RefineSurface(spec) => {
                if self.surface.as_ref().is_some_and(|there| there.spec.is_like(&spec)) {
                    self.apply(Command::SetSurface(spec));
                }
            }
            Command::MoveSurfacePoint(point) => {
                if let Some(surface) = &mut self.surface {
                    surface.point = Some(point);
                }
            }
            Command::MoveSurfaceAnchor(fraction) => {
                if let Some(surface) = self.surface.as_mut().filter(|_| fraction.is_finite()) {
                    surface.anchor = fraction.rem_euclid(1.0);
                }
            }
            Command::CloseSurface => self.surface = None,
            Command::SetSettings { side, settings } => self.domain_mut(side).settings = settings,
            Command::MoveInterior { side, point } => self.interior[side as usize] = Some(point),
            Command::MoveAnchor { side, fraction } => {
                if fraction.is_finite() {
                    self.anchor[side as usize] = fraction.rem_euclid(1.0);
                }
            }
            Command::SetDirection(direction) => self.direction = direction,
            Command::SetExtension(extension) => self.extension = extension,
            Command::SetTexture(texture) => self.texture = texture,
            Command::SetTextureScale(scale) => self.texture_scale = scale,
            Command::SetTextureSide(side) => self.texture_side = side,
            Command::SetColouring(colouring) => self.colouring = colouring,
            Command::SetWireframe(shown) => self.wireframe = shown,
            Command::SetPlots(open) => self.plots = open,
            Command::Open(session) => *self = *session,
            Command::SetComparison(comparison) => self.comparison = comparison,
            Command::Swap => {
                std::mem::swap(&mut self.source, &mut self.target);
                self.interior.swap(0, 1);
                self.anchor.swap(0, 1);
            }
        }
    }

    /// The constraints, with the domains' poles where no interior point is set.
    pub fn constraints(&self, poles: [DVec2; 2]) -> Constraints {
        Constraints {
            source_point: self.interior[0].unwrap_or(poles[0]),
            target_point: self.interior[1].unwrap_or(poles[1]),
            source_anchor: self.anchor[0],
            target_anchor: self.anchor[1],
        }
    }

    /// How the map is made from the constraints.
    pub fn map_settings(&self) -> MapSettings {
        MapSettings { direction: self.direction, extension: self.extension }
    }

    fn domain_mut(&mut self, side: Side) -> &mut DomainSpec {
        match side {
            Side::Source => &mut self.source,
            Side::Target => &mut self.target,
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
