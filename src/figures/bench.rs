//! Tables 1 and 2: the paper's times, and the measurement of ours.
//!
//! A [`BenchRow`] is measured on the calling thread, so that a worker can measure one between two
//! messages. Times are medians; everything runs on one thread. The outlines other than the V-shape
//! and the blob are riemap's own drawings of these shapes.

use super::scenes::{crowding_constraints, uniform};
use super::{Figure, FigureError, planar};
use crate::conformal::{
    ConformalMap, Constraints, Direction, KernelMode, PrepareError, PrepareSettings, PrepareTimings, PreparedSide,
    Side, prepare,
};
use crate::geometry::{Bounds, DVec2};
use crate::outline::Preset;
use crate::zipper::DiskMap;
use std::sync::Arc;
use web_time::Instant;

/// The machine of the paper's measurements (section 4).
pub const PAPER_MACHINE: &str = "MacBook Air, Apple M3 (8 cores), 24 GB; C++, SC Toolbox in MATLAB";

/// A row of the paper's Table 1; times in seconds.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[allow(missing_docs, reason = "the fields are the table's columns")]
#[non_exhaustive]
pub struct PaperPreparation {
    pub domain: Preset,
    pub m: u32,
    pub n: u32,
    pub triangles: u32,
    pub triangulation_s: f64,
    pub psi_s: f64,
    pub bff_s: f64,
    pub zipper_s: f64,
    /// Approximate; `None` means more than 12 hours.
    pub sc_toolbox_s: Option<f64>,
}

const fn row_1(domain: Preset, counts: [u32; 3], times: [f64; 4], sc_toolbox_s: Option<f64>) -> PaperPreparation {
    let ([m, n, triangles], [triangulation_s, psi_s, bff_s, zipper_s]) = (counts, times);
    PaperPreparation { domain, m, n, triangles, triangulation_s, psi_s, bff_s, zipper_s, sc_toolbox_s }
}

/// The paper's Table 1.
pub const TABLE_1: [PaperPreparation; 6] = [
    row_1(Preset::Gingerbread, [500, 13_620, 27_738], [0.005, 0.119, 0.165, 0.342], Some(180.0)),
    row_1(Preset::Heart, [1000, 90_181, 181_360], [0.048, 1.633, 0.835, 1.047], Some(1800.0)),
    row_1(Preset::Blob, [1000, 97_649, 196_296], [0.043, 1.731, 0.888, 1.064], Some(2400.0)),
    row_1(Preset::Cinquefoil, [1000, 101_985, 204_968], [0.044, 1.843, 0.946, 1.063], Some(1700.0)),
    row_1(Preset::VShape, [2000, 62_668, 127_334], [0.028, 2.119, 0.598, 4.242], Some(9600.0)),
    row_1(Preset::MapleLeaf, [3200, 344_911, 693_020], [0.145, 33.22, 3.300, 10.04], None),
];

/// A row of the paper's Table 2; times in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[allow(missing_docs, reason = "the fields are the table's columns")]
#[non_exhaustive]
pub struct PaperFrame {
    pub figure: u32,
    pub source: Preset,
    pub target: Preset,
    pub matching_ms: f64,
    pub extension_ms: f64,
}

const fn row_2(figure: u32, [source, target]: [Preset; 2], [matching_ms, extension_ms]: [f64; 2]) -> PaperFrame {
    PaperFrame { figure, source, target, matching_ms, extension_ms }
}

/// The paper's Table 2.
pub const TABLE_2: [PaperFrame; 3] = [
    row_2(11, [Preset::Gingerbread, Preset::Heart], [0.059, 0.833]),
    row_2(12, [Preset::VShape, Preset::Blob], [0.344, 3.462]),
    row_2(13, [Preset::MapleLeaf, Preset::Cinquefoil], [0.383, 22.82]),
];

/// How the domains of a row are discretized.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BenchSetting {
    /// The paper's m, uniform samples and triangles.
    Paper,
    /// riemap's defaults: adaptive samples, graded triangles.
    Default,
}

