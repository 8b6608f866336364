//! Ranges of a letter: `1/3 < e ≤ 1`, `e > 1/3`, `(1/3, 1]`, two inequalities in a row or one after the other.
//!
//! An end that is only what the letter can be anyway, as `e ≤ 1` is, may be given or left out, and may be counted in or
//! out; but it must not be given further out, as `e ≤ 2` is. Any other end must be there, at the right number, with its
//! own value counted in or out as it should be, and the letter by itself: `3e > 1` is a step short. What else is said must
//! follow from the ends: the same again, or less. A number beside a range is another answer, unless it is an end. Where
//! `or` joins ranges, each must be right.

use std::cmp::Ordering;

use crate::answer::Kind;
use crate::expr::{Expr, Relation, written};
use crate::mark::reading::{End, Form, Reading, Said, Statement};
use crate::mechanics::Moment;
use crate::number::Letter;

use super::accuracy::Written;
use super::bounds::{Bound, bounds, is_natural, letter, order_to_natural, relations, rounds_to};
use super::exact;
use super::finding::Finding;
use super::statements::{is_concluded, is_rival};
use super::units::{self, UnitCheck};
use super::{Model, Note, events, moments, number, sorts};

/// Judges a whole reading against a range.
pub(super) fn judge(model: &Model, reading: &Reading) -> Finding {
    let letters = &model.vocabulary.letters;
    let right = relations([&model.value], letters);
    let Some(letter) = letter(&right, letters) else { return Finding::unreadable(Note::CannotBeCompared) };
    let Some(right) = bounds(&right, letter, letters) else { return Finding::unreadable(Note::CannotBeCompared) };
    let is_reason = |statement: &Statement| is_reason(statement, letter);
    let alternatives = reading.statements.chunk_by(|_, next| !next.said.iter().any(is_rival));
    let of = |statements: &[Statement]| {
        let whole = one(model, &right, letter, statements);
        let Some((last, before)) = statements.split_last() else { return whole };
        let mut concluded: Vec<Statement> = before.iter().filter(|statement| !is_reason(statement)).cloned().collect();
        // `e > 1/3, so v < 0`
        if !whole.is_credited() && is_sign(last) && is_concluded(&[last]) && concluded.len() == before.len() {
            // `e > 1/3, so v > 0`, where it is then that the sphere turns back
            let is_else = model.turns_back.is_some_and(|turns_back| says_negative(last) != turns_back);
            return match is_else {
                true => Finding::unreadable(Note::NamedOtherwise),
                false => one(model, &right, letter, before),
            };
        }
        if whole.is_credited() || concluded.len() == before.len() || is_reason(last) {
            return whole;
        }
        concluded.push(last.clone());
        one(model, &right, letter, &concluded)
    };
    // `A rebounds if k > 2`, where it is then that it goes on; where it is not, it may be so of the other values.
    match events::is_of_another_event(model, &reading.statements) {
        true => Finding::unreadable(Note::NamedOtherwise),
        false => {
            let finding = alternatives.map(of).reduce(Finding::and).unwrap_or(Finding::unreadable(Note::CannotBeRead));
            // `1/8 < e ≤ 1, the maximum is 1`
            let is_told = reading.statements.len() > 1 && reading.statements.iter().any(tells_an_end);
            if is_told && !finding.is_credited() { Finding::unreadable(Note::CannotBeCompared) } else { finding }
        }
    }
}

/// Does a statement name the greatest value or the least?
fn tells_an_end(statement: &Statement) -> bool {
    const ENDS: [&str; 4] = ["max", "maximum", "greatest", "largest"];
    let label = statement.label.iter().map(|label| &label.typed);
    label.chain(statement.remarks()).flat_map(|text| sorts::words(text)).any(|word| ENDS.contains(&word))
}

/// `v = 4(1 - 3e) < 0, so e > 1/3`, `angle > 90, so e > 1/3`: what goes before and is no inequality of the letter alone is the
/// reason for what follows.
fn is_reason(statement: &Statement, letter: Letter) -> bool {
    let is_of_letter_alone = |expr: &Expr| {
        let names = expr.names();
        !names.is_empty() && names.iter().all(|name| name.text == letter.name())
    };
    let is_inequality = |said: &Said| match &said.form {
        Form::Equation(relation @ Expr::Relation(_, sign, _)) => {
            *sign != Relation::Equal && !is_of_letter_alone(relation)
        }
        Form::Range(..) => {
            let names = |word: &str| sorts::sort(word).is_some() || word == "product";
            let mut words = said.remarks.iter().flat_map(|remark| sorts::words(remark));
            statement.label.is_none() && (said.unit.is_some() || words.any(names))
        }
        _ => false,
    };
    let label = statement.label.as_ref().map(|label| label.typed.trim());
    label.is_some_and(|name| name != letter.name()) || statement.said.iter().any(is_inequality)
}

