//! A side of a map as it is named on the command line, an outline or a surface: read, prepared, with its points.

use super::CliError;
use super::arguments::{Anchor, Discretisation, NamedOutline, Point, read_outline};
use super::flatten_arguments::{self, SurfaceAnchor, SurfacePoint, preset};
use super::output::{say_solver, warn_if_coarse};
use super::progress::Progress;
use crate::conformal::{
    InteriorPoint, PrepareSettings, PreparedSide, SideGeometry, SurfaceSettings, prepare, prepare_surface,
};
use crate::surface::{Surface, SurfaceMesh, names_format};
use std::str::FromStr;
use std::sync::Arc;

/// An interior point of a side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SidePoint {
    /// Of an outline.
    Plane(Point),
    /// Of a surface.
    Surface(SurfacePoint),
}

impl FromStr for SidePoint {
    type Err = String;

    /// Two numbers are a place in the plane; all else that a surface's point may be is that.
    fn from_str(text: &str) -> Result<Self, String> {
        let planar = text.parse().map(Self::Plane);
        planar.or_else(|error| text.parse().map(Self::Surface).map_err(|_: String| error))
    }
}

/// A boundary point of a side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SideAnchor {
    /// At this fraction of the boundary's length.
    Fraction(f64),
    /// Of an outline.
    Plane(Anchor),
    /// Of a surface.
    Surface(SurfaceAnchor),
}

impl FromStr for SideAnchor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            Ok(Anchor::Fraction(s)) => Ok(Self::Fraction(s)),
            Ok(anchor) => Ok(Self::Plane(anchor)),
            Err(error) => text.parse().map(Self::Surface).map_err(|_: String| error),
        }
    }
}

/// What a side is, as it was read.
pub enum Given {
    /// An outline.
    Outline(NamedOutline),
    /// A surface.
    Surface(Surface),
}

/// A side, prepared.
pub struct NamedSide {
    name: String,
    given: Given,
    pub prepared: Arc<PreparedSide>,
}

/// How sides are read and prepared.
#[derive(Debug, Clone, Copy)]
pub struct Reading<'a> {
    /// Whether to repair what can be.
    pub repair: bool,
    /// Whether a surface's edges are flipped.
    pub intrinsic_delaunay: bool,
    pub discretisation: &'a Discretisation,
}

/// Whether a name means a surface: a preset, or a file by its ending.
pub fn is_surface(name: &str) -> bool {
    preset(name).is_some() || (!name.starts_with("preset:") && names_format(name))
}

/// What is asked of a side: the options of its points, and what they say.
#[derive(Debug, Clone, Copy)]
pub struct Asked<'a> {
    /// The side.
    pub name: &'a str,
    /// The number of boundary samples.
    pub samples: Option<u32>,
    /// The interior point.
    pub point: (&'static str, Option<SidePoint>),
    /// The boundary point.
    pub anchor: (&'static str, SideAnchor),
}

impl Asked<'_> {
    /// Checks that all of it is of the side's kind.
    pub fn check(&self) -> Result<(), CliError> {
        let Self { name, samples, point: (point_option, point), anchor: (anchor_option, anchor) } = *self;
        if let (true, Some(SidePoint::Plane(_))) | (false, Some(SidePoint::Surface(_))) = (is_surface(name), point) {
            return Err(other_point(name, point_option));
        }
        match (is_surface(name), anchor) {
            (true, SideAnchor::Plane(_)) | (false, SideAnchor::Surface(_)) => Err(other_anchor(name, anchor_option)),
            (true, _) if samples.is_some() => Err(CliError::Usage(format!(
                "{name} is a surface: it has its own boundary vertices, and takes no samples"
            ))),
            _ => Ok(()),
        }
    }
}

fn other_point(name: &str, option: &str) -> CliError {
    let meant = if is_surface(name) { "a surface: V, F:A,B,C or X,Y,Z" } else { "an outline: X,Y" };
    CliError::Usage(format!("{option}: {name} is {meant} is meant"))
}

