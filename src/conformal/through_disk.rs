//! The images of a surface's vertices on another surface, through the unit disk.
//!
//! Both surfaces are mapped to the disk, each by its own measure (see `disk_coordinates`): f = g₂⁻¹ ∘ g₁ takes x₁ to x₂
//! and y₁ to y₂. Boundary vertices are mapped by the matched measures, which keep the digits that the disk rounds
//! away; an interior vertex goes to the point of the other surface that has the same position in the disk. A walk from
//! triangle to triangle locates it, starting near a neighbor; a vertex that no walk locates is a stray, and goes to the
//! nearest point in the disk.

use super::subdivision::Cuts;
use super::{BoundaryCorrespondence, MeshedSurface, PerSide, Side};
use crate::geometry::{DVec2, DVec3};
use crate::laplace::Deadline;
use crate::mesh::{BarycentricPoint, DiskLayout, NO_TRIANGLE, TriMesh, TriangleId};
use crate::surface::SurfaceTree;
use std::sync::OnceLock;

/// Steps of walks, and triangles visited, between two checks of the deadline: 0.3 ms.
const BLOCK: usize = 4096;

/// The value for a vertex that is not located yet.
const NOWHERE: BarycentricPoint = BarycentricPoint::new(TriangleId::new(NO_TRIANGLE), [0.0; 3]);

/// The images of a mapped surface's vertices on the other one; one point and its position for each vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SurfaceImages {
    points: Vec<BarycentricPoint>,
    places: Vec<DVec3>,
}

impl SurfaceImages {
    /// The images as points of the other surface.
    pub fn points(&self) -> &[BarycentricPoint] {
        &self.points
    }

    /// The positions of the images in space.
    pub fn places(&self) -> &[DVec3] {
        &self.places
    }

    /// The images of these vertices, in the other surface's own mesh.
    pub(super) fn at_own_vertices(&self, vertices: &[usize], cuts: Cuts) -> Self {
        Self {
            points: vertices.iter().map(|&v| cuts.coarser(self.points[v])).collect(),
            places: vertices.iter().map(|&v| self.places[v]).collect(),
        }
    }
}

/// The image of a side in the unit disk.
#[derive(Debug, Default)]
pub(super) struct DiskImage {
    /// g at the vertices.
    places: Vec<DVec2>,
    /// The search tree for nearest points; built for the first stray.
    tree: OnceLock<SurfaceTree>,
}

impl DiskImage {
    /// g at the vertices.
    pub fn places(&self) -> &[DVec2] {
        &self.places
    }

    /// The search tree for nearest points among `triangles`; built on the first call.
    fn tree(&self, triangles: &[[u32; 3]]) -> &SurfaceTree {
        let place = |v: u32| self.places[v as usize].extend(0.0);
        self.tree.get_or_init(|| SurfaceTree::of(triangles.iter().map(|corners| corners.map(place)).collect()))
    }

    /// g at the vertices, for overwriting. The search tree is dropped.
    pub fn places_mut(&mut self) -> &mut Vec<DVec2> {
        self.tree.take();
        &mut self.places
    }
}

/// The data of a map between two surfaces beyond those of its sides: those of the last complete update, and those
/// of the update in progress.
#[derive(Debug, Default)]
pub(super) struct ThroughDisk {
    /// Both sides in the disk.
    pub disks: PerSide<DiskImage>,
    /// How often each of `disks` was renewed.
    pub revisions: PerSide<u64>,
    pub images: SurfaceImages,
    /// The images, in the update in progress, of the sides that it recomputes.
    pub coming_disks: PerSide<DiskImage>,
    coming: SurfaceImages,
    /// By boundary edge of a side, the triangle at it; computed when the side is first mapped onto.
    edge_triangles: PerSide<Vec<u32>>,
    search: Search,
}

/// The progress of locating the vertices.
#[derive(Debug, Default)]
struct Search {
    /// The first triangle of the mapped surface whose corners are not processed.
    next: usize,
    /// By vertex, whether it was processed.
    is_done: Vec<bool>,
    /// The triangle of the other surface in which a vertex was located last.
    last: Option<TriangleId>,
    /// Vertices that no walk has located.
    strays: Vec<u32>,
    /// How many of the strays have their nearest point.
    settled: usize,
}

