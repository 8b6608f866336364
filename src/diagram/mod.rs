//! Diagrams: what a scene looks like from above, drawn from its numbers.
//!
//! A [`Diagram`] is one picture with its title and its words for those who do not see it. Its [`Drawing`] is lines and
//! labels at places that are settled; the printers [`tikz`] and [`svg`] only write them down, so that
//! the picture is the same on paper and on screen.
//!
//! [`given`] draws what a question gives and nothing else, [`solution`] what its worked solution works with. Angles are
//! drawn as they are; an angle that is a letter is drawn at about 40 degrees. Velocities are arrows of one length.

mod canvas;
mod contact;
mod corner;
mod drawing;
mod geometry;
mod given;
mod illustration;
mod particle;
mod solution;
mod source;
mod spheres;
mod spots;
mod svg;
mod tikz;
mod wall;
mod walls;
mod words;

pub use drawing::{Drawing, Label, Point, Section, Stroke, Style};
pub use geometry::Frame;
pub use given::given;
pub use solution::solution;
pub use svg::svg;
pub use tikz::tikz;

use crate::expr::{Expr, Piece, Text, written_angle};
use crate::number::{Angle, Value};
use crate::unit::Unit;

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

/// How the words of a question give its scene.
#[derive(Clone, Copy, Debug)]
pub struct Manner<'a> {
    /// Are velocities vectors in **i** and **j**?
    pub vectors: bool,
    /// The letters that the words give with a unit, such as `m` in 'a mass of 3m kg'.
    pub with_units: &'a [String],
    /// The angles that the words name by a letter, each with its tangent: 'where tan α = 2'.
    pub angles: &'a [(Expr, Value)],
    /// The letters that the words have for the angle between a path after an impact and the wall, by how many impacts
    /// come before that one.
    pub after_walls: &'a [(u8, Expr)],
}

impl Manner<'_> {
    /// An angle by the letter that the words have for it, or as it is written.
    fn angle(self, angle: &Angle) -> Expr {
        let is_it = |tangent: &Value| (angle.y() - &(tangent * angle.x())).is_zero();
        let named = self.angles.iter().find(|(_, tangent)| is_it(tangent));
        named.map_or_else(|| written_angle(angle), |(name, _)| name.clone())
    }

    /// A value with its unit, where its letters have one.
    fn quantity(self, value: &Expr, unit: Unit) -> Text {
        let has_unit = value
            .names()
            .iter()
            .all(|name| matches!(name.text.as_str(), "i" | "j") || self.with_units.contains(&name.text));
        Text(vec![Piece::Quantity(value.clone(), if has_unit { unit } else { Unit::None })])
    }
}

/// A formula by itself.
fn formula(value: Expr) -> Text {
    Text(vec![Piece::Formula(value)])
}
