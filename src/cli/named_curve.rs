//! Outlines named on the command line, as curves.

use super::CliError;
use super::discretization::InterpretArgument;
use super::named_outline::read_outline;
use super::side::is_surface;
use crate::geometry::{Curve, DVec2, SimplePolygon};
use crate::outline::{self, OutlineNote, Preset};
use std::str::FromStr as _;

/// An outline as a curve.
pub struct NamedCurve {
    /// The curve.
    pub curve: Curve,
    /// The number of its pieces that each side has.
    pub sides: Vec<usize>,
    /// The points of its file in its order.
    pub vertices: Vec<DVec2>,
    /// The polygon that it was found from.
    pub polygon: SimplePolygon,
    /// Whether the file's points ran clockwise, so that the curve's pieces are in the opposite order.
    pub is_reversed: bool,
}

impl NamedCurve {
    /// A preset by its formulas, or a file's curve, as it is interpreted; notes are printed to stderr. Errors: also if it
    /// is a surface.
    pub fn read(name: &str, how: &outline::Reading, interpret: InterpretArgument) -> Result<Self, CliError> {
        if is_surface(name) {
            return Err(CliError::Input(format!("{name} is a surface, and only an outline has a curve")));
        }
        let refused = |error: &dyn std::fmt::Display| CliError::Input(format!("{name}: {error}"));
        if let Some(Ok(preset)) = name.strip_prefix("preset:").map(Preset::from_str) {
            let curve = preset.curve().map_err(|error| refused(&error))?;
            let sides = vec![1; curve.pieces().len()];
            let polygon = preset.outline().into_polygon();
            return Ok(Self { curve, sides, vertices: polygon.vertices().to_vec(), polygon, is_reversed: false });
        }
        let named = read_outline(name, how)?.interpreted(interpret);
        named.say_notes(name);
        let polygon = named.outline.polygon();
        let curve = match named.interpretation(name) {
            Some(_) => named.outline.curve().map(|found| (found.sides().to_vec(), found.into_curve())),
            None => Curve::from_polygon(polygon).map(|curve| (vec![1; curve.pieces().len()], curve)),
        };
        let (sides, curve) = curve.map_err(|error| refused(&error))?;
        let is_reversed = polygon.was_clockwise() || named.outline.notes().contains(&OutlineNote::Reversed);
        Ok(Self { curve, sides, vertices: named.vertices, polygon: named.outline.into_polygon(), is_reversed })
    }
}
