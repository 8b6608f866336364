//! Equations in one or two unknown letters, solved exactly.
//!
//! An equation is a value that must be nought. Roots that hold an unknown are removed by squaring,
//! which may bring in roots of its own: whoever asks must try each solution in the original. What is
//! left is a polynomial in the unknown; it is solved if it is linear or quadratic in the unknown or in
//! its square, once factors and rational roots have been taken out.

use std::collections::BTreeMap;

use super::polynomial_roots::roots_of_factor;
use super::value::{Terms, Value, term};
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

/// Every value of the unknowns, in the order of `unknowns`, for which all equations may hold.
///
/// # Errors
///
/// See [`NoRoots`].
pub fn solve_system(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
    eliminate(equations, unknowns)
}

/// The coefficients of the powers 0, 1, 2, … of the unknown in an equation whose other side is nought, once it is free of
/// denominators and of roots that hold the unknown; and whether it had to be squared for that.
pub fn collected(equation: &Value, unknown: Letter) -> Option<(Vec<Value>, bool)> {
    let holds = |root: &Root| match root {
        Root::Nested { radicand, .. } => radicand.has_letter(|own| *own == unknown),
        Root::Cosine(tangent) => *tangent == unknown,
        Root::Prime(_) => false,
    };
    let is_squared = equation.roots().iter().any(holds);
    let cleared = without_common_factor(&clear(equation, &[unknown]).ok()?, unknown);
    let cleared = match cleared.as_quotient() {
        Some((polynomial, _)) => Value::quotient(polynomial.primitive(), Polynomial::one()),
        None => cleared,
    };
    Some((coefficients(&cleared, unknown), is_squared))
}

fn eliminate(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
    match unknowns {
        [] => Ok(vec![Vec::new()]),
        [unknown] => {
            let cleared: Result<Vec<Value>, NoRoots> =
                equations.iter().map(|equation| clear(equation, unknowns)).collect();
            let cleared = cleared?;
            if cleared.iter().any(|equation| equation.is_constant() && !equation.is_zero()) {
                return Err(NoRoots::Never);
            }
            let equation = cleared
                .iter()
                .filter(|equation| equation.has_letter(|own| own == unknown))
                .min_by_key(|equation| coefficients(equation, *unknown).len())
                .ok_or(NoRoots::Always)?;
            Ok(roots_of(equation, *unknown)?.into_iter().map(|root| vec![root]).collect())
        }
        _ => several(equations, unknowns),
    }
}

/// Two unknowns or more: one of them leaves, by substitution where it occurs linearly, else by the
/// resultant of two equations.
fn several(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
    let mut reason = None;
    for place in 0..unknowns.len() {
        for index in 0..equations.len() {
            match by_substitution(equations, index, unknowns, place) {
                Some(Err(NoRoots::Degree(_) | NoRoots::TooLong)) if reason.is_some() => {}
                Some(Err(given_up @ (NoRoots::Degree(_) | NoRoots::TooLong))) => reason = Some(given_up),
                Some(outcome) => return outcome,
                None => {}
            }
        }
    }
    if let Some(reason) = reason {
        return Err(reason);
    }
    let ([first, second, ..], [x, y]) = (equations, unknowns) else { return Err(NoRoots::Degree(2)) };
    let (first, second) = without_shared(clear(first, unknowns)?, clear(second, unknowns)?);
    let resultant = resultant(&coefficients(&first, *x), &coefficients(&second, *x))?;
    let mut solutions = Vec::new();
    for value in roots_of(&clear(&resultant, &[*y])?, *y)? {
        let Some(left) = first.substitute(*y, &value) else { continue };
        for root in roots_of(&clear(&left, &[*x])?, *x)? {
            solutions.push(vec![root, value.clone()]);
        }
    }
    Ok(solutions)
}

