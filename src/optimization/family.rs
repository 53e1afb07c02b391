//! All conformal maps of one side onto another, in closed form: f = g₂⁻¹ ∘ T ∘ g₁ with the sides' maps g₁, g₂ to the unit
//! disk and a Möbius map T of the disk onto itself, so that
//!
//! ln |f′| = ln |g₁′| + ln |T′| ∘ g₁ − ln |g₂′| ∘ f.
//!
//! The criterion is summed over triangles of one side: that whose mesh is mapped or, for a region, the source. Many
//! triangles are represented by some of them at equal steps of area. g₁, g₂ come from finite elements: values are those of
//! the map up to their error (1 % with the usual meshes), which is why the best map is measured as a whole.

use super::chart::Chart;
use super::criterion::Value;
use super::soundness::{Q_FACTOR, penalty};
use super::statistics::{Scales, thinned};
use super::symmetry::Images;
use super::{Criterion, SharedSymmetries};
use crate::conformal::{Constraints, InteriorPoint, Moebius, PerSide, Side, TriangleDistortion, Unfold};
use crate::geometry::{DVec2, DVec3};
use crate::mesh::TriangleId;
use num_complex::Complex64;

/// The least distance from the circle, in the disk, of the image of a point that is moved there: with less, f64 leaves
/// fewer than four digits to a Möbius map's scale.
const LEAST_DISTANCE: f64 = 1e-11;

/// Of a triangle whose image in the disk has at least this height, area and corners have two digits: positions are solved for
/// to 1e-14.
const LEAST_HEIGHT: f64 = 1e-12;

/// A map for which more than this share of the weight has no place on the other side has no value: its criterion would be
/// that of the rest, and walks that find nothing take a hundred times as long as others.
const MOST_MISSING: f64 = 0.05;

/// The Q that a flipped triangle counts as, and the largest one: that of a triangle all of whose image is a segment.
const FLIPPED_Q: f64 = 1e3;

/// The mean Q in the disk is limited only from here: the usual meshes have 1.02 there.
const Q_LIMITED: f64 = 1.1;

/// A point whose image is farther than this from the middle is replaced by one half way where it is the point that stays.
const FAR: f64 = 0.98;

/// Both charts and what the criterion is summed over.
#[derive(Debug)]
pub struct Family {
    charts: PerSide<Chart>,
    criterion: Criterion,
    /// The side whose triangles are summed over.
    side: Side,
}

/// Triangles of a side, each with the last triangle of the other side in which its image was found.
#[derive(Debug, Clone, Default)]
pub struct Nodes {
    all: Vec<Node>,
    /// Of all of them.
    weight: f64,
    scales: Scales,
    /// The mean Q in the disk beyond which values grow.
    most_q: f64,
}

#[derive(Debug, Clone)]
struct Node {
    image: Complex64,
    size: Size,
    weight: f64,
    near: TriangleId,
    /// The images of the places to which the side's symmetries move it, each with the last triangle as above.
    moved: Vec<Option<(Complex64, TriangleId)>>,
}

/// How a triangle's scale under T ∘ g is found.
#[derive(Debug, Clone, Copy)]
enum Size {
    /// By the corners of its image under g, ln of its own area, and its own shape: as the scale is measured on a map, also where the mesh is
    /// too coarse for ln |g′|.
    Corners { corners: [Complex64; 3], ln_area: f64, shape: [DVec2; 3] },
    /// By ln |g′| at its middle: its image is too small for the digits of the disk.
    Derivative(f64),
}

impl Node {
    /// ln of the scale under T ∘ g.
    fn scale(&self, map: &Moebius) -> f64 {
        match self.size {
            Size::Corners { corners, ln_area, .. } => 0.5 * (map.area(corners).abs().ln() - ln_area),
            Size::Derivative(scale) => scale + map.log_scale(self.image),
        }
    }

    /// Q under T ∘ g; `None` where the image is too small.
    fn q(&self, map: &Moebius) -> Option<f64> {
        let Size::Corners { corners, shape, .. } = self.size else { return None };
        let found = TriangleDistortion::of(shape, map.triangle(corners), 0.0);
        Some(if found.flipped { FLIPPED_Q } else { found.q.min(FLIPPED_Q) })
    }
}

impl Nodes {
    /// Whether there is nothing to sum over.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The mean Q of the triangles under T ∘ g; 1 where none has one.
    fn mean_q(&self, map: &Moebius) -> f64 {
        let of_nodes = self.all.iter().filter_map(|node| Some((node.q(map)?, node.weight)));
        let (sum, weight) = of_nodes.fold((0.0, 0.0), |(sum, total), (q, weight)| (sum + weight * q, total + weight));
        if weight > 0.0 { sum / weight } else { 1.0 }
    }
}

impl Family {
    /// The family over both charts; `mapped` is the side whose mesh is mapped.
    pub fn new(charts: PerSide<Chart>, criterion: Criterion, mapped: Side) -> Self {
        let side = if criterion.region().is_some() { Side::Source } else { criterion.mapped().unwrap_or(mapped) };
        Self { charts, criterion, side }
    }

