//! The arguments of `riemap invariants`.

use super::discretization::InterpretArgument;
use super::marks::MarkArguments;
use super::values::Point;

/// `riemap invariants OUTLINE`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  riemap invariants preset:l-shape --point=-0.4,-0.4
  riemap invariants outline.json --point 0.5,0.5 --second-point 1.5,0.5 --json
  riemap invariants preset:disk --point 0,0 --marks 0,0.175,0.35,0.625 --json
  riemap invariants l.csv --point 1,1 --mark v0 --mark v2 --mark v3 --mark v5")]
pub struct InvariantsArguments {
    /// The outline, given as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`.
    pub outline: String,
    /// The point from which harmonic measure and conformal radius are taken; strictly inside. Capacity and modulus need none.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub point: Option<Point>,
    /// A second point inside: also print its hyperbolic distance from the first one.
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, requires = "point")]
    pub second_point: Option<Point>,
    /// The marks: with them, the modulus is printed, the extremal distance between the arcs from mark 1 to 2 and from mark 3
    /// to 4, and the measures of the arcs from mark to mark instead of those of the sides.
    #[command(flatten)]
    pub marks: MarkArguments,
    /// What an outline's points are taken for, as for `riemap map`. The sides of a curve are the
    /// segments of a path, and the parts between corners of a smooth list of points, divided at the first point.
    #[arg(long, default_value = "auto")]
    pub interpret: InterpretArgument,
    /// How its file is read.
    #[command(flatten)]
    pub reading: super::named_outline::ReadingArguments,
    /// Print the invariants as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}
