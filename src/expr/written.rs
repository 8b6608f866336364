//! Exact values as a careful teacher writes them.
//!
//! Inside a [`Value`] an angle stands as its tangent and cosine; here sines come back. A product is
//! written number, roots, letters, sines and cosines, bracket; a sum begins with a positive term.

use std::collections::BTreeMap;

use super::{Expr, Function};
use crate::number::{Angle, Fraction, Letter, Polynomial, Range, Root, Value};

/// The simplest form of a value, as a teacher writes it.
///
/// ```
/// use carom::expr::{print, written};
/// use carom::number::Value;
/// let speed = Value::fraction(208, 27).square_root().unwrap();
/// assert_eq!(print::plain(&written(&speed)), "4*sqrt(39)/9");
/// ```
pub fn written(value: &Value) -> Expr {
    if let Some(number) = value.as_fraction() {
        return number_expr(number);
    }
    let (terms, below) = collect(value);
    let shared = Shared::of(&terms);
    let rest: Vec<Term> = terms.iter().map(|term| shared.taken_from(term)).collect();
    let constant_sum = rest.len() > 1 && rest.iter().all(|term| term.letters.is_empty() && term.circular.is_empty());
    let (rest, scale) = if constant_sum { (rest, Fraction::ONE) } else { whole(rest) };
    let mut scale = scale;
    let bracket = if let [single] = rest.as_slice() {
        scale = &scale * &single.number;
        None
    } else {
        Some(ordered_sum(&rest))
    };
    // A denominator known to be negative, such as e - 1, is turned round.
    let below_value = Value::quotient(below.clone(), Polynomial::one());
    let turned = below_value.sign().is_some_and(|sign| sign.is_lt());
    let below = if turned { -&below } else { below };
    let negative = scale.sign().is_lt() != turned;
    let scale = scale.abs();
    let mut factors = vec![Expr::Number(scale.numerator().into())];
    // The bracket stands before sines and cosines, so that it is not taken for part of the angle.
    match rest.as_slice() {
        [single] => factors.extend(single.symbols()),
        _ => {
            let (before, circular) = shared.factors();
            factors.extend(before);
            factors.extend(bracket);
            factors.extend(circular);
        }
    }
    let denominator = Expr::product([Expr::Number(scale.denominator().into()), below_expr(&below)]);
    let size = Expr::product(factors).over(denominator);
    if negative { size.negated() } else { size }
}

/// An angle: so many degrees, a letter, or an inverse tangent with what must be added to it.
pub fn written_angle(angle: &Angle) -> Expr {
    if let Some(degrees) = angle.whole_degrees() {
        return Expr::degrees(number_expr(&degrees));
    }
    let (y, x) = (angle.y(), angle.x());
    let negative = y.sign().is_some_and(|sign| sign.is_lt());
    match x.sign() {
        Some(sign) if sign.is_gt() => {
            let size = arctangent(&if negative { -y } else { y.clone() }, x);
            if negative { size.negated() } else { size }
        }
        Some(sign) if sign.is_lt() && y.sign().is_some() => {
            let size = arctangent(&y.absolute(), &-x);
            let straight = Expr::degrees(Expr::integer(180));
            if negative { Expr::Sum(vec![size, straight.negated()]) } else { Expr::Sum(vec![straight, size.negated()]) }
        }
        _ => by_half_angle(y, x),
    }
}

/// The number of degrees of an angle, for the exchange formats: `46`, `atan(7)/deg`, `theta/deg`.
pub fn in_degrees(angle: &Expr) -> Expr {
    match angle {
        Expr::Degrees(inner) => (**inner).clone(),
        Expr::Negative(inner) => in_degrees(inner).negated(),
        Expr::Sum(terms) => Expr::Sum(terms.iter().map(in_degrees).collect()),
        other => other.clone().over(Expr::degrees(Expr::integer(1))),
    }
}

