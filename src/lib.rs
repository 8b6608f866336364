//! Carom makes and marks exercises on collisions in two dimensions.
pub mod answer;
pub mod bank;
pub mod cli;
pub mod diagnostic;
pub mod diagram;
pub mod examine;
pub mod expr;
pub mod generate;
pub mod mark;
pub mod mechanics;
pub mod method;
pub mod number;
pub mod paper;
pub mod render;
pub mod solve;
pub mod study;
pub mod table;
pub mod unit;

/// The guide for programmers: its example is run.
#[cfg(doctest)]
#[doc = include_str!("../docs/guides/programmer.md")]
struct GuideForProgrammers;