    /// As [`Self::nodes`], for a search that begins at `start`: values grow where T distorts the triangles.
    pub fn limited_nodes(&self, most: usize, start: &Constraints) -> Nodes {
        let mut nodes = self.nodes(most);
        let onto = |map: Moebius| if self.side == Side::Source { map } else { map.inverse() };
        let of_start = self.moebius(start).map_or(1.0, |map| nodes.mean_q(&onto(map)));
        // the disks of outlines are as fine as their samples ask for, and their maps are refined
        if self.charts[self.side].prepared().is_surface() {
            nodes.most_q = (Q_FACTOR * of_start).max(Q_LIMITED);
        }
        nodes
    }

    /// Triangles that stand for all, about `most` of them at most.
    pub fn nodes(&self, most: usize) -> Nodes {
        let chart = &self.charts[self.side];
        let start = self.charts[self.side.other()].middle();
        let weighted = chart.triangles().map(|(t, area)| {
            let share = self.criterion.region().map_or(1.0, |region| region.share(chart.corners(t)));
            (t, share * area)
        });
        let nodes = thinned(weighted.filter(|(_, weight)| *weight > 0.0).collect(), most);
        let node = |(t, weight)| {
            let (image, scale) = chart.at_middle(t);
            let size = size_in_disk(chart, t).unwrap_or(Size::Derivative(scale));
            let motions = self.criterion.symmetries().into_iter().flat_map(SharedSymmetries::motions);
            let place = chart.corners(t).into_iter().sum::<DVec3>().truncate() / 3.0;
            let moved = motions.map(|motion| Some((chart.image(motion.moved(place).into())?, start)));
            let moved = moved.collect();
            Node { image, size, weight, near: start, moved }
        };
        let all: Vec<Node> = nodes.into_iter().map(node).collect();
        let weight = all.iter().map(|node| node.weight).sum();
        Nodes { weight, all, scales: Scales::default(), most_q: f64::INFINITY }
    }

    /// The criterion for the map with T from the source's disk onto the target's.
    pub fn value(&self, nodes: &mut Nodes, map: &Moebius) -> Value {
        let map = if self.side == Side::Source { *map } else { map.inverse() };
        let other = &self.charts[self.side.other()];
        nodes.scales.clear();
        let (mut missing, most_missing) = (0.0, MOST_MISSING * nodes.weight);
        for node in &mut nodes.all {
            let Some(found) = other.locate(map.image(node.image), node.near) else {
                node.near = other.middle();
                missing += node.weight;
                if missing > most_missing {
                    return Value::NONE;
                }
                nodes.scales.miss(node.weight);
                continue;
            };
            node.near = found.triangle();
            nodes.scales.push(node.scale(&map) - other.scale(found), node.weight);
        }
        let of_scales = self.criterion.of(&mut nodes.scales).unwrap_or(f64::INFINITY);
        let is_limited = nodes.most_q.is_finite();
        let penalty = if is_limited { penalty(nodes.mean_q(&map) / nodes.most_q, of_scales) } else { 0.0 };
        let Some(shared) = self.criterion.symmetries() else {
            return Value { criterion: of_scales, objective: of_scales + penalty };
        };
        let mismatch = mismatch(shared, &mut nodes.all, other, &map);
        Value { criterion: mismatch, objective: mismatch + of_scales + penalty }
    }

    /// T of the map with these constraints; `None` if a point is not inside of its side's mesh.
    pub fn moebius(&self, constraints: &Constraints) -> Option<Moebius> {
        let to_middle = |side: Side| {
            let map = Moebius::to_middle(self.charts[side].image(constraints.points[side])?)?;
            let anchor = map.apply(self.charts[side].on_circle(constraints.anchors[side]));
            Some((map, anchor))
        };
        let (source, target) = (to_middle(Side::Source)?, to_middle(Side::Target)?);
        let turn = Moebius::turn((target.1 / source.1).arg());
        Some(target.0.inverse().after(&turn).after(&source.0))
    }

    /// T that takes a point of the source's disk to one of the target's, turned by an angle.
    pub fn through(pair: PerSide<Complex64>, turn: f64) -> Option<Moebius> {
        let (source, target) = (Moebius::to_middle(pair.source)?, Moebius::to_middle(pair.target)?);
        Some(target.inverse().after(&Moebius::turn(turn)).after(&source))
    }

    /// Places of a side's disk, evenly spread over the side's area.
    pub fn spread(&self, side: Side, count: usize) -> Vec<Complex64> {
        let chart = &self.charts[side];
        let chosen = thinned(chart.triangles().collect(), count);
        let places = chosen.into_iter().map(|(t, _)| chart.at_middle(t).0);
        places.filter(|place| place.norm() < 1.0 - LEAST_DISTANCE).collect()
    }

