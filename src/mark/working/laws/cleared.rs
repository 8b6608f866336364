//! The tangent of a deflection once the fraction within the fraction has been cleared: the second method mark for it.

use super::compound::has_two_tangents;
use crate::answer::Kind;
use crate::bank::{Code, EarnedFor};
use crate::expr::Expr;
use crate::mark::judging::{has_fraction_within, is_printed_value};
use crate::mark::key::{KeyedMark, KeyedPart};
use crate::mark::working::evidence::Evidence;
use crate::mark::working::examine::{Examined, Working};
use crate::mark::working::numbers::{comes_to, sizes};
use crate::mechanics::{Law, Moment, Quantity, Seen, Sphere};

/// Does the law give the tangent of a deflection?
pub(in crate::mark::working) fn is_of_deflection(law: Law) -> bool {
    let is_tangent = |quantity: &Quantity| matches!(quantity, Quantity::TanDeflection(_));
    matches!(law.seen(), Seen::Value(quantities, _) if quantities.iter().any(is_tangent))
}

impl Working<'_> {
    /// From the line on which the tangent was `found`, the first that has it without a fraction within a fraction. There
    /// the result itself counts: whoever reaches it has cleared them.
    pub(super) fn cleared(&self, found: Evidence, quantities: &[Quantity]) -> Option<Evidence> {
        let right: Vec<Vec<f64>> = [&self.prepared.known, &self.followed]
            .into_iter()
            .flat_map(|known| quantities.iter().filter_map(|quantity| sizes(known, *quantity)))
            .collect();
        let line = (found.line..self.lines.len()).find(|place| {
            self.members(&self.lines[*place]).any(|(member, values)| {
                let comes = |right: &Vec<f64>| values.iter().zip(right).all(|(value, right)| comes_to(*value, *right));
                !has_fraction_within(&member.expr) && right.iter().any(comes)
            })
        })?;
        Some(Evidence { line, ..found })
    }

    /// The direction after the impact, which the tangent of the deflection has in it where it is found from the components
    /// at once: by their cross product over their scalar product. Of tangents that stand there nobody sees whence they come.
    pub(in crate::mark::working) fn direction_by_deflection(&self, mark: &KeyedMark) -> Option<Evidence> {
        let is_direction = |quantity: Quantity| matches!(quantity, Quantity::TOverN(_, Moment::After));
        let is_of_it = match &mark.earned_for {
            EarnedFor::Law(law, _) => Sphere::BOTH.into_iter().any(|of| law.gives(Quantity::TOverN(of, Moment::After))),
            EarnedFor::Quantity(quantity) => is_direction(*quantity),
            _ => false,
        };
        let laws = self.part.scheme.iter().filter_map(|other| match other.earned_for {
            EarnedFor::Law(law, _) if is_of_deflection(law) => Some(law),
            _ => None,
        });
        let law = laws.filter(|_| is_of_it).last()?;
        let known = &self.prepared.known;
        let line = Sphere::BOTH.into_iter().find_map(|of| self.line_that_is(known, Quantity::TanDeflection(of)))?;
        let of_tangents = self.members(&self.lines[line]).any(|(member, _)| has_two_tangents(&member.expr));
        (!of_tangents).then(|| Evidence::given(line, law.name()))
    }
}

impl Examined {
    /// The blank with the printed result, where the working has come as far as the tangent.
    pub(in crate::mark::working) fn cleared_in_answers(
        &self,
        part: &KeyedPart,
        law: Law,
        said: &[Option<(Expr, String)>],
    ) -> Option<usize> {
        let mut marks = part.scheme.iter().zip(&self.awards);
        let is_found = marks.any(|(mark, award)| {
            let is_own = mark.code == Code::A1 && matches!(mark.earned_for, EarnedFor::Law(own, _) if own == law);
            is_own && award.as_ref().is_some_and(|award| award.given)
        });
        let mut blanks = part.blanks.iter().zip(said);
        let result = blanks.position(|(blank, said)| {
            let is_result = |(value, _): &(Expr, String)| is_printed_value(&blank.model, value);
            blank.model.kind == Kind::Shown && said.as_ref().is_some_and(is_result)
        });
        result.filter(|_| is_found)
    }
}