/// `v < 0`, `v_A > 0`: the sign of a velocity.
fn is_sign(statement: &Statement) -> bool {
    let is_velocity = |expr: &Expr| matches!(expr, Expr::Name(name) if name.text.starts_with(['v', 'w', 'x', 'y']));
    let is_it = |said: &Said| {
        matches!(&said.form, Form::Equation(Expr::Relation(left, sign, right))
            if *sign != Relation::Equal && is_velocity(left) && right.is_zero())
    };
    statement.label.is_none() && statement.said.iter().all(is_it)
}

fn says_negative(statement: &Statement) -> bool {
    let is_less = |said: &Said| {
        matches!(&said.form, Form::Equation(Expr::Relation(_, Relation::Less | Relation::LessOrEqual, _)))
    };
    statement.said.iter().all(is_less)
}

/// A range where none is asked for: two numbers in brackets are not the answer, and what `more than 3` is meant to say of
/// a number is for a person to see.
pub(super) fn out_of_place(model: &Model, reading: &Reading) -> Option<Finding> {
    let mut forms = reading.statements.iter().flat_map(|statement| &statement.said).map(|said| &said.form);
    let range = forms.find(|form| matches!(form, Form::Range(..))).filter(|_| model.kind != Kind::Range)?;
    let is_after = model.quantity.and_then(moments::moment) == Some(Moment::After);
    let is_right = |end: &End| number::value(model, &end.at, &Written::of(&end.at)).is_credited();
    Some(match range {
        // `reduced from 5 to 3.57`
        Form::Range(Some(low), Some(high))
            if is_after && low.included.or(high.included).is_none() && is_right(high) =>
        {
            Finding::unreadable(Note::CannotBeCompared)
        }
        Form::Range(Some(_), Some(_)) => Finding::WRONG,
        _ => Finding::unreadable(Note::CannotBeCompared),
    })
}

