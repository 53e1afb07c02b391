//! What the renderer draws, on whatever adapter there is (lavapipe in CI):
//! first numbers at probe pixels, then small pictures against committed ones.
//!
//! Without an adapter the tests fail under `CI=true` and are skipped, with a
//! message, otherwise. `UPDATE_SNAPSHOTS=1` rewrites the pictures.

#![cfg(all(feature = "app", not(target_arch = "wasm32")))]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod cauchy_green;
mod cells;
mod live;
mod numbers;
mod pictures;
mod support;
mod surface;
