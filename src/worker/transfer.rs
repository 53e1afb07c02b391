//! The transferable form of a prepared side and of an integral equation: flat arrays, which are moved between workers, and a short record.
//!
//! The arrays of a side are those of `PreparedSide::to_buffers`, in its order; the record is packed: the surface's repairs, and whether
//! an integral equation follows.

use super::{packed, unpacked};
use crate::conformal::{BoundaryEquation, FlatBuffers, FlatEquation, NotFlat, PreparedSide};
use crate::geometry::Curve;

/// A [`PreparedSide`] or a [`BoundaryEquation`] in transferable form.
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer {
    /// The floating-point arrays.
    pub floats: Vec<Vec<f64>>,
    /// The index arrays.
    pub indices: Vec<Vec<u32>>,
    /// The small parts with varying structure, packed.
    pub record: Vec<u8>,
}

impl TryFrom<&PreparedSide> for Transfer {
    type Error = NotFlat;

    fn try_from(side: &PreparedSide) -> Result<Self, NotFlat> {
        let FlatBuffers { floats, indices, repairs, expected } = side.to_buffers()?;
        Ok(Self { floats, indices, record: packed(&(repairs, expected)) })
    }
}

/// The points first, then the arrays of the factored equation.
impl From<&BoundaryEquation> for Transfer {
    fn from(equation: &BoundaryEquation) -> Self {
        let mut equation = equation.to_flat();
        let record = packed(&equation);
        let points = std::mem::take(&mut equation.points);
        let floats = std::iter::once(points).chain(equation.integral.floats).collect();
        Self { floats, indices: vec![equation.integral.integers], record }
    }
}

impl Transfer {
    /// The integral equation of `curve`; `None` if the arrays and the record are not those of its equation.
    pub fn into_equation(self, curve: &Curve) -> Option<BoundaryEquation> {
        let mut equation: FlatEquation = unpacked(&self.record)?;
        let mut floats = self.floats.into_iter();
        equation.points = floats.next()?;
        equation.integral.floats = floats.collect();
        let [rows]: [Vec<u32>; 1] = self.indices.try_into().ok()?;
        equation.integral.integers = rows;
        BoundaryEquation::from_flat(curve, equation)
    }

    /// The side; `None` if the arrays and the record are not those of a side.
    pub fn into_side(self) -> Option<PreparedSide> {
        let (repairs, expected) = unpacked(&self.record)?;
        PreparedSide::from_buffers(FlatBuffers { floats: self.floats, indices: self.indices, repairs, expected })
    }
}
