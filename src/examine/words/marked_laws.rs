//! Of which law the text of a mark speaks.

use crate::bank::{EarnedFor, Question};
use crate::examine::Finding;
use crate::expr::print;
use crate::mechanics::{Law, Quantity};

/// Marks for the use of one law, whose text speaks of another: `Newton's law of restitution` for `momentum`.
pub fn of_another_law(question: &Question) -> Vec<Finding> {
    // Steps on the way from these equations speak of them, as `solve` does.
    let has_words_of_its_own = |law: Law| {
        law.gives_equation() || [Quantity::EnergyLost, Quantity::ImpulseMagnitude].iter().any(|own| law.gives(*own))
    };
    let mut findings = Vec::new();
    for (place, part) in question.parts.iter().enumerate() {
        for (row, mark) in part.marks.iter().enumerate() {
            let (EarnedFor::Law(own, _), Some(text)) = (&mark.earned_for, &mark.text) else { continue };
            let text = print::text_unicode(text);
            let other = Law::meant(&text).filter(|other| other.gives_equation() && other != own);
            let other = other.filter(|_| has_words_of_its_own(*own) && !own.is_named_in(&text));
            // What is conserved may be momentum, and is said of energy.
            let lower = text.to_lowercase();
            // `PCLM`, `M0 for use of energy`
            let mut words = lower.split(|letter: char| !letter.is_alphanumeric());
            let names_it = words.any(|word| ["clm", "pclm", "com", "plm", "pcom", "nlr", "nel"].contains(&word));
            let denies_it = ["no ", "not ", "m0", "a0", "without"].iter().any(|word| lower.contains(word));
            let is_of_energy = own.gives_equation()
                && lower.contains("energy")
                && !(lower.contains(own.name()) || names_it || denies_it);
            let Some(other) = other.or_else(|| Law::meant("energy").filter(|_| is_of_energy)) else { continue };
            let message = format!(
                "the text of the mark {} speaks of {}, and it is for `{}`",
                mark.id,
                other.name(),
                mark.earned_for
            );
            let help = format!("say in its `text` what is done with {}, or mend `for`", own.name());
            let found = Finding::new(message, "", format!("for {}", own.name()));
            findings.push(found.with_help(help).at_row(place, "marks", row));
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn the_text_of_a_mark_is_of_the_law_for_which_it_is() {
        let id = "direct/one-sphere-catches-the-other";
        let text = |law: &str, text: &str| {
            (format!("\"M1\", for = \"{law}\""), format!("\"M1\", for = \"{law}\", text = \"{text}\""))
        };
        let table = [
            ("momentum", "Newton's law of restitution", "the mark M1a speaks of restitution, and it is for `momentum`"),
            ("momentum", "conservation of energy", "the mark M1a speaks of energy, and it is for `momentum`"),
            ("momentum", "conservation of momentum, all terms", ""),
            ("momentum", "all four terms, consistent signs", ""),
            ("momentum", "PCLM, no energy used", ""),
            ("momentum", "COM along the line; energy is not kept", ""),
            ("momentum", "conservation of energy, components", "speaks of energy, and it is for `momentum`"),
            ("momentum", "energy, with both panels compared", "speaks of energy, and it is for `momentum`"),
            ("momentum", "all terms. M0 for use of energy", ""),
            ("restitution", "conservation of momentum", "speaks of momentum, and it is for `restitution`"),
            ("restitution", "separation over approach", ""),
            ("energy", "Newton's law of restitution", "speaks of restitution, and it is for `energy`"),
            ("energy", "difference of the energies", ""),
        ];
        for (law, said, words) in table {
            let (from, to) = text(law, said);
            let edits: Edits = &[(&from, &to)];
            let found: String = of_another_law(&edited(id, edits)).into_iter().map(|finding| finding.message).collect();
            assert!(found.contains(words) && found.is_empty() == words.is_empty(), "{law}: {said}: {found}");
        }
    }
}
