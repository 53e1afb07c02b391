//! The renderer's output on any adapter (lavapipe in CI):
//! first numbers at probe pixels, then small pictures compared with committed ones.
//!
//! Without an adapter the tests fail under `CI=true`, and are otherwise skipped with
//! a message. `UPDATE_SNAPSHOTS=1` rewrites the pictures.

#![cfg(all(feature = "app", not(target_arch = "wasm32")))]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod cauchy_green;
mod cells;
mod live;
mod numbers;
mod octaves;
mod pictures;
mod support;
mod surface;
mod tilings;
