//! What the author says of a question besides: slips that its numbers hide, slips that look alike, answers worked out by
//! hand.

use super::super::document::{Faults, listed};
use super::super::file::{QuestionFile, TestFile};
use super::super::literal::Words;
use super::super::question::{AuthorsTest, Find, Part, Style};
use super::names::{Also, NamesUsed};
use crate::diagnostic::near;
use crate::expr::{Angles, Expr, read_as_written};
use crate::mechanics::Slip;

/// What was declared, checked.
pub struct Declared {
    /// Tags of slips.
    pub hidden: Vec<String>,
    /// Pairs of them.
    pub alike: Vec<(String, String)>,
    /// Tests.
    pub tests: Vec<AuthorsTest>,
}

/// What the answers of a test are compared with.
pub struct Asked<'q> {
    /// The styles of the question.
    pub styles: &'q [Style],
    /// Its parts, as far as they could be read.
    pub parts: &'q [Part],
    /// Its reference numbers.
    pub reference: &'q [(String, Expr)],
    /// The place of their style.
    pub reference_style: usize,
}

/// Checks what a file declares of a question.
pub fn declared(file: &QuestionFile, question: &Asked, used: &mut NamesUsed, faults: &mut Faults) -> Declared {
    faults.twice("the slip", &[], &file.hidden);
    faults.twice("the pair", &[], &file.alike);
    let hidden = hidden(&file.hidden, faults);
    let alike = file.alike.iter().filter_map(|words| pair(words, faults)).collect();
    let written: usize = file.parts.iter().map(|part| part.answers.len()).sum();
    let read: usize = question.parts.iter().map(|part| part.answers.len()).sum();
    let mut tests = Vec::new();
    for test in &file.tests {
        let Some((style, numbers)) = numbers_of(test, question, used, faults) else { continue };
        // Of an answer that cannot be read nothing is known.
        if read == written {
            strange_answers(test, question.parts, faults);
        }
        let answers = test.answers.iter().map(|(name, words)| (name.get_ref().clone(), words.get_ref().clone()));
        tests.push(AuthorsTest { span: test.span.clone(), style, numbers, answers: answers.collect() });
    }
    Declared { hidden, alike, tests }
}

/// The slips of a list; several that nobody knows are one fault.
fn hidden(list: &[Words], faults: &mut Faults) -> Vec<String> {
    let is_known = |words: &&Words| known(words.get_ref()).is_some();
    let unknown: Vec<&Words> = list.iter().filter(|words| !is_known(words)).collect();
    if let [first, .., last] = unknown.as_slice() {
        let names: Vec<&str> = unknown.iter().map(|words| words.get_ref().trim()).collect();
        let instead = |name: &str| near(name, tags()).map(|near| format!("`{near}` for `{name}`"));
        let instead: Vec<String> = names.iter().filter_map(|name| instead(name)).collect();
        let help = match instead.as_slice() {
            [] => "take them out; `carom check` then names the slips that belong there".to_owned(),
            some => format!("did you mean {}? Take out what is none", some.join(", ")),
        };
        let message = format!("unknown slips {}", listed(&names));
        faults.report(first.span().start..last.span().end, message, LISTED, help);
    } else if let [words] = unknown.as_slice() {
        slip(words.get_ref(), words, faults);
    }
    list.iter().filter_map(|words| known(words.get_ref())).collect()
}

/// Where an author finds the names of slips.
const LISTED: &str = "docs/marking.md lists the slips of every law";

fn tags() -> Vec<&'static str> {
    Slip::all().iter().map(|(_, slip)| slip.tag).collect()
}

fn known(tag: &str) -> Option<String> {
    tags().contains(&tag.trim()).then(|| tag.trim().to_owned())
}

fn slip(tag: &str, words: &Words, faults: &mut Faults) -> Option<String> {
    let found = known(tag);
    if found.is_none() {
        let tag = tag.trim();
        faults.unknown(words.span(), format!("unknown slip `{tag}`"), LISTED.to_owned(), tag, tags());
    }
    found
}

