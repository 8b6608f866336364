//! Diagrams: what a scene looks like from above, drawn from its numbers.
//!
//! A [`Diagram`] is one picture with its title and its words for those who do not see it. Its [`Drawing`] is lines and
//! labels at places that are settled; the printers [`tikz`] and [`svg`] only write them down, so that
//! the picture is the same on paper and on screen.

mod drawing;
mod svg;
mod tikz;

pub use drawing::{Drawing, Label, Point, Section, Stroke, Style};
pub use svg::svg;
pub use tikz::tikz;

/// One picture of a question or of its solution.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagram {
    /// What stands above it: `Before`, `After`; empty for the figure of a question.
    pub title: String,
    /// The lines and labels.
    pub drawing: Drawing,
    /// What it shows, in words, for a reader who does not see it.
    pub words: String,
}
