//! Words with formulas in them, before it is decided on what they are printed.

use super::{Expr, Name};
use crate::unit::Unit;

/// A run of words, formulas and quantities.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Text(pub Vec<Piece>);

/// A piece of a [`Text`].
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// Plain words; printers escape them.
    Words(String),
    /// Words in italics, such as the lead-in `[In this question …]`.
    Italic(Vec<Piece>),
    /// A formula within the line.
    Formula(Expr),
    /// A number or vector with its unit: `4 kg`, `(4i - j) m s^-1`, `30°`.
    Quantity(Expr, Unit),
    /// A formula on a line of its own, as the result of a 'show that'.
    Display(Expr),
}

impl Text {
    /// Words alone.
    pub fn words(text: impl Into<String>) -> Text {
        Text(vec![Piece::Words(text.into())])
    }

    /// Is there nothing in it?
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The text with a letter at its end kept to the word before it, so that no last line is a letter alone.
    ///
    /// ```
    /// use carom::expr::{print, read_markup};
    /// let ask = read_markup("Find the value of {k}.").unwrap();
    /// assert_eq!(print::text_latex(&ask[0].clone().without_widow()), "Find the value of~$k$.");
    /// ```
    pub fn without_widow(mut self) -> Text {
        let is_stop = |piece: &Piece| matches!(piece, Piece::Words(words) if words.chars().count() < 2);
        let is_letter = |piece: &Piece| match piece {
            Piece::Formula(formula) => matches!(formula, Expr::Name(_)),
            Piece::Italic(inner) => matches!(&inner[..], [Piece::Words(words)] if words.chars().count() == 1),
            _ => false,
        };
        let last = self.0.iter().rposition(|piece| !is_stop(piece));
        let before = last.filter(|last| is_letter(&self.0[*last])).and_then(|last| last.checked_sub(1));
        if let Some(Piece::Words(words)) = before.and_then(|before| self.0.get_mut(before))
            && words.ends_with(' ')
        {
            words.pop();
            words.push('\u{a0}');
        }
        self
    }

    /// The text with each formula and the size of each quantity changed, or the first error met.
    ///
    /// ```
    /// use carom::expr::{Expr, print, read_markup};
    /// let stem = read_markup("a mass of {k kg}").unwrap();
    /// let filled = stem[0].map_formulas(&mut |formula| {
    ///     Ok::<_, ()>(formula.substitute(&|name| (name == "k").then(|| Expr::integer(3))))
    /// });
    /// assert_eq!(print::text_unicode(&filled.unwrap()), "a mass of 3 kg");
    /// ```
    pub fn map_formulas<E>(&self, change: &mut impl FnMut(&Expr) -> Result<Expr, E>) -> Result<Text, E> {
        changed(&self.0, change).map(Text)
    }

    /// Every formula and size of a quantity, in order.
    pub fn formulas(&self) -> Vec<&Expr> {
        let mut found = Vec::new();
        collect(&self.0, &mut found);
        found
    }

    /// Is there a formula or quantity in it?
    pub fn has_formulas(&self) -> bool {
        has_formulas(&self.0)
    }

    /// Every name in its formulas, with the place where it was read.
    pub fn names(&self) -> Vec<&Name> {
        self.formulas().into_iter().flat_map(Expr::names).collect()
    }
}

fn changed<E>(pieces: &[Piece], change: &mut impl FnMut(&Expr) -> Result<Expr, E>) -> Result<Vec<Piece>, E> {
    let each = |piece: &Piece| {
        Ok(match piece {
            Piece::Words(words) => Piece::Words(words.clone()),
            Piece::Italic(inner) => Piece::Italic(changed(inner, change)?),
            Piece::Formula(expr) => Piece::Formula(change(expr)?),
            Piece::Quantity(expr, unit) => Piece::Quantity(change(expr)?, *unit),
            Piece::Display(expr) => Piece::Display(change(expr)?),
        })
    };
    pieces.iter().map(each).collect()
}

fn has_formulas(pieces: &[Piece]) -> bool {
    pieces.iter().any(|piece| match piece {
        Piece::Words(_) => false,
        Piece::Italic(inner) => has_formulas(inner),
        Piece::Formula(_) | Piece::Quantity(..) | Piece::Display(_) => true,
    })
}

fn collect<'a>(pieces: &'a [Piece], found: &mut Vec<&'a Expr>) {
    for piece in pieces {
        match piece {
            Piece::Words(_) => {}
            Piece::Italic(inner) => collect(inner, found),
            Piece::Formula(expr) | Piece::Quantity(expr, _) | Piece::Display(expr) => found.push(expr),
        }
    }
}
