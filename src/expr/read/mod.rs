//! Readers: one expression, or words with formulas in them, from text that anybody may have written.
//!
//! Whatever the text, the answer is a tree or a [`Fault`](super::Fault): length and depth are limited.

mod lexer;
mod parser;

pub use parser::{Angles, read};

#[cfg(test)]
mod tests;
