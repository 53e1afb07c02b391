//! The orthogonal grid of a marked outline, as a study: its lines for the screen, or its file.
//!
//! What is made is what `riemap grid` makes: for the same outline, marks and cells the file is the same to the byte.

use super::invariants::{Number, StudiedOutline, finite};
use crate::conformal::{GridCells, Marks, Quadrilateral};
use crate::export::GridFormat;
use crate::geometry::DVec2;
use crate::language::{Message, key};
use serde::{Deserialize, Serialize};

/// The most lines that are drawn in each direction: more could not be told apart.
const MOST_LINES: u32 = 100;

/// The shares of the work up to the map and up to the nodes, roughly: the equation is solved three times or more before the
/// first node, and the lines come after the last one.
const SOLVED: f64 = 0.6;
const MADE: f64 = 0.8;

/// An outline with four marks, and the grid that is wanted between them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GridTask {
    outline: StudiedOutline,
    /// Fractions of the boundary's length from its first point.
    marks: [f64; 4],
    cells: [u32; 2],
    /// The format of the file that is wanted; `None`: the lines for the screen.
    file: Option<GridFormat>,
}

/// A grid, with what is known of its accuracy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FoundGrid {
    /// The modulus of the quadrilateral.
    pub modulus: Number,
    /// The estimated error of a node, the largest one.
    pub image_error: f64,
    /// The largest deviation of the lines' tangents from 90° at interior nodes, in degrees; `None` without such nodes.
    pub angle_deviation: Option<f64>,
    /// What was wanted.
    pub content: GridContent,
}

/// A grid for the screen, or as a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum GridContent {
    /// The lines inside in both directions, at most a hundred of each: every second or third one where there are more.
    Lines([Vec<Vec<DVec2>>; 2]),
    /// The file.
    File(String),
}

impl GridTask {
    /// The grid between the marks of an outline: its file in a format, or else its lines.
    pub fn new(outline: StudiedOutline, marks: [f64; 4], cells: GridCells, file: Option<GridFormat>) -> Self {
        Self { outline, marks, cells: cells.counts(), file }
    }

    /// The format of the file that is wanted.
    pub fn file(&self) -> Option<GridFormat> {
        self.file
    }

    /// Of how many lines one is drawn, of those that run along the sides 1 and 3, and of those across.
    pub fn strides(cells: GridCells) -> [u32; 2] {
        let [n, m] = cells.counts();
        [m, n].map(|count| count.div_ceil(MOST_LINES))
    }

    /// Makes the grid. `report` gets the share that is done and returns whether to go on; `None` if it said no. It is asked
    /// before each preparation of the integral equation, which takes the longest, and for each row of nodes.
    ///
    /// Errors: the marks are not in order, the outline has no curve, or the quadrilateral no map; in words.
    pub fn run(&self, report: &mut dyn FnMut(f64) -> bool) -> Result<Option<FoundGrid>, Message> {
        let cells = GridCells::new(self.cells).ok_or(key::no_such_row())?;
        let marks = Marks::new(self.marks).map_err(|error| Message::from(&error))?;
        let spec = self.outline.spec()?;
        let curve = spec.curve().map_err(|_| key::outline_without_curve())?.into_curve();
        let polygon = spec.polygon();
        let found = Quadrilateral::of_outline_while((&polygon, &curve), marks, &mut || report(0.0));
        let Some(quadrilateral) = found.map_err(|error| Message::from(&error))? else { return Ok(None) };
        if !report(SOLVED) {
            return Ok(None);
        }
        let map = quadrilateral.map().map_err(|error| Message::from(&error))?;
        let progress = &mut |done| report(SOLVED + (MADE - SOLVED) * done);
        let Some(grid) = map.grid(cells, progress) else { return Ok(None) };
        let content = match self.file {
            Some(format) => GridContent::File(format.text(&grid, &map, &curve)),
            None => GridContent::Lines(map.lines(cells, Self::strides(cells))),
        };
        let (modulus, image_error) = (quadrilateral.modulus().into(), finite(grid.image_error()));
        Ok(Some(FoundGrid { modulus, image_error, angle_deviation: grid.deviation(), content }))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::outline::Preset;
    use crate::worker::{packed, unpacked};

    fn task(marks: [f64; 4], cells: [u32; 2], file: Option<GridFormat>) -> GridTask {
        GridTask::new(StudiedOutline::Preset(Preset::Disk), marks, GridCells::new(cells).unwrap(), file)
    }

    #[test]
    fn a_grid_is_made_of_lines_or_as_a_file_and_crosses_as_bytes() {
        let marks = [0.0, 0.175, 0.35, 0.625];
        let found = task(marks, [6, 150], None).run(&mut |_| true).unwrap().unwrap();
        assert!((found.modulus.value - 1.045_465_950_033_828_5).abs() < 1e-12, "{:?}", found.modulus);
        assert!(found.image_error < 1e-6 && found.angle_deviation.unwrap() < 1e-5);
        let GridContent::Lines([rows, columns]) = &found.content else { panic!() };
        assert_eq!([rows.len(), columns.len()], [74, 5], "every second of 149, and all of 5");
        assert_eq!(unpacked::<FoundGrid>(&packed(&found)).unwrap(), found);
        let file = task(marks, [2, 1], Some(GridFormat::Csv));
        assert_eq!(unpacked::<GridTask>(&packed(&file)).unwrap(), file);
        let GridContent::File(text) = file.run(&mut |_| true).unwrap().unwrap().content else { panic!() };
        assert_eq!(text.lines().count(), 1 + 3 * 2);
    }

    #[test]
    fn a_grid_is_cancelled_and_refused_in_words() {
        let whole = task([0.0, 0.25, 0.625, 0.75], [40, 40], None);
        let (mut calls, mut last) = (0, 0.0);
        let found = whole.run(&mut |done| {
            assert!(done >= last, "{done} after {last}");
            (calls, last) = (calls + 1, done);
            calls < 5
        });
        assert_eq!((found.unwrap(), calls), (None, 5));
        // the first question comes before the equation of the finer resolution, long before the first node
        let mut shares = Vec::new();
        let found = whole.run(&mut |done| {
            shares.push(done);
            false
        });
        assert_eq!((found.unwrap(), shares), (None, vec![0.0]));
        let refused = |marks| task(marks, [4, 4], None).run(&mut |_| true).unwrap_err().english();
        assert!(refused([0.0, 0.5, 0.25, 0.75]).contains("counter-clockwise"), "{}", refused([0.0, 0.5, 0.25, 0.75]));
        assert_eq!(refused([0.0, 0.25, 0.25, 0.75]), "marks 2 and 3 are the same point");
    }
}
