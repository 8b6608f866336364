//! Readers: one expression, or words with formulas in them, from text that anybody may have written.
//!
//! Whatever the text, the answer is a tree or a [`Fault`](super::Fault): length and depth are limited.

mod call;
mod chain;
mod lexer;
mod markup;
mod meant;
mod parser;
mod range;

pub(crate) use call::in_degrees as bare_in_degrees;
pub use markup::{Markup, read_markup};
pub use parser::{Angles, read, read_as_written};
pub use range::read_range;

#[cfg(test)]
mod markup_tests;
#[cfg(test)]
mod tests;