fn pair(words: &Words, faults: &mut Faults) -> Option<(String, String)> {
    let Some((one, other)) = words.get_ref().split_once('=') else {
        let help = "write `\"e-taken-as-1 = coalesce\"`";
        faults.report(words.span(), "one slip alone is like no other", "expected two, `one = other`", help);
        return None;
    };
    let (one, other) = (slip(one, words, faults)?, slip(other, words, faults)?);
    if one == other {
        let help = "write the other slip that it cannot be told from, or take the pair out";
        faults.report(words.span(), format!("`{one}` is like itself"), "expected two different slips", help);
        return None;
    }
    Some((one, other))
}

/// The place of the style of a test, and its numbers: its own, and those of the reference besides.
fn numbers_of(
    written: &TestFile,
    question: &Asked,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Option<(usize, Vec<(String, Expr)>)> {
    let Asked { styles, reference, reference_style, .. } = *question;
    let style = match &written.style {
        None => reference_style,
        Some(words) => {
            let names: Vec<&str> = styles.iter().map(|style| style.name.name()).collect();
            match names.iter().position(|name| *name == words.get_ref().as_str()) {
                Some(place) => place,
                None => {
                    let label = format!("the question has {}", listed(&names));
                    let text = words.get_ref();
                    faults.unknown(words.span(), format!("no style `{text}` here"), label, text, names);
                    return None;
                }
            }
        }
    };
    let mut own: Vec<(String, Expr)> = Vec::new();
    for (name, words) in &written.numbers {
        match read_as_written(words.get_ref(), Angles::Degrees) {
            Ok(expr) => {
                used.expression(words, &expr, Also::OnlyLetters, None, faults);
                own.push((name.get_ref().clone(), expr));
            }
            Err(fault) => faults.expression(words, fault),
        }
    }
    let names: Vec<&str> = styles.get(style)?.parameters.iter().map(|(name, _)| name.as_str()).collect();
    for (name, _) in written.numbers.iter().filter(|(name, _)| !names.contains(&name.get_ref().as_str())) {
        let label = format!("style `{}` has {}", styles[style].name, listed(&names));
        let text = name.get_ref();
        faults.unknown(name.span(), format!("`{text}` is no parameter"), label, text, names.iter().copied());
    }
    let mut numbers = Vec::new();
    for name in &names {
        let known = own.iter().chain(reference).find(|(own, _)| own == name);
        match known {
            Some(known) => numbers.push(known.clone()),
            // What the reference lacks is its own fault.
            None if style == reference_style => {}
            None => faults.report(
                written.span.clone(),
                format!("the test gives no number for `{name}`"),
                "and the reference has none",
                format!("add it to the test: `numbers = {{ {name} = \"…\" }}`"),
            ),
        }
    }
    Some((style, numbers))
}

/// What a test answers, and nobody asks for.
fn strange_answers(written: &TestFile, parts: &[Part], faults: &mut Faults) {
    let answers = || parts.iter().flat_map(|part| &part.answers);
    let asked: Vec<String> = answers().map(|answer| answer.find.name()).collect();
    for (name, _) in written.answers.iter().filter(|(name, _)| !asked.contains(name.get_ref())) {
        let text = name.get_ref();
        let is_second = |find: &Find| matches!(find, Find::Vector(_, y) if y.to_string() == *text);
        if let Some(find) = answers().map(|answer| &answer.find).find(|find| is_second(find)) {
            let first = find.name();
            let help = format!("write both at the first: `\"{first}\" = \"3i + 4j\"`");
            faults.report(name.span(), format!("`{text}` is asked for with `{first}`"), "one vector", help);
            continue;
        }
        let label = format!("the question asks for {}", listed(&asked));
        let known = asked.iter().map(String::as_str);
        faults.unknown(name.span(), format!("`{text}` is not asked for"), label, text, known);
    }
}
