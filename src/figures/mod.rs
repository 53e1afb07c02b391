//! The contents and numbers of the paper's figures and tables, computed on demand; nothing is drawn here.
//!
//! A [`Figure`] has [scenes](Figure::scenes), sessions that the app can open, and
//! [choices](Figure::choices), the details that the paper leaves open with the values used here.
//! The studies compute the numbers behind the plots; `cli` draws them. [`BenchRow`] measures one row
//! of Table 1 or 2.
//!
//! | file | what | paper |
//! |---|---|---|
//! | `scenes` | domains, samples, constraints | captions of Figures 6–12 |
//! | `surface_scenes` | the same with surfaces | captions of Figures 14, 16, 17 |
//! | `disk_kernel` | kernel and measure on the disk | Figure 6 |
//! | `moebius` | a Möbius map, both extensions | Figure 7 |
//! | `crowding` | V-shape → blob by four methods | Figure 12 |
//! | `convergence` | the same for increasing m | Figure 15 |
//! | `surfaces` | surfaces over planar domains | Figures 14, 16, 17 |
//! | `bench` | times of this machine beside the paper's | Tables 1 and 2 |
//! | `ladder` | errors of all methods against unknowns and time | – |

mod bench;
mod convergence;
mod crowding;
mod disk_kernel;
mod ladder;
mod moebius;
mod scenes;
mod surface_scenes;
mod surfaces;
mod table;

pub use crate::closed_form::ArcLength;
pub use bench::{
    BenchRow, BenchSetting, Frame, FrameTimes, Measurement, PAPER_MACHINE, PaperFrame, PaperPreparation, Preparation,
    TABLE_1, TABLE_2,
};
pub use convergence::{ConvergenceRow, ConvergenceStudy, SecondMap, fitted_order};
pub use crowding::{BoundaryMap, CrowdingStudy, Method};
pub use disk_kernel::DiskKernelStudy;
pub use ladder::{Errors, ImageOf, LadderMethod, LadderRow, LadderShape, Reference, Rung, coast};
pub use moebius::{GRID_CIRCLES, GRID_RAYS, MoebiusStudy, grid_point};
pub use scenes::{Scene, SceneLabel};
pub use surfaces::SurfaceStudy;
pub use table::{Cell, Table};

use crate::boundary_integral::BoundaryIntegralError;
use crate::conformal::{MapError, MeshedDomain, PrepareError, PreparedSide, prepare};
use crate::laplace::NotConverged;
use crate::session::DomainSpec;
use crate::surface::{SurfacePreset, TopologyError};
use crate::zipper::ZipperError;
use std::sync::Arc;

/// A figure of the paper that can be reproduced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Figure {
    /// Figure 6: Poisson kernel and harmonic measure on the disk.
    DiskKernel,
    /// Figure 7: a Möbius map of the disk, by both extensions.
    Moebius,
    /// Figure 8: the four ways to map the hand to the blob.
    Options,
    /// Figure 9: angle distortion for increasing resolution.
    Distortion,
    /// Figure 10: the gingerbread man reshaped.
    Reshaping,
    /// Figure 12: the V-shape to the blob, through the disk and directly.
    Crowding,
    /// Figure 14: the hemisphere over L-shapes.
    LShapes,
    /// Figure 15: convergence on the V-shape.
    Convergence,
    /// Figure 16: angle distortion of a head over the disk.
    Head,
    /// Figure 17: a face over several outlines.
    Face,
}

/// The resolution of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Detail {
    /// The paper's numbers of samples.
    #[default]
    Paper,
    /// A quarter of the paper's numbers.
    Quick,
}

impl Detail {
    /// The number of samples to use for the paper's number.
    pub fn samples(self, paper: u32) -> u32 {
        match self {
            Self::Paper => paper,
            Self::Quick => paper / 4,
        }
    }
}

