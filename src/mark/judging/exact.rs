//! Is what a student wrote exactly equal to the model answer? Refuted by intervals, proved by the normal form.

use crate::expr::{Expr, Function, Meaning, Turn, evaluate, holds};
use crate::mark::enclosure::{POINTS, enclose, enclose_roughly, letter};
use crate::number::{Angle, FloatInterval, Fraction, Interval, Letter, Range, Value};

use super::Model;
use super::effort::{MOST_EFFORT, effort, effort_at_point};

/// The precision of the enclosures that refute.
pub(super) const BITS: usize = 96;

/// Whether two expressions are equal for all their letters can stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Equality {
    Equal,
    Different,
    /// Neither proved nor refuted.
    Undecided,
}

/// What a name means where these are the letters.
pub(super) fn meaning_of(letters: &[Letter], name: &str) -> Option<Meaning> {
    let letter = letter(letters, name)?;
    Some(match letter.range() {
        Range::Acute => Meaning::Angle(Turn::of(Angle::of(&Value::letter(*letter), &Value::ONE)?)),
        _ => Meaning::Number(Value::letter(*letter)),
    })
}

/// The exact meaning; `None` if it has none, or takes too long.
pub(super) fn meaning(expr: &Expr, letters: &[Letter]) -> Option<Meaning> {
    effort(expr)?;
    if !decidable(&[expr]) {
        return None;
    }
    evaluate(expr, &|name| meaning_of(letters, name)).ok()
}

/// The exact value, if it is a plain number or a formula.
pub(super) fn value(expr: &Expr, letters: &[Letter]) -> Option<Value> {
    match meaning(expr, letters)? {
        Meaning::Number(value) => Some(value),
        _ => None,
    }
}

/// Does it stand for an angle, as `arctan 7` or `30°` does?
pub(super) fn is_angle(expr: &Expr, letters: &[Letter]) -> bool {
    may_be_angle(expr, letters) && matches!(meaning(expr, letters), Some(Meaning::Angle(_) | Meaning::Degrees(_)))
}

/// Is there an angle in it that is not under a sine or a root? It spares working out what is plainly none.
fn may_be_angle(expr: &Expr, letters: &[Letter]) -> bool {
    match expr {
        Expr::Degrees(_) | Expr::Pi | Expr::Call(Function::Asin | Function::Acos | Function::Atan, _) => true,
        Expr::Name(name) => letter(letters, &name.text).is_some_and(|letter| letter.range() == Range::Acute),
        Expr::Call(..) | Expr::Number(_) | Expr::Decimal(_) => false,
        _ => expr.children().into_iter().any(|child| may_be_angle(child, letters)),
    }
}

/// A name that is neither a letter of the question nor a unit vector.
pub(super) fn unknown_letter(expr: &Expr, letters: &[Letter]) -> Option<String> {
    let names = expr.names();
    let known = |name: &str| matches!(name, "i" | "j") || letter(letters, name).is_some();
    names.iter().find(|name| !known(&name.text)).map(|name| name.text.clone())
}

/// Are the two equal, whatever their letters stand for?
pub(super) fn same(model: &Expr, student: &Expr, letters: &[Letter]) -> Equality {
    let roughly = |point: u32| enclose_roughly(model, letters, point);
    if refuted(roughly, |point| enclose(model, letters, point, BITS), student, letters) {
        return Equality::Different;
    }
    proved(model, student, letters)
}

/// Is a student's expression equal to the model answer?
pub(super) fn equals(model: &Model, student: &Expr) -> Equality {
    let (known, letters) = (model.known(), &model.vocabulary.letters);
    if refuted(|point| known.roughly(point), |point| known.enclosure(point), student, letters) {
        return Equality::Different;
    }
    let said = match (known.value(), effort(student)) {
        (Some(right), Some(_)) if decidable(&[&model.value, student]) => Some(right).zip(value(student, letters)),
        _ => None,
    };
    match said {
        Some((right, said)) if right.equals(&said) => Equality::Equal,
        Some(_) => Equality::Different,
        None => proved(&model.value, student, letters),
    }
}

/// By the normal form, or by exact values at fixed points, where a formula is short that would be long in letters.
pub(super) fn proved(model: &Expr, student: &Expr, letters: &[Letter]) -> Equality {
    if model == student {
        return Equality::Equal;
    }
    if !decidable(&[model, student]) {
        return Equality::Undecided;
    }
    let equation = Expr::equation(model.clone(), student.clone());
    let whole = effort(student).and(effort(model)).map(|_| holds(&equation, &|name| meaning_of(letters, name)));
    match whole {
        Some(Ok(Some(true))) => Equality::Equal,
        Some(Ok(Some(false))) => Equality::Different,
        _ => match effort_at_point(student).zip(effort_at_point(model)) {
            Some((one, two)) if one + two <= MOST_EFFORT / u64::from(2 * POINTS) => at_points(&equation, letters),
            _ => Equality::Undecided,
        },
    }
}

