//! The slips that students make with the laws of a question, each with the wrong values to which it leads.

use std::collections::BTreeSet;

use crate::bank::{EarnedFor, Question};
use crate::expr::print as written;
use crate::generate::Variant;
use crate::mark::KeyedQuestion;
use crate::mark::slips::Asked;
use crate::mechanics::{Law, Quantity, Slip};
use crate::number::{Range, Value};
use crate::paper::{PrintedQuestion, key_question};
use crate::solve::Solution;

/// The slips of a law.
pub struct LawMistakes {
    /// The law.
    pub law: Law,
    /// Its slips, with what they lead to.
    pub slips: Vec<Mistake>,
}

/// A slip with what it leads to.
pub struct Mistake {
    /// The slip.
    pub slip: &'static Slip,
    /// Does the question say that its numbers hide it, and do these?
    pub is_hidden: bool,
    /// The answers that it changes.
    pub leads_to: Vec<WrongAnswer>,
}

/// An answer that a slip changes.
pub struct WrongAnswer {
    /// The part: `a`, or empty.
    pub part: String,
    /// What the answer is called.
    pub name: String,
    /// The wrong value, one for each way to the answer on which the slip shows in its own way; of a vector its components.
    /// None in letters: a slip changes the formula there.
    pub values: Vec<Vec<f64>>,
    /// Its unit, with the space before it.
    pub unit: String,
    /// Is it an end of the values that a letter can have?
    pub is_end: bool,
}

/// Every slip of the laws in the solution of a question with its reference numbers, and of those that earn its marks.
pub fn mistakes(question: &Question, variant: &Variant, printed: &PrintedQuestion) -> Vec<LawMistakes> {
    let mut laws: BTreeSet<Law> = variant.solution.steps().into_iter().map(|step| step.law).collect();
    for mark in question.parts.iter().flat_map(|part| &part.marks) {
        if let EarnedFor::Law(law, _) = mark.earned_for {
            laws.insert(law);
        }
    }
    let keyed = KeyedQuestion::read(&key_question(question, variant, printed)).ok();
    let wrong = |slip: &'static Slip| {
        let leads_to = keyed.as_ref().map_or_else(Vec::new, |keyed| led_to(slip, question, variant, printed, keyed));
        let is_hidden = leads_to.is_empty() && question.hidden.iter().any(|hidden| hidden == slip.tag);
        Mistake { slip, is_hidden, leads_to }
    };
    laws.into_iter()
        .filter(|law| !law.slips().is_empty())
        .map(|law| LawMistakes { law, slips: law.slips().iter().map(wrong).collect() })
        .collect()
}

fn led_to(
    slip: &Slip,
    question: &Question,
    variant: &Variant,
    printed: &PrintedQuestion,
    keyed: &KeyedQuestion,
) -> Vec<WrongAnswer> {
    let mut found = Vec::new();
    for (part, shown) in question.parts.iter().zip(&printed.parts) {
        for (answer, shown_answer) in part.answers.iter().zip(&shown.answers) {
            let asked = Asked::of(&answer.find, answer.kind);
            let rows = keyed.mistaken_values(&asked);
            let mut values: Vec<Vec<f64>> =
                rows.into_iter().filter(|(tags, _)| *tags == [slip.tag]).map(|(_, values)| values).collect();
            let right = right(&asked, &variant.solution);
            if let Some(sizes) = right.iter().map(|one| one.size).collect::<Option<Vec<f64>>>() {
                values.retain(|wrong| !are_same(wrong, &sizes));
            }
            if values.is_empty() {
                continue;
            }
            values.dedup();
            // What is lettered has no wrong number, but a wrong formula.
            let in_letters = right.iter().any(|one| one.has_letters);
            let degrees = right.iter().any(|one| one.in_degrees);
            let unit = shown_answer.unit.plain();
            found.push(WrongAnswer {
                part: shown.label.clone(),
                name: written::text_unicode(&shown_answer.name),
                values: if in_letters { Vec::new() } else { values },
                is_end: asked == Asked::Ends,
                unit: if degrees { "°".to_owned() } else { format!(" {unit}").trim_end().to_owned() },
            });
        }
    }
    found
}

/// The right value of one thing that is asked for.
struct Right {
    /// As wrong ones are printed; `None` for what has letters, and for an end of a range.
    size: Option<f64>,
    has_letters: bool,
    in_degrees: bool,
}

