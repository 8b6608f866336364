//! The sign of a formula that is linear in the cosine and the sine of an acute angle, as `2 - cos α` is.
//!
//! Both lie between 0 and 1, and such a formula is a mean of the four values that it has where each is 0 or 1, all with
//! some weight: if none of those is negative and one is positive, so is the formula.

use std::cmp::Ordering;

use super::value::{Root, Value};
use super::{Letter, Polynomial};

impl Value {
    /// The sign that the formula has at all four corners; `None` where it is not linear, or its sign there not known.
    pub(super) fn sign_at_corners(&self) -> Option<Ordering> {
        let roots = self.roots();
        if roots.iter().any(|root| matches!(root, Root::Nested { .. })) {
            return None;
        }
        let tangent = roots.iter().rev().find_map(|root| match root {
            Root::Cosine(tangent) if !tangent.is_constant() => Some(*tangent),
            _ => None,
        })?;
        // By the cosine: its coefficient is that of the cosine, and what is multiplied by the tangent that of the sine.
        let (rest, with) = self.split(&Root::Cosine(tangent));
        if rest.has_letter(|letter| *letter == tangent) {
            return None;
        }
        let of_cosine = with.substitute(tangent, &Value::ZERO)?;
        let of_sine = &with.substitute(tangent, &Value::ONE)? - &of_cosine;
        if !is_linear(&with, &of_cosine, &of_sine, tangent) {
            return None;
        }
        let mut common = Ordering::Equal;
        for corner in [&rest + &of_cosine, &rest + &of_sine, &(&rest + &of_cosine) + &of_sine, rest] {
            let sign = corner.sign()?;
            if sign.is_ne() && common.is_ne() && sign != common {
                return None;
            }
            common = common.then(sign);
        }
        Some(common)
    }
}

/// Is it `a + b t`?
fn is_linear(value: &Value, a: &Value, b: &Value, tangent: Letter) -> bool {
    if value.has_letter(|letter| letter.is_constant()) {
        // What is given as a number of degrees is compared at length; such a formula is left open.
        return false;
    }
    let letter = Value::quotient(Polynomial::letter(tangent), Polynomial::one());
    *value == a + &(b * &letter)
}

#[cfg(test)]
mod tests {
    use super::super::Range;
    use super::*;

    #[test]
    fn a_formula_linear_in_a_cosine_and_a_sine_has_the_sign_of_its_corners() {
        let alpha = Letter::new("alpha", Range::Acute).unwrap();
        let (sine, cosine) = (Value::sine(alpha), Value::cosine(alpha));
        let u = Value::letter(Letter::new("u", Range::Positive).unwrap());
        let number = |number: i64| Value::from(number);
        let table = [
            (&number(2) - &cosine, Some(Ordering::Greater)),
            (&number(1) - &cosine, Some(Ordering::Greater)),
            (&sine - &number(1), Some(Ordering::Less)),
            (&number(2) - &(&sine + &cosine), Some(Ordering::Greater)),
            (&number(1) - &(&sine + &cosine), None),
            (&(&number(3) * &u) - &(&u * &cosine), Some(Ordering::Greater)),
            (&cosine - &sine, None),
            (&number(1) - &(&number(2) * &cosine), None),
            (&u - &cosine, None),
        ];
        for (value, sign) in table {
            assert_eq!(value.sign(), sign, "{value:?}");
        }
    }
}
