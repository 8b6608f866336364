//! Letters in machine integers: short polynomials, each monomial packed into one word, unreduced over one denominator.
//!
//! With `e = p/q`, masses and a line of centres in proportion to polynomials, and velocities that are sums of things,
//! such as cos α or √2, with polynomials as coefficients,
//!
//! ```text
//! along an axis   d = q (m_A + m_B)         d v_A = d u_A - (p+q) (u_A - u_B) m_B,   d v_B = d u_B + (p+q) (u_A - u_B) m_A
//! any line        d = q (m_A + m_B) l·l     d v_A = d u_A - (p+q) w m_B l,           d v_B = d u_B + (p+q) w m_A l,
//!                                           w = (u_A - u_B)·l
//! ```
//!
//! The things occur in velocities alone, in which all this is linear; so they are never multiplied by each other, and may
//! stand for letters. Common factors are looked for once, when values are made of what was found. What is accepted has been
//! solved once to see that nothing overflows.

use crate::method::batch::batch;
use crate::method::elements::{Coefficients, coefficients};
use crate::method::needs::geometry_of;
use crate::method::proportion::proportion;
use crate::method::{Found, Geometry, Impact, Method, Prepared, Promise, Role, Skip};
use crate::number::{Fraction, Letter, Monomial, Polynomial, Roots, Value};
use std::collections::BTreeMap;

use super::matrix::gcd;

/// Short polynomials in letters.
pub(in crate::method) struct Polynomials;

/// The most terms of a polynomial.
const TERMS: usize = 16;

/// The most letters and things: each has a byte of a word for its exponent.
const SYMBOLS: usize = 8;

/// The highest exponent that is accepted: a product of five is the longest that is formed.
const HIGHEST: u32 = 40;

/// A polynomial: exponents, a byte each, and coefficients. The order of terms is that in which they arose.
#[derive(Clone, Copy, Debug, Default)]
struct Packed {
    terms: [(u64, i64); TERMS],
    count: usize,
}

impl Packed {
    fn add_term(&mut self, monomial: u64, coefficient: i64) -> Option<()> {
        let known = self.terms[..self.count].iter().position(|(other, _)| *other == monomial);
        match known {
            Some(place) => {
                self.terms[place].1 = self.terms[place].1.checked_add(coefficient)?;
                if self.terms[place].1 == 0 {
                    self.count -= 1;
                    self.terms[place] = self.terms[self.count];
                }
            }
            None if coefficient != 0 => {
                *self.terms.get_mut(self.count)? = (monomial, coefficient);
                self.count += 1;
            }
            None => {}
        }
        Some(())
    }

    fn terms(&self) -> &[(u64, i64)] {
        &self.terms[..self.count]
    }

    fn times(&self, other: &Packed) -> Option<Packed> {
        let mut product = Packed::default();
        for (left, p) in self.terms() {
            for (right, q) in other.terms() {
                product.add_term(left + right, p.checked_mul(*q)?)?;
            }
        }
        Some(product)
    }

    fn plus(&self, other: &Packed, sign: i64) -> Option<Packed> {
        let mut sum = *self;
        for (monomial, coefficient) in other.terms() {
            sum.add_term(*monomial, coefficient.checked_mul(sign)?)?;
        }
        Some(sum)
    }
}

/// What a byte of a monomial counts.
#[derive(Clone, PartialEq)]
enum Symbol {
    Letter(Letter),
    /// A product of roots, taken as a whole.
    Thing(Roots),
}

/// The symbols of an impact, in the order in which they were met.
#[derive(Clone, Default)]
struct Symbols(Vec<Symbol>);

impl Symbols {
    fn place(&mut self, symbol: Symbol) -> Option<usize> {
        let known = self.0.iter().position(|other| *other == symbol);
        let place = known.unwrap_or(self.0.len());
        if known.is_none() {
            self.0.push(symbol);
        }
        (place < SYMBOLS).then_some(place)
    }

    fn monomial(&mut self, roots: &Roots, letters: &Monomial) -> Option<u64> {
        let mut packed = 0;
        if !roots.is_empty() {
            packed += 1 << (8 * self.place(Symbol::Thing(roots.clone()))?);
        }
        for (letter, exponent) in letters {
            let place = self.place(Symbol::Letter(*letter))?;
            packed +=
                u64::from(*exponent).checked_shl(8 * u32::try_from(place).ok()?).filter(|_| *exponent <= HIGHEST)?;
        }
        Some(packed)
    }

