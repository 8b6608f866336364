//! Lines that are crossed out and stand again.

use crate::mark::working::equations::Matched;
use crate::mark::working::examine::Studied;

/// A line that is crossed out does not count where the same law, or the same letter, stands again without a stroke.
pub(in crate::mark::working) fn set_aside_replaced(lines: &mut [Studied]) {
    let letters = |studied: &Studied| -> Vec<String> {
        let members = studied.reading.iter().flat_map(|reading| &reading.members);
        members.filter_map(|member| member.letter.clone()).collect()
    };
    let stands: Vec<&Studied> = lines.iter().filter(|studied| !studied.line.is_crossed_out()).collect();
    let is_replaced = |studied: &Studied| {
        let laws = &studied.matched;
        let own = letters(studied);
        stands.iter().any(|other| {
            let same_law = |law: &Matched| other.matched.iter().any(|matched| matched.equation == law.equation);
            laws.iter().any(same_law) || letters(other).iter().any(|letter| own.contains(letter))
        })
    };
    let crossed = lines.iter().map(|studied| studied.line.is_crossed_out() && is_replaced(studied));
    let crossed: Vec<bool> = crossed.collect();
    for (studied, _) in lines.iter_mut().zip(crossed).filter(|(_, crossed)| *crossed) {
        (studied.reading, studied.matched) = (None, Vec::new());
        studied.role = "crossed out and replaced".to_owned();
    }
}
