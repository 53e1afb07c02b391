//! Values of options that have a grammar of their own, and how they are parsed.

use super::CliError;
use crate::conformal::{CurveBoundary, MeshedDomain};
use crate::figures::Figure;
use crate::geometry::DVec2;
use crate::mesh::Sizing;
use crate::tiling::{Tiling, TilingPattern, TilingStyle};
use std::str::FromStr;

/// A point in the plane, `X,Y`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point(pub DVec2);

impl FromStr for Point {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (x, y) = text.split_once(',').ok_or("expected X,Y, such as 0.5,-0.2")?;
        let number = |s: &str| s.trim().parse::<f64>().ok().filter(|v| v.is_finite());
        match (number(x), number(y)) {
            (Some(x), Some(y)) => Ok(Self(DVec2::new(x, y))),
            _ => Err("expected two finite numbers X,Y, such as 0.5,-0.2".to_owned()),
        }
    }
}

/// A boundary point: `vK`, `X,Y` or `@S`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Anchor {
    /// At this point of the outline's file, counted from 0.
    Vertex(u32),
    /// The boundary point nearest to this point.
    Nearest(DVec2),
    /// At this fraction of the arc length from the outline's first point.
    Fraction(f64),
}

impl FromStr for Anchor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if let Some(vertex) = text.strip_prefix('v') {
            return vertex
                .parse()
                .map(Self::Vertex)
                .map_err(|_| "expected vK, such as v0, for the file's K-th point".into());
        }
        let Some(fraction) = text.strip_prefix('@') else { return Ok(Self::Nearest(text.parse::<Point>()?.0)) };
        match fraction.parse::<f64>() {
            Ok(s) if s.is_finite() => Ok(Self::Fraction(s)),
            _ => Err("expected @S with a finite fraction S of the arc length, such as @0.25".to_owned()),
        }
    }
}

impl Anchor {
    /// The fraction of the arc length of the outline, or of its curve. `vertices` are the points of its file. Errors: there
    /// is no such vertex.
    pub fn fraction(
        self,
        domain: &MeshedDomain,
        curve: Option<&CurveBoundary>,
        vertices: &[DVec2],
    ) -> Result<f64, CliError> {
        let x = match self {
            Self::Fraction(s) => return Ok(s.rem_euclid(1.0)),
            Self::Nearest(x) => x,
            Self::Vertex(k) => vertex_at(k, vertices)?,
        };
        let near = domain.samples().fraction_at(domain.samples().nearest(x));
        Ok(curve.map_or(near, |curve| curve.nearest_fraction(x, near)))
    }
}

/// The point of number `k` of an outline's file, counted from 0.
pub fn vertex_at(k: u32, vertices: &[DVec2]) -> Result<DVec2, CliError> {
    let missing = || format!("v{k}: the outline has {} points, counted from 0", vertices.len());
    vertices.get(k as usize).copied().ok_or_else(|| CliError::Input(missing()))
}

/// A hyperbolic tiling, `P,Q` or `P,Q,STYLE`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TilingArgument(pub TilingPattern);

impl FromStr for TilingArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let form = "expected P,Q or P,Q,STYLE, such as 7,3 or 4,6,edges";
        let mut parts = text.split(',').map(str::trim);
        let mut number = || parts.next()?.parse::<u8>().ok();
        let (Some(p), Some(q)) = (number(), number()) else { return Err(form.to_owned()) };
        let style = match parts.next() {
            None | Some("tiles") => TilingStyle::Tiles,
            Some("edges") => TilingStyle::Edges,
            Some("triangles") => TilingStyle::Triangles,
            Some("picture") => TilingStyle::Picture,
            Some(other) => return Err(format!("\"{other}\": a style is tiles, edges, triangles or picture")),
        };
        if parts.next().is_some() {
            return Err(form.to_owned());
        }
        let tiling = Tiling::new(p, q).map_err(|error| error.to_string())?;
        Ok(Self(TilingPattern { tiling, style }))
    }
}

/// `uniform` or `graded:G`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizingArgument(pub Sizing);

impl FromStr for SizingArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "uniform" {
            return Ok(Self(Sizing::Uniform));
        }
        match text.strip_prefix("graded:").and_then(|g| g.parse::<f64>().ok()) {
            Some(g) if g.is_finite() && g > 0.0 && g <= 1.0 => Ok(Self(Sizing::Graded(g))),
            _ if text == "graded" => Ok(Self(Sizing::default())),
            _ => Err("expected uniform or graded:G with 0 < G ≤ 1, such as graded:0.15".to_owned()),
        }
    }
}

/// The number of a figure that riemap can reproduce.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FigureNumber(pub Figure);

impl FromStr for FigureNumber {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.parse().ok().and_then(Figure::of_number).map(Self).ok_or_else(|| {
            let numbers = Figure::ALL.map(|figure| figure.number().to_string());
            format!("expected one of {}", numbers.join(", "))
        })
    }
}

/// A size in pixels, `WxH`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Size(pub [u32; 2]);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let sides = text.split_once('x').and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
        match sides {
            Some(size) if size.iter().all(|s| (16..=8192).contains(s)) => Ok(Self(size)),
            _ => Err("expected WIDTHxHEIGHT, each from 16 to 8192, such as 1600x900".to_owned()),
        }
    }
}
