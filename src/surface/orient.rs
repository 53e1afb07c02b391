//! Decides which triangles to reverse so that neighbors traverse their common edge in opposite directions.

use super::TopologyError;
use super::edges::{NO_TWIN, ends};
use crate::mesh::TriangleId;

/// Whether to reverse each triangle: in each component the minority. An error for one-sided surfaces, which have no
/// orientation. Cost O(n).
pub(super) fn turned(triangles: &[[u32; 3]], twins: &[u32]) -> Result<Vec<bool>, TopologyError> {
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    for start in 0..triangles.len() {
        if turned[start].is_some() {
            continue;
        }
        let members = orient_component(triangles, twins, start, &mut turned)?;
        let many = members.iter().filter(|&&t| turned[t] == Some(true)).count() > members.len() / 2;
        for t in members.into_iter().filter(|_| many) {
            turned[t] = turned[t].map(|turned| !turned);
        }
    }
    Ok(turned.into_iter().map(|turned| turned == Some(true)).collect())
}

/// Decides for the component of `start` which triangles must be reversed to agree with it; returns the members.
fn orient_component(
    triangles: &[[u32; 3]],
    twins: &[u32],
    start: usize,
    turned: &mut [Option<bool>],
) -> Result<Vec<usize>, TopologyError> {
    turned[start] = Some(false);
    let (mut pending, mut members) = (vec![start], Vec::new());
    while let Some(t) = pending.pop() {
        members.push(t);
        for (half, &twin) in (3 * t as u32..).zip(&twins[3 * t..3 * t + 3]).filter(|(_, twin)| **twin != NO_TWIN) {
            let same = ends(triangles, half) == ends(triangles, twin);
            let wanted = turned[t].map(|turned| turned != same);
            let other = twin as usize / 3;
            if turned[other].is_none() {
                turned[other] = wanted;
                pending.push(other);
            } else if turned[other] != wanted {
                return Err(TopologyError::OneSided { triangle: TriangleId::new(other as u32) });
            }
        }
    }
    Ok(members)
}
