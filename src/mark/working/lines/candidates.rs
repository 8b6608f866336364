//! What of a line its equation may be: all of it, or what is left without the words before it.

use super::remarks::{
    after_impact, after_remark, after_stationary, along_impulse, is_formula, named_by_moment, turned_round,
    without_cancelling, without_lead_in, without_reason, without_remark,
};
use super::sentence::conclusions;

/// The signs of an equation or an inequality.
const RELATIONS: [char; 5] = ['=', '<', '>', '≤', '≥'];

/// The line, and the line without the words before its formula: `CLM: …`, `by conservation of momentum …`.
///
/// With the words of which a colon says that they are its name.
pub(super) fn candidates(typed: &str) -> Vec<(Option<&str>, String)> {
    let typed = typed.trim_start_matches(['∴', '→', '⇒', '⇔', '•']).trim_start_matches("=>").trim();
    // An equals sign with nothing after it waits for what is worked out on the next line.
    let typed = without_remark(without_cancelling(without_reason(typed.trim_end_matches(['=', ' ']))));
    // A bullet stands apart; a minus sign does not.
    let typed = ["- ", "* "].iter().find_map(|bullet| typed.strip_prefix(bullet)).unwrap_or(typed).trim();
    let typed = without_lead_in(typed);
    // `3 × −2` and `4·3` are written with signs that words do not have.
    let mut all: Vec<(Option<&str>, String)> = Vec::new();
    all.extend(case(typed).map(|both| (None, both)));
    all.extend(turned_round(typed).map(|turned| (None, turned)));
    all.extend(along_impulse(typed).map(|along| (None, along)));
    all.extend(after_impact(typed).map(|after| (None, after)));
    all.extend(after_remark(typed).map(|formula| (None, formula.to_owned())));
    all.extend(named_by_moment(typed).map(|(name, formula)| (Some(name), formula.to_owned())));
    all.extend(named_root(typed).map(|named| (None, named)));
    all.push((None, typed.to_owned()));
    if let Some((before, after)) = typed.split_once(':')
        && after.contains(RELATIONS)
    {
        // A law in general letters is no name of its numbers: `mu = m_A v_A + m_B v_B: 16 cos 30° = …`.
        let is_law = before.contains('=') && !before.contains(|sign: char| sign.is_ascii_digit());
        let name = if is_law { None } else { Some(before.trim()).filter(|before| !before.contains(RELATIONS)) };
        // `w - v = 3: w = v + 3` is two equations, and `k = 3 : 2 = 1.5` a ratio.
        let are_two = before.contains(RELATIONS) && after.contains(char::is_alphabetic);
        // `product = -1: …` says in words what the formula is set equal to.
        let is_said = before
            .split_once('=')
            .map(|(name, _)| name.trim())
            .is_some_and(|name| name.len() > 3 && !is_formula(name) && name.chars().all(char::is_alphabetic));
        match name {
            _ if is_said => all = vec![(None, after.trim().to_owned())],
            _ if is_law => all.insert(0, (None, after.trim().to_owned())),
            None if are_two && case(typed).is_none() => {
                all.insert(0, (None, format!("{}, {}", before.trim(), after.trim())))
            }
            None => {}
            name => all.push((name, after.trim().to_owned())),
        }
    }
    // `d/dt = 0: 2 - 6t² = 0` is no ratio.
    if let Some(formula) = after_stationary(typed) {
        all.insert(0, (None, formula.to_owned()));
    }
    // `v - u = 2i - 2j, which is parallel to i - j`: the vector, and one along it.
    let along = ["parallel to", "parallel", "∥"].into_iter().find_map(|word| typed.split_once(word));
    if let Some((before, after)) = along.filter(|(before, _)| before.contains('=')) {
        let before = before.trim_end().trim_end_matches("which is").trim_end_matches([' ', ',']);
        all.push((None, format!("{before}, {}", after.trim())));
    }
    // A scalar product is worked out on its right: `(2i + 5j).(i - j) = 2 - 5`, `p = (2i + 5j).(i - j) = -3`.
    let sides: Vec<&str> = typed.split('=').collect();
    let is_product = |side: &&str| SCALAR_PRODUCTS.iter().any(|sign| side.contains(sign));
    if let Some(product) = sides.iter().rposition(is_product).filter(|at| at + 1 < sides.len()) {
        let after = sides[product + 1..].join("=").trim().to_owned();
        all.extend((product > 0).then(|| (None, format!("{} = {after}", sides[0].trim()))));
        all.push((None, after));
    }
    // `p = -3 gives m = 2`: both, or what is concluded from a remark.
    for (before, after) in conclusions(typed).filter(|(_, after)| after.contains(RELATIONS)) {
        all.push((None, format!("{before}, {after}")));
        all.push((None, after.to_owned()));
    }
    let is_word = |word: &str| {
        let letters = word.trim_matches(['(', ')', '.', ',', ':']);
        // `3 and 4` are two values.
        let is_long = letters.chars().count() >= 3 && letters != "and";
        is_long && letters.chars().all(char::is_alphabetic) && !is_formula(letters)
    };
    let words: Vec<&str> = typed.split_whitespace().collect();
    let last = words.iter().take_while(|word| !word.contains('=')).enumerate().filter(|(_, word)| is_word(word)).last();
    if let Some((last, _)) = last
        && last + 1 < words.len()
    {
        all.push((None, without_lead_in(&words[last + 1..].join(" ")).to_owned()));
    }
    all
}

/// `speed of A √(1.92² + 2²) = 2.78`: a root whose name stands before it without an equals sign.
fn named_root(typed: &str) -> Option<String> {
    let root = ["√", "sqrt"].into_iter().filter_map(|root| typed.find(root)).min()?;
    let (name, formula) = typed.split_at(root);
    let name = name.trim();
    let name = name.strip_suffix(" is").unwrap_or(name);
    let mut words = name.split_whitespace();
    let are_words = !name.is_empty() && name.chars().all(|sign| sign.is_alphabetic() || sign.is_whitespace());
    let is_name = are_words && words.any(|word| word.chars().count() >= 3 && !is_formula(word));
    (is_name && formula.contains('=')).then(|| format!("{name} = {formula}"))
}

/// `for v = 0: 10 = 3w`: what holds in a case, and the equation there, if there is one. It has a letter: `k = 3 : 2 = 1.5` is a ratio.
fn case(typed: &str) -> Option<String> {
    let (case, equation) = typed.split_once(':')?;
    let sides: Vec<&str> = case.split(RELATIONS).collect();
    let (words, letter) = sides[0].trim_end().rsplit_once(' ').unwrap_or(("", sides[0].trim()));
    let is_letter = letter.len() <= 3 && letter.starts_with(char::is_alphabetic);
    let is_case = sides.len() == 2
        && is_letter
        && words.split_whitespace().all(|word| CASES.contains(&word.to_lowercase().as_str()));
    let case = case[words.len()..].trim().to_owned();
    let is_equation = equation.contains(RELATIONS) && equation.contains(char::is_alphabetic);
    match equation.trim() {
        "" => Some(case),
        equation => is_equation.then(|| format!("{case}, {equation}")),
    }
    .filter(|_| is_case)
}

/// What is said before a case.
const CASES: [&str; 13] =
    ["for", "when", "if", "the", "at", "let", "with", "where", "put", "take", "case", "critical", "limiting"];

/// How the sign of a scalar product stands before a vector: `(2i + 5j).(i - j)`, `u_A·(1, -1)`.
const SCALAR_PRODUCTS: [&str; 7] = [".(", " . (", "·(", "· (", "•(", "• (", "⋅("];
