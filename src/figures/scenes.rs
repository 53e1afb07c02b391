//! The domains, resolutions and constraints of the figures, as sessions.

use super::{Detail, Figure, surface_scenes};
use crate::conformal::{Constraints, Direction, Extension, PerSide, PrepareSettings, Side};
use crate::geometry::DVec2;
use crate::mesh::Sizing;
use crate::outline::{Preset, Sampling};
use crate::session::{Colouring, Command, Comparison, OutlineSpec, Session, SidePoints, TextureKind};

/// The settings of one map in a figure.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scene {
    /// The label that distinguishes it from the figure's other scenes.
    pub label: SceneLabel,
    /// The sides, the constraints and the display.
    pub session: Session,
}

/// The property that distinguishes a scene from the figure's other scenes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SceneLabel {
    /// m, the boundary samples of both sides.
    Samples(u32),
    /// m₁, the boundary samples of the source.
    SourceSamples(u32),
    /// |x₁|, the distance of the source's point from the disk's center.
    Radius(f64),
    /// How the map is computed.
    Way(Direction, Extension),
    /// The outline that is mapped to.
    Outline(Preset),
    /// The V-shape to the blob.
    VShapeToBlob,
    /// Six equidistant points are mapped to the corners of an L.
    SixthsToCorners,
    /// x₁ lies in an arm of the L.
    InArm,
    /// An L with narrow arms.
    NarrowArms,
    /// An L with arms of different width.
    UnequalArms,
}

impl std::fmt::Display for SceneLabel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Samples(m) => write!(f, "m = {m}"),
            Self::SourceSamples(m) => write!(f, "m₁ = {m}"),
            Self::Radius(radius) => write!(f, "x₁ = {radius}"),
            Self::Way(direction, extension) => {
                let way = if *direction == Direction::Forward { "forward" } else { "backward" };
                let how = match extension {
                    Extension::Harmonic => "harmonic",
                    Extension::CauchyGreen => "Cauchy–Green",
                    Extension::Exact => "exact",
                };
                write!(f, "{way}, {how}")
            }
            Self::Outline(preset) => f.write_str(preset.title()),
            Self::VShapeToBlob => f.write_str("V-shape → blob"),
            Self::SixthsToCorners => f.write_str("sixths to corners"),
            Self::InArm => f.write_str("x₁ in an arm"),
            Self::NarrowArms => f.write_str("narrow arms"),
            Self::UnequalArms => f.write_str("unequal arms"),
        }
    }
}

/// m in the rows of Figures 6 and 7.
const DISK_SAMPLES: [u32; 3] = [25, 50, 100];

/// m₁ of Figure 9.
const DISTORTION_SAMPLES: [u32; 4] = [400, 800, 1600, 3200];

/// y₂ of Figure 9. At 0 the leaf's stem is mapped into a notch of the cinquefoil, for which m₂ = 1000 is
/// too coarse: it is flattened for every m₁ (Q_avg 1.11 at 3200). At 0.1 the leaf's tip is mapped there
/// (1.08). At this value both lie beside a notch (1.02).
const DISTORTION_ANCHOR: f64 = 0.04;

/// m₁ and m₂ of Figure 8: low and high.
const OPTION_SAMPLES: [PerSide<u32>; 2] = [PerSide::new(300, 200), PerSide::new(1800, 1200)];

/// The targets of Figure 10 and their samples: the paper's numbers where it states them, else 1000.
const RESHAPED: [Preset; 4] = [Preset::Disk, Preset::Square, Preset::Heart, Preset::Turkey];
const RESHAPED_SAMPLES: PerSide<u32> = PerSide::new(500, 1000);

/// Squares of the pattern across the source, where a figure has no number of its own.
pub(super) const SQUARES: f64 = 8.0;

/// x₁ of Figures 6 and 7, x₂ of Figure 7; y₁ = y₂ = (1, 0) is the disk's first point.
const DISK_POINTS: [DVec2; 2] = [DVec2::new(0.6, 0.2), DVec2::new(0.0, -0.5)];

/// The paper's discretization: `count` uniform samples, triangles of area h²/2.
pub(super) fn uniform(count: u32) -> PrepareSettings {
    let sampling = Sampling::Uniform { count, keep_corners: false };
    PrepareSettings { sampling, sizing: Sizing::Uniform, ..PrepareSettings::default() }
}

/// x₁ = 0.96 + 0.8432i and y₁ = 1 + i on the V (Figure 3); x₂ = g⁻¹(0) and y₂ = g⁻¹(1) on the
/// blob, its outline's first point.
pub(super) fn crowding_points() -> PerSide<DVec2> {
    PerSide::new(
        DVec2::new(0.96, 0.8432),
        crate::exact::point(crate::exact::blob::from_disk(crate::exact::Complex::ZERO)),
    )
}

