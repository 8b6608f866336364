//! Printers: one expression as plain ASCII, LaTeX, MathML or the mathematics of a terminal.
//!
//! [`plain`] is the form that other programs parse. The three pretty printers share one
//! layout: signs, brackets, multiplication signs and dropped ones are decided there once,
//! so that a question sheet cannot differ from its web page. No printer simplifies.

mod extent;
mod latex;
mod layout;
mod letter;
mod mathml;
mod plain;
mod shape;
mod svg;
mod text;
mod unicode;
mod unit;
mod words;

pub use extent::extent;
pub use latex::{latex, latex_quantity};
pub use mathml::{mathml, mathml_block, mathml_inline};
pub use plain::plain;
pub use svg::text_svg;
pub use text::{text_html, text_latex, text_unicode};
pub use unicode::unicode;
pub use unit::{unit_latex, unit_mathml, unit_unicode};
pub use words::{latex_lacks, words_html, words_latex, words_unicode};

/// What most formulas and sentences take in bytes, so that few need more room while they are written.
const ROOM: usize = 1000;

#[cfg(test)]
mod tests;
