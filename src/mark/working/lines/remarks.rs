//! What students say around a formula: words with which a sentence goes on, and remarks at its end.

use std::borrow::Cow;

use super::sentence::conclusions;

/// A line without the arrow that says which way is positive: `R(→) 16 cos 30° = …`, `PCLM ↔ …`, `perp (↑+): …`.
pub(super) fn without_arrow(typed: &str) -> Cow<'_, str> {
    let (words, rest) = typed.split_at(typed.find(|sign: char| !(sign.is_alphabetic() || sign == ' ')).unwrap_or(0));
    let words: Vec<&str> =
        words.split_whitespace().filter(|word| !matches!(*word, "R" | "Res" | "resolving")).collect();
    let is_word = |word: &&str| word.chars().count() > 2 && !is_formula(word);
    let after = after_arrow(rest.trim_start_matches([':', ' ']))
        .filter(|after| words.iter().all(is_word) && after.contains('='));
    match (after, words.as_slice()) {
        (None, _) => Cow::Borrowed(typed),
        (Some(after), []) => Cow::Borrowed(after),
        (Some(after), words) => Cow::Owned(format!("{}: {after}", words.join(" "))),
    }
}

/// What stands after an arrow, in brackets or not, with the sign of its direction.
fn after_arrow(typed: &str) -> Option<&str> {
    const ARROWS: [&str; 14] = ["<-->", "<->", "-->", "->", "<-", "→", "←", "↑", "↓", "↔", "↕", "⟶", "⟵", "⟷"];
    let opened = typed.strip_prefix('(');
    let mut rest = opened.unwrap_or(typed).trim_start_matches(['+', ' ']);
    let from = rest.len();
    while let Some(after) = ARROWS.iter().find_map(|arrow| rest.strip_prefix(*arrow)) {
        rest = after.trim_start();
    }
    let is_there = rest.len() < from;
    let rest = rest.trim_start_matches('+').trim_start_matches([' ', '\u{fe0f}']);
    let rest = if opened.is_some() { rest.strip_prefix(')')? } else { rest };
    is_there.then(|| rest.trim_start_matches([' ', ':', ',']))
}

/// What follows from a remark in words: `right angle so tan θ = …`.
pub(super) fn after_remark(typed: &str) -> Option<&str> {
    let (remark, formula) = conclusions(typed).next()?;
    let is_in_words = remark.chars().all(|sign| sign.is_alphabetic() || " ,".contains(sign))
        && remark.split_whitespace().any(|word| word.len() > 3 && !is_formula(word));
    (is_in_words && formula.contains('=')).then(|| formula.trim())
}

/// Without the word with which a sentence goes on, or the name of the law that is used: `NEL: y - x = 4`.
pub(super) fn without_lead_in(typed: &str) -> &str {
    // `By CLM 32 = 4v + 6w`
    let first = typed.split(' ').next().unwrap_or_default();
    let by = ["by", "using", "from"].into_iter().find(|by| first.eq_ignore_ascii_case(by));
    let named = by.map_or(typed, |by| typed[by.len()..].trim_start());
    let after_law = |(law, ends): (&str, &[char])| {
        let (lead, after) = named.split_at_checked(law.len())?;
        let after = without_dash(after).or_else(|| after.strip_prefix(ends))?;
        (lead.eq_ignore_ascii_case(law) && after.contains('=')).then(|| after.trim_start_matches([' ', ':']))
    };
    let after_word = |word: &&str| typed.strip_prefix(*word)?.strip_prefix(' ');
    let after = LEAD_INS.iter().find_map(after_word).or_else(|| laws().find_map(after_law));
    after.unwrap_or(typed).trim()
}

/// `NLR - w - v = 3`: a dash between blanks is no minus sign after the name of a law.
fn without_dash(after: &str) -> Option<&str> {
    [" - ", " – ", " — "].into_iter().find_map(|dash| after.strip_prefix(dash))
}

