//! Is a formula the one that is printed, and not only equal to it?
//!
//! A printed result may be copied with its factors and terms in another order, with a minus or a number taken out of a
//! bracket or cancelled. Nothing else may be left to do: no letter to cancel, no bracket to multiply out, no sine over a
//! cosine to be called a tangent.

use crate::expr::Expr;
use crate::number::Fraction;

/// Are the two one formula but for order, signs and numbers? A number over a number within a fraction is still to be cleared.
pub(super) fn looks_like(printed: &Expr, written: &Expr) -> bool {
    let is_cleared = || !has_fraction_within(written) || has_fraction_within(printed);
    printed == written || look(printed).is_some_and(|printed| look(written) == Some(printed)) && is_cleared()
}

/// Is there a fraction above or below the line of a fraction?
pub(in crate::mark) fn has_fraction_within(expr: &Expr) -> bool {
    match expr {
        Expr::Quotient(above, below) if holds_fraction(above) || holds_fraction(below) => true,
        other => other.children().into_iter().any(has_fraction_within),
    }
}

fn holds_fraction(expr: &Expr) -> bool {
    match expr {
        Expr::Quotient(..) => true,
        Expr::Number(number) => !number.is_integer(),
        other => other.children().into_iter().any(holds_fraction),
    }
}

/// A formula as a number times factors over others, each in a spelling of its own that no order changes.
#[derive(PartialEq, Eq)]
struct Look {
    number: Fraction,
    above: Vec<String>,
    below: Vec<String>,
}

impl Look {
    fn of_factor(spelling: String) -> Look {
        Look { number: Fraction::ONE, above: vec![spelling], below: Vec::new() }
    }

    fn of_number(number: Fraction) -> Look {
        Look { number, above: Vec::new(), below: Vec::new() }
    }

    fn times(self, other: Look) -> Look {
        let joined = |one: Vec<String>, other: Vec<String>| {
            let mut all = [one, other].concat();
            all.sort();
            all
        };
        Look {
            number: self.number * other.number,
            above: joined(self.above, other.above),
            below: joined(self.below, other.below),
        }
    }

    /// One over it. A fraction below a stroke is still to be cleared.
    fn turned_over(self) -> Option<Look> {
        let number = self.number.reciprocal()?;
        self.below.is_empty().then_some(Look { number, above: Vec::new(), below: self.above })
    }

    fn without_number(&self) -> String {
        format!("{}/{}", self.above.join("*"), self.below.join("*"))
    }
}

/// How a formula looks; nothing of one that no printed result has.
fn look(expr: &Expr) -> Option<Look> {
    Some(match expr {
        Expr::Number(number) => Look::of_number(number.clone()),
        Expr::Decimal(text) => Look::of_number(text.parse().ok()?),
        Expr::Negative(inner) => look(inner)?.times(Look::of_number(-Fraction::ONE)),
        Expr::Product(factors) => {
            let nothing = Look::of_number(Fraction::ONE);
            factors.iter().try_fold(nothing, |product, factor| Some(product.times(look(factor)?)))?
        }
        Expr::Quotient(above, below) => look(above)?.times(look(below)?.turned_over()?),
        Expr::Power(base, exponent) => power(base, exponent)?,
        Expr::Sum(terms) => sum(terms)?,
        Expr::Call(function, of) => Look::of_factor(format!("{}({})", function.name(), spelling(of)?)),
        Expr::Degrees(of) => Look::of_factor(format!("{} deg", spelling(of)?)),
        Expr::Name(name) => Look::of_factor(name.text.clone()),
        Expr::Pi => Look::of_factor("pi".to_owned()),
        Expr::Vector(..) | Expr::Relation(..) => return None,
    })
}

fn spelling(expr: &Expr) -> Option<String> {
    let look = look(expr)?;
    Some(format!("{}*{}", look.number, look.without_number()))
}

/// The square of a letter or of a function is the same factor twice.
fn power(base: &Expr, exponent: &Expr) -> Option<Look> {
    match (base, exponent) {
        (Expr::Name(_) | Expr::Call(..), Expr::Number(two)) if *two == Fraction::from(2) => {
            Some(look(base)?.times(look(base)?))
        }
        _ => Some(Look::of_factor(format!("({})^({})", spelling(base)?, spelling(exponent)?))),
    }
}

/// A bracket: what its first term is multiplied by, in a fixed order of the terms, is taken out of it.
fn sum(terms: &[Expr]) -> Option<Look> {
    let mut looks = terms_of(terms)?;
    looks.sort_by_key(|(_, spelling)| spelling.clone());
    let (first, _) = looks.first()?.clone();
    let over = first.reciprocal()?;
    let inner: Vec<String> = looks.iter().map(|(number, rest)| format!("{}*{rest}", number * &over)).collect();
    Some(Look::of_factor(format!("({})", inner.join(" + "))).times(Look::of_number(first)))
}

/// The terms of a sum, with those of a bracket that is only added or multiplied by a number.
fn terms_of(terms: &[Expr]) -> Option<Vec<(Fraction, String)>> {
    let mut all = Vec::new();
    for term in terms {
        let within = bracket(term);
        match within {
            Some((number, inner)) => {
                all.extend(terms_of(inner)?.into_iter().map(|(own, spelling)| (&own * &number, spelling)));
            }
            None => {
                let look = look(term)?;
                let spelling = look.without_number();
                all.push((look.number, spelling));
            }
        }
    }
    Some(all)
}

/// A bracket, and the number by which it is multiplied.
fn bracket(term: &Expr) -> Option<(Fraction, &[Expr])> {
    match term {
        Expr::Sum(inner) => Some((Fraction::ONE, inner)),
        Expr::Negative(inner) => bracket(inner).map(|(number, inner)| (-number, inner)),
        Expr::Product(factors) => match factors.as_slice() {
            [Expr::Number(number), other] | [other, Expr::Number(number)] => {
                bracket(other).map(|(own, inner)| (own * number.clone(), inner))
            }
            _ => None,
        },
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Angles, read};

    #[test]
    fn a_number_over_a_number_within_a_fraction_is_still_to_be_cleared() {
        let printed = "tan(alpha)/(3 + 4*tan(alpha)^2)";
        let table = [
            (printed, true),
            ("tan(alpha)/(4*tan(alpha)^2 + 3)", true),
            ("2*tan(alpha)/(6 + 8*tan(alpha)^2)", true),
            ("(tan(alpha)/3)/(1 + 4*tan(alpha)^2/3)", false),
            ("((1/3)*tan(alpha))/(1 + (4/3)*tan(alpha)^2)", false),
        ];
        let formula = |text| read(text, Angles::Radians).unwrap();
        for (written, expected) in table {
            assert_eq!(looks_like(&formula(printed), &formula(written)), expected, "{written}");
        }
    }
}
