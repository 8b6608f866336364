//! What of an answer counts: values that the student rejects do not, nor those that a condition of theirs rules out, nor
//! what is told of something else besides, as the direction beside a speed is.

use std::borrow::Cow;
use std::cmp::Ordering;

use crate::answer::Kind;
use crate::expr::{Expr, Function, Relation};
use crate::mark::enclosure::enclose_roughly;
use crate::mark::reading::{
    End, Form, Label, Reading, Said, Statement, is_in_place_of, is_rejection, is_second_thought,
};
use crate::mechanics::{Moment, Quantity};
use crate::number::Fraction;

use super::besides::{compared_with_a_bound, without_its_name, without_size_and_direction, without_told_besides};
use super::moments::{COMPARING, EARLIER, LATER, moment, states};
use super::otherwise::{DIRECTED, is_changed_to};
use super::sorts::{changes_in_words, is_of_change, words};
use super::sources::without_its_sources;
use super::statements::is_rival;
use super::{Model, exact};

/// The reading without what does not count; `None` if nothing is left of it.
pub(super) fn counted<'r>(model: &Model, reading: &'r Reading) -> Option<Cow<'r, Reading>> {
    let kept = without_rejected(model, &reading.statements);
    if kept.is_empty() && !reading.statements.is_empty() {
        return None;
    }
    let kept = without_what_is_worked_with(kept);
    let kept = without_what_is_rooted(model, without_what_changes(model, without_other_moment(model, kept)));
    let kept = match model.kind {
        Kind::Number | Kind::Expression => {
            let kept = compared_with_a_bound(model, kept);
            without_told_besides(
                model,
                meeting_conditions(model, without_its_sources(model, without_steps(model, kept))),
            )
        }
        Kind::Line => without_its_name(kept),
        Kind::Vector => without_size_and_direction(model, kept),
        Kind::Angle => {
            let kept = without_its_sources(model, without_steps(model, kept));
            without_told_besides(model, meeting_conditions(model, kept))
        }
        _ => kept,
    };
    let same = kept.len() == reading.statements.len() && kept == reading.statements;
    Some(if same { Cow::Borrowed(reading) } else { Cow::Owned(Reading { statements: kept, ..reading.clone() }) })
}

fn is_rejected(statement: &Statement) -> bool {
    let label = statement.label.iter().map(|label| label.typed.to_lowercase());
    let remarks = statement.remarks().cloned();
    // `2.78, not 3.08`, `8, −8 (N/A)`, `8 or −8 (not possible)`
    const DENIED: [&str; 8] = ["not", "n/a", "not possible", "not valid", "not allowed", "✗", "✘", "❌"];
    let is_denied = statement.remarks().any(|remark| DENIED.contains(&remark.as_str()) || is_in_place_of(remark));
    if is_denied || is_taken_back(statement) {
        return true;
    }
    label.chain(remarks).any(|words| words.split(|letter: char| !letter.is_alphanumeric()).any(is_rejection))
}

/// `8 or 3 (reject the larger)`: which of them it is, a person sees.
pub(super) fn rejects_by_description(reading: &Reading) -> bool {
    const DESCRIBED: [&str; 13] = [
        "larger", "smaller", "bigger", "lower", "higher", "greater", "first", "second", "former", "latter", "positive",
        "lesser", "last",
    ];
    let mut remarks = reading.remarks();
    let is_described = remarks.clone().flat_map(|remark| words(remark)).any(|word| DESCRIBED.contains(&word));
    reading.statements.len() > 1 && is_described && remarks.any(|remark| words(remark).any(is_rejection))
}

/// `3.08, no, 2.78`
fn is_taken_back(statement: &Statement) -> bool {
    statement.remarks().any(|remark| is_second_thought(remark))
}

/// `v_B = 3.08, no, 2.78`: what takes the place of a value has its name.
fn with_names_carried_over(statements: &[Statement]) -> Cow<'_, [Statement]> {
    if !statements.iter().any(is_taken_back) {
        return Cow::Borrowed(statements);
    }
    let mut found = statements.to_vec();
    for at in 1..found.len() {
        if is_taken_back(&found[at - 1]) && found[at].label.is_none() {
            found[at].label = found[at - 1].label.clone();
        }
    }
    Cow::Owned(found)
}

