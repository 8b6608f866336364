//! Answers that were left where the working ends, and not filled in.
//!
//! A number there may be anything: a step on the way, a component, a mass. It is an answer where it is called what is asked
//! for, or where the method for it is seen on other lines; and only if it is right.

use std::rc::Rc;

use super::answers::is_shown;
use super::components::put_together;
use super::decide::is_own;
use super::last_lines::{
    calls_something, concluded, has_own_unit, is_angle_after_its_ratio, is_formula, is_inequality, is_inverse,
    is_of_angle, name_and_end,
};
use super::memory::{Judged, Lines};
use crate::answer::Kind;
use crate::bank::{Code, Find};
use crate::expr::{Expr, Relation};
use crate::mark::award::{Award, Place};
use crate::mark::judging::{Judgement, Note, Verdict, is_made_of_others, judge};
use crate::mark::key::{KeyedBlank, KeyedPart};
use crate::mark::reading::{Form, Label, Reading, Statement};
use crate::mark::script::PartScript;
use crate::mark::working::{Examined, goes_on, is_bare, typed_lines};
use crate::mechanics::{Moment, Quantity};

/// The last lines of the working of a part, as many as it has blanks.
pub(super) struct Left<'s> {
    part: &'s KeyedPart,
    /// Each with its number in the working; the last line first.
    lines: Vec<(usize, &'s str)>,
    /// All of them, in their order.
    all: Vec<&'s str>,
    /// What stands left of the equals sign in the line that the last one goes on from, with an equals sign in front.
    begun: Option<&'s str>,
    /// What the lines earn, a mark each.
    by_lines: &'s [Option<Award>],
    examined: &'s Examined,
}

impl<'s> Left<'s> {
    pub(super) fn of(part: &'s KeyedPart, script: &'s PartScript, examined: &'s Examined) -> Left<'s> {
        let mut lines: Vec<(usize, &str)> =
            typed_lines(&script.working).enumerate().map(|(place, line)| (place + 1, line)).collect();
        lines.reverse();
        let goes_on = |(_, line): &&(usize, &str)| goes_on(line);
        let begun = lines.first().filter(goes_on).and_then(|_| lines.iter().find(|line| !goes_on(line)));
        let begun = begun.and_then(|(_, line)| line.split_once('=')).map(|(name, _)| name);
        let all = lines.iter().rev().map(|(_, line)| *line).collect();
        lines.truncate(part.blanks.len());
        Left { part, lines, all, begun, by_lines: &examined.awards, examined }
    }

    /// The last line, if it has the right answers to all of several blanks: `v = 3, w = 5`.
    pub(super) fn for_all(&self, judge: &dyn Fn(&str) -> Vec<Judgement>) -> Option<&'s str> {
        let (number, line) = self.lines.first().filter(|_| self.part.blanks.len() > 1)?;
        let has_method = || (0..self.part.blanks.len()).all(|blank| self.has_method(blank, *number));
        let is_right = |judgement: &Judgement| judgement.verdict == Verdict::Correct;
        if self.part.blanks.iter().any(|blank| self.is_found_otherwise(blank)) {
            return None;
        }
        ((calls_something(line) || has_method()) && judge(line).iter().all(is_right)).then_some(*line)
    }

