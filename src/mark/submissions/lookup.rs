//! What a person calls a question, a part, a blank or a mark, looked up in the key; or what there is instead.

use crate::diagnostic::near;
use crate::expr::print::words_unicode;
use crate::mark::key::{AnswerKey, KeyedPaper, KeyedPart, KeyedQuestion};

/// The longest piece of what a person typed that a reason repeats.
const SHOWN: usize = 60;

/// The paper of a student.
pub(super) fn paper<'k>(key: &'k AnswerKey, student: &str) -> Result<&'k KeyedPaper, String> {
    if student.is_empty() {
        return Err("whose is this? the student is not named".to_owned());
    }
    if let Some(paper) = key.paper(student) {
        return Ok(paper);
    }
    let named: Vec<&KeyedPaper> = key.papers.iter().filter(|paper| same_name(&paper.name, student)).collect();
    match named.as_slice() {
        [only] => Ok(only),
        [] => Err(no_paper(key, student)),
        several => {
            let each: Vec<String> = several.iter().filter_map(|paper| Some(shown(paper.student.as_deref()?))).collect();
            Err(format!("several students are called {}; they {}", shown(student), are(&each)))
        }
    }
}

/// Is it the same name, however it is spaced and whatever its capitals?
fn same_name(name: &str, typed: &str) -> bool {
    let words = |text: &str| text.split_whitespace().map(str::to_lowercase).collect::<Vec<_>>();
    !name.is_empty() && words(name) == words(typed)
}

/// That nobody of the class is called so, and how they are called.
fn no_paper(key: &AnswerKey, student: &str) -> String {
    let students: Vec<&str> = key.papers.iter().filter_map(|paper| paper.student.as_deref()).collect();
    let names = key.papers.iter().map(|paper| paper.name.as_str()).filter(|name| !name.is_empty());
    let help = match near(student, students.iter().copied().chain(names)) {
        Some(near) => format!("did you mean {}?", shown(near)),
        None => match students.as_slice() {
            [] => "it has no paper at all".to_owned(),
            [only] => format!("its one student is {}", shown(only)),
            [first, .., last] => format!("its {} students are {} to {}", students.len(), shown(first), shown(last)),
        },
    };
    format!("the key has no paper for {}; {help}", shown(student))
}

/// The places of a question and of a part of it; `7(b)` may name both where nothing else names the part.
///
/// # Errors
///
/// Why there is none, and which of the two names is at fault, from 0.
pub(super) fn question_and_part(
    paper: &KeyedPaper,
    name: &str,
    label: &str,
) -> Result<(usize, usize), (String, usize)> {
    let found = question(paper, name);
    let is_unparted = found.is_err() && label.trim().is_empty();
    let number_ends = name.rfind(|sign: char| sign.is_ascii_digit()).filter(|_| is_unparted);
    if let Some((number, own)) = number_ends.map(|last| name.split_at(last + 1))
        && own.contains(char::is_alphabetic)
        && let Ok(place) = question(paper, number)
        && let Ok(part) = part(&paper.questions[place], own)
    {
        return Ok((place, part));
    }
    let place = found.map_err(|fault| (fault, 0))?;
    part(&paper.questions[place], label).map(|part| (place, part)).map_err(|fault| (fault, 1))
}

/// A question by its number on the sheet, with `Q` or without, or by its id: its place.
fn question(paper: &KeyedPaper, name: &str) -> Result<usize, String> {
    // As most write it.
    let number = name.parse::<usize>().ok().filter(|_| !name.starts_with(['+', '0']));
    let place = number.and_then(|number| paper.questions.iter().position(|question| question.number == number));
    if let Some(place) = place {
        return Ok(place);
    }
    let lower = name.trim().to_lowercase();
    let number = ["question", "q"].iter().find_map(|word| lower.strip_prefix(word)).unwrap_or(&lower);
    let number = number.trim().trim_end_matches('.').trim_end_matches(".0");
    let is_it = |question: &KeyedQuestion| question.number.to_string() == number || question.id == name.trim();
    paper.questions.iter().position(is_it).ok_or_else(|| {
        let numbers = paper.questions.iter().map(|question| question.number.to_string()).collect::<Vec<_>>();
        if name.trim().is_empty() {
            return format!("no question is named; there {}", are(&numbers));
        }
        let ids = paper.questions.iter().map(|question| question.id.as_str());
        match near(name, ids.filter(|id| id.len() > 4)) {
            Some(near) => format!("no question {} on the sheet; did you mean `{near}`?", shown(name)),
            None => format!("no question {} on the sheet; there {}", shown(name), are(&numbers)),
        }
    })
}

