//! The two equations solved: one of the unknowns is left alone.

use super::conventions::Convention;
use super::offered::differences;
use super::pair::BOTH;
use crate::expr::Expr;
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Studied, Working};
use crate::mechanics::Quantity;

impl Working<'_> {
    /// The mark for solving the two equations: a value of one of the unknowns follows them, or so much of one is known. With
    /// the other still in it nothing has been solved: an equation is only written the other way round.
    pub(in crate::mark::working) fn solved(&self) -> Option<Evidence> {
        let convention = self.convention.as_ref()?;
        let states = |studied: &Studied| {
            let members = studied.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            members.iter().zip(&studied.values).any(|(member, value)| {
                let is_unknown = member.letter.as_ref().is_some_and(|letter| convention.letters.contains(letter));
                let mut names = member.expr.names().into_iter();
                is_unknown && value.is_some() && !names.any(|name| convention.letters.contains(&name.text))
            })
        };
        // `9x = 5v - 4ev` comes of both equations; before them it could be anything.
        let has_law = |equation: &Quantity| {
            self.lines.iter().position(|studied| studied.matched.iter().any(|matched| matched.equation == *equation))
        };
        let laws: Option<Vec<usize>> = BOTH.iter().map(has_law).collect();
        let both = laws.and_then(|places| places.into_iter().max());
        let eliminates = |(place, studied): (usize, &Studied)| {
            let mut equations = studied.reading.iter().flat_map(|reading| &reading.equations);
            both.is_some_and(|both| place > both)
                && studied.matched.iter().all(|matched| !matched.is_method())
                && equations
                    .any(|equation| self.has_one_unknown(equation, convention) && !self.has_side_of_result(equation))
        };
        // Who has both equations and then the result has found nothing that follows from it.
        let end = Some(self.end_of_finding()).filter(|end| both.is_some_and(|both| both < *end));
        let mut lines = self.lines.iter().enumerate().take(end.map_or(usize::MAX, |end| end + 1));
        let line = lines.position(|(place, studied)| states(studied) || eliminates((place, studied)));
        let in_tangent = || self.along_in_tangent().filter(|place| both.is_some_and(|both| *place > both));
        let line = line.or_else(|| self.solved_in_vectors()).or_else(in_tangent)?;
        Some(Evidence::given(line, "the equations solved"))
    }

    /// Is one of the student's two letters the only unknown in an equation?
    fn has_one_unknown(&self, equation: &(Expr, Expr), convention: &Convention) -> bool {
        differences(equation, self.prepared).is_some_and(|linear| {
            linear.iter().all(|linear| match linear.unknowns.as_slice() {
                [(name, _)] => convention.letters.contains(name),
                _ => false,
            })
        })
    }

    /// `tan β = u sin α/v = 3 tan α/(2 - e)`, where that is to be shown: what v is has not been found.
    fn has_side_of_result(&self, (left, right): &(Expr, Expr)) -> bool {
        self.is_side_of_result(left) || self.is_side_of_result(right)
    }
}
