//! Several equations in one line: `Momentum: 6 cos 30° = 3v + w. Since e = ½, w − v = cos 30°, which gives v = 1.08`.

use super::remarks::is_formula;
use crate::mark::reading::{names_a_quantity, turns_round};

/// A line in its steps: where a new sentence begins, and where an equation follows from what stands before it.
pub(super) fn steps(line: &str) -> Vec<&str> {
    let (mut found, mut start) = (Vec::new(), 0);
    for parting in partings(line) {
        let step = &line[start..parting.end];
        // What leads to an equation stays before it.
        let next = if parting.kind == Kind::Conclusion { parting.start } else { parting.end };
        if parting.kind != Kind::Joint && has_equation(&line[start..parting.start]) && has_equation(&line[next..]) {
            found.push(if next == parting.end { step } else { line[start..next].trim_end().trim_end_matches(',') });
            start = next;
        }
    }
    found.push(&line[start..]);
    found.into_iter().map(str::trim).filter(|step| !step.is_empty()).collect()
}

/// The equations of a sentence with commas between them, each without the words before it; nothing where there are not two.
///
/// What has a name keeps it: `speed of A = 3`. Values that words stand before are kept with them.
pub(super) fn equations_in_sentence(typed: &str) -> Option<String> {
    let mut start = 0;
    let mut clauses: Vec<&str> = Vec::new();
    for parting in partings(typed) {
        clauses.push(&typed[start..parting.start]);
        start = parting.end;
    }
    clauses.push(&typed[start..]);
    // `Let k = u/√5, so the components are 2k along and k across`
    let is_let = typed.get(..4).is_some_and(|start| start.eq_ignore_ascii_case("let "));
    let mut kept: Vec<&str> = Vec::new();
    let mut equations = 0;
    for clause in clauses.into_iter().map(str::trim).filter(|clause| !clause.is_empty()) {
        if clause.split_whitespace().any(turns_round) {
            return None;
        }
        if has_equation(clause) {
            equations += 1;
            kept.push(without_words(clause));
            continue;
        }
        let mut words = clause.split_whitespace().map(bare);
        if !words.clone().any(is_word) {
            return None;
        }
        let is_value = words.any(|word| is_formula(word) || word.contains(|sign: char| sign.is_ascii_digit()));
        kept.extend((is_value && !is_let).then_some(clause));
    }
    (equations > usize::from(!is_let)).then(|| kept.join(", "))
}

/// What stands before a word that draws a conclusion and what follows from it, at each such word: `p = -3 gives m = 2`.
pub(super) fn conclusions(typed: &str) -> impl Iterator<Item = (&str, &str)> {
    let concludes = |parting: &Parting| {
        parting.kind == Kind::Conclusion || typed[parting.start..parting.end].eq_ignore_ascii_case(GIVES)
    };
    let found = partings(typed).into_iter().filter(concludes);
    found.map(|parting| (typed[..parting.start].trim(), typed[parting.end..].trim()))
}

/// Where two clauses part.
struct Parting {
    /// Where the stop, arrow or joining word begins, and where it ends.
    start: usize,
    end: usize,
    kind: Kind,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// The end of a sentence, or of a column.
    Stop,
    /// `so`, `⇒`
    Conclusion,
    /// A comma, `and`.
    Joint,
}

/// Words from which a conclusion follows, and words that only join.
const CONCLUSIONS: [&str; 8] = [" so ", " giving ", " which gives ", " hence ", " therefore ", " thus ", " => ", " ⇒ "];
/// It joins the steps of one line.
const GIVES: &str = " gives";
const JOINTS: [&str; 6] = [" and ", " gives ", " then ", " also ", " but ", " // "];

