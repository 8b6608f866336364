//! The largest value of a quantity: where its rate of change is nought, and at the ends of a range that has them.

use std::cmp::Ordering;

use super::backwards::{Found, MOST_SHOWN, Posed};
use super::conditions_in_words::{in_english, no_roots, without_markup};
use super::law::Known;
use super::line::Line;
use super::refusal::Refusal;
use super::{Derivation, Quantity, pose};
use crate::expr::{Expr, Relation, written, written_angle};
use crate::number::{Angle, Demand, Letter, NoRoots, Polynomial, Range, Span, Value, solve_inequalities, solve_system};

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
                let name = without_markup(&in_english(quantity, self.scene.setting));
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
            let name = without_markup(&in_english(quantity, self.scene.setting));
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

    /// Is it an end of the range of the unknown?
    fn is_end(&self, values: &[Value]) -> bool {
        let is_end = |value: &Value| value.is_zero() || value.equals(&Value::ONE);
        self.scene.unknowns[0].range() == Range::Unit && values.first().is_some_and(is_end)
    }

    /// The slope must fall through nought there.
    pub(super) fn is_maximum(&self, quantity: Quantity, values: &[Value]) -> Result<(), String> {
        if self.is_end(values) {
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

    /// Why it is there that the quantity is largest, and what says so, where that is short.
    pub(super) fn largest_line(&self, quantity: Quantity, values: &[Value]) -> Line {
        let setting = self.scene.setting;
        let what = in_english(quantity, setting);
        let slope = self.stationary(quantity).ok().and_then(|mut slopes| slopes.pop());
        if let ([unknown], [at]) = (self.scene.unknowns.as_slice(), values)
            && let Some(slope) = &slope
            && self.is_end(values)
            && !slope.substitute(*unknown, at).is_some_and(|there| there.is_zero())
        {
            return self.end_line(quantity, slope, *unknown, at).said_of(setting);
        }
        // A quotient is nought where what stands above the line is.
        let above = slope.map(|slope| &slope * &Value::quotient(slope.denominator(), Polynomial::one()));
        let line = match above.filter(|above| !above.is_constant() && above.terms() <= MOST_SHOWN) {
            Some(above) => {
                let words = format!(
                    "At the largest value of {what} its rate of change is nought, and so is what stands above the line in it:"
                );
                Line::plain(&words, vec![Expr::equation(written(&above), Expr::integer(0))])
            }
            None => Line::plain(&format!("At the largest value of {what} its rate of change is nought."), vec![]),
        };
        line.said_of(setting)
    }

    /// Why a quantity is largest at an end of the range of the unknown, where its rate of change is not nought: it grows or
    /// falls all the way, or else, where it does not or that cannot be seen, its values are compared.
    fn end_line(&self, quantity: Quantity, slope: &Value, unknown: Letter, at: &Value) -> Line {
        let what = in_english(quantity, self.scene.setting);
        let name = Expr::name(unknown.name());
        // The rate may be that of the square of a size, or of the tangent of an angle: it has the same sign.
        let of = match self.known.number(quantity) {
            Some(value) if value.derivative(unknown).is_some() => what.clone(),
            Some(_) => format!("the square of {what}"),
            None => format!("the tangent of {what}"),
        };
        let everywhere = |value: &Value, demand| {
            let spans = solve_inequalities(&[(value.clone(), demand)], unknown);
            spans.is_ok_and(|spans| spans == [Span::of(unknown.range())])
        };
        let strictly = |relation| if relation == Relation::Greater { "positive" } else { "negative" };
        let found = [(slope.clone(), Relation::Greater, "negative"), (-slope, Relation::Less, "positive")];
        let found = found.into_iter().find_map(|(value, relation, never)| {
            let weak = if relation == Relation::Greater { Relation::GreaterOrEqual } else { Relation::LessOrEqual };
            if everywhere(&value, Demand::Positive) {
                Some((relation, strictly(relation).to_owned()))
            } else {
                everywhere(&value, Demand::NotNegative).then(|| (weak, format!("never {never}")))
            }
        });
        match found {
            Some((relation, sign)) => {
                let words = format!(
                    "The rate of change of {of} with {{x}} is {sign}, so it is largest at the end {{x}} = {{at}} of the range:"
                );
                let rate = Expr::Relation(Box::new(written(slope)), relation, Box::new(Expr::integer(0)));
                let shown = if slope.terms() <= MOST_SHOWN { vec![rate] } else { vec![] };
                Line::with(&words, &[("x", name), ("at", written(at))], shown)
            }
            None => {
                let mut words =
                    format!("Where its rate of change with {{x}} is nought, and at the ends of the range, {what} is");
                let compared = self.compared(quantity, unknown);
                let names: Vec<[String; 2]> =
                    (0..compared.len()).map(|place| ["p", "v"].map(|name| format!("{name}{place}"))).collect();
                let mut formulas = vec![("x", name)];
                for ([p, v], (place, value)) in names.iter().zip(compared) {
                    let comma = if formulas.len() > 1 { "," } else { "" };
                    words.push_str(&format!("{comma} {{{v}}} for {{x}} = {{{p}}}"));
                    formulas.extend([(p.as_str(), place), (v.as_str(), value)]);
                }
                Line::with(&format!("{words}."), &formulas, vec![])
            }
        }
    }

    /// Each place in the range where a quantity may be largest, and its value there.
    fn compared(&self, quantity: Quantity, unknown: Letter) -> Vec<(Expr, Expr)> {
        let places = self.extremes(quantity).unwrap_or_default().into_iter().flatten();
        // Only e has a range with ends.
        let is_inside = |place: &Value| {
            [place.sign(), (&Value::ONE - place).sign()].iter().all(|sign| sign.is_none_or(Ordering::is_ge))
        };
        let there = |place: &Value| match self.known.number(quantity) {
            Some(value) => Some(written(&value.substitute(unknown, place)?)),
            None => {
                let (y, x) = self.known.direction(quantity)?;
                Angle::of(&y.substitute(unknown, place)?, &x.substitute(unknown, place)?)
                    .map(|angle| written_angle(&angle))
            }
        };
        places.filter(is_inside).filter_map(|place| Some((written(&place), there(&place)?))).collect()
    }
}
