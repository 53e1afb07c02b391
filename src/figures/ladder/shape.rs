//! The outlines of the ladder: their curves, dense polygons on them, and the points from which measure is taken.

use super::super::FigureError;
use super::polygons::{clef, clef_point, coast, notch};
use crate::exact::{self, Complex};
use crate::geometry::{Curve, CurvePoint, DVec2, Jet, Piece, SimplePolygon};
use crate::outline::Preset;
use std::f64::consts::{FRAC_PI_2, TAU};

/// An outline of the ladder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LadderShape {
    /// The unit disk, from 0.6 + 0.2i.
    Disk,
    /// The ellipse with half axes 4 and 1, from its center.
    Ellipse,
    /// A square, from its center.
    Square,
    /// A square of side 2 with corners rounded by arcs of radius `ROUNDING`, from its center.
    RoundedSquare,
    /// Three quarters of a square of side 2, from the middle of the quarter at its corner.
    LShape,
    /// The 10×1 rectangle, from its center.
    Rectangle,
    /// The V of the paper's section 1.2, from the point of Figure 3 in its tip.
    VShape,
    /// The blob of the paper's section 5.2, from its center.
    Blob,
    /// The image of the unit disk under z + 0.12 z⁵, from 0.
    Quintic,
    /// A square with a notch of 1° down to its middle, from (0.5, 0.2).
    Notch,
    /// A winding strip with 200 corners, from its middle.
    Clef,
    /// A coast with 192 corners, from 0.
    Coast,
}

/// The radius of the rounded square's arcs.
const ROUNDING: f64 = 0.3;
/// The angle of the notch, in degrees.
const NOTCH: f64 = 1.0;
/// The coast's halvings, and how far they move.
const COAST_LEVELS: u32 = 5;
const COAST_ROUGHNESS: f64 = 0.2;
/// Vertices of the polygon on a closed curve that is not a preset: chords leave it by 1e-6 of its size.
const VERTICES: u32 = 2880;

