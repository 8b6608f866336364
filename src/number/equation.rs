//! Equations in one unknown letter, solved exactly; of several unknowns the others leave first: [`super::elimination`].
//!
//! An equation is a value that must be nought. Roots that hold an unknown are removed by squaring,
//! which may bring in roots of its own: whoever asks must try each solution in the original. What is
//! left is a polynomial in the unknown; it is solved if it is linear or quadratic in the unknown or in
//! its square, once factors and rational roots have been taken out.

use std::collections::BTreeMap;

use super::polynomial_roots::{coprime, roots_of_factor};
use super::terms::{Roots, Terms};
use super::value::Value;
use super::{Letter, Polynomial, Root};

/// Why a system was not solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoRoots {
    /// It holds whatever the unknown is.
    Always,
    /// It never holds.
    Never,
    /// A factor of this degree is left.
    Degree(usize),
    /// The formulas grow too long.
    TooLong,
}

/// Squaring doubles a formula; beyond this many terms it is given up.
pub(super) const MOST_TERMS: usize = 600;

/// The coefficients of the powers 0, 1, 2, … of the unknown in an equation whose other side is nought, once it is free of
/// denominators and of roots that hold the unknown; and whether it had to be squared for that.
pub fn collected(equation: &Value, unknown: Letter) -> Option<(Vec<Value>, bool)> {
    let holds = |root: &Root| match root {
        Root::Nested { radicand, .. } => radicand.has_letter(|own| *own == unknown),
        Root::Cosine(tangent) => *tangent == unknown,
        Root::Prime(_) => false,
    };
    let is_squared = equation.roots().iter().any(holds);
    let cleared = clear(equation, &[unknown]).ok()?;
    let (shared, rest) = without_common_factor(&cleared);
    // What holds the unknown is part of the equation.
    let cleared = if shared.degree(unknown) > 0 { cleared } else { rest };
    let cleared = match cleared.as_quotient() {
        Some((polynomial, _)) => Value::quotient(polynomial.primitive(), Polynomial::one()),
        None => cleared,
    };
    Some((coefficients(&cleared, unknown), is_squared))
}

/// The equation times whatever makes it free of denominators and of roots that hold an unknown.
pub(super) fn clear(equation: &Value, unknowns: &[Letter]) -> Result<Value, NoRoots> {
    let mut equation = numerator(equation);
    loop {
        if equation.terms() > MOST_TERMS {
            return Err(NoRoots::TooLong);
        }
        let holds_unknown = |root: &Root| {
            let letters = match root {
                Root::Cosine(tangent) => vec![*tangent],
                Root::Nested { radicand, .. } => radicand.letters(),
                Root::Prime(_) => Vec::new(),
            };
            letters.iter().any(|letter| unknowns.contains(letter))
        };
        let Some(root) = equation.roots().into_iter().rfind(holds_unknown) else { return Ok(equation) };
        let (without, with) = equation.split(&root);
        equation = if without.is_zero() {
            // Nought where the root is, too.
            numerator(&(&with * &root.square()))
        } else {
            numerator(&(&(&without * &without) - &(&(&with * &with) * &root.square())))
        };
    }
}

fn numerator(value: &Value) -> Value {
    let (terms, _) = value.parts();
    Value::build(terms.into_owned(), Polynomial::one())
}

/// The coefficients of the powers 0, 1, 2, … of the unknown in a cleared equation.
pub(super) fn coefficients(equation: &Value, unknown: Letter) -> Vec<Value> {
    let mut by_power: BTreeMap<usize, Terms> = BTreeMap::new();
    for (roots, polynomial) in equation.numerator_terms().iter() {
        for (power, coefficient) in polynomial.coefficients(unknown).into_iter().enumerate() {
            *by_power.entry(power).or_default().coefficient_mut(roots.clone()) = coefficient;
        }
    }
    let mut coefficients: Vec<Value> =
        by_power.into_values().map(|terms| Value::build(terms, Polynomial::one())).collect();
    while coefficients.last().is_some_and(Value::is_zero) {
        coefficients.pop();
    }
    coefficients
}