/// A part by its label, with brackets or without: its place.
fn part(question: &KeyedQuestion, name: &str) -> Result<usize, String> {
    if let Some(place) = question.parts.iter().position(|part| part.label == name) {
        return Ok(place);
    }
    let lower = name.trim().to_lowercase();
    let label = lower.strip_prefix("part").unwrap_or(&lower).trim().trim_matches(['(', ')', '.']);
    let found = question.parts.iter().position(|part| part.label.to_lowercase() == label);
    found.ok_or_else(|| {
        let number = question.number;
        let labels: Vec<String> = question.parts.iter().map(|part| part.label.clone()).collect();
        match (labels.as_slice(), label) {
            ([only], _) if only.is_empty() => {
                format!("question {number} has no part {}; it has none: leave `part` empty", shown(name))
            }
            (_, "") => format!("which part of question {number}? there {}", are(&labels)),
            _ => format!("question {number} has no part {}; there {}", shown(name), are(&labels)),
        }
    })
}

/// A blank by its name, however it is spaced: its place.
pub(super) fn blank(part: &KeyedPart, name: &str) -> Result<usize, String> {
    if let Some(place) = part.blanks.iter().position(|blank| blank.name == name) {
        return Ok(place);
    }
    let plain = |name: &str| name.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
    let found = part.blanks.iter().position(|blank| plain(&blank.name) == plain(name));
    found.ok_or_else(|| {
        let names: Vec<&str> = part.blanks.iter().map(|blank| blank.name.as_str()).collect();
        let help = match near(name, names.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there {}", are(&names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>())),
        };
        format!("no blank {}; {help}", shown(name))
    })
}

/// A mark by its id: its place.
pub(super) fn mark(part: &KeyedPart, name: &str) -> Result<usize, String> {
    let found = part.scheme.iter().position(|mark| mark.id.eq_ignore_ascii_case(name.trim()));
    found.ok_or_else(|| {
        let ids: Vec<String> = part.scheme.iter().map(|mark| mark.id.clone()).collect();
        format!("no mark {}; there {}", shown(name), are(&ids))
    })
}

/// What a person typed, for a sentence: in backticks, harmless, and not longer than one reads.
pub(super) fn shown(typed: &str) -> String {
    let typed = words_unicode(typed.trim());
    match typed.char_indices().nth(SHOWN) {
        Some((cut, _)) => format!("`{}…`", &typed[..cut]),
        None => format!("`{typed}`"),
    }
}

/// `is a`, or `are a, b and c`.
fn are(names: &[String]) -> String {
    match names {
        [] => "is none".to_owned(),
        [only] => format!("is {only}"),
        [first, .., last] if names.len() > 12 => format!("are {first} to {last}"),
        [most @ .., last] => format!("are {} and {last}", most.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_question_may_name_its_part() {
        let key = crate::mark::shipped_key("direct/velocities-after-impact", 7);
        for (name, label, found) in [
            ("7", "b", Ok((0, 1))),
            ("7(b)", "", Ok((0, 1))),
            ("Q7b", "", Ok((0, 1))),
            ("7 (b)", " ", Ok((0, 1))),
            ("7b", "b", Err(0)),
            ("7(d)", "", Err(0)),
            ("2b", "", Err(0)),
            ("7", "d", Err(1)),
            ("7", "", Err(1)),
        ] {
            let place = question_and_part(&key.papers[0], name, label).map_err(|(_, cell)| cell);
            assert_eq!(place, found, "`{name}` and `{label}`");
        }
    }
}