/// What the two laws are called, for short and in words, with what ends the name.
fn laws() -> impl Iterator<Item = (&'static str, &'static [char])> {
    const SHORT: [&str; 8] = ["CLM", "COLM", "PCLM", "PCM", "NEL", "NLR", "NLOR", "NLI"];
    // With a blank after it COM may be the centre of mass.
    const WITH_COLON: [&str; 7] = [
        "COM",
        "momentum",
        "conservation of momentum",
        "restitution",
        "law of restitution",
        "newton's law of restitution",
        "impact law",
    ];
    SHORT.into_iter().map(|law| (law, &[':', ' '][..])).chain(WITH_COLON.into_iter().map(|law| (law, &[':'][..])))
}

/// `x = -(5)` for `-x = 5`.
pub(super) fn turned_round(typed: &str) -> Option<String> {
    // `-v = x + y, y - x = 4`: what stands after a comma is as it was.
    let (typed, rest) = typed.split_at(typed.find([',', ';']).unwrap_or(typed.len()));
    let mut sides = typed.strip_prefix(['-', '−'])?.split('=').map(str::trim);
    let letter = sides.next().filter(|letter| letter.len() <= 3 && letter.starts_with(char::is_alphabetic))?;
    let is_name = letter.chars().skip(1).all(|sign| sign == '_' || sign.is_ascii_uppercase() || sign.is_ascii_digit());
    let negated: Vec<String> = sides.map(|side| format!("-({side})")).collect();
    (is_name && !negated.is_empty()).then(|| format!("{letter} = {}{rest}", negated.join(" = ")))
}

/// `after 2/3 × 5 = 10/3`, `after: along wall -6 × 2/3 = -4`: the moment, and of which component, name what is worked out.
pub(super) fn named_by_moment(typed: &str) -> Option<(&str, &str)> {
    const COMPONENT: [&str; 7] = ["along", "the", "wall", "perp", "perpendicular", "parallel", "normal"];
    let (words, formula) = typed.split_at(typed.find(|sign: char| sign.is_ascii_digit() || "-−".contains(sign))?);
    let name = words.strip_suffix(' ')?.trim_end_matches([':', ' ']);
    let mut each = name.split_whitespace().map(|word| word.trim_end_matches([':', ',']));
    let is_moment = |word: &str| matches!(word, "after" | "before");
    let is_named = each.clone().any(is_moment) && each.all(|word| is_moment(word) || COMPONENT.contains(&word));
    (is_named && formula.contains('=')).then_some((name, formula))
}

/// What follows from it that something is stationary: `d/dt = 0 gives 1 - e = 2tan²t`.
pub(super) fn after_stationary(typed: &str) -> Option<&str> {
    let (derivative, after) = typed.split_once('=')?;
    let after = after.trim_start().strip_prefix('0')?;
    let is_derivative = derivative.trim_start().starts_with('d') && derivative.contains("/d");
    let after = after.trim_start_matches([' ', ',', ';', ':', '⇒', '→', '∴', '=', '>']);
    let words = ["gives", "when", "so", "if", "where", "hence"];
    let after = words.into_iter().find_map(|word| after.strip_prefix(word)).unwrap_or(after);
    (is_derivative && after.contains('=')).then(|| after.trim())
}

/// A line without the remark in brackets of what has gone from both sides, or of what the law says: `u cos α = x + y (m cancels)`,
/// `… (momentum gained = momentum lost)`.
pub(super) fn without_cancelling(typed: &str) -> &str {
    let Some((before, remark)) = typed.trim_end_matches(['.', ' ']).rsplit_once('(') else { return typed };
    let is_in_words = |side: &str| {
        side.chars().all(|sign| sign.is_alphabetic() || sign == ' ')
            && side.split_whitespace().any(|word| word.len() > 3 && !is_formula(word))
    };
    let says_so = |remark: &str| match remark.contains('=') {
        true => before.contains('=') && remark.split('=').all(is_in_words),
        false => ["cancel", "divid"].iter().any(|word| remark.contains(word)),
    };
    if remark.strip_suffix(')').is_some_and(says_so) { before.trim_end() } else { typed }
}