    /// A right answer to one blank, with what was found of it.
    pub(super) fn for_one(
        &self,
        place: usize,
        lines: &Lines,
        judged: &mut dyn FnMut(&str) -> Rc<Judged>,
    ) -> Option<(&'s str, Rc<Judged>)> {
        let blank = &self.part.blanks[place];
        if is_shown(blank) {
            return self.printed_result(place);
        }
        // Nought may be anything's: that a sphere is at rest is often given.
        if blank.model.value == Expr::integer(0) {
            return None;
        }
        let is_range = blank.model.kind == Kind::Range;
        let in_a_line = self.lines.iter().find_map(|(number, line)| {
            let line = if is_range { concluded(line) } else { line };
            let has_method = self.has_method(place, *number);
            let shows_method = self.works_out(place, *number);
            // Both components of a vector are its method.
            let has_method = has_method || shows_method && blank.model.kind == Kind::Vector;
            // `m(fu cos α + u cos α)` by itself is the method and the answer.
            let is_formula_alone = shows_method && blank.model.kind == Kind::Expression && !line.contains('=');
            let may_work_out = shows_method && line.contains('=') || is_formula_alone;
            let is_called = calls_something(line) || is_range && is_inequality(line);
            let is_called = is_called || self.is_lone_value(line);
            if !has_method && !may_work_out && !is_called && self.begun.is_none() {
                return None;
            }
            let mut readings = lines.read(line, &blank.model.vocabulary);
            // `KE lost = ½mu² sin²30 = 12`: the question has numbers in place of m and u, and the method is seen.
            let mut ends = if readings.is_err() && may_work_out { name_and_end(line) } else { None };
            // `t = 0.79, α = 38.3°`: the question has no t.
            if ends.is_none() && readings.is_err() {
                ends = self.end_after_own_letters(place, line, lines);
            }
            // `x = -1, y = 4` after `v = xi + yj`
            let is_vector = blank.model.kind == Kind::Vector && blank.model.vocabulary.vectors;
            ends = ends.or_else(|| is_vector.then(|| put_together(&self.all[..*number])).flatten());
            // `½m(16u² - 9u²) = 7mu²/2`: in letters as well the line itself is the method.
            let in_letters = may_work_out
                && readings.as_ref().as_ref().is_ok_and(|all| all.first().is_some_and(is_worked_out_in_letters));
            if in_letters {
                ends = line.rsplit_once('=').map(|(_, end)| end.trim().to_owned());
            }
            if let Some(ends) = &ends {
                readings = lines.read(ends, &blank.model.vocabulary);
            }
            let Ok(readings) = readings.as_ref() else { return None };
            let statements = readings.first().map(|one| &one.statements)?;
            // `v = 3, w = 5` is for two blanks, and not the second value for either; `w − v = 3` is for none.
            // `tan β = 1/2, β = 26.6°` and `63.4° to the normal, so 26.6° to the wall` are about one angle.
            let is_of_one_angle = || {
                self.is_only_angle(place) && statements.iter().all(is_of_angle) || is_angle_after_its_ratio(statements)
            };
            // `t = 0.79, α = 38.3°`: what stands before it is called nothing that is asked.
            let last = self.called_last(place, line, statements, lines);
            let is_alone = last.is_some() || self.part.blanks.len() == 1 || statements.len() == 1 || is_of_one_angle();
            let mut labels = statements.iter().filter_map(|one| one.label.as_ref());
            let is_result = labels.all(|label| !is_formula(&label.typed) || is_made_of_others(&blank.model, label));
            let is_found = |statement: &Statement| self.is_only_angle(place) && statement.said.iter().any(is_inverse);
            // `E_1 - E_2` is what the loss is made of.
            let is_difference = |statement: &Statement| {
                let label = statement.label.as_ref().filter(|label| matches!(label.expr, Some(Expr::Sum(_))));
                label.is_some_and(|label| is_made_of_others(&blank.model, label))
            };
            // An inequality names its letter.
            let is_called = |statement: &Statement| {
                is_range || self.part.calls(place, statement) || is_found(statement) || is_difference(statement)
            };
            let begun = self.begun.filter(|_| self.lines[0].0 == *number).map(|name| format!("{name} {line}"));
            let is_begun = || {
                let read = begun.as_ref().map(|whole| lines.read(whole, &blank.model.vocabulary));
                let statements = read.as_ref().and_then(|read| Some(&read.as_ref().as_ref().ok()?.first()?.statements));
                statements.is_some_and(|statements| statements.iter().any(is_called))
            };
            // `45 - 18.4 = 26.6`: the line itself is the method.
            let is_alone_here =
                || matches!(statements.as_slice(), [Statement { label: None, said }] if said.len() == 1);
            let is_end = || {
                in_letters
                    || may_work_out && statements.iter().all(is_worked_out)
                    || is_formula_alone && is_alone_here()
            };
            let is_root = self.is_root(blank, *number, statements, lines);
            let is_result = is_result || is_root;
            let is_unit = self.is_lone_value(line) && has_own_unit(blank, statements);
            let is_answer =
                || has_method || is_root || is_unit || is_end() || statements.iter().any(is_called) || is_begun();
            if self.is_found_otherwise(blank) && statements.iter().all(is_bare) {
                return None;
            }
            let is_of_other = || statements.iter().any(|statement| self.is_of_other(blank, statement));
            if !(is_alone && is_result && is_answer()) || is_of_other() {
                return None;
            }
            let found = judged(last.or(ends.as_deref()).unwrap_or(line));
            is_right(&found.judgement).then_some((line, found))
        });
        in_a_line.or_else(|| self.ends_of_range(judged).filter(|_| is_range))
    }

