//! Texts that several controls share.

pub mod words;