fn other_anchor(name: &str, option: &str) -> CliError {
    let meant = if is_surface(name) { "a surface: V, X,Y,Z or @S" } else { "an outline: X,Y or @S" };
    CliError::Usage(format!("{option}: {name} is {meant} is meant"))
}

/// Reads the side of this name.
pub fn read(name: &str, repair: bool) -> Result<Given, CliError> {
    if is_surface(name) {
        flatten_arguments::read(name).map(Given::Surface)
    } else {
        read_outline(name, repair).map(Given::Outline)
    }
}

impl NamedSide {
    /// Prepares a side that was read.
    pub fn prepare(
        Asked { name, samples, .. }: &Asked<'_>,
        given: Given,
        reading: Reading<'_>,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let about = |error: &dyn std::fmt::Display| CliError::Input(format!("{name}: {error}"));
        let Reading { repair, intrinsic_delaunay, discretisation } = reading;
        let prepared = match &given {
            Given::Surface(surface) => {
                let mesh = if repair { SurfaceMesh::repaired(surface) } else { SurfaceMesh::new(surface) };
                let (kernel, solver) = (discretisation.kernel_mode(), discretisation.solver_kind());
                let settings = SurfaceSettings { intrinsic_delaunay, kernel, solver };
                let mesh = mesh.map_err(|error| about(&error))?;
                prepare_surface(mesh, settings, &mut progress.preparing(name)).map_err(|error| about(&error))?
            }
            Given::Outline(outline) => {
                let settings: PrepareSettings = discretisation.settings(outline, *samples);
                let prepared = prepare(&outline.outline.polygon, &settings, &mut progress.preparing(name));
                prepared.map_err(|error| about(&error))?
            }
        };
        Ok(Self { name: (*name).to_owned(), given, prepared: Arc::new(prepared) })
    }

    /// Its interior point, or the default one, and the fraction of the boundary's length at its boundary point.
    pub fn constraint(&self, asked: &Asked<'_>) -> Result<(InteriorPoint, f64), CliError> {
        let ((point_option, point), (anchor_option, anchor)) = (asked.point, asked.anchor);
        Ok((self.point(point_option, point)?, self.anchor(anchor_option, anchor)?))
    }

    /// The interior point that an `option` says, or the default one.
    fn point(&self, option: &str, point: Option<SidePoint>) -> Result<InteriorPoint, CliError> {
        match (point, self.prepared.geometry(), &self.given) {
            (None, ..) => Ok(self.prepared.default_point()),
            (Some(SidePoint::Plane(point)), SideGeometry::Plane(_), _) => Ok(point.0.into()),
            (Some(SidePoint::Surface(point)), SideGeometry::Space(surface), Given::Surface(given)) => {
                point.locate(option, given, surface).map(Into::into)
            }
            (Some(_), ..) => Err(other_point(&self.name, option)),
        }
    }

    /// The fraction of the boundary's length that an `option` says.
    fn anchor(&self, option: &str, anchor: SideAnchor) -> Result<f64, CliError> {
        match (anchor, self.prepared.geometry()) {
            (SideAnchor::Fraction(s), _) => Ok(s.rem_euclid(1.0)),
            (SideAnchor::Plane(anchor), SideGeometry::Plane(domain)) => Ok(anchor.fraction(domain)),
            (SideAnchor::Surface(anchor), SideGeometry::Space(surface)) => anchor.fraction(option, surface),
            (SideAnchor::Plane(_) | SideAnchor::Surface(_), _) => Err(other_anchor(&self.name, option)),
        }
    }

    /// Says on stderr what was done to what was read, and how it was prepared.
    pub fn say_notes(&self, discretisation: &Discretisation) {
        match &self.given {
            Given::Outline(outline) => outline.say_notes(&self.name),
            Given::Surface(surface) => {
                let repairs = self.prepared.surface().into_iter().flat_map(|meshed| &meshed.surface().repairs);
                let notes = surface.notes.iter().map(ToString::to_string).chain(repairs.map(ToString::to_string));
                notes.for_each(|note| eprintln!("riemap: {}: {note}", self.name));
            }
        }
        warn_if_coarse(&self.name, &self.prepared);
        say_solver(&self.name, discretisation.solver_kind(), self.prepared.solver());
    }
}
