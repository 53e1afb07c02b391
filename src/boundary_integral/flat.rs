//! A factored equation as flat arrays, which cross a worker boundary by transfer, and its reading, which validates
//! everything.
//!
//! The curve does not travel: the receiver has the outline, and evaluates it as the sender did.

use super::BoundaryIntegral;
use super::corner::{Compressed, Step};
use super::factor::{Factor, FlatFactor};
use super::layout::{Block, Layout, Panel};
use super::legendre::NODES;
use super::system::System;
use crate::geometry::{Curve, DVec2};
use faer::Mat;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A [`BoundaryIntegral`] without its curve.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(crate) struct FlatIntegral {
    /// The factor's values, then for each block one array: its matrix, the innermost one, and the steps.
    #[serde(skip)]
    pub floats: Vec<Vec<f64>>,
    /// The factor's orders and sizes.
    #[serde(skip)]
    pub integers: Vec<u32>,
    layout: Layout,
    outside: Vec<DVec2>,
    extent: f64,
    duration_ms: f64,
}

impl BoundaryIntegral {
    /// The equation as flat arrays.
    pub(crate) fn to_flat(&self) -> FlatIntegral {
        let FlatFactor { mut floats, integers } = self.system.factor().to_flat();
        floats.extend(self.system.blocks().iter().map(|block| flat_block(&block.compressed)));
        FlatIntegral {
            floats,
            integers,
            layout: self.layout.clone(),
            outside: self.outside.clone(),
            extent: self.extent,
            duration_ms: self.duration_ms,
        }
    }

    /// The equation of `curve` from flat arrays; `None` unless [`Self::to_flat`] wrote them for this curve.
    pub(crate) fn from_flat(curve: &Curve, flat: FlatIntegral) -> Option<Self> {
        let FlatIntegral { mut floats, integers, layout, outside, extent, duration_ms } = flat;
        let blocks = floats.split_off(floats.len().checked_sub(layout.blocks.len())?);
        let factor = Factor::from_flat(FlatFactor { floats, integers })?;
        if !is_sound(&layout, curve) || factor.len() != layout.panels.len() * NODES {
            return None;
        }
        let read = |(block, values): (&Block, Vec<f64>)| block_of(block, curve, &values).map(Arc::new);
        let blocks = layout.blocks.iter().zip(blocks).map(read).collect::<Option<Vec<_>>>()?;
        let system = System::factored(curve, &layout, blocks, factor);
        Some(Self { curve: curve.clone(), layout, system, outside, extent, duration_ms })
    }
}

/// Whether the panels cover every piece in order, and refer to blocks, and blocks to panels, that exist.
fn is_sound(layout: &Layout, curve: &Curve) -> bool {
    let (count, panels, blocks) = (curve.pieces().len(), &layout.panels, &layout.blocks);
    let is_interval = |panel: &Panel| {
        panel.from >= 0.0
            && panel.from < panel.to
            && panel.to <= 1.0
            && panel.block.is_none_or(|block| block < blocks.len())
    };
    let mut next = 0;
    let covers = panels.iter().all(|panel| {
        let is_next = panel.piece == next || panel.piece + 1 == next;
        next = panel.piece + 1;
        is_next && is_interval(panel)
    });
    let is_block = |block: &Block| {
        block.junction < count
            && matches!(block.mesh.panels, 1 | 2 | 4)
            && block.panels.len() == 2 * block.mesh.panels
            && block.panels.iter().all(|&panel| panel < panels.len())
    };
    covers && next == count && blocks.iter().all(is_block)
}

fn flat_block(block: &Compressed) -> Vec<f64> {
    let Compressed { matrix, steps, repeated, innermost } = block;
    let of_steps = std::iter::once(repeated).chain(steps).flat_map(|step| [&step.outer, &step.inner]);
    let all = std::iter::once(matrix).chain(innermost).chain(of_steps);
    all.flat_map(|matrix| matrix.col_iter().flat_map(|column| column.iter().copied())).collect()
}

