//! Messages for errors of the map, and for its notes.

use crate::boundary_integral::BoundaryIntegralError;
use crate::conformal::{
    MOST_LENGTH, MOST_PINS, MapError, MapNote, NotFlat, PinError, PrepareError, QuadrilateralError, ResolveError,
    TableError, Unsharpened, WalkError,
};
use crate::figures::FigureError;
use crate::language::{Message, Value, key};
use crate::optimization::OptimizeError;

impl From<&PrepareError> for Message {
    fn from(error: &PrepareError) -> Self {
        match error {
            PrepareError::Sampling(error) => error.into(),
            PrepareError::Mesh(error) => error.into(),
            PrepareError::Laplace(error) => error.into(),
            PrepareError::Table(error) => error.into(),
            PrepareError::IntegralOfSurface => key::integral_of_surface().into(),
        }
    }
}

impl From<&TableError> for Message {
    fn from(error: &TableError) -> Self {
        match error {
            TableError::TooLarge { rows, columns, bytes, budget, fitting_samples } => {
                key::table_too_large(*rows, *columns, bytes / 1_000_000, budget / 1_000_000, *fitting_samples)
            }
            TableError::NotConverged(error) => error.into(),
        }
    }
}

impl From<&ResolveError> for Message {
    fn from(error: &ResolveError) -> Self {
        match error {
            ResolveError::Prepare(error) => error.into(),
            ResolveError::Map(error) => error.into(),
        }
    }
}

impl From<&OptimizeError> for Message {
    fn from(error: &OptimizeError) -> Self {
        match error {
            OptimizeError::Map(error) => error.into(),
            OptimizeError::EmptyRegion => key::region_holds_nothing().into(),
            OptimizeError::NoSharedSymmetry => key::no_shared_symmetry().into(),
        }
    }
}

impl From<&MapError> for Message {
    fn from(error: &MapError) -> Self {
        match error {
            MapError::PointOutside { side, x, y } => key::map_point_outside(*side, *x, *y),
            MapError::NoPoint { triangle, weights, triangles, .. } => {
                key::map_no_point(*triangles, weights[0], weights[1], weights[2], triangle.number())
            }
            MapError::OnBoundary { .. } => key::map_on_boundary().into(),
            MapError::OtherKind { side } => key::map_other_kind(*side),
            MapError::AnchorNotFinite { side } => key::map_anchor_not_finite(*side),
            MapError::LoopAnchorNotFinite { .. } => key::map_loop_anchor_not_finite().into(),
            MapError::NotConverged { side, error } => key::map_not_converged(*side, Message::from(error)),
            MapError::BoundaryIntegral { side, error } => key::map_boundary_integral(*side, Message::from(error)),
        }
    }
}

impl From<&PinError> for Message {
    fn from(error: &PinError) -> Self {
        match error {
            PinError::Count { count } => key::pin_count(*count, MOST_PINS),
            PinError::NotFinite { pin, side } => key::pin_not_finite(*pin, *side),
            PinError::Coinciding { pins: [a, b], side } => key::pins_coincide(*a, *b, *side),
            PinError::Order { pins: [a, b, c], .. } => key::pins_out_of_order(*a, *b, *c),
            PinError::NotFound { side } => key::pins_not_found(*side),
            PinError::Missed { pin, miss } => key::pin_missed(*pin, *miss),
            PinError::NotConverged { side, error } => key::map_not_converged(*side, Message::from(error)),
            PinError::Map(error) => error.into(),
        }
    }
}

impl From<&QuadrilateralError> for Message {
    fn from(error: &QuadrilateralError) -> Self {
        match error {
            QuadrilateralError::NotFinite { mark } => key::mark_not_finite(*mark),
            QuadrilateralError::Coinciding { marks: [a, b] } => key::marks_coincide(*a, *b),
            QuadrilateralError::Order { mark } => key::marks_out_of_order(*mark, mark % 4 + 1),
            QuadrilateralError::TooLong { side, length } => {
                let [a, b, c, d] = [0, 1, 2, 3].map(|k| (side + k) % 4 + 1);
                key::quadrilateral_too_long(a, b, c, d, Value::number(format!("{length:.0}")), MOST_LENGTH)
            }
            QuadrilateralError::NoMiddle => key::quadrilateral_no_middle().into(),
            QuadrilateralError::BoundaryIntegral(error) => error.into(),
            QuadrilateralError::Rectangle(_) => key::outline_without_curve().into(),
        }
    }
}

impl From<&BoundaryIntegralError> for Message {
    fn from(error: &BoundaryIntegralError) -> Self {
        match error {
            BoundaryIntegralError::TooManyUnknowns { needed, limit } => key::integral_too_large(*needed, *limit),
            BoundaryIntegralError::TooMuchMemory { limit_mb } => key::integral_too_much_memory(*limit_mb),
            BoundaryIntegralError::CornerNotResolved { at } => key::integral_corner_not_resolved(at.x, at.y),
            BoundaryIntegralError::NotResolved => key::integral_not_resolved().into(),
            BoundaryIntegralError::Singular => key::integral_singular().into(),
            BoundaryIntegralError::NotInside { at } => key::integral_not_inside(at.x, at.y),
        }
    }
}

impl From<&NotFlat> for Message {
    fn from(NotFlat: &NotFlat) -> Self {
        key::equation_travels_apart().into()
    }
}

impl From<&Unsharpened> for Message {
    fn from(reason: &Unsharpened) -> Self {
        match reason {
            Unsharpened::Curve(_) => key::integral_no_curve().into(),
            Unsharpened::Integral(error) => error.into(),
            Unsharpened::Apart => key::integral_apart().into(),
            Unsharpened::Mesh(error) => key::integral_not_meshed(Self::from(error)),
        }
    }
}

impl From<&MapNote> for Message {
    fn from(note: &MapNote) -> Self {
        match note {
            MapNote::NoMeasure { edges } => key::map_no_measure(*edges),
            MapNote::NegativeKernel { edges } => key::map_negative_kernel(*edges),
        }
    }
}

impl From<&WalkError> for Message {
    fn from(error: &WalkError) -> Self {
        match error {
            WalkError::StartOutside { x, y } => key::walk_start_outside(*x, *y),
            WalkError::NoBoundary => key::walk_no_boundary().into(),
        }
    }
}

impl From<&FigureError> for Message {
    fn from(error: &FigureError) -> Self {
        match error {
            FigureError::Prepare(error) => error.into(),
            FigureError::BoundaryIntegral(error) => error.into(),
            FigureError::Map(error) => error.into(),
            FigureError::Zipper(error) => error.into(),
            FigureError::NotConverged(error) => error.into(),
            FigureError::Topology(error) => error.into(),
            FigureError::NoSurface => key::figure_no_surface().into(),
            FigureError::NoDomain => key::figure_no_domain().into(),
            FigureError::Outline => key::figure_outline().into(),
        }
    }
}