impl BenchSetting {
    /// Both settings.
    pub const ALL: [Self; 2] = [Self::Paper, Self::Default];

    fn settings(self, preset: Preset) -> PrepareSettings {
        let paper = TABLE_1.iter().find(|row| row.domain == preset).filter(|_| self == Self::Paper);
        paper.map_or_else(PrepareSettings::default, |row| uniform(row.m))
    }
}

/// One row of a table, to be measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BenchRow {
    /// Row `index` of [`TABLE_1`].
    Preparation {
        /// `0 … 5`.
        index: usize,
        /// The discretization.
        setting: BenchSetting,
    },
    /// The table of Ψ of row `index` of [`TABLE_1`] with the paper's settings. riemap does not need it; it takes up to
    /// 1 GB and several seconds.
    PsiTable {
        /// `0 … 5`.
        index: usize,
    },
    /// Row `index` of [`TABLE_2`].
    Frame {
        /// `0 … 2`.
        index: usize,
        /// The discretization.
        setting: BenchSetting,
    },
}

/// A measured row of Table 1; times in seconds.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct Preparation {
    /// Boundary samples.
    pub m: u32,
    /// Interior vertices.
    pub n: usize,
    /// Triangles, N.
    pub triangles: usize,
    /// Sampling and meshing.
    pub triangulation_s: f64,
    /// Assembling, ordering and factoring; after these, ψ at any x takes one solve.
    pub factorisation_s: f64,
    /// The geodesic algorithm on the same samples, for one interior point.
    pub zipper_s: f64,
}

/// A measured row of Table 2; times in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct Frame {
    /// Boundary samples of source and target.
    pub m: [u32; 2],
    /// Triangles of the source, whose mesh is mapped.
    pub triangles: usize,
    /// The times while x₁ moves.
    pub source: FrameTimes,
    /// The times while x₂ moves.
    pub target: FrameTimes,
}

/// The durations of the stages of a frame.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct FrameTimes {
    /// Point location, ψ, harmonic measure and matching.
    pub matching_ms: f64,
    /// Computing the images of the source's vertices.
    pub extension_ms: f64,
}

/// A measured row.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measurement {
    /// A row of Table 1.
    Preparation(Preparation),
    /// A row of Table 2.
    Frame(Frame),
    /// The column Ψ of Table 1.
    PsiTable {
        /// Seconds, including the factorization; `None` if the table would take too much memory.
        psi_s: Option<f64>,
    },
}

/// Frames per run: a single frame is too short to be timed well.
const FRAMES_PER_RUN: usize = 5;

impl BenchRow {
    /// All rows in the order of the tables: first with the paper's settings, the tables of Ψ last.
    pub fn all() -> Vec<Self> {
        let rows = |setting: BenchSetting| {
            let preparations = (0..TABLE_1.len()).map(move |index| Self::Preparation { index, setting });
            preparations.chain((0..TABLE_2.len()).map(move |index| Self::Frame { index, setting }))
        };
        let tables = (0..TABLE_1.len()).map(|index| Self::PsiTable { index });
        BenchSetting::ALL.into_iter().flat_map(rows).chain(tables).collect()
    }

    /// Measures the row `runs` times (at least once) and returns medians. `None` for an index beyond the table.
    pub fn measure(self, runs: usize) -> Result<Option<Measurement>, FigureError> {
        Ok(match self {
            Self::Preparation { index, setting } => match TABLE_1.get(index) {
                Some(row) => Some(Measurement::Preparation(preparation(row.domain, setting, runs.max(1))?)),
                None => None,
            },
            Self::PsiTable { index } => match TABLE_1.get(index) {
                Some(row) => Some(Measurement::PsiTable { psi_s: psi_table(row.domain, runs.max(1))? }),
                None => None,
            },
            Self::Frame { index, setting } => match TABLE_2.get(index) {
                Some(row) => Some(Measurement::Frame(frame(row, setting, runs.max(1) * FRAMES_PER_RUN)?)),
                None => None,
            },
        })
    }
}