    /// Polynomials with whole coefficients in proportion to those given, and by what they were multiplied.
    fn packed<const COUNT: usize>(&mut self, parts: [Coefficients; COUNT]) -> Option<([Packed; COUNT], i64)> {
        let mut below = 1_i64;
        for (_, coefficient) in parts.iter().flatten() {
            let (_, denominator) = coefficient.as_small()?;
            below = below.checked_mul(denominator / gcd(below, denominator))?;
        }
        let mut all = [Packed::default(); COUNT];
        for (packed, parts) in all.iter_mut().zip(&parts) {
            for ((roots, letters), coefficient) in parts {
                let (above, denominator) = coefficient.as_small()?;
                packed.add_term(self.monomial(roots, letters)?, above.checked_mul(below / denominator)?)?;
            }
        }
        Some((all, below))
    }

    fn exponents(&self, monomial: u64) -> (Roots, Monomial) {
        let (mut roots, mut letters) = (Roots::new(), Monomial::new());
        for (place, symbol) in self.0.iter().enumerate() {
            let exponent = (monomial >> (8 * place) & 0xff) as u32;
            match symbol {
                Symbol::Letter(letter) if exponent > 0 => letters.push((*letter, exponent)),
                Symbol::Thing(thing) if exponent > 0 => roots.clone_from(thing),
                _ => {}
            }
        }
        letters.sort_unstable();
        (roots, letters)
    }

    /// The value of a quotient, in lowest terms.
    fn value(&self, above: &Packed, below: &Packed, and_below: i64) -> Value {
        let mut terms: BTreeMap<Roots, Vec<(Monomial, Fraction)>> = BTreeMap::new();
        for (monomial, coefficient) in above.terms() {
            let (roots, letters) = self.exponents(*monomial);
            terms.entry(roots).or_default().push((letters, Fraction::from(*coefficient)));
        }
        let polynomial = |(roots, terms)| (roots, Polynomial::from_terms(terms));
        let divisor = below.terms().iter().map(|(monomial, coefficient)| {
            (self.exponents(*monomial).1, &Fraction::from(*coefficient) * &Fraction::from(and_below))
        });
        let divisor = Polynomial::from_terms(divisor);
        Value::build(terms.into_iter().map(polynomial).collect(), divisor)
    }
}

fn parts(polynomial: &Polynomial) -> Coefficients {
    polynomial.terms().iter().map(|(letters, number)| ((Roots::new(), letters.clone()), number.clone())).collect()
}

/// Polynomials in the ratio of two values; `None` if it has a root.
fn ratio(pair: &[Value; 2]) -> Option<[Coefficients; 2]> {
    if let Some(fractions) = proportion(pair) {
        return Some(fractions.map(|number| parts(&Polynomial::constant(number))));
    }
    let [(a, b), (c, d)] = [pair[0].as_quotient()?, pair[1].as_quotient()?];
    Some([parts(&(&a * &d)), parts(&(&c * &b))])
}

/// An impact in packed polynomials.
pub(in crate::method) struct Short {
    masses: [Packed; 2],
    /// Above and below in e.
    e: [Packed; 2],
    line: [Packed; 2],
    before: [[Packed; 2]; 2],
    /// The place of the axis along which the line of centres lies.
    place: usize,
}

/// What is needed to make values of packed polynomials.
pub(in crate::method) struct Kept {
    symbols: Symbols,
    /// What the velocities before were multiplied by.
    below: i64,
    before: [[Value; 2]; 2],
    /// The place of what is across the line of centres, and stays, where the geometry leaves it out.
    across: Option<usize>,
}

fn short(impact: &Impact<Value>, geometry: Geometry) -> Option<(Short, Kept)> {
    let mut symbols = Symbols::default();
    let (masses, _) = symbols.packed(ratio(&impact.masses)?)?;
    let (p, q) = impact.restitution.as_quotient()?;
    let (e, _) = symbols.packed([parts(&p), parts(&q)])?;
    let (line, _) = symbols.packed(ratio(&impact.line)?)?;
    let [[a_x, a_y], [b_x, b_y]] = &impact.before;
    let velocities = [coefficients(a_x)?, coefficients(a_y)?, coefficients(b_x)?, coefficients(b_y)?];
    let ([a_x, a_y, b_x, b_y], below) = symbols.packed(velocities)?;
    let place = usize::from(impact.line[0].is_written_zero());
    let short = Short { masses, e, line, before: [[a_x, a_y], [b_x, b_y]], place };
    let across = (geometry == Geometry::Axis).then_some(1 - place);
    Some((short, Kept { symbols, below, before: impact.before.clone(), across }))
}

