//! Are the answers of a variant told apart? Of two that share a value nobody can see which of them a student has found, and
//! of one that is given whether it was found at all.

use super::remark::Remark;
use super::words::in_order;
use crate::answer::Kind;
use crate::bank::{Answer, Find, Question};
use crate::expr::{Expr, Meaning, Piece, evaluate};
use crate::generate::Variant;
use crate::mechanics::Quantity;
use crate::number::{Angle, FloatInterval, Places, Value};
use crate::paper::Words;
use crate::unit::Unit;

/// Two figures are one if they round alike; formulas, and exact numbers, if they are equal.
pub fn alike(question: &Question, variant: &Variant, remarks: &mut Vec<Remark>) {
    let answers: Vec<&Answer> = question.parts.iter().flat_map(|part| &part.answers).collect();
    for (place, one) in answers.iter().enumerate() {
        for other in &answers[place + 1..] {
            if one.find != other.find && one.kind == other.kind && share(one, other, variant) {
                let what = format!("`{}` and `{}` have one value", one.find.name(), other.find.name());
                let label = "a student who exchanges the two is marked right";
                let help = format!("require `{}`", further(one, other, variant));
                let remark = Remark::new(what, format!("\"{}\"", other.find.name()), label, help);
                let remark = remark.with_help_for_all("ask for one of the two alone, or for what differs from it");
                // As in 2i + 2j: who finds the one component has not found the other by it.
                remarks.push(if are_of_one_vector(&one.find, &other.find) { remark.warning() } else { remark });
            }
        }
    }
}

/// The two components of one velocity, or of one impulse?
fn are_of_one_vector(one: &Find, other: &Find) -> bool {
    let (Find::Quantity(one), Find::Quantity(other)) = (one, other) else { return false };
    one.impact() == other.impact()
        && match (one.of_its_impact(), other.of_its_impact()) {
            (Quantity::Velocity(a, before, _), Quantity::Velocity(b, after, _)) => (a, before) == (b, after),
            (Quantity::Impulse(a, _), Quantity::Impulse(b, _)) => a == b,
            _ => false,
        }
}

/// A number with its unit that the words give, and that is to be found: who copies it is right. A few variants may have that,
/// for who knows which.
pub fn given(question: &Question, variant: &Variant, words: &Words, remarks: &mut Vec<Remark>) {
    let mut pieces = Vec::new();
    words.stem.iter().for_each(|text| in_order(&text.0, &mut pieces));
    for answer in question.parts.iter().flat_map(|part| &part.answers).filter(|answer| answer.kind == Kind::Number) {
        let Find::Quantity(quantity) = answer.find else { continue };
        let Some(value) = variant.solution.number(quantity).filter(|value| value.is_constant() && !value.is_zero())
        else {
            continue;
        };
        let is_it = |piece: &&Piece| match piece {
            Piece::Quantity(expr, unit) if *unit == quantity.unit() && *unit != Unit::None && is_of_numbers(expr) => {
                matches!(evaluate(expr, &|_| None), Ok(Meaning::Number(given)) if given == value)
            }
            _ => false,
        };
        if pieces.iter().any(is_it) {
            let name = answer.find.name();
            let what = format!("the answer `{name}` is a number that the words give");
            let help = "require other numbers, or ask for something else";
            let label = "a student who copies a number is marked right";
            remarks.push(Remark::new(what, format!("\"{name}\""), label, help).of_nearly_all());
        }
    }
}

/// Is there no name in it?
fn is_of_numbers(expr: &Expr) -> bool {
    !matches!(expr, Expr::Name(_)) && expr.all_children(&mut is_of_numbers)
}

/// A requirement that keeps two answers so far apart that no rounding makes them one; exact ones need only differ.
fn further(one: &Answer, other: &Answer, variant: &Variant) -> String {
    let (first, second) = (one.find.name(), other.find.name());
    let has_letters =
        |quantity: &Quantity| variant.solution.number(*quantity).is_some_and(|value| !value.is_constant());
    // Of letters nobody knows which is the greater.
    if one.find.quantities().iter().any(has_letters) {
        return format!("{first} != {second}");
    }
    let places = |answer: &Answer| answer.accept(variant.style).places().cloned();
    let apart = |margin: &str| format!("abs({first} - {second}) > {margin}");
    match places(one).or_else(|| places(other)) {
        None => format!("{first} != {second}"),
        // Of so many figures the last is worth least where the first is a nine, and most where it is a one.
        Some(Places::SignificantFigures(..2)) => apart(&format!("abs({second})")),
        Some(Places::SignificantFigures(figures)) => {
            apart(&format!("abs({second})/{}", 5 * 10_u64.saturating_pow(figures.saturating_sub(2).min(9))))
        }
        Some(Places::DecimalPlaces(places)) => apart(&format!("1/{}", 10_u64.saturating_pow(places.min(9)))),
        Some(Places::Nearest(step)) => apart(&step.decimal().to_string()),
    }
}

fn share<'a>(one: &'a Answer, other: &'a Answer, variant: &Variant) -> bool {
    let (first, second) = (one.find.quantities(), other.find.quantities());
    let solution = &variant.solution;
    let places = |answer: &'a Answer| answer.accept(variant.style).places();
    let is_pair = !first.is_empty() && first.len() == second.len();
    is_pair
        && first.iter().zip(&second).all(|(a, b)| {
            if a.unit() != b.unit() {
                return false;
            }
            match (solution.number(*a), solution.number(*b)) {
                (Some(a), Some(b)) => round_alike(&a, &b, places(one).or(places(other))),
                _ if are_far_apart(variant, [*a, *b], places(one)) => false,
                _ => match (solution.angle(*a), solution.angle(*b)) {
                    (Some(a), Some(b)) => {
                        let places = places(one).unwrap_or(&Places::SignificantFigures(3));
                        let known = a.is_constant() && b.is_constant();
                        known && matches!((a.rounded(places), b.rounded(places)), (Ok(a), Ok(b)) if a == b)
                    }
                    _ => false,
                },
            }
        })
}

/// Are two angles so far apart that two figures of them are unlike? To find what they are exactly costs more than a glance.
fn are_far_apart(variant: &Variant, of: [Quantity; 2], places: Option<&Places>) -> bool {
    let size = |quantity| {
        let (y, x) = variant.solution.known().direction(quantity)?;
        Angle::size_between_doubles(&y, &x)
    };
    match (places, of.map(size)) {
        (None | Some(Places::SignificantFigures(2..)), [Some(a), Some(b)]) => {
            let (less, more) = if a.upper < b.lower { (a, b) } else { (b, a) };
            1.2 * less.upper < more.lower
        }
        _ => false,
    }
}

fn round_alike(a: &Value, b: &Value, places: Option<&Places>) -> bool {
    if a == b {
        return true;
    }
    let (Some(places), true) = (places, a.is_constant() && b.is_constant()) else { return false };
    // Most are far apart, and a certified rounding costs more than a glance.
    let glance = |value: &Value| value.between_doubles().and_then(FloatInterval::sharp).or_else(|| value.to_f64());
    let near = matches!((glance(a), glance(b)), (Some(a), Some(b)) if (a - b).abs() <= 0.01 * a.abs().max(b.abs()));
    near && matches!((a.rounded(places), b.rounded(places)), (Ok(a), Ok(b)) if a == b)
}
