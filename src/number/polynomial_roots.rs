//! The roots of a polynomial whose coefficients are exact values: linear, quadratic, or quadratic in the square, once
//! repeated, rational and simple surd roots have been taken out.

use super::equation::{MOST_TERMS, NoRoots};
use super::{Fraction, Root, Value};

/// The roots for coefficients of the powers 0, 1, 2, …
pub(super) fn roots_of_factor(mut coefficients: Vec<Value>) -> Result<Vec<Value>, NoRoots> {
    let mut roots = Vec::new();
    if coefficients.first().is_some_and(Value::is_zero) {
        roots.push(Value::ZERO);
        let first = coefficients.iter().position(|coefficient| !coefficient.is_zero()).unwrap_or(0);
        coefficients.drain(..first);
    }
    coefficients = without_sum_of_squares(coefficients);
    // Roots that are rational, or rational times a square root, leave one after the other.
    while coefficients.len() > 3 && !only_even(&coefficients) {
        if let Some((shared, rest)) = repeated(&coefficients) {
            roots.extend(roots_of_factor(shared)?);
            coefficients = rest;
            continue;
        }
        let Some(root) = simple_root(&coefficients) else { return Err(NoRoots::Degree(coefficients.len() - 1)) };
        coefficients = deflated(&coefficients, &root);
        roots.push(root);
    }
    match coefficients.as_slice() {
        [] | [_] => {}
        [constant, slope] => roots.extend((-constant).divided_by(slope)),
        [c, b, a] => roots.extend(quadratic(a, b, c)),
        [c, _, b, _, a] if only_even(&coefficients) => {
            for square in quadratic(a, b, c) {
                if let Some(root) = square.square_root() {
                    roots.push(-&root);
                    roots.push(root);
                }
            }
        }
        longer => return Err(NoRoots::Degree(longer.len() - 1)),
    }
    Ok(roots)
}

fn only_even(coefficients: &[Value]) -> bool {
    coefficients.iter().skip(1).step_by(2).all(Value::is_zero) && coefficients.len() <= 5
}

fn quadratic(a: &Value, b: &Value, c: &Value) -> Vec<Value> {
    let discriminant = &(b * b) - &(&Value::from(4) * &(a * c));
    let below = &Value::from(2) * a;
    let at = |root: &Value| (root - b).divided_by(&below);
    match discriminant.square_root() {
        None => Vec::new(),
        Some(root) if root.is_zero() => at(&root).into_iter().collect(),
        Some(root) => [at(&root), at(&-&root)].into_iter().flatten().collect(),
    }
}

/// Divided by `1 + x²` as often as it goes: what cosines leave behind, and never nought.
fn without_sum_of_squares(mut coefficients: Vec<Value>) -> Vec<Value> {
    let square = [Value::ONE, Value::ZERO, Value::ONE];
    while coefficients.len() > 3 {
        let Some((quotient, rest)) = divided(&coefficients, &square) else { break };
        if !rest.is_empty() {
            break;
        }
        coefficients = quotient;
    }
    coefficients
}

/// Quotient and remainder of two polynomials; `None` if the coefficients grow too long.
fn divided(dividend: &[Value], divisor: &[Value]) -> Option<(Vec<Value>, Vec<Value>)> {
    let lead = divisor.last()?;
    let mut rest = dividend.to_vec();
    let mut quotient = Vec::new();
    while rest.len() >= divisor.len() {
        let factor = rest.pop()?.divided_by(lead)?;
        let shift = rest.len() + 1 - divisor.len();
        for (entry, part) in rest[shift..].iter_mut().zip(divisor) {
            *entry = &*entry - &(&factor * part);
            if entry.terms() > MOST_TERMS / 10 {
                return None;
            }
        }
        quotient.push(factor);
    }
    quotient.reverse();
    while rest.last().is_some_and(Value::is_zero) {
        rest.pop();
    }
    Some((quotient, rest))
}

/// The factor that a polynomial shares with its rate of change, and what is left without it: roots that occur more than
/// once. Only of coefficients without letters; with letters and without surds the factors were found before.
fn repeated(coefficients: &[Value]) -> Option<(Vec<Value>, Vec<Value>)> {
    if !coefficients.iter().all(Value::is_constant) || coefficients.iter().all(|value| value.as_fraction().is_some()) {
        return None;
    }
    let slope = coefficients.iter().zip(0_i64..).skip(1).map(|(value, power)| value * &Value::from(power));
    let (mut first, mut second) = (coefficients.to_vec(), slope.collect::<Vec<_>>());
    while !second.is_empty() {
        let (_, rest) = divided(&first, &second)?;
        (first, second) = (second, rest);
    }
    if first.len() < 2 {
        return None;
    }
    let (rest, nothing) = divided(coefficients, &first)?;
    nothing.is_empty().then_some((first, rest))
}

/// A rational root, or a rational multiple of one of the square roots among the coefficients.
fn simple_root(coefficients: &[Value]) -> Option<Value> {
    if let Some(root) = rational_root(coefficients) {
        return Some(root);
    }
    let mut surds: Vec<Root> = coefficients.iter().flat_map(Value::roots).collect();
    surds.retain(|root| matches!(root, Root::Prime(_)));
    surds.sort();
    surds.dedup();
    let lead = coefficients.last()?;
    surds.iter().find_map(|surd| {
        let scale = surd.square().square_root()?;
        let mut power = Value::ONE;
        let mut scaled = Vec::new();
        for coefficient in coefficients {
            scaled.push((coefficient * &power).divided_by(lead)?);
            power = &power * &scale;
        }
        let last = scaled.last()?.clone();
        let monic: Option<Vec<Value>> = scaled.iter().map(|value| value.divided_by(&last)).collect();
        Some(&rational_root(&monic?)? * &scale)
    })
}

/// A root p/q of a polynomial with rational coefficients: p divides the first, q the last.
fn rational_root(coefficients: &[Value]) -> Option<Value> {
    let numbers: Option<Vec<Fraction>> = coefficients.iter().map(|value| value.as_fraction().cloned()).collect();
    let numbers = numbers?;
    let scale = numbers.iter().fold(Fraction::ONE, |scale, number| &scale * &Fraction::from(number.denominator()));
    let whole = |number: &Fraction| (number * &scale).as_small().map(|(n, _)| n.unsigned_abs());
    let (constant, lead) = (whole(numbers.first()?)?, whole(numbers.last()?)?);
    let divisors = |number: u64| (1..=number.min(2000)).filter(move |divisor| number.is_multiple_of(*divisor));
    for p in divisors(constant) {
        for q in divisors(lead) {
            for sign in [1, -1] {
                let candidate = Fraction::new(sign * i64::try_from(p).ok()?, i64::try_from(q).ok()?);
                let value = numbers.iter().rev().fold(Fraction::ZERO, |sum, number| &(&sum * &candidate) + number);
                if value.is_zero() {
                    return Some(candidate.into());
                }
            }
        }
    }
    None
}

/// The polynomial divided by `x - root`.
fn deflated(coefficients: &[Value], root: &Value) -> Vec<Value> {
    let mut carried = Value::ZERO;
    let mut quotient: Vec<Value> = coefficients
        .iter()
        .skip(1)
        .rev()
        .map(|coefficient| {
            carried = &(&carried * root) + coefficient;
            carried.clone()
        })
        .collect();
    quotient.reverse();
    quotient
}