/// The statements without those that are rejected, and without those whose values are named again as rejected: `1/3 or 3
/// (reject 3)`, `1/3 or 3 (reject > 1)`.
fn without_rejected(model: &Model, statements: &[Statement]) -> Vec<Statement> {
    let statements = with_names_carried_over(statements);
    let (rejected, kept): (Vec<&Statement>, Vec<&Statement>) = statements.iter().partition(|one| is_rejected(one));
    let order = |one: &Expr, other: &Expr| order(model, one, other);
    let is_of = |value: &Expr, rejected: &Said| match &rejected.form {
        Form::Value(other) => order(value, other) == Some(Ordering::Equal),
        // `3 > 1 so rejected`, where it is.
        Form::Equation(Expr::Relation(left, relation, bound)) => {
            let is_so = order(left, bound).is_some_and(|sign| holds(*relation, sign));
            order(value, left) == Some(Ordering::Equal) && is_so
        }
        Form::Range(low, high) => {
            low.as_ref().is_none_or(|low| order(value, &low.at).is_some_and(Ordering::is_gt))
                && high.as_ref().is_none_or(|high| order(value, &high.at).is_some_and(Ordering::is_lt))
        }
        _ => false,
    };
    let is_ruled_out = |statement: &&Statement| {
        let Some(Form::Value(value)) = statement.said.last().map(|said| &said.form) else { return false };
        // `2.78, sorry, 2.78 m/s`
        let rejected = rejected.iter().filter(|rejected| !is_taken_back(rejected));
        rejected.filter_map(|rejected| rejected.said.last()).any(|rejected| is_of(value, rejected))
    };
    kept.into_iter().filter(|statement| !is_ruled_out(statement)).cloned().collect()
}

/// How one value stands to another, where that can be told: with letters, as it is wherever they can lie.
pub(super) fn order(model: &Model, one: &Expr, other: &Expr) -> Option<Ordering> {
    let letters = &model.vocabulary.letters;
    let gap = Expr::sum([one.clone(), other.clone().negated()]);
    let at_point = |point: u32| {
        let gap = enclose_roughly(&gap, letters, point)?;
        match (gap.lower > 0.0, gap.upper < 0.0) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        }
    };
    let everywhere = || {
        let first = at_point(0)?;
        exact::points(letters).all(|point| at_point(point) == Some(first)).then_some(first)
    };
    exact::value(&gap, letters).and_then(|gap| gap.sign()).or_else(everywhere)
}

/// `tan⁻¹(5/4) = 51.3, 180 − 51.3 = 128.7`: a value that the last statement works with is a step to it. So it is under a
/// letter of the student's own, `β = 51.3, 180 − β = 128.7`.
fn without_what_is_worked_with(mut statements: Vec<Statement>) -> Vec<Statement> {
    let name = |label: &Option<Label>| label.as_ref().and_then(|label| label.expr.clone());
    if let [steps @ .., last] = statements.as_slice()
        && let Some(works @ Expr::Sum(_)) = name(&last.label)
        && let [letter] = works.names().as_slice()
        && steps.iter().any(|step| matches!(name(&step.label), Some(Expr::Name(own)) if own.text == letter.text))
    {
        let is_step = |step: &Statement| matches!(name(&step.label), Some(Expr::Name(own)) if own.text == letter.text);
        let mut last = last.clone();
        last.label = None;
        let steps = steps.iter().filter(|step| !is_step(step)).cloned();
        statements = steps.chain([last]).collect();
    }
    let value = |said: &Said| match &said.form {
        Form::Value(value) => Some(value.clone()),
        _ => None,
    };
    let works = statements.last().and_then(|last| last.said.first()).and_then(value);
    let terms = match &works {
        Some(Expr::Sum(terms)) => terms.as_slice(),
        _ => return statements,
    };
    let is_term = |value: &Expr| {
        let is_figure = match value {
            Expr::Decimal(_) => true,
            // A single figure may be met by chance.
            Expr::Number(number) => number.abs() >= Fraction::from(10),
            _ => false,
        };
        is_figure && terms.iter().any(|term| term == value || *term == value.clone().negated())
    };
    let is_step = |statement: &Statement| {
        let last = statement.said.last();
        last.and_then(value).is_some_and(|value| is_term(&value)) && !statement.said.iter().any(is_rival)
    };
    let end = statements.len() - 1;
    let kept = statements.iter().enumerate().filter(|(at, statement)| *at == end || !is_step(statement));
    kept.map(|(_, statement)| statement.clone()).collect()
}

/// `1.5² + 2² = 6.25, √6.25 = 2.5`: the square, of which the root is taken next; `2² + 3² = 13, v = 3.61` leaves the root out.
///
/// `v_B = i − 2j so speed = √5`: the vector, of which the size is taken.
fn without_what_is_rooted(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let is_of_size = matches!(model.kind, Kind::Number | Kind::Expression);
    if statements.len() < 2 {
        return statements;
    }
    let is_rooted = |at: usize| {
        let (square, root) = (statements[at].said.last(), statements.get(at + 1).and_then(|next| next.said.first()));
        match (square.map(|said| &said.form), root.map(|said| &said.form)) {
            (Some(Form::Value(square)), Some(Form::Value(Expr::Call(Function::Sqrt, under)))) => {
                statements[at].label.is_none() && square == &**under
            }
            (Some(Form::Value(_)), Some(Form::Value(_)))
                if statements[at].label.is_none() && statements[at].said.first().is_some_and(is_sum_of_squares) =>
            {
                is_of_size
            }
            (Some(Form::Vector(..)), Some(Form::Value(_))) => {
                is_of_size && says(&statements[at + 1], &["speed", "magnitude", "mag", "so"])
            }
            _ => false,
        }
    };
    let kept: Vec<bool> = (0..statements.len()).map(|at| !is_rooted(at)).collect();
    statements.into_iter().zip(kept).filter(|(_, kept)| *kept).map(|(statement, _)| statement).collect()
}