/// Judges statements that are all to hold.
fn one(model: &Model, right: &[Bound], letter: Letter, statements: &[Statement]) -> Finding {
    let letters = &model.vocabulary.letters;
    let mut own: Vec<Bound> = Vec::new();
    let mut bare = Vec::new();
    for statement in statements {
        // `k > 17/18 (0.944 to 3 s.f.)`: the bound again.
        let is_bound_again =
            |value: &Expr| statement.label.is_none() && own.iter().any(|bound| rounds_to(&bound.shown, value));
        let equations = statement.said.iter().filter_map(|said| match &said.form {
            Form::Equation(relation) => Some(relation),
            _ => None,
        });
        if equations.clone().any(|relation| exact::unknown_letter(relation, letters).is_some()) {
            return Finding::wrong(Note::UnknownLetter);
        }
        let mut found = vec![bounds(&relations(equations, letters), letter, letters)];
        for said in &statement.said {
            found.push(match &said.form {
                Form::Equation(_) => continue,
                Form::Range(low, high) if is_of(letter, statement) => ends_of(said, low, high, letters),
                // Coordinates, where brackets are open to doubt.
                Form::Vector(..) => return Finding::WRONG,
                // `e over 1/3`, which reads as a quotient: the letter itself is no bound of it.
                Form::Value(value) if value.names().iter().any(|name| name.text == letter.name()) => None,
                Form::Value(value) if is_bound_again(value) => continue,
                Form::Value(value) => {
                    bare.push(value.clone());
                    continue;
                }
                _ => None,
            });
        }
        match found.into_iter().collect::<Option<Vec<_>>>() {
            Some(found) => own.extend(found.into_iter().flatten()),
            None => return Finding::unreadable(Note::CannotBeCompared),
        }
    }
    let ends: Vec<&Bound> = right.iter().filter(|bound| !is_natural(bound, letter)).collect();
    let all_are = |ends: &[&Bound]| {
        let is_end = |value: &Expr| ends.iter().any(|end| at(model, end, value).is_credited());
        !bare.is_empty() && bare.iter().all(is_end)
    };
    if own.is_empty() {
        // `between 1/3 (excluded) and 1`
        let mut remarks = statements.iter().flat_map(Statement::remarks);
        if remarks.any(|remark| remark.contains("between") || remark.contains("clud")) {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        // `1/3 - 1` may be a range with a dash.
        let is_end = |value: &Expr| right.iter().any(|end| at(model, end, value).is_credited());
        if let [Expr::Sum(terms)] = bare.as_slice()
            && let [first, Expr::Negative(last)] = terms.as_slice()
            && is_end(first)
            && is_end(last)
        {
            return Finding::unreadable(Note::CannotBeCompared);
        }
        return match (all_are(&ends), all_are(&right.iter().collect::<Vec<_>>())) {
            (true, _) => Finding::partial(Note::RangeWanted),
            (false, true) => Finding::wrong(Note::RangeWanted),
            (false, false) => Finding::wrong(Note::NotARange),
        };
    }
    let units =
        statements.iter().flat_map(|statement| &statement.said).map(|said| units::check(model, said.unit.as_ref()));
    let finding = units.fold(against(model, &ends, &own, letter), |finding, unit| match unit {
        UnitCheck::Fine => finding,
        UnitCheck::Condoned(note) => finding.remarked(note),
        UnitCheck::Spoilt(note) => finding.spoilt_by(note),
        // Ends are compared as they stand.
        UnitCheck::Converted(_) => Finding::unreadable(Note::CannotBeCompared),
    });
    match bare.is_empty() {
        true => finding,
        // `e = 1/3, so e > 1/3`: the critical value, and what is concluded from it.
        false if all_are(&ends) && is_concluded(&statements.iter().collect::<Vec<_>>()) => finding,
        // `k > 2, k = 2`: whether that is a step on the way or counts the end in, nobody can tell.
        false if all_are(&ends) => finding.spoilt_by(Note::RangeEnd),
        false if finding.is_credited() => Finding::wrong(Note::RivalAnswers),
        false => finding,
    }
}

/// The bounds of a student against the ends that must be there.
fn against(model: &Model, ends: &[&Bound], own: &[Bound], letter: Letter) -> Finding {
    let mut worst = Finding::EXACT;
    let mut missing = Vec::new();
    for end in ends {
        let near: Vec<&Bound> = own.iter().filter(|bound| is_near(model, bound, end)).collect();
        // Said twice, what is nearest counts, as in a chain of equals signs.
        match near.iter().map(|bound| at(model, end, &bound.shown)).reduce(Finding::or_better) {
            Some(finding) => worst = worst.and(finding),
            None if own.iter().any(|bound| at(model, end, &bound.shown).is_credited()) => {
                return Finding::wrong(Note::RangeTurned);
            }
            None => missing.push(end),
        }
        if near.iter().any(|bound| bound.included != end.included) {
            worst = worst.spoilt_by(Note::RangeEnd);
        }
        if !near.is_empty() && near.iter().all(|bound| !bound.solved) {
            worst = worst.spoilt_by(Note::RangeUnsolved);
        }
    }
    let follows = |bound: &Bound| {
        is_natural(bound, letter) || ends.iter().any(|end| is_no_tighter(bound, end) || is_near(model, bound, end))
    };
    // `1/4 ≤ k ≤ 3`: not left out, but elsewhere.
    let is_elsewhere = |end: &&&Bound| own.iter().any(|bound| bound.above == end.above && !is_natural(bound, letter));
    match (missing.len(), own.iter().all(follows)) {
        (0, true) if goes_too_far(own, letter) => worst.spoilt_by(Note::RangeTooFar),
        (0, true) => worst,
        (count, true) if count < ends.len() && !missing.iter().any(is_elsewhere) => {
            worst.at_most_partial(Note::RangeHalf)
        }
        _ => Finding::WRONG,
    }
}

/// Is the last bound on some side one of values that the letter cannot have? Then nobody looked how far the letter goes.
fn goes_too_far(own: &[Bound], letter: Letter) -> bool {
    [true, false].into_iter().any(|above| {
        let mut side = own.iter().filter(|bound| bound.above == above).peekable();
        side.peek().is_some() && side.all(|bound| order_to_natural(bound, letter) == Some(Ordering::Greater))
    })
}

/// Is the bound the end, as near as the model's rule of acceptance wants it?
fn is_near(model: &Model, bound: &Bound, end: &Bound) -> bool {
    bound.above == end.above && at(model, end, &bound.shown).is_credited()
}

/// Does the bound lie outside the end, or on it, so that it says nothing more?
fn is_no_tighter(bound: &Bound, end: &Bound) -> bool {
    let order = (&bound.value - &end.value).sign();
    bound.above == end.above && order.is_some_and(if end.above { Ordering::is_le } else { Ordering::is_ge })
}

/// A bound as it is written against an end, by the model's rule of acceptance.
fn at(model: &Model, end: &Bound, shown: &Expr) -> Finding {
    number::value(&model.of_value(written(&end.value)), shown, &Written::of(shown))
}

/// Is it said of this letter, or of none?
fn is_of(letter: Letter, statement: &Statement) -> bool {
    let named = statement.label.as_ref().and_then(|label| label.expr.as_ref());
    named.is_none_or(|named| matches!(named, Expr::Name(name) if name.text == letter.name()))
}

/// The ends of a range that names no letter; a word beside it may say whether they belong to it.
fn ends_of(said: &Said, low: &Option<End>, high: &Option<End>, letters: &[Letter]) -> Option<Vec<Bound>> {
    let says = |word: &str| said.remarks.iter().any(|remark| remark.contains(word));
    let bound = |above: bool, end: &End| {
        let takes_in = says("inclusive") || says("both included");
        let included = match (end.included, takes_in, says("exclusive") || says("strictly")) {
            (None, true, false) => Some(true),
            (None, false, true) => Some(false),
            (included, ..) => included,
        };
        Some(Bound { above, included, value: exact::value(&end.at, letters)?, shown: end.at.clone(), solved: true })
    };
    let ends = [(true, low), (false, high)].into_iter().filter_map(|(above, end)| Some((above, end.as_ref()?)));
    ends.map(|(above, end)| bound(above, end)).collect()
}