/// The commas, stops, arrows and joining words that stand outside brackets.
fn partings(typed: &str) -> Vec<Parting> {
    let (mut found, mut sentence, mut depth, mut at) = (Vec::new(), 0, 0_usize, 0);
    while let Some(sign) = typed[at..].chars().next() {
        match sign {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        let after = &typed[at + sign.len_utf8()..];
        let is_apart = after.is_empty() || after.starts_with(char::is_whitespace);
        let begins_with =
            |word: &&&str| typed[at..].get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word));
        // The blank behind a word may stand before the next.
        let length = |word: &&str| word.len() - 1;
        let parting = match sign {
            '\t' => Some((1, Kind::Stop)),
            '.' => (is_apart && has_equation(&typed[sentence..at])).then_some((1, Kind::Stop)),
            '=' if after.starts_with('>') => Some((2, Kind::Conclusion)),
            '⇒' | '⟹' => Some((sign.len_utf8(), Kind::Conclusion)),
            ';' | '→' | '∴' => Some((sign.len_utf8(), Kind::Joint)),
            ',' => is_apart.then_some((1, Kind::Joint)),
            ' ' => {
                let conclusion = CONCLUSIONS.iter().find(begins_with).map(|word| (length(word), Kind::Conclusion));
                conclusion.or_else(|| JOINTS.iter().find(begins_with).map(|word| (length(word), Kind::Joint)))
            }
            _ => None,
        };
        let parting = parting.filter(|_| depth == 0);
        if let Some((length, kind)) = parting {
            found.push(Parting { start: at, end: at + length, kind });
            sentence = at + length;
        }
        at += parting.map_or(sign.len_utf8(), |(length, _)| length);
    }
    found
}

/// Does an equals sign stand here that is none of an inequality, nor of an arrow?
fn has_equation(typed: &str) -> bool {
    ["=>", ">=", "<=", "=<"].iter().fold(typed.to_owned(), |typed, sign| typed.replace(sign, " ")).contains('=')
}

/// An equation without the words before it, unless they name what it is about.
fn without_words(clause: &str) -> &str {
    // `A: -J = 6(v - 11); B: J = 4(w - 3)`: the equation says by itself of which sphere it is.
    let of_sphere = ["A:", "B:"].iter().find_map(|sphere| clause.strip_prefix(sphere)).map(str::trim_start);
    let is_impulse = |side: &str| matches!(side.trim().trim_start_matches(['-', '−']), "I" | "J");
    if let Some(impulse) = of_sphere.filter(|equation| equation.split('=').next().is_some_and(is_impulse)) {
        return impulse;
    }
    let left = &clause[..clause.find('=').unwrap_or(0)];
    // Each word with the blank behind it.
    let lengths = left.split_inclusive(char::is_whitespace).scan(0, |end, word| {
        *end += word.len();
        Some((word.trim_end(), *end))
    });
    let Some((_, end)) = lengths.filter(|(word, _)| is_word(bare(word))).last() else { return clause };
    let (words, rest) = clause.split_at(end);
    let is_of_law = |word: &str| LAWS.contains(&word.to_lowercase().as_str());
    let names = |word: &str| COMPONENTS.contains(&word) || (names_a_quantity(word) && !is_of_law(word));
    let is_name = words.split_whitespace().map(bare).any(names);
    let formula = rest[..rest.find('=').unwrap_or(0)].trim();
    let is_in_words = |word: &str| word.len() > 1 && word.chars().all(char::is_alphabetic) && !is_formula(word);
    if is_name || formula.is_empty() || formula.split_whitespace().any(is_in_words) { clause } else { rest.trim() }
}

/// Names of laws that are names of quantities too.
const LAWS: [&str; 2] = ["momentum", "restitution"];

/// Words that tell a component.
const COMPONENTS: [&str; 9] =
    ["along", "across", "perp", "perpendicular", "parallel", "para", "normal", "tangential", "wall"];

fn bare(word: &str) -> &str {
    word.trim_matches(['(', ')', '.', ',', ':', '\'', '’'])
}

/// Is it a word of a sentence, and no formula?
fn is_word(word: &str) -> bool {
    word.chars().count() >= 3 && word.chars().all(char::is_alphabetic) && !is_formula(word)
}
