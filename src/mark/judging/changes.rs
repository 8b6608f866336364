//! Labels that speak of a gain or of a change, of which a loss is the opposite.

use super::called::{EARLIER, LATER, words};

/// Does the label speak of a gain, which a loss is the opposite of?
pub(super) fn is_gain(label: &str) -> bool {
    let is = |wanted: &[&str]| words(label).any(|word| wanted.contains(&word.to_lowercase().as_str()));
    is(&["gain", "gains", "gained", "increase", "increases", "increased"]) && !is(&["loss", "lost", "loses"])
}

/// Is it a gain, by its word or as what there is after less what there was before?
pub(super) fn is_turned_round(label: &str) -> bool {
    let label = label.trim().to_lowercase();
    is_gain(&label) || is_after_less_before(&label)
}

fn is_after_less_before(label: &str) -> bool {
    let is_difference = |(of, other): (&str, &str)| is_of_end(of, &LATER, 'f') && is_of_end(other, &EARLIER, 'i');
    label.split_once(['-', '−', '–']).is_some_and(is_difference)
}

/// Does the label speak of a change, after minus before?
pub(super) fn is_change(label: &str) -> bool {
    // The letter alone is that of an angle.
    if matches!(label.trim(), "δ" | "delta" | "\\delta") {
        return false;
    }
    let label = label.trim().to_lowercase();
    is_gain(&label)
        || ['Δ', 'δ', '∆'].iter().any(|delta| label.starts_with(*delta))
        || label.starts_with("\\delta")
        || words(&label).any(|word| matches!(word, "delta" | "change"))
        || is_after_less_before(&label)
}

/// `KE after`, `final KE`, `KEf`: what there is at one moment, by its words or by a letter at its end.
fn is_of_end(label: &str, wanted: &[&str], letter: char) -> bool {
    let mut found = words(label).filter(|word| !word.is_empty());
    found.any(|word| wanted.contains(&word) || (word.starts_with("ke") && word.len() == 3 && word.ends_with(letter)))
}