/// The right values of what is asked for, of a vector both components.
fn right(asked: &Asked, solution: &Solution) -> Vec<Right> {
    let number = |value: &Value| Right { size: value.to_f64(), has_letters: !value.is_constant(), in_degrees: false };
    let angle = |y: Option<f64>, x: Option<f64>, has_letters| Right {
        size: y.zip(x).map(|(y, x)| y.atan2(x).to_degrees()),
        has_letters,
        in_degrees: true,
    };
    match asked {
        Asked::Quantities(quantities) => {
            let of_one = |quantity: &Quantity| match (solution.number(*quantity), solution.angle(*quantity)) {
                (Some(value), _) => Right { in_degrees: quantity.is_angle(), ..number(&value) },
                (None, Some(found)) => angle(found.y().to_f64(), found.x().to_f64(), !found.is_constant()),
                (None, None) => Right { size: None, has_letters: false, in_degrees: quantity.is_angle() },
            };
            quantities.iter().map(of_one).collect()
        }
        // Of an acute angle the tangent is known.
        Asked::Unknown => match solution.found().first() {
            Some((letter, tangent)) if letter.range() == Range::Acute => {
                vec![angle(tangent.to_f64(), Some(1.0), !tangent.is_constant())]
            }
            found => found.into_iter().map(|(_, value)| number(value)).collect(),
        },
        Asked::Ends => {
            let ends = solution.range().into_iter().flat_map(|values| values.span.low.iter().chain(&values.span.high));
            ends.map(|end| Right { size: None, ..number(&end.value) }).collect()
        }
    }
}

/// With a mass of 1 a division by it that was forgotten changes nothing: no slip leads to the right answer. What is
/// greatest is found by search, and less precisely.
fn are_same(wrong: &[f64], right: &[f64]) -> bool {
    let is_near = |(wrong, right): (&f64, &f64)| (wrong - right).abs() <= 1e-6 * right.abs().max(1.0);
    wrong.len() == right.len() && wrong.iter().zip(right).all(is_near)
}

/// As the command prints them.
pub fn in_words(all: &[LawMistakes]) -> String {
    let mut text = "\nSlips that students make, and what each leads to with the reference numbers\n".to_owned();
    for LawMistakes { law, slips } in all {
        text.push_str(&format!("  {}\n", law.name()));
        for Mistake { slip, is_hidden, leads_to } in slips {
            text.push_str(&format!("    {}: {}\n", slip.tag, slip.sentence));
            let wrong: Vec<String> = leads_to.iter().map(wrong_in_words).collect();
            let wrong = match wrong.is_empty() {
                true if *is_hidden => "hidden: with these numbers the answers come out right".to_owned(),
                true => "does not show here".to_owned(),
                false => wrong.join("; "),
            };
            text.push_str(&format!("      → {wrong}\n"));
        }
    }
    text
}

/// `(a) speed of A 3.46 m/s`
fn wrong_in_words(wrong: &WrongAnswer) -> String {
    let part = if wrong.part.is_empty() { String::new() } else { format!("({}) ", wrong.part) };
    if wrong.values.is_empty() {
        return format!("{part}another formula for {}", wrong.name);
    }
    let one = |value: &Vec<f64>| {
        let numbers: Vec<String> = value.iter().map(|number| three_figures(*number)).collect();
        match numbers.as_slice() {
            [number] => format!("{number}{}", wrong.unit),
            several => format!("({}){}", several.join(", "), wrong.unit),
        }
    };
    let mut values: Vec<String> = wrong.values.iter().map(one).collect();
    values.sort();
    values.dedup();
    let end = if wrong.is_end { " that end at" } else { "" };
    format!("{part}{}{end} {}", wrong.name, values.join(" or "))
}

/// A float to three significant figures, without an exponent.
fn three_figures(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    // No number is minus nought.
    format!("{}", rounded + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;
    use crate::generate::reference;
    use crate::paper::compose;

    #[test]
    fn no_slip_leads_to_the_right_answer() {
        // The masses of the reference numbers let a division go unnoticed, and the greatest deflection is at one angle.
        let rows = [
            ("backwards/velocity-of-b-and-restitution", "coefficient of restitution", 5.0 / 7.0),
            ("deflection/greatest-deflection", "value of α", 38.328_818),
            ("deflection/greatest-deflection", "greatest deflection", 13.342_364),
        ];
        for (id, name, right) in rows {
            let (_, text) = shipped().find(|(shipped, _)| *shipped == id).unwrap();
            let question = read_question(id, &Source::new(id, text)).unwrap_or_else(|_| panic!("{id}"));
            let variant = reference(&question).unwrap();
            let all = mistakes(&question, &variant, &compose(&question, &variant, 1));
            let wrong = all.iter().flat_map(|law| &law.slips).flat_map(|mistake| &mistake.leads_to);
            let wrong: Vec<f64> =
                wrong.filter(|wrong| wrong.name == name).flat_map(|wrong| wrong.values.concat()).collect();
            assert!(wrong.len() > 3, "{id}: {name}");
            assert!(wrong.iter().all(|value| (value - right).abs() > 1e-3), "{id}: {name}: {wrong:?}");
        }
    }

    #[test]
    fn wrong_values_have_three_figures() {
        let table = [(2.7755, "2.78"), (46.10211, "46.1"), (-0.012345, "-0.0123"), (1234.5, "1230"), (-0.0, "0")];
        for (value, words) in table {
            assert_eq!(three_figures(value), words);
        }
    }
}
