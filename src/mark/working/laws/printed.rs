//! A result that is printed in the question: no line on the way to it may be false, and it must end the working.

use crate::mark::working::examine::{Studied, Working, context};
use crate::mark::working::numbers::{Context, Linear, Points, Sum, difference, sizes};
use std::borrow::Cow;

use crate::answer::Kind;
use crate::expr::{Expr, Function, Relation};
use crate::mark::award::Ground;
use crate::mark::judging::{Judgement, Model, Note, judge};
use crate::mark::reading::{Form, Label, Reading};
use crate::mark::working::evidence::Evidence;
use crate::mark::working::lines::ReadLine;

/// The role of a line that ends the working with what is to be shown.
const PRINTED_RESULT: &str = "the result as it is printed";

/// Where equations are looked at: what letters and names stand for at one point.
pub(in crate::mark::working) struct Spot {
    pub(in crate::mark::working) points: Points,
    pub(in crate::mark::working) point: usize,
    pub(in crate::mark::working) names: Vec<(String, Vec<f64>)>,
}

/// What an equation is, wherever it can be worked out.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::mark::working) enum Truth {
    True,
    False,
    Unknown,
}

impl Working<'_> {
    /// What the lines say of a printed result: that one of them is false, or that they end with it.
    pub(in crate::mark::working) fn printed_result(&self) -> Option<Evidence> {
        let role = PRINTED_RESULT;
        if let Some(line) = self.false_line() {
            let feedback = "this line is not true, so the result does not follow from it".to_owned();
            let role = "not true";
            return Some(Evidence {
                given: false,
                note: Some(Ground::NotShown.tag()),
                feedback,
                ..Evidence::given(line, role)
            });
        }
        let last = self.lines.len().checked_sub(1)?;
        self.ends_with_result(last).then(|| Evidence::given(last, role))
    }

    fn printed_models(&self) -> impl Iterator<Item = &Model> {
        self.part.blanks.iter().map(|blank| &blank.model).filter(|model| model.kind == Kind::Shown)
    }

    /// What the results that are printed come to.
    pub(super) fn printed_values(&self) -> impl Iterator<Item = &Expr> {
        self.printed_models().filter_map(sides_of).map(|(_, right)| right)
    }

    /// Is it what a result comes to, as it is printed? Whoever copies it has not found it.
    pub(super) fn is_printed_value(&self, expr: &Expr) -> bool {
        self.printed_values().any(|right| right == expr)
    }

    /// Is it either side of a result that is printed?
    pub(in crate::mark::working) fn is_side_of_result(&self, expr: &Expr) -> bool {
        self.printed_models().filter_map(sides_of).any(|(left, right)| left == expr || right == expr)
    }

    /// `tan θ = 1/2` where tan²θ = 1/4 is to be shown: the letter that is sought, alone under its function or power, set equal to
    /// a number, which may have been read off the result.
    pub(super) fn restates_number(&self, (left, right): &(Expr, Expr)) -> bool {
        let is_number = |expr: &Expr| expr.names().is_empty();
        let is_of_result = |side: &Expr| {
            let mut results = self.printed_models().filter_map(sides_of).filter(|(_, number)| is_number(number));
            bare_letter(side)
                .is_some_and(|letter| self.has_sought(side) && results.any(|(own, _)| bare_letter(own) == Some(letter)))
        };
        is_of_result(left) && is_number(right) || is_of_result(right) && is_number(left)
    }

    /// Is the line what was to be shown, written once more? A step on the way to it is not as it is printed, and has more in
    /// it.
    pub(in crate::mark::working) fn is_printed_result(&self, studied: &Studied) -> bool {
        let Some(reading) = studied.reading.as_ref().filter(|_| self.printed_models().next().is_some()) else {
            return false;
        };
        let line = Reading { statements: reading.statements.clone(), printed: String::new(), decided: Vec::new() };
        let equations = reading.equations.iter().map(|(left, right)| leaves(left) + leaves(right));
        // What stands alone is said of the one thing to the left of the result.
        let longest = equations.chain(reading.members.iter().map(|member| leaves(&member.expr) + 1)).max().unwrap_or(0);
        let line = Ok(vec![line]);
        self.printed_models().any(|result| {
            let is = |note: Note, found: &Judgement| found.note == Some(note.tag());
            let is_left = |side: &Expr| matches!(&result.value, Expr::Relation(left, ..) if **left == *side);
            let found = judge(result, &line);
            let is_no_more =
                longest <= leaves(&result.value) && reading.equations.iter().all(|(left, _)| is_left(left));
            is(Note::Restated, &found) || is_no_more && is(Note::NotAsPrinted, &found)
        })
    }

    /// The last line on which anything may be found: what stands behind the printed result follows from that. What is to be
    /// shown may be said at the beginning, or be what somebody wants.
    pub(in crate::mark::working) fn end_of_finding(&self) -> usize {
        const WANTED: [&str; 7] = ["show", "need", "want", "prove", "rtp", "require", "aim"];
        if self.printed_models().next().is_none() {
            return self.lines.len();
        }
        let states = |studied: &Studied| {
            let typed = studied.line.typed.to_lowercase();
            let mut members = studied.reading.iter().flat_map(|reading| &reading.members);
            !WANTED.iter().any(|word| typed.contains(word))
                && (members.any(|member| self.is_printed_value(&member.expr)) || self.is_printed_result(studied))
        };
        self.lines.iter().skip(1).rposition(states).map_or(self.lines.len(), |place| place + 1)
    }

    fn ends_with_result(&self, last: usize) -> bool {
        let end = |place: usize| self.lines[place].reading.as_ref()?.statements.last().cloned();
        let Some(mut end) = end(last) else { return false };
        // What `= 9 tan α/4` goes on from says what it is.
        let begins = |place: &usize| {
            let line = &self.lines[*place].line;
            !line.goes_on() && !is_remark(line.typed.trim_start())
        };
        let begin = (0..=last).rfind(begins).and_then(|place| self.lines[place].reading.as_ref());
        // In `= t/(2 + 3t²) = tan α/(2 + 3 tan²α)` the first is no name of the second.
        let goes_on = self.lines[last].line.goes_on();
        if let Some(said) = end.said.last_mut().filter(|_| goes_on)
            && let Form::Equation(Expr::Relation(_, Relation::Equal, right)) = &said.form
        {
            said.form = Form::Value((**right).clone());
        }
        if end.label.is_none() || goes_on {
            end.label = begin.and_then(|line| self.called(line)).cloned();
        }
        if let Some((left, _)) = begin.and_then(|line| self.result_of_difference(line)) {
            end.label = Some(Label { typed: crate::expr::print::plain(left), expr: Some(left.clone()) });
        }
        let is_named = end.label.is_some() || end.said.iter().any(|said| matches!(said.form, Form::Equation(_)));
        end.said.drain(..end.said.len().saturating_sub(1));
        let line = Ok(vec![Reading { statements: vec![end], printed: String::new(), decided: Vec::new() }]);
        is_named && self.printed_models().any(|model| judge(model, &line).note == Some(Note::Restated.tag()))
    }

    /// The first line that is false and stays so: neither crossed out nor put right.
    fn false_line(&self) -> Option<usize> {
        self.printed_models().next()?;
        let (everywhere, where_found) = self.spots();
        if where_found.is_empty() && !self.prepared.found.is_empty() {
            return None;
        }
        let mut named = None;
        let truths: Vec<Truth> = self
            .lines
            .iter()
            .map(|studied| {
                let Some(reading) = &studied.reading else { return Truth::Unknown };
                if is_remark(&studied.line.typed) {
                    return Truth::Unknown;
                }
                let goes_on = studied.line.goes_on();
                let (mut equations, name) = self.equations(reading, named.take().filter(|_| goes_on));
                named = name;
                equations.retain(|(left, right)| self.is_of_every_impact(left) && self.is_of_every_impact(right));
                self.truth_of_all(&equations, &everywhere, &where_found)
            })
            .collect();
        (0..truths.len()).find(|place| truths[*place] == Truth::False && !self.is_put_right(*place, &truths))
    }

    /// Has it the same value at every impact? A student's own letters of one are not those of the next.
    fn is_of_every_impact(&self, side: &Expr) -> bool {
        let is_given = |name: &str| self.question.letters.iter().any(|letter| letter.name() == name);
        self.question.scene.then.is_empty() || side.names().iter().all(|name| is_given(&name.text))
    }

    /// Has the line been crossed out, or written once more as it should be? The result itself is no correction.
    fn is_put_right(&self, place: usize, truths: &[Truth]) -> bool {
        let own = &self.lines[place];
        if own.line.is_crossed_out() {
            return true;
        }
        let left = |studied: &Studied| Some(studied.reading.as_ref()?.equations.first()?.0.clone());
        (0..truths.len()).filter(|other| truths[*other] == Truth::True).any(|other| {
            let studied = &self.lines[other];
            let is_same_law = own.matched.iter().any(|matched| {
                studied.matched.iter().any(|other| other.equation == matched.equation && other.departures.is_empty())
            });
            let says_the_same = || {
                other > place
                    && !self.is_printed_result(studied)
                    && left(studied).is_some_and(|found| Some(found) == left(own))
            };
            is_same_law || says_the_same()
        })
    }

    /// The equations of a line, with what is named as the result in its place; a line that begins with an equals sign goes
    /// on from the one before.
    pub(in crate::mark::working) fn equations(
        &self,
        reading: &ReadLine,
        before: Option<Expr>,
    ) -> (Vec<(Expr, Expr)>, Option<Expr>) {
        let mut equations = if reading.is_guessed { Vec::new() } else { reading.equations.clone() };
        let mut named = before;
        let of_difference = self.result_of_difference(reading).map(|(_, right)| right);
        for statement in &reading.statements {
            let printed = statement.label.as_ref().and_then(|label| self.printed_right_side(&label.typed));
            named = printed.or_else(|| of_difference.cloned()).or(named.filter(|_| statement.label.is_none()));
            let (Some(right), Some(first)) = (&named, statement.said.first()) else { continue };
            if let Form::Value(value) = &first.form {
                equations.push((right.clone(), value.clone()));
            }
        }
        (equations, named)
    }

    /// What a line calls its value: beside `t = tan α` the result, if it is named there.
    fn called<'l>(&self, line: &'l ReadLine) -> Option<&'l Label> {
        let is_result = |label: &&Label| self.printed_right_side(&label.typed).is_some();
        let result = line.statements.iter().filter_map(|statement| statement.label.as_ref()).find(is_result);
        result.or(line.statements.last()?.label.as_ref())
    }

    /// The result, by its two sides, that a line calls the tangent of a difference of two angles: `tan(β - α) = …`.
    fn result_of_difference(&self, reading: &ReadLine) -> Option<(&Expr, &Expr)> {
        let (called, _) = reading.equations.first()?;
        expanded(called)?;
        let (everywhere, where_found) = self.spots();
        self.printed_models().filter_map(sides_of).find(|(_, right)| {
            self.truth(&(called.clone(), (*right).clone()), &everywhere, &where_found) == Truth::True
        })
    }

    /// What has this name in a result that is printed in this question.
    fn printed_right_side(&self, typed: &str) -> Option<Expr> {
        let plain = |text: &str| -> String {
            let greek = [("α", "alpha"), ("β", "beta"), ("γ", "gamma"), ("δ", "delta"), ("θ", "theta"), ("φ", "phi")];
            let spelt = greek.iter().fold(text.to_owned(), |text, (sign, name)| text.replace(sign, name));
            spelt.replace('²', "^2").chars().filter(|sign| !" ()\\{}∴⇒".contains(*sign)).collect()
        };
        let typed = plain(typed);
        let models = self.question.parts.iter().flat_map(|part| &part.blanks).map(|blank| &blank.model);
        models.filter(|model| model.kind == Kind::Shown).find_map(|model| match &model.value {
            Expr::Relation(left, Relation::Equal, right) => {
                (plain(&crate::expr::print::plain(left)) == typed).then(|| (**right).clone())
            }
            _ => None,
        })
    }

    /// Where equations are looked at: every point, and every point where the letters that are to be found have a value.
    fn spots(&self) -> (Vec<Spot>, Vec<Spot>) {
        let count = self.prepared.points.count;
        let at = |point| {
            let names = self.names(&|quantity| sizes(&self.prepared.known, quantity));
            Spot { points: self.prepared.points.clone(), point, names }
        };
        let found = |point| {
            let there = self.prepared.where_found(point)?;
            let names = self.names(&|quantity| Some(vec![there.number(quantity)?; count]));
            Some(Spot { points: self.prepared.points.with(&self.prepared.found, point), point, names })
        };
        ((0..count).map(at).collect(), (0..count).filter_map(found).collect())
    }

    /// Are these equations true, as far as they can be worked out?
    pub(in crate::mark::working) fn truth_of_all(
        &self,
        equations: &[(Expr, Expr)],
        everywhere: &[Spot],
        where_found: &[Spot],
    ) -> Truth {
        let truth = |equation: &(Expr, Expr)| self.truth(equation, everywhere, where_found);
        let all: Vec<Truth> = equations.iter().map(truth).collect();
        match () {
            () if all.contains(&Truth::False) => Truth::False,
            () if all.contains(&Truth::True) => Truth::True,
            () => Truth::Unknown,
        }
    }

    /// Is an equation true: wherever it may be, or at least where the letters are what is to be found?
    fn truth(&self, (left, right): &(Expr, Expr), everywhere: &[Spot], where_found: &[Spot]) -> Truth {
        // `e = 1` says what is looked at, and not what follows.
        let is_given =
            |expr: &Expr| matches!(expr, Expr::Name(name) if self.prepared.points.letter(&name.text, 0).is_some());
        // `m₁ = tan θ`, `m₁m₂ = -1`: gradients, and no masses.
        let of_numbers =
            |expr: &Expr| !expr.names().is_empty() && expr.names().iter().all(|name| is_gradient(&name.text));
        if is_given(left) || is_given(right) || of_numbers(left) || of_numbers(right) {
            return Truth::Unknown;
        }
        let holds = |spot: &Spot| {
            let context = Context { points: &spot.points, given: &spot.names, ..context(self.prepared, spot.point) };
            let nought =
                |linear: &Linear| linear.is_number().then(|| linear.constant.may_be_nought(linear.size * 100.0));
            match difference(&self.with_results(left), &self.with_results(right), &context)? {
                Sum::Number(linear) => nought(&linear),
                Sum::Vector(x, y) => Some(nought(&x)? && nought(&y)?),
            }
        };
        let all = |spots: &[Spot]| spots.iter().map(holds).collect::<Option<Vec<bool>>>();
        let Some((everywhere, where_found)) = all(everywhere).zip(all(where_found)) else { return Truth::Unknown };
        let hold = |found: &[bool]| !found.is_empty() && found.iter().all(|holds| *holds);
        if hold(&everywhere) || hold(&where_found) { Truth::True } else { Truth::False }
    }

    /// The formula with printed results in the place of what they are for: `tan β` is no letter of the question.
    fn with_results(&self, expr: &Expr) -> Expr {
        let models = self.question.parts.iter().flat_map(|part| &part.blanks).map(|blank| &blank.model);
        let result = models.filter(|model| model.kind == Kind::Shown).find_map(|model| match &model.value {
            Expr::Relation(left, Relation::Equal, right) if **left == *expr => Some((**right).clone()),
            _ => None,
        });
        match result {
            Some(right) => right,
            None => {
                let expr = expanded(expr).map_or(Cow::Borrowed(expr), Cow::Owned);
                expr.map_children(&mut |child| self.with_results(child))
            }
        }
    }
}

