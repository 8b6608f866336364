//! A way to use a law, in the first impact or in a later one.

use super::{Here, Known, Law, Line, Outcome, Show, silent};
use crate::expr::Expr;
use crate::mechanics::later::Meeting;
use crate::mechanics::{Axis, Quantity};
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

    /// What it gives from what is known; `None` where one of it does not exist, as the direction of a sphere at rest
    /// does not.
    pub fn evaluate<N: Number>(&self, known: &Known<N>) -> Outcome<N> {
        self.in_law().evaluated(&self.here(known))
    }

    /// The same with a slip in place of the law; `None` if the slip changes nothing that this rule does. A slip may start
    /// from what the rule does not need.
    pub fn slipped<N: Number>(&self, slip: &str, known: &Known<N>) -> Outcome<N> {
        self.in_law().evaluated_with(slip, &self.here(known))
    }

    /// What is known, as the law has it.
    fn here<'k, N: Number>(&self, known: &'k Known<N>) -> Here<'k, N> {
        Here::at(self.later.map_or(Meeting::FIRST, |(meeting, _)| meeting), known)
    }

    /// The equation, as a student first writes it, that a mark for accuracy is given for.
    fn equation(&self, show: &Show) -> Option<Expr> {
        match self.later {
            Some((meeting, rule)) => {
                let show = show.of_later(meeting)?;
                rule.earning(&show).map(|equation| show.named(&equation))
            }
            None => self.earning(show),
        }
    }

    /// All such equations: resolving has one for each component, any other law one alone.
    pub fn equations(&self, show: &Show) -> Vec<Expr> {
        match self.law {
            Law::Resolve if matches!(self.gives[0].of_its_impact(), Quantity::Velocity(_, _, Axis::N)) => {
                self.lines(show).iter().filter_map(|line| line.equations.first().cloned()).collect()
            }
            _ => self.equation(show).into_iter().collect(),
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

#[cfg(test)]
mod tests {
    use super::super::{Datum, all_rules};
    use super::*;

    #[test]
    fn a_rule_looks_at_nothing_that_it_does_not_need() {
        let quantities = Quantity::of_an_impact();
        let datum = |(place, quantity): (usize, &Quantity)| {
            let number = 1.0 + place as f64 / 7.0;
            let datum = match quantity {
                quantity if quantity.is_equation() => Datum::Equation([number, 0.5 - number, 3.0]),
                quantity if quantity.is_angle() => Datum::Direction { y: number, x: 2.0 },
                Quantity::GivenDirection(..) => Datum::Direction { y: number, x: -2.0 },
                _ => Datum::Number(number),
            };
            (*quantity, datum)
        };
        let everything = Known(quantities.iter().enumerate().map(datum).collect());
        let mut found = 0;
        for rule in all_rules(&[]) {
            let needed = rule.needs.iter().filter_map(|need| Some((*need, everything.0.get(need)?.clone())));
            let needed = Known(needed.collect());
            assert_eq!(rule.evaluate(&needed), rule.evaluate(&everything), "{rule:?}");
            found += usize::from(rule.evaluate(&needed).is_some());
        }
        assert!(2 * found > all_rules(&[]).len(), "of most rules something was seen: {found}");
    }
}
