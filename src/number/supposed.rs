//! The sign of a formula where another is positive: with `u > w` is `10u - w` positive, as `9w + 10d` is with `u = w + d`.

use std::cmp::Ordering;

use super::{Letter, Range, Value};

impl Value {
    /// The size without the sign where another value is positive.
    pub fn absolute_where_positive(&self, positive: &Value) -> Value {
        match self.sign_where_positive(positive) {
            Some(Ordering::Less) => -self,
            Some(_) => self.clone(),
            None => self.absolute(),
        }
    }

    /// The sign that the value has wherever another is positive, with letters in their ranges.
    fn sign_where_positive(&self, positive: &Value) -> Option<Ordering> {
        let known = self.sign();
        if known.is_some() || positive.sign().is_some() {
            return known;
        }
        // No letter that is typed has a space in its name.
        let difference = Value::letter(Letter::new("the difference", Range::Positive)?);
        let by = |letter: Letter| {
            let rest = positive.substitute(letter, &Value::ZERO)?;
            let slope = &positive.substitute(letter, &Value::ONE)? - &rest;
            let is_linear = *positive == &rest + &(&slope * &Value::letter(letter));
            if !is_linear || slope.has_letter(|other| *other == letter) || slope.sign() != Some(Ordering::Greater) {
                return None;
            }
            self.substitute(letter, &(&difference - &rest).divided_by(&slope)?)?.sign()
        };
        let is_free = |letter: &Letter| matches!(letter.range(), Range::Positive | Range::Real);
        let letters = positive.letters().into_iter().filter(is_free);
        letters.into_iter().find_map(by)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_is_faster_decides_signs() {
        let letter = |name| Value::letter(Letter::new(name, Range::Positive).unwrap());
        let (u, w, m) = (letter("u"), letter("w"), letter("m"));
        let x = Value::letter(Letter::new("x", Range::Real).unwrap());
        let cosine = Value::cosine(Letter::new("alpha", Range::Acute).unwrap());
        let times = |number: i64, value: &Value| &Value::from(number) * value;
        let approach = &u - &w;
        let table = [
            (&times(10, &u) - &w, &approach, Some(Ordering::Greater)),
            (&w - &times(2, &u), &approach, Some(Ordering::Less)),
            (&(&m * &u) - &(&m * &w), &approach, Some(Ordering::Greater)),
            (&u - &times(2, &w), &approach, None),
            (&times(3, &(&u * &cosine)) - &w, &(&(&u * &cosine) - &w), Some(Ordering::Greater)),
            (&u - &w, &(&u - &(&w * &cosine)), None),
            (times(2, &x), &times(3, &x), Some(Ordering::Greater)),
        ];
        for (value, positive, sign) in table {
            assert_eq!(value.sign_where_positive(positive), sign, "{value:?}");
        }
    }
}
