//! Answers that come out below nought, where what is asked for is a size.

use std::cmp::Ordering;

use crate::answer::Kind;
use crate::bank::{Answer, Find, Question};
use crate::examine::remark::Remark;
use crate::expr::print;
use crate::generate::Variant;
use crate::mechanics::Quantity;

/// The tangents of angles through which a path is turned, and components that are called speeds, where they are negative.
pub fn sizes(question: &Question, variant: &Variant, remarks: &mut Vec<Remark>) {
    for answer in question.parts.iter().flat_map(|part| &part.answers).filter(|answer| answer.kind != Kind::Shown) {
        let Find::Quantity(quantity) = answer.find else { continue };
        let Some(help) = other(answer, quantity) else { continue };
        let value = variant.solution.number(quantity);
        if value.is_some_and(|value| value.is_constant() && value.sign() == Some(Ordering::Less)) {
            let what = format!("the answer `{}` comes out below nought", print::text_unicode(&answer.name));
            let label = "a student who gives its size is marked wrong";
            remarks.push(Remark::new(what, format!("find = \"{quantity}\""), label, help));
        }
    }
}

/// What to do about an answer that is to have no sign.
fn other(answer: &Answer, quantity: Quantity) -> Option<String> {
    match quantity.of_its_impact() {
        Quantity::TanDeflection(_) => Some(format!("require `{quantity} > 0`, or ask for the angle itself")),
        Quantity::Velocity(..) if print::text_unicode(&answer.name).to_lowercase().contains("speed") => {
            Some(format!("find the speed, or require `{quantity} > 0`"))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::edited;
    use crate::generate::reference;

    #[test]
    fn a_size_is_not_below_nought() {
        let (line, turned) = ("direct/velocities-after-impact", "rest-letters/distance-from-the-centre-of-b");
        let speed = ("find = \"A.after.speed\"", "find = \"A.after.x\"");
        let velocity = (
            "{ name = \"speed of *A*\", find = \"A.after.speed\"",
            "{ name = \"velocity of *A*\", find = \"A.after.x\"",
        );
        let table = [
            (line, &[][..], ""),
            (line, &[speed], "the answer `speed of A` comes out below nought"),
            (line, &[("exact = [\"speed of *A*\"", "exact = [\"velocity of *A*\""), velocity], ""),
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
