//! The transferable form of a prepared side: flat arrays, which are moved between workers, and a short text.
//!
//! The arrays are those of `PreparedSide::to_buffers`, in its order; the text is the surface's repairs as JSON.

use crate::conformal::{FlatBuffers, NotFlat, PreparedSide};

/// A [`PreparedSide`] in transferable form.
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer {
    /// The floating-point arrays.
    pub floats: Vec<Vec<f64>>,
    /// The index arrays.
    pub indices: Vec<Vec<u32>>,
    /// The small parts with varying structure, as JSON.
    pub text: String,
}

impl TryFrom<&PreparedSide> for Transfer {
    type Error = NotFlat;

    fn try_from(side: &PreparedSide) -> Result<Self, NotFlat> {
        let FlatBuffers { floats, indices, repairs } = side.to_buffers()?;
        // Plain data can always be written as JSON.
        Ok(Self { floats, indices, text: serde_json::to_string(&repairs).unwrap_or_default() })
    }
}

impl Transfer {
    /// The side; `None` if the arrays and the text are not those of a side.
    pub fn into_side(self) -> Option<PreparedSide> {
        let repairs = serde_json::from_str(&self.text).ok()?;
        PreparedSide::from_buffers(FlatBuffers { floats: self.floats, indices: self.indices, repairs })
    }
}
