//! Values at the end of a line that plainly comes to something else: `3 × 64 - 2 × 49 = 40/3` has not found 40/3.

use super::{ROUNDED, are_apart_either_way, is_unfinished, middle};
use crate::bank::Find;
use crate::expr::{Expr, Function};
use crate::mark::working::examine::{Studied, Value, Working, value};
use crate::mark::working::laws::leaves;
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{any_within, comes_to, comes_to_angle, is_vector, sizes};
use crate::mechanics::{Datum, Known, Quantity};
use crate::number;

/// What a blank asks for, at every point.
pub(super) enum Wanted {
    Number { right: Vec<f64>, is_angle: bool },
    Vector(Vec<f64>, Vec<f64>),
}

impl Wanted {
    /// Is it this, whatever its sign?
    fn is(&self, values: &[Value]) -> bool {
        match self {
            Wanted::Number { right, is_angle } => values.iter().zip(right).all(|(value, right)| match is_angle {
                true => comes_to_angle(*value, *right, false),
                false => comes_to(*value, *right),
            }),
            Wanted::Vector(x, y) => [1.0, -1.0].into_iter().any(|sign| is_vector(values, x, y, sign)),
        }
    }
}

/// A formula to which a value is set equal.
struct Formula<'s> {
    expr: &'s Expr,
    /// What it comes to, at every point.
    values: Vec<Value>,
    /// How many names and numbers it has.
    length: usize,
    /// Is there a square or a root in it?
    has_square: bool,
}

