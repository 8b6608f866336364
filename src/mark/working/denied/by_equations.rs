//! What a student's own equations come to for a letter: `8 = 4e` has not led to `e = 1/2`.

use super::brackets::{bracketed, is_same};
use super::{are_apart_either_way, is_unfinished, middle};
use crate::expr::Expr;
use crate::mark::working::examine::{Working, context, value};
use crate::mark::working::lines::Member;
use crate::mark::working::numbers::{Context, Linear, Sum, any_within, common_root, difference};

/// A root at every point, along i and along j; a number is along i alone.
type Root = Vec<[f64; 2]>;

/// An equation that is linear in its unknowns, at every point.
enum Equation {
    Number(Vec<Linear>),
    Vector(Vec<[Linear; 2]>),
}

impl Working<'_> {
    /// Does a line give a letter a plain value, where the student's own equations in that letter, or in it and one other, all
    /// have plainly another root? Whatever sign the value has: one direction may have been turned round.
    pub(in crate::mark::working) fn is_denied_by_equations(&self, member: &Member) -> bool {
        let Some(letter) = member.letter.as_ref().filter(|_| !is_unfinished(&member.expr)) else { return false };
        let own = value(&member.expr, self.prepared, &self.prepared.names);
        let Some(own) = own.map(|values| values.iter().map(middle).collect::<Root>()) else { return false };
        let roots = self.roots_for(letter);
        let is_apart = |root: &Root| root.iter().zip(&own).all(|(root, own)| are_apart_either_way(*root, *own));
        !roots.is_empty() && roots.iter().all(is_apart) && !self.is_root_recovered(letter, &own)
    }

    /// The roots of all equations that say something of a letter.
    fn roots_for(&self, letter: &str) -> Vec<Root> {
        let names = self.names_but(letter);
        let equations: Vec<Equation> =
            self.equations_of(letter).filter_map(|equation| self.linear(equation, &names)).collect();
        let mut roots: Vec<Root> = equations.iter().filter_map(|equation| root(equation, letter)).collect();
        for (place, one) in equations.iter().enumerate() {
            roots.extend(equations[place + 1..].iter().filter_map(|other| root_of_two(one, other, letter)));
        }
        roots
    }

    /// Does one of the equations in a letter alone have this root if it lost a pair of brackets?
    fn is_root_recovered(&self, letter: &str, own: &Root) -> bool {
        let names = self.names_but(letter);
        let is_recovered = |(left, right): &(Expr, Expr)| {
            let with_left = bracketed(left).into_iter().map(|left| (left, right.clone()));
            let with_right = bracketed(right).into_iter().map(|right| (left.clone(), right));
            let mut roots = with_left.chain(with_right).filter_map(|own| root(&self.linear(&own, &names)?, letter));
            roots.any(|root| root.iter().zip(own).all(|(root, own)| is_same(*root, *own)))
        };
        self.equations_of(letter).any(is_recovered)
    }

    fn names_but(&self, letter: &str) -> Vec<(String, Vec<f64>)> {
        self.prepared.names.iter().filter(|(name, _)| name != letter).cloned().collect()
    }

    fn equations_of<'s>(&'s self, letter: &'s str) -> impl Iterator<Item = &'s (Expr, Expr)> {
        let open = self.lines.iter().filter(|studied| !studied.line.is_crossed_out());
        let equations = open.filter_map(|studied| studied.reading.as_ref()).flat_map(|reading| &reading.equations);
        let has_letter =
            move |expr: &Expr| any_within(expr, &|inner| matches!(inner, Expr::Name(name) if name.text == letter));
        // Another letter that is to be found is not known here.
        let is_closed = move |side: &Expr| has_letter(side) || !self.has_sought(side);
        equations.filter(move |(left, right)| {
            let is_of_letter = (has_letter(left) || has_letter(right)) && is_closed(left) && is_closed(right);
            is_of_letter && !is_plain(left, right) && !is_plain(right, left)
        })
    }

    fn linear(&self, (left, right): &(Expr, Expr), names: &[(String, Vec<f64>)]) -> Option<Equation> {
        let at = |point| {
            let context = Context { given: names, ..context(self.prepared, point) };
            difference(left, right, &context)
        };
        let all: Vec<Sum> = (0..self.prepared.points.count).map(at).collect::<Option<_>>()?;
        let numbers = all.iter().map(|sum| match sum {
            Sum::Number(linear) => Some(linear.clone()),
            Sum::Vector(..) => None,
        });
        if let Some(numbers) = numbers.collect::<Option<Vec<Linear>>>() {
            return Some(Equation::Number(numbers));
        }
        let vectors = all.into_iter().map(|sum| match sum {
            Sum::Vector(x, y) => Some([x, y]),
            Sum::Number(_) => None,
        });
        vectors.collect::<Option<_>>().map(Equation::Vector)
    }
}

/// The root of an equation in this letter alone.
fn root(equation: &Equation, letter: &str) -> Option<Root> {
    let of = |linear: &Linear| match linear.unknowns.as_slice() {
        [(own, number)] if own == letter => finite(-linear.constant.middle() / number.middle()),
        _ => None,
    };
    match equation {
        Equation::Number(all) => all.iter().map(|linear| Some([of(linear)?, 0.0])).collect(),
        Equation::Vector(all) => all.iter().map(|[x, y]| Some([of(x)?, of(y)?])).collect(),
    }
}

/// What two equations in this letter and one other come to for it.
fn root_of_two(one: &Equation, other: &Equation, letter: &str) -> Option<Root> {
    let (Equation::Number(one), Equation::Number(other)) = (one, other) else { return None };
    let at = |(one, other): (&Linear, &Linear)| {
        let beside = |linear: &Linear| match linear.unknowns.as_slice() {
            [(first, _), (second, _)] if first == letter => Some(second.clone()),
            [(first, _), (second, _)] if second == letter => Some(first.clone()),
            _ => None,
        };
        let name = beside(one).filter(|name| beside(other).as_ref() == Some(name))?;
        let numbers = |linear: &Linear| linear.in_numbers([letter, &name]);
        common_root(numbers(one), numbers(other)).map(|[root, _]| [root, 0.0])
    };
    one.iter().zip(other).map(at).collect()
}

/// Is it a letter that is said to be so much, with nothing left to work out?
fn is_plain(name: &Expr, expr: &Expr) -> bool {
    matches!(name, Expr::Name(_)) && !is_unfinished(expr)
}

fn finite(number: f64) -> Option<f64> {
    number.is_finite().then_some(number)
}