/// The values of the unknown for which a cleared equation holds.
pub(super) fn roots_of(equation: &Value, unknown: Letter) -> Result<Vec<Value>, NoRoots> {
    if equation.is_zero() {
        return Err(NoRoots::Always);
    }
    let equation = &without_common_roots(equation);
    let factors: Vec<Value> = match equation.as_quotient() {
        Some((polynomial, _)) => {
            let (_, factors) = polynomial.square_free();
            factors.into_iter().map(|(factor, _)| Value::quotient(factor, Polynomial::one())).collect()
        }
        None => {
            let (shared, rest) = without_common_factor(equation);
            let (_, shared) = shared.square_free();
            let whole = shared.into_iter().map(|(factor, _)| Value::quotient(factor, Polynomial::one()));
            whole.filter(|factor| factor.has_letter(|letter| *letter == unknown)).chain([rest]).collect()
        }
    };
    let mut roots: Vec<Value> = Vec::new();
    let mut left_over = None;
    let factors = factors.iter().map(|factor| coefficients(factor, unknown)).collect();
    for factor in coprime(factors) {
        match roots_of_factor(factor) {
            Ok(found) => {
                for root in found {
                    if !roots.iter().any(|other| other.equals(&root)) {
                        roots.push(root);
                    }
                }
            }
            Err(reason) => left_over = Some(reason),
        }
    }
    match left_over {
        Some(reason) => Err(reason),
        None => Ok(roots),
    }
}

/// Divided by the roots that all its terms share, as that of an angle's sine and cosine: they are not nought, and beneath
/// the root of a discriminant they would only come back as factors that nothing cancels.
fn without_common_roots(equation: &Value) -> Value {
    let (terms, denominator) = equation.parts();
    let mut shared = terms.products().next().cloned().unwrap_or_default();
    shared.retain(|root| terms.products().all(|key| key.contains(root)));
    if shared.is_empty() {
        return equation.clone();
    }
    let without = |(mut key, coefficient): (Roots, Polynomial)| {
        key.retain(|root| !shared.contains(root));
        (key, coefficient)
    };
    Value::build(terms.into_owned().into_iter().map(without).collect(), denominator.into_owned())
}

/// With surds among the coefficients: what all polynomials share, and the rest.
fn without_common_factor(equation: &Value) -> (Polynomial, Value) {
    let terms = equation.numerator_terms();
    let shared = terms.iter().fold(Polynomial::zero(), |shared, (_, p)| shared.greatest_common_divisor(p));
    let rest = equation.divided_by(&Value::quotient(shared.clone(), Polynomial::one()));
    match rest {
        Some(rest) if !shared.is_one() => (shared, rest),
        _ => (Polynomial::one(), equation.clone()),
    }
}

impl Value {
    /// The rate of change with a letter that no root in the value holds; `None` if one does.
    pub fn derivative(&self, letter: Letter) -> Option<Value> {
        let (terms, denominator) = self.parts();
        let mut sum = Value::ZERO;
        let below = Value::quotient(denominator.clone().into_owned(), Polynomial::one());
        let slope_below = Value::quotient(denominator.derivative(letter), Polynomial::one());
        for (roots, coefficient) in terms.iter() {
            let holds = |root: &Root| match root {
                Root::Prime(_) => false,
                Root::Cosine(tangent) => *tangent == letter,
                Root::Nested { radicand, .. } => radicand.has_letter(|own| *own == letter),
            };
            if roots.iter().any(holds) {
                return None;
            }
            let slope = Value::build(Terms::one(roots.clone(), coefficient.derivative(letter)), Polynomial::one());
            let above = Value::build(Terms::one(roots.clone(), coefficient.clone()), Polynomial::one());
            sum = &sum + &(&(&slope * &below) - &(&above * &slope_below));
        }
        sum.divided_by(&(&below * &below))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::{Range, solve_system};
    use super::*;

    /// A letter to be found, and its value.
    pub fn unknown(name: &str) -> (Letter, Value) {
        let letter = Letter::new(name, Range::Real).unwrap();
        (letter, Value::letter(letter))
    }

    #[test]
    fn one_unknown_in_its_square_or_under_a_root() {
        let (x, value) = unknown("x");
        let square = &(&value * &value) - &Value::from(3);
        let roots = solve_system(&[square], &[x]).unwrap();
        assert_eq!(roots.len(), 2);
        let root = (&value + &Value::from(7)).square_root().unwrap();
        let roots = solve_system(&[&root - &(&value + &Value::ONE)], &[x]).unwrap();
        assert!(roots.contains(&vec![Value::from(2)]), "{roots:?}");
    }

    #[test]
    fn a_cubic_with_a_rational_root_and_one_without() {
        let (x, value) = unknown("x");
        let cube = value.power(3).unwrap();
        let roots = solve_system(&[&cube - &Value::from(8)], &[x]).unwrap();
        assert_eq!(roots, vec![vec![Value::from(2)]]);
        assert_eq!(solve_system(&[&(&cube - &value) - &Value::ONE], &[x]), Err(NoRoots::Degree(3)));
    }
}
