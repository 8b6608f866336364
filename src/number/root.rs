//! Square roots of exact values, as simple as they come: squares taken out, nested roots undone.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::VecDeque;
use std::sync::LazyLock;

use dashu_int::ops::{BitTest, SquareRoot};
use dashu_int::{IBig, UBig};

use super::polynomial::Polynomial;
use super::terms::{Roots, Terms};
use super::value::{Root, Value, integer};
use super::{Fraction, Range, steps};

/// Primes up to this are looked for in a radicand. What is left of a larger number is taken for a
/// prime unless it is a square: an exam never gets there, and a value stays right all the same.
const LARGEST_TRIAL: usize = 100_000;

/// Every prime up to [`LARGEST_TRIAL`].
static PRIMES: LazyLock<Vec<u64>> = LazyLock::new(|| {
    let mut crossed_out = vec![false; LARGEST_TRIAL + 1];
    let mut primes = Vec::new();
    for number in 2..=LARGEST_TRIAL {
        if !crossed_out[number] {
            primes.push(number as u64);
            (number * number..=LARGEST_TRIAL).step_by(number).for_each(|multiple| crossed_out[multiple] = true);
        }
    }
    primes
});

impl Value {
    /// The square root that is not negative; `None` if the value is known to be negative.
    ///
    /// Where the sign of the value depends on its letters, the root stands for itself: its letters
    /// are then restricted to values for which it exists.
    pub fn square_root(&self) -> Option<Value> {
        if let Value::Rational(number) = self {
            return root_of_fraction(number);
        }
        if self.sign() == Some(Ordering::Less) {
            return None;
        }
        if self.is_zero() {
            return Some(Value::ZERO);
        }
        if let Some(root) = self.undo_nesting() {
            return Some(root);
        }
        let (terms, denominator) = self.parts();
        // √(f N / q) = √(f q) √N / q, where f is what all the coefficients share and N the rest.
        let shared = terms.coefficients().fold(Polynomial::zero(), |shared, p| shared.greatest_common_divisor(p));
        let content = terms.coefficients().map(Polynomial::content).reduce(|a, b| a.common_measure(&b))?;
        let scale = content.reciprocal()?;
        let divided = |coefficient: &Polynomial| Some(coefficient.divided_by(&shared)?.scaled(&scale));
        let rest = terms.iter().map(|(roots, coefficient)| Some((roots.clone(), divided(coefficient)?)));
        let mut rest: Terms = rest.collect::<Option<_>>()?;
        let mut sign = Fraction::ONE;
        if let (1, Some(unit)) = (rest.len(), rest.get(&[])) {
            // The rest is plus or minus one; the polynomial takes it in.
            sign = unit.as_constant()?;
            rest = Terms::default();
        }
        let (outside, inside) = squares_out((&shared * &*denominator).scaled(&content).scaled(&sign));
        let inside = if rest.is_empty() { inside } else { &inside * &Value::build(rest, Polynomial::one()) };
        let root = match inside.as_fraction() {
            Some(number) => root_of_fraction(number)?,
            None => inside.root_of_surds().unwrap_or_else(|| Value::nested(inside)),
        };
        (&outside * &root).divided_by(&Value::quotient(denominator.into_owned(), Polynomial::one()).absolute())
    }

    /// The size without the sign. Where the sign depends on letters it is the root of the square.
    pub fn absolute(&self) -> Value {
        match self.sign() {
            Some(Ordering::Less) => -self,
            Some(_) => self.clone(),
            None => self.absolute_by_factors().unwrap_or_else(|| Value::nested(self * self)),
        }
    }