    /// Is a line, after others, a value with its unit and nothing else: `85.6°`? A root needs no others: `√17`.
    fn is_lone_value(&self, line: &str) -> bool {
        let is_figures = line.trim_start().starts_with(|sign: char| sign.is_ascii_digit() || sign == '√');
        let is_end = self.all.len() > 1 || line.contains('√');
        self.part.blanks.len() == 1 && is_end && is_figures && !line.contains('=')
    }

    /// The end of a line that is called what is asked, after values of letters of the student's own.
    fn end_after_own_letters(&self, place: usize, line: &str, lines: &Lines) -> Option<String> {
        let (before, end) = line.rsplit_once([',', ';'])?;
        let is_of_letter = |value: &str| {
            let name = value.split_once('=').map(|(name, _)| name.trim()).unwrap_or_default();
            name.starts_with(char::is_alphabetic) && name.chars().count() <= 3
        };
        let readings = lines.read(end.trim(), &self.part.blanks[place].model.vocabulary);
        let statements = readings.as_ref().as_ref().ok()?.first().map(|reading| reading.statements.as_slice())?;
        let is_called = matches!(statements, [one] if self.part.calls(place, one));
        (is_called && before.split([',', ';']).all(is_of_letter)).then(|| end.trim().to_owned())
    }

    /// The end of a line of several values of which the last alone is called what is asked.
    fn called_last<'l>(&self, place: usize, line: &'l str, statements: &[Statement], lines: &Lines) -> Option<&'l str> {
        let (last, before) = statements.split_last().filter(|(_, before)| !before.is_empty())?;
        let is_asked = |statement: &Statement| {
            (0..self.part.blanks.len()).any(|blank| self.part.calls(blank, statement)) || statement.label.is_none()
        };
        if before.iter().any(is_asked) || !self.part.calls(place, last) {
            return None;
        }
        let end = line.rsplit([',', ';']).next()?.trim();
        let readings = lines.read(end, &self.part.blanks[place].model.vocabulary);
        let own = readings.as_ref().as_ref().ok().and_then(|all| all.first()).map(|reading| &reading.statements);
        own.is_some_and(|own| *own == [last.clone()]).then_some(end)
    }

    /// Does a line end in a letter of which an equation before, there or on the line before, holds for the right value:
    /// `v cos 30° = 5, v = 10√3/3`?
    fn is_root(&self, blank: &KeyedBlank, number: usize, statements: &[Statement], lines: &Lines) -> bool {
        let [before @ .., Statement { label: Some(Label { expr: Some(Expr::Name(letter)), .. }), .. }] = statements
        else {
            return false;
        };
        let holds = |statement: &Statement| {
            let label = statement.label.as_ref().and_then(|label| label.expr.as_ref());
            let has_letter = label.is_some_and(|label| label.names().iter().any(|name| name.text == letter.text));
            let reading =
                || Reading { statements: vec![statement.clone()], printed: String::new(), decided: Vec::new() };
            let note = || judge(&blank.model, &Ok(vec![reading()])).note;
            has_letter && [Note::Unsolved, Note::SquareLeft].iter().any(|open| note() == Some(open.tag()))
        };
        let on_line_before = |line: &&str| {
            let readings = lines.read(line, &blank.model.vocabulary);
            let reading = readings.as_ref().as_ref().ok().and_then(|readings| readings.first());
            reading.is_some_and(|reading| reading.statements.iter().any(holds))
        };
        before.iter().any(holds) || number.checked_sub(2).and_then(|at| self.all.get(at)).is_some_and(on_line_before)
    }

    /// A right range of which either end stands on a line of its own, the last two.
    fn ends_of_range(&self, judged: &mut dyn FnMut(&str) -> Rc<Judged>) -> Option<(&'s str, Rc<Judged>)> {
        let [(_, last)] = self.lines.as_slice() else { return None };
        let [.., before_last, _] = self.all.as_slice() else { return None };
        let ends = [*before_last, *last].map(concluded);
        if !ends.iter().all(|end| is_inequality(end)) {
            return None;
        }
        let found = judged(&ends.join(" and "));
        is_right(&found.judgement).then_some((last, found))
    }

    /// The line that calls something the answer to a blank, right or wrong, and how that is read.
    pub(super) fn stated(&self, place: usize) -> Option<(&'s str, Vec<Reading>)> {
        let stated = self.examined.stated.get(place)?.as_ref().filter(|_| !is_shown(&self.part.blanks[place]))?;
        Some((&*stated.typed, vec![stated.reading.clone()]))
    }

    /// Does the part ask for this angle and for no other?
    fn is_only_angle(&self, place: usize) -> bool {
        let angles = self.part.blanks.iter().enumerate().filter(|(_, blank)| blank.model.kind == Kind::Angle);
        angles.map(|(own, _)| own).eq([place])
    }

    /// The last line, if it ends with the result that is to be shown, and no line on the way to it is false.
    fn printed_result(&self, blank: usize) -> Option<(&'s str, Rc<Judged>)> {
        let (_, line) = self.lines.first()?;
        let mut awards = self.part.scheme.iter().zip(self.by_lines);
        let is_end = awards.any(|(mark, award)| {
            let given = award.as_ref().is_some_and(|award| award.given);
            mark.code == Code::A1Shown && mark.blanks.contains(&blank) && given
        });
        let judgement = Judgement {
            verdict: Verdict::Partial,
            reading: None,
            note: Some(Note::Restated.tag()),
            feedback: Note::Restated.sentence().to_owned(),
        };
        is_end.then(|| (*line, Judged::new(judgement, None)))
    }

    /// Do lines show how the value of a blank is found? The method on which its own mark depends, and something besides
    /// the line itself.
    fn has_method(&self, blank: usize, line: usize) -> bool {
        let scheme = &self.part.scheme;
        let own = scheme.iter().find(|mark| is_own(mark, &self.part.blanks[blank]));
        let mut leads = own.map(|mark| mark.depends.as_slice()).unwrap_or_default().iter();
        let elsewhere = |mark: usize| self.seen(mark).is_some_and(|number| number != line);
        let mut methods = (0..scheme.len()).filter(|mark| scheme[*mark].code.is_method());
        leads.all(|mark| self.seen(*mark).is_some())
            && methods.any(|mark| scheme[mark].blanks.contains(&blank) && elsewhere(mark))
    }

    /// Does a line show the method on which the own mark of a blank depends?
    fn works_out(&self, blank: usize, line: usize) -> bool {
        let mut scheme = self.part.scheme.iter();
        let own = scheme.find(|mark| is_own(mark, &self.part.blanks[blank]));
        let leads = own.map(|mark| mark.depends.as_slice()).unwrap_or_default();
        !leads.is_empty() && leads.iter().all(|mark| self.seen(*mark) == Some(line))
    }

    /// The line that shows a mark.
    fn seen(&self, mark: usize) -> Option<usize> {
        match self.by_lines[mark].as_ref().filter(|award| award.given)?.evidence.as_ref()?.place {
            Place::Line(number) => Some(number),
            Place::Answer(_) => None,
        }
    }

    /// Have the lines found another value for the velocity that is asked?
    fn is_found_otherwise(&self, blank: &KeyedBlank) -> bool {
        blank.find.quantities().iter().any(|quantity| self.examined.found_otherwise.contains(quantity))
    }

    /// Is it called by the letter of the other sphere?
    fn is_of_other(&self, blank: &KeyedBlank, statement: &Statement) -> bool {
        let Find::Quantity(Quantity::Speed(sphere, Moment::After)) = blank.find else { return false };
        match statement.label.as_ref().and_then(|label| label.expr.as_ref()) {
            Some(Expr::Name(name)) => self.examined.is_of_other(&name.text, sphere),
            _ => false,
        }
    }
}

