//! The numbers of a planar map: its boundary correspondence as CSV, the mapped mesh as OBJ.

use crate::conformal::{ConformalMap, Direction, Side};
use crate::geometry::DVec2;
use crate::outline::BoundaryPoint;
use std::fmt::Write as _;

/// The columns of [`boundary_csv`], with their units.
pub const BOUNDARY_COLUMNS: &str = "s1 (share of arc length),s2 (share of arc length),x1 (source units),y1 (source units),\
     x2 (target units),y2 (target units),harmonic measure (from 0 to 1)";

/// The boundary correspondence: pairs of points of the two outlines that are mapped to each other.
///
/// One line for each boundary vertex of the mapped side, counter-clockwise from the anchor y: s₁ and s₂, the shares of
/// the outlines' arc lengths from their first points; both places; the harmonic measure ω̃ from the anchor, which is the
/// same on both sides. ω̃ never decreases; s₁ and s₂ neither, but for one step from 1 to 0.
pub fn boundary_csv(map: &ConformalMap) -> String {
    let mapped = map.direction().mapped_side();
    let [samples, others] = [mapped, mapped.other()].map(|side| &map.domain(side).samples);
    let measure = map.measure(mapped);
    let mut text = format!("{BOUNDARY_COLUMNS}\n");
    for k in measure.vertices() {
        let (point, image) = (BoundaryPoint { edge: k as u32, fraction: 0.0 }, map.correspondence().points[k]);
        let ours = (samples.fraction_at(point), samples.position(point));
        let theirs = (others.fraction_at(image), others.position(image));
        let [(s1, p1), (s2, p2)] = if mapped == Side::Source { [ours, theirs] } else { [theirs, ours] };
        let _ = writeln!(text, "{s1},{s2},{},{},{},{},{}", p1.x, p1.y, p2.x, p2.y, measure.at_vertex(k));
    }
    text
}

/// The target as the map paints it: `v` lies in the target, `vt` are source coordinates, one for each, not scaled.
pub fn mapped_obj(map: &ConformalMap) -> String {
    let mesh = map.mapped_mesh();
    let (positions, coordinates): (&[DVec2], &[DVec2]) = match map.direction() {
        Direction::Forward => (map.images(), &mesh.vertices),
        Direction::Backward => (&mesh.vertices, map.images()),
    };
    let mut text = String::from("# riemap: v lies in the target, vt are source coordinates (not scaled)\n");
    for p in positions {
        let _ = writeln!(text, "v {} {} 0", p.x, p.y);
    }
    for t in coordinates {
        let _ = writeln!(text, "vt {} {}", t.x, t.y);
    }
    for [a, b, c] in mesh.triangles.iter().map(|t| t.map(|v| v + 1)) {
        let _ = writeln!(text, "f {a}/{a} {b}/{b} {c}/{c}");
    }
    text
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
