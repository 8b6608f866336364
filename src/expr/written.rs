//! Exact values as a careful teacher writes them.
//!
//! Inside a [`Value`] an angle stands as its tangent and cosine; here sines come back. A product is
//! written number, roots, letters, sines and cosines, bracket; a sum begins with a positive term.

use std::cmp::Ordering;

use super::term::{Shared, Term, collect, ordered_sum, whole};
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
    if let Some(size) = size_below(value) {
        return ratio(&(value * &size), &size);
    }
    if let Some(product) = in_brackets(value) {
        return product;
    }
    let (terms, below) = collect(value);
    if let Some((above, below)) = by_cosines(value, terms.len(), &below) {
        return written(&above).over(written(&below));
    }
    // A sum of plain surds stays a sum: 4/3 + 11√2/9.
    let constant_sum = terms.len() > 1 && terms.iter().all(|term| term.letters.is_empty() && term.circular.is_empty());
    let shared = if constant_sum { Shared::nothing() } else { Shared::of(&terms) };
    let rest: Vec<Term> = terms.iter().map(|term| shared.taken_from(term)).collect();
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
    // And so is one that takes the minus before the whole away: `8/(3 - 5e)` for `-8/(5e - 3)`.
    let signs: Vec<bool> = below.terms().iter().map(|(_, number)| number.sign().is_lt()).collect();
    let is_difference = signs.contains(&true) && signs.contains(&false);
    let turned = match below_value.sign() {
        Some(sign) => sign.is_lt(),
        None => is_difference && scale.sign().is_lt(),
    };
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

/// The fewest terms of a product of two brackets, as `x² - 2x + 1` is.
const OF_TWO_BRACKETS: usize = 3;

/// A value in letters whose numerator is a product of brackets, and perhaps of roots: `3m(u - w)(1 + e)/(3 + m)`. Of angles the
/// identities of sines and cosines say more.
fn in_brackets(value: &Value) -> Option<Expr> {
    let mut product = Brackets::of(value)?;
    product.turn();
    let Brackets { outside, brackets } = product;
    let brackets = brackets.iter().map(|(bracket, power)| written(bracket).to_the(i64::from(*power)));
    let (size, is_negative) = match written(&outside) {
        Expr::Negative(inner) => (*inner, true),
        other => (other, false),
    };
    let (above, below) = match size {
        Expr::Quotient(above, below) => (*above, *below),
        Expr::Number(number) => (Expr::Number(number.numerator().into()), Expr::Number(number.denominator().into())),
        other => (other, Expr::integer(1)),
    };
    let before = if let Expr::Product(factors) = above { factors } else { vec![above] };
    let size = Expr::product(before.into_iter().chain(brackets)).over(below);
    Some(if is_negative { size.negated() } else { size })
}

/// A value as powers of brackets and what stands outside them.
struct Brackets {
    outside: Value,
    brackets: Vec<(Value, u32)>,
}

impl Brackets {
    /// None where there are fewer than two.
    fn of(value: &Value) -> Option<Brackets> {
        let (terms, below) = value.parts();
        let (roots, above) = terms.iter().next().filter(|_| terms.len() == 1)?;
        let is_angle = |letter: &Letter| matches!(letter.range(), Range::Acute | Range::Degrees);
        if above.terms().len() < OF_TWO_BRACKETS || value.has_letter(is_angle) {
            return None;
        }
        let (number, factors) = above.square_free();
        let whole = |polynomial: &Polynomial| Value::quotient(polynomial.clone(), Polynomial::one());
        let (brackets, single): (Vec<_>, Vec<_>) =
            factors.into_iter().partition(|(factor, _)| factor.terms().len() > 1);
        if brackets.iter().map(|(_, power)| power).sum::<u32>() < 2 {
            return None;
        }
        let roots = roots.iter().fold(Value::Rational(number), |product, root| &product * &Value::root(root.clone()));
        let single = single.iter().fold(roots, |product, (factor, power)| &product * &whole(&factor.power(*power)));
        let brackets = brackets.iter().map(|(factor, power)| (whole(factor), *power)).collect();
        Some(Brackets { outside: single.divided_by(&whole(&below))?, brackets })
    }

    /// Turns brackets round: one is positive where that is known; and one of unknown sign takes a minus before the whole away.
    fn turn(&mut self) {
        let Brackets { outside, brackets } = self;
        let turn = |outside: &mut Value, (bracket, power): &mut (Value, u32)| {
            *bracket = -&*bracket;
            if *power % 2 == 1 {
                *outside = -&*outside;
            }
        };
        let is_negative = |(bracket, _): &&mut (Value, u32)| bracket.sign() == Some(Ordering::Less);
        brackets.iter_mut().filter(is_negative).for_each(|bracket| turn(outside, bracket));
        if outside.sign() == Some(Ordering::Less) {
            let is_open = |(bracket, power): &&mut (Value, u32)| bracket.sign().is_none() && power % 2 == 1;
            brackets.iter_mut().find(is_open).into_iter().for_each(|bracket| turn(outside, bracket));
        }
    }
}

