//! Impacts in numbers of one kind, ready to be solved by one function any number of times.

use super::{After, Found, Impact, Prepared, Skip};
use crate::number::Value;

/// A batch of impacts, the function that solves one, and what it last found.
struct Batch<P, S, A> {
    impacts: Vec<P>,
    solve: S,
    after: Vec<A>,
    found: fn(&P, &A) -> Found,
}

/// Puts each impact into the form that a function solves; `found` says what an outcome means.
///
/// The function is a type parameter and no pointer, so that the compiler may fold it into the loop that is timed.
///
/// # Errors
///
/// The first impact that has no such form, and why.
pub(super) fn batch<P: 'static, A: Clone + Default + 'static>(
    impacts: &[Impact<Value>],
    form: impl Fn(&Impact<Value>) -> Result<P, String>,
    solve: impl Fn(&P) -> A + 'static,
    found: fn(&P, &A) -> Found,
) -> Result<Box<dyn Prepared>, Skip> {
    let one = |(place, impact)| form(impact).map_err(|why| Skip { place, why });
    let impacts = impacts.iter().enumerate().map(one).collect::<Result<Vec<P>, Skip>>()?;
    let after = vec![A::default(); impacts.len()];
    Ok(Box::new(Batch { impacts, solve, after, found }))
}

impl<P, A, S: Fn(&P) -> A> Prepared for Batch<P, S, A> {
    fn run(&mut self) {
        for (impact, after) in self.impacts.iter().zip(&mut self.after) {
            *after = (self.solve)(impact);
        }
    }

    fn found(&self) -> Vec<Found> {
        self.impacts.iter().zip(&self.after).map(|(impact, after)| (self.found)(impact, after)).collect()
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
    let form = |impact: &Impact<Value>| impact.in_floats().ok_or_else(|| LETTERS_ARE_NO_FLOATS.to_owned());
    batch(impacts, form, solve, |_, after| match after.as_flattened().iter().all(|component| component.is_finite()) {
        true => Found::Float(*after),
        false => Found::Missed("a component is no finite number".to_owned()),
    })
}
