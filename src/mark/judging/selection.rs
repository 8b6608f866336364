//! What of an answer counts: values that the student rejects do not, nor those that a condition of theirs rules out, nor
//! what is told of something else besides, as the direction beside a speed is.

use std::borrow::Cow;
use std::cmp::Ordering;

use crate::answer::Kind;
use crate::expr::{Expr, Relation};
use crate::mark::reading::{End, Form, Reading, ReferenceLine, Said, Statement};
use crate::mechanics::{Moment, Quantity};
use crate::unit::Unit;

use super::called::{COMPARING, EARLIER, LATER, LOSSES, is_of_loss, moment, states, words};
use super::otherwise::DIRECTED;
use super::statements::is_rival;
use super::{Model, exact, number, vector};

/// Words that take back the value beside them.
const REJECTIONS: [&str; 9] =
    ["reject", "rejected", "rejecting", "discard", "discarded", "disregard", "ignored", "inadmissible", "invalid"];

/// The reading without what does not count; `None` if nothing is left of it.
pub(super) fn counted<'r>(model: &Model, reading: &'r Reading) -> Option<Cow<'r, Reading>> {
    let kept: Vec<Statement> = reading.statements.iter().filter(|statement| !is_rejected(statement)).cloned().collect();
    if kept.is_empty() && !reading.statements.is_empty() {
        return None;
    }
    let kept = without_other_moment(model, kept);
    let kept = match model.kind {
        Kind::Number | Kind::Expression => {
            without_told_besides(model, meeting_conditions(model, without_steps(model, kept)))
        }
        Kind::Vector => without_size(model, kept),
        Kind::Angle => without_told_besides(model, meeting_conditions(model, without_steps(model, kept))),
        _ => kept,
    };
    let same = kept.len() == reading.statements.len() && kept == reading.statements;
    Some(if same { Cow::Borrowed(reading) } else { Cow::Owned(Reading { statements: kept, ..reading.clone() }) })
}

fn is_rejected(statement: &Statement) -> bool {
    let label = statement.label.iter().map(|label| label.typed.to_lowercase());
    let remarks = statement.said.iter().flat_map(|said| said.remarks.iter().cloned());
    label
        .chain(remarks)
        .any(|words| words.split(|letter: char| !letter.is_alphanumeric()).any(|word| REJECTIONS.contains(&word)))
}

