//! Closed forms used as truth.