/// All four components and their denominator; nothing on overflow. What stays is left out.
type All = Option<([[Packed; 2]; 2], Packed)>;

impl Short {
    /// `q (m_A + m_B)` and `p + q`.
    fn sums(&self) -> Option<(Packed, Packed)> {
        let [m_a, m_b] = &self.masses;
        let [p, q] = &self.e;
        let divisor = q.times(&m_a.plus(m_b, 1)?)?;
        (divisor.count > 0).then_some((divisor, p.plus(q, 1)?))
    }

    fn along_axis(&self, b_moves: bool) -> All {
        let [m_a, m_b] = &self.masses;
        let [a, b] = [0, 1].map(|sphere: usize| &self.before[sphere][self.place]);
        let (d, s) = self.sums()?;
        let approach = if b_moves { a.plus(b, -1)? } else { *a };
        let gained = s.times(&approach)?;
        let to_b = m_a.times(&gained)?;
        let mut after = [[Packed::default(); 2]; 2];
        after[0][self.place] = d.times(a)?.plus(&m_b.times(&gained)?, -1)?;
        after[1][self.place] = if b_moves { d.times(b)?.plus(&to_b, 1)? } else { to_b };
        Some((after, d))
    }

    fn any_line(&self) -> All {
        let [m_a, m_b] = &self.masses;
        let [x, y] = &self.line;
        let [a, b] = &self.before;
        let (d, s) = self.sums()?;
        let square = x.times(x)?.plus(&y.times(y)?, 1)?;
        let d = (square.count > 0).then(|| d.times(&square))??;
        let approach = a[0].plus(&b[0], -1)?.times(x)?.plus(&a[1].plus(&b[1], -1)?.times(y)?, 1)?;
        let gained = s.times(&approach)?;
        let (to_a, to_b) = (m_b.times(&gained)?, m_a.times(&gained)?);
        let component = |before: &Packed, change: &Packed, line: &Packed, sign: i64| {
            d.times(before)?.plus(&change.times(line)?, sign)
        };
        let after_a = [component(&a[0], &to_a, x, -1)?, component(&a[1], &to_a, y, -1)?];
        let after_b = [component(&b[0], &to_b, x, 1)?, component(&b[1], &to_b, y, 1)?];
        Some(([after_a, after_b], d))
    }

    fn solve(&self, geometry: Geometry) -> All {
        match geometry {
            Geometry::AtRest => self.along_axis(false),
            Geometry::HeadOn | Geometry::Axis => self.along_axis(true),
            Geometry::AnyLine => self.any_line(),
        }
    }

    fn is_small(&self) -> bool {
        Geometry::ALL.iter().all(|geometry| self.solve(*geometry).is_some())
    }
}

/// Is the impact one in short polynomials?
pub(in crate::method) fn accepts(impact: &Impact<Value>) -> bool {
    short(impact, Geometry::AnyLine).is_some_and(|(short, _)| short.is_small())
}

fn found(kept: &Kept, all: &All) -> Found {
    let Some((after, divisor)) = all else {
        return Found::Missed("a product did not fit into machine words".to_owned());
    };
    let value = |packed: &Packed| kept.symbols.value(packed, divisor, kept.below);
    let mut values = after.each_ref().map(|velocity| velocity.each_ref().map(value));
    if let Some(across) = kept.across {
        for (found, before) in values.iter_mut().zip(&kept.before) {
            found[across].clone_from(&before[across]);
        }
    }
    Found::Exact(values)
}

/// The batch by a geometry.
pub(in crate::method) fn prepare(impacts: &[Impact<Value>], geometry: Geometry) -> Result<Box<dyn Prepared>, Skip> {
    let form = |impact: &Impact<Value>| {
        let form = short(impact, geometry).filter(|(short, _)| short.is_small());
        form.ok_or_else(|| "the numbers are no short polynomials".to_owned())
    };
    batch(impacts, form, move |impact| impact.solve(geometry), found)
}

impl Method for Polynomials {
    fn name(&self) -> &'static str {
        "polynomials"
    }

    fn role(&self) -> Role {
        Role::AnswerPath
    }

    fn accepts(&self) -> &'static str {
        "short polynomials in letters: components with roots as well, no roots in masses, e or the line of centres, not too large"
    }

    fn promises(&self) -> Promise {
        Promise::Exact
    }

    fn prepare(&self, impacts: &[Impact<Value>]) -> Result<Box<dyn Prepared>, Skip> {
        prepare(impacts, geometry_of(impacts))
    }
}
