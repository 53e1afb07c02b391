//! Fill-reducing ordering: approximate minimum degree (Amestoy, Davis, Duff 1996), by faer.

use super::{DirichletLaplacian, LaplaceError};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// A permutation of the unknowns that limits the fill of the factor; `forward` and `inverse` are inverse to each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Ordering {
    /// The old index at each new one.
    pub(super) forward: Vec<u32>,
    /// The new index of each old one.
    pub(super) inverse: Vec<u32>,
}

impl Ordering {
    /// The approximate minimum degree ordering of L̂.
    pub fn minimum_degree(laplacian: &DirichletLaplacian) -> Result<Self, LaplaceError> {
        let n = laplacian.interior.cols();
        let too_large = || LaplaceError::TooLarge { unknowns: n, bytes: 0 };
        let pointers = laplacian.interior.proper_indptr();
        let indices = laplacian.interior.indices();
        let pattern = SymbolicSparseColMatRef::<u32>::new_checked(n, n, &pointers, None, indices);
        let (mut forward, mut inverse) = (vec![0; n], vec![0; n]);
        let request = amd::order_maybe_unsorted_scratch::<u32>(n, indices.len());
        let mut memory = MemBuffer::try_new(request).map_err(|_| too_large())?;
        amd::order_maybe_unsorted(
            &mut forward,
            &mut inverse,
            pattern,
            amd::Control::default(),
            MemStack::new(&mut memory),
        )
        .map_err(|_| too_large())?;
        Ok(Self { forward, inverse })
    }
}
