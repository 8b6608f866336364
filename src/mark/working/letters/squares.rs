//! Letters that a student gives by their squares: after `V² = u² cos²α + e²u² sin²α` it is known what `½mV²` is.

use crate::expr::Expr;
use crate::mark::working::examine::{Working, evaluate, value};
use crate::mark::working::theirs::numbers;

impl Working<'_> {
    /// Finds what every member of every line comes to, with all that is known of letters.
    pub(in crate::mark::working) fn evaluate(&mut self) {
        let names: Vec<_> = self.names.iter().cloned().chain(self.roots()).collect();
        evaluate(&mut self.lines, self.prepared, &names);
    }

    /// Letters of which nothing else is known, and the roots of what their squares are said to be.
    fn roots(&self) -> Vec<(String, Vec<f64>)> {
        let members = self.lines.iter().filter_map(|studied| studied.reading.as_ref()).flat_map(|line| &line.members);
        let own = members.filter_map(|member| {
            let letter = squared(member.multiple.as_ref()?)?;
            let square = numbers(&value(&member.expr, self.prepared, &self.names)?)?;
            let is_open = value(letter, self.prepared, &self.names).is_none();
            let roots: Vec<f64> = square.into_iter().map(f64::sqrt).collect();
            let Expr::Name(name) = letter else { return None };
            (is_open && roots.iter().all(|root| root.is_finite())).then(|| (name.text.clone(), roots))
        });
        own.collect()
    }
}

/// What is squared.
pub(in crate::mark::working) fn squared(expr: &Expr) -> Option<&Expr> {
    match expr {
        Expr::Power(base, exponent) if **exponent == Expr::integer(2) => Some(base),
        _ => None,
    }
}