/// The inverse tangent of `y/x`, x positive.
fn arctangent(y: &Value, x: &Value) -> Expr {
    if !x.equals(&Value::ONE) {
        return Expr::call(Function::Atan, written(y).over(written(x)));
    }
    let tangent = y;
    let letter = |value: &Value| match value.as_quotient() {
        Some((above, below)) if below.is_one() => above
            .letters()
            .first()
            .copied()
            .filter(|letter| letter.range() == Range::Acute && above == Polynomial::letter(*letter)),
        _ => None,
    };
    if let Some(letter) = letter(tangent) {
        return Expr::name(letter.name());
    }
    if let Some(letter) = tangent.reciprocal().as_ref().and_then(letter) {
        return Expr::Sum(vec![Expr::degrees(Expr::integer(90)), Expr::name(letter.name()).negated()]);
    }
    Expr::call(Function::Atan, written(tangent))
}

/// The angle of `(x, y)` where the sign of `x` depends on letters: it needs no case distinction.
fn by_half_angle(y: &Value, x: &Value) -> Expr {
    let size = (&(x * x) + &(y * y)).square_root();
    let size = size.expect("a sum of squares has a root");
    if y.sign().is_some_and(|sign| sign.is_ge()) {
        return Expr::call(Function::Acos, ratio(x, &size));
    }
    Expr::product([Expr::integer(2), Expr::call(Function::Atan, ratio(y, &(&size + x)))])
}

/// A quotient in its simplest form, or where that would be laborious just as a quotient.
pub fn ratio(above: &Value, below: &Value) -> Expr {
    if below.is_laborious() || below.roots().iter().any(|root| matches!(root, Root::Nested { .. })) {
        return written(above).over(written(below));
    }
    match above.divided_by(below) {
        Some(value) => written(&value),
        None => written(above).over(written(below)),
    }
}

fn number_expr(number: &Fraction) -> Expr {
    let size = Expr::Number(number.abs());
    if number.sign().is_lt() { size.negated() } else { size }
}

/// A term of a numerator, with sines and cosines in place of tangents.
#[derive(Clone)]
struct Term {
    number: Fraction,
    /// The product of the primes under one square root.
    surd: u128,
    nested: Vec<Value>,
    letters: BTreeMap<Letter, u32>,
    circular: BTreeMap<(Letter, Circular), u32>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Circular {
    Sin,
    Cos,
    Tan,
}

fn is_angle(letter: &Letter) -> bool {
    matches!(letter.range(), Range::Acute | Range::Degrees)
}

/// The terms of the numerator, and the denominator.
fn collect(value: &Value) -> (Vec<Term>, Polynomial) {
    let mut below = value.denominator();
    let angles: Vec<Letter> = value.letters().into_iter().filter(is_angle).collect();
    // Each factor 1 + tan² below is a cos² above.
    let mut squares: BTreeMap<Letter, u32> = BTreeMap::new();
    for angle in angles {
        let secant = Polynomial::one_plus_square(angle);
        let mut count = 0;
        while below.degree(angle) > 1
            && let Some(rest) = below.divided_by(&secant)
        {
            below = rest;
            count += 2;
        }
        squares.insert(angle, count);
    }
    let mut terms = Vec::new();
    for (roots, coefficient) in value.numerator_terms() {
        for (monomial, number) in coefficient.terms() {
            let mut cosines = squares.clone();
            let (mut surd, mut nested) = (1, Vec::new());
            for root in &roots {
                match root {
                    Root::Prime(prime) => surd *= prime,
                    Root::Cosine(angle) => *cosines.entry(*angle).or_insert(0) += 1,
                    Root::Nested { radicand, .. } => nested.push(radicand.clone()),
                }
            }
            // cos θ √X is written √(X cos² θ), where the cosine goes into every term of X.
            for radicand in &mut nested {
                for (angle, count) in &mut cosines {
                    if *count > 0
                        && monomial.iter().all(|(letter, _)| letter != angle)
                        && radicand.letters().contains(angle)
                    {
                        let cosine = Value::cosine(*angle);
                        *radicand = &*radicand * &(&cosine * &cosine);
                        *count -= 1;
                    }
                }
            }
            let mut term =
                Term { number: number.clone(), surd, nested, letters: BTreeMap::new(), circular: BTreeMap::new() };
            for (letter, power) in monomial {
                if is_angle(letter) {
                    let available = cosines.get(letter).copied().unwrap_or(0);
                    let sines = available.min(*power);
                    put(&mut term.circular, (*letter, Circular::Sin), sines);
                    put(&mut term.circular, (*letter, Circular::Tan), power - sines);
                    cosines.insert(*letter, available - sines);
                } else {
                    term.letters.insert(*letter, *power);
                }
            }
            for (angle, count) in cosines {
                put(&mut term.circular, (angle, Circular::Cos), count);
            }
            terms.push(term);
        }
    }
    (terms, below)
}

fn put<K: Ord>(map: &mut BTreeMap<K, u32>, key: K, power: u32) {
    if power > 0 {
        map.insert(key, power);
    }
}

impl Term {
    /// Everything but the number.
    fn symbols(&self) -> Vec<Expr> {
        let mut symbols = Vec::new();
        if self.surd > 1 {
            symbols.push(Expr::call(Function::Sqrt, Expr::Number(Fraction::from(dashu_int::IBig::from(self.surd)))));
        }
        symbols.extend(letter_factors(&self.letters));
        symbols.extend(self.nested.iter().map(root_expr));
        symbols.extend(circular_factors(&self.circular));
        symbols
    }

