//! Equations in several unknown letters: one unknown after the other leaves, until one is left, which [`super::equation`] finds.

use std::cmp::Ordering;

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
            let open: Vec<&Value> =
                cleared.iter().filter(|equation| equation.has_letter(|own| own == unknown)).collect();
            let equation = match open.as_slice() {
                [only] => only,
                all => {
                    all.iter().min_by_key(|equation| coefficients(equation, *unknown).len()).ok_or(NoRoots::Always)?
                }
            };
            Ok(roots_of(equation, *unknown)?.into_iter().map(|root| vec![root]).collect())
        }
        _ => several(equations, unknowns),
    }
}

/// Two unknowns or more: one of them leaves, with its roots where an equation has it alone, by substitution where it occurs
/// linearly, else by the resultant of two equations.
fn several(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
    for index in 0..equations.len() {
        if let Some(solutions) = by_one_alone(equations, index, unknowns) {
            return solutions;
        }
    }
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

/// Each root of an equation of higher degree in one of the unknowns alone, put into the others. `None` where it has more
/// unknowns than one, or its roots or those of the others are not found in this way.
fn by_one_alone(equations: &[Value], index: usize, unknowns: &[Letter]) -> Option<Result<Vec<Vec<Value>>, NoRoots>> {
    let cleared = clear(&equations[index], unknowns).ok()?;
    let mut held = (0..unknowns.len()).filter(|place| cleared.has_letter(|letter| *letter == unknowns[*place]));
    let (place, None) = (held.next()?, held.next()) else { return None };
    let unknown = unknowns[place];
    if coefficients(&cleared, unknown).len() == 2 {
        return None;
    }
    let rest: Vec<Letter> = unknowns.iter().filter(|other| **other != unknown).copied().collect();
    let mut solutions = Vec::new();
    for root in roots_of(&cleared, unknown).ok()? {
        let others = equations.iter().enumerate().filter(|(other, _)| *other != index);
        let others: Option<Vec<Value>> = others.map(|(_, other)| other.substitute(unknown, &root)).collect();
        let Some(others) = others else { continue };
        match eliminate(&others, &rest) {
            Ok(found) => solutions.extend(found.into_iter().map(|mut all| {
                all.insert(place, root.clone());
                all
            })),
            Err(NoRoots::Never) => {}
            Err(_) => return None,
        }
    }
    Some(if solutions.is_empty() { Err(NoRoots::Never) } else { Ok(solutions) })
}

/// Of two equations in two unknowns the one unknown leaves by their resultant.
fn by_resultant(equations: &[Value], unknowns: &[Letter]) -> Result<Vec<Vec<Value>>, NoRoots> {
    let ([first, second, ..], [x, y]) = (equations, unknowns) else { return Err(NoRoots::Degree(2)) };
    let (first, second) = without_shared(clear(first, unknowns)?, clear(second, unknowns)?);
    let resultant = resultant(&coefficients(&first, *x), &coefficients(&second, *x))?;
    let mut solutions = Vec::new();
    for value in roots_of(&clear(&resultant, &[*y])?, *y)? {
        // Where the first holds whatever the other unknown is, the second finds it.
        let left =
            [&first, &second].into_iter().filter_map(|one| one.substitute(*y, &value)).find(|left| !left.is_zero());
        let Some(left) = left else { continue };
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
    let (mut all, more) = match (system, of_factor) {
        // Elsewhere there is none: what is not found where the factor vanishes is not found at all.
        (Err(NoRoots::Never), of_factor) => (Vec::new(), of_factor?),
        (system, Err(_)) => return system,
        (system, Ok(more)) => (system?, more),
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

/// What two unknowns must fulfil besides, where one equation determines them both: that of squares which add up to nought.
/// Of a square in one unknown the discriminant is then nowhere positive, so that it is nought.
pub fn discriminant_of_squares(equation: &Value, unknowns: &[Letter]) -> Option<Value> {
    let cleared = clear(equation, unknowns).ok()?;
    let discriminant = |unknown: &Letter| {
        let [c, b, a] = coefficients(&cleared, *unknown).try_into().ok()?;
        Some(&(&b * &b) - &(&(&a * &c) * &Value::from(4)))
    };
    unknowns.iter().filter_map(discriminant).find(is_nowhere_positive)
}

/// Is it a negative number times squares, and times what is positive?
fn is_nowhere_positive(value: &Value) -> bool {
    let Some((polynomial, _)) = value.as_quotient() else { return false };
    let (number, factors) = polynomial.square_free();
    let is_positive =
        |factor: &Polynomial| Value::quotient(factor.clone(), Polynomial::one()).sign() == Some(Ordering::Greater);
    number.sign() == Ordering::Less && factors.iter().all(|(factor, power)| power % 2 == 0 || is_positive(factor))
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
    use super::super::equation::tests::unknown;
    use super::*;

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

    #[test]
    fn an_unknown_that_an_equation_has_alone_leaves_with_its_roots() {
        let ((x, a), (y, b)) = (unknown("x"), unknown("y"));
        let square = |value: &Value| value * value;
        let [four, nine] = [4, 9].map(Value::from);
        // x² = 4 and y² = 9
        let roots = solve_system(&[&square(&a) - &four, &square(&b) - &nine], &[x, y]).unwrap();
        assert_eq!(roots.len(), 4, "{roots:?}");
        // x y² = 0 and 3x + y² + x³ = 0
        let cubed = &square(&a) * &a;
        let second = &(&(&a * &Value::from(3)) + &square(&b)) + &cubed;
        let roots = solve_system(&[&a * &square(&b), second], &[x, y]).unwrap();
        assert!(roots.contains(&vec![Value::ZERO, Value::ZERO]), "{roots:?}");
    }

    #[test]
    fn a_product_that_vanishes_leaves_the_other_equation() {
        let ((x, a), (y, b)) = (unknown("x"), unknown("y"));
        let less = |value: &Value, by: i64| &(value * value) - &Value::from(by);
        // (x² - 1)(y² - 4) = 0 and x² + y² = 5
        let product = &less(&a, 1) * &less(&b, 4);
        let circle = &less(&a, 5) + &(&b * &b);
        let roots = solve_system(&[product, circle], &[x, y]).unwrap();
        assert!(roots.contains(&vec![Value::from(-1), Value::from(2)]) && roots.len() == 4, "{roots:?}");
    }

    #[test]
    fn squares_that_add_up_to_nought_are_nought() {
        let ((x, a), (y, b)) = (unknown("x"), unknown("y"));
        let [first, second] = [&a - &Value::ONE, &b - &Value::from(2)];
        let sum = &(&first * &first) + &(&second * &second);
        let besides = discriminant_of_squares(&sum, &[x, y]).unwrap();
        assert_eq!(solve_system(&[sum.clone(), besides], &[x, y]), Ok(vec![vec![Value::ONE, Value::from(2)]]));
        assert!(discriminant_of_squares(&(&sum - &Value::ONE), &[x, y]).is_none());
        assert!(discriminant_of_squares(&(&(&a * &a) - &(&b * &b)), &[x, y]).is_none());
    }
}