/// `k = 8 or k = −8, k > 0`: an inequality beside values is no value, and rules out those that do not meet it.
fn meeting_conditions(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let statements = without_ranges_besides(model, statements);
    let conditions: Vec<(Relation, &Expr)> = statements.iter().filter_map(conditions_of).flatten().collect();
    if conditions.is_empty() {
        return statements;
    }
    let meets = |statement: &&Statement| {
        let Some(Form::Value(value)) = statement.said.last().map(|said| &said.form) else { return true };
        conditions.iter().all(|(relation, bound)| {
            let gap = exact::value(&Expr::sum([value.clone(), (*bound).clone().negated()]), &model.vocabulary.letters);
            gap.and_then(|gap| gap.sign()).is_none_or(|sign| holds(*relation, sign))
        })
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
    let order = |one: &Expr, other: &Expr| {
        let gap = Expr::sum([one.clone(), other.clone().negated()]);
        exact::value(&gap, &model.vocabulary.letters).and_then(|gap| gap.sign())
    };
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

fn holds(relation: Relation, sign: Ordering) -> bool {
    match relation {
        Relation::Less => sign.is_lt(),
        Relation::LessOrEqual => sign.is_le(),
        Relation::Greater => sign.is_gt(),
        Relation::GreaterOrEqual => sign.is_ge(),
        _ => true,
    }
}

/// Is it an angle, by its unit or by the line from which it is measured?
pub(super) fn is_angular(said: &Said) -> bool {
    said.unit.as_ref().is_some_and(|unit| unit.degrees || unit.dimension == [0, 0, 0, 1])
        || (said.unit.is_none() && said.reference.is_some_and(|line| !line.is_direction()))
}

/// `5.44 before, 3.52 after, 1.92 lost` where the loss is asked: what there is before and after leads to it. So it does to
/// a deflection; and to a speed what there is `horizontal` and `vertical`.
fn without_steps(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    const DEFLECTIONS: [&str; 3] = ["deflection", "deflected", "turned"];
    let Some(asked) = model.quantity.filter(|_| statements.len() > 1) else { return statements };
    let (asked_for, steps): (&[&str], &[&str]) = match asked.of_its_impact() {
        _ if is_of_loss(asked) => (&LOSSES, states(asked)),
        Quantity::Deflection(_) | Quantity::SignedDeflection(_) => (&DEFLECTIONS, states(asked)),
        Quantity::Speed(..) => (&["speed"], &DIRECTED),
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
        let mut remarks = statement.said.iter().flat_map(|said| &said.remarks).flat_map(|remark| words(remark));
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

/// Does one of these words stand in its label or beside its values?
fn says(statement: &Statement, wanted: &[&str]) -> bool {
    let label = statement.label.iter().map(|label| &label.typed);
    let texts = label.chain(statement.said.iter().flat_map(|said| &said.remarks));
    texts.flat_map(|text| words(text)).any(|word| wanted.contains(&word.to_lowercase().as_str()))
}

/// `4i + j (speed √17)`: the size of the vector, told besides, where it is right.
fn without_size(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let is_vector =
        |statement: &Statement| statement.said.last().is_some_and(|said| matches!(said.form, Form::Vector(..)));
    if statements.len() < 2 || !statements.iter().any(is_vector) {
        return statements;
    }
    let Some((x, y)) = vector::components(model) else { return statements };
    let of_size = Model { kind: Kind::Number, ..model.of_value(vector::magnitude(&x, &y)) };
    let names_size = |label: &str| {
        let is_size = |word: &str| matches!(&*word.to_lowercase(), "speed" | "magnitude" | "size");
        label.starts_with('|') || words(label).any(is_size)
    };
    let is_size = |statement: &Statement| {
        let is_named = statement.label.as_ref().is_some_and(|label| names_size(&label.typed));
        let is_right =
            |said: &Said| matches!(said.form, Form::Value(_)) && number::judge(&of_size, said, None).is_correct();
        is_named
            && !statement.said.is_empty()
            && !statement.said.iter().any(is_rival)
            && statement.said.iter().all(is_right)
    };
    statements.into_iter().filter(|statement| !is_size(statement)).collect()
}

/// Is it called an angle?
fn is_called_an_angle(statement: &Statement) -> bool {
    statement.label.as_ref().is_some_and(|label| match &label.expr {
        Some(Expr::Name(name)) => number::is_angle_name(&name.text),
        Some(_) => false,
        None => words(&label.typed).any(|word| word.eq_ignore_ascii_case("angle")),
    })
}

/// `3.61 m/s at 56.3° to the line of centres`, where the speed or the direction is asked: the other is told besides. A
/// direction in words goes with the one value that is left.
fn without_told_besides(model: &Model, statements: Vec<Statement>) -> Vec<Statement> {
    let Some(unit) = model.unit() else { return statements };
    let is_besides = |statement: &Statement| {
        let Some(said) = statement.said.last().filter(|said| !is_rival(said)) else { return false };
        match (&said.form, unit) {
            (_, Unit::None) => false,
            (Form::Value(_), Unit::Degree) => said.unit.is_some() && !is_angular(said),
            (_, Unit::Degree) => false,
            (Form::Value(_), _) => is_angular(said) || (said.unit.is_none() && is_called_an_angle(statement)),
            (Form::Direction, _) => true,
            _ => false,
        }
    };
    let (besides, mut kept): (Vec<Statement>, Vec<Statement>) = statements.iter().cloned().partition(is_besides);
    if kept.is_empty() {
        return statements;
    }
    let directions: Vec<ReferenceLine> = besides
        .iter()
        .flat_map(|statement| &statement.said)
        .filter(|said| said.form == Form::Direction)
        .filter_map(|said| said.reference)
        .collect();
    // `2.78 (component along LOC)`
    if let ([only], [Statement { label: Some(label), .. }]) = (kept.as_mut_slice(), besides.as_slice())
        && only.label.is_none()
        && label.typed.to_lowercase().starts_with("comp")
    {
        only.label = Some(label.clone());
    }
    if let ([Statement { said, .. }], [direction]) = (kept.as_mut_slice(), directions.as_slice())
        && let Some(last) = said.last_mut()
        && last.reference.is_none()
    {
        last.reference = Some(*direction);
    }
    kept
}
