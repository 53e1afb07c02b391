//! Which columns of a table are x and y.

use super::rows::Row;

/// The columns that are read, and how many are left out although they vary.
pub(super) struct Columns {
    pub x: usize,
    pub y: usize,
    pub dropped: usize,
}

/// The least number of rows in which consecutive numbers are told from coordinates.
const LEAST_INDEXED: usize = 3;

/// What headers call the columns.
const X: [&str; 7] = ["x", "lon", "lng", "long", "longitude", "easting", "east"];
const Y: [&str; 5] = ["y", "lat", "latitude", "northing", "north"];

impl Columns {
    /// `numbers`: the rows, all of the same length of at least two. `header`: the last line before them.
    pub fn of(numbers: &[Vec<f64>], header: Option<&Row>) -> Self {
        let width = numbers.first().map_or(2, Vec::len);
        let varies = |column: usize| numbers.iter().any(|row| row[column] != numbers[0][column]);
        let named = |names: &[&str]| header.filter(|row| row.fields.len() == width)?.position_of(names);
        // a third column that is constant is z = 0, not a flat y beside an index
        let is_indexed = width > 2 && numbers.len() >= LEAST_INDEXED && is_index(numbers) && varies(2);
        let first = usize::from(is_indexed);
        let (x, y) = named(&X).zip(named(&Y)).unwrap_or((first, first + 1));
        let others = (first..width).filter(|&column| column != x && column != y);
        Self { x, y, dropped: others.filter(|&column| varies(column)).count() }
    }
}

/// Whether the first column counts the rows, from 0 or from 1.
fn is_index(numbers: &[Vec<f64>]) -> bool {
    [0.0, 1.0].iter().any(|&start| numbers.iter().enumerate().all(|(k, row)| row[0] == k as f64 + start))
}
