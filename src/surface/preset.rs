//! Surfaces by formula: a planar mesh of a disk or a rectangle, lifted into space.

use super::{Surface, head};
use crate::geometry::{DVec2, DVec3};
use crate::mesh::{MeshError, Sizing, mesh_domain};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt;
use std::str::FromStr;

/// A built-in surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SurfacePreset {
    /// The upper half of the unit sphere.
    Hemisphere,
    /// z = x² + y² over the unit disk.
    Paraboloid,
    /// z = x² − y² over the unit disk.
    Saddle,
    /// A rectangle of 4×1, bent by 200° around a cylinder: flat inside.
    BentStrip,
    /// Half of a torus, its tube slit open.
    HalfTorus,
    /// Bumps over an ellipse, much like a face.
    HeightField,
    /// The head of an animal, open at the neck.
    AnimalHead,
}

impl SurfacePreset {
    /// All presets, in the order of the menus.
    pub const ALL: [Self; 7] = [
        Self::AnimalHead,
        Self::HeightField,
        Self::Hemisphere,
        Self::Paraboloid,
        Self::Saddle,
        Self::BentStrip,
        Self::HalfTorus,
    ];

    /// The usual number of boundary vertices: about 13,000 triangles on a hemisphere.
    pub const USUAL_BOUNDARY: u32 = 250;

    /// The name in `preset:NAME`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hemisphere => "hemisphere",
            Self::Paraboloid => "paraboloid",
            Self::Saddle => "saddle",
            Self::BentStrip => "bent-strip",
            Self::HalfTorus => "half-torus",
            Self::HeightField => "height-field",
            Self::AnimalHead => "animal-head",
        }
    }

    /// A good default view: the direction to the eye, and the direction that is up.
    pub fn view(self) -> [DVec3; 2] {
        match self {
            Self::Hemisphere | Self::Paraboloid | Self::Saddle | Self::HalfTorus => {
                [DVec3::new(0.45, -1.0, 0.75), DVec3::Z]
            }
            Self::BentStrip => [DVec3::new(0.9, -1.3, 0.55), DVec3::Z],
            Self::HeightField => [DVec3::new(0.5, 0.3, 1.0), DVec3::Y],
            Self::AnimalHead => [DVec3::new(0.35, -0.75, 0.35), DVec3::Z],
        }
    }

    /// The surface with about `boundary` vertices along its boundary (at least 12).
    pub fn surface(self, boundary: u32) -> Result<Surface, MeshError> {
        let boundary = self.outline(boundary.max(12));
        let mesh = mesh_domain(&boundary, Sizing::Uniform)?.0;
        let vertices = mesh.vertices().iter().map(|&p| self.lifted(p)).collect();
        Ok(Surface::new(vertices, mesh.into_triangles()))
    }

    /// The boundary of the planar mesh.
    fn outline(self, count: u32) -> Vec<DVec2> {
        match self {
            Self::Hemisphere | Self::Paraboloid | Self::Saddle | Self::AnimalHead => circle(count).collect(),
            Self::HeightField => circle(count).map(|p| p * DVec2::new(0.8, 1.0)).collect(),
            Self::BentStrip => rectangle(STRIP, count),
            Self::HalfTorus => rectangle(TORUS, count),
        }
    }

    fn lifted(self, p: DVec2) -> DVec3 {
        let DVec2 { x, y } = p;
        let square = p.length_squared();
        match self {
            // the inverse stereographic projection keeps the triangles' shapes
            Self::Hemisphere => DVec3::new(2.0 * x, 2.0 * y, 1.0 - square) / (1.0 + square),
            Self::Paraboloid => p.extend(square),
            Self::Saddle => p.extend(x * x - y * y),
            Self::BentStrip => {
                let radius = STRIP.x / STRIP_ANGLE;
                let (sine, cosine) = (x / radius).sin_cos();
                DVec3::new(radius * sine, y, radius * (1.0 - cosine))
            }
            Self::HalfTorus => {
                let [around, along] = [p.y / TUBE - 0.5 * SLIT_ANGLE, p.x / RING - FRAC_PI_2];
                let distance = RING + TUBE * around.cos();
                DVec3::new(distance * along.cos(), distance * along.sin(), TUBE * around.sin())
            }
            Self::HeightField => p.extend(face(p)),
            Self::AnimalHead => head::lifted(p),
        }
    }
}

/// Length and width of the strip, and the angle by which it is bent: 200°.
const STRIP: DVec2 = DVec2::new(4.0, 1.0);
const STRIP_ANGLE: f64 = TAU * 200.0 / 360.0;
/// Radii of the torus, and how far its tube is closed: 270°.
const RING: f64 = 2.0;
const TUBE: f64 = 0.8;
const SLIT_ANGLE: f64 = 0.75 * TAU;
const TORUS: DVec2 = DVec2::new(RING * FRAC_PI_2 * 2.0, TUBE * SLIT_ANGLE);

/// A dome with a nose, a brow, two sockets and a chin: Gaussian bumps (x, y, width, height).
fn face(p: DVec2) -> f64 {
    const BUMPS: [(f64, f64, f64, f64); 7] = [
        (0.0, -0.08, 0.12, 0.28),
        (0.0, 0.08, 0.09, 0.16),
        (0.0, 0.38, 0.30, 0.08),
        (-0.28, 0.18, 0.13, -0.10),
        (0.28, 0.18, 0.13, -0.10),
        (0.0, -0.40, 0.16, 0.07),
        (0.0, -0.68, 0.18, 0.10),
    ];
    let dome = 0.6 * (1.05 - 0.9 * (p.x * p.x / 0.64 + p.y * p.y)).sqrt();
    let bump = |&(x, y, width, height): &(f64, f64, f64, f64)| {
        height * (-(p - DVec2::new(x, y)).length_squared() / (width * width)).exp()
    };
    dome + BUMPS.iter().map(bump).sum::<f64>()
}

fn circle(count: u32) -> impl Iterator<Item = DVec2> {
    (0..count).map(move |k| DVec2::from_angle(TAU * f64::from(k) / f64::from(count)))
}

/// The corners (0, 0) and `size`, with points evenly spaced along each side.
fn rectangle(size: DVec2, count: u32) -> Vec<DVec2> {
    let step = 2.0 * (size.x + size.y) / f64::from(count);
    let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
    let side = |k: usize| {
        let (a, b) = (corners[k], corners[(k + 1) % 4]);
        let parts = (a.distance(b) / step).round().max(1.0) as u32;
        (0..parts).map(move |i| a.lerp(b, f64::from(i) / f64::from(parts)))
    };
    (0..4).flat_map(side).collect()
}

impl fmt::Display for SurfacePreset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// No preset has this name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no surface preset \"{name}\"; there are {}", SurfacePreset::ALL.map(SurfacePreset::name).join(", "))]
#[non_exhaustive]
pub struct UnknownSurfacePreset {
    /// The requested name.
    pub name: String,
}

impl FromStr for SurfacePreset {
    type Err = UnknownSurfacePreset;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL
            .into_iter()
            .find(|preset| preset.name() == name)
            .ok_or_else(|| UnknownSurfacePreset { name: name.to_owned() })
    }
}
