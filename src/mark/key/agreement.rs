//! Does a key agree with itself? What it says twice is said alike, and its answers are those of its collision.
//!
//! Answers are refuted by intervals at fixed points, which is quick: a key of two hundred papers is marked with at once. What
//! intervals cannot tell apart passes.

use std::collections::HashMap;

use serde_json::Value as Json;

use super::{KeyFault, KeyedBlank, KeyedQuestion};
use crate::answer::Kind;
use crate::bank::Find;
use crate::expr::{Angles, Expr, in_degrees, print, read, written, written_angle};
use crate::mark::enclosure::{POINTS, enclose_roughly};
use crate::mechanics::{Known, Quantity};
use crate::number::{Angle, Decimal, FloatInterval, Fraction, Letter, Places, Range, Value, round};
use crate::paper::{Blank, KeyQuestion};
use crate::solve::Solution;

/// Two questions with one number: which of the two a student has answered nobody could tell.
pub(super) fn of_paper(questions: &[KeyQuestion]) -> Vec<KeyFault> {
    twice(questions, |question| question.number)
        .map(|(place, first)| {
            let number = questions[place].number;
            let fault = KeyFault::new(
                format!("there are two questions {number}: `{}` is another", questions[first].id),
                "expected a number that no other question has",
            );
            let help = format!("give it the number on the sheet, such as {}", place + 1);
            KeyFault { help, ..fault.below("number").below(&format!("questions[{place}]")) }
        })
        .collect()
}

/// Each place where a key says of a question what it denies elsewhere.
pub(super) fn of_question(stated: &KeyQuestion, question: &KeyedQuestion) -> Vec<KeyFault> {
    let mut faults = Vec::new();
    for (place, first) in twice(&stated.parts, |part| part.label.clone()) {
        let label = &stated.parts[place].label;
        let message = match label.is_empty() {
            true => "there are two parts without a label".to_owned(),
            false => format!("there are two parts ({label}): `parts[{first}]` is another"),
        };
        let fault = KeyFault::new(message, "expected a label that no other part has");
        let help = "give it the label on the sheet: `a`, `b`, `c`".to_owned();
        faults.push(KeyFault { help, ..fault.below("label").below(&format!("parts[{place}]")) });
    }
    for (place, (part, keyed)) in stated.parts.iter().zip(&question.parts).enumerate() {
        let below = |fault: KeyFault| fault.below(&format!("parts[{place}]"));
        let scheme = part.scheme.len();
        if part.marks != scheme {
            let fault = KeyFault::new(
                format!("{} marks, and the scheme has {scheme}", part.marks),
                format!("expected {scheme}, one for each mark of `scheme`"),
            );
            let help = "change `marks`, or add to `scheme` what is missing".to_owned();
            faults.push(below(KeyFault { help, ..fault.below("marks") }));
        }
        for (at, (blank, read)) in part.blanks.iter().zip(&keyed.blanks).enumerate() {
            let below = |fault: KeyFault| below(fault.below(&format!("blanks[{at}]")));
            faults.extend(of_blank(question, blank, read, &keyed.known).map(below));
        }
    }
    faults
}

/// Of all that have the key of an earlier one their place, and that of the first.
fn twice<T, K: std::hash::Hash + Eq>(all: &[T], key: impl Fn(&T) -> K) -> impl Iterator<Item = (usize, usize)> {
    let mut first = HashMap::new();
    let mut found = Vec::new();
    for (place, one) in all.iter().enumerate() {
        let earlier = *first.entry(key(one)).or_insert(place);
        if earlier != place {
            found.push((place, earlier));
        }
    }
    found.into_iter()
}

/// A blank with another value than the collision leads to, or with a decimal of another.
fn of_blank(question: &KeyedQuestion, blank: &Blank, keyed: &KeyedBlank, known: &Known<Value>) -> Option<KeyFault> {
    match keyed.model.kind {
        Kind::Range => return of_range(question, blank, &keyed.model.value),
        // What is to be shown may be said of another size than is found.
        Kind::Equation | Kind::Shown => return None,
        _ => {}
    }
    let (exact, decimal) = (texts(&blank.exact), texts(&blank.decimal));
    for (place, right) in right(question, &keyed.find, known).iter().enumerate() {
        let text = *exact.get(place)?;
        let letters = &question.letters;
        let Some(right) = right else { continue };
        let stated = read(text, Angles::Radians).ok()?;
        if is_refuted(&stated, right, letters) {
            let what = match &blank.find {
                Json::String(name) => name.clone(),
                find => texts(find).get(place).map_or_else(String::new, |name| (*name).to_owned()),
            };
            return Some(other_exact(text, format!("expected `{what}` to be `{}`", print::plain(right))));
        }
        let Some(figures) = decimal.get(place) else { continue };
        if let Some(right) = other_decimal(figures, &stated, letters) {
            let fault = KeyFault::new(
                format!("`{figures}` is not the decimal of `{text}`"),
                format!("expected `{right}`, or more figures of it, or fewer"),
            );
            let help = "put that there: `exact` is what answers are compared with".to_owned();
            return Some(KeyFault { help, ..fault.below("decimal") });
        }
    }
    None
}