impl LadderShape {
    /// All outlines, in the order of the table.
    pub const ALL: [Self; 12] = [
        Self::Disk,
        Self::Ellipse,
        Self::Square,
        Self::RoundedSquare,
        Self::LShape,
        Self::Rectangle,
        Self::VShape,
        Self::Blob,
        Self::Quintic,
        Self::Notch,
        Self::Clef,
        Self::Coast,
    ];

    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Disk => "disk",
            Self::Ellipse => "ellipse-4-1",
            Self::Square => "square",
            Self::RoundedSquare => "rounded-square",
            Self::LShape => "l-shape",
            Self::Rectangle => "rectangle-10-1",
            Self::VShape => "v-shape",
            Self::Blob => "blob",
            Self::Quintic => "z+0.12z^5",
            Self::Notch => "notch-1",
            Self::Clef => "clef",
            Self::Coast => "coast",
        }
    }

    /// The name in a figure.
    pub fn title(self) -> &'static str {
        match self {
            Self::Disk => "disk",
            Self::Ellipse => "ellipse 4:1",
            Self::Square => "square",
            Self::RoundedSquare => "rounded square",
            Self::LShape => "L-shape",
            Self::Rectangle => "rectangle 10×1",
            Self::VShape => "V-shape",
            Self::Blob => "blob",
            Self::Quintic => "z + 0.12 z⁵",
            Self::Notch => "notch of 1°",
            Self::Clef => "clef of 200 corners",
            Self::Coast => "coast of 192 corners",
        }
    }

    /// The point from which harmonic measure is taken.
    pub fn point(self) -> DVec2 {
        match self {
            Self::Disk => DVec2::new(0.6, 0.2),
            Self::LShape => DVec2::new(0.5, 0.5),
            Self::Rectangle => DVec2::new(5.0, 0.5),
            Self::VShape => super::super::scenes::crowding_points().source,
            Self::Blob => exact::point(exact::blob::from_disk(Complex::ZERO)),
            Self::Notch => DVec2::new(0.5, 0.2),
            Self::Clef => clef_point(),
            Self::Ellipse | Self::Square | Self::RoundedSquare | Self::Quintic | Self::Coast => DVec2::ZERO,
        }
    }

    fn preset(self) -> Option<Preset> {
        match self {
            Self::Disk => Some(Preset::Disk),
            Self::Square => Some(Preset::Square),
            Self::VShape => Some(Preset::VShape),
            Self::Blob => Some(Preset::Blob),
            _ => None,
        }
    }

    fn corners(self) -> Option<Vec<DVec2>> {
        let corners: &[(f64, f64)] = match self {
            Self::LShape => &[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)],
            Self::Rectangle => &[(0.0, 0.0), (10.0, 0.0), (10.0, 1.0), (0.0, 1.0)],
            Self::Notch => return Some(notch(NOTCH)),
            Self::Clef => return Some(clef()),
            Self::Coast => return coast(COAST_LEVELS, COAST_ROUGHNESS).map(|coast| coast.vertices().to_vec()),
            _ => return None,
        };
        Some(corners.iter().map(|&corner| corner.into()).collect())
    }

    /// Whether the outline is a polygon.
    pub fn is_polygon(self) -> bool {
        matches!(self, Self::Square | Self::LShape | Self::Rectangle | Self::Notch) || self.has_many_corners()
    }

    /// Whether few samples would be corners only.
    pub fn has_many_corners(self) -> bool {
        matches!(self, Self::Clef | Self::Coast)
    }

    /// The curve; harmonic measure is counted from its start.
    pub fn curve(self) -> Result<Curve, FigureError> {
        let curve = if let Some(preset) = self.preset() {
            preset.curve()
        } else if let Some(corners) = self.corners() {
            let ends = corners.iter().zip(corners.iter().cycle().skip(1));
            Curve::new(ends.map(|(&a, &b)| Piece::Line([a, b])).collect())
        } else if self == Self::Ellipse {
            let axes = [DVec2::new(4.0, 0.0), DVec2::new(0.0, 1.0)];
            Curve::new(vec![Piece::Arc { center: DVec2::ZERO, axes, from: 0.0, to: TAU }])
        } else if self == Self::Quintic {
            let whole = Piece::Formula { function: quintic, from: 0.0, to: TAU };
            Curve::new(vec![whole]).and_then(|curve| curve.analytic_at(0))
        } else {
            Curve::new(rounded_square())
        };
        curve.map_err(|_| FigureError::Outline)
    }

    /// A polygon with vertices on the curve, from its start.
    pub fn polygon(self) -> Result<SimplePolygon, FigureError> {
        if let Some(preset) = self.preset() {
            return Ok(preset.outline().into_polygon());
        }
        let points = match self.corners() {
            Some(corners) => corners,
            None => dense(&self.curve()?),
        };
        SimplePolygon::try_from(points).map_err(|_| FigureError::Outline)
    }
}

/// e^{it} + 0.12 e^{5it} with its derivatives by t.
fn quintic(t: f64) -> Jet {
    let (z, w) = (DVec2::from_angle(t), 0.12 * DVec2::from_angle(5.0 * t));
    Jet { position: z + w, first: (z + 5.0 * w).perp(), second: -(z + 25.0 * w) }
}

/// From (1, 0) on: half a side, then arcs and sides, then the other half.
fn rounded_square() -> Vec<Piece> {
    let inner = 1.0 - ROUNDING;
    let mut pieces = Vec::new();
    for k in 0..4 {
        let turned = |x: f64, y: f64| (0..k).fold(DVec2::new(x, y), |p, _| p.perp());
        let start = if k == 0 { turned(1.0, 0.0) } else { turned(1.0, -inner) };
        pieces.push(Piece::Line([start, turned(1.0, inner)]));
        let from = FRAC_PI_2 * f64::from(k);
        pieces.push(Piece::circular(turned(inner, inner), ROUNDING, from, from + FRAC_PI_2));
    }
    pieces.push(Piece::Line([DVec2::new(1.0, -inner), DVec2::new(1.0, 0.0)]));
    pieces
}

/// Points at equal parameters of the pieces; those of a line are its start alone.
fn dense(curve: &Curve) -> Vec<DVec2> {
    let count = curve.pieces().len() as u32;
    let of_piece = |k: usize| {
        let parts = if curve.pieces()[k].is_straight() { 1 } else { VERTICES / count };
        (0..parts).map(move |j| curve.position(CurvePoint::new(k, f64::from(j) / f64::from(parts))))
    };
    (0..curve.pieces().len()).flat_map(of_piece).collect()
}
