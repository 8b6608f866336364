//! Equations in several unknown letters: one unknown after the other leaves, until one is left, which [`super::equation`] finds.

use super::equation::{MOST_TERMS, NoRoots, clear, coefficients, roots_of};
use super::{Letter, Polynomial, Value};

/// Every value of the unknowns, in the order of `unknowns`, for which all equations may hold.
///
/// # Errors
///
/// See [`NoRoots`].
pub fn solve_system(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
    eliminate(equations, unknowns)
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
    match (by_resultant(equations, unknowns), reason) {
        (Err(_), Some(reason)) => Err(reason),
        (outcome, _) => outcome,
    }
}

/// Of two equations in two unknowns the one unknown leaves by their resultant.
fn by_resultant(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
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
    let factor = shared_factor(&constant, &slope, &rest);
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
    let Some(factor) = factor else { return Some(solve()) };
    // `d (2p - 3) = 0` holds where d is nought, too.
    let mut where_it_vanishes = equations.to_vec();
    where_it_vanishes[index] = factor;
    Some(of_both(solve(), eliminate(&where_it_vanishes, unknowns)))
}

/// What a linear equation has as a factor without its unknown, but with others.
fn shared_factor(constant: &Value, slope: &Value, others: &[Letter]) -> Option<Value> {
    let (constant, slope) = constant.as_quotient().zip(slope.as_quotient())?;
    let factor = Value::quotient(constant.0.greatest_common_divisor(&slope.0), Polynomial::one());
    factor.has_letter(|letter| others.contains(letter)).then_some(factor)
}

/// The solutions of a system, and those where a factor vanishes, each once. Squaring may have brought in a factor of which
/// nothing follows.
fn of_both(
    system: Result<Vec<Vec<Value>>, NoRoots>,
    of_factor: Result<Vec<Vec<Value>>, NoRoots>,
) -> Result<Vec<Vec<Value>>, NoRoots> {
    let Ok(more) = of_factor else { return system };
    let mut all = match system {
        Ok(all) => all,
        Err(NoRoots::Never) => Vec::new(),
        Err(reason) => return Err(reason),
    };
    for solution in more {
        if !all.contains(&solution) {
            all.push(solution);
        }
    }
    Ok(all)
}

fn put_in(value: &Value, unknowns: &[Letter], solution: &[Value]) -> Option<Value> {
    unknowns.iter().zip(solution).try_fold(value.clone(), |value, (unknown, root)| value.substitute(*unknown, root))
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

#[cfg(test)]
mod tests {
    use super::super::Range;
    use super::*;

    fn unknown(name: &str) -> (Letter, Value) {
        let letter = Letter::new(name, Range::Real).unwrap();
        (letter, Value::letter(letter))
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

    #[test]
    fn a_product_that_vanishes_does_so_by_either_factor() {
        let ((x, a), (y, b)) = (unknown("x"), unknown("y"));
        // y (2x - 3) = 0 and x + y = 7
        let product = &b * &(&(&a * &Value::from(2)) - &Value::from(3));
        let sum = &(&a + &b) - &Value::from(7);
        let roots = solve_system(&[product, sum], &[x, y]).unwrap();
        let halves = vec![Value::fraction(3, 2), Value::fraction(11, 2)];
        assert!(roots.contains(&vec![Value::from(7), Value::ZERO]) && roots.contains(&halves), "{roots:?}");
        assert_eq!(roots.len(), 2, "{roots:?}");
    }
}
