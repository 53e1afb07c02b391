//! Orthogonal grids: the images of the lines of a rectangle's lattice.

use super::boundary::BoundaryMap;
use super::{Quadrilateral, QuadrilateralError};
use crate::cauchy_integral::{BoundaryFunction as _, CauchyIntegral};
use crate::geometry::{Curve, CurvePoint, DVec2, Piece};
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

    /// The estimated error of a node, the largest one.
    pub fn image_error(&self) -> f64 {
        self.image_error
    }

    /// By how many degrees the tangents of two lines, measured by differences along each, deviate from a right angle: the
    /// largest deviation at [`MEASURED`] interior nodes or fewer; `None` without interior nodes.
    pub fn deviation(&self) -> Option<f64> {
        self.deviation
    }

    /// The lines: those of constant j, then those of constant i, each from its first node to its last.
    pub fn lines(&self) -> impl Iterator<Item = Vec<DVec2>> + '_ {
        let [n, m] = self.cells.0.map(|count| count as usize);
        let node = move |i: usize, j: usize| self.nodes[i + (n + 1) * j];
        let rows = (0..=m).map(move |j| (0..=n).map(|i| node(i, j)).collect());
        let columns = (0..=n).map(move |i| (0..=m).map(|j| node(i, j)).collect());
        rows.chain(columns)
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
pub const MEASURED: usize = 2048;
/// The step of differences along a line, in distances from the rectangle's boundary: by Koebe's and de Branges's bounds of
/// the derivatives those of fourth order are off by 4e-7 at most.
const STEP: f64 = 0.01;

/// The map of the rectangle onto a quadrilateral.
struct RectangleMap<'a> {
    boundary: BoundaryMap<'a>,
    inside: CauchyIntegral,
    size: DVec2,
}

impl Quadrilateral {
    /// The grid with these numbers of cells along the sides from corner 1 to 2 and from corner 2 to 3. `progress` is called
    /// with the completed fraction.
    pub fn grid(
        &self,
        cells: GridCells,
        progress: &(dyn Fn(f64) + Sync),
    ) -> Result<OrthogonalGrid, QuadrilateralError> {
        let map = RectangleMap::new(self)?;
        let [n, m] = cells.0;
        let row = |j: u32| {
            progress(f64::from(j) / f64::from(m + 1));
            (0..=n).into_par_iter().map(move |i| Place { cells: [n, m], at: [i, j] })
        };
        let images: Vec<(DVec2, f64)> =
            (0..=m).flat_map(|j| row(j).map(|place| map.node(place)).collect::<Vec<_>>()).collect();
        let deviation = map.deviation(cells);
        let image_error = images.iter().map(|(_, error)| *error).fold(0.0, f64::max);
        Ok(OrthogonalGrid { cells, nodes: images.into_iter().map(|(node, _)| node).collect(), image_error, deviation })
    }
}

/// A node of the lattice.
#[derive(Debug, Clone, Copy)]
struct Place {
    cells: [u32; 2],
    at: [u32; 2],
}

impl Place {
    /// The point of the rectangle's boundary; `None` inside. Shares count from the nearer end of each side's first corner.
    fn on_boundary(self) -> Option<CurvePoint> {
        let ([n, m], [i, j]) = (self.cells, self.at);
        let share = |k: u32, of: u32| f64::from(k) / f64::from(of);
        let along = |piece: usize, k: u32, of: u32| {
            if 2 * k <= of { CurvePoint::new(piece, share(k, of)) } else { CurvePoint::before_end(piece, share(of - k, of)) }
        };
        match (i, j) {
            (_, 0) => Some(along(0, i, n)),
            _ if i == n => Some(along(1, j, m)),
            _ if j == m => Some(along(2, n - i, n)),
            (0, _) => Some(along(3, m - j, m)),
            _ => None,
        }
    }

    fn position(self, size: DVec2) -> DVec2 {
        let share = |k: usize| f64::from(self.at[k]) / f64::from(self.cells[k]);
        size * DVec2::new(share(0), share(1))
    }
}

impl<'a> RectangleMap<'a> {
    fn new(quadrilateral: &'a Quadrilateral) -> Result<Self, QuadrilateralError> {
        let size = DVec2::new(1.0, quadrilateral.modulus.value);
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        let rectangle = Curve::new((0..4).map(|k| Piece::Line([corners[k], corners[(k + 1) % 4]])).collect())?;
        let boundary = BoundaryMap::new(quadrilateral);
        let inside = CauchyIntegral::new(&rectangle, &boundary.breaks(), &boundary);
        Ok(Self { boundary, inside, size })
    }

    /// The image of a node and its error.
    fn node(&self, place: Place) -> (DVec2, f64) {
        if let Some(at) = place.on_boundary() {
            return (self.boundary.value(at), self.boundary.error(at));
        }
        let found = self.inside.evaluate(place.position(self.size));
        (found.value, found.error)
    }

    /// [`OrthogonalGrid::deviation`].
    fn deviation(&self, cells: GridCells) -> Option<f64> {
        let [n, m] = cells.0;
        let count = (n as usize - 1) * (m as usize - 1);
        let angle = |k: usize| {
            let (i, j) = (k % (n as usize - 1), k / (n as usize - 1));
            self.angle(Place { cells: cells.0, at: [i as u32 + 1, j as u32 + 1] }.position(self.size))
        };
        let step = count.div_ceil(MEASURED).max(1);
        let off = |k: usize| (angle(k * step).to_degrees() - 90.0).abs();
        (0..count.div_ceil(step)).into_par_iter().map(off).reduce_with(f64::max)
    }

    /// The angle between the two lines through a point.
    fn angle(&self, w: DVec2) -> f64 {
        let from_boundary = w.min_element().min((self.size - w).min_element());
        let step = STEP * from_boundary;
        let difference = |direction: DVec2| {
            let at = |k: f64| self.inside.evaluate(w + k * step * direction).value;
            8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))
        };
        difference(DVec2::X).angle_to(difference(DVec2::Y))
    }
}
