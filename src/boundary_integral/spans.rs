//! The spans of harmonic measure along the curve, from the transformed density, and what their polynomials leave open.

use super::corner::{Compressed, Problem};
use super::layout::{Block, End, Layout, Panel};
use super::legendre::{NODES, Rule, Values};
use super::peak::Peaks;
use super::span::Span;
use super::system::{System, gather};
use crate::geometry::{Curve, Piece};
use faer::Mat;

/// The measure at which the recursion into a corner ends, as a power of 2: what is left is a power of the distance.
const DEPTH: f64 = 50.0;

/// The spans of a block on both its legs, from the junction outwards.
fn block_spans(
    curve: &Curve,
    block: &Block,
    compressed: &Compressed,
    exponent: f64,
    density: Mat<f64>,
    peaks: &Peaks,
) -> [Vec<Span>; 2] {
    let count = curve.pieces().len();
    let pieces = [(block.junction + count - 1) % count, block.junction];
    let ends = [End::Finish, End::Start];
    let outer_panels = block.mesh.outer();
    let (mut spans, mut density, mut shrink) = ([Vec::new(), Vec::new()], density, 1.0);
    let depth = (DEPTH / exponent.min(1.0)).ceil() as usize;
    for level in 0..depth {
        let step = compressed.step(level);
        let outer = &step.outer * &density;
        for leg in 0..2 {
            let unit = block.scales[leg] * shrink;
            for (k, &(start, length)) in outer_panels.iter().enumerate().rev() {
                let row = (leg * outer_panels.len() + k) * NODES;
                let half = 0.5 * length * unit * curve.lengths()[pieces[leg]];
                let values = std::array::from_fn(|i| half * outer[(row + i, 0)]);
                // inside of the block's first panel from the second level on
                let panel = (start * shrink) as usize;
                let span = Span::new(pieces[leg], ends[leg], [start * unit, (start + length) * unit], &values);
                spans[leg].push(span.with_peak(peaks[block.panels[leg * block.mesh.panels + panel]].as_ref()));
            }
        }
        density = &step.inner * &density;
        shrink *= 0.5;
    }
    let rest = &compressed.innermost * &density;
    for leg in 0..2 {
        let unit = block.scales[leg] * shrink;
        let weight = |k: usize| 0.5 * unit * curve.lengths()[pieces[leg]] * Rule::get().weights[k % NODES];
        let rows = block.mesh.panels * NODES;
        let measure = (0..rows).map(|k| weight(k) * rest[(leg * rows + k, 0)]).sum();
        let to = unit * block.mesh.panels as f64;
        spans[leg].push(Span::rest(pieces[leg], ends[leg], to, measure, exponent));
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
    let of_block = |(block, (rows, compressed)): (&Block, &(Vec<usize>, Compressed))| {
        let exponent = Problem::Interior.exponent(curve.junctions()[block.junction]);
        block_spans(curve, block, compressed, exponent, gather(rows, transformed), peaks)
    };
    let mut of_blocks: Vec<[Vec<Span>; 2]> = layout.blocks.iter().zip(system.blocks()).map(of_block).collect();
    let mut spans = Vec::new();
    let mut first = vec![0; curve.pieces().len() + 1];
    for (index, panel) in layout.panels.iter().enumerate() {
        match (panel.block, panel.end) {
            (None, end) => {
                let half = 0.5 * (panel.to - panel.from) * curve.lengths()[panel.piece];
                let values = std::array::from_fn(|i| half * transformed[index * NODES + i]);
                let span = Span::new(panel.piece, end, [panel.from, panel.to], &values);
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

/// The error of ω for a displacement of the boundary, in displacements times density: 1 on 64 points of a circle, 3 on
/// 64 points of z + 0.12 z⁵.
const DISPLACEMENT: f64 = 4.0;

fn tail(coefficients: &Values) -> f64 {
    coefficients[NODES - 1].abs() + coefficients[NODES - 2].abs()
}

/// What the polynomials leave open: of the transformed density without the peak's projection, which is what the panel
/// stands for; of the projection where the panel belongs to a block; and of the spans.
pub fn unresolved(curve: &Curve, layout: &Layout, spans: &[Span], (transformed, peaks): (&[f64], &Peaks)) -> f64 {
    let rule = Rule::get();
    let of_panel = |(index, panel): (usize, &Panel)| {
        let half = 0.5 * (panel.to - panel.from) * curve.lengths()[panel.piece];
        let mut coefficients = rule.coefficients(&std::array::from_fn(|i| half * transformed[index * NODES + i]));
        let mut within_block = 0.0;
        if let Some(peak) = &peaks[index] {
            coefficients.iter_mut().zip(peak.projection()).for_each(|(c, p)| *c -= p);
            within_block = if panel.block.is_some() { tail(peak.projection()) } else { 0.0 };
        }
        UNRESOLVED * (tail(&coefficients) + within_block)
    };
    let of_spline = |(index, panel): (usize, &Panel)| {
        let &Piece::Spline { ref spline, from, to } = &curve.pieces()[panel.piece] else { return 0.0 };
        let ends = if panel.end == End::Start { [from, to] } else { [to, from] };
        let densities = &transformed[index * NODES..(index + 1) * NODES];
        let density = densities.iter().fold(0.0_f64, |most, density| most.max(density.abs()));
        DISPLACEMENT * density * spline.left_open(ends, [panel.from, panel.to])
    };
    let of_panels = layout.panels.iter().enumerate().map(of_panel).fold(0.0, f64::max);
    let of_spans = spans.iter().filter_map(Span::coefficients).map(tail).fold(0.0, f64::max);
    let of_splines = layout.panels.iter().enumerate().map(of_spline).fold(0.0, f64::max);
    of_panels.max(UNRESOLVED * of_spans).max(of_splines)
}