/// A range from the wrong value or to the wrong value.
fn of_range(question: &KeyedQuestion, blank: &Blank, stated: &Expr) -> Option<KeyFault> {
    let right = question.solution()?.range()?.written();
    let expected = || format!("expected `{}`", print::plain(&right));
    let text = texts(&blank.exact).first().copied().unwrap_or_default();
    are_other_ends(stated, &right, &question.letters).then(|| other_exact(text, expected()))
}

/// What the collision leads to for what is asked: of a vector both components; nothing where that is not known.
fn right(question: &KeyedQuestion, find: &Find, known: &Known<Value>) -> Vec<Option<Expr>> {
    let quantities = match find {
        Find::Unknown(name) => {
            let found = question.solution().and_then(|solution| found(solution, name));
            return vec![found];
        }
        Find::Quantity(quantity) => vec![*quantity],
        Find::Vector(x, y) => vec![*x, *y],
    };
    let value = |quantity: Quantity, known: &Known<Value>| match known.number(quantity) {
        Some(value) => Some(written(&value)),
        None => {
            let (y, x) = known.direction(quantity)?;
            Angle::of(&y, &x).map(|angle| in_degrees(&written_angle(&angle)))
        }
    };
    let has_unknowns = !question.scene.unknowns.is_empty();
    let known = match question.solution() {
        Some(solution) => solution.known(),
        None if has_unknowns => return Vec::new(),
        None => known,
    };
    quantities.into_iter().map(|quantity| value(quantity, known)).collect()
}

/// A letter that was found: of an angle its degrees.
fn found(solution: &Solution, name: &str) -> Option<Expr> {
    let (letter, value) = solution.found().iter().find(|(letter, _)| letter.name() == name)?;
    match letter.range() {
        Range::Acute => Angle::of(value, &Value::ONE).map(|angle| in_degrees(&written_angle(&angle))),
        _ => Some(written(value)),
    }
}

/// One text, or those of a list.
fn texts(json: &Json) -> Vec<&str> {
    match json {
        Json::Array(all) => all.iter().filter_map(Json::as_str).collect(),
        one => one.as_str().into_iter().collect(),
    }
}

fn other_exact(text: &str, expected: String) -> KeyFault {
    let fault = KeyFault::new(format!("`{text}` is not what the scene of the question leads to"), expected);
    let help = "put that there, or correct the `scene`; `carom sheet` writes both as they belong together";
    KeyFault { help: help.to_owned(), ..fault.below("exact") }
}

/// Do two ranges that are written alike begin or end elsewhere?
fn are_other_ends(stated: &Expr, right: &Expr, letters: &[Letter]) -> bool {
    match (stated, right) {
        (Expr::Relation(left, relation, rest), Expr::Relation(own_left, own_relation, own_rest)) => {
            relation == own_relation
                && (are_other_ends(left, own_left, letters) || are_other_ends(rest, own_rest, letters))
        }
        (Expr::Relation(..), _) | (_, Expr::Relation(..)) => false,
        _ => is_refuted(stated, right, letters),
    }
}

fn is_refuted(stated: &Expr, right: &Expr, letters: &[Letter]) -> bool {
    let points = if letters.is_empty() { 1 } else { POINTS };
    stated != right
        && (0..points).any(|point| {
            let both = enclose_roughly(stated, letters, point).zip(enclose_roughly(right, letters, point));
            both.is_some_and(|(stated, right)| !stated.overlaps(right))
        })
}

/// The decimal of an expression to as many figures, if those that are given are others.
fn other_decimal(figures: &str, exact: &Expr, letters: &[Letter]) -> Option<String> {
    if !exact.names().is_empty() {
        return None;
    }
    let within: FloatInterval = enclose_roughly(exact, letters, 0)?;
    let Ok(Expr::Decimal(_) | Expr::Number(_) | Expr::Negative(_)) = read(figures, Angles::Radians) else {
        return Some(format!("{}", (within.lower + within.upper) / 2.0));
    };
    let given: f64 = figures.parse().ok()?;
    let places = figures.split_once('.').map_or(0, |(_, after)| after.len());
    let half = 0.5 * 10f64.powi(-i32::try_from(places).ok()?);
    // Beyond the figures of a double nothing is known.
    let doubt = half * 1e-6 + given.abs() * 1e-14;
    let is_near = given - half - doubt <= within.upper && within.lower <= given + half + doubt;
    let exact = Fraction::from_f64((within.lower + within.upper) / 2.0)?;
    let right: Decimal = round(&exact, &Places::SignificantFigures(8));
    (!is_near).then(|| right.to_string())
}
