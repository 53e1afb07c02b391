//! What `riemap flatten` says about the outline's corners.

use crate::conformal::CornerCuts;
use crate::counted::counted;
use crate::export::{Division, Flattened};

/// How the outline's corners are hit.
#[derive(Debug, serde::Serialize)]
pub struct Corners {
    /// Their number; a vertex is mapped to each.
    hit: usize,
    /// Those at which there was a vertex.
    reused: usize,
    /// What the new vertices divide, which follow those of the file.
    divisions: Vec<Division>,
    /// Parts of triangles that are folded, at reentrant corners.
    folded: usize,
}

impl Corners {
    /// The corners of `cuts`, by the numbers of the file.
    pub fn of(cuts: &CornerCuts, flattened: &Flattened) -> Self {
        let divisions = flattened.divisions().to_vec();
        Self { hit: cuts.at_corners().len(), reused: cuts.reused(), divisions, folded: cuts.folded() }
    }

    /// The line of the summary.
    pub fn said(&self) -> String {
        let (hit, added, folded) = (self.hit, self.divisions.len(), self.folded);
        let folded = match folded {
            0 => String::new(),
            _ => counted!(
                folded,
                "; 1 part of a triangle is folded there",
                "; {folded} parts of triangles are folded there"
            ),
        };
        let added = counted!(added, "1 new vertex", "{added} new vertices");
        counted!(hit, "1 corner is hit, with {added}{folded}", "{hit} corners are hit, with {added}{folded}")
    }
}