impl ThroughDisk {
    /// Starts locating this number of `vertices` in the other surface, `side` of the map; those of the boundary are
    /// placed as they are matched.
    pub fn begin(&mut self, vertices: usize, (other, side): (&MeshedSurface, Side), matched: &BoundaryCorrespondence) {
        let mesh = other.mesh();
        let edge_triangles = &mut self.edge_triangles[side];
        if edge_triangles.is_empty() {
            *edge_triangles = triangles_at_edges(mesh);
        }
        let points = &mut self.coming.points;
        points.clear();
        for point in matched.points() {
            let triangle = edge_triangles[point.edge() as usize];
            let next = (point.edge() + 1) % mesh.boundary_count();
            let weights = mesh.triangles()[triangle as usize].map(|v| match v {
                v if v == point.edge() => 1.0 - point.fraction(),
                v if v == next => point.fraction(),
                _ => 0.0,
            });
            points.push(BarycentricPoint::new(TriangleId::new(triangle), weights));
        }
        self.search.begin(points, vertices);
        points.resize(vertices, NOWHERE);
    }

    /// Continues until all vertices are located (true) or `deadline` has passed.
    pub fn advance(
        &mut self,
        (mapped, side): (&MeshedSurface, Side),
        other: &MeshedSurface,
        is_coming: PerSide<bool>,
        deadline: Deadline,
    ) -> bool {
        let Self { disks, coming_disks, coming, search, .. } = self;
        let [here, there] =
            [side, side.other()].map(|side| if is_coming[side] { &coming_disks[side] } else { &disks[side] });
        let mesh = other.mesh();
        let layout = DiskLayout { triangles: mesh.triangles(), neighbours: mesh.neighbours(), places: &there.places };
        let points = &mut coming.points;
        if !search.walk(mapped.mesh().triangles(), &here.places, &layout, points, deadline)
            || !search.settle(&here.places, there, mesh.triangles(), points, deadline)
        {
            return false;
        }
        coming.places.clear();
        coming.places.extend(points.iter().map(|&point| other.position(point)));
        true
    }

    /// Makes the results of a complete update visible.
    pub fn commit(&mut self, is_coming: PerSide<bool>) {
        for side in Side::BOTH.into_iter().filter(|side| is_coming[*side]) {
            let (shown, coming) = (&mut self.disks[side], &mut self.coming_disks[side]);
            std::mem::swap(shown, coming);
            self.revisions[side] += 1;
        }
        std::mem::swap(&mut self.images, &mut self.coming);
    }
}

/// By boundary edge, the triangle at it.
fn triangles_at_edges(mesh: &TriMesh<DVec3>) -> Vec<u32> {
    let mut result = vec![0; mesh.boundary_count() as usize];
    for (t, (corners, neighbours)) in mesh.triangles().iter().zip(mesh.neighbours()).enumerate() {
        for i in (0..3).filter(|&i| neighbours[i] == NO_TRIANGLE) {
            result[corners[(i + 1) % 3] as usize] = t as u32;
        }
    }
    result
}

impl Search {
    /// Starts with this number of vertices, of which the first are `located`.
    fn begin(&mut self, located: &[BarycentricPoint], vertices: usize) {
        self.next = 0;
        self.is_done.clear();
        self.is_done.resize(located.len(), true);
        self.is_done.resize(vertices, false);
        self.last = located.first().map(BarycentricPoint::triangle);
        self.strays.clear();
        self.settled = 0;
    }

    /// The triangle at which a walk starts if none nearer is known.
    fn start(&self) -> TriangleId {
        self.last.unwrap_or(TriangleId::new(0))
    }

    /// Walks to the vertices, triangle by triangle, until all are processed (true) or `deadline` has passed.
    fn walk(
        &mut self,
        triangles: &[[u32; 3]],
        here: &[DVec2],
        layout: &DiskLayout,
        points: &mut [BarycentricPoint],
        deadline: Deadline,
    ) -> bool {
        let mut steps = 0;
        while let Some(&corners) = triangles.get(self.next) {
            for v in corners {
                if !std::mem::replace(&mut self.is_done[v as usize], true) {
                    self.walk_to(v, corners, here[v as usize], layout, points, &mut steps);
                }
            }
            self.next += 1;
            steps += 1;
            if steps >= BLOCK {
                steps = 0;
                if deadline.is_over() {
                    return false;
                }
            }
        }
        true
    }

