//! Ranges of a letter: `1/3 < e ≤ 1`, `e > 1/3`, `3e > 1`, two inequalities in a row or one after the other.
//!
//! An end that is only what the letter can be anyway, as `e ≤ 1` is, may be given or left out, and may be counted in or
//! out. Any other end must be there, at the right number, with its own value counted in or out as it should be.

use std::cmp::Ordering;

use crate::expr::{Expr, Meaning, Relation, evaluate, written};
use crate::mark::reading::{Form, Reading};
use crate::number::{Letter, Span, Value};

use super::accuracy::Written;
use super::exact::{self, meaning_of};
use super::finding::Finding;
use super::{Model, Note, number};

/// One inequality, solved for the letter: the letter lies on this side of the bound.
struct Bound {
    /// Is the letter above it?
    above: bool,
    included: bool,
    value: Value,
    /// As it was written, where the letter stands by itself.
    shown: Expr,
}

/// Judges a whole reading against a range.
pub(super) fn judge(model: &Model, reading: &Reading) -> Finding {
    let letters = &model.vocabulary.letters;
    let right = relations(&model.value);
    let Some(letter) = letter(&right, letters) else { return Finding::unreadable(Note::CannotBeCompared) };
    let Some(right) = bounds(&right, letter, letters) else { return Finding::unreadable(Note::CannotBeCompared) };
    let said = reading.statements.iter().flat_map(|statement| &statement.said);
    let mut own = Vec::new();
    let mut bare = Vec::new();
    for said in said {
        match &said.form {
            Form::Equation(relation) => own.extend(relations(relation)),
            Form::Value(value) => bare.push(value.clone()),
            _ => return Finding::unreadable(Note::CannotBeCompared),
        }
    }
    let ends: Vec<&Bound> = right.iter().filter(|bound| !is_natural(bound, letter)).collect();
    if own.is_empty() {
        let is_end = |value: &Expr| ends.iter().any(|end| at(model, end, value).is_credited());
        let named = !bare.is_empty() && bare.iter().all(is_end);
        return if named { Finding::partial(Note::RangeWanted) } else { Finding::wrong(Note::RangeWanted) };
    }
    if own.iter().any(|relation| exact::unknown_letter(relation, letters).is_some()) {
        return Finding::wrong(Note::UnknownLetter);
    }
    let Some(own) = bounds(&own, letter, letters) else { return Finding::unreadable(Note::CannotBeCompared) };
    against(model, &ends, &own, letter)
}

/// The bounds of a student against the ends that must be there.
fn against(model: &Model, ends: &[&Bound], own: &[Bound], letter: Letter) -> Finding {
    let mut worst = Finding::EXACT;
    let mut used = vec![false; own.len()];
    let mut missing = 0;
    for end in ends {
        let near = |bound: &&Bound| at(model, end, &bound.shown).is_credited();
        let Some(place) = own.iter().position(|bound| bound.above == end.above && near(&bound)) else {
            if own.iter().any(|bound| bound.above != end.above && near(&bound)) {
                return Finding::wrong(Note::RangeTurned);
            }
            missing += 1;
            continue;
        };
        used[place] = true;
        worst = worst.and(at(model, end, &own[place].shown));
        if own[place].included != end.included {
            worst = worst.spoilt_by(Note::RangeEnd);
        }
    }
    // What else is said must be no more than what the letter is anyway.
    let idle = own.iter().zip(&used).filter(|(_, used)| !**used).all(|(bound, _)| is_natural(bound, letter));
    match (missing, ends.len()) {
        (0, _) if idle => worst,
        (0, _) => Finding::WRONG,
        (missing, all) if missing < all && idle => worst.at_most_partial(Note::RangeHalf),
        _ => Finding::WRONG,
    }
}

/// A bound as it is written against an end, by the model's rule of acceptance.
fn at(model: &Model, end: &Bound, shown: &Expr) -> Finding {
    number::value(&model.of_value(written(&end.value)), shown, &Written::of(shown))
}

/// Every relation, of a chain both.
fn relations(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Relation(left, relation, right) => match &**left {
            Expr::Relation(_, _, middle) => {
                let last = Expr::Relation(middle.clone(), *relation, right.clone());
                relations(left).into_iter().chain([last]).collect()
            }
            _ => vec![expr.clone()],
        },
        _ => Vec::new(),
    }
}

/// The letter that the relations are about: the one that stands by itself.
fn letter(relations: &[Expr], letters: &[Letter]) -> Option<Letter> {
    let named = |expr: &Expr| match expr {
        Expr::Name(name) => letters.iter().find(|letter| letter.name() == name.text).copied(),
        _ => None,
    };
    relations.iter().find_map(|relation| match relation {
        Expr::Relation(left, _, right) => named(left).or_else(|| named(right)),
        _ => None,
    })
}

/// Each relation solved for the letter, in which it must be linear.
fn bounds(relations: &[Expr], letter: Letter, letters: &[Letter]) -> Option<Vec<Bound>> {
    relations.iter().map(|relation| bound(relation, letter, letters)).collect()
}

fn bound(relation: &Expr, letter: Letter, letters: &[Letter]) -> Option<Bound> {
    let Expr::Relation(left, relation, right) = relation else { return None };
    let value = |expr: &Expr| match evaluate(expr, &|name| meaning_of(letters, name)).ok()? {
        Meaning::Number(value) => Some(value),
        _ => None,
    };
    let difference = &value(left)? - &value(right)?;
    let slope = difference.derivative(letter)?;
    let turns = slope.sign()?.is_lt();
    if slope.is_zero() || slope.letters().contains(&letter) {
        return None;
    }
    let (greater, included) = match relation {
        Relation::Greater => (true, false),
        Relation::GreaterOrEqual => (true, true),
        Relation::Less => (false, false),
        Relation::LessOrEqual => (false, true),
        _ => return None,
    };
    let value = (-difference.substitute(letter, &Value::ZERO)?).divided_by(&slope)?;
    let is_letter = |expr: &Expr| matches!(expr, Expr::Name(name) if name.text == letter.name());
    let shown = match (is_letter(left), is_letter(right)) {
        (true, false) => (**right).clone(),
        (false, true) => (**left).clone(),
        _ => written(&value),
    };
    Some(Bound { above: greater != turns, included, value, shown })
}

/// Is the bound no more than what the letter can be anyway?
fn is_natural(bound: &Bound, letter: Letter) -> bool {
    let Span { low, high } = Span::of(letter.range());
    let order = |end: &Value| (&bound.value - end).sign();
    match bound.above {
        true => low.is_some_and(|low| order(&low.value).is_some_and(Ordering::is_le)),
        false => high.is_some_and(|high| order(&high.value).is_some_and(Ordering::is_ge)),
    }
}
