//! Styles checked: parameters, derived names, stems and requirements, the question's and the style's own.

use std::ops::Range;

use super::super::document::Faults;
use super::super::domain::Domain;
use super::super::file::{DomainFile, QuestionFile, StyleFile};
use super::super::givens::names_in_degrees;
use super::super::literal::Words;
use super::super::question::{Style, StyleName};
use super::super::requirement::Requirement;
use super::names::{Also, DERIVED, NamesUsed, RESERVED, Scope};
use crate::expr::{
    Angles, Expr, Fault, Function, Markup, Span, Text, evaluate, number, read, read_as_written, read_markup,
};
use crate::mechanics::Quantity;
use crate::number::Value;

/// What is written once for every style.
struct Shared {
    stem: Option<Markup>,
    parameters: Vec<Given<Domain>>,
    lets: Vec<Given<Expr>>,
    require: Vec<Requirement>,
}

/// A name with its meaning and its place.
#[derive(Clone)]
struct Given<T> {
    name: String,
    span: Range<usize>,
    meaning: T,
}

/// Every style of a file, with the names that have a meaning in it.
pub fn styles(file: &QuestionFile, used: &mut NamesUsed, faults: &mut Faults) -> (Vec<Style>, Vec<(String, Scope)>) {
    let letters = file.scene.as_ref().map(|scene| scene.letters()).unwrap_or_default();
    let shared = Shared {
        stem: file.stem.as_ref().and_then(|stem| markup(stem, None, used, faults)),
        parameters: parameters(&file.parameters, &letters, None, used, faults),
        lets: lets(&file.lets, &letters, None, used, faults),
        require: require(&file.require, &[], None, used, faults),
    };
    let (mut styles, mut scopes) = (Vec::new(), Vec::new());
    for (index, style) in file.styles.iter().enumerate() {
        let name = style_name(&style.name, faults);
        let (checked, scope) =
            one_style(index, name.unwrap_or(StyleName::Exact), style, (&shared, file), &letters, used, faults);
        styles.push(checked);
        scopes.push((style.name.get_ref().clone(), scope));
    }
    (styles, scopes)
}

fn style_name(name: &Words, faults: &mut Faults) -> Option<StyleName> {
    let text = name.get_ref().as_str();
    let found = StyleName::ALL.into_iter().find(|style| style.name() == text);
    if found.is_none() {
        let label = "expected `friendly`, `exact` or `calculator`".to_owned();
        faults.unknown(
            name.span(),
            format!("unknown style `{text}`"),
            label,
            text,
            StyleName::ALL.map(StyleName::name),
        );
    }
    found
}

