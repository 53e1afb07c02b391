//! Sets of lattice points, stored as column spans per row.
//!
//! The hexagonal lattice of the uniform mesher is never stored point by point:
//! a set is a sorted list of disjoint half-open column spans for each row, so
//! that inside tests, erosion and numbering cost O(spans), and only the points
//! that are needed are visited. Rows are skewed: point `(r, c)` is
//! at `x = a (c + r/2)`, `y = r a √3/2`, so its six neighbours are `(r, c±1)`,
//! `(r+1, c−1)`, `(r+1, c)`, `(r−1, c)` and `(r−1, c+1)`.

/// Columns `start … end−1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Span {
    pub start: i32,
    pub end: i32,
}

impl Span {
    pub fn len(self) -> usize {
        (self.end - self.start).max(0) as usize
    }
}

/// A set of lattice points with consecutive numbers, row by row.
#[derive(Debug, Clone, Default)]
pub(super) struct RowSpans {
    /// Row `r` is `spans[row_start[r] .. row_start[r+1]]`.
    row_start: Vec<u32>,
    spans: Vec<Span>,
    /// The number of the first point of each span.
    first: Vec<u32>,
    count: u32,
}

impl RowSpans {
    /// Builds the set from one sorted list of disjoint spans per row, in order of the rows.
    pub fn build(rows: usize, mut row: impl FnMut(usize, &mut Vec<Span>)) -> Self {
        let mut set = Self { row_start: vec![0], ..Self::default() };
        let mut scratch = Vec::new();
        for r in 0..rows {
            scratch.clear();
            row(r, &mut scratch);
            for &span in scratch.iter().filter(|span| span.start < span.end) {
                set.first.push(set.count);
                set.count += span.len() as u32;
                set.spans.push(span);
            }
            set.row_start.push(set.spans.len() as u32);
        }
        set
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.count as usize
    }

    pub fn rows(&self) -> usize {
        self.row_start.len() - 1
    }

    /// The spans of row `r`; empty outside the lattice.
    pub fn row(&self, r: usize) -> &[Span] {
        if r >= self.rows() {
            return &[];
        }
        &self.spans[self.row_start[r] as usize..self.row_start[r + 1] as usize]
    }

    /// The number of point `(r, c)`, if it belongs to the set.
    pub fn index(&self, r: usize, c: i32) -> Option<u32> {
        let row = self.row(r);
        let k = row.partition_point(|span| span.end <= c);
        let span = row.get(k).filter(|span| span.start <= c)?;
        Some(self.first[self.row_start[r] as usize + k] + (c - span.start) as u32)
    }

    /// The points whose six neighbors all belong to the set too.
    pub fn eroded(&self) -> Self {
        let (mut pair, mut triple) = (Vec::new(), Vec::new());
        Self::build(self.rows(), |r, out| {
            if r == 0 {
                return;
            }
            let own: Vec<Span> = self.row(r).iter().map(|s| Span { start: s.start + 1, end: s.end - 1 }).collect();
            // (r+1, c−1) and (r+1, c): columns [start+1, end) of the row above
            let above: Vec<Span> = self.row(r + 1).iter().map(|s| Span { start: s.start + 1, end: s.end }).collect();
            // (r−1, c) and (r−1, c+1): columns [start, end−1) of the row below
            let below: Vec<Span> = self.row(r - 1).iter().map(|s| Span { start: s.start, end: s.end - 1 }).collect();
            intersect(&own, &above, &mut pair);
            intersect(&pair, &below, &mut triple);
            out.extend_from_slice(&triple);
        })
    }
}

/// `out = a ∩ b`, for sorted disjoint spans (empty ones allowed).
pub(super) fn intersect(a: &[Span], b: &[Span], out: &mut Vec<Span>) {
    out.clear();
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let span = Span { start: a[i].start.max(b[j].start), end: a[i].end.min(b[j].end) };
        if span.start < span.end {
            out.push(span);
        }
        if a[i].end < b[j].end { i += 1 } else { j += 1 }
    }
}

/// Sorts the spans and joins those that touch or overlap.
pub(super) fn normalise(spans: &mut Vec<Span>) {
    spans.sort_unstable();
    let mut kept = 0;
    for k in 1..spans.len() {
        if spans[k].start <= spans[kept].end {
            spans[kept].end = spans[kept].end.max(spans[k].end);
        } else {
            kept += 1;
            spans[kept] = spans[k];
        }
    }
    spans.truncate(kept + 1);
}

/// `out = a ∖ b`, for normalised spans.
pub(super) fn subtract(a: &[Span], b: &[Span], out: &mut Vec<Span>) {
    out.clear();
    let mut j = 0;
    for &span in a {
        let mut start = span.start;
        while j < b.len() && b[j].end <= start {
            j += 1;
        }
        while j < b.len() && b[j].start < span.end {
            if b[j].start > start {
                out.push(Span { start, end: b[j].start });
            }
            start = start.max(b[j].end);
            if b[j].end > span.end {
                break;
            }
            j += 1;
        }
        if start < span.end {
            out.push(Span { start, end: span.end });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn span(start: i32, end: i32) -> Span {
        Span { start, end }
    }

    #[test]
    fn difference_agrees_with_the_set_of_points() {
        let a = [span(0, 10), span(12, 20), span(25, 30)];
        let mut b = vec![span(-3, 1), span(2, 4), span(3, 14), span(13, 14), span(18, 27), span(19, 20)];
        let mut out = Vec::new();
        normalise(&mut b);
        subtract(&a, &b, &mut out);
        let within = |spans: &[Span], c: i32| spans.iter().any(|s| s.start <= c && c < s.end);
        for c in -5..35 {
            assert_eq!(within(&out, c), within(&a, c) && !within(&b, c), "column {c}");
        }
    }

    #[test]
    fn erosion_keeps_the_points_with_six_neighbours() {
        let set = RowSpans::build(5, |r, out| {
            out.push(if r == 2 { span(-2, 3) } else { span(-2, 4) });
        });
        let inner = set.eroded();
        for r in 0..5 {
            for c in -4..6 {
                let has = |r: i32, c: i32| r >= 0 && set.index(r as usize, c).is_some();
                let (s, q) = (r as i32, c);
                let around = [(s, q), (s, q - 1), (s, q + 1), (s + 1, q - 1), (s + 1, q), (s - 1, q), (s - 1, q + 1)];
                let expected = around.iter().all(|&(r, c)| has(r, c));
                assert_eq!(inner.index(r, c).is_some(), expected, "row {r}, column {c}");
            }
        }
    }

    #[test]
    fn numbers_run_row_by_row() {
        let set = RowSpans::build(2, |r, out| {
            out.extend([span(0, 2), span(5, 6 + r as i32)]);
        });
        let numbers: Vec<_> = [(0, 0), (0, 1), (0, 5), (1, 0), (1, 1), (1, 5), (1, 6)]
            .map(|(r, c)| set.index(r, c).map_or(-1, |k| k as i32))
            .to_vec();
        assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!(set.len(), 7);
        assert_eq!(set.index(0, 2), None);
    }
}