    /// Walks to a corner of a triangle, starting from another corner that is located.
    fn walk_to(
        &mut self,
        v: u32,
        corners: [u32; 3],
        x: DVec2,
        layout: &DiskLayout,
        points: &mut [BarycentricPoint],
        steps: &mut usize,
    ) {
        let near = corners.into_iter().map(|v| points[v as usize].triangle()).find(|&t| t != NOWHERE.triangle());
        match layout.locate(x, near.unwrap_or(self.start()), steps) {
            Some(point) => {
                self.last = Some(point.triangle());
                points[v as usize] = point;
            }
            None => self.strays.push(v),
        }
    }

    /// Assigns to each stray the nearest point of the other surface in the disk (where triangles are flipped, one of
    /// those that cover it), until all are done (true) or `deadline` has passed.
    fn settle(
        &mut self,
        here: &[DVec2],
        there: &DiskImage,
        triangles: &[[u32; 3]],
        points: &mut [BarycentricPoint],
        deadline: Deadline,
    ) -> bool {
        while let Some(&v) = self.strays.get(self.settled) {
            let tree = there.tree(triangles);
            // a position that is not finite passes the test of every triangle, so it is no stray
            let nearest = tree.nearest(here[v as usize].extend(0.0)).map(|(point, _)| point);
            points[v as usize] = nearest.unwrap_or(BarycentricPoint::new(self.start(), [1.0, 0.0, 0.0]));
            self.settled += 1;
            if self.settled < self.strays.len() && deadline.is_over() {
                return false;
            }
        }
        true
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use crate::conformal::{
        ConformalMap, Constraints, Direction, MapSettings, PreparedSide, SurfaceSettings, prepare_surface,
    };
    use crate::geometry::DVec3;
    use crate::laplace::Deadline;
    use crate::surface::{Surface, SurfaceMesh, SurfacePreset};
    use std::sync::Arc;

    fn prepared(surface: &Surface) -> Arc<PreparedSide> {
        let mesh = SurfaceMesh::new(surface).unwrap();
        Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap())
    }

    /// A flat strip with this number of squares along and across, all divided along the same diagonal.
    fn strip(along: u32, across: u32) -> Surface {
        let row = along + 1;
        let vertices =
            (0..row * (across + 1)).map(|v| DVec3::new(f64::from(v % row), f64::from(v / row), 0.0)).collect();
        let triangles = (0..along * across).flat_map(|q| {
            let a = q / along * row + q % along;
            [[a, a + 1, a + 1 + row], [a, a + 1 + row, a + row]]
        });
        Surface::new(vertices, triangles.collect())
    }

    /// On a crowded strip, most vertices and triangles coincide in the disk.
    #[test]
    fn few_walks_get_lost_against_a_strip() {
        let hemisphere = prepared(&SurfacePreset::Hemisphere.surface(100).unwrap());
        for strip in [strip(60, 2), strip(120, 6)].map(|surface| prepared(&surface)) {
            let at = Constraints::new((strip.default_point(), 0.1), (hemisphere.default_point(), 0.6));
            for way in [Direction::Forward, Direction::Backward] {
                let map = ConformalMap::new(Arc::clone(&strip), Arc::clone(&hemisphere), &at, way.into()).unwrap();
                let images = map.surface_images().unwrap();
                let (strays, vertices) = (map.through_disk.search.strays.len(), images.places().len());
                println!("{way:?}: {strays} of {vertices}");
                assert!(images.places().iter().all(|p| p.is_finite()));
                assert!(10 * strays <= vertices, "{way:?}: {strays} of {vertices}");
                // computed in pieces, the images are the same, strays included
                let mut pieces = ConformalMap::unmapped(Arc::clone(&strip), Arc::clone(&hemisphere));
                let settings = MapSettings::from(way);
                while !pieces.advance(&at, settings, Deadline::in_ms(0.0)).unwrap() {}
                assert_eq!(pieces.surface_images(), map.surface_images());
            }
        }
    }
}