    /// The term with a positive number, as it stands in a sum.
    fn size(&self) -> Expr {
        let number = self.number.abs();
        let mut factors = vec![Expr::Number(number.numerator().into())];
        factors.extend(self.symbols());
        if factors.len() == 1 {
            return Expr::Number(number);
        }
        Expr::product(factors).over(Expr::Number(number.denominator().into()))
    }

    /// Constants first, then by degree: the order in which `1 - e` and `2 + 3u` are written.
    fn degree(&self) -> u32 {
        self.letters.values().sum::<u32>() + self.circular.values().sum::<u32>()
    }
}

fn root_expr(radicand: &Value) -> Expr {
    if let Some(inner) = radicand.square_root_of_square() {
        return Expr::call(Function::Abs, written(&inner));
    }
    Expr::call(Function::Sqrt, written(radicand))
}

/// Letters in the order in which they are spoken: masses, then e, then the rest.
fn letter_factors(letters: &BTreeMap<Letter, u32>) -> Vec<Expr> {
    let rank = |letter: &Letter| match letter.name().as_bytes() {
        [b'm', ..] => 0,
        b"e" => 1,
        _ => 2,
    };
    let mut sorted: Vec<(&Letter, &u32)> = letters.iter().collect();
    sorted.sort_by_key(|(letter, _)| rank(letter));
    sorted.into_iter().map(|(letter, power)| Expr::name(letter.name()).to_the(i64::from(*power))).collect()
}

fn circular_factors(circular: &BTreeMap<(Letter, Circular), u32>) -> Vec<Expr> {
    let factor = |((angle, circular), power): (&(Letter, Circular), &u32)| {
        let function = match circular {
            Circular::Sin => Function::Sin,
            Circular::Cos => Function::Cos,
            Circular::Tan => Function::Tan,
        };
        let argument = match angle.range() {
            Range::Degrees => Expr::degrees(Expr::Number(angle.name().parse().unwrap_or(Fraction::ZERO))),
            _ => Expr::name(angle.name()),
        };
        Expr::call(function, argument).to_the(i64::from(*power))
    };
    circular.iter().map(factor).collect()
}

/// What all terms share: it is written once, before the bracket.
struct Shared {
    surd: u128,
    letters: BTreeMap<Letter, u32>,
    circular: BTreeMap<(Letter, Circular), u32>,
    nested: Vec<Value>,
}

impl Shared {
    fn of(terms: &[Term]) -> Shared {
        let Some((first, others)) = terms.split_first().filter(|(_, others)| !others.is_empty()) else {
            return Shared { surd: 1, letters: BTreeMap::new(), circular: BTreeMap::new(), nested: Vec::new() };
        };
        let mut shared = Shared {
            surd: first.surd,
            letters: first.letters.clone(),
            circular: first.circular.clone(),
            nested: first.nested.clone(),
        };
        for term in others {
            shared.surd = common(shared.surd, term.surd);
            lessen(&mut shared.letters, &term.letters);
            lessen(&mut shared.circular, &term.circular);
            shared.nested.retain(|radicand| term.nested.contains(radicand));
        }
        shared
    }