/// What stands below the line in lowest terms, where its square does and it itself above: of `|x|/x²`, which is `1/|x|`.
fn size_below(value: &Value) -> Option<Value> {
    let below = value.denominator();
    let is_size = |root: &Root| {
        let Root::Nested { radicand, .. } = root else { return false };
        let Some((square, _)) = radicand.as_quotient() else { return false };
        let is_square = square.square_free().1.iter().all(|(_, power)| power % 2 == 0);
        is_square && below.divided_by(&square).is_some() && value.split(root).0.is_zero()
    };
    let size = value.roots().into_iter().find(|root| !below.is_one() && is_size(root))?;
    Some(Value::root(size))
}

/// Numerator and denominator with sines and cosines in place of the tangents of given degrees below, where that
/// is shorter: each is multiplied by the power of the cosine that the tangents come to.
fn by_cosines(value: &Value, above_terms: usize, below: &Polynomial) -> Option<(Value, Value)> {
    let mut cosines = Value::ONE;
    for angle in below.letters().into_iter().filter(Letter::is_constant) {
        cosines = &cosines * &Value::cosine(angle).power(i32::try_from(below.degree(angle)).ok()?)?;
    }
    if cosines == Value::ONE {
        return None;
    }
    let below_by_cosines = &Value::quotient(below.clone(), Polynomial::one()) * &cosines;
    let (above, below_by_cosines) = Value::without_common_factors(&(value * &below_by_cosines), &below_by_cosines);
    let count = |value: &Value| collect(value).0.len();
    if count(&above) + count(&below_by_cosines) >= above_terms + below.terms().len() {
        return None;
    }
    let turned = below_by_cosines.sign().is_some_and(|sign| sign.is_lt());
    Some(if turned { (-above, -below_by_cosines) } else { (above, below_by_cosines) })
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
            let size = FromDegrees::arctangent(&if negative { -y } else { y.clone() }, x);
            if negative { size.from(0).written() } else { size.written() }
        }
        Some(sign) if sign.is_lt() && y.sign().is_some() => {
            let size = FromDegrees::arctangent(&y.absolute(), &-x);
            if negative { size.from(180).from(0).written() } else { size.from(180).written() }
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

/// A whole number of degrees and an angle added to it or taken from it, so that `180° − (90° − α)` is `90° + α`.
struct FromDegrees {
    degrees: i64,
    is_added: bool,
    angle: Expr,
}

impl FromDegrees {
    /// The inverse tangent of `y/x`, x positive.
    fn arctangent(y: &Value, x: &Value) -> FromDegrees {
        let added = |angle| FromDegrees { degrees: 0, is_added: true, angle };
        if !x.equals(&Value::ONE) {
            return added(Expr::call(Function::Atan, written(y).over(written(x))));
        }
        // No reciprocal is taken to see whether it is a letter: of a sum of many roots that would take minutes.
        if let Some((above, below)) = y.as_quotient() {
            if let Some(letter) = acute_letter(&above).filter(|_| below.is_one()) {
                return added(Expr::name(letter.name()));
            }
            if let Some(letter) = acute_letter(&below).filter(|_| above.is_one()) {
                return added(Expr::name(letter.name())).from(90);
            }
        }
        added(Expr::call(Function::Atan, written(y)))
    }

    /// So many degrees less the angle.
    fn from(self, degrees: i64) -> FromDegrees {
        FromDegrees { degrees: degrees - self.degrees, is_added: !self.is_added, angle: self.angle }
    }

    fn written(self) -> Expr {
        let angle = if self.is_added { self.angle } else { self.angle.negated() };
        let degrees = Expr::degrees(Expr::integer(self.degrees.abs()));
        match self.degrees {
            0 => angle,
            1.. => Expr::Sum(vec![degrees, angle]),
            _ => Expr::Sum(vec![angle, degrees.negated()]),
        }
    }
}

/// The letter of an acute angle, where the polynomial is just its tangent.
fn acute_letter(polynomial: &Polynomial) -> Option<Letter> {
    let letter = polynomial.letters().first().copied().filter(|letter| letter.range() == Range::Acute)?;
    (*polynomial == Polynomial::letter(letter)).then_some(letter)
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
    let (above, below) = &Value::in_lowest_terms(above, below);
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
