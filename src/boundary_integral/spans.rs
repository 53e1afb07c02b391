//! The spans of harmonic measure along the curve, from the transformed density, and what their polynomials leave open.

use super::corner::{Compressed, PlacedBlock, Problem};
use super::layout::{Block, End, Layout, Panel};
use super::legendre::{NODES, Rule, Values};
use super::peak::Peaks;
use super::span::{Rounding, Span};
use super::system::System;
use crate::geometry::{Curve, Piece};
use faer::Mat;

/// The bits of a density that the recursion into a corner shares between its two errors, see [`depth`].
const BITS: f64 = 53.0;

/// The levels after which the recursion into a corner ends, and the measure is a power of the distance.
///
/// Into a corner of less than π the density falls as 2^{−(e−1)} from level to level, e = π/α, but its rounding error does
/// not: after L levels it is 2^{(e−1)L − 53} of the density. The power leaves out the next mode, r^{2e}, or r^{e+1} of
/// curved legs, which is 2^{−eL} or 2^{−L} of it. The depth is that at which both are equal: in the square's corners
/// the measure is then right to 1e-10 of itself at every distance.
fn depth(exponent: f64, is_straight: bool) -> usize {
    let next_mode = if is_straight { exponent } else { exponent.min(1.0) };
    (BITS / ((exponent - 1.0).max(0.0) + next_mode)).ceil() as usize
}

/// The error that rounding leaves in the density times the perimeter. Where the true density is nothing, in the arms of
/// the V and the ends of rectangles of 10×1 and 40×1, it is found to be 2e-17 to 4e-15.
pub const ROUNDING: f64 = 4e-15;

/// The measure of both legs of a block with these true densities at its nodes, and their lengths.
fn leg_measures(curve: &Curve, block: &Block, density: &Mat<f64>) -> [(f64, f64); 2] {
    let count = curve.pieces().len();
    let pieces = [(block.junction + count - 1) % count, block.junction];
    let rows = block.mesh.panels * NODES;
    [0, 1].map(|leg| {
        let panel = block.scales[leg] * curve.lengths()[pieces[leg]];
        let weight = |k: usize| 0.5 * panel * Rule::get().weights[k % NODES];
        let measure = (0..rows).map(|k| weight(k) * density[(leg * rows + k, 0)]).sum();
        (measure, panel * block.mesh.panels as f64)
    })
}

/// The spans of a block on both its legs, from the junction outwards. `least` is the density that rounding leaves.
fn block_spans(
    curve: &Curve,
    block: &Block,
    compressed: &Compressed,
    (exponent, least): (f64, f64),
    density: Mat<f64>,
    peaks: &Peaks,
) -> [Vec<Span>; 2] {
    let count = curve.pieces().len();
    let pieces = [(block.junction + count - 1) % count, block.junction];
    let ends = [End::Finish, End::Start];
    let outer_panels = block.mesh.outer();
    let legs = leg_measures(curve, block, &(&compressed.matrix * &density));
    let rounding = legs.map(|(measure, length)| Rounding::Corner {
        relative: (least * length / measure.abs()).max(f64::EPSILON),
        measure,
    });
    let (mut spans, mut density, mut shrink) = ([Vec::new(), Vec::new()], density, 1.0);
    let is_straight = pieces.iter().all(|&piece| curve.pieces()[piece].is_straight());
    for level in 0..depth(exponent, is_straight) {
        let step = compressed.step(level);
        let outer = &step.outer * &density;
        for leg in 0..2 {
            let unit = block.scales[leg] * shrink;
            for (k, &(start, length)) in outer_panels.iter().enumerate().rev() {
                let row = (leg * outer_panels.len() + k) * NODES;
                let half = 0.5 * length * unit * curve.lengths()[pieces[leg]];
                let values = std::array::from_fn(|i| half * outer[(row + i, 0)]);
                let places = [start * unit, (start + length) * unit];
                let span = Span::new(pieces[leg], ends[leg], places, &values, rounding[leg]);
                // inside of the block's first panel from the second level on
                let panel = block.panels[leg * block.mesh.panels + (start * shrink) as usize];
                spans[leg].push(span.with_peak(peaks[panel].as_ref()));
            }
        }
        density = &step.inner * &density;
        shrink *= 0.5;
    }
    let rest = leg_measures(curve, block, &(compressed.innermost() * &density));
    for leg in 0..2 {
        let to = block.scales[leg] * shrink * block.mesh.panels as f64;
        spans[leg].push(Span::rest(pieces[leg], ends[leg], to, shrink * rest[leg].0, exponent, rounding[leg]));
    }
    spans.map(|mut list| {
        list.reverse();
        list
    })
}

