//! Impacts in numbers of one kind, ready to be solved by one function any number of times.

use super::{After, Found, Impact, Prepared, Skip};
use crate::number::Value;

/// A batch of impacts, the function that solves one, what it last found, and what must be known to say what that means.
struct Batch<P, Q, S, A> {
    impacts: Vec<P>,
    solve: S,
    after: Vec<A>,
    kept: Vec<Q>,
    found: fn(&Q, &A) -> Found,
}

/// Puts each impact into the form that a function solves, beside what is kept for `found`, which says what an outcome means.
///
/// The function is a type parameter and no pointer, so that the compiler may fold it into the loop that is timed.
///
/// # Errors
///
/// The first impact that has no such form, and why.
pub(super) fn batch<P: 'static, Q: 'static, A: Clone + Default + 'static>(
    impacts: &[Impact<Value>],
    form: impl Fn(&Impact<Value>) -> Result<(P, Q), String>,
    solve: impl Fn(&P) -> A + 'static,
    found: fn(&Q, &A) -> Found,
) -> Result<Box<dyn Prepared>, Skip> {
    let one = |(place, impact)| form(impact).map_err(|why| Skip { place, why });
    let forms = impacts.iter().enumerate().map(one).collect::<Result<Vec<(P, Q)>, Skip>>()?;
    let (impacts, kept): (Vec<P>, Vec<Q>) = forms.into_iter().unzip();
    let after = vec![A::default(); impacts.len()];
    Ok(Box::new(Batch { impacts, solve, after, kept, found }))
}

impl<P, Q, A, S: Fn(&P) -> A> Prepared for Batch<P, Q, S, A> {
    fn run(&mut self) {
        for (impact, after) in self.impacts.iter().zip(&mut self.after) {
            *after = (self.solve)(impact);
        }
    }

    fn found(&self) -> Vec<Found> {
        self.kept.iter().zip(&self.after).map(|(kept, after)| (self.found)(kept, after)).collect()
    }
}

/// Why an impact with letters has no floats.
pub(super) const LETTERS_ARE_NO_FLOATS: &str = "letters are no floats";

/// A batch of impacts in doubles.
///
/// # Errors
///
/// The first impact with a letter in it.
pub(super) fn floats(
    impacts: &[Impact<Value>],
    solve: impl Fn(&Impact<f64>) -> After<f64> + 'static,
) -> Result<Box<dyn Prepared>, Skip> {
    let form = |impact: &Impact<Value>| Ok((impact.in_floats().ok_or_else(|| LETTERS_ARE_NO_FLOATS.to_owned())?, ()));
    batch(impacts, form, solve, |(), after| float(*after))
}

/// Floats as they were found, unless one is no finite number.
pub(super) fn float(after: After<f64>) -> Found {
    match after.as_flattened().iter().all(|component| component.is_finite()) {
        true => Found::Float(after),
        false => Found::Missed("a component is no finite number".to_owned()),
    }
}

/// Exact values as they were found, unless a quotient was not carried out.
pub(super) fn exact(after: Option<&After<Value>>) -> Found {
    match after {
        Some(after) => Found::Exact(after.clone()),
        None => Found::Missed("a quotient by a sum of many roots is not carried out".to_owned()),
    }
}
