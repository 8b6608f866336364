//! Values that are squares of values: `151 - 28√3 = (7√3 - 2)²`, and a formula of unknown sign under the root of its
//! square.
//!
//! A square of `c + d r`, `r` a root, is `a + b r` with `a = c² + d² r²` and `b = 2 c d`. So `a² - b² r²` is the square
//! of `c² - d² r²`, and half of `a` plus or minus that is `c²`: a question about values without `r`.

use super::residue::is_no_square;
use super::value::{Root, Value};
use super::{Fraction, Polynomial};

/// In a longer value the squares on the way would grow too long.
const LONGEST: usize = 24;

/// Of which numbers times a value the root is looked for.
const SHARES: [i64; 8] = [1, 2, 3, 5, 6, 7, 10, 15];

/// Each root makes three questions of one.
const MOST_ROOTS: usize = 4;

impl Value {
    /// `f` where the value is written as `f²`, which the absolute value of a formula of unknown sign is.
    pub fn square_root_of_square(&self) -> Option<Value> {
        let roots = self.roots();
        if self.may_be_square(&roots) { within(self, &roots) } else { None }
    }

    fn may_be_square(&self, roots: &[Root]) -> bool {
        let plain = |root: &Root| !matches!(root, Root::Nested { .. });
        let can_be = roots.len() <= MOST_ROOTS && self.terms() <= LONGEST && roots.iter().all(plain);
        can_be && !is_no_square(self, roots)
    }

    /// The square root that is not negative of a value with roots in it, as a sum without a root inside another: of a square,
    /// and of one over a small number, as 2 + √3 is half of (1 + √3)².
    pub(super) fn root_of_surds(&self) -> Option<Value> {
        let roots = self.roots();
        // The small numbers are squares modulo the prime, so what is no square there is none times any of them.
        if roots.is_empty() || !self.may_be_square(&roots) {
            return None;
        }
        SHARES.into_iter().find_map(|share| {
            let share = Value::from(share);
            within(&(self * &share), &roots)?.absolute().divided_by(&share.square_root()?)
        })
    }
}

/// `f`, in no other roots than these.
fn within(value: &Value, roots: &[Root]) -> Option<Value> {
    let Some(root) = value.roots().pop() else { return without_roots(value, roots) };
    // Of the roots that may be in `c` and `d`, only those before this one: or there would be no end.
    let fewer: Vec<Root> = roots.iter().filter(|other| **other != root).cloned().collect();
    let (a, b) = value.split(&root);
    let gap = within(&(&(&a * &a) - &(&(&b * &b) * &root.square())), &fewer)?;
    let half = Value::fraction(1, 2);
    [&a + &gap, &a - &gap].iter().find_map(|double| {
        let c = within(&(double * &half), &fewer).filter(|c| !c.is_zero() && !c.is_laborious())?;
        let d = (&b * &half).divided_by(&c)?;
        Some(&c + &(&d * &Value::root(root.clone())))
    })
}

/// Of a quotient: half of each power. A number may be the square of one of the surds, and `1 + tan²` is that of a cosine
/// below.
fn without_roots(value: &Value, roots: &[Root]) -> Option<Value> {
    let (above, below) = value.as_quotient()?;
    let (above, below) = (half(&above, roots)?, half(&below, roots)?);
    above.divided_by(&below)
}

fn half(polynomial: &Polynomial, roots: &[Root]) -> Option<Value> {
    let (number, factors) = polynomial.square_free();
    let mut product = of_number(&number, roots)?;
    for (factor, power) in factors {
        product = &product * &Value::quotient(factor.power(power / 2), Polynomial::one());
        if power % 2 == 1 {
            let is_below = |root: &&Root| match root {
                Root::Cosine(tangent) => factor == Polynomial::one_plus_square(*tangent),
                _ => false,
            };
            let cosine = roots.iter().find(is_below)?;
            product = &product * &Value::root(cosine.clone()).reciprocal()?;
        }
    }
    Some(product)
}

/// The root of a number that is a square, or the square of one of the surds times one.
fn of_number(number: &Fraction, roots: &[Root]) -> Option<Value> {
    if let Some(root) = number.square_root() {
        return Some(Value::Rational(root));
    }
    let root = Value::Rational(number.clone()).square_root()?;
    root.roots().iter().all(|root| roots.contains(root)).then_some(root)
}

#[cfg(test)]
mod tests {
    use super::super::{Letter, Range};
    use super::*;

    fn surd(number: i64) -> Value {
        Value::from(number).square_root().unwrap()
    }

    #[test]
    fn a_square_is_known_by_its_surds_cosines_and_letters() {
        let letter = |name, range| Value::letter(Letter::new(name, range).unwrap());
        let (u, x) = (letter("u", Range::Positive), letter("x", Range::Real));
        let alpha = Letter::new("alpha", Range::Acute).unwrap();
        let (sine, cosine) = (Value::sine(alpha), Value::cosine(alpha));
        for f in [
            &(&surd(3) * &Value::from(7)) - &Value::from(2),
            &(&surd(2) + &surd(3)) + &Value::ONE,
            &(&surd(2) + &surd(3)) + &surd(5),
            &(&surd(3) * &x) - &Value::from(4),
            &(&(&surd(3) * &x) + &(&surd(2) * &u)) - &Value::ONE,
            &(&u * &cosine) - &x,
            &(&surd(2) * &sine) + &x,
            (&(&surd(3) * &x) - &u).divided_by(&(&x + &Value::from(6))).unwrap(),
        ] {
            let square = &f * &f;
            let root = square.square_root_of_square().unwrap_or_else(|| panic!("{square:?}"));
            assert_eq!(&root * &root, square);
            assert!(root == f || root == -&f, "{root:?} is not {f:?}");
        }
    }

    #[test]
    fn what_is_no_square_has_no_such_root() {
        let x = Value::letter(Letter::new("x", Range::Real).unwrap());
        for value in [&Value::ONE + &surd(3), &Value::from(2) + &surd(3), &surd(2) * &x, &(&surd(3) * &x) + &Value::ONE]
        {
            assert_eq!(value.square_root_of_square(), None, "{value:?}");
        }
    }

    #[test]
    fn a_root_with_surds_inside_is_a_sum_if_it_can_be() {
        let u = Value::letter(Letter::new("u", Range::Positive).unwrap());
        let sum = |numbers: &[(i64, i64)]| {
            let one = |(number, root): &(i64, i64)| &Value::from(*number) * &surd(*root);
            numbers.iter().map(one).reduce(|sum, term| &sum + &term).unwrap()
        };
        for root in [
            sum(&[(1, 2), (1, 6)]),
            sum(&[(3, 6), (3, 10)]),
            sum(&[(6, 6), (2, 14)]),
            sum(&[(15, 10), (-9, 6)]),
            sum(&[(3, 2), (3, 6), (2, 10), (2, 30)]),
        ] {
            assert_eq!((&root * &root).square_root(), Some(root.clone()));
            let lettered = &root * &u;
            assert_eq!((&lettered * &lettered).square_root(), Some(lettered));
        }
    }

    #[test]
    fn a_root_of_a_square_is_not_written_as_one_root_in_another() {
        let tangent = Value::letter(Letter::new("51", Range::Degrees).unwrap());
        let square = &Value::from(151) - &(&surd(3) * &Value::from(28));
        let root = (&square * &(&tangent * &tangent)).square_root().unwrap();
        assert_eq!(root, &(&(&surd(3) * &Value::from(7)) - &Value::from(2)) * &tangent);
    }
}
