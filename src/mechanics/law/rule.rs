//! A way to use a law, in the first impact or in a later one.

use std::borrow::Cow;

use super::{Known, Law, Line, Outcome, Show, silent};
use crate::expr::Expr;
use crate::mechanics::Quantity;
use crate::mechanics::later::Meeting;
use crate::number::Number;

/// A way to use a law: from the quantities in `needs` to those in `gives`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Rule {
    /// The law it applies.
    pub law: Law,
    /// Which of the law's forms it is; the law's own file says what the numbers mean.
    pub form: u8,
    /// What must be known.
    pub needs: Vec<Quantity>,
    /// What is known afterwards, in the order of evaluation.
    pub gives: Vec<Quantity>,
    /// How much it adds to a solution, to choose between derivations: about one a line of working.
    pub cost: u32,
    /// Of a later impact: which, and the rule as the law has it, which says the same of A and B.
    pub later: Option<(Meeting, &'static Rule)>,
}

impl Rule {
    /// The same rule in a later impact. It needs that there is such an impact.
    pub(super) fn of_later(&'static self, meeting: Meeting) -> Rule {
        let said = |quantities: &[Quantity]| quantities.iter().map(|quantity| meeting.quantity(*quantity)).collect();
        let mut needs: Vec<Quantity> = said(&self.needs);
        needs.push(Quantity::Meeting(meeting));
        Rule { needs, gives: said(&self.gives), later: Some((meeting, self)), ..self.clone() }
    }

    /// The rule as its law has it, of A and B.
    pub fn in_law(&self) -> &Rule {
        self.later.map_or(self, |(_, rule)| rule)
    }

    /// How many impacts come before the one that it is of.
    pub fn impact(&self) -> u8 {
        self.gives.first().map_or(0, |quantity| quantity.impact())
    }

    /// What is known, as the law has it.
    fn in_its_words<'k, N: Number>(&self, known: &'k Known<N>) -> Cow<'k, Known<N>> {
        match self.later {
            Some((meeting, _)) => Cow::Owned(meeting.known(known)),
            None => Cow::Borrowed(known),
        }
    }

    /// What it gives from what is known; `None` where one of it does not exist, as the direction of a sphere at rest
    /// does not.
    pub fn evaluate<N: Number>(&self, known: &Known<N>) -> Outcome<N> {
        self.in_law().evaluated(&self.in_its_words(known))
    }

    /// The same with a slip in place of the law; `None` if the slip changes nothing that this rule does.
    pub fn slipped<N: Number>(&self, slip: &str, known: &Known<N>) -> Outcome<N> {
        self.in_law().evaluated_with(slip, &self.in_its_words(known))
    }

    /// The equation, as a student first writes it, that a mark for accuracy is given for.
    pub fn equation(&self, show: &Show) -> Option<Expr> {
        match self.later {
            Some((meeting, rule)) => {
                let show = show.of_later(meeting)?;
                rule.earning(&show).map(|equation| show.named(&equation))
            }
            None => self.earning(show),
        }
    }

    /// The lines of working that a worked solution shows for it.
    pub fn lines(&self, show: &Show) -> Vec<Line> {
        let said = |rule: &Rule, show: &Show| rule.shown(show).into_iter().map(|line| show.said(line)).collect();
        match self.later {
            Some((meeting, rule)) => show.of_later(meeting).map_or_else(silent, |show| said(rule, &show)),
            None => said(self, show),
        }
    }
}
