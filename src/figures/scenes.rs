//! The domains, resolutions and constraints of the figures, as sessions.

use super::{Detail, Figure, surface_scenes};
use crate::conformal::{Constraints, Direction, Extension, PrepareSettings};
use crate::geometry::DVec2;
use crate::mesh::Sizing;
use crate::outline::{Preset, Sampling};
use crate::session::{Colouring, Comparison, DomainSpec, OutlineSpec, Session, TextureKind};

/// One map of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// What tells it from the figure's other scenes.
    pub label: String,
    /// The map.
    pub session: Session,
}

/// m of the rows of Figures 6 and 7.
const DISK_SAMPLES: [u32; 3] = [25, 50, 100];

/// m₁ of Figure 9.
const DISTORTION_SAMPLES: [u32; 4] = [400, 800, 1600, 3200];

/// y₂ of Figure 9. At 0 the leaf's stem goes into a notch of the cinquefoil, for which m₂ = 1000 is
/// too coarse: it is flattened for every m₁ (Q_avg 1.11 at 3200). At 0.1 the leaf's tip goes there
/// (1.08). Here both are beside a notch (1.02).
const DISTORTION_ANCHOR: f64 = 0.04;

/// m₁ and m₂ of Figure 8: low and high.
const OPTION_SAMPLES: [[u32; 2]; 2] = [[300, 200], [1800, 1200]];

/// The targets of Figure 10 and their samples: the paper's where it says so, else 1000.
const RESHAPED: [Preset; 4] = [Preset::Disk, Preset::Square, Preset::Heart, Preset::Turkey];
const RESHAPED_SAMPLES: [u32; 2] = [500, 1000];

/// x₁ of Figures 6 and 7, x₂ of Figure 7; y₁ = y₂ = (1, 0) is the disk's first point.
const DISK_POINTS: [DVec2; 2] = [DVec2::new(0.6, 0.2), DVec2::new(0.0, -0.5)];

/// The paper's discretisation: `count` uniform samples, triangles of area h²/2.
pub(super) fn uniform(count: u32) -> PrepareSettings {
    let sampling = Sampling::Uniform { count, keep_corners: false };
    PrepareSettings { sampling, sizing: Sizing::Uniform, ..PrepareSettings::default() }
}

/// x₁ = 0.96 + 0.8432i and y₁ = 1 + i on the V (Figure 3); x₂ = g⁻¹(0) and y₂ = g⁻¹(1) on the
/// blob, its outline's first point.
pub(super) fn crowding_constraints() -> Constraints {
    Constraints {
        source_point: DVec2::new(0.96, 0.8432),
        target_point: crate::exact::blob::from_disk(crate::exact::Complex::ZERO).into(),
        source_anchor: 0.0,
        target_anchor: 0.0,
    }
}

impl Figure {
    /// The maps that the figure shows, in its order.
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

fn session(presets: [Preset; 2], samples: [u32; 2], direction: Direction) -> Session {
    let domain = |k: usize| DomainSpec { outline: OutlineSpec::Preset(presets[k]), settings: uniform(samples[k]) };
    Session { source: domain(0), target: domain(1), direction, ..Session::default() }
}

fn disk(m: u32) -> Scene {
    let mut session = session([Preset::Disk, Preset::Disk], [m, m], Direction::Forward);
    session.interior = DISK_POINTS.map(Some);
    session.texture = TextureKind::Polar;
    Scene { label: format!("m = {m}"), session }
}

fn options(samples: [u32; 2], detail: Detail) -> Vec<Scene> {
    let [m1, m2] = samples.map(|m| detail.samples(m));
    let directions = [(Direction::Forward, "forward"), (Direction::Backward, "backward")];
    let extensions = [(Extension::Harmonic, "harmonic"), (Extension::CauchyGreen, "Cauchy–Green")];
    let scene = |direction, extension| {
        let session = session([Preset::Hand, Preset::Blob], [m1, m2], direction);
        Session { extension, texture_scale: 16.0, ..session }
    };
    let labelled = directions.into_iter().flat_map(|d| extensions.map(|e| (d, e)));
    labelled.map(|((d, way), (e, how))| Scene { label: format!("{way}, {how}"), session: scene(d, e) }).collect()
}

fn distortion(m: u32, detail: Detail) -> Scene {
    let samples = [detail.samples(m), detail.samples(1000)];
    let mut session = session([Preset::MapleLeaf, Preset::Cinquefoil], samples, Direction::Forward);
    session.colouring = Colouring::Angle;
    session.anchor = [0.0, DISTORTION_ANCHOR];
    Scene { label: format!("m₁ = {}", samples[0]), session }
}

fn reshaping(target: Preset, detail: Detail) -> Scene {
    let samples = RESHAPED_SAMPLES.map(|m| detail.samples(m));
    let mut session = session([Preset::Gingerbread, target], samples, Direction::Backward);
    session.texture_scale = 16.0;
    Scene { label: target.title().to_owned(), session }
}

fn crowding(detail: Detail) -> Scene {
    let samples = [detail.samples(2000), detail.samples(1000)];
    let mut session = session([Preset::VShape, Preset::Blob], samples, Direction::Forward);
    let Constraints { source_point, target_point, source_anchor, target_anchor } = crowding_constraints();
    session.interior = [Some(source_point), Some(target_point)];
    session.anchor = [source_anchor, target_anchor];
    session.comparison = Comparison::Both;
    session.texture_scale = 64.0; // the tip around x₁, a tenth of the V, fills the blob
    Scene { label: "V-shape → blob".to_owned(), session }
}
