//! Tables of numbers with named columns, written as CSV.

use std::fmt;

/// A cell of a [`Table`].
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A number, written with enough digits to be read back exactly.
    Number(f64),
    /// A count or an index.
    Count(u64),
    /// A word without commas, quotes and line breaks.
    Word(String),
    /// Not applicable.
    Empty,
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<u32> for Cell {
    fn from(value: u32) -> Self {
        Self::Count(u64::from(value))
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        Self::Count(value as u64)
    }
}

impl From<&str> for Cell {
    fn from(word: &str) -> Self {
        Self::Word(word.to_owned())
    }
}

impl fmt::Display for Cell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            // with an exponent if the decimal form would be mostly zeros
            Self::Number(value) if *value != 0.0 && value.abs() < 1e-4 => write!(f, "{value:e}"),
            Self::Number(value) => write!(f, "{value}"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Word(word) => f.write_str(word),
            Self::Empty => Ok(()),
        }
    }
}

/// Rows of cells under named columns.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Table {
    /// The names of the columns.
    pub columns: &'static [&'static str],
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<Cell>>,
}

impl Table {
    /// A table without rows.
    pub fn new(columns: &'static [&'static str]) -> Self {
        Self { columns, rows: Vec::new() }
    }

    /// The table as comma-separated values; the first line holds the names.
    pub fn csv(&self) -> String {
        let mut text = self.columns.join(",");
        text.push('\n');
        for row in &self.rows {
            debug_assert_eq!(row.len(), self.columns.len(), "a row does not fit {:?}", self.columns);
            let fields: Vec<String> = row.iter().map(Cell::to_string).collect();
            text.push_str(&fields.join(","));
            text.push('\n');
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_reads_back_exactly() {
        let mut table = Table::new(&["k", "x", "word", "none"]);
        table.rows.push(vec![3_u32.into(), 1.234_567_890_123_4e-17.into(), "kernel".into(), Cell::Empty]);
        let csv = table.csv();
        assert_eq!(csv, "k,x,word,none\n3,1.2345678901234e-17,kernel,\n");
    }
}
