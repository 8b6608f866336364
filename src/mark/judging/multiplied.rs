//! Words for a quantity with a number beside them: a multiple or a power of what they name, and no name of it.

/// How a square ends in words.
pub(super) const SQUARED: [&str; 3] = ["²", "^2", "squared"];

/// `½ KE`, `2 speed`, `-KE lost`, `speed²`, `KE/2`: a multiple or power of what the words name.
pub(super) fn is_multiplied(typed: &str) -> bool {
    let typed = typed.trim();
    let is_number = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | '/' | '½' | '⅓' | '¼' | '⅔' | '¾');
    let rest = typed.trim_start_matches(is_number);
    let number = &typed[..typed.len() - rest.len()];
    let word: String = rest.trim_start().trim_start_matches(['*', '×']).trim_start().chars().take(2).collect();
    let is_ordinal = rest.starts_with(char::is_alphabetic) && ["st", "nd", "rd", "th"].contains(&word.as_str());
    let is_mass = rest.trim_start().starts_with("kg");
    let leads = word.starts_with(|sign: char| sign.is_alphabetic() || matches!(sign, '-' | '−'));
    let begins = leads && !(number.is_empty() || number.ends_with('.') || is_mass || is_ordinal);
    let negative = typed.strip_prefix(['-', '−']).is_some_and(|rest| rest.starts_with(char::is_alphabetic));
    let after_word = |rest: &str| rest.trim_end().ends_with(char::is_alphabetic);
    let is_power = |power: &str| typed.strip_suffix(power).is_some_and(after_word);
    let is_share = |(word, below): (&str, &str)| {
        let below = below.trim();
        after_word(word) && !below.is_empty() && below.chars().all(|sign| sign.is_ascii_digit())
    };
    let ends = SQUARED.into_iter().any(is_power) || typed.rsplit_once('/').is_some_and(is_share);
    // `loss × 2`, `speed − 1`, `√speed`
    let head = typed.trim_end_matches(|sign: char| sign.is_ascii_digit() || sign == '.').trim_end();
    let is_changed = head.len() < typed.trim_end().len() && head.ends_with(['×', '*', '·', '+', '-', '−', '–']);
    let is_rooted = typed.strip_prefix('√').is_some_and(|rest| rest.trim_start().starts_with(char::is_alphabetic));
    begins || negative || ends || is_changed || is_rooted
}
