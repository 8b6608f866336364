//! One of the two laws in which a number that is given was copied wrongly: `4(5 cos 30°) = 4v + 2w` where the speed is 4.

use super::apiece::Apiece;
use super::linear::Linear;
use super::offered::differences;
use super::pair::{Convention, Departure, Laws, Matched};
use super::prepared::Prepared;
use crate::expr::Expr;
use crate::mechanics::{Scene, Velocity};
use crate::number::Fraction;

/// An equation with more numbers is not gone through for one that is copied wrongly.
const MOST_NUMBERS: usize = 8;

/// The numbers that stand in a question for masses and velocities, and 1 where a letter stands alone: each once.
pub(super) fn given_numbers(scene: &Scene) -> Vec<Expr> {
    let masses = scene.masses.iter().flatten().map(|mass| &mass.shown);
    let velocities = scene.before.iter().flatten().flat_map(|velocity| match velocity {
        Velocity::Components(x, y) => vec![&x.shown, &y.shown],
        Velocity::Polar { speed, angle, .. } => {
            std::iter::once(&speed.shown).chain(angle.iter().map(|(_, shown)| shown)).collect()
        }
    });
    let mut all: Vec<Expr> = Vec::new();
    for shown in masses.chain(velocities) {
        let mut own = numbers(shown);
        if own.is_empty() && !shown.names().is_empty() {
            own.push(Expr::integer(1));
        }
        for number in own.into_iter().map(without_sign) {
            if !all.contains(&number) {
                all.push(number);
            }
        }
    }
    all
}

/// The numbers that stand for masses in a scene and in those that follow it.
pub(in crate::mark) fn numbers_of_masses(scene: &Scene) -> Vec<Expr> {
    let own = scene.masses.iter().flatten().flat_map(|mass| numbers(&mass.shown));
    own.chain(scene.then.iter().flat_map(|then| numbers_of_masses(&then.scene))).collect()
}

/// The law that an equation is once one of its numbers, in one place or wherever it stands, is what is given.
pub(super) fn with_number_misread(
    (left, right): &(Expr, Expr),
    laws: &Laws,
    convention: &Convention,
    prepared: &Prepared,
) -> Option<Matched> {
    let has = |letter: &String| [left, right].iter().any(|side| side.names().iter().any(|name| name.text == *letter));
    let written: Vec<Expr> = [left, right].into_iter().flat_map(numbers).collect();
    if !convention.letters.iter().all(has) || written.len() > MOST_NUMBERS {
        return None;
    }
    // What is taken from itself comes to nought whatever it is.
    let comes_to_nought = |linear: Vec<Linear>| linear.iter().all(|at| at.constant.may_be_nought(at.size));
    if differences(&(left.clone(), right.clone()), prepared).is_none_or(comes_to_nought) {
        return None;
    }
    let law = |put: &dyn Fn(usize, &Expr) -> Option<Expr>| {
        let mut place = 0;
        let mut with = |side: &Expr| replaced(side, &mut place, put);
        let equation = (with(left), with(right));
        laws.exactly(&differences(&equation, prepared)?, || Apiece::of(&equation, prepared), convention)
    };
    let choices = written.iter().enumerate().flat_map(|(at, typed)| {
        let may_be = move |given: &&Expr| *given != typed && !prepared.are_masses(typed, given);
        prepared.given_numbers.iter().filter(may_be).map(move |given| (at, typed, given))
    });
    let mut found = choices.filter_map(|(at, typed, given)| {
        let stands_again = written.iter().filter(|number| *number == typed).count() > 1;
        let everywhere = || law(&|_, number| (number == typed).then(|| given.clone()));
        law(&|place, _| (place == at).then(|| given.clone())).or_else(|| stands_again.then(everywhere).flatten())
    });
    found.next().map(|equation| Matched::with(equation, Departure::NumberMisread))
}

fn without_sign(number: Expr) -> Expr {
    match number {
        Expr::Number(value) if value < Fraction::ZERO => Expr::Number(-value),
        other => other,
    }
}

/// The numbers in a formula, in order.
fn numbers(expr: &Expr) -> Vec<Expr> {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => vec![expr.clone()],
        other => other.children().into_iter().flat_map(numbers).collect(),
    }
}

/// The formula with other numbers in the places for which there are such; places are counted on.
fn replaced(expr: &Expr, place: &mut usize, put: &dyn Fn(usize, &Expr) -> Option<Expr>) -> Expr {
    match expr {
        Expr::Number(_) | Expr::Decimal(_) => {
            let number = put(*place, expr).unwrap_or_else(|| expr.clone());
            *place += 1;
            number
        }
        other => other.map_children(&mut |child| replaced(child, place, put)),
    }
}