/// The constraints of Figure 12, with y₁ and y₂ at the first points of the outlines.
pub(super) fn crowding_constraints() -> Constraints {
    let PerSide { source, target } = crowding_points();
    Constraints::new((source, 0.0), (target, 0.0))
}

impl Figure {
    /// The maps of the figure, in its order.
    pub fn scenes(self, detail: Detail) -> Vec<Scene> {
        match self {
            Self::DiskKernel | Self::Moebius => DISK_SAMPLES.map(disk).to_vec(),
            Self::Options => OPTION_SAMPLES.iter().flat_map(|&samples| options(samples, detail)).collect(),
            Self::Distortion => DISTORTION_SAMPLES.map(|m| distortion(m, detail)).to_vec(),
            Self::Reshaping => RESHAPED.map(|target| reshaping(target, detail)).to_vec(),
            Self::Crowding | Self::Convergence => vec![crowding(detail)],
            Self::LShapes => surface_scenes::l_shapes(detail),
            Self::Head => surface_scenes::heads(detail),
            Self::Face => surface_scenes::faces(detail),
        }
    }
}

fn session(presets: PerSide<Preset>, samples: PerSide<u32>, direction: Direction) -> Session {
    let side = |side: Side| {
        let outline = OutlineSpec::Preset(presets[side]);
        let settings = uniform(samples[side]);
        [Command::SetOutline { side, outline }, Command::SetSettings { side, settings }]
    };
    let display = [Command::SetDirection(direction), Command::SetTextureScale(SQUARES)];
    Session::with(Side::BOTH.into_iter().flat_map(side)).and(display)
}

/// Commands that set all four points.
fn points(points: PerSide<DVec2>, anchors: PerSide<f64>) -> [Command; 2] {
    Side::BOTH.map(|side| {
        let (interior, anchor) = (Some(points[side]), anchors[side]);
        Command::PlacePoints { side, points: SidePoints::Outline { interior, anchor } }
    })
}

fn disk(m: u32) -> Scene {
    let [source_point, target_point] = DISK_POINTS;
    let session = session(PerSide::new(Preset::Disk, Preset::Disk), PerSide::new(m, m), Direction::Forward);
    let session = session
        .and(points(PerSide::new(source_point, target_point), PerSide::default()))
        .and([Command::SetTexture(TextureKind::Polar)]);
    Scene { label: SceneLabel::Samples(m), session }
}

fn options(samples: PerSide<u32>, detail: Detail) -> Vec<Scene> {
    let samples = samples.map(|m| detail.samples(m));
    let directions = [Direction::Forward, Direction::Backward];
    let extensions = [Extension::Harmonic, Extension::CauchyGreen];
    let scene = |direction, extension| {
        let session = session(PerSide::new(Preset::Hand, Preset::Blob), samples, direction);
        session.and([Command::SetExtension(extension), Command::SetTextureScale(16.0)])
    };
    let ways = directions.into_iter().flat_map(|d| extensions.map(|e| (d, e)));
    ways.map(|(d, e)| Scene { label: SceneLabel::Way(d, e), session: scene(d, e) }).collect()
}

fn distortion(m: u32, detail: Detail) -> Scene {
    let samples = PerSide::new(detail.samples(m), detail.samples(1000));
    let session = session(PerSide::new(Preset::MapleLeaf, Preset::Cinquefoil), samples, Direction::Forward).and([
        Command::SetColouring(Colouring::Angle),
        Command::MoveAnchor { side: Side::Target, fraction: DISTORTION_ANCHOR },
    ]);
    Scene { label: SceneLabel::SourceSamples(samples.source), session }
}

fn reshaping(target: Preset, detail: Detail) -> Scene {
    let samples = RESHAPED_SAMPLES.map(|m| detail.samples(m));
    let session = session(PerSide::new(Preset::Gingerbread, target), samples, Direction::Backward);
    Scene { label: SceneLabel::Outline(target), session: session.and([Command::SetTextureScale(16.0)]) }
}

fn crowding(detail: Detail) -> Scene {
    let samples = PerSide::new(detail.samples(2000), detail.samples(1000));
    let session = session(PerSide::new(Preset::VShape, Preset::Blob), samples, Direction::Forward);
    let session = session.and(points(crowding_points(), crowding_constraints().anchors)).and([
        Command::SetComparison(Comparison::Both),
        Command::SetTextureScale(64.0), // the tip around x₁, a tenth of the V, fills the blob
    ]);
    Scene { label: SceneLabel::VShapeToBlob, session }
}