/// Why a figure could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// A domain could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// Harmonic measure could not be computed from the boundary.
    #[error(transparent)]
    BoundaryIntegral(#[from] BoundaryIntegralError),
    /// A map could not be computed.
    #[error(transparent)]
    Map(#[from] MapError),
    /// The map through the disk could not be computed.
    #[error(transparent)]
    Zipper(#[from] ZipperError),
    /// An iterative solver did not converge; the scenes do not use one.
    #[error(transparent)]
    NotConverged(#[from] NotConverged),
    /// A surface is not a topological disk.
    #[error(transparent)]
    Topology(#[from] TopologyError),
    /// A surface was given for a figure without surfaces.
    #[error("the figure shows no surface")]
    NoSurface,
    /// A side is a surface where an outline is expected.
    #[error("the figure shows outlines, and one of its sides is a surface")]
    NoDomain,
    /// An outline is not a simple polygon.
    #[error("the outline of a scene is not a simple polygon")]
    Outline,
}

impl Figure {
    /// All figures, by number.
    pub const ALL: [Self; 10] = [
        Self::DiskKernel,
        Self::Moebius,
        Self::Options,
        Self::Distortion,
        Self::Reshaping,
        Self::Crowding,
        Self::LShapes,
        Self::Convergence,
        Self::Head,
        Self::Face,
    ];

    /// The number in the paper.
    pub fn number(self) -> u32 {
        match self {
            Self::DiskKernel => 6,
            Self::Moebius => 7,
            Self::Options => 8,
            Self::Distortion => 9,
            Self::Reshaping => 10,
            Self::Crowding => 12,
            Self::LShapes => 14,
            Self::Convergence => 15,
            Self::Head => 16,
            Self::Face => 17,
        }
    }

    /// The figure with this number.
    pub fn of_number(number: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|figure| figure.number() == number)
    }

    /// A short title.
    pub fn title(self) -> &'static str {
        match self {
            Self::DiskKernel => "Poisson kernel and harmonic measure on the disk",
            Self::Moebius => "A Möbius map of the disk, exact and approximate",
            Self::Options => "Four ways to map a hand to the blob",
            Self::Distortion => "Angle distortion from the maple leaf to the cinquefoil",
            Self::Reshaping => "The gingerbread man, conformally reshaped",
            Self::Crowding => "From the V-shape to the blob: directly, and through the disk",
            Self::LShapes => "The hemisphere over L-shaped domains",
            Self::Convergence => "Convergence on the V-shape",
            Self::Head => "Angle distortion of a head over the disk",
            Self::Face => "A face over planar domains",
        }
    }

    /// riemap's surface for a figure whose mesh in the paper cannot be distributed; another one may be given.
    pub fn stand_in(self) -> Option<SurfacePreset> {
        match self {
            Self::Head => Some(SurfacePreset::AnimalHead),
            Self::Face => Some(SurfacePreset::HeightField),
            _ => None,
        }
    }

    /// The details that the paper leaves open, with the values used here.
    pub fn choices(self) -> &'static [&'static str] {
        match self {
            Self::DiskKernel => &[
                "x = (0.6, 0.2), y = (1, 0) and m as in the caption; n follows from riemap's mesher",
                "φ is interpolated from the ring of vertices around x, not linearly in x's triangle",
            ],
            Self::Moebius => &[
                "constraints, grid and m as in the caption and section 3.2",
                "the grid's lines are mapped point by point, 8 points between its nodes",
            ],
            Self::Options => &[
                "outlines: riemap's hand; the paper's blob",
                "the paper gives no constraints: both poles of inaccessibility, both first boundary points",
                "Q_avg leaves out flattened triangles (Q > 10); the table has both means",
            ],
            Self::Distortion => &[
                "outlines: riemap's own of these names",
                "the paper gives only the last m (3200): m₁ doubles from 400",
                "the paper shows the constraints in Figure 1 only: both poles of inaccessibility, the leaf's top to the first petal's 4 % of the way round, so that neither tip nor stem goes into a notch",
                "Q_avg leaves out flattened triangles (Q > 10); the table has both means",
            ],
            Self::Reshaping => &[
                "outlines: riemap's own of these names",
                "the paper gives no constraints: both poles of inaccessibility, both first boundary points",
                "500 samples of the gingerbread man as in Table 1; 1000 of each target",
                "Q_avg leaves out flattened triangles (Q > 10); the table has both means",
            ],
            Self::Crowding => &[
                "x₁ = 0.96 + 0.8432i and y₁ = 1 + i as in Figure 3",
                "the paper gives no x₂, y₂: the images of 0 and 1 under the blob's exact map",
                "precomputed maps go through the center −i of the V and the blob's pole of inaccessibility",
                "of the paper's other algorithms the geodesic one (Zipper) is shown",
            ],
            Self::LShapes => &[
                "the hemisphere is riemap's own with m = 900 as in the caption; its triangles are uniform, so that there are more than the paper's 4800",
                "leftmost: the L to whose corners six equidistant points go when the pole goes to (1, 1)/√3 of its sides; by Schwarz and Christoffel its arms are √3 − 1 of them wide",
                "the paper gives neither the other domains nor their constraints: the same L with x₁ in an arm, then two other Ls with their poles of inaccessibility; x₂ is the hemisphere's pole (in the app, the vertex farthest from the boundary), y₁ the concave corner",
            ],
            Self::Head => &[
                "the paper's cow head is not part of riemap, whose own animal head stands in; --surface FILE takes another",
                "the paper gives no constraints: the vertex farthest from the boundary goes to x₁ = 0, 0.4 and 0.8",
                "the disk has 1000 uniform samples",
            ],
            Self::Face => &[
                "the paper's face is not part of riemap, whose own height field stands in; --surface FILE takes another",
                "outlines: riemap's own, with 1000 uniform samples and their corners",
                "the paper gives no constraints: the tip of the nose (of a file with y up the vertex of largest z) goes to the pole of inaccessibility, the top of the loop to the top of the outline",
            ],
            Self::Convergence => &[
                "constraints as in Figure 12",
                "with the exact second map only the V's error is left; with the blob sampled at m₂ = 1000, as in Figure 12, its own error bounds what can be reached",
                "Zipper runs on points of the exact curve; riemap on its preset, whose samples are compared with the nearest points of the curve",
            ],
        }
    }
}

/// The planar domain of a side. Errors: [`FigureError::NoDomain`] for a surface.
pub fn planar(side: &PreparedSide) -> Result<Arc<MeshedDomain>, FigureError> {
    side.domain().map(Arc::clone).ok_or(FigureError::NoDomain)
}

/// Prepares one side of a session.
pub fn prepare_spec(spec: &DomainSpec) -> Result<Arc<PreparedSide>, FigureError> {
    Ok(Arc::new(prepare(&spec.outline.polygon(), &spec.settings, &mut |_| ())?))
}
