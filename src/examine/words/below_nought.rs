//! Answers that come out below nought, where what is asked for is a size.

use std::cmp::Ordering;

use super::requests::{Thing, requests};
use super::sentence::{Sentence, is_supposed, says, sentences};
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::examine::remark::Remark;
use crate::expr::print;
use crate::generate::Variant;
use crate::mechanics::Quantity;

/// The tangents of angles through which a path is turned, components that are called speeds, and energies that a sphere
/// loses or gains, where they are negative; and such speeds in letters that do not tell their sign.
pub fn sizes(question: &Question, variant: &Variant, remarks: &mut Vec<Remark>) {
    let each = question.parts.iter().flat_map(|part| part.answers.iter().map(move |answer| (part, answer)));
    for (part, answer) in each.filter(|(_, answer)| answer.kind != Kind::Shown) {
        let Find::Quantity(quantity) = answer.find else { continue };
        let Some(value) = variant.solution.number(quantity) else { continue };
        let is_negative = match value.sign() {
            Some(sign) => sign == Ordering::Less && value.is_constant(),
            None => matches!(quantity.of_its_impact(), Quantity::Velocity(..)),
        };
        let Some(help) = is_negative.then(|| help(part, answer, quantity)).flatten() else { continue };
        let may = if value.is_constant() { "comes" } else { "may come" };
        let what = format!("the answer `{}` {may} out below nought", print::text_unicode(&answer.name));
        let label = "a student who gives its size is marked wrong";
        remarks.push(Remark::new(what, format!("find = \"{quantity}\""), label, help));
    }
}

/// What to do about an answer that is to have no sign; none of one that may have it.
fn help(part: &Part, answer: &Answer, quantity: Quantity) -> Option<String> {
    match quantity.of_its_impact() {
        Quantity::TanDeflection(_) => Some(format!("require `{quantity} > 0`, or ask for the angle itself")),
        Quantity::Velocity(..) if is_a_speed(part, answer) => Some(format!(
            "ask for the velocity, and say which way is positive; or find the speed, or require `{quantity} > 0`"
        )),
        Quantity::SphereEnergyLost(sphere) => of_change(part, quantity, Quantity::SphereEnergyGained(sphere), "gained"),
        Quantity::SphereEnergyGained(sphere) => of_change(part, quantity, Quantity::SphereEnergyLost(sphere), "lost"),
        _ => None,
    }
}

/// What to do about an energy that is lost where it is called gained, or the other way round; a change may have either sign.
fn of_change(part: &Part, quantity: Quantity, opposite: Quantity, word: &str) -> Option<String> {
    let opposite = opposite.in_impact(quantity.impact())?;
    let mut asked = part.ask.iter().flat_map(sentences);
    let is_change = asked.any(|sentence| says(&sentence, &["change", "changes"]));
    (!is_change).then(|| format!("require `{quantity} > 0`; or find `{opposite}`, and ask for what is {word}"))
}

/// Is an answer called a speed, or are speeds alone asked for?
fn is_a_speed(part: &Part, answer: &Answer) -> bool {
    let asked: Vec<Sentence> = part.ask.iter().flat_map(sentences).filter(|sentence| !is_supposed(sentence)).collect();
    let mut requests = asked.iter().flat_map(|sentence| requests(sentence));
    print::text_unicode(&answer.name).to_lowercase().contains("speed")
        || requests.any(|request| request.thing == Thing::Speed)
            && !asked.iter().any(|sentence| says(sentence, &["velocity", "velocities", "component", "components"]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::edited;
    use crate::generate::reference;

    #[test]
    fn a_size_is_not_below_nought() {
        let (line, turned) = ("direct/velocities-after-impact", "rest-letters/distance-from-the-centre-of-b");
        let letters = "direct/velocities-in-letters";
        let speed = ("find = \"A.after.speed\"", "find = \"A.after.x\"");
        let velocity = (
            "{ name = \"speed of *A*\", find = \"A.after.speed\"",
            "{ name = \"velocity of *A*\", find = \"A.after.x\"",
        );
        let table = [
            (line, &[][..], ""),
            (line, &[speed], "the answer `speed of A` comes out below nought"),
            (
                line,
                &[
                    ("exact = [\"speed of *A*\"", "exact = [\"velocity of *A*\""),
                    ("the speed of each", "the velocity of each"),
                    velocity,
                ],
                "",
            ),
            (
                line,
                &[velocity, ("exact = [\"speed of *A*\"", "exact = [\"velocity of *A*\"")],
                "the answer `velocity of A` comes out below nought",
            ),
            (line, &[("find = \"B.after.speed\"", "find = \"B.after.x\"")], ""),
            (letters, &[], ""),
            (letters, &[("the velocity of each", "the speed of each")], ""),
            (
                letters,
                &[("the velocity of each", "the speed of each"), ("B = \"mB\"", "B = \"5*mB\"")],
                "the answer `velocity of A` may come out below nought",
            ),
            (
                line,
                &[("find = \"A.after.speed\"", "find = \"B.ke_lost\"")],
                "the answer `speed of A` comes out below nought",
            ),
            (line, &[("find = \"A.after.speed\"", "find = \"B.ke_gained\"")], ""),
            (turned, &[], ""),
            (
                turned,
                &[("impact_parameter = \"-d\"", "impact_parameter = \"d\"")],
                "the answer `tan θ` comes out below nought",
            ),
        ];
        for (id, edits, words) in table {
            let question = edited(id, edits);
            let mut remarks = Vec::new();
            sizes(&question, &reference(&question).unwrap(), &mut remarks);
            let said = format!("{remarks:?}");
            assert!(said.contains(words) && remarks.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