    /// The point that stays while maps near `map` are tried, beginning at `start`: the target's, or the source's if the
    /// source is a surface over an outline; where its partner would be next to the boundary, one half way.
    pub fn staying(&self, start: &Constraints, map: &Moebius) -> Staying {
        let is_surface = |side: Side| self.charts[side].prepared().is_surface();
        let side = if is_surface(Side::Source) && !is_surface(Side::Target) { Side::Source } else { Side::Target };
        let at = self.charts[side].image(start.points[side]).unwrap_or_default();
        let onto = |side: Side| if side == Side::Source { *map } else { map.inverse() };
        let stays = Staying { side, at, point: Some(start.points[side]), anchor: start.anchors.source };
        if at.norm() <= FAR && onto(side).image(at).norm() <= FAR {
            return stays;
        }
        let half = Moebius::half_way(onto(side).inverse().image(Complex64::ZERO));
        Staying { at: half, point: self.charts[side].point(half), ..stays }
    }

    /// The constraints of the map with T; `None` if its moving point is next to the boundary.
    pub fn constraints(&self, map: &Moebius, stays: &Staying) -> Option<Constraints> {
        let (side, other) = (stays.side, stays.side.other());
        let onto = if side == Side::Source { *map } else { map.inverse() };
        let image = Some(onto.image(stays.at)).filter(|image| image.norm() < 1.0 - LEAST_DISTANCE)?;
        let (fixed, moving) = (stays.point?, self.charts[other].point(image)?);
        let anchor = self.charts.target.fraction(map.apply(self.charts.source.on_circle(stays.anchor)));
        let points = PerSide::from_fn(|at| if at == side { fixed } else { moving });
        Some(Constraints::new((points.source, stays.anchor), (points.target, anchor)))
    }

    /// Constraints between two others: points go along the disks' shortest ways, boundary points along the shorter arcs.
    pub fn between(&self, from: &Constraints, to: &Constraints, t: f64) -> Option<Constraints> {
        let place = |side: Side| {
            let chart = &self.charts[side];
            let [a, b] = [from, to].map(|at| chart.image(at.points[side]));
            let point = chart.point(Moebius::along(a?, b?, t)?)?;
            let [a, b] = [from, to].map(|at| chart.on_circle(at.anchors[side]));
            Some((point, chart.fraction(a * Complex64::from_polar(1.0, t * (b / a).arg()))))
        };
        Some(Constraints::new(place(Side::Source)?, place(Side::Target)?))
    }

    /// Turns of either disk about its middle within a map, so that it takes one boundary point to the other: equally good
    /// maps if the side is a disk with its default point in the middle.
    pub fn turned(&self, map: &Moebius, anchors: PerSide<f64>) -> [Moebius; 2] {
        let at = PerSide::from_fn(|side| self.charts[side].on_circle(anchors[side]));
        let after = Moebius::turn((at.target / map.apply(at.source)).arg());
        let before = Moebius::turn((map.inverse().apply(at.target) / at.source).arg());
        [after.after(map), map.after(&before)]
    }
}

/// The corners of a triangle in the disk and ln of its area; `None` where they are too close to each other.
fn size_in_disk(chart: &Chart, triangle: usize) -> Option<Size> {
    let corners = chart.at_corners(triangle);
    let [a, b, c] = chart.corners(triangle);
    let area = 0.5 * (b - a).cross(c - a).length();
    let shape = DVec3::unfold([a, b, c]);
    let longest = (0..3).map(|k| (corners[k] - corners[(k + 1) % 3]).norm()).fold(0.0, f64::max);
    let height = 2.0 * Moebius::turn(0.0).area(corners).abs() / longest;
    (height > LEAST_HEIGHT && area > 0.0).then(|| Size::Corners { corners, ln_area: area.ln(), shape })
}

/// The mismatch of the map with T from the nodes' disk onto the other side's.
fn mismatch(shared: &SharedSymmetries, nodes: &mut [Node], other: &Chart, map: &Moebius) -> f64 {
    let place = |image: Complex64, near: &mut TriangleId| {
        let found = other.locate(map.image(image), *near)?;
        *near = found.triangle();
        other.position(found).in_plane()
    };
    let places: Vec<_> = nodes.iter_mut().map(|node| place(node.image, &mut node.near)).collect();
    let images = |k: usize| {
        let of_node = |(node, at): (&mut Node, &Option<DVec2>)| {
            let (image, near) = node.moved[k].as_mut()?;
            Some(Images { place: (*at)?, moved: place(*image, near)?, weight: node.weight })
        };
        nodes.iter_mut().zip(&places).filter_map(of_node).collect()
    };
    shared.mismatch(images).unwrap_or(f64::INFINITY)
}

/// What stays while maps are tried: a point of one side, and the source's boundary point.
#[derive(Debug, Clone, Copy)]
pub struct Staying {
    side: Side,
    at: Complex64,
    point: Option<InteriorPoint>,
    anchor: f64,
}
