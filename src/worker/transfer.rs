//! What crosses a worker's border: a prepared side as flat arrays, which are transferred, and a short text.
//!
//! The arrays are those of `PreparedSide::to_buffers`, in its order; the text is the surface's repairs as JSON.

use crate::conformal::{FlatBuffers, PreparedSide};

/// A [`PreparedSide`] as it crosses.
#[derive(Debug, Clone, PartialEq)]
pub struct Transfer {
    /// The floating-point arrays.
    pub floats: Vec<Vec<f64>>,
    /// The index arrays.
    pub indices: Vec<Vec<u32>>,
    /// What is small and has many forms, as JSON.
    pub text: String,
}

impl From<&PreparedSide> for Transfer {
    fn from(side: &PreparedSide) -> Self {
        let FlatBuffers { floats, indices, repairs } = side.to_buffers();
        // Plain data: it always has a form as text.
        Self { floats, indices, text: serde_json::to_string(&repairs).unwrap_or_default() }
    }
}

impl Transfer {
    /// The side; `None` if this is not what a side makes.
    pub fn into_side(self) -> Option<PreparedSide> {
        let repairs = serde_json::from_str(&self.text).ok()?;
        PreparedSide::from_buffers(FlatBuffers { floats: self.floats, indices: self.indices, repairs })
    }
}
