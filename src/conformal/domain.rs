//! Everything about one domain that does not depend on the constraints.

use crate::geometry::{DVec2, SimplePolygon};
use crate::mesh::{MeshError, Sizing, TriMesh, mesh_domain};
use crate::outline::{BoundarySamples, Sampling, SamplingError, sample};
use web_time::Instant;

/// How a domain is discretised.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct PrepareSettings {
    /// How the boundary is sampled.
    pub sampling: Sampling,
    /// How the triangle size varies.
    pub sizing: Sizing,
}

/// A stage of the preparation, for progress.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stage {
    /// Sampling the boundary.
    Sample,
    /// Triangulating.
    Mesh,
    /// Assembling the cotangent Laplacian.
    Assemble,
    /// Fill-reducing ordering.
    Order,
    /// Cholesky factorisation.
    Factor,
}

/// How long each stage took, in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the fields are the stages")]
pub struct PrepareTimings {
    pub sample: f64,
    pub mesh: f64,
    pub assemble: f64,
    pub order: f64,
    pub factor: f64,
}

/// Why a domain could not be prepared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PrepareError {
    /// The boundary could not be sampled.
    #[error(transparent)]
    Sampling(#[from] SamplingError),
    /// The sampled boundary could not be meshed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// A domain, sampled, meshed, assembled and factored.
#[derive(Debug, Clone)]
pub struct PreparedDomain {
    /// The boundary samples, `m` of them.
    pub samples: BoundarySamples,
    /// The mesh over them.
    pub mesh: TriMesh,
    /// The default interior point: the pole of inaccessibility.
    pub pole: DVec2,
    /// How long it took.
    pub timings: PrepareTimings,
}

/// A [`PreparedDomain`] as flat arrays, to cross a worker boundary by transfer.
#[derive(Debug, Clone, PartialEq)]
pub struct DomainBuffers {
    /// The floating-point arrays.
    pub floats: Vec<Vec<f64>>,
    /// The index arrays.
    pub indices: Vec<Vec<u32>>,
}

/// Samples, meshes, assembles, orders and factors, reporting each stage before it starts.
pub fn prepare(
    polygon: &SimplePolygon,
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedDomain, PrepareError> {
    // skeleton
    progress(Stage::Sample);
    let start = Instant::now();
    let samples = sample(polygon, settings.sampling)?;
    progress(Stage::Mesh);
    let (mesh, _report) = mesh_domain(&samples.points, settings.sizing)?;
    let timings = PrepareTimings { sample: start.elapsed().as_secs_f64() * 1e3, ..PrepareTimings::default() };
    Ok(PreparedDomain { samples, mesh, pole: polygon.pole_of_inaccessibility(1e-3), timings })
}

impl PreparedDomain {
    /// The point inside the domain nearest to `x` that keeps the distance `inset`
    /// from the boundary where the domain is wide enough: a handle slides along the boundary.
    pub fn nearest_inside(&self, x: DVec2, inset: f64) -> DVec2 {
        let _ = inset;
        x // skeleton
    }

    /// As flat arrays.
    pub fn to_buffers(&self) -> DomainBuffers {
        DomainBuffers { floats: Vec::new(), indices: Vec::new() } // skeleton
    }

    /// From flat arrays; `None` if they are not what [`Self::to_buffers`] makes.
    pub fn from_buffers(buffers: DomainBuffers) -> Option<Self> {
        let _ = buffers;
        None // skeleton
    }
}
