//! The largest value of a quantity: where its rate of change is nought, and at the ends of a range that has them.

use std::cmp::Ordering;

use super::backwards::{Found, MOST_SHOWN, Posed};
use super::conditions_in_words::{in_english, no_roots};
use super::law::Known;
use super::line::Line;
use super::refusal::Refusal;
use super::{Derivation, Quantity, pose};
use crate::expr::{Expr, written};
use crate::number::{NoRoots, Polynomial, Range, Value, solve_system};

/// Of several places where a quantity may be largest, those that no other surpasses.
pub(super) fn only_largest(found: &mut Vec<Found>, quantity: Quantity) {
    let sizes: Vec<Option<Known<Value>>> = found
        .iter()
        .map(|one| {
            let mut known = pose(&one.scene).ok()?;
            Derivation::carry_out(&mut known, &[quantity]);
            Some(known)
        })
        .collect();
    let surpasses = |one: &Known<Value>, other: &Known<Value>| match (one.number(quantity), other.number(quantity)) {
        (Some(a), Some(b)) => (&a - &b).sign() == Some(Ordering::Greater),
        // Angles from 0 to 180 degrees, by their vectors.
        _ => one
            .direction(quantity)
            .zip(other.direction(quantity))
            .is_some_and(|((y, x), (v, u))| (&(&y * &u) - &(&x * &v)).sign() == Some(Ordering::Greater)),
    };
    let kept: Vec<bool> = sizes
        .iter()
        .map(|size| !size.iter().any(|one| sizes.iter().flatten().any(|other| surpasses(other, one))))
        .collect();
    let mut kept = kept.into_iter();
    found.retain(|_| kept.next().unwrap_or(true));
}

impl Posed<'_> {
    /// Where the rate of change is nought, and the ends of a range that has them.
    pub(super) fn extremes(&self, quantity: Quantity) -> Result<Vec<Vec<Value>>, Refusal> {
        let slopes = self.stationary(quantity)?;
        let unknown = self.scene.unknowns[0];
        let mut candidates = match slopes.as_slice() {
            [slope] if slope.is_zero() => {
                let name = in_english(quantity).replace('*', "");
                return Err(Refusal::underdetermined(format!("{name} is the same whatever {} is", unknown.name())));
            }
            [slope] if slope.letters().contains(&unknown) => match solve_system(&slopes, &[unknown]) {
                Err(NoRoots::Never) => Vec::new(),
                outcome => outcome.map_err(no_roots)?,
            },
            _ => Vec::new(),
        };
        if unknown.range() == Range::Unit {
            for end in [Value::ZERO, Value::ONE] {
                if !candidates.iter().any(|candidate| candidate[0].equals(&end)) {
                    candidates.push(vec![end]);
                }
            }
        } else if candidates.is_empty() {
            let name = in_english(quantity).replace('*', "");
            return Err(Refusal::impossible(format!(
                "{name} has no largest value: its rate of change with {} is never nought",
                unknown.name()
            )));
        }
        Ok(candidates)
    }

    /// The rate of change of what is to be as large as possible. A square root is largest where its
    /// square is.
    fn stationary(&self, quantity: Quantity) -> Result<Vec<Value>, Refusal> {
        let [unknown] = self.scene.unknowns.as_slice() else {
            return Err(Refusal::beyond("a quantity is made as large as possible by one unknown only"));
        };
        let value = match self.known.number(quantity) {
            Some(value) => value,
            None => match self.known.direction(quantity).and_then(|(y, x)| y.divided_by(&x)) {
                Some(tangent) => tangent,
                None => return Err(Refusal::beyond(format!("`{quantity}` cannot be made as large as possible"))),
            },
        };
        let slope = value.derivative(*unknown).or_else(|| (&value * &value).derivative(*unknown));
        slope
            .map(|slope| vec![slope])
            .ok_or_else(|| Refusal::beyond(format!("the largest `{quantity}` is beyond the methods used here")))
    }

    /// The slope must fall through nought there.
    pub(super) fn is_maximum(&self, quantity: Quantity, values: &[Value]) -> Result<(), String> {
        let is_end = |value: &Value| value.is_zero() || value.equals(&Value::ONE);
        if self.scene.unknowns[0].range() == Range::Unit && values.first().is_some_and(is_end) {
            return Ok(());
        }
        let (Some(slope), [unknown], [value]) = (
            self.stationary(quantity).ok().and_then(|mut slopes| slopes.pop()),
            self.scene.unknowns.as_slice(),
            values,
        ) else {
            return Ok(());
        };
        let second = slope.derivative(*unknown).and_then(|second| second.substitute(*unknown, value));
        match second.and_then(|second| second.sign()) {
            Some(Ordering::Greater) => Err(format!("`{quantity}` is smallest there, not largest")),
            _ => Ok(()),
        }
    }

    /// Why it is there that the quantity is largest, and the equation that says so, where that is short.
    pub(super) fn slope_line(&self, quantity: Quantity) -> Line {
        let what = in_english(quantity);
        let slope = self.stationary(quantity).ok().and_then(|mut slopes| slopes.pop());
        // A quotient is nought where what stands above the line is.
        let above = slope.map(|slope| &slope * &Value::quotient(slope.denominator(), Polynomial::one()));
        match above.filter(|above| !above.is_constant() && above.terms() <= MOST_SHOWN) {
            Some(above) => {
                let words = format!(
                    "At the largest value of {what} its rate of change is nought, and so is what stands above the line in it:"
                );
                Line::plain(&words, vec![Expr::equation(written(&above), Expr::integer(0))])
            }
            None => Line::plain(&format!("At the largest value of {what} its rate of change is nought."), vec![]),
        }
    }
}
