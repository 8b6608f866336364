//! One line of working: words, and the equations that follow them.

use super::later;
use super::{Scene, Setting};
use crate::expr::{Expr, Piece, Text, read_markup};

/// One step of working: words and the equations that follow them.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The words; may be empty.
    pub words: Text,
    /// Equations on successive lines; a repeated left side stands for a chain.
    pub equations: Vec<Expr>,
    /// Does the last equation get a number by which later lines refer to it?
    pub numbered: bool,
    /// Does it say what a condition of the scene comes to?
    pub of_condition: bool,
}

impl Line {
    /// Words and equations.
    pub fn plain(words: &str, equations: Vec<Expr>) -> Line {
        Line::with(words, &[], equations)
    }

    /// Words and equations, the last of which gets a number.
    pub fn numbered(words: &str, equations: Vec<Expr>) -> Line {
        Line { numbered: true, ..Line::plain(words, equations) }
    }

    /// Words in the bank's own markup, in which names in braces stand for formulas.
    pub fn with(words: &str, formulas: &[(&str, Expr)], equations: Vec<Expr>) -> Line {
        let replace = |name: &str| formulas.iter().find(|(other, _)| *other == name).map(|(_, expr)| expr.clone());
        let paragraphs = read_markup(words).unwrap_or_else(|_| vec![Text::words(words)]);
        let mut pieces = Vec::new();
        for text in paragraphs {
            let replaced = text.map_formulas(&mut |expr: &Expr| Ok::<_, ()>(expr.substitute(&replace)));
            pieces.extend(replaced.unwrap_or_default().0.into_iter().map(without_second_unit));
        }
        Line { words: Text(pieces), equations, numbered: false, of_condition: false }
    }
}

impl Line {
    /// The same line with `m_A` and `m_B` for masses that are to be found: their letters have the names that files use.
    pub fn with_masses_in_symbols(mut self) -> Line {
        let symbol = |name: &str| match name {
            "A.mass" => Some(Expr::name("m_A")),
            "B.mass" => Some(Expr::name("m_B")),
            _ => None,
        };
        let words = self.words.map_formulas(&mut |expr: &Expr| Ok::<_, ()>(expr.substitute(&symbol)));
        self.words = words.unwrap_or_default();
        self.equations = self.equations.iter().map(|equation| equation.substitute(&symbol)).collect();
        self
    }

    /// The same line without `M = M`, which a law says of a letter that it does not find.
    pub(super) fn without_identities(mut self) -> Line {
        let says_nothing = |equation: &Expr| matches!(equation, Expr::Relation(left, _, right) if left == right);
        self.equations.retain(|equation| !says_nothing(equation));
        self
    }

    /// The same line in other words.
    pub(super) fn said_by(mut self, say: &impl Fn(&str) -> String) -> Line {
        for piece in &mut self.words.0 {
            if let Piece::Words(words) = piece {
                *words = say(words);
            }
        }
        self
    }

    /// The same line of a condition on a scene; where impacts follow, the impact is the first.
    pub(super) fn of_condition(self, scene: &Scene) -> Line {
        let line = if scene.then.is_empty() { self } else { self.said_by(&|words| later::numbered(0, words)) };
        Line { of_condition: true, ..line }
    }

    /// The same line in the words of another setting.
    pub fn said_of(self, setting: Setting) -> Line {
        self.said_by(&|words| setting.say(words).into_owned())
    }
}

/// A letter such as v carries its unit already; a formula in letters does not get it twice.
fn without_second_unit(piece: Piece) -> Piece {
    let unit_vector = |name: &str| name == "i" || name == "j";
    match piece {
        Piece::Quantity(expr, _) if expr.names().iter().any(|name| !unit_vector(&name.text)) => Piece::Formula(expr),
        other => other,
    }
}