fn prepared(preset: Preset, setting: BenchSetting) -> Result<PreparedSide, FigureError> {
    Ok(prepare(preset.outline().polygon(), &setting.settings(preset), &mut |_| ())?)
}

fn preparation(preset: Preset, setting: BenchSetting, runs: usize) -> Result<Preparation, FigureError> {
    let (mut timings, mut zipper) = (Vec::new(), Vec::new());
    let mut domain = prepared(preset, setting)?;
    for run in 0..runs {
        if run > 0 {
            domain = prepared(preset, setting)?;
        }
        timings.push(domain.timings());
        let start = Instant::now();
        let planar = planar(&domain)?;
        DiskMap::new(planar.samples().points(), planar.default_point())?;
        zipper.push(start.elapsed().as_secs_f64());
    }
    let seconds = |stage: fn(&PrepareTimings) -> f64| 1e-3 * median(timings.iter().map(stage).collect());
    Ok(Preparation {
        m: domain.boundary_count() as u32,
        n: domain.interior_count(),
        triangles: domain.triangles().len(),
        triangulation_s: seconds(|t| t.sample + t.mesh),
        factorisation_s: seconds(|t| t.assemble + t.order + t.factor),
        zipper_s: median(zipper),
    })
}

fn psi_table(preset: Preset, runs: usize) -> Result<Option<f64>, FigureError> {
    let settings = PrepareSettings { kernel: KernelMode::Table, ..BenchSetting::Paper.settings(preset) };
    let polygon = preset.outline().into_polygon();
    let mut seconds = Vec::new();
    for _ in 0..runs {
        match prepare(&polygon, &settings, &mut |_| ()) {
            Ok(domain) => {
                let t = domain.timings();
                seconds.push(1e-3 * (t.assemble + t.order + t.factor + t.table));
            }
            Err(PrepareError::Table(_)) => return Ok(None),
            Err(error) => return Err(error.into()),
        }
    }
    Ok(Some(median(seconds)))
}

fn frame(row: &PaperFrame, setting: BenchSetting, frames: usize) -> Result<Frame, FigureError> {
    let domains = [Arc::new(prepared(row.source, setting)?), Arc::new(prepared(row.target, setting)?)];
    let at_rest = if row.figure == Figure::Crowding.number() {
        crowding_constraints()
    } else {
        let [source, target] = domains.each_ref().map(|domain| domain.default_point());
        Constraints::new((source, 0.0), (target, 0.0))
    };
    let [source, target] = domains;
    let (m, triangles) = ([&source, &target].map(|side| side.boundary_count() as u32), source.triangles().len());
    let mut map = ConformalMap::new(source, target, &at_rest, Direction::Forward.into())?;
    let [source, target] = Side::BOTH.map(|side| drag(&mut map, at_rest, side, frames));
    Ok(Frame { m, triangles, source: source?, target: target? })
}

/// The size of a drag step relative to the domain's extent.
const DRAG_STEP: f64 = 1e-3;

/// The median durations while one interior point moves back and forth.
fn drag(map: &mut ConformalMap, at_rest: Constraints, side: Side, frames: usize) -> Result<FrameTimes, FigureError> {
    let domain = planar(map.side(side))?;
    let [low, high] = Bounds::of(domain.samples().points().iter().copied()).corners();
    let step = DVec2::new(DRAG_STEP * (high - low).max_element(), 0.0);
    let point = at_rest.points[side].in_plane().ok_or(FigureError::NoDomain)?;
    let (mut matching, mut extension) = (Vec::new(), Vec::new());
    for k in 0..frames {
        let moved = if k % 2 == 0 { at_rest.with_point(side, point + step) } else { at_rest };
        map.update(&moved, Direction::Forward.into())?;
        let timings = map.timings();
        matching.push(timings.kernel + timings.matching);
        extension.push(timings.extend);
    }
    map.update(&at_rest, Direction::Forward.into())?;
    Ok(FrameTimes { matching_ms: median(matching), extension_ms: median(extension) })
}

/// The median; 0 if there are no values.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
