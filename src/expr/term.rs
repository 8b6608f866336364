//! The terms of a numerator as they are written: numbers, roots, letters, sines and cosines.

use std::collections::BTreeMap;

use super::circle::fewest;
use super::written::written;
use super::{Expr, Function};
use crate::number::{Fraction, Letter, Polynomial, Range, Root, Value};

/// A term of a numerator, with sines and cosines in place of tangents.
#[derive(Clone)]
pub(super) struct Term {
    pub(super) number: Fraction,
    /// The product of the primes under one square root: a whole number, of any length.
    pub(super) surd: Fraction,
    pub(super) nested: Vec<Value>,
    pub(super) letters: BTreeMap<Letter, u32>,
    pub(super) circular: BTreeMap<(Letter, Circular), u32>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Circular {
    Sin,
    Cos,
    Tan,
}

fn is_angle(letter: &Letter) -> bool {
    matches!(letter.range(), Range::Acute | Range::Degrees)
}

/// The terms of the numerator, and the denominator.
pub(super) fn collect(value: &Value) -> (Vec<Term>, Polynomial) {
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
    for (roots, coefficient) in value.numerator_terms().iter() {
        for (monomial, number) in coefficient.terms() {
            let mut cosines = squares.clone();
            let (mut surd, mut nested) = (Fraction::ONE, Vec::new());
            for root in roots {
                match root {
                    Root::Prime(prime) => surd = &surd * &Fraction::from(dashu_int::IBig::from(*prime)),
                    Root::Cosine(angle) => *cosines.entry(*angle).or_insert(0) += 1,
                    Root::Nested { radicand, .. } => nested.push(radicand.clone()),
                }
            }
            // cos θ √X is written √(X cos² θ), where the cosine goes into every term of X.
            for radicand in &mut nested {
                for (angle, count) in &mut cosines {
                    if *count > 0
                        && monomial.iter().all(|(letter, _)| letter != angle)
                        && radicand.has_letter(|letter| letter == angle)
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
    (fewest(terms), below)
}

fn put<K: Ord>(map: &mut BTreeMap<K, u32>, key: K, power: u32) {
    if power > 0 {
        map.insert(key, power);
    }
}

impl Term {
    /// Do the two differ by their numbers alone?
    pub(super) fn is_like(&self, other: &Term) -> bool {
        self.surd == other.surd
            && self.circular == other.circular
            && self.letters == other.letters
            && self.nested == other.nested
    }

    /// The term with another power of a sine or cosine.
    pub(super) fn raise(&mut self, base: (Letter, Circular), power: u32) {
        self.circular.remove(&base);
        put(&mut self.circular, base, power);
    }

    /// Everything but the number.
    pub(super) fn symbols(&self) -> Vec<Expr> {
        let mut symbols = Vec::new();
        if !self.surd.is_one() {
            symbols.push(Expr::call(Function::Sqrt, Expr::Number(self.surd.clone())));
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
pub(super) struct Shared {
    surd: Fraction,
    letters: BTreeMap<Letter, u32>,
    circular: BTreeMap<(Letter, Circular), u32>,
    nested: Vec<Value>,
}

impl Shared {
    /// Nothing is shared.
    pub(super) fn nothing() -> Shared {
        Shared { surd: Fraction::ONE, letters: BTreeMap::new(), circular: BTreeMap::new(), nested: Vec::new() }
    }

    pub(super) fn of(terms: &[Term]) -> Shared {
        let Some((first, others)) = terms.split_first().filter(|(_, others)| !others.is_empty()) else {
            return Shared::nothing();
        };
        let mut shared = Shared {
            surd: first.surd.clone(),
            letters: first.letters.clone(),
            circular: first.circular.clone(),
            nested: first.nested.clone(),
        };
        for term in others {
            shared.surd = shared.surd.common_measure(&term.surd);
            lessen(&mut shared.letters, &term.letters);
            lessen(&mut shared.circular, &term.circular);
            shared.nested.retain(|radicand| term.nested.contains(radicand));
        }
        shared
    }

    pub(super) fn taken_from(&self, term: &Term) -> Term {
        let mut rest = term.clone();
        rest.surd = &rest.surd / &self.surd;
        reduce(&mut rest.letters, &self.letters);
        reduce(&mut rest.circular, &self.circular);
        rest.nested.retain(|radicand| !self.nested.contains(radicand));
        rest
    }

    /// What stands before a bracket, and what stands behind it.
    pub(super) fn factors(&self) -> (Vec<Expr>, Vec<Expr>) {
        let plain = Term {
            number: Fraction::ONE,
            surd: self.surd.clone(),
            nested: self.nested.clone(),
            letters: self.letters.clone(),
            circular: BTreeMap::new(),
        };
        (plain.symbols(), circular_factors(&self.circular))
    }
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
pub(super) fn whole(mut terms: Vec<Term>) -> (Vec<Term>, Fraction) {
    if terms.len() < 2 {
        return (terms, Fraction::ONE);
    }
    let mut content = terms.iter().fold(Fraction::ZERO, |content, term| content.common_measure(&term.number));
    if terms.iter().all(|term| term.number.sign().is_lt()) {
        content = -content;
    }
    for term in &mut terms {
        term.number = &term.number / &content;
    }
    (terms, content)
}

/// The terms in the order of writing: a positive one first, then by degree.
pub(super) fn ordered_sum(terms: &[Term]) -> Expr {
    let mut sorted: Vec<&Term> = terms.iter().collect();
    sorted.sort_by(|one, other| (one.degree(), &one.surd).cmp(&(other.degree(), &other.surd)));
    if let Some(position) = sorted.iter().position(|term| term.number.sign().is_gt()) {
        let first = sorted.remove(position);
        sorted.insert(0, first);
    }
    Expr::sum(sorted.into_iter().map(|term| {
        let size = term.size();
        if term.number.sign().is_lt() { size.negated() } else { size }
    }))
}
