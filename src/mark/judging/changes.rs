//! Labels that speak of a gain or of a change, of which a loss is the opposite.

use super::moments::{EARLIER, LATER};
use super::sorts::words;

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
    let is_difference = |(of, other): (&str, &str)| {
        is_of_end(of, &LATER) && is_of_end(other, &EARLIER)
            || [('2', '1'), ('f', 'i')]
                .into_iter()
                .any(|(of_end, of_start)| is_second_less_first(of, other, of_end, of_start))
    };
    label.split_once(['-', '−', '–']).is_some_and(is_difference)
}

/// `KE2 − KE1`, `E_f − E_i`
fn is_second_less_first(of: &str, other: &str, of_end: char, of_start: char) -> bool {
    let name = |side: &str, moment: char| {
        let name = side.trim().strip_suffix(moment)?.trim_end_matches('_');
        matches!(name, "ke" | "e" | "k" | "t").then(|| name.to_owned())
    };
    name(of, of_end).is_some_and(|of| name(other, of_start) == Some(of))
}

/// Does the label speak of a change, after minus before?
pub(super) fn is_change(label: &str) -> bool {
    // The letter alone is that of an angle.
    if matches!(label.trim(), "δ" | "delta" | "\\delta") {
        return false;
    }
    let label = label.trim().to_lowercase();
    // `δE`, but `δ/2` is half an angle.
    let is_of_name = |rest: &str| rest.trim_start().starts_with(|sign: char| sign.is_alphabetic() || sign == '(');
    is_gain(&label)
        || label.strip_prefix(['Δ', 'δ', '∆']).is_some_and(is_of_name)
        || label.starts_with("\\delta")
        || words(&label).any(|word| matches!(word, "delta" | "change"))
        || is_after_less_before(&label)
}

/// `KE after`, `final KE`: what there is at one moment, by its words.
fn is_of_end(label: &str, wanted: &[&str]) -> bool {
    words(label).any(|word| wanted.contains(&word))
}