    /// For a single product: roots are positive, and so is each factor of known sign; only the product of
    /// the factors of unknown sign needs the root of its square.
    fn absolute_by_factors(&self) -> Option<Value> {
        let (terms, denominator) = self.parts();
        let [(roots, polynomial)] = terms.iter().collect::<Vec<_>>().try_into().ok()?;
        let whole = |p: &Polynomial| Value::quotient(p.clone(), Polynomial::one());
        let mut known = roots.iter().fold(Value::ONE, |product, root| &product * &Value::root(root.clone()));
        let mut unknown = Value::ONE;
        for (part, below) in [(polynomial, false), (&denominator, true)] {
            let (number, factors) = part.square_free();
            let mut place = |factor: &Value, known: &mut Value| -> Option<()> {
                let factor = if below { factor.reciprocal()? } else { factor.clone() };
                match factor.sign() {
                    Some(Ordering::Less) => *known = -(&*known * &factor),
                    Some(_) => *known = &*known * &factor,
                    None => unknown = &unknown * &factor,
                }
                Some(())
            };
            place(&Value::Rational(number), &mut known)?;
            for (factor, power) in factors {
                let even = whole(&factor.power(power - power % 2));
                known = if below { known.divided_by(&even)? } else { &known * &even };
                if power % 2 == 1 {
                    place(&whole(&factor), &mut known)?;
                }
            }
        }
        Some(&known * &Value::nested(&unknown * &unknown))
    }

    /// √(a + b√d) = √((a+s)/2) ± √((a-s)/2) where s² = a² - b²d is the square of a fraction.
    fn undo_nesting(&self) -> Option<Value> {
        let (terms, denominator) = self.parts();
        if terms.len() != 2 || denominator.as_constant().is_none() {
            return None;
        }
        let a = terms.get(&[])?.as_constant()?;
        let (key, coefficient) = terms.iter().find(|(key, _)| !key.is_empty())?;
        let mut square = coefficient.as_constant()?;
        let negative = square.sign().is_lt();
        square = &square * &square;
        for root in key {
            let Root::Prime(prime) = root else { return None };
            square = &square * &integer(*prime);
        }
        let s = (&(&a * &a) - &square).square_root()?;
        let half = Fraction::new(1, 2);
        let large = root_of_fraction(&(&(&a + &s) * &half))?;
        let small = root_of_fraction(&(&(&a - &s) * &half))?;
        Some(if negative { &large - &small } else { &large + &small })
    }
}

/// The whole square root of a square, `None` for any other integer.
pub(super) fn exact_root(value: &IBig) -> Option<IBig> {
    let magnitude = UBig::try_from(value.clone()).ok()?;
    let root = magnitude.sqrt();
    (&root * &root == magnitude).then(|| root.into())
}

/// √(n/d) = (s/d) √r where n d = s² r.
fn root_of_fraction(number: &Fraction) -> Option<Value> {
    if number.is_zero() {
        return Some(Value::ZERO);
    }
    if number.sign().is_lt() {
        return None;
    }
    let (mut outside, mut inside) = (Fraction::ONE, Fraction::ONE);
    let mut roots = Roots::new();
    let mut take = |square: IBig, primes: Vec<u128>, rest: Option<IBig>, below: bool| {
        let factor = Fraction::from(square);
        outside = if below { &outside / &factor } else { &outside * &factor };
        for prime in primes {
            roots.push(Root::Prime(prime));
            if below {
                outside = &outside / &integer(prime);
            }
        }
        if let Some(rest) = rest {
            let rest = Fraction::from(rest);
            inside = &inside * &rest;
            if below {
                outside = &outside / &rest;
            }
        }
    };
    let (square, primes, rest) = square_part(number.numerator());
    take(square, primes, rest, false);
    let (square, primes, rest) = square_part(number.denominator());
    take(square, primes, rest, true);
    roots.sort();
    let value = Value::surd(outside, roots);
    // Too long for a machine integer: kept whole, as a root of its own.
    Some(if inside.is_one() { value } else { &value * &Value::nested(Value::Rational(inside)) })
}

/// `s`, distinct primes and what is too large to be one of them, in `number = s² * primes * rest`.
type SquarePart = (IBig, Vec<u128>, Option<IBig>);

