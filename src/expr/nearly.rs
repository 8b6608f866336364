//! About what an expression comes to, between two doubles that surely hold it: most comparisons need no more.

use super::evaluate::{Meaning, Names};
use super::{Expr, Function};
use crate::number::{FloatInterval, Fraction, Value};

/// The highest whole power that is worked out here.
const MOST_POWER: i64 = 4;

/// Two doubles that hold the number that an expression stands for; `None` if it is no number without letters, or if doubles
/// do not suffice.
pub(super) fn nearly(expr: &Expr, names: Names) -> Option<FloatInterval> {
    let found = match expr {
        Expr::Number(value) => FloatInterval::from_fraction(value),
        Expr::Decimal(text) => FloatInterval::from_fraction(&text.parse::<Fraction>().ok()?),
        Expr::Name(name) => match names(&name.text)? {
            Meaning::Number(Value::Rational(value)) => FloatInterval::from_fraction(&value),
            Meaning::Number(value) => value.between_doubles()?,
            _ => return None,
        },
        Expr::Negative(inner) => -nearly(inner, names)?,
        Expr::Sum(terms) => {
            let (first, rest) = terms.split_first()?;
            rest.iter().try_fold(nearly(first, names)?, |sum, term| Some(sum + nearly(term, names)?))?
        }
        Expr::Product(factors) => {
            let (first, rest) = factors.split_first()?;
            rest.iter().try_fold(nearly(first, names)?, |product, factor| Some(product * nearly(factor, names)?))?
        }
        Expr::Quotient(above, below) => nearly(above, names)?.checked_div(nearly(below, names)?)?,
        Expr::Power(base, exponent) => {
            let Expr::Number(exponent) = &**exponent else { return None };
            let (exponent, _) =
                exponent.as_small().filter(|(whole, below)| *below == 1 && (1..=MOST_POWER).contains(whole))?;
            let base = nearly(base, names)?;
            (1..exponent).fold(base, |product, _| product * base)
        }
        Expr::Call(Function::Abs, inner) => nearly(inner, names)?.abs(),
        // Of what may be negative there may be no root.
        Expr::Call(Function::Sqrt, inner) => {
            nearly(inner, names).filter(|value| value.sign().is_some_and(|sign| sign.is_gt()))?.sqrt()?
        }
        _ => return None,
    };
    found.is_finite().then_some(found)
}

#[cfg(test)]
mod tests {
    use super::super::{Angles, holds, read};
    use super::*;

    fn names(name: &str) -> Option<Meaning> {
        let number = match name {
            "a" => Value::fraction(7, 12),
            "b" => Value::from(18).square_root()?,
            "c" => (&Value::from(3) + &Value::from(11).square_root()?).square_root()?,
            _ => return None,
        };
        Some(Meaning::Number(number))
    }

    #[test]
    fn what_doubles_hold_is_the_exact_number() {
        for text in
            ["a", "-b", "a + b - c", "2*a*c", "c/b", "abs(a - c)^3", "sqrt(c + 1/3)", "0.25*b^2", "(b - a)/(1.5 - c)"]
        {
            let expr = read(text, Angles::Degrees).unwrap();
            let near = nearly(&expr, &names).unwrap_or_else(|| panic!("{text}"));
            let exact = super::super::number(&expr, &names).unwrap().enclose_constant(200).unwrap();
            assert!(near.overlaps(FloatInterval::from_interval(&exact)) && near.sharp().is_some(), "{text}");
        }
    }

    #[test]
    fn what_doubles_cannot_tell_is_left_to_exact_numbers() {
        for text in ["sqrt(b^2 - 18)", "1/(b^2 - 18)", "x", "b^(1/2)", "a^9", "sqrt(0 - a)", "atan(a)"] {
            assert!(nearly(&read(text, Angles::Degrees).unwrap(), &names).is_none(), "{text}");
        }
        for (text, holding) in
            [("b^2 = 18", true), ("b^2 != 18", false), ("sqrt(b^2 - 18) < 1", true), ("c^2 - 3 <= sqrt(11)", true)]
        {
            assert_eq!(holds(&read(text, Angles::Degrees).unwrap(), &names), Ok(Some(holding)), "{text}");
        }
    }
}
