//! The criterion as a function of x₁, all else fixed: what a drag of x₁ would give.
//!
//! Values are those of the closed form at the vertices of a planar source's mesh, in the order of the mesh, infinite on the
//! boundary; between them they are linear. They are summed over a few triangles, which is enough to tell places apart. Those
//! of the [`Marks`] are summed over many: areas are those of the maps there up to a hundredth, scales up to three. Among maps that keep symmetries almost equally well the
//! best place is that of the most even areas.

use super::chart::Chart;
use super::compass::Compass;
use super::criterion::Value;
use super::family::{Family, Nodes};
use super::{Criterion, OptimizeError};
use crate::conformal::{Constraints, MapError, MeshedDomain, PerSide, PreparedSide, Side};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use std::sync::Arc;

/// Triangles that stand for all, for the values at vertices: enough to tell places apart.
const FEW: usize = 300;
/// The same for marks.
const MANY: usize = 5000;
/// The same for marks of symmetries, where each triangle is moved by all of them: as many as in the search.
const MANY_MOVED: usize = 600;

/// The last step of the search for the best place, in steps at first.
const SMALL: f64 = 0.02;

/// The criterion over a planar source.
#[derive(Debug)]
pub struct Landscape {
    family: Family,
    nodes: Nodes,
    many: usize,
    constraints: Constraints,
    domain: Arc<MeshedDomain>,
    values: Vec<f64>,
    stage: Stage,
}

/// What is computed next.
#[derive(Debug)]
enum Stage {
    /// Values at vertices; of the best one so far what a search minimizes, and its index.
    Vertices(Option<(f64, usize)>),
    /// The best place near the best vertex; the criterion at the best one so far.
    Lowest(Compass, f64),
    /// The value in the middle of all.
    Middle(Marks),
    /// The worst value.
    Worst(Marks),
    /// Nothing; without marks if no place has a map.
    Done(Option<Marks>),
}

/// The best, the middle and the worst value of a landscape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marks {
    /// The best place.
    pub lowest: DVec2,
    /// The value there.
    pub least: f64,
    /// The value at the vertex in the middle of the order of values.
    pub middle: f64,
    /// The value at the last vertex in this order.
    pub worst: f64,
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
        let many = if criterion.symmetries().is_some() { MANY_MOVED } else { MANY };
        let family = Family::new(charts, criterion, mapped);
        let nodes = family.nodes(FEW);
        if nodes.is_empty() {
            return Err(OptimizeError::EmptyRegion);
        }
        let values = vec![f64::INFINITY; sides.source.boundary_count()];
        Ok(Self { family, nodes, many, constraints, domain: Arc::clone(domain), values, stage: Stage::Vertices(None) })
    }

    /// Continues until all values and marks are there (true) or the deadline has passed; computes at least one.
    pub fn advance(&mut self, deadline: Deadline) -> bool {
        while !self.is_complete() {
            self.stage = match std::mem::replace(&mut self.stage, Stage::Done(None)) {
                Stage::Vertices(best) => self.add_vertex(best),
                Stage::Lowest(compass, value) => self.descend(compass, value),
                Stage::Middle(marks) => {
                    Stage::Worst(Marks { middle: self.value_of_rank(0.5).max(marks.least), ..marks })
                }
                Stage::Worst(marks) => {
                    Stage::Done(Some(Marks { worst: self.value_of_rank(1.0).max(marks.middle), ..marks }))
                }
                done @ Stage::Done(_) => done,
            };
            if deadline.is_over() {
                break;
            }
        }
        self.is_complete()
    }

    fn value(&mut self, x: DVec2) -> Value {
        let at = self.constraints.with_point(Side::Source, x);
        self.family.moebius(&at).map_or(Value::NONE, |map| self.family.value(&mut self.nodes, &map))
    }

    fn add_vertex(&mut self, best: Option<(f64, usize)>) -> Stage {
        let vertex = self.values.len();
        let Some(&x) = self.domain.mesh().vertices().get(vertex) else {
            let Some((_, vertex)) = best else { return Stage::Done(None) };
            self.nodes = self.family.nodes(self.many);
            let step = self.reach(vertex);
            let compass = Compass::new(self.domain.mesh().vertices()[vertex], step, SMALL * step);
            return Stage::Lowest(compass, self.values[vertex]);
        };
        let value = self.value(x);
        self.values.push(value.criterion);
        let is_better = value.objective < best.map_or(f64::INFINITY, |(least, _)| least);
        Stage::Vertices(if is_better { Some((value.objective, vertex)) } else { best })
    }

    /// The length of the longest edge at a vertex.
    fn reach(&self, vertex: usize) -> f64 {
        let mesh = self.domain.mesh();
        let around = mesh.triangles().iter().filter(|corners| corners.iter().any(|&v| v as usize == vertex));
        let lengths = around.flatten().map(|&v| mesh.vertices()[v as usize].distance(mesh.vertices()[vertex]));
        lengths.fold(0.0, f64::max)
    }

    fn descend(&mut self, mut compass: Compass, least: f64) -> Stage {
        if let Some(x) = compass.question() {
            let value = self.value(x);
            let is_best = compass.answer(value.objective);
            return Stage::Lowest(compass, if is_best { value.criterion } else { least });
        }
        Stage::Middle(Marks { lowest: compass.best(), least, middle: least, worst: least })
    }

    /// The value at the vertex at this share of the order of finite values, of which there is one; summed over many triangles
    /// if it is finite then, too.
    fn value_of_rank(&mut self, share: f64) -> f64 {
        let mut order: Vec<usize> = (0..self.values.len()).filter(|&v| self.values[v].is_finite()).collect();
        order.sort_by(|&a, &b| self.values[a].total_cmp(&self.values[b]));
        let vertex = order[(share * (order.len() - 1) as f64) as usize];
        let value = self.value(self.domain.mesh().vertices()[vertex]).criterion;
        if value.is_finite() { value } else { self.values[vertex] }
    }

    /// Whether all values and marks are there.
    pub fn is_complete(&self) -> bool {
        matches!(self.stage, Stage::Done(_))
    }

    /// The best, the middle and the worst value; `None` before they are there, and if no place has a map.
    pub fn marks(&self) -> Option<Marks> {
        if let Stage::Done(marks) = self.stage { marks } else { None }
    }

    /// The source whose vertices the values belong to.
    pub fn domain(&self) -> &MeshedDomain {
        &self.domain
    }

    /// The values so far.
    pub fn values(&self) -> &[f64] {
        &self.values
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