/// `2² + 3²`
fn is_sum_of_squares(said: &Said) -> bool {
    let is_square = |term: &Expr| matches!(term, Expr::Power(_, two) if **two == Expr::integer(2));
    matches!(&said.form, Form::Value(Expr::Sum(terms)) if terms.len() > 1 && terms.iter().all(is_square))
}

/// `k = 8 or k = −8, k > 0`: an inequality beside values is no value, and rules out those that do not meet it.
fn meeting_conditions(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let statements = without_ranges_besides(model, statements);
    let nought = Expr::integer(0);
    let mut conditions: Vec<(Relation, &Expr)> = statements.iter().filter_map(conditions_of).flatten().collect();
    // `k = 8 or −8, take positive`
    let takes_positive = |remark: &String| remark.starts_with("tak") && remark.contains("positive");
    let is_chosen = |remark: &String| takes_positive(remark) || remark == "positive only";
    conditions
        .extend(statements.iter().flat_map(Statement::remarks).any(is_chosen).then_some((Relation::Greater, &nought)));
    if conditions.is_empty() {
        return statements;
    }
    let meets = |statement: &&Statement| {
        let Some(Form::Value(value)) = statement.said.last().map(|said| &said.form) else { return true };
        conditions.iter().all(|(relation, bound)| order(model, value, bound).is_none_or(|sign| holds(*relation, sign)))
    };
    // `e = 7/5 > 1, so e = 5/7`: what is found after a condition and does not meet it shows that none was meant.
    let is_meant = statements.last().is_none_or(|last| meets(&last) || last.said.iter().any(is_rival));
    let values = statements.iter().filter(|statement| conditions_of(statement).is_none());
    let kept: Vec<Statement> = values.filter(|statement| !is_meant || meets(statement)).cloned().collect();
    if kept.is_empty() { statements } else { kept }
}

/// The conditions that a letter meets, if the statement is of such: `k > 0`, `0 < e < 1`.
fn conditions_of(statement: &Statement) -> Option<Vec<(Relation, &Expr)>> {
    statement.said.iter().map(condition).collect()
}

/// What a letter is compared with, and how.
fn condition(said: &Said) -> Option<(Relation, &Expr)> {
    let Form::Equation(Expr::Relation(left, relation, right)) = &said.form else { return None };
    let turned = match relation {
        Relation::Less => Relation::Greater,
        Relation::LessOrEqual => Relation::GreaterOrEqual,
        Relation::Greater => Relation::Less,
        Relation::GreaterOrEqual => Relation::LessOrEqual,
        Relation::NotEqual => Relation::NotEqual,
        _ => return None,
    };
    match (&**left, &**right) {
        (Expr::Name(_), bound) => Some((*relation, bound)),
        (bound, Expr::Name(_)) => Some((turned, bound)),
        _ => None,
    }
}

/// `5/7, which is less than 1`, `from 45 to 75, i.e. 30`: a range in words is no value either, where the value that stands
/// beside it lies in it, or is the way from its one end to the other.
fn without_ranges_besides(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let is_range = |statement: &Statement| matches!(statement.said.as_slice(), [said @ Said { form: Form::Range(..), .. }] if !is_rival(said));
    if statements.len() < 2 || !statements.iter().any(is_range) {
        return statements;
    }
    let last = statements.iter().rev().find(|statement| !is_range(statement)).and_then(|last| last.said.last());
    let Some(Said { form: Form::Value(value), .. }) = last else { return statements };
    let order = |one: &Expr, other: &Expr| order(model, one, other);
    let goes_with = |low: &Option<End>, high: &Option<End>| {
        let is_in = low.as_ref().is_none_or(|low| order(value, &low.at).is_some_and(Ordering::is_ge))
            && high.as_ref().is_none_or(|high| order(value, &high.at).is_some_and(Ordering::is_le));
        match (low, high) {
            // Two numbers in brackets may be meant for something else.
            (Some(low), Some(high)) => {
                let way = |from: &End, to: &End| Expr::sum([to.at.clone(), from.at.clone().negated()]);
                let is_way =
                    || [way(low, high), way(high, low)].iter().any(|way| order(value, way) == Some(Ordering::Equal));
                low.included.is_none() && high.included.is_none() && (is_in || is_way())
            }
            _ => is_in,
        }
    };
    let is_besides = |statement: &Statement| match statement.said.as_slice() {
        [Said { form: Form::Range(low, high), .. }] => is_range(statement) && goes_with(low, high),
        _ => false,
    };
    statements.iter().filter(|statement| !is_besides(statement)).cloned().collect()
}

