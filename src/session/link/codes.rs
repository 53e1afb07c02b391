//! The numbers that encode enum values in a link. They never change; a new value gets the next number.

use super::{Choice, LinkError};
use crate::conformal::{Direction, Extension, KernelMode, Side};
use crate::laplace::SolverKind;
use crate::session::{Colouring, Comparison, Holes, TextureKind};

/// An enum whose values have numbers.
pub(super) trait Coded: Sized {
    /// The number of the value.
    fn code(self) -> u8;

    /// The value of a number. Errors: [`LinkError::Unknown`].
    fn of(code: u8) -> Result<Self, LinkError>;
}

macro_rules! codes {
    ($what:ident, $type:ty { $($value:path = $code:literal),+ $(,)? }) => {
        impl Coded for $type {
            fn code(self) -> u8 {
                match self { $($value => $code),+ }
            }

            fn of(code: u8) -> Result<Self, LinkError> {
                match code {
                    $($code => Ok($value),)+
                    _ => Err(LinkError::Unknown { what: Choice::$what, name: code.to_string() }),
                }
            }
        }
    };
}

codes!(Direction, Direction { Direction::Forward = 0, Direction::Backward = 1 });
codes!(Extension, Extension { Extension::Harmonic = 0, Extension::CauchyGreen = 1, Extension::Exact = 2 });
codes!(Side, Side { Side::Source = 0, Side::Target = 1 });
codes!(Kernel, KernelMode { KernelMode::Adjoint = 0, KernelMode::Table = 1, KernelMode::Integral = 2 });
codes!(Setting, Holes { Holes::Filled = 0, Holes::Open = 1 });
codes!(Solver, SolverKind { SolverKind::Direct = 0, SolverKind::Pcg = 1 });
codes!(Colouring, Colouring { Colouring::Texture = 0, Colouring::Angle = 1, Colouring::Area = 2 });
codes!(Comparison, Comparison {
    Comparison::Off = 0,
    Comparison::Fresh = 1,
    Comparison::Precomputed = 2,
    Comparison::Both = 3,
});

impl Coded for TextureKind {
    fn code(self) -> u8 {
        match self {
            Self::Checker => 0,
            Self::Grid => 1,
            Self::Polar => 2,
            Self::Conformal | Self::Tiling => 3, // a section says which
            Self::Image => 4,
        }
    }

    fn of(code: u8) -> Result<Self, LinkError> {
        const TEXTURES: [TextureKind; 5] =
            [TextureKind::Checker, TextureKind::Grid, TextureKind::Polar, TextureKind::Conformal, TextureKind::Image];
        let unknown = || LinkError::Unknown { what: Choice::Texture, name: code.to_string() };
        TEXTURES.get(usize::from(code)).copied().ok_or_else(unknown)
    }
}