/// A line without what it says at its end of the law that it is by, `20 = 5v + 2w (by CLM)`, `(9 - 7e)/t = 16t by AM-GM`, and without
/// a note behind a hash.
pub(super) fn without_reason(typed: &str) -> &str {
    let is_formula_before = |before: &str| before.contains(['=', '<', '>', '≤', '≥']);
    let noted = typed.split_once('#').filter(|(before, note)| before.ends_with(' ') && !note.contains('='));
    let typed = noted.map_or(typed, |(before, _)| before).trim_end();
    let Some((before, reason)) = typed.trim_end_matches(['.', ' ']).rsplit_once("by ") else { return typed };
    let is_law = |word: &str| {
        let word = word.trim_matches(['(', ')', ',', '[', ']']);
        LAW_WORDS.iter().any(|law| law.eq_ignore_ascii_case(word))
    };
    let is_apart = |before: &str| before.ends_with([' ', '(', '[']);
    let is_reason = is_apart(before) && reason.split([' ', '/']).filter(|word| !word.is_empty()).all(is_law);
    let before = before.trim_end_matches([' ', '(', '[', ',', ';', '-', '–']);
    if is_reason && is_formula_before(before) { before } else { typed }
}

/// The words of which names of laws are made.
const LAW_WORDS: [&str; 28] = [
    "CLM",
    "COLM",
    "PCLM",
    "PCM",
    "COM",
    "NEL",
    "NLR",
    "NLOR",
    "NLI",
    "AM-GM",
    "AM–GM",
    "AMGM",
    "AM/GM",
    "AM",
    "GM",
    "conservation",
    "momentum",
    "linear",
    "restitution",
    "impulse",
    "impact",
    "newton's",
    "newton",
    "law",
    "of",
    "the",
    "and",
    "&",
];

/// What an impulse is said to be along: `impulse is in direction i − j` for `I ∝ i − j`, where I is no number.
pub(super) fn along_impulse(typed: &str) -> Option<String> {
    const ALONG: [&str; 8] =
        ["∝", "∥", "//", "||", "is parallel to ", "parallel to ", "is in the direction ", "is a multiple of "];
    let rest = typed.strip_prefix("I ")?.trim_start();
    let line = ALONG.iter().find_map(|words| rest.strip_prefix(*words))?;
    Some(format!("impulse is in direction {}", line.trim_start().trim_start_matches("of ")))
}

/// What each component is after an impact: `3i, 2j` for `3i stays, -4j becomes 2j`.
pub(super) fn after_impact(typed: &str) -> Option<String> {
    const BECOMES: [&str; 7] = [" becomes ", " become ", " changes to ", " turns into ", " → ", " -> ", " \\to "];
    // An arrow after an equation says what follows from it.
    let is_formula = |before: &str| {
        let mut words = before.split(|sign: char| !sign.is_alphabetic());
        !before.contains('=') && !words.any(|word| word.len() > 1 && !is_formula(word))
    };
    let changed = |clause: &str| {
        let sides = BECOMES.iter().find_map(|word| clause.split_once(word));
        sides.filter(|(before, _)| is_formula(before)).map(|(_, after)| after.trim().to_owned())
    };
    let clauses = || typed.split([',', ';']).flat_map(|clause| clause.split(" and ")).map(str::trim);
    clauses().any(|clause| changed(clause).is_some()).then(|| {
        let after: Vec<String> =
            clauses().map(|clause| changed(clause).unwrap_or_else(|| without_remark(clause).to_owned())).collect();
        after.join(", ")
    })
}

