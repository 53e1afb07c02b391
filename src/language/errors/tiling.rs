//! Messages for numbers without a hyperbolic tiling.

use crate::language::{Label, Message, key};
use crate::tiling::{Solid, TILING_NUMBERS, TilingError};

impl From<&TilingError> for Message {
    fn from(error: &TilingError) -> Self {
        let number = |number: u8| u32::from(number);
        match *error {
            TilingError::OutOfRange { p, q } => key::tiling_out_of_range(
                number(p),
                number(q),
                number(*TILING_NUMBERS.start()),
                number(*TILING_NUMBERS.end()),
            ),
            TilingError::Spherical { p, q, solid } => key::tiling_on_sphere(number(p), number(q), Label::from(solid)),
            TilingError::Euclidean { p, q } => key::tiling_in_plane(number(p), number(q)),
        }
    }
}

impl From<Solid> for Label {
    fn from(solid: Solid) -> Self {
        match solid {
            Solid::Tetrahedron => key::tetrahedron(),
            Solid::Octahedron => key::octahedron(),
            Solid::Cube => key::cube(),
            Solid::Icosahedron => key::icosahedron(),
            Solid::Dodecahedron => key::dodecahedron(),
        }
    }
}