/// Shorter numbers, in bits, are taken apart quicker than they are looked up.
const SHORT: usize = 24;

/// How many numbers are remembered.
const REMEMBERED: usize = 16;

thread_local! {
    /// The numbers taken apart last: what stands in an answer is worked out again for everything that it may be.
    static LAST: RefCell<VecDeque<(IBig, SquarePart)>> = RefCell::default();
}

fn square_part(number: IBig) -> SquarePart {
    if number.bit_len() <= SHORT {
        return taken_apart(number);
    }
    LAST.with_borrow_mut(|last| {
        if let Some((_, part)) = last.iter().find(|(known, _)| *known == number) {
            return part.clone();
        }
        let part = taken_apart(number.clone());
        last.truncate(REMEMBERED - 1);
        last.push_front((number, part.clone()));
        part
    })
}

fn taken_apart(number: IBig) -> SquarePart {
    let (mut rest, mut square, mut primes) = (number, IBig::ONE, Vec::new());
    // Machine integers where they suffice: there are many divisions.
    let mut small = u64::try_from(&rest).ok();
    for prime in PRIMES.iter().copied() {
        if small.is_some_and(|small| prime * prime > small) {
            break;
        }
        steps::add(1);
        let mut power = 0;
        while small.map_or_else(|| (&rest % prime) == 0, |small| small % prime == 0) {
            rest /= prime;
            small = u64::try_from(&rest).ok();
            power += 1;
        }
        if power > 1 {
            square *= IBig::from(prime).pow(power / 2);
        }
        if power % 2 == 1 {
            primes.push(prime.into());
        }
    }
    if let Some(root) = exact_root(&rest) {
        return (square * root, primes, None);
    }
    match u128::try_from(&rest) {
        Ok(last) => primes.push(last),
        Err(_) => return (square, primes, Some(rest)),
    }
    assert!(rest.bit_len() <= 128);
    (square, primes, None)
}

/// `outside² * inside = polynomial`, with what is inside free of squares and `outside` not negative.
fn squares_out(polynomial: Polynomial) -> (Value, Value) {
    let (number, factors) = polynomial.square_free();
    let whole = |p: &Polynomial| Value::quotient(p.clone(), Polynomial::one());
    let (mut outside, mut inside) = (Value::ONE, Polynomial::one());
    for (factor, power) in factors {
        outside = &outside * &whole(&factor.power(power / 2)).absolute();
        if power % 2 == 0 {
            continue;
        }
        // 1 + tan² is one over the square of the cosine.
        let cosine = factor.letters().into_iter().find(|letter| {
            matches!(letter.range(), Range::Acute | Range::Degrees) && factor == Polynomial::one_plus_square(*letter)
        });
        match cosine {
            Some(tangent) => {
                let secant = Value::cosine(tangent).reciprocal().expect("the cosine of an acute angle is not nought");
                outside = &outside * &secant;
            }
            None => inside = &inside * &factor,
        }
    }
    let sign = if number.sign().is_lt() { Fraction::from(-1) } else { Fraction::ONE };
    let root = root_of_fraction(&number.abs()).expect("an absolute value has a root");
    // Under a root that stays, surds go back inside: √3 √(2 + x) is written √(6 + 3x).
    if inside.is_one() && sign.is_one() {
        return (&outside * &root, Value::ONE);
    }
    let (factor, surd) = split_surd(&root);
    (&outside * &Value::Rational(factor), whole(&inside.scaled(&(&surd * &sign))))
}

/// The rational factor of a single surd, and the square of the rest.
fn split_surd(root: &Value) -> (Fraction, Fraction) {
    let (terms, _) = root.parts();
    let (key, coefficient) = terms.iter().next().expect("a root of a positive number has one term");
    let number = coefficient.as_constant().unwrap_or(Fraction::ONE);
    let square = key.iter().fold(Fraction::ONE, |product, root| match root.square().as_fraction() {
        Some(square) => &product * square,
        None => product,
    });
    (number, square)
}