/// What a sphere has along a line before an impact and after it, for `A: -1/√2 → 1/√2`.
pub(super) fn before_and_after(typed: &str) -> Option<String> {
    let (sphere, change) = typed.split_once(':')?;
    let (before, after) = ["→", "->", "⟶"].iter().find_map(|arrow| change.split_once(arrow))?;
    let is_value = |side: &str| {
        side.contains(|sign: char| sign.is_ascii_digit()) && !side.contains(|sign: char| "=<>,;:→".contains(sign))
    };
    let is_change = matches!(sphere.trim(), "A" | "B") && is_value(before) && is_value(after);
    is_change.then(|| format!("{} before {}, after {}", sphere.trim(), before.trim(), after.trim()))
}

/// A line without what it says at its end of a component that stays as it is: `, which remains the same`.
pub(super) fn without_remark(typed: &str) -> &str {
    const AROUND: [char; 7] = [' ', ',', ';', '-', '–', '(', ':'];
    let unstopped = typed.trim_end_matches([' ', '.', ')']);
    if let Some(before) = NO_CHANGE.iter().find_map(|words| unstopped.strip_suffix(words)) {
        return before.trim_end_matches(AROUND);
    }
    let words = typed.rsplit(' ').take_while(|word| {
        let word = word.trim_matches(['(', ')', ',', '.', ';']);
        STAYS.contains(&word) || BESIDE_STAYS.contains(&word)
    });
    let words: Vec<&str> = words.collect();
    let says_so = words.iter().any(|word| STAYS.contains(&word.trim_matches(['(', ')', ',', '.', ';'])));
    let length: usize = words.iter().map(|word| word.len() + 1).sum();
    match typed.len().checked_sub(length).filter(|length| says_so && *length > 0) {
        Some(length) => without_open_words(typed[..length].trim_end_matches([' ', ',', ';', '-', '–'])),
        None => typed,
    }
}

/// Without words behind a bracket that nothing closes: `8 sin 48° (vertical` is left of `8 sin 48° (vertical, stays the same)`.
fn without_open_words(typed: &str) -> &str {
    let is_in_words = |inside: &str| inside.chars().all(|sign| sign.is_alphabetic() || " ,;-".contains(sign));
    let open = typed.rsplit_once('(').filter(|(_, inside)| is_in_words(inside));
    open.map_or(typed, |(before, _)| before.trim_end())
}

/// Words that say of a component that it stays as it is, and others that stand with them.
const STAYS: [&str; 8] = ["unchanged", "same", "stay", "stays", "remain", "remains", "unaffected", "constant"];
const BESIDE_STAYS: [&str; 9] = ["is", "are", "the", "as", "before", "which", "both", "after", "impact"];
/// The same by what it does not do.
const NO_CHANGE: [&str; 8] = [
    "doesn't change",
    "doesn’t change",
    "doesnt change",
    "does not change",
    "don't change",
    "dont change",
    "do not change",
    "no change",
];

/// Is it a function or `sinθ`, which looks like a word, perhaps with a letter before it: `xcosθ`?
pub(super) fn is_formula(word: &str) -> bool {
    let mut signs = word.chars();
    let is_one = |word: &str| is_function(word);
    is_one(word)
        || signs.next().is_some_and(char::is_alphabetic)
            && ["sin", "cos", "tan"].iter().any(|name| signs.as_str().starts_with(name))
            && is_one(signs.as_str())
}

fn is_function(word: &str) -> bool {
    let of_angle = |function: &str| {
        let angle = word.strip_prefix(function).unwrap_or_default();
        angle.chars().count() == 1 || FUNCTIONS.contains(&angle)
    };
    FUNCTIONS.contains(&word) || ["sin", "cos", "tan"].iter().any(|function| of_angle(function))
}

/// Words with which a sentence goes on to its formula.
const LEAD_INS: [&str; 22] = [
    "which gives",
    "this gives",
    "and so",
    "i.e.",
    "i.e",
    "ie",
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
