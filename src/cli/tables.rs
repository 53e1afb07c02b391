//! A map's numbers as JSON, with a summary.

use super::accuracy::Accuracy;
use super::chain::Chain;
use super::optimization::Optimized;
use super::output::triangles;
use super::pins::Pinned;
use super::side::Placed;
use crate::conformal::{
    ConformalMap, FrameTimings, PerSide, Places, PrepareTimings, PreparedSide, Quality, ResolvedBoundary, Side,
};
use crate::outline::Interpreted;

/// The size of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Counts {
    /// Boundary vertices.
    pub m: u32,
    /// Interior vertices.
    pub n: usize,
    /// Triangles.
    pub triangles: usize,
    /// The triangles into which those of a surface are cut for the computation, if they are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub computed_triangles: Option<usize>,
}

impl Counts {
    /// The sizes of a side's mesh.
    pub fn of_side(side: &PreparedSide) -> Self {
        let (m, triangles) = (side.boundary_count() as u32, side.triangles().len());
        Self { m, n: side.interior_count(), triangles, computed_triangles: None }
    }

    /// The sizes of the mapped mesh.
    pub fn of(map: &ConformalMap) -> Self {
        let (own, finest) = (Self::of_side(map.mapped()), map.finest().mapped().triangles().len());
        Self { computed_triangles: Some(finest).filter(|&finest| finest != own.triangles), ..own }
    }

    /// In words, for the terminal.
    pub fn said(&self) -> String {
        let cut = self.computed_triangles.map(|count| format!(" (cut into {count})")).unwrap_or_default();
        format!("m = {}, n = {}, {}{cut}", self.m, self.n, triangles(self.triangles))
    }
}

/// Durations of the stages in milliseconds; the preparations of both sides are added up.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct MapTimings {
    #[serde(flatten)]
    prepare: PrepareTimings,
    #[serde(flatten)]
    frame: FrameTimings,
}

/// The summary printed by `--json`, also written at the end of a .json file.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Summary {
    /// Angle distortion of the mapped mesh.
    pub quality: Quality,
    /// The durations of the stages.
    pub timing_ms: MapTimings,
    /// The sizes of the mapped mesh.
    pub counts: Counts,
    /// The share of the other outline's area that the images do not cover, because its preimage is smaller than 1e-6 of
    /// the mapped domain; none if the mesh was not refined.
    pub unresolved_area: Option<f64>,
    /// What the points of each outline were taken for; none for a surface.
    pub interpretation: PerSide<Option<Interpreted>>,
    /// How the measures were computed, and how accurately.
    #[serde(flatten)]
    pub accuracy: Accuracy,
    /// The pins and what came out, if the map was given by pins.
    #[serde(flatten)]
    pub pinned: Option<Pinned>,
    /// The search and what came out, if the best map was asked for.
    #[serde(flatten)]
    pub best: Option<Best>,
    /// The links, if the map is a composition.
    #[serde(flatten)]
    pub chain: Option<Chain>,
}

/// The search for the best map, and its constraints.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Best {
    /// The criterion before and after.
    pub optimised: Optimized,
    /// What came out.
    #[serde(flatten)]
    pub constraints: Placed,
}

impl Summary {
    /// The summary of this map; `coarse` is the preparation of the mapped mesh before it was refined, `unestimated` why
    /// there is no estimate of its errors.
    pub fn of(
        map: &ConformalMap,
        interpretation: PerSide<Option<Interpreted>>,
        coarse: PrepareTimings,
        unestimated: Option<String>,
    ) -> Self {
        let [a, b] = Side::BOTH.map(|side| map.side(side).timings());
        Self {
            quality: map.quality(),
            timing_ms: MapTimings { prepare: a.and(b).and(coarse), frame: map.timings() },
            counts: Counts::of(map),
            unresolved_area: map.resolution().map(ResolvedBoundary::unresolved_area),
            interpretation,
            accuracy: Accuracy::of(map, unestimated),
            pinned: None,
            best: None,
            chain: None,
        }
    }
}

#[derive(serde::Serialize)]
struct Boundary<'a> {
    boundary: Places<'a>,
}

#[derive(serde::Serialize)]
struct MapDocument<'a> {
    source: Boundary<'a>,
    target: Boundary<'a>,
    boundary_map: Vec<Vec<f64>>,
    harmonic_measure: Vec<f64>,
    vertices: Places<'a>,
    triangles: &'a [[u32; 3]],
    images: Places<'a>,
    /// For each vertex of a mapped surface its index in the file, or 2³² − 1 if a repair has added it.
    #[serde(skip_serializing_if = "Option::is_none")]
    vertex_origins: Option<&'a [u32]>,
    /// The estimated error of each image of `boundary_map`.
    #[serde(skip_serializing_if = "Option::is_none")]
    boundary_error: Option<&'a [f64]>,
    #[serde(flatten)]
    summary: &'a Summary,
}

/// The first `count` positions.
fn first(places: Places<'_>, count: usize) -> Places<'_> {
    match places {
        Places::Plane(places) => Places::Plane(&places[..count]),
        Places::Space(places) => Places::Space(&places[..count]),
    }
}

/// The boundary samples of the mapped side with their images: x, y, u, v; on surfaces with a third coordinate.
fn boundary_map(map: &ConformalMap) -> Vec<Vec<f64>> {
    let coordinates = |places: Places<'_>, k: usize| match places {
        Places::Plane(places) => places[k].to_array().to_vec(),
        Places::Space(places) => places[k].to_array().to_vec(),
    };
    let (own, images) = (map.mapped().vertices(), map.image_places());
    (0..map.mapped().boundary_count()).map(|k| [coordinates(own, k), coordinates(images, k)].concat()).collect()
}

/// The harmonic measure at every boundary sample of the mapped side, from its anchor.
fn harmonic_measure(map: &ConformalMap) -> Vec<f64> {
    let measure = map.measure(map.mapped_side());
    (0..measure.vertex_count()).map(|k| measure.at_vertex(k)).collect()
}

/// The whole map as JSON.
pub fn json(map: &ConformalMap, summary: &Summary) -> Result<Vec<u8>, serde_json::Error> {
    let boundary = |side: Side| {
        let side = map.side(side);
        Boundary { boundary: first(side.vertices(), side.boundary_count()) }
    };
    serde_json::to_vec(&MapDocument {
        source: boundary(Side::Source),
        target: boundary(Side::Target),
        boundary_map: boundary_map(map),
        harmonic_measure: harmonic_measure(map),
        vertices: map.mapped().vertices(),
        triangles: map.mapped().triangles(),
        images: map.image_places(),
        vertex_origins: map.mapped().surface().map(|meshed| meshed.surface().vertex_origins()),
        boundary_error: summary.accuracy.points(),
        summary,
    })
}