fn block_of(block: &Block, curve: &Curve, values: &[f64]) -> Option<Compressed> {
    let mesh = block.mesh;
    let (size, outer) = (2 * mesh.panels * NODES, 2 * mesh.outer().len() * NODES);
    let (square, step) = (size * size, (outer + size) * size);
    let count = curve.pieces().len();
    let pieces = [(block.junction + count - 1) % count, block.junction];
    let squares = if pieces.iter().all(|&piece| curve.pieces()[piece].is_straight()) { 1 } else { 2 };
    let (squares, steps) = values.split_at_checked(squares * square)?;
    let matrix = |values: &[f64]| Mat::from_fn(values.len() / size, size, |i, j| values[j * (values.len() / size) + i]);
    let mut squares = squares.chunks_exact(square).map(matrix);
    if !steps.len().is_multiple_of(step) {
        return None;
    }
    let mut steps = steps.chunks_exact(step).map(|values| {
        let (outer, inner) = values.split_at(outer * size);
        Step { outer: matrix(outer), inner: matrix(inner) }
    });
    Some(Compressed {
        matrix: squares.next()?,
        innermost: squares.next(),
        repeated: steps.next()?,
        steps: steps.collect(),
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::boundary_integral::Settings;
    use crate::geometry::CurvePoint;
    use crate::outline::Preset;

    fn prepared(preset: Preset) -> BoundaryIntegral {
        let outline = preset.outline();
        BoundaryIntegral::prepare(outline.curve().unwrap().curve(), &Settings::default()).unwrap()
    }

    /// Straight corners, and curved ones with steps of their own.
    #[test]
    fn an_equation_from_its_arrays_gives_the_same_measure_bit_for_bit() {
        for (preset, x) in [(Preset::LShape, DVec2::new(0.4, 0.4)), (Preset::Heart, DVec2::ZERO)] {
            let outline = preset.outline();
            let x = if outline.polygon().contains(x) { x } else { outline.polygon().pole_of_inaccessibility(1e-3) };
            let integral = prepared(preset);
            let again = BoundaryIntegral::from_flat(integral.curve(), integral.to_flat()).unwrap();
            assert_eq!(again.unknowns(), integral.unknowns());
            let [one, other] = [&integral, &again].map(|integral| integral.harmonic_measure(x).unwrap());
            let along = |k: usize| CurvePoint::new(k % integral.curve().pieces().len(), 0.37);
            for k in 0..integral.curve().pieces().len() {
                let [a, b] = [&one, &other].map(|measure| measure.between(along(k), along(k + 1)));
                assert!(a == b, "{preset:?}, arc {k}: {a} and {b}");
            }
            assert!(one.error_estimate() == other.error_estimate());
        }
    }

    #[test]
    fn arrays_that_were_not_written_for_the_curve_are_refused() {
        let integral = prepared(Preset::LShape);
        let refused = |change: &dyn Fn(&mut FlatIntegral)| {
            let mut flat = integral.to_flat();
            change(&mut flat);
            assert!(BoundaryIntegral::from_flat(integral.curve(), flat).is_none());
        };
        refused(&|flat| flat.floats.truncate(1));
        refused(&|flat| flat.integers[0] = u32::MAX);
        refused(&|flat| flat.integers[1] = u32::MAX);
        refused(&|flat| flat.floats[1].truncate(7));
        refused(&|flat| flat.layout.panels.truncate(3));
        refused(&|flat| flat.layout.panels[0].piece = 99);
        refused(&|flat| flat.layout.blocks[0].panels[0] = 9999);
        refused(&|flat| *flat = FlatIntegral::default());
        let other = prepared(Preset::Square);
        assert!(BoundaryIntegral::from_flat(other.curve(), integral.to_flat()).is_none(), "another curve");
    }
}