/// Do enclosures keep apart at any of the fixed points? Most wrong values are seen between doubles.
fn refuted(
    roughly: impl Fn(u32) -> Option<FloatInterval>,
    finely: impl Fn(u32) -> Option<Interval>,
    student: &Expr,
    letters: &[Letter],
) -> bool {
    let are_apart_roughly = |point| {
        let both = roughly(point).zip(enclose_roughly(student, letters, point));
        both.is_some_and(|(right, said)| !right.overlaps(said))
    };
    let are_apart = |point| {
        let both = finely(point).and_then(|right| Some((right, enclose(student, letters, point, BITS)?)));
        both.is_some_and(|(right, said)| !right.overlaps(&said))
    };
    points(letters).any(are_apart_roughly) || points(letters).any(are_apart)
}

/// The points at which enclosures are compared: one is enough where there are no letters.
pub(super) fn points(letters: &[Letter]) -> std::ops::Range<u32> {
    0..if letters.is_empty() { 1 } else { POINTS }
}

/// Does the equation hold exactly at fixed points? For forms that the normal form cannot take.
fn at_points(equation: &Expr, letters: &[Letter]) -> Equality {
    // Without letters all points are one, and what holds there is proved.
    let (points, enough) = if equation.names().is_empty() { (1, 1) } else { (2 * POINTS, POINTS) };
    let mut held = 0;
    for point in 0..points {
        let names = |name: &str| {
            let letter = letter(letters, name)?;
            let value = Value::from(letter.at(point));
            Some(match letter.range() {
                Range::Acute => Meaning::Angle(Turn::of(Angle::of(&value, &Value::ONE)?)),
                _ => Meaning::Number(value),
            })
        };
        match holds(equation, &names) {
            Ok(Some(true)) => held += 1,
            Ok(Some(false)) => return Equality::Different,
            _ => {}
        }
    }
    // Two formulas of an exam that agree exactly at this many unrelated points are the same formula.
    if held >= enough { Equality::Equal } else { Equality::Undecided }
}

/// Beyond this degree of the field in which they lie, sums of sines and cosines of given degrees are not compared:
/// whole degrees and a root stay below it.
const HIGHEST_DEGREE: u128 = 96;

/// Can relations between the sines and cosines of given degrees in these expressions be decided quickly?
///
/// One angle alone satisfies no relation of so low a degree; of several, such as cos 20° = cos 40° + cos 80°, the
/// decision takes as many figures as the field that holds them all has dimensions.
fn decidable(exprs: &[&Expr]) -> bool {
    let mut angles = Vec::new();
    exprs.iter().for_each(|expr| given_angles(expr, false, &mut angles));
    angles.sort();
    angles.dedup();
    if angles.len() < 2 {
        return true;
    }
    let order = angles.iter().try_fold(4_u128, |order, degrees| {
        let below =
            u128::try_from((degrees / &Fraction::from(360)).denominator()).ok().filter(|below| *below < 1 << 20)?;
        Some(order / shared(order, below) * below).filter(|order| *order < 1 << 20)
    });
    let roots = exprs.iter().map(|expr| roots(expr)).sum::<u32>().min(20);
    order.is_some_and(|order| (totient(order) / 2) << roots <= HIGHEST_DEGREE)
}

fn shared(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { shared(b, a % b) }
}

/// How many numbers up to `order` share no factor with it.
fn totient(order: u128) -> u128 {
    (1..=order).filter(|number| shared(order, *number) == 1).count() as u128
}

/// The given angles of which sines, cosines and tangents are taken, from 0 to 45 degrees; those that are roots left out.
fn given_angles(expr: &Expr, in_call: bool, found: &mut Vec<Fraction>) {
    if in_call && let Some(degrees) = given_degrees(expr) {
        let right = Fraction::from(90);
        let acute = &degrees - &(&right * &Fraction::from((&degrees / &right).floor()));
        let least = if acute > Fraction::from(45) { &right - &acute } else { acute };
        if !(&least / &Fraction::from(15)).is_integer() {
            found.push(least);
        }
        return;
    }
    let in_call = match expr {
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, _) => true,
        Expr::Call(..) => false,
        _ => in_call,
    };
    expr.children().into_iter().for_each(|child| given_angles(child, in_call, found));
}

/// The number of degrees, where an expression is arithmetic with given angles alone.
fn given_degrees(expr: &Expr) -> Option<Fraction> {
    match expr {
        Expr::Number(number) => Some(number.clone()),
        Expr::Decimal(text) => text.parse().ok(),
        Expr::Pi => Some(Fraction::from(180)),
        Expr::Degrees(inner) => given_degrees(inner),
        Expr::Negative(inner) => Some(-given_degrees(inner)?),
        Expr::Sum(terms) => terms.iter().try_fold(Fraction::ZERO, |sum, term| Some(&sum + &given_degrees(term)?)),
        Expr::Product(factors) => {
            factors.iter().try_fold(Fraction::ONE, |product, factor| Some(&product * &given_degrees(factor)?))
        }
        Expr::Quotient(above, below) => Some(&given_degrees(above)? * &given_degrees(below)?.reciprocal()?),
        _ => None,
    }
}

/// How many roots are in it.
fn roots(expr: &Expr) -> u32 {
    let own = matches!(expr, Expr::Call(Function::Sqrt, _))
        || matches!(expr, Expr::Power(_, exponent) if !matches!(**exponent, Expr::Number(ref number) if number.is_integer()));
    u32::from(own) + expr.children().into_iter().map(roots).sum::<u32>()
}