/// Two equations without the factor that both have, such as a sum of masses that squaring left in them.
fn without_shared(first: Value, second: Value) -> (Value, Value) {
    let (Some((p, _)), Some((q, _))) = (first.as_quotient(), second.as_quotient()) else { return (first, second) };
    let shared = p.greatest_common_divisor(&q);
    let rest = |all: &Polynomial| Some(Value::quotient(all.divided_by(&shared)?, Polynomial::one()));
    match (rest(&p), rest(&q)) {
        (Some(p), Some(q)) if !p.is_constant() && !q.is_constant() => (p, q),
        _ => (first, second),
    }
}

/// The unknown at a place taken from one equation and put into the others. Roots that hold other
/// unknowns stay as they are, so that a speed or a cosine is squared only where it must be. `None` if
/// the unknown does not occur linearly.
fn by_substitution(
    equations: &[Value],
    index: usize,
    unknowns: &[Letter],
    place: usize,
) -> Option<Result<Vec<Vec<Value>>, NoRoots>> {
    let unknown = unknowns[place];
    let cleared = clear(&equations[index], &[unknown]).ok()?;
    let [constant, slope] = coefficients(&cleared, unknown).try_into().ok()?;
    let root = (-&constant).divided_by(&slope)?;
    let rest: Vec<Letter> = unknowns.iter().filter(|other| **other != unknown).copied().collect();
    let others = equations.iter().enumerate().filter(|(other, _)| *other != index);
    let substituted: Option<Vec<Value>> = others.map(|(_, other)| other.substitute(unknown, &root)).collect();
    let solve = || {
        let mut solutions = Vec::new();
        for solution in eliminate(&substituted.ok_or(NoRoots::Never)?, &rest)? {
            if let Some(value) = put_in(&root, &rest, &solution) {
                let mut all = solution;
                all.insert(place, value);
                solutions.push(all);
            }
        }
        Ok(solutions)
    };
    Some(solve())
}

fn put_in(value: &Value, unknowns: &[Letter], solution: &[Value]) -> Option<Value> {
    unknowns.iter().zip(solution).try_fold(value.clone(), |value, (unknown, root)| value.substitute(*unknown, root))
}