/// May a name be that of a gradient, or of a mass, as a student may say as well?
fn is_gradient(name: &str) -> bool {
    matches!(name, "m_1" | "m_2")
}

/// The letter in `θ`, `tan θ` or `tan²θ`.
fn bare_letter(expr: &Expr) -> Option<&str> {
    match expr {
        Expr::Name(name) => Some(&name.text),
        Expr::Call(_, inner) | Expr::Power(inner, _) => bare_letter(inner),
        _ => None,
    }
}

/// Both sides of a result that is an equation.
fn sides_of(model: &Model) -> Option<(&Expr, &Expr)> {
    match &model.value {
        Expr::Relation(left, Relation::Equal, right) => Some((&**left, &**right)),
        _ => None,
    }
}

/// `tan(β - α)` as `(tan β - tan α)/(1 + tan β tan α)`.
fn expanded(expr: &Expr) -> Option<Expr> {
    let Expr::Call(Function::Tan, difference) = expr else { return None };
    let Expr::Sum(terms) = &**difference else { return None };
    let [from @ Expr::Name(_), Expr::Negative(taken)] = terms.as_slice() else { return None };
    let [from, taken] = [from, taken].map(|angle| Expr::call(Function::Tan, angle.clone()));
    let above = Expr::Sum(vec![from.clone(), Expr::Negative(Box::new(taken.clone()))]);
    let below = Expr::Sum(vec![Expr::integer(1), Expr::Product(vec![from, taken])]);
    Some(Expr::Quotient(Box::new(above), Box::new(below)))
}

/// `multiply top and bottom by 7 - 3e`: words with which nothing is set equal, so that a chain goes on after them.
fn is_remark(typed: &str) -> bool {
    let is_word = |word: &str| word.chars().count() > 2 && word.chars().all(char::is_alphabetic);
    let words = typed.split_whitespace().filter(|word| is_word(word)).count();
    words >= LEAST_WORDS && !typed.contains(['=', '<', '>', '≤', '≥', '≈'])
}

/// Fewer words may be the name of what stands beside them.
const LEAST_WORDS: usize = 3;

/// How many numbers and letters stand in a formula.
pub(in crate::mark::working) fn leaves(expr: &Expr) -> usize {
    let inner: usize = expr.children().into_iter().map(leaves).sum();
    inner.max(1)
}
