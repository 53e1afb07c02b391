//! The criterion as a function of x₁, all else fixed: what a drag of x₁ would give.
//!
//! Values are those of the closed form at the vertices of a planar source's mesh, in the order of the mesh, infinite on the
//! boundary; between them they are linear.

use super::chart::Chart;
use super::family::{Family, Nodes};
use super::{Criterion, OptimizeError};
use crate::conformal::{Constraints, MapError, MeshedDomain, PerSide, PreparedSide, Side};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use std::sync::Arc;

/// Triangles that stand for all.
const FEW: usize = 300;

/// The criterion over a planar source.
#[derive(Debug)]
pub struct Landscape {
    family: Family,
    nodes: Nodes,
    constraints: Constraints,
    domain: Arc<MeshedDomain>,
    values: Vec<f64>,
}

impl Landscape {
    /// A landscape with the boundary points and x₂ of `constraints`; `mapped` is the side whose mesh is mapped.
    ///
    /// Errors: the source is a surface; a side's map to the disk cannot be computed; nothing lies in the region.
    pub fn new(
        sides: &PerSide<Arc<PreparedSide>>,
        criterion: Criterion,
        constraints: Constraints,
        mapped: Side,
    ) -> Result<Self, OptimizeError> {
        let domain = sides.source.domain().ok_or(MapError::OtherKind { side: Side::Source })?;
        let charts = PerSide::new(Chart::new(Side::Source, &sides.source)?, Chart::new(Side::Target, &sides.target)?);
        let family = Family::new(charts, criterion, mapped);
        let nodes = family.nodes(FEW);
        if nodes.is_empty() {
            return Err(OptimizeError::EmptyRegion);
        }
        let values = vec![f64::INFINITY; sides.source.boundary_count()];
        Ok(Self { family, nodes, constraints, domain: Arc::clone(domain), values })
    }

    /// Continues until all values are there (true) or the deadline has passed; computes at least one.
    pub fn advance(&mut self, deadline: Deadline) -> bool {
        let vertices = self.domain.mesh().vertices();
        while let Some(&x) = vertices.get(self.values.len()) {
            let at = self.constraints.with_point(Side::Source, x);
            let value = self.family.moebius(&at).map(|map| self.family.value(&mut self.nodes, &map));
            self.values.push(value.unwrap_or(f64::INFINITY));
            if deadline.is_over() {
                break;
            }
        }
        self.is_complete()
    }

    /// Whether all values are there.
    pub fn is_complete(&self) -> bool {
        self.values.len() == self.domain.mesh().vertices().len()
    }

    /// The source whose vertices the values belong to.
    pub fn domain(&self) -> &MeshedDomain {
        &self.domain
    }

    /// The values so far.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The place of the least value so far, and that value.
    pub fn lowest(&self) -> Option<(DVec2, f64)> {
        let known = self.domain.mesh().vertices().iter().copied().zip(self.values.iter().copied());
        known.filter(|(_, value)| value.is_finite()).min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The level line at a finite value, as segments, one for each triangle that it crosses. None before all values are there.
    pub fn level_line(&self, level: f64) -> Vec<[DVec2; 2]> {
        let mesh = self.domain.mesh();
        let crossing = |&[a, b]: &[u32; 2]| {
            let [p, q] = [a, b].map(|v| self.values.get(v as usize).copied().unwrap_or(f64::INFINITY));
            let [from, to] = [a, b].map(|v| mesh.vertices()[v as usize]);
            // an edge to the boundary is crossed in its middle
            let share = if p.is_finite() && q.is_finite() { (level - p) / (q - p) } else { 0.5 };
            ((p < level) != (q < level)).then(|| from.lerp(to, share))
        };
        let segment = |&[a, b, c]: &[u32; 3]| {
            let found: Vec<DVec2> = [[a, b], [b, c], [c, a]].iter().filter_map(crossing).collect();
            <[DVec2; 2]>::try_from(found).ok()
        };
        mesh.triangles().iter().filter_map(segment).collect()
    }
}
