//! Where the panels lie: compressed blocks at the junctions, and panels between them that are split until the curve is
//! resolved, and until each is short against the width of the problem's side and its distance from corners (`distance`).

mod distance;
mod draft;
mod shape;

use super::BoundaryIntegralError;
use super::corner::{BlockMesh, Problem};
use super::legendre::NODES;
use crate::geometry::{Curve, DVec2, Piece};
use draft::Draft;

/// How finely the boundary is divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// The largest length of a panel in distances to other parts of the boundary. With 1.5 and 2 the presets' ω is off
    /// by 1e-14, with 2.5 that of the ends of the 10×1 rectangle by 1e-10 of itself.
    pub proximity: f64,
    /// The largest length of a panel in distances to the given interior points.
    pub nearness: f64,
    /// The largest share of the last two Legendre coefficients of z′.
    pub tail: f64,
    /// The length of a block's panels, in shares of the most that fits.
    pub block: f64,
    /// The angle between two legs below which a block has more than one panel on each leg. With one panel a corner of
    /// 90° leaves errors of 1e-14, one of 60° of 3e-13; with two panels both leave 1e-15.
    pub blunt: f64,
    /// Whether blocks have twice the panels where that makes a difference.
    pub blocks_are_fine: bool,
}

impl Fineness {
    /// Errors of ω of 1e-13 on polygons and of 1e-11 on smooth curves.
    pub const STANDARD: Self =
        Self { proximity: 2.0, nearness: 0.8, tail: 1e-10, block: 1.0, blunt: 1.3, blocks_are_fine: false };
    /// For boundaries of many corners: a quarter fewer unknowns on the maple leaf and the turkey, and errors of 1e-11.
    const COMPACT: Self = Self { blunt: 0.75, ..Self::STANDARD };
    /// To compare with: about twice the unknowns.
    pub const FINE: Self =
        Self { proximity: 1.4, nearness: 0.5, tail: 1e-12, block: 0.6, blunt: 1.3, blocks_are_fine: true };
}

/// The end of a piece from which a panel is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum End {
    /// By t.
    Start,
    /// By 1 − t.
    Finish,
}

/// A panel: the parameters from `from` to `to` of a piece, measured from one of its ends.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Panel {
    pub piece: usize,
    pub end: End,
    pub from: f64,
    pub to: f64,
    /// The block that the panel belongs to.
    pub block: Option<usize>,
}

/// A compressed block at a junction.
#[derive(Debug, Clone, serde::Serialize, serde::Deserialize)]
pub struct Block {
    pub junction: usize,
    pub mesh: BlockMesh,
    /// Parameters per panel of each leg.
    pub scales: [f64; 2],
    /// The panels of the first leg, from the junction outwards, then those of the second.
    pub panels: Vec<usize>,
}

/// The panels in the order of the curve, and the blocks among them.
#[derive(Debug, Clone, Default, serde::Serialize, serde::Deserialize)]
pub struct Layout {
    pub panels: Vec<Panel>,
    pub blocks: Vec<Block>,
}

/// Rounds of splitting; each halves what is too long.
const MOST_ROUNDS: usize = 60;

/// The deviations of splines from their panels' polynomials that are reached one after the other, as long as the
/// unknowns allow. A spline is not analytic at its knots: a panel over many of them has an error of about this share of
/// its measure, and with 1e-10 every panel ends at a knot.
const SPLINE_TOLERANCES: [f64; 6] = [1e-3, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10];
/// The unknowns that smaller deviations of splines may cost: a factor of 50 ms.
const SPLINE_UNKNOWNS: usize = 1536;

/// Unknowns from which on a factor takes so long that corners have fewer panels.
const COMPACT_FROM: usize = 1024;

/// Lays out the panels of a curve. Fails if they have more than `limit` nodes.
pub fn layout(
    curve: &Curve,
    near: &[DVec2],
    (fineness, problem): (Fineness, Problem),
    limit: usize,
) -> Result<Layout, BoundaryIntegralError> {
    let least = curve.pieces().len() * NODES;
    if least > limit {
        return Err(BoundaryIntegralError::TooManyUnknowns { needed: least, limit });
    }
    let mut draft = Draft::new(curve, near, fineness, problem);
    let mut best = refined(&mut draft, SPLINE_TOLERANCES[0], limit);
    let is_large = |layout: &Layout| layout.panels.len() * NODES > COMPACT_FROM;
    if fineness == Fineness::STANDARD && best.as_ref().map_or(true, is_large) {
        draft = Draft::new(curve, near, Fineness::COMPACT, problem);
        best = refined(&mut draft, SPLINE_TOLERANCES[0], limit);
    }
    let mut best = best?;
    if curve.pieces().iter().any(|piece| matches!(piece, Piece::Spline { .. })) {
        for tolerance in &SPLINE_TOLERANCES[1..] {
            let Ok(finer) = refined(&mut draft, *tolerance, limit.min(SPLINE_UNKNOWNS)) else { break };
            best = finer;
        }
    }
    Ok(best)
}

/// Splits until nothing is too long.
fn refined(draft: &mut Draft<'_>, tolerance: f64, limit: usize) -> Result<Layout, BoundaryIntegralError> {
    for _ in 0..MOST_ROUNDS {
        let layout = draft.panels();
        let needed = layout.panels.len() * NODES;
        if needed > limit {
            return Err(BoundaryIntegralError::TooManyUnknowns { needed, limit });
        }
        if !draft.split(&layout, tolerance) {
            return Ok(layout);
        }
    }
    Err(BoundaryIntegralError::NotResolved)
}
