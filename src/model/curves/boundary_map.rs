//! The input of the curves: two boundary loops with their measures and the matching between them, for outlines and
//! surfaces.

use crate::conformal::{ConformalMap, HarmonicMeasure, PerSide, PreparedSide, Side};
use crate::outline::{BoundaryPoint, BoundarySamples};

/// A closed boundary, parameterized by arc length.
#[derive(Debug, Clone, Copy)]
pub struct Loop<'a> {
    /// The lengths of its edges.
    pub edge_lengths: &'a [f64],
    /// The positions of its vertices as fractions of its length.
    pub fractions: &'a [f64],
}

impl<'a> From<&'a BoundarySamples> for Loop<'a> {
    fn from(samples: &'a BoundarySamples) -> Self {
        Self { edge_lengths: samples.edge_lengths(), fractions: samples.fractions() }
    }
}

impl<'a> From<&'a PreparedSide> for Loop<'a> {
    fn from(side: &'a PreparedSide) -> Self {
        Self { edge_lengths: side.edge_lengths(), fractions: side.fractions() }
    }
}

/// The boundary map, with data indexed by source and target.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryMap<'a> {
    /// The side whose vertices are mapped.
    pub mapped: Side,
    /// The loops.
    pub loops: PerSide<Loop<'a>>,
    /// ψ at the vertices.
    pub kernels: PerSide<&'a [f64]>,
    /// ω̃ along the loops.
    pub measures: PerSide<&'a HarmonicMeasure>,
    /// The images of the mapped vertices.
    pub images: &'a [BoundaryPoint],
}

impl<'a> From<&'a ConformalMap> for BoundaryMap<'a> {
    fn from(map: &'a ConformalMap) -> Self {
        Self {
            mapped: map.mapped_side(),
            loops: PerSide::from_fn(|side| Loop::from(&**map.side(side))),
            kernels: PerSide::from_fn(|side| map.kernel(side)),
            measures: PerSide::from_fn(|side| map.measure(side)),
            images: map.correspondence().points(),
        }
    }
}
