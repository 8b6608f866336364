//! Values of unknowns that are too long to be put back: the unknowns stay letters, and intervals tell what holds.
//!
//! A root of fifty terms can be written down, but a quotient by it would be rationalised root after root, for minutes and
//! pages. A formula in the letter with the letter's value beside it is what one would write, too.

use std::cmp::Ordering;
use std::sync::Arc;

use super::backwards::{Found, Posed, Reason};
use super::later::Meeting;
use super::law::{Here, MASSES};
use super::validity::check;
use super::{Quantity, Scene};
use crate::expr::{Expr, print};
use crate::number::{Interval, Letter, Value};

/// The most terms of a value that is put back although one cannot easily divide by it.
const MOST_TERMS: usize = 24;

/// The binary places in which it is tried whether a solution can happen, as many as conditions are tried with.
const BITS: usize = 256;

/// What was found for letters.
type Values<'v> = (&'v [Letter], &'v [Value]);

impl Posed {
    /// A candidate with the unknowns left letters, if it is too long to be put back.
    ///
    /// # Errors
    ///
    /// Why the candidate is no solution.
    pub(super) fn left_as_letters(self: &Arc<Self>, values: &[Value]) -> Result<Option<Found>, Reason> {
        let is_long = |value: &Value| value.terms() > MOST_TERMS && value.is_laborious();
        if values.iter().any(is_long) { self.in_letters(values) } else { Ok(None) }
    }

    /// A candidate with the unknowns left letters, if other letters, other things to be found and laws that nothing satisfies
    /// of itself do not ask for more than intervals can tell.
    pub(super) fn in_letters(self: &Arc<Self>, values: &[Value]) -> Result<Option<Found>, Reason> {
        let unknowns = &self.scene.unknowns;
        let is_alone = self.scene.letters.iter().all(|letter| unknowns.contains(letter));
        let is_of_numbers = is_alone && values.iter().all(Value::is_constant);
        if !is_of_numbers || self.scene.maximise.is_some() || !self.broken.is_empty() {
            return Ok(None);
        }
        for condition in &self.scene.conditions {
            if !self.holds_at(condition, values).ok_or(Reason::Undecided)? {
                let relation = Expr::equation(condition.left.clone(), condition.right.clone());
                return Err(format!("it does not satisfy `{}`", print::plain(&relation)).into());
            }
        }
        let known = check(&self.given).map_err(|refusal| refusal.reason)?;
        for meeting in [Meeting::FIRST].into_iter().chain(Meeting::all(self.given.0.keys())) {
            can_happen(&Here::at(meeting, &known), (unknowns, values))?;
        }
        let scene = Scene { unknowns: Vec::new(), conditions: Vec::new(), ..self.scene.clone() };
        let mut found = Found::from(Arc::clone(self), scene);
        found.values = unknowns.iter().copied().zip(values.iter().cloned()).collect();
        found.worked = Some((self.given.clone(), known));
        found.are_left = true;
        Ok(Some(found))
    }
}

/// Masses are positive, the spheres approach, and a coefficient of restitution is one.
fn can_happen(known: &Here<Value>, (unknowns, values): Values) -> Result<(), Reason> {
    let at = |letter: Letter| {
        let place = unknowns.iter().position(|unknown| *unknown == letter)?;
        values[place].enclose_constant(BITS)
    };
    let enclosed = |quantity: Quantity| known.number(quantity)?.enclose(BITS, &at);
    let above = |quantity: Quantity, least: i64| {
        let above: Interval = enclosed(quantity)? - Interval::integer(least, BITS);
        if above.contains_zero() { Some(Ordering::Equal) } else { above.sign() }
    };
    for (mass, name) in MASSES.into_iter().zip(["A", "B"]) {
        if above(mass, 0).is_some_and(Ordering::is_le) {
            return Err(format!("the mass of {name} would not be positive").into());
        }
    }
    if above(Quantity::Approach, 0).is_some_and(Ordering::is_le) {
        return Err("the spheres do not approach along the line of centres, so there is no impact".to_owned().into());
    }
    if above(Quantity::Separation, 0).is_some_and(Ordering::is_lt) {
        return Err("the spheres would pass through each other".to_owned().into());
    }
    if above(Quantity::Restitution, 0).is_some_and(Ordering::is_lt)
        || above(Quantity::Restitution, 1).is_some_and(Ordering::is_gt)
    {
        return Err("the coefficient of restitution would not be one from 0 to 1".to_owned().into());
    }
    Ok(())
}
