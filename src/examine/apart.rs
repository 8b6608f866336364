//! Are the answers of a variant told apart? Of two that share a value nobody can see which of them a student has found.

use super::remark::Remark;
use crate::bank::{Answer, Question};
use crate::generate::Variant;
use crate::number::{Places, Value};

/// Two figures are one if they round alike; formulas, and exact numbers, if they are equal.
pub fn alike(question: &Question, variant: &Variant, remarks: &mut Vec<Remark>) {
    let answers: Vec<&Answer> = question.parts.iter().flat_map(|part| &part.answers).collect();
    for (place, one) in answers.iter().enumerate() {
        for other in &answers[place + 1..] {
            if one.find != other.find && one.kind == other.kind && share(one, other, variant) {
                let what = format!("`{}` and `{}` have one value", one.find.name(), other.find.name());
                let label = "a student who exchanges the two is marked right";
                let help = format!("require `{}`", further(one, other, variant));
                remarks.push(Remark::new(what, format!("\"{}\"", other.find.name()), label, help));
            }
        }
    }
}

/// A requirement that keeps two answers so far apart that no rounding makes them one; exact ones need only differ.
fn further(one: &Answer, other: &Answer, variant: &Variant) -> String {
    let (first, second) = (one.find.name(), other.find.name());
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
                _ => match (solution.angle(*a), solution.angle(*b)) {
                    (Some(a), Some(b)) => {
                        let places = places(one).unwrap_or(&Places::SignificantFigures(3));
                        let known = a.letters().is_empty() && b.letters().is_empty();
                        known && matches!((a.rounded(places), b.rounded(places)), (Ok(a), Ok(b)) if a == b)
                    }
                    _ => false,
                },
            }
        })
}

fn round_alike(a: &Value, b: &Value, places: Option<&Places>) -> bool {
    if a == b {
        return true;
    }
    let (Some(places), true) = (places, a.is_constant() && b.is_constant()) else { return false };
    // Most are far apart, and a certified rounding costs more than a glance.
    let near = matches!((a.to_f64(), b.to_f64()), (Some(a), Some(b)) if (a - b).abs() <= 0.01 * a.abs().max(b.abs()));
    near && matches!((a.rounded(places), b.rounded(places)), (Ok(a), Ok(b)) if a == b)
}
