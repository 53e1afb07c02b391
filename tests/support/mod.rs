//! Helpers shared by several test programs.

#![allow(dead_code, reason = "each program of tests uses a part of it")]
#![allow(clippy::panic, clippy::unwrap_used, missing_docs, reason = "tests")]

pub mod data;
pub mod domains;
#[cfg(feature = "app")]
pub mod program;
pub mod random;
