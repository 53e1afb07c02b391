//! The arguments of `riemap invariants`.

use super::discretization::InterpretArgument;
use super::values::Point;
use crate::conformal::Marks;
use std::str::FromStr;

/// `riemap invariants OUTLINE`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  riemap invariants preset:l-shape --point=-0.4,-0.4
  riemap invariants outline.json --point 0.5,0.5 --second-point 1.5,0.5 --json
  riemap invariants preset:disk --point 0,0 --marks 0,0.175,0.35,0.625 --json")]
pub struct InvariantsArguments {
    /// The outline, given as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`.
    pub outline: String,
    /// The point from which harmonic measure and conformal radius are taken; strictly inside.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub point: Point,
    /// A second point inside: also print its hyperbolic distance from the first one.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub second_point: Option<Point>,
    /// Four boundary points as fractions of the boundary's length from the outline's first point, in counter-clockwise
    /// cyclic order: print the measures of the arcs from mark to mark instead of those of the sides, and the modulus, the
    /// extremal distance between the arcs from mark 1 to 2 and from mark 3 to 4.
    #[arg(long, value_name = "S,S,S,S", allow_hyphen_values = true)]
    pub marks: Option<MarksArgument>,
    /// What an outline's points are taken for, as for `riemap map`. The sides of a curve are the
    /// segments of a path, and the parts between corners of a smooth list of points, divided at the first point.
    #[arg(long, default_value = "auto")]
    pub interpret: InterpretArgument,
    /// Cut off small loops and spikes of a file's outline instead of refusing it.
    #[arg(long)]
    pub repair: bool,
    /// Print the invariants as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}

/// Four fractions of a boundary's length in counter-clockwise cyclic order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarksArgument(pub Marks);

impl FromStr for MarksArgument {
    type Err = String;

    /// Fractions are taken modulo 1.
    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<f64>> = text.split(',').map(|s| s.trim().parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[a, b, c, d]) => Marks::new([a, b, c, d]).map(Self).map_err(|error| error.to_string()),
            _ => Err("expected four finite fractions S,S,S,S, such as 0,0.25,0.5,0.75".to_owned()),
        }
    }
}
