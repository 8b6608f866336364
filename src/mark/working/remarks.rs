//! What students say around a formula: words with which a sentence goes on, and remarks at its end.

/// What follows from a remark in words: `right angle so tan θ = …`.
pub(super) fn after_remark(typed: &str) -> Option<&str> {
    let (remark, formula) = [" so ", " hence ", " therefore "].iter().find_map(|word| typed.split_once(word))?;
    let is_in_words = remark.chars().all(|sign| sign.is_alphabetic() || " ,".contains(sign))
        && remark.split_whitespace().any(|word| word.len() > 3 && !is_formula(word));
    (is_in_words && formula.contains('=')).then(|| formula.trim())
}

/// Without the word with which a sentence goes on.
pub(super) fn without_lead_in(typed: &str) -> &str {
    LEAD_INS.iter().find_map(|word| typed.strip_prefix(word)?.strip_prefix(' ')).unwrap_or(typed).trim()
}

/// `x = -(5)` for `-x = 5`.
pub(super) fn turned_round(typed: &str) -> Option<String> {
    let mut sides = typed.strip_prefix(['-', '−'])?.split('=').map(str::trim);
    let letter = sides.next().filter(|letter| letter.len() <= 3 && letter.starts_with(char::is_alphabetic))?;
    let is_name = letter.chars().skip(1).all(|sign| sign == '_' || sign.is_ascii_uppercase() || sign.is_ascii_digit());
    let negated: Vec<String> = sides.map(|side| format!("-({side})")).collect();
    (is_name && !negated.is_empty()).then(|| format!("{letter} = {}", negated.join(" = ")))
}

/// A line without what it says at its end of a component that stays as it is: `, which remains the same`.
pub(super) fn without_remark(typed: &str) -> &str {
    let words = typed.rsplit(' ').take_while(|word| {
        let word = word.trim_matches(['(', ')', ',', '.', ';']);
        STAYS.contains(&word) || BESIDE_STAYS.contains(&word)
    });
    let words: Vec<&str> = words.collect();
    let says_so = words.iter().any(|word| STAYS.contains(&word.trim_matches(['(', ')', ',', '.', ';'])));
    let length: usize = words.iter().map(|word| word.len() + 1).sum();
    match typed.len().checked_sub(length).filter(|length| says_so && *length > 0) {
        Some(length) => typed[..length].trim_end_matches([' ', ',', ';', '-', '–']),
        None => typed,
    }
}

/// Words that say of a component that it stays as it is, and others that stand with them.
const STAYS: [&str; 8] = ["unchanged", "same", "stay", "stays", "remain", "remains", "unaffected", "constant"];
const BESIDE_STAYS: [&str; 9] = ["is", "are", "the", "as", "before", "which", "both", "after", "impact"];

/// Is it a function or `sinθ`, which looks like a word?
pub(super) fn is_formula(word: &str) -> bool {
    let of_angle = |function: &str| {
        let angle = word.strip_prefix(function).unwrap_or_default();
        angle.chars().count() == 1 || FUNCTIONS.contains(&angle)
    };
    FUNCTIONS.contains(&word) || ["sin", "cos", "tan"].iter().any(|function| of_angle(function))
}

/// Words with which a sentence goes on to its formula.
const LEAD_INS: [&str; 16] = [
    "let",
    "Let",
    "put",
    "Put",
    "so",
    "So",
    "and",
    "then",
    "hence",
    "Hence",
    "thus",
    "therefore",
    "giving",
    "gives",
    "or",
    "as",
];

const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "tan", "sqrt", "root", "arctan", "arcsin", "arccos", "atan", "theta", "alpha", "beta"];