    fn taken_from(&self, term: &Term) -> Term {
        let mut rest = term.clone();
        rest.surd /= self.surd;
        reduce(&mut rest.letters, &self.letters);
        reduce(&mut rest.circular, &self.circular);
        rest.nested.retain(|radicand| !self.nested.contains(radicand));
        rest
    }

    /// What stands before a bracket, and what stands behind it.
    fn factors(&self) -> (Vec<Expr>, Vec<Expr>) {
        let plain = Term {
            number: Fraction::ONE,
            surd: self.surd,
            nested: self.nested.clone(),
            letters: self.letters.clone(),
            circular: BTreeMap::new(),
        };
        (plain.symbols(), circular_factors(&self.circular))
    }
}

fn common(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

fn lessen<K: Ord>(shared: &mut BTreeMap<K, u32>, other: &BTreeMap<K, u32>) {
    shared.retain(|key, power| {
        *power = (*power).min(other.get(key).copied().unwrap_or(0));
        *power > 0
    });
}

fn reduce<K: Ord>(rest: &mut BTreeMap<K, u32>, shared: &BTreeMap<K, u32>) {
    rest.retain(|key, power| {
        *power -= shared.get(key).copied().unwrap_or(0);
        *power > 0
    });
}

/// Terms with coprime whole numbers, the first written one positive, and the number taken out.
fn whole(mut terms: Vec<Term>) -> (Vec<Term>, Fraction) {
    if terms.len() < 2 {
        return (terms, Fraction::ONE);
    }
    let mut content = terms.iter().fold(Fraction::ZERO, |content, term| gcd_of_fractions(&content, &term.number));
    if terms.iter().all(|term| term.number.sign().is_lt()) {
        content = -content;
    }
    for term in &mut terms {
        term.number = &term.number / &content;
    }
    (terms, content)
}

/// The largest fraction of which both are whole multiples.
fn gcd_of_fractions(a: &Fraction, b: &Fraction) -> Fraction {
    let (mut x, mut y) = (a.abs(), b.abs());
    while !y.is_zero() {
        let times = Fraction::from((&x / &y).floor());
        (x, y) = (y.clone(), &x - &(&times * &y));
    }
    x
}

/// The terms in the order of writing: a positive one first, then by degree.
fn ordered_sum(terms: &[Term]) -> Expr {
    let mut sorted: Vec<&Term> = terms.iter().collect();
    sorted.sort_by_key(|term| (term.degree(), term.surd));
    if let Some(position) = sorted.iter().position(|term| term.number.sign().is_gt()) {
        let first = sorted.remove(position);
        sorted.insert(0, first);
    }
    Expr::sum(sorted.into_iter().map(|term| {
        let size = term.size();
        if term.number.sign().is_lt() { size.negated() } else { size }
    }))
}

/// The denominator: its shared letters before a bracket.
fn below_expr(below: &Polynomial) -> Expr {
    match below.as_constant() {
        Some(number) => number_expr(&number),
        None => {
            let value = Value::quotient(below.clone(), Polynomial::one());
            written(&value)
        }
    }
}