/// The spans in the order of the curve, and the first one of each piece, followed by their number.
pub fn spans(
    curve: &Curve,
    layout: &Layout,
    system: &System,
    (transformed, peaks): (&[f64], &Peaks),
) -> (Vec<Span>, Vec<usize>) {
    let least = ROUNDING / curve.perimeter();
    let of_block = |(block, placed): (&Block, &PlacedBlock)| {
        let exponent = Problem::Interior.exponent(curve.junctions()[block.junction]);
        block_spans(curve, block, &placed.compressed, (exponent, least), placed.gather(transformed), peaks)
    };
    let mut of_blocks: Vec<[Vec<Span>; 2]> = layout.blocks.iter().zip(system.blocks()).map(of_block).collect();
    let mut spans = Vec::new();
    let mut first = vec![0; curve.pieces().len() + 1];
    for (index, panel) in layout.panels.iter().enumerate() {
        match (panel.block, panel.end) {
            (None, end) => {
                let half = 0.5 * (panel.to - panel.from) * curve.lengths()[panel.piece];
                let values = std::array::from_fn(|i| half * transformed[index * NODES + i]);
                let rounding = Rounding::Density(half * least);
                let span = Span::new(panel.piece, end, [panel.from, panel.to], &values, rounding);
                spans.push(span.with_peak(peaks[index].as_ref()));
            }
            // the first panel of a block's leg stands for all of the leg, the others find nothing left
            (Some(block), End::Start) => spans.append(&mut of_blocks[block][1]),
            (Some(block), End::Finish) => spans.extend(of_blocks[block][0].drain(..).rev()),
        }
        first[panel.piece + 1] = spans.len();
    }
    (spans, first)
}

/// The error of ω in a panel for its last two coefficients. Integration would divide them by 2 · NODES; on
/// the L-shape and the half-disk, the error of ω is 1 to 2 times what that gives.
const UNRESOLVED: f64 = 0.1;

/// The share of a peak's last coefficients that counts within a block: next to the corners of the square, the heart, the
/// L-shape, the cinquefoil and stars the error of ω is 1e-4 to 4e-2 of them times `UNRESOLVED`.
const WITHIN_BLOCK: f64 = 0.1;

/// The error of ω for a displacement of the boundary, in displacements times density: 1 on 64 points of a circle, 3 on
/// 64 points of z + 0.12 z⁵.
const DISPLACEMENT: f64 = 4.0;

fn tail(coefficients: &Values) -> f64 {
    coefficients[NODES - 1].abs() + coefficients[NODES - 2].abs()
}

/// How far the curve may be from a smooth one through the same points, along a panel of a spline; 0 of other pieces.
pub fn left_open(curve: &Curve, panel: &Panel) -> f64 {
    let &Piece::Spline { ref spline, from, to } = &curve.pieces()[panel.piece] else { return 0.0 };
    let ends = if panel.end == End::Start { [from, to] } else { [to, from] };
    spline.left_open(ends, [panel.from, panel.to])
}

/// What the polynomials leave open: of the transformed density without the peak's projection, which is what the panel
/// stands for; of the projection where the panel belongs to a block; and of the spans.
pub fn unresolved(curve: &Curve, layout: &Layout, spans: &[Span], (transformed, peaks): (&[f64], &Peaks)) -> f64 {
    let rule = Rule::get();
    // the outer panels of a block are those of its finer mesh: no polynomial of the transformed density is used there
    let is_kept = |index: usize, block: &Block| {
        let q = block.mesh.panels;
        block.panels.iter().position(|&panel| panel == index).is_some_and(|k| q > 1 && k % q >= q / 2)
    };
    let of_panel = |(index, panel): (usize, &Panel)| {
        if panel.block.is_some_and(|block| is_kept(index, &layout.blocks[block])) {
            return 0.0;
        }
        let half = 0.5 * (panel.to - panel.from) * curve.lengths()[panel.piece];
        let mut coefficients = rule.coefficients(&std::array::from_fn(|i| half * transformed[index * NODES + i]));
        let mut within_block = 0.0;
        if let Some(peak) = &peaks[index] {
            coefficients.iter_mut().zip(peak.projection()).for_each(|(c, p)| *c -= p);
            within_block = if panel.block.is_some() { WITHIN_BLOCK * tail(peak.projection()) } else { 0.0 };
        }
        UNRESOLVED * (tail(&coefficients) + within_block)
    };
    let of_spline = |(index, panel): (usize, &Panel)| {
        let densities = &transformed[index * NODES..(index + 1) * NODES];
        let density = densities.iter().fold(0.0_f64, |most, density| most.max(density.abs()));
        DISPLACEMENT * density * left_open(curve, panel)
    };
    let of_panels = layout.panels.iter().enumerate().map(of_panel).fold(0.0, f64::max);
    let of_spans = spans.iter().filter_map(Span::coefficients).map(tail).fold(0.0, f64::max);
    let of_splines = layout.panels.iter().enumerate().map(of_spline).fold(0.0, f64::max);
    of_panels.max(UNRESOLVED * of_spans).max(of_splines)
}
