//! Labels that speak of a gain or of a change, of which a loss is the opposite.

use super::Model;
use super::moments::{EARLIER, LATER};
use super::sorts::{is_of_gain, words};
use crate::mechanics::Quantity;

/// Does the label speak of a gain where a loss is asked, or of a loss where a gain is?
pub(super) fn is_opposite(asked: Quantity, label: &str) -> bool {
    let is_said = |wanted: &[&str]| words(label).any(|word| wanted.contains(&word.to_lowercase().as_str()));
    const GAIN: [&str; 6] = ["gain", "gains", "gained", "increase", "increases", "increased"];
    const LOSS: [&str; 6] = ["loss", "lost", "loses", "decrease", "decreases", "decreased"];
    is_said(&GAIN) != is_said(&LOSS) && is_said(&LOSS) == is_of_gain(asked)
}

/// Is it the opposite of what is asked, by its word or as the difference that is?
pub(super) fn is_turned_round(asked: Quantity, label: &str) -> bool {
    let label = label.trim().to_lowercase();
    let is_difference = if is_of_gain(asked) { is_before_less_after(&label) } else { is_after_less_before(&label) };
    is_opposite(asked, &label) || is_difference
}

fn is_after_less_before(label: &str) -> bool {
    is_difference_of(label, [&LATER, &EARLIER], [('2', '1'), ('f', 'i')])
}

fn is_before_less_after(label: &str) -> bool {
    is_difference_of(label, [&EARLIER, &LATER], [('1', '2'), ('i', 'f')])
}

/// Is it what there is at one end less what there is at the other, by their words or by their indices?
fn is_difference_of(label: &str, [of_words, other_words]: [&[&str]; 2], indices: [(char, char); 2]) -> bool {
    let is_difference = |(of, other): (&str, &str)| {
        is_of_end(of, of_words) && is_of_end(other, other_words)
            || indices.into_iter().any(|(first, second)| is_second_less_first(of, other, first, second))
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

/// Does the label speak of a change, after minus before, where that is not what is asked?
pub(super) fn is_of_loss(model: &Model, label: &str) -> bool {
    !model.quantity.is_some_and(is_of_gain) && is_change(label)
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
    is_opposite(Quantity::EnergyLost, &label)
        || label.strip_prefix(['Δ', 'δ', '∆']).is_some_and(is_of_name)
        || label.starts_with("\\delta")
        || words(&label).any(|word| matches!(word, "delta" | "change"))
        || is_after_less_before(&label)
}

/// `KE after`, `final KE`: what there is at one moment, by its words.
fn is_of_end(label: &str, wanted: &[&str]) -> bool {
    words(label).any(|word| wanted.contains(&word))
}
