//! The cotangent Laplacian of a mesh and its Cholesky factor.
