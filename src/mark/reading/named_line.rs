//! The line that a label names: `angle with the tangent`, `θ to AB`. Its words are those that name a line beside a value.

use super::wording::{A_TO_B, AFTER_A_LINE, ANGLE, B_TO_A, CENTRES, TANGENT};
use super::{ReferenceLine, centres};
use ReferenceLine::{CommonTangent, FromAToB, FromBToA, I, J, LineAB, LineOfCentres};

/// What line a text names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NamedLine {
    /// One that is known.
    Known(ReferenceLine),
    /// One of which nobody can tell how it lies, or several.
    Unknown,
}

/// The line that words name, if they name any; **i** and **j** are known where the answer is of vectors.
pub(crate) fn named_line(text: &str, vectors: bool) -> Option<NamedLine> {
    let words: Vec<String> = text
        .split(|sign: char| !sign.is_alphanumeric())
        .filter(|word| !matches!(*word, "" | "the" | "The" | "a" | "an" | "its" | "their"))
        .map(str::to_lowercase)
        .collect();
    let mut found: Option<NamedLine> = None;
    let mut at = 0;
    while at < words.len() {
        let Some((line, length)) = line_at(&words, at, vectors) else {
            at += 1;
            continue;
        };
        at += length;
        found = Some(match found {
            None => line,
            Some(before) => both(before, line),
        });
    }
    let turned_back = |line| line == NamedLine::Known(I) && text.contains(['-', '−']);
    if found.is_some_and(turned_back) { Some(NamedLine::Unknown) } else { found }
}

/// `line of centres AB` is one line.
fn both(one: NamedLine, other: NamedLine) -> NamedLine {
    match (one, other) {
        _ if one == other => one,
        (NamedLine::Known(LineOfCentres), NamedLine::Known(line)) if line.unsensed() == LineOfCentres => other,
        (NamedLine::Known(line), NamedLine::Known(LineOfCentres)) if line.unsensed() == LineOfCentres => one,
        _ => NamedLine::Unknown,
    }
}

/// The line that is named from this word on, and by how many words.
fn line_at(words: &[String], at: usize, vectors: bool) -> Option<(NamedLine, usize)> {
    let is_across = matches!(words[at].as_str(), "perpendicular" | "perp" | "normal");
    let is_to = |at: usize| words.get(at).is_some_and(|word| matches!(word.as_str(), "to" | "of" | "from"));
    if is_across
        && is_to(at + 1)
        && let Some((line, length)) = plain_line(words, at + 2)
    {
        let turned = match line.unsensed() {
            LineOfCentres => NamedLine::Known(CommonTangent),
            CommonTangent => NamedLine::Known(LineOfCentres),
            _ => NamedLine::Unknown,
        };
        return Some((turned, length + 2));
    }
    if let Some((line, length)) = plain_line(words, at) {
        let next = at + length;
        // `tangent of the angle` is a number.
        let is_ratio =
            line == CommonTangent && is_to(next) && !AFTER_A_LINE.iter().any(|more| stands(words, next, more));
        return (!is_ratio).then_some((NamedLine::Known(line), length));
    }
    let measures = |word: &String| ANGLE.contains(&word.as_str()) || matches!(word.as_str(), "between" | "and");
    at.checked_sub(1).and_then(|before| words.get(before)).filter(|word| measures(word))?;
    match words[at].as_str() {
        "i" if vectors => Some((NamedLine::Known(I), 1)),
        "j" if vectors => Some((NamedLine::Known(J), 1)),
        "i" | "j" | "horizontal" | "vertical" | "perpendicular" | "perp" => Some((NamedLine::Unknown, 1)),
        _ => None,
    }
}

/// A line of centres or a tangent by its own name, the longest that fits.
fn plain_line(words: &[String], at: usize) -> Option<(ReferenceLine, usize)> {
    let known = [
        (LineOfCentres, &CENTRES[..]),
        (CommonTangent, &TANGENT),
        (LineAB, &["ab"]),
        (FromAToB, &A_TO_B),
        (FromBToA, &B_TO_A),
    ];
    let spelt = known.into_iter().flat_map(|(line, names)| names.iter().map(move |name| (line, *name)));
    let fitting = spelt.filter(|(_, name)| stands(words, at, name));
    let described = centres::described(|at| words.get(at).map(String::as_str), at).map(|end| (LineOfCentres, end - at));
    let named = fitting.map(|(line, name)| (line, name.split(' ').count()));
    named.chain(described).max_by_key(|(_, length)| *length)
}

/// Do these words stand here?
fn stands(words: &[String], at: usize, wanted: &str) -> bool {
    let mut here = words.iter().skip(at);
    wanted.split(' ').all(|word| here.next().is_some_and(|found| found.eq_ignore_ascii_case(word)))
}