pub(super) fn holds(relation: Relation, sign: Ordering) -> bool {
    match relation {
        Relation::Less => sign.is_lt(),
        Relation::LessOrEqual => sign.is_le(),
        Relation::Greater => sign.is_gt(),
        Relation::GreaterOrEqual => sign.is_ge(),
        Relation::NotEqual => sign.is_ne(),
        _ => true,
    }
}

/// Is it an angle, by its unit, by the line from which it is measured, or as an inverse tangent is?
pub(super) fn is_angular(said: &Said) -> bool {
    let is_inverse = |form: &Form| matches!(form, Form::Value(value) if holds_inverse(value));
    match &said.unit {
        Some(unit) => unit.degrees || unit.dimension == [0, 0, 0, 1],
        None => said.reference.is_some_and(|line| !line.is_direction()) || is_inverse(&said.form),
    }
}

/// `arctan 2`, `180 − arctan 2`
fn holds_inverse(expr: &Expr) -> bool {
    match expr {
        Expr::Call(function, _) => matches!(function, Function::Asin | Function::Acos | Function::Atan),
        Expr::Relation(..) => false,
        other => other.children().into_iter().any(holds_inverse),
    }
}

/// `5.44 before, 3.52 after, 1.92 lost` where the loss is asked: what there is before and after leads to it. So it does to
/// a deflection; and to a speed what there is `horizontal` and `vertical`.
fn without_steps(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    const DEFLECTIONS: [&str; 3] = ["deflection", "deflected", "turned"];
    let Some(asked) = model.quantity.filter(|_| statements.len() > 1) else { return statements };
    let (asked_for, steps): (&[&str], &[&str]) = match asked.of_its_impact() {
        _ if is_of_change(asked) => (changes_in_words(asked), states(asked)),
        Quantity::Deflection(_) | Quantity::SignedDeflection(_) => (&DEFLECTIONS, states(asked)),
        Quantity::Speed(..) => (&["speed", "resultant", "magnitude", "total"], &DIRECTED),
        _ => return statements,
    };
    let is_asked = |statement: &Statement| says(statement, asked_for);
    match statements.iter().any(is_asked) {
        true => statements.into_iter().filter(|step| is_asked(step) || !says(step, steps)).collect(),
        false => statements,
    }
}

/// `before 2i + j, after 4i + j`: what is said of the moment that is asked counts, and no other.
fn without_other_moment(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let Some(moment) = model.quantity.and_then(moment).filter(|_| statements.len() > 1) else { return statements };
    let (own, other): (&[&str], &[&str]) = match moment {
        Moment::After => (&LATER, &EARLIER),
        Moment::Before => (&EARLIER, &LATER),
    };
    let compares = |statement: &Statement| {
        let mut remarks = statement.remarks().flat_map(|remark| words(remark));
        remarks.any(|word| COMPARING.contains(&word))
    };
    let is_of = |statement: &Statement, wanted: &[&str], unwanted: &[&str]| {
        says(statement, wanted) && !says(statement, unwanted) && !compares(statement)
    };
    let is_other = |statement: &Statement| is_of(statement, other, own) && !statement.said.iter().any(is_rival);
    match statements.iter().any(|statement| is_of(statement, own, other)) {
        true => statements.into_iter().filter(|statement| !is_other(statement)).collect(),
        false => statements,
    }
}

/// `5.44 reduced to 3.52`: what there is before an impact and after it, of which one is asked.
fn without_what_changes(model: &Model, mut statements: Vec<Statement>) -> Vec<Statement> {
    let is_free = |statement: &Statement| statement.label.is_none() && !statement.said.iter().any(is_rival);
    let changes = statements.last().and_then(|last| last.label.as_ref());
    if let ([before, _], Some(label)) = (statements.as_slice(), changes)
        && is_free(before)
        && is_changed_to(&label.typed.to_lowercase())
    {
        match model.quantity.and_then(moment) {
            Some(Moment::After) => drop(statements.remove(0)),
            Some(Moment::Before) => drop(statements.pop()),
            None => {}
        }
    }
    statements
}

/// Does one of these words stand in its label or beside its values?
pub(super) fn says(statement: &Statement, wanted: &[&str]) -> bool {
    let label = statement.label.iter().map(|label| &label.typed);
    let texts = label.chain(statement.remarks());
    texts.flat_map(|text| words(text)).any(|word| wanted.contains(&word.to_lowercase().as_str()))
}
