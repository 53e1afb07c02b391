//! What the curves are made of: two boundary loops with their measures, matched; in the plane or around a surface.

use crate::conformal::{ConformalMap, HarmonicMeasure, PreparedSide, Side};
use crate::outline::{BoundaryPoint, BoundarySamples};

/// A closed boundary by its arc length.
#[derive(Debug, Clone, Copy)]
pub struct Loop<'a> {
    /// The lengths of its edges.
    pub edge_lengths: &'a [f64],
    /// Where its vertices lie, as fractions of the whole length.
    pub fractions: &'a [f64],
}

impl<'a> From<&'a BoundarySamples> for Loop<'a> {
    fn from(samples: &'a BoundarySamples) -> Self {
        Self { edge_lengths: &samples.edge_lengths, fractions: &samples.fractions }
    }
}

impl<'a> From<&'a PreparedSide> for Loop<'a> {
    fn from(side: &'a PreparedSide) -> Self {
        Self { edge_lengths: side.edge_lengths(), fractions: side.fractions() }
    }
}

/// A map's boundaries, by source and target.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryMap<'a> {
    /// The side whose vertices are mapped.
    pub mapped: Side,
    /// The loops.
    pub loops: [Loop<'a>; 2],
    /// ψ at their vertices.
    pub kernels: [&'a [f64]; 2],
    /// ω̃ along them.
    pub measures: [&'a HarmonicMeasure; 2],
    /// Where the mapped vertices go.
    pub images: &'a [BoundaryPoint],
}

impl<'a> From<&'a ConformalMap> for BoundaryMap<'a> {
    fn from(map: &'a ConformalMap) -> Self {
        Self {
            mapped: map.mapped_side(),
            loops: Side::BOTH.map(|side| Loop::from(&**map.side(side))),
            kernels: Side::BOTH.map(|side| map.kernel(side)),
            measures: Side::BOTH.map(|side| map.measure(side)),
            images: &map.correspondence().points,
        }
    }
}
