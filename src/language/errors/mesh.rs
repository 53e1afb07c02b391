//! Messages for errors in sampling and meshing a boundary, and in factoring its Laplacian.

use crate::language::{Message, Value, key};
use crate::laplace::{LaplaceError, NotConverged};
use crate::mesh::MeshError;
use crate::outline::SamplingError;

impl From<&SamplingError> for Message {
    fn from(error: &SamplingError) -> Self {
        match error {
            SamplingError::TooFew { count } => key::sampling_too_few(*count),
            SamplingError::TooMany { count, limit } => key::sampling_too_many(*limit, *count),
            SamplingError::MoreCornersThanSamples { corners, count } => {
                key::sampling_more_corners_than_samples(*corners, *count)
            }
        }
    }
}

impl From<&MeshError> for Message {
    fn from(error: &MeshError) -> Self {
        match error {
            MeshError::SelfCrossing { x, y } => key::mesh_self_crossing(*x, *y),
            MeshError::RepeatedPoint { x, y } => key::mesh_repeated_point(*x, *y),
            MeshError::TooFewPoints { count } => key::mesh_too_few_points(*count),
            MeshError::NotFinite { index } => key::mesh_not_finite(*index),
            MeshError::NotCounterClockwise => key::mesh_not_counter_clockwise().into(),
            MeshError::OutOfRange => key::mesh_out_of_range().into(),
            MeshError::Grading { grading } => key::mesh_grading(*grading),
            MeshError::TooManyVertices { estimate, limit } => {
                key::mesh_too_many_vertices(Value::number(format!("{estimate:.2e}")), *limit)
            }
            MeshError::TooThin { x, y } => key::mesh_too_thin(*x, *y),
        }
    }
}

impl From<&LaplaceError> for Message {
    fn from(error: &LaplaceError) -> Self {
        match error {
            LaplaceError::Structure(reason) => key::laplace_structure(reason.as_str()),
            LaplaceError::Degenerate { x, y } => key::laplace_degenerate(*x, *y),
            LaplaceError::DegenerateAt { vertex } => key::laplace_degenerate_at(vertex.number()),
            LaplaceError::NotPositiveDefinite { vertex } => key::laplace_not_positive_definite(*vertex),
            LaplaceError::TooLarge { unknowns, bytes } => key::laplace_too_large(*unknowns, bytes / 1_000_000),
        }
    }
}

impl From<&NotConverged> for Message {
    fn from(NotConverged { residual }: &NotConverged) -> Self {
        key::not_converged(Value::number(format!("{residual:.1e}")))
    }
}
