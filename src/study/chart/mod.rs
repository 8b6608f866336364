//! Charts, printed as SVG: a canvas, marks that differ by shape and colour, and labels that find a free place.
//!
//! Conventions. Lengths are in pixels of a picture that may be shown at any size, y downwards. Colours are written as
//! attributes, so that a page for print needs no style sheet; on a dark page a few rules take their place. The eight
//! colours are those of Okabe and Ito, which people with any kind of colour vision tell apart; no two series differ by
//! colour alone.

mod bars;
mod canvas;
mod labels;
mod scale;
mod scatter;
mod strips;

pub use bars::{Bar, Bars, bars};
pub use scatter::{Series, Work, scatter};
pub use strips::strips;

/// A chart as a file of its own, and what it is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chart {
    /// The name of its file, without the ending: `stability-quantities`.
    pub name: String,
    /// The picture.
    pub svg: String,
}
