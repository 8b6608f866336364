//! Bounds of a letter: the inequalities of an answer, each solved for the letter that they are about.

use std::cmp::Ordering;

use crate::expr::{Expr, Meaning, Relation, evaluate, written};
use crate::number::{Letter, Span, Value};

use super::accuracy::Written;
use super::exact::{self, meaning_of};

/// One inequality, solved for the letter: the letter lies on this side of the bound.
pub(super) struct Bound {
    /// Is the letter above it?
    pub(super) above: bool,
    /// Does it belong to the range? Words such as `from 1 to 3` do not say.
    pub(super) included: Option<bool>,
    pub(super) value: Value,
    /// As it was written, where the letter stands by itself.
    pub(super) shown: Expr,
    /// Does the letter stand by itself?
    pub(super) solved: bool,
}

/// The relations of chains, two sides each; a chain may come in pieces of which the one begins where the other ends. What a
/// bound comes to may stand behind it, as in `f > 0.8/1.2 = 2/3`; where it does not come to that, the equals sign is left.
pub(super) fn relations<'e>(chains: impl IntoIterator<Item = &'e Expr>, letters: &[Letter]) -> Vec<Expr> {
    let mut whole: Vec<Chain> = Vec::new();
    for chain in chains {
        let chain = Chain::of(chain);
        match whole.last_mut() {
            Some(before) if before.sides.last() == chain.sides.first() => {
                before.sides.extend(&chain.sides[1..]);
                before.signs.extend(chain.signs);
            }
            _ => whole.push(chain),
        }
    }
    whole.into_iter().flat_map(|chain| chain.with_bounds_worked_out(letters).pairs()).collect()
}

/// The sides of a chain, and the signs between them.
struct Chain<'e> {
    sides: Vec<&'e Expr>,
    signs: Vec<Relation>,
}

impl Chain<'_> {
    fn of(expr: &Expr) -> Chain<'_> {
        match expr {
            Expr::Relation(left, sign, right) => {
                let mut chain = Chain::of(left);
                chain.signs.push(*sign);
                chain.sides.push(right);
                chain
            }
            side => Chain { sides: vec![side], signs: Vec::new() },
        }
    }

    /// Without the equals signs behind bounds, where there is an inequality.
    fn with_bounds_worked_out(mut self, letters: &[Letter]) -> Self {
        if self.signs.iter().all(|sign| *sign == Relation::Equal) {
            return self;
        }
        let mut at = 0;
        while let Some(sign) = self.signs.get(at) {
            let is_equal = *sign == Relation::Equal;
            match is_equal.then(|| worked_out(self.sides[at], self.sides[at + 1], letters)).flatten() {
                Some(end) => {
                    self.signs.remove(at);
                    self.sides.splice(at..at + 2, [end]);
                }
                None => at += 1,
            }
        }
        self
    }

    fn pairs(&self) -> Vec<Expr> {
        let pairs = self.sides.iter().zip(&self.sides[1..]).zip(&self.signs);
        let boxed = |side: &Expr| Box::new(side.clone());
        pairs.map(|((left, right), sign)| Expr::Relation(boxed(left), *sign, boxed(right))).collect()
    }
}

/// Of a bound and what it is said to come to: the one that is exact, if they are the same or the one rounds to the other.
fn worked_out<'e>(bound: &'e Expr, end: &'e Expr, letters: &[Letter]) -> Option<&'e Expr> {
    let value = |expr: &Expr| exact::value(expr, letters).filter(|value| value.letters().is_empty());
    let found = value(end)?;
    match value(bound)? {
        first if first == found || rounds_to(bound, end) => Some(bound),
        _ => rounds_to(end, bound).then_some(end),
    }
}

/// Is the second a decimal to which the first, a number, rounds?
pub(super) fn rounds_to(exact: &Expr, rounded: &Expr) -> bool {
    let Some(written) = Some(rounded).filter(|rounded| matches!(rounded, Expr::Decimal(_))).and_then(Written::of)
    else {
        return false;
    };
    exact::value(exact, &[]).is_some_and(|exact| written.is_rounding_of(&exact))
}

/// The letter that the relations are about: the one that stands by itself.
pub(super) fn letter(relations: &[Expr], letters: &[Letter]) -> Option<Letter> {
    let named = |expr: &Expr| match expr {
        Expr::Name(name) => letters.iter().find(|letter| letter.name() == name.text).copied(),
        _ => None,
    };
    relations.iter().find_map(|relation| match relation {
        Expr::Relation(left, _, right) => named(left).or_else(|| named(right)),
        _ => None,
    })
}

/// Each relation solved for the letter, in which it must be linear.
pub(super) fn bounds(relations: &[Expr], letter: Letter, letters: &[Letter]) -> Option<Vec<Bound>> {
    relations.iter().map(|relation| bound(relation, letter, letters)).collect()
}

fn bound(relation: &Expr, letter: Letter, letters: &[Letter]) -> Option<Bound> {
    let Expr::Relation(left, relation, right) = relation else { return None };
    let value = |expr: &Expr| match evaluate(expr, &|name| meaning_of(letters, name)).ok()? {
        Meaning::Number(value) => Some(value),
        _ => None,
    };
    let difference = &value(left)? - &value(right)?;
    let slope = difference.derivative(letter)?;
    let turns = slope.sign()?.is_lt();
    if slope.is_zero() || slope.letters().contains(&letter) {
        return None;
    }
    let (greater, included) = match relation {
        Relation::Greater => (true, false),
        Relation::GreaterOrEqual => (true, true),
        Relation::Less => (false, false),
        Relation::LessOrEqual => (false, true),
        _ => return None,
    };
    let value = (-difference.substitute(letter, &Value::ZERO)?).divided_by(&slope)?;
    let is_letter = |expr: &Expr| matches!(expr, Expr::Name(name) if name.text == letter.name());
    let by_itself = match (is_letter(left), is_letter(right)) {
        (true, false) => Some(right),
        (false, true) => Some(left),
        _ => None,
    };
    let by_itself = by_itself.filter(|bound| bound.names().iter().all(|name| name.text != letter.name()));
    let shown = by_itself.map_or_else(|| written(&value), |bound| (**bound).clone());
    Some(Bound { above: greater != turns, included: Some(included), value, shown, solved: by_itself.is_some() })
}

/// Is the bound no more than what the letter can be anyway?
pub(super) fn is_natural(bound: &Bound, letter: Letter) -> bool {
    order_to_natural(bound, letter).is_some_and(Ordering::is_ge)
}

/// How far out a bound lies, compared with the last value that the letter can have on that side.
pub(super) fn order_to_natural(bound: &Bound, letter: Letter) -> Option<Ordering> {
    let Span { low, high } = Span::of(letter.range());
    let order = |end: &Value| (&bound.value - end).sign();
    match bound.above {
        true => order(&low?.value).map(Ordering::reverse),
        false => order(&high?.value),
    }
}