impl Working<'_> {
    /// For each blank: is the right value in the lines, and only behind an equals sign that is false?
    pub(in crate::mark::working) fn denied_by_lines(&self) -> Vec<bool> {
        let is_contact_denied = self.is_contact_denied();
        self.part.blanks.iter().map(|blank| is_contact_denied || self.is_only_denied(&blank.find)).collect()
    }

    fn is_only_denied(&self, find: &Find) -> bool {
        let Some(wanted) = self.wanted(find) else { return false };
        let right = || self.members_that_are(&wanted);
        let is_denied = |studied: &Studied, member: &Member| {
            self.is_denied_by_line(studied, member) || self.is_denied_by_equations(member)
        };
        right().any(|(studied, member)| is_denied(studied, member))
            && !right().any(|(studied, member)| is_unfinished(&member.expr) && !is_denied(studied, member))
    }

    /// Does the right value of a blank stand anywhere in the lines?
    pub(in crate::mark::working) fn has_right_value(&self, find: &Find) -> bool {
        self.wanted(find).is_some_and(|wanted| self.members_that_are(&wanted).next().is_some())
    }

    /// Where a letter was to be found, what was asked is known there alone.
    pub(super) fn wanted(&self, find: &Find) -> Option<Wanted> {
        let found = self.prepared.all_where_found().unwrap_or_default();
        let at = if found.is_empty() { self.prepared.known.as_slice() } else { found.as_slice() };
        let known = |quantity: Quantity| sizes(at, quantity);
        match find {
            Find::Quantity(quantity) => {
                known(*quantity).map(|right| Wanted::Number { right, is_angle: is_angle(at, *quantity) })
            }
            Find::Vector(x, y) => known(*x).zip(known(*y)).map(|(x, y)| Wanted::Vector(x, y)),
            Find::Unknown(_) => None,
        }
    }

    pub(super) fn members_that_are<'s>(
        &'s self,
        wanted: &'s Wanted,
    ) -> impl Iterator<Item = (&'s Studied, &'s Member)> {
        let all = self.lines.iter().flat_map(|studied| self.members(studied).map(move |one| (studied, one)));
        all.filter(|(_, (_, values))| wanted.is(values)).map(|(studied, (member, _))| (studied, member))
    }

    /// Does a plain value follow formulas of the question's own names and numbers all of which plainly come to something else?
    /// In letters it is plain if it is shorter than each of them.
    pub(in crate::mark::working) fn is_denied_by_line(&self, studied: &Studied, member: &Member) -> bool {
        let is_in_letters = !member.expr.names().is_empty();
        let is_plain = is_in_letters || !is_unfinished(&member.expr);
        let Some(own) = self.in_given_names(&member.expr).filter(|_| is_plain) else { return false };
        let formulas = self.formulas_before(studied, member);
        let is_denied = |formula: &Formula<'_>| {
            let mut pairs = formula.values.iter().zip(&own);
            let is_apart = pairs.all(|(one, other)| are_apart(*one, *other, formula.has_square));
            is_apart
                && (!is_in_letters || leaves(&member.expr) < formula.length)
                && !self.is_recovered(formula.expr, &own)
        };
        !formulas.is_empty() && formulas.iter().all(is_denied)
    }

    /// The formulas to which a member is set equal by its line, and by those before that the line goes on from.
    fn formulas_before<'s>(&'s self, studied: &'s Studied, member: &Member) -> Vec<Formula<'s>> {
        let formula = |other: &'s Member| {
            let values = self.in_given_names(&other.expr).filter(|_| is_unfinished(&other.expr));
            let is_square = |inner: &Expr| matches!(inner, Expr::Power(..) | Expr::Call(Function::Sqrt, _));
            let (length, has_square) = (leaves(&other.expr), any_within(&other.expr, &is_square));
            values.map(|values| Formula { expr: &other.expr, values, length, has_square })
        };
        self.members_before(studied, member).into_iter().filter_map(formula).collect()
    }

    /// All to which a member is set equal by its line, and by those before that the line goes on from.
    pub(super) fn members_before<'s>(&'s self, studied: &'s Studied, member: &Member) -> Vec<&'s Member> {
        let mut found = Vec::new();
        let Some(reading) = &studied.reading else { return found };
        let before = reading.members.iter().take_while(|other| !std::ptr::eq(*other, member));
        found.extend(before.filter(|other| other.statement == member.statement));
        let place = self.lines.iter().position(|other| std::ptr::eq(other, studied)).unwrap_or_default();
        if member.statement > 0 || !studied.line.goes_on() {
            return found;
        }
        for other in self.lines[..place].iter().rev() {
            let members = other.reading.as_ref().map(|reading| reading.members.as_slice()).unwrap_or_default();
            let last = members.last().map(|last| last.statement);
            found.extend(members.iter().filter(|other| Some(other.statement) == last));
            if !other.line.goes_on() {
                break;
            }
        }
        found
    }

    /// What a formula comes to by what is given, and not by the student's own letters, nor by one that is to be found or that
    /// only the words of the question have.
    pub(super) fn in_given_names(&self, expr: &Expr) -> Option<Vec<Value>> {
        let is_given = |letter: &str| {
            let has = |value: &number::Value| value.letters().iter().any(|own| own.name() == letter);
            self.question.given.0.iter().any(|(_, datum)| match datum {
                Datum::Number(size) => has(size),
                Datum::Direction { y, x } => has(y) || has(x),
                Datum::Equation(numbers) => numbers.iter().any(has),
            })
        };
        let is_sought = |letter: &str| self.prepared.found.iter().any(|(own, _)| own.name() == letter);
        let is_letter = |name: &str| self.prepared.points.letter(name, 0).is_some();
        let is_known = |name: &str| !is_letter(name) || is_given(name) && !is_sought(name);
        let names = expr.names();
        let are_known = names.iter().all(|name| is_known(&name.text));
        are_known.then(|| value(expr, self.prepared, &self.prepared.names))?
    }
}

fn is_angle(known: &[Known<f64>], quantity: Quantity) -> bool {
    matches!(known.first().and_then(|known| known.0.get(&quantity)), Some(Datum::Direction { .. }))
}

/// Do two values plainly differ, however an equals sign may be meant: a square for its root where there is one, an angle for
/// its ratio, a percentage, a size for a signed number?
fn are_apart(one: Value, other: Value, has_square: bool) -> bool {
    match (one, other) {
        (Value::Number(one), Value::Number(other)) => {
            let (one, other) = (one.middle().abs(), other.middle().abs());
            let near = |one: f64, other: f64| (one - other).abs() <= ROUNDED * one.max(other);
            let may_be = |one: f64, other: f64| {
                let radians = one.to_radians();
                let forms = [one, 100.0 * one, radians, radians.sin(), radians.cos(), radians.tan()];
                let square = has_square.then_some(one * one);
                forms.into_iter().chain(square).any(|form| near(form, other))
            };
            !may_be(one, other) && !may_be(other, one)
        }
        (Value::Vector(..), Value::Vector(..)) => are_apart_either_way(middle(&one), middle(&other)),
        // A vector and its size are set equal by those who take the one for the other.
        _ => false,
    }
}
