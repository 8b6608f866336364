//! The roots of a polynomial whose coefficients are exact values: linear, quadratic, or quadratic in the square, once
//! repeated, rational and simple surd roots have been taken out.

use super::equation::{MOST_TERMS, NoRoots};
use super::{Fraction, Interval, Root, Value};

/// Enough for what is left of coefficients of exam questions after Euclid has taken most of them away.
const PROOF_BITS: usize = 512;

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
        if let Some(factors) = square_free(&coefficients) {
            let found: Result<Vec<_>, _> = factors.into_iter().map(roots_of_factor).collect();
            roots.extend(found?.concat());
            return Ok(roots);
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

/// The factors that a polynomial has once, twice, three times and so on, if it has any more than once. Only of coefficients
/// without letters; with letters and without surds the factors were found before.
fn square_free(coefficients: &[Value]) -> Option<Vec<Vec<Value>>> {
    if !coefficients.iter().all(Value::is_constant) || coefficients.iter().all(|value| value.as_fraction().is_some()) {
        return None;
    }
    let slope = derivative(coefficients);
    let shared = common_divisor(coefficients.to_vec(), slope.clone())?;
    if shared.len() < 2 {
        return None;
    }
    // Yun's way: in each round what is left of the polynomial and of its derivative loses the factors of one more power.
    let (mut left, mut next) = (exactly_divided(coefficients, &shared)?, exactly_divided(&slope, &shared)?);
    let mut factors = Vec::new();
    while left.len() > 1 {
        let rest = difference(&next, &derivative(&left));
        let factor = common_divisor(left.clone(), rest.clone())?;
        (left, next) = (exactly_divided(&left, &factor)?, exactly_divided(&rest, &factor)?);
        if factor.len() > 1 {
            factors.push(factor);
        }
    }
    Some(factors)
}

/// Factors with surds that have nothing in common, in place of such as may: what two of them share is a factor by itself, and
/// shorter than both.
pub(super) fn coprime(factors: Vec<Vec<Value>>) -> Vec<Vec<Value>> {
    let has_surds = factors.iter().flatten().any(|value| value.as_fraction().is_none());
    if factors.len() < 2 || !has_surds || !factors.iter().flatten().all(Value::is_constant) {
        return factors;
    }
    let mut open: Vec<Vec<Value>> =
        factors.into_iter().flat_map(|factor| square_free(&factor).unwrap_or_else(|| vec![factor])).collect();
    let mut found: Vec<Vec<Value>> = Vec::new();
    while let Some(factor) = open.pop() {
        let split = found.iter().enumerate().find_map(|(place, other)| {
            let shared = common_divisor(factor.clone(), other.clone()).filter(|shared| shared.len() > 1)?;
            let rests = [exactly_divided(&factor, &shared)?, exactly_divided(other, &shared)?];
            Some((place, shared, rests))
        });
        match split {
            Some((place, shared, rests)) => {
                found.swap_remove(place);
                open.extend(rests.into_iter().filter(|rest| rest.len() > 1).chain([shared]));
            }
            None => found.push(factor),
        }
    }
    found
}

fn derivative(coefficients: &[Value]) -> Vec<Value> {
    coefficients.iter().zip(0_i64..).skip(1).map(|(value, power)| value * &Value::from(power)).collect()
}

fn difference(one: &[Value], other: &[Value]) -> Vec<Value> {
    let at = |all: &[Value], place: usize| all.get(place).cloned().unwrap_or(Value::ZERO);
    let mut all: Vec<Value> =
        (0..one.len().max(other.len())).map(|place| &at(one, place) - &at(other, place)).collect();
    while all.last().is_some_and(Value::is_zero) {
        all.pop();
    }
    all
}

fn exactly_divided(dividend: &[Value], divisor: &[Value]) -> Option<Vec<Value>> {
    divided(dividend, divisor).filter(|(_, rest)| rest.is_empty()).map(|(quotient, _)| quotient)
}

/// By Euclid, with one for its highest coefficient.
fn common_divisor(mut first: Vec<Value>, mut second: Vec<Value>) -> Option<Vec<Value>> {
    if are_coprime(&first, &second) == Some(true) {
        return Some(vec![Value::ONE]);
    }
    while !second.is_empty() {
        let (_, rest) = divided(&first, &second)?;
        (first, second) = (second, rest);
    }
    let lead = first.last()?.clone();
    first.iter().map(|coefficient| coefficient.divided_by(&lead)).collect()
}

/// Have two polynomials nothing in common? Euclid's way in intervals, which proves that at once for nearly all that have not;
/// exact coefficients with sines of given degrees grow longer with each step. None where intervals do not tell.
fn are_coprime(first: &[Value], second: &[Value]) -> Option<bool> {
    let enclosed =
        |all: &[Value]| all.iter().map(|value| value.enclose_constant(PROOF_BITS)).collect::<Option<Vec<Interval>>>();
    let (mut first, mut second) = (enclosed(first)?, enclosed(second)?);
    loop {
        let lead = second.last().filter(|lead| !lead.contains_zero())?;
        if second.len() == 1 {
            return Some(true);
        }
        while first.len() >= second.len() {
            let factor = first.pop()?.checked_div(lead)?;
            let shift = first.len() + 1 - second.len();
            for (entry, part) in first[shift..].iter_mut().zip(&second) {
                *entry = entry.clone() - factor.clone() * part.clone();
            }
        }
        std::mem::swap(&mut first, &mut second);
    }
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

#[cfg(test)]
mod tests {
    use super::super::Direction;
    use super::super::equation::tests::unknown;
    use super::super::solve_system;
    use super::*;

    #[test]
    fn a_factor_with_surds_that_is_there_twice_leaves_the_rest_to_be_solved() {
        let (x, value) = unknown("x");
        let root = |number: i64| Value::from(number).square_root().unwrap();
        // (x − 2/√3 + √2)⁴ (x − √2)² (x² − √2 x − 1)
        let line = &(&value - &Value::from(2).divided_by(&root(3)).unwrap()) + &root(2);
        let square = &(&(&value * &value) - &(&root(2) * &value)) - &Value::ONE;
        let roots =
            solve_system(&[&line.power(4).unwrap() * &(&(&value - &root(2)).power(2).unwrap() * &square)], &[x])
                .unwrap();
        assert_eq!(roots.len(), 4, "{roots:?}");
        let double = &Value::from(2).divided_by(&root(3)).unwrap() - &root(2);
        assert!(roots.iter().any(|found| found[0].equals(&double)));
    }

    #[test]
    fn intervals_prove_that_polynomials_have_nothing_in_common_and_never_that_they_have() {
        let tangent = |degrees: &str| {
            let direction = Direction::degrees(&degrees.parse().unwrap()).unwrap();
            direction.sin.divided_by(&direction.cos).unwrap()
        };
        let root = Value::from(2).square_root().unwrap();
        let times = |roots: &[&Value]| {
            roots.iter().fold(vec![Value::ONE], |product, root| {
                let shifted = std::iter::once(Value::ZERO).chain(product.iter().cloned());
                let taken = product.iter().map(|entry| -(entry * root)).chain([Value::ZERO]);
                shifted.zip(taken).map(|(one, other)| &one + &other).collect()
            })
        };
        let (a, b, c) = (tangent("141"), tangent("40"), tangent("17"));
        for (one, other, said) in [
            (times(&[&a, &b, &c]), times(&[&root, &Value::ONE]), Some(true)),
            (times(&[&a, &b, &c, &root]), times(&[&tangent("40.0000001")]), Some(true)),
            (times(&[&a, &b, &root]), times(&[&c, &b]), None),
            (times(&[&a, &a]), times(&[&a]), None),
            (times(&[&a]), Vec::new(), None),
        ] {
            assert_eq!(are_coprime(&one, &other), said, "{one:?} and {other:?}");
        }
    }
}
