//! Orthogonal grids: the images of the lines of a rectangle's lattice.

use super::map::{Place, RectangleMap};
use crate::geometry::DVec2;
use rayon::prelude::*;

/// The most cells along a side.
pub const MOST_CELLS: u32 = 1000;

/// The numbers of cells along the sides 1 and 2, from 1 to [`MOST_CELLS`] each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GridCells([u32; 2]);

impl GridCells {
    /// The numbers, if they are within the limits.
    pub fn new(counts: [u32; 2]) -> Option<Self> {
        counts.iter().all(|count| (1..=MOST_CELLS).contains(count)).then_some(Self(counts))
    }

    /// The numbers.
    pub fn counts(self) -> [u32; 2] {
        self.0
    }
}

/// A grid whose lines meet at right angles: the images of a lattice of equal cells under the conformal map of the
/// quadrilateral's rectangle onto it.
#[derive(Debug, Clone, PartialEq)]
pub struct OrthogonalGrid {
    cells: GridCells,
    nodes: Vec<DVec2>,
    image_error: f64,
    deviation: Option<f64>,
}

impl OrthogonalGrid {
    /// The numbers of cells.
    pub fn cells(&self) -> GridCells {
        self.cells
    }

    /// The nodes (i, j), i from 0 to N the number of cells along the sides 1 and 3, j from 0 to M: i + (N + 1) j is the
    /// index. (0, 0) is corner 1, (N, 0) corner 2, (N, M) corner 3. Nodes with i = 0 or N, or j = 0 or M lie on the outline.
    pub fn nodes(&self) -> &[DVec2] {
        &self.nodes
    }

    /// The four corners of the quadrilateral.
    pub fn corners(&self) -> [DVec2; 4] {
        let [n, m] = self.cells.0.map(|count| count as usize);
        [0, n, n + (n + 1) * m, (n + 1) * m].map(|k| self.nodes[k])
    }

    /// The estimated error of a node, the largest one.
    pub fn image_error(&self) -> f64 {
        self.image_error
    }

    /// By how many degrees the tangents of two lines, measured by differences along each, deviate from a right angle: the
    /// largest deviation at up to 2,048 interior nodes; `None` without interior nodes.
    pub fn deviation(&self) -> Option<f64> {
        self.deviation
    }

    /// The corners of every cell as indices of nodes, counter-clockwise.
    pub fn quads(&self) -> impl Iterator<Item = [usize; 4]> + '_ {
        let [n, m] = self.cells.0.map(|count| count as usize);
        let corner = move |i: usize, j: usize| i + (n + 1) * j;
        (0..m).flat_map(move |j| {
            (0..n).map(move |i| [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)])
        })
    }
}

/// The most nodes at which the angle between the lines is measured.
const MEASURED: usize = 2048;
/// The least number of steps in which a line is drawn.
const DRAWN: u32 = 128;
/// The most of them, however many nodes it has.
const MOST_DRAWN: u32 = 256;

impl RectangleMap<'_> {
    /// The grid with these numbers of cells. `progress` is called with the completed fraction and returns whether to go
    /// on; `None` if it said no.
    pub fn grid(&self, cells: GridCells, progress: &mut dyn FnMut(f64) -> bool) -> Option<OrthogonalGrid> {
        let steps @ [n, m] = cells.0;
        let (mut nodes, mut image_error) = (Vec::new(), 0.0_f64);
        for j in 0..=m {
            if !progress(f64::from(j) / f64::from(m + 1)) {
                return None;
            }
            let image = |i: u32| self.image_with_error(Place { steps, at: [i, j] });
            let row: Vec<(DVec2, f64)> = (0..=n).into_par_iter().map(image).collect();
            image_error = row.iter().map(|(_, error)| *error).fold(image_error, f64::max);
            nodes.extend(row.into_iter().map(|(node, _)| node));
        }
        Some(OrthogonalGrid { cells, nodes, image_error, deviation: self.deviation(steps) })
    }

    /// The lines of a grid inside, for drawing: those of constant j in the first list, those of constant i in the second,
    /// divided further where their nodes are few, and into 256 steps at most. Of the first list only every
    /// `stride[0]`-th line, of the second every `stride[1]`-th.
    pub fn lines(&self, cells: GridCells, stride: [u32; 2]) -> [Vec<Vec<DVec2>>; 2] {
        let [n, m] = cells.0;
        let every = |stride: u32, count: u32| -> Vec<u32> { (1..count).filter(|k| k % stride == 0).collect() };
        let [fine_n, fine_m] = cells.0.map(|count| (count * DRAWN.div_ceil(count)).min(MOST_DRAWN));
        let row = |j: u32| (0..=fine_n).map(|i| self.image(Place { steps: [fine_n, m], at: [i, j] })).collect();
        let column = |i: u32| (0..=fine_m).map(|j| self.image(Place { steps: [n, fine_m], at: [i, j] })).collect();
        let [rows, columns] = [every(stride[0], m), every(stride[1], n)];
        [rows.into_par_iter().map(row).collect(), columns.into_par_iter().map(column).collect()]
    }

    /// [`OrthogonalGrid::deviation`].
    fn deviation(&self, steps @ [n, m]: [u32; 2]) -> Option<f64> {
        let (inner_n, inner_m) = (n as usize - 1, m as usize - 1);
        let count = inner_n * inner_m;
        let stride = count.div_ceil(MEASURED).max(1);
        let off = |k: usize| {
            let at = [k * stride % inner_n, k * stride / inner_n].map(|k| k as u32 + 1);
            (self.angle(Place { steps, at }).to_degrees() - 90.0).abs()
        };
        (0..count.div_ceil(stride)).into_par_iter().map(off).reduce_with(f64::max)
    }
}
