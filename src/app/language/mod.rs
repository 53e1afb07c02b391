//! The words on the screen that are not beside their control.

pub mod words;
