//! What the author says of a question besides: slips that its numbers hide, slips that look alike, answers worked out by
//! hand.

use super::super::document::{Faults, listed};
use super::super::file::{QuestionFile, TestFile};
use super::super::literal::Words;
use super::super::question::{AuthorsTest, Part, Style};
use super::names::{Also, NamesUsed};
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

/// Checks what a file declares; `reference` are its reference numbers and the place of their style.
pub fn declared(
    file: &QuestionFile,
    styles: &[Style],
    parts: &[Part],
    reference: (&[(String, Expr)], usize),
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Declared {
    faults.twice("the slip", &[], &file.hidden);
    faults.twice("the pair", &[], &file.alike);
    let hidden = file.hidden.iter().filter_map(|words| slip(words.get_ref(), words, faults)).collect();
    let alike = file.alike.iter().filter_map(|words| pair(words, faults)).collect();
    let mut tests = Vec::new();
    for written in &file.tests {
        tests.extend(test(written, styles, parts, reference, used, faults));
    }
    Declared { hidden, alike, tests }
}

fn slip(tag: &str, words: &Words, faults: &mut Faults) -> Option<String> {
    let tag = tag.trim();
    let tags: Vec<&str> = Slip::all().iter().map(|(_, slip)| slip.tag).collect();
    if tags.contains(&tag) {
        return Some(tag.to_owned());
    }
    let label = "docs/marking.md lists the slips of every law".to_owned();
    faults.unknown(words.span(), format!("unknown slip `{tag}`"), label, tag, tags);
    None
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

fn test(
    written: &TestFile,
    styles: &[Style],
    parts: &[Part],
    reference: (&[(String, Expr)], usize),
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Option<AuthorsTest> {
    let style = match &written.style {
        None => reference.1,
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
        let known = own.iter().find(|(own, _)| own == name).or(reference.0.iter().find(|(own, _)| own == name));
        match known {
            Some(known) => numbers.push(known.clone()),
            None => faults.report(
                written.span.clone(),
                format!("the test gives no number for `{name}`"),
                "and the reference has none",
                format!("add it to the test: `numbers = {{ {name} = \"…\" }}`"),
            ),
        }
    }
    let asked: Vec<String> = parts.iter().flat_map(|part| &part.answers).map(|answer| answer.find.name()).collect();
    let is_strange = |name: &String| !asked.is_empty() && !asked.contains(name);
    for (name, _) in written.answers.iter().filter(|(name, _)| is_strange(name.get_ref())) {
        let text = name.get_ref();
        let label = format!("the question asks for {}", listed(&asked));
        let known = asked.iter().map(String::as_str);
        faults.unknown(name.span(), format!("`{text}` is not asked for"), label, text, known);
    }
    let answers = written.answers.iter().map(|(name, words)| (name.get_ref().clone(), words.get_ref().clone()));
    Some(AuthorsTest { span: written.span.clone(), style, numbers, answers: answers.collect() })
}