/// Is it one chain of formulas in letters without a name, of which the first is worked out?
fn is_worked_out_in_letters(reading: &Reading) -> bool {
    let [Statement { label: None, said }] = reading.statements.as_slice() else { return false };
    match said.first().map(|said| &said.form) {
        Some(Form::Equation(Expr::Relation(left, Relation::Equal, _))) => !matches!(**left, Expr::Name(_)),
        _ => false,
    }
}

/// Is it a value without a name, worked out from more than two numbers multiplied: `2 × 6 = 12` may be anything?
fn is_worked_out(statement: &Statement) -> bool {
    fn is_more(expr: &Expr) -> bool {
        matches!(expr, Expr::Sum(_) | Expr::Power(..) | Expr::Call(..)) || expr.children().into_iter().any(is_more)
    }
    let [first, _, ..] = statement.said.as_slice() else { return false };
    let is_velocity = |label: &Label| matches!(label.typed.trim(), "v" | "V");
    statement.label.as_ref().is_none_or(is_velocity) && matches!(&first.form, Form::Value(expr) if is_more(expr))
}

/// Is it right, if only as coordinates, which not every board takes for a vector?
fn is_right(judgement: &Judgement) -> bool {
    judgement.verdict == Verdict::Correct || judgement.note == Some(Note::Coordinates.tag())
}