/// The equation times whatever makes it free of denominators and of roots that hold an unknown.
fn clear(equation: &Value, unknowns: &[Letter]) -> Result<Value, NoRoots> {
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
fn coefficients(equation: &Value, unknown: Letter) -> Vec<Value> {
    let mut by_power: BTreeMap<usize, Terms> = BTreeMap::new();
    for (roots, polynomial) in equation.numerator_terms() {
        for (power, coefficient) in polynomial.coefficients(unknown).into_iter().enumerate() {
            by_power.entry(power).or_default().insert(roots.clone(), coefficient);
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
fn roots_of(equation: &Value, unknown: Letter) -> Result<Vec<Value>, NoRoots> {
    if equation.is_zero() {
        return Err(NoRoots::Always);
    }
    let equation = &without_common_roots(equation);
    let factors: Vec<Value> = match equation.as_quotient() {
        Some((polynomial, _)) => {
            let (_, factors) = polynomial.square_free();
            factors.into_iter().map(|(factor, _)| Value::quotient(factor, Polynomial::one())).collect()
        }
        None => vec![without_common_factor(equation, unknown)],
    };
    let mut roots: Vec<Value> = Vec::new();
    let mut left_over = None;
    for factor in factors {
        match roots_of_factor(coefficients(&factor, unknown)) {
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
    let mut shared = terms.keys().next().cloned().unwrap_or_default();
    shared.retain(|root| terms.keys().all(|key| key.contains(root)));
    if shared.is_empty() {
        return equation.clone();
    }
    let without = |(mut key, coefficient): (Vec<Root>, Polynomial)| {
        key.retain(|root| !shared.contains(root));
        (key, coefficient)
    };
    Value::build(terms.into_owned().into_iter().map(without).collect(), denominator.into_owned())
}

/// With surds among the coefficients: what all polynomials share is solved apart from the rest only if
/// it does not hold the unknown, and then it is no equation at all.
fn without_common_factor(equation: &Value, unknown: Letter) -> Value {
    let terms = equation.numerator_terms();
    let shared = terms.iter().fold(Polynomial::zero(), |shared, (_, p)| shared.greatest_common_divisor(p));
    if shared.degree(unknown) > 0 || shared.is_one() {
        return equation.clone();
    }
    equation.divided_by(&Value::quotient(shared, Polynomial::one())).unwrap_or_else(|| equation.clone())
}

/// The determinant that is nought exactly where two polynomials share a root.
fn resultant(first: &[Value], second: &[Value]) -> Result<Value, NoRoots> {
    let (m, n) = (first.len().saturating_sub(1), second.len().saturating_sub(1));
    if m == 0 || n == 0 || m + n > 8 {
        return Err(NoRoots::Degree(m.max(n)));
    }
    let size = m + n;
    let mut rows = vec![vec![Value::ZERO; size]; size];
    for shift in 0..n {
        for (power, coefficient) in first.iter().rev().enumerate() {
            rows[shift][shift + power] = coefficient.clone();
        }
    }
    for shift in 0..m {
        for (power, coefficient) in second.iter().rev().enumerate() {
            rows[n + shift][shift + power] = coefficient.clone();
        }
    }
    determinant(rows)
}

fn determinant(mut rows: Vec<Vec<Value>>) -> Result<Value, NoRoots> {
    let size = rows.len();
    let mut result = Value::ONE;
    for column in 0..size {
        let Some(pivot) = (column..size).find(|row| !rows[*row][column].is_zero()) else { return Ok(Value::ZERO) };
        if pivot != column {
            rows.swap(pivot, column);
            result = -result;
        }
        let lead = rows[column][column].clone();
        result = &result * &lead;
        for row in column + 1..size {
            let Some(factor) = rows[row][column].divided_by(&lead) else { continue };
            if factor.is_zero() {
                continue;
            }
            let pivot_row = rows[column].clone();
            for (entry, above) in rows[row].iter_mut().zip(&pivot_row).skip(column) {
                *entry = &*entry - &(&factor * above);
                if entry.terms() > MOST_TERMS {
                    return Err(NoRoots::TooLong);
                }
            }
        }
    }
    Ok(result)
}

impl Value {
    /// The rate of change with a letter that no root in the value holds; `None` if one does.
    pub fn derivative(&self, letter: Letter) -> Option<Value> {
        let (terms, denominator) = self.parts();
        let mut sum = Value::ZERO;
        let below = Value::quotient(denominator.clone().into_owned(), Polynomial::one());
        let slope_below = Value::quotient(denominator.derivative(letter), Polynomial::one());
        for (roots, coefficient) in &*terms {
            let holds = |root: &Root| match root {
                Root::Prime(_) => false,
                Root::Cosine(tangent) => *tangent == letter,
                Root::Nested { radicand, .. } => radicand.has_letter(|own| *own == letter),
            };
            if roots.iter().any(holds) {
                return None;
            }
            let slope = Value::build(term(roots.clone(), coefficient.derivative(letter)), Polynomial::one());
            let above = Value::build(term(roots.clone(), coefficient.clone()), Polynomial::one());
            sum = &sum + &(&(&slope * &below) - &(&above * &slope_below));
        }
        sum.divided_by(&(&below * &below))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Range;
    use super::*;

    fn unknown(name: &str) -> (Letter, Value) {
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

    #[test]
    fn two_unknowns_by_substitution_and_by_resultant() {
        let ((x, a), (y, b)) = (unknown("x"), unknown("y"));
        let sum = &(&a + &b) - &Value::from(5);
        let product = &(&a * &b) - &Value::from(6);
        let roots = solve_system(&[product, sum], &[x, y]).unwrap();
        assert!(roots.contains(&vec![Value::from(2), Value::from(3)]) && roots.len() == 2, "{roots:?}");
        let circle = &(&(&a * &a) + &(&b * &b)) - &Value::from(25);
        let hyperbola = &(&(&a * &a) - &(&b * &b)) - &Value::from(7);
        let roots = solve_system(&[circle, hyperbola], &[x, y]).unwrap();
        assert!(roots.contains(&vec![Value::from(4), Value::from(-3)]), "{roots:?}");
    }
}