fn one_style(
    index: usize,
    name: StyleName,
    style: &StyleFile,
    (shared, file): (&Shared, &QuestionFile),
    letters: &[&str],
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> (Style, Scope) {
    let own_stem = style.stem.as_ref().and_then(|stem| markup(stem, Some(index), used, faults));
    let own_parameters = parameters(&style.parameters, letters, Some(index), used, faults);
    let own_lets = lets(&style.lets, letters, Some(index), used, faults);
    let mut all_require = shared.require.clone();
    all_require.extend(require(&style.require, &file.require, Some(index), used, faults));

    // A style that gives a parameter a formula, or a derived name values, has the last word.
    let hidden = |name: &str| own_lets.iter().any(|own| own.name == name);
    let mut all_parameters: Vec<Given<Domain>> =
        shared.parameters.iter().filter(|given| !hidden(&given.name)).cloned().collect();
    override_with(&mut all_parameters, own_parameters.clone());
    let hidden = |name: &str| own_parameters.iter().any(|own| own.name == name);
    let mut all_lets: Vec<Given<Expr>> = shared.lets.iter().filter(|given| !hidden(&given.name)).cloned().collect();
    override_with(&mut all_lets, own_lets);

    for derived in &all_lets {
        if let Some(parameter) = all_parameters.iter().find(|parameter| parameter.name == derived.name) {
            let span = derived.span.start.max(parameter.span.start);
            let span = if span == derived.span.start { derived.span.clone() } else { parameter.span.clone() };
            faults.report(
                span,
                format!("`{}` is both a parameter and a derived name", derived.name),
                "it has a meaning already",
                "rename one of the two",
            );
        }
    }
    count(style.name.span(), &all_parameters, faults);
    let scope = Scope {
        given: all_parameters
            .iter()
            .map(|given| (given.name.clone(), given.span.clone(), "parameter"))
            .chain(all_lets.iter().map(|given| (given.name.clone(), given.span.clone(), DERIVED)))
            .collect(),
    };
    let checked = Style {
        name,
        note: style.note.as_ref().and_then(|note| line(note, Some(index), used, faults)).unwrap_or_default(),
        stem: own_stem.or_else(|| shared.stem.clone()).unwrap_or_default(),
        parameters: all_parameters.into_iter().map(|given| (given.name, given.meaning)).collect(),
        lets: all_lets.into_iter().map(|given| (given.name, given.meaning)).collect(),
        require: all_require,
    };
    (checked, scope)
}

/// Those of the same name are replaced where they stand, the others follow.
fn override_with<T>(all: &mut Vec<Given<T>>, own: Vec<Given<T>>) {
    for given in own {
        match all.iter_mut().find(|known| known.name == given.name) {
            Some(known) => *known = given,
            None => all.push(given),
        }
    }
}

/// The sets of parameters must be countable.
fn count(span: Range<usize>, parameters: &[Given<Domain>], faults: &mut Faults) {
    let size = parameters.iter().try_fold(1u64, |size, given| size.checked_mul(given.meaning.size()));
    if size.is_none() {
        faults.report(
            span,
            "the style has too many sets of parameters",
            format!("more than {} of them", u64::MAX),
            "give the parameters fewer values",
        );
    }
}

/// Paragraphs of words and formulas.
pub fn markup(words: &Words, style: Option<usize>, used: &mut NamesUsed, faults: &mut Faults) -> Option<Markup> {
    match read_markup(words.get_ref()) {
        Ok(paragraphs) => {
            for text in &paragraphs {
                used.text(words, text, style, faults);
            }
            Some(paragraphs)
        }
        Err(fault) => {
            faults.expression(words, fault);
            None
        }
    }
}

/// Words on one line.
pub fn line(words: &Words, style: Option<usize>, used: &mut NamesUsed, faults: &mut Faults) -> Option<Text> {
    let mut paragraphs = markup(words, style, used, faults)?;
    if paragraphs.len() > 1 {
        let help = "take the blank lines out of it";
        faults.report(words.span(), "words in several paragraphs", "expected words for one line", help);
        return None;
    }
    Some(paragraphs.pop().unwrap_or_default())
}

fn parameters(
    written: &[(Words, DomainFile)],
    letters: &[&str],
    style: Option<usize>,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Vec<Given<Domain>> {
    let mut found = Vec::new();
    for (name, domain) in written {
        new_name("parameter", name, letters, faults);
        // A parameter whose values are at fault is there all the same, so that its uses are no faults.
        let meaning = read_domain(name, domain, style, used, faults).unwrap_or(Domain::List(vec![Expr::integer(1)]));
        found.push(Given { name: name.get_ref().clone(), span: name.span(), meaning });
    }
    found
}

fn read_domain(
    name: &Words,
    domain: &DomainFile,
    style: Option<usize>,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Option<Domain> {
    let read_value = |words: &Words, used: &mut NamesUsed, faults: &mut Faults| {
        let expr =
            read_as_written(words.get_ref(), Angles::Degrees).map_err(|fault| faults.expression(words, fault)).ok()?;
        used.expression(words, &expr, Also::OnlyLetters, style, faults);
        if let (true, Err(fault)) = (expr.names().is_empty(), evaluate(&expr, &|_| None)) {
            let help = fault.help.unwrap_or_else(|| "write another value, or take it out".to_owned());
            faults.expression(words, Fault { span: Span::default(), help: Some(help), ..fault });
            return None;
        }
        Some(expr)
    };
    match domain {
        DomainFile::Range(words) if Domain::is_range(words.get_ref()) => {
            Domain::range(words.get_ref()).map_err(|fault| faults.expression(words, fault)).ok()
        }
        DomainFile::Range(words) => Some(Domain::List(vec![read_value(words, used, faults)?])),
        DomainFile::List(items, span) if items.is_empty() => {
            faults.report(
                span.clone(),
                format!("parameter `{}` has no values", name.get_ref()),
                "the list is empty",
                "write `[\"1/4\", \"1/2\"]` or a range `\"2..12\"`",
            );
            None
        }
        DomainFile::List(items, _) => {
            let mut values: Vec<(Expr, Option<Value>)> = Vec::new();
            let mut complete = true;
            for words in items {
                if words.get_ref().contains("..") {
                    faults.report(
                        words.span(),
                        "a range within a list",
                        "expected one value",
                        format!("write the range alone, without brackets: `\"{}\"`", words.get_ref()),
                    );
                    complete = false;
                    continue;
                }
                let Some(value) = read_value(words, used, faults) else {
                    complete = false;
                    continue;
                };
                let known = number(&value, &|_| None).ok();
                let is_it =
                    |(other, number): &(Expr, Option<Value>)| *other == value || (known.is_some() && *number == known);
                if let Some(before) = values.iter().position(is_it) {
                    let label = match items.get(before).map(|other| other.get_ref()) {
                        Some(other) if other != words.get_ref() => format!("it is `{other}`, which was there before"),
                        _ => "it was there before".to_owned(),
                    };
                    faults.report(
                        words.span(),
                        format!("the value `{}` stands in the list twice", words.get_ref()),
                        label,
                        "take one of the two out, so that no variant is dealt twice",
                    );
                }
                values.push((value, known));
            }
            complete.then(|| Domain::List(values.into_iter().map(|(value, _)| value).collect()))
        }
    }
}

fn lets(
    written: &[(Words, Words)],
    letters: &[&str],
    style: Option<usize>,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Vec<Given<Expr>> {
    let mut found: Vec<Given<Expr>> = Vec::new();
    for (name, words) in written {
        new_name(DERIVED, name, letters, faults);
        let meaning = match read(words.get_ref(), Angles::Degrees) {
            Ok(expr) => {
                used.expression(words, &expr, Also::Nothing, style, faults);
                check_order(name, words, &expr, &written[found.len()..], faults);
                names_in_degrees(&expr)
            }
            Err(fault) => {
                faults.expression(words, fault);
                Expr::integer(1)
            }
        };
        found.push(Given { name: name.get_ref().clone(), span: name.span(), meaning });
    }
    found
}

/// A derived name may use those before it, and not itself; `rest` are it and those that follow.
fn check_order(name: &Words, words: &Words, expr: &Expr, rest: &[(Words, Words)], faults: &mut Faults) {
    for used in expr.names() {
        if !rest.iter().any(|(later, _)| *later.get_ref() == used.text) {
            continue;
        }
        let (name, other) = (name.get_ref().as_str(), used.text.as_str());
        let (message, help) = if name == other {
            (format!("`{name}` is derived from itself"), "derive it from other names")
        } else if leads_to(other, name, rest, &mut Vec::new()) {
            let message = format!("`{name}` and `{other}` are derived from each other");
            (message, "derive one of the two from the parameters alone")
        } else {
            let message = format!("`{name}` is derived from `{other}`, which comes later");
            (message, "put the names in the order in which they follow")
        };
        faults.report(faults.place(words, used.span), message, "not known here yet", help);
    }
}

/// Is a derived name needed, by way of others or not, for another?
fn leads_to(from: &str, to: &str, all: &[(Words, Words)], seen: &mut Vec<String>) -> bool {
    if seen.iter().any(|name| name == from) {
        return false;
    }
    seen.push(from.to_owned());
    let Some((_, words)) = all.iter().find(|(name, _)| name.get_ref() == from) else { return false };
    let Ok(expr) = read(words.get_ref(), Angles::Degrees) else { return false };
    expr.names().iter().any(|name| name.text == to || leads_to(&name.text, to, all, seen))
}

/// A new name must be one, and must not mean something already.
fn new_name(what: &str, name: &Words, letters: &[&str], faults: &mut Faults) {
    let text = name.get_ref().as_str();
    let is_name = text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let is_function = Function::ALL.iter().any(|function| function.name() == text);
    let (message, label) = if !is_name {
        (format!("`{text}` cannot be a name"), "expected a letter, then letters, digits or `_`".to_owned())
    } else if letters.contains(&text) {
        (
            format!("{what} `{text}` is also a letter of the scene"),
            "a letter keeps its name and has no values".to_owned(),
        )
    } else if RESERVED.contains(&text) || is_function {
        (format!("{what} `{text}` has a meaning already"), format!("`{text}` is part of the expression language"))
    } else if text != "e" && text.parse::<Quantity>().is_ok() {
        (format!("{what} `{text}` has the name of a quantity"), "a requirement could not tell them apart".to_owned())
    } else {
        return;
    };
    let help = match is_name {
        true => format!("choose another name, such as `{text}_1`"),
        false => "choose a name such as `u`, `mA` or `alpha`".to_owned(),
    };
    faults.report(name.span(), message, label, help);
}

fn require(
    written: &[Words],
    before: &[Words],
    style: Option<usize>,
    used: &mut NamesUsed,
    faults: &mut Faults,
) -> Vec<Requirement> {
    faults.twice("the requirement", before, written);
    let mut found = Vec::new();
    for words in written {
        match Requirement::read(words.get_ref()) {
            Ok(requirement) => {
                for name in requirement.names() {
                    used.name(words, name, Also::Quantities, style, faults);
                }
                if requirement.is_constant() {
                    let message = format!("requirement `{}` has no name in it", words.get_ref());
                    let help = "name a parameter or a result in it, `mA > 2`, or take it out";
                    faults.report(words.span(), message, "it says nothing about the question", help);
                }
                found.push(requirement);
            }
            Err(fault) => faults.expression(words, fault),
        }
    }
    found
}
